/**
 * @file smOCCTExport.h
 * @brief Writes parts and instances as STEP or BREP, by OpenCASCADE
 */
#ifndef smOCCTExport_h
#define smOCCTExport_h

#include "smExportTree.h"
#include "smProgressCallback.h"
#include "smReadersKernelModule.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace sm
{
struct ExportOptions
{
  /// Unit of the file's lengths, and the factor from lengths of the models to lengths of the file.
  std::string UnitName = "mm";
  double Unit = 1.0;
  /// Entries of the header: the file's name, and the program with its version.
  std::string FileName;
  std::string System;
};

struct ExportResult
{
  /// The reason why nothing was written; empty if it was. The state of the stream has its errors.
  std::string Problem;
  std::vector<std::string> Warnings;
  /// Number of faces in the file, those of every part once.
  int Faces = 0;
  bool Aborted = false;
};

/**
 * Writes AP214 (AUTOMOTIVE_DESIGN): products, assemblies, colours, layers, materials; faces with their trim
 * curves, every number with 17 digits. Bodies, faces and edges keep their names, and their entity numbers
 * unless an earlier body has the same ones. `progress` gets a fraction in [0,1] and returns false to stop.
 * Holds a KernelSession. Throws only std::bad_alloc.
 */
ExportResult WriteSTEP(const ExportTree& tree, const ExportOptions& options, std::ostream& stream,
  const ProgressCallback& progress);

/// Writes OpenCASCADE's own text format, one compound of all instances; it has neither units, names nor
/// colours.
SMREADERSKERNEL_EXPORT ExportResult WriteBREP(const ExportTree& tree, const ExportOptions& options,
  std::ostream& stream, const ProgressCallback& progress);
}

#endif
