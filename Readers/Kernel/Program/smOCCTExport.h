/**
 * @file smOCCTExport.h
 * @brief Writes parts and instances as STEP or BREP, by OpenCASCADE
 */
#ifndef smOCCTExport_h
#define smOCCTExport_h

#include "smExport.h"
#include "smProgressCallback.h"

#include <iosfwd>

namespace sm
{
/**
 * Writes AP214 (AUTOMOTIVE_DESIGN): products, assemblies, colours, layers, materials; faces with their trim
 * curves, every number with 17 digits. Bodies, faces and edges keep their names, and their entity numbers
 * unless an earlier body has the same ones. `progress` gets a fraction in [0,1] and returns false to stop.
 * Throws only std::bad_alloc.
 */
ExportResult WriteSTEP(const ExportTree& tree, const ExportOptions& options, std::ostream& stream,
  const ProgressCallback& progress);

/// Writes OpenCASCADE's own text format, one compound of all instances; it has neither units, names nor
/// colours.
ExportResult WriteBREP(const ExportTree& tree, const ExportOptions& options, std::ostream& stream,
  const ProgressCallback& progress);
}

#endif
