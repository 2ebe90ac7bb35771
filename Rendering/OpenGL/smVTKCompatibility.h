/**
 * @file smVTKCompatibility.h
 * @brief Names that differ between versions of VTK (9.1 to 9.7), found by the headers that exist and never by
 * a version
 *
 * | name here | until VTK 9.2 | from 9.3 on |
 * |---|---|---|
 * | sm::CompositeMapper | vtkCompositePolyDataMapper2 | vtkCompositePolyDataMapper |
 */
#ifndef smVTKCompatibility_h
#define smVTKCompatibility_h

#if __has_include(<vtkOpenGLBatchedPolyDataMapper.h>)
#include <vtkCompositePolyDataMapper.h>
#define SM_COMPOSITE_MAPPER vtkCompositePolyDataMapper
#else
#include <vtkCompositePolyDataMapper2.h>
#define SM_COMPOSITE_MAPPER vtkCompositePolyDataMapper2
#endif

namespace sm
{
/// Draws all blocks of a composite dataset, those of one state together. Until VTK 9.2
/// vtkCompositePolyDataMapper is a different class, which draws block by block and gives different pictures.
using CompositeMapper = SM_COMPOSITE_MAPPER;
}

#undef SM_COMPOSITE_MAPPER

#endif
