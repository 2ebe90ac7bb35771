/**
 * @file vtkMassPropertiesGPUInternals.h
 * @brief What vtkMassPropertiesGPU keeps of its last run; not installed
 */
#ifndef vtkMassPropertiesGPUInternals_h
#define vtkMassPropertiesGPUInternals_h

#include "smMassTable.h"
#include "smSchemeRun.h"
#include "vtkMassPropertiesGPU.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

struct vtkMassPropertiesGPU::Totals
{
  sm::MassRow Row;
  /// Volumes of the bodies.
  std::vector<double> Volumes;
  /// With one of the paper's schemes.
  sm::SchemeRun Run;
  sm::SchemeTotals Estimates;
  /// Of radius 1 about the origin, made once: glyphs share its cells and normals.
  vtkSmartPointer<vtkPolyData> Sphere;
};

#endif
