/**
 * @file smPortableCxx.h
 * @brief Compiles the chunks of mathematics in glsl/ as C++, through GLM; not installed
 *
 * Include it in a source file, not in a header, and inside no namespace. Then include the files of the chunks
 * in a namespace, or in the body of a class, where the names that they need are declared: accessors, sizes
 * and arrays, which every chunk lists in its first comment.
 */
#ifndef smPortableCxx_h
#define smPortableCxx_h

#include <glm/common.hpp>
#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>
#include <glm/ext/vector_double4.hpp>
#include <glm/ext/vector_uint2.hpp>
#include <glm/ext/vector_uint4.hpp>
#include <glm/geometric.hpp>
#include <glm/packing.hpp>

using glm::abs;
using glm::clamp;
using glm::cross;
using glm::dot;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using glm::floor;
using glm::length;
using glm::max;
using glm::min;
using glm::packDouble2x32;
using glm::uintBitsToFloat;
using glm::unpackDouble2x32;
using glm::uvec2;
using glm::uvec4;
using uint = unsigned int;

// GLSL's suffix of double literals.
#pragma GCC diagnostic ignored "-Wliteral-suffix"
constexpr double operator"" LF(long double value)
{
  return static_cast<double>(value);
}

// A C++ compiler does not reorder operations without -ffast-math, so GLSL's `precise` has no counterpart.
#define precise

#define SM_OUT(type) type&
#define SM_INOUT(type) type&
#define SM_DOUBLES(name, size) double name[size]
#define SM_OUT_DOUBLES(name, size) double* name
#define SM_DOUBLE(name, at) name[at]
#define SM_SET_DOUBLE(name, at, value) name[at] = value
#define SM_VECTORS(name, size) dvec4 name[size]
#define SM_IN_VECTORS(name, size) const dvec4* name
#define SM_OUT_VECTORS(name, size) dvec4* name
#define SM_VECTOR(name, at) name[at]
#define SM_SET_VECTOR(name, at, value) name[at] = value
#define SM_CONSTANT static constexpr
#define SM_SELECT(condition, yes, no) ((condition) ? (yes) : (no))
#define SM_ANY(condition) (condition)

#endif
