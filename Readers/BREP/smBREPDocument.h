/**
 * @file smBREPDocument.h
 * @brief Reads OpenCASCADE's BREP files, text and binary, as parts and instances
 */
#ifndef smBREPDocument_h
#define smBREPDocument_h

#include "smOCCTDocument.h"

#include <string>
#include <string_view>

namespace sm
{
/// Message for bytes that do not begin like a BREP file.
inline const std::string NotBREP =
  "it is not a BREP file of OpenCASCADE: \"CASCADE Topology\" is missing at its start";

/// Returns true if the bytes begin like a BREP file.
bool LooksLikeBREP(std::string_view bytes);

/**
 * Reads the bytes of a BREP file. The format has neither names nor units: the length unit of the document is
 * that of the numbers, which the caller must set. A compound of compounds and solids is an assembly, and
 * shapes that occur in it several times are instances of one part. `progress` gets a fraction in [0,1] and
 * returns false to stop. The caller must hold a KernelSession. Throws only std::bad_alloc.
 */
Document ReadBREP(std::string_view bytes, const ProgressCallback& progress);
}

#endif
