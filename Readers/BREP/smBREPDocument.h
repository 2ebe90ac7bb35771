/**
 * @file smBREPDocument.h
 * @brief OpenCASCADE's BREP files, text and binary, as parts and instances
 */
#ifndef smBREPDocument_h
#define smBREPDocument_h

#include "smOCCTDocument.h"

#include <string>
#include <string_view>

namespace sm
{
/// Why bytes that do not begin like a BREP file cannot be read.
inline const std::string NotBREP =
  "it is not a BREP file of OpenCASCADE: \"CASCADE Topology\" is missing at its start";

/// The bytes begin like a BREP file.
bool LooksLikeBREP(std::string_view bytes);

/**
 * Reads the bytes of a BREP file. The format has neither names nor units: the length unit of the document is that of the numbers, which
 * the caller knows. A compound of compounds and solids is an assembly, and shapes that occur in it several times are instances of one
 * part. `progress` gets a fraction in [0,1] and answers false to stop. The caller holds a KernelSession. Throws std::bad_alloc, and
 * nothing else.
 */
Document ReadBREP(std::string_view bytes, const ProgressCallback& progress);
}

#endif
