/**
 * @file smOCCTReadBREP.h
 * @brief Reads OpenCASCADE's BREP files, text and binary, as a tree of shapes
 */
#ifndef smOCCTReadBREP_h
#define smOCCTReadBREP_h

#include "smKernel.h"

#include <string_view>

namespace sm
{
/**
 * Reads the bytes of a BREP file. A compound of compounds and solids is an assembly; shapes that occur in it
 * several times are one object. `progress` gets a fraction in [0,1] and returns false to stop. Throws only
 * std::bad_alloc.
 */
BREPContent ReadKernelBREP(std::string_view bytes, const ProgressCallback& progress);
}

#endif
