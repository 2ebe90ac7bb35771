/**
 * @file smPartFile.h
 * @brief Checking parts and writing them as STEP
 */
#ifndef smPartFile_h
#define smPartFile_h

#include "smPaperParts.h"

#include <string>

namespace smpaper
{
/// Counts over all placements of a part's solids.
struct PartCounts
{
  int Solids = 0;
  int Faces = 0;
  /// Faces whose loops are not just a rectangle of constant parameters.
  int TrimmedFaces = 0;
  /// Faces that the file holds; those of a solid that is placed often count once.
  int DistinctFaces = 0;
};

PartCounts Count(const PaperPart& part);

/// Throws std::runtime_error unless every solid passes BRepCheck_Analyzer, has closed shells, and a volume above 0.
void Check(const PaperPart& part);

/// Turns off OpenCASCADE's messages on stdout.
void QuietOpenCascade();

/// Writes a part with its names, every number with 17 digits, the time stamp fixed: the same bytes for the same part.
/// Throws std::runtime_error.
void WriteStep(const PaperPart& part, const std::string& path);
}

#endif
