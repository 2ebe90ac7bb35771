/**
 * @file smOCCTReadBREP.h
 * @brief Reads OpenCASCADE's BREP files, text and binary, as parts and instances
 */
#ifndef smOCCTReadBREP_h
#define smOCCTReadBREP_h

#include "smDocument.h"

#include <string_view>

namespace sm
{
/**
 * Reads the bytes of a BREP file. The format has neither names nor units: the length unit of the document is
 * that of the numbers, which the caller must set. A compound of compounds and solids is an assembly, and
 * shapes that occur in it several times are instances of one part. `progress` gets a fraction in [0,1] and
 * returns false to stop. Throws only std::bad_alloc.
 */
Document ReadKernelBREP(std::string_view bytes, const ProgressCallback& progress);
}

#endif
