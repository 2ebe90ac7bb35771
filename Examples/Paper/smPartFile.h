/**
 * @file smPartFile.h
 * @brief Checks parts and writes them as STEP
 */
#ifndef smPartFile_h
#define smPartFile_h

#include "smPaperParts.h"

#include <string>

namespace smpaper
{
/// Numbers of solids and faces, over all placements of a part's solids.
struct PartCounts
{
  int Solids = 0;
  int Faces = 0;
  /// Faces whose loop is not a rectangle of constant parameters.
  int TrimmedFaces = 0;
  /// Faces in the file; those of a solid with several placements count once.
  int DistinctFaces = 0;
};

PartCounts Count(const PaperPart& part);

/// Throws std::runtime_error unless every solid passes BRepCheck_Analyzer, has closed shells, and a volume
/// above 0.
void Check(const PaperPart& part);

/// Turns off OpenCASCADE's messages on stdout.
void QuietOpenCascade();

/// Writes a part with its names, 17 digits per number and a fixed time stamp, so that the same part gives the
/// same bytes. Throws std::runtime_error.
void WriteStep(const PaperPart& part, const std::string& path);
}

#endif
