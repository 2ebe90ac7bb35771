/**
 * @file smShaderCheck.h
 * @brief Finds what compilers of some drivers get wrong in the text of a shader; not installed
 */
#ifndef smShaderCheck_h
#define smShaderCheck_h

#include "smRenderingComputeModule.h"

#include <string>

namespace sm
{
/**
 * Returns a sentence, with the name and the line, about the first construct of a GLSL text that NVIDIA's
 * compiler gets wrong (Documentation/Drivers.md); empty if there is none:
 *
 * - an array of double, dvec2, dvec3, dvec4, or of a structure with such a member, that belongs to an
 *   invocation: local or global variables, constants, parameters, members of structures, constructors.
 *   Indexed by what is not a constant, it holds floats.
 * - a variable of a type dmat..., whose columns are such an array.
 * - an assignment to a component of a dvec2, dvec3 or dvec4 by an index that is not a number. It does not
 *   link.
 *
 * Arrays in buffers, uniforms and shared variables are right. Types that a macro without parameters stands
 * for are recognized; the text of other macros is searched as it stands.
 */
SMRENDERINGCOMPUTE_EXPORT std::string FindUnsafeConstruct(const std::string& source);
}

#endif
