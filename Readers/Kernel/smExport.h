/**
 * @file smExport.h
 * @brief Writes parts and instances as STEP or BREP, by OpenCASCADE in a process of its own
 */
#ifndef smExport_h
#define smExport_h

#include "smExportTree.h"
#include "smProgressCallback.h"

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

enum class ExportFormat
{
  STEP,
  BREP
};

/// Writes the tree (Program/smOCCTExport.h describes what). `progress` gets a fraction in [0,1] about ten
/// times a second and returns false to stop. Throws std::bad_alloc and what `progress` throws.
ExportResult WriteExport(ExportFormat format, const ExportTree& tree, const ExportOptions& options,
  std::ostream& stream, const ProgressCallback& progress);
}

#endif
