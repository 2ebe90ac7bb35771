/**
 * @file smPortableCxx.h
 * @brief Compiles the chunks of mathematics in glsl/ as C++, through GLM; for tests, not installed
 *
 * Include it inside no namespace, then include the chunk's file inside one, after defining the accessors
 * that the chunk names.
 */
#ifndef smPortableCxx_h
#define smPortableCxx_h

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>
#include <glm/ext/vector_double4.hpp>
#include <glm/geometric.hpp>

using glm::cross;
using glm::dot;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using glm::length;
using uint = unsigned int;

// GLSL's suffix of double literals.
#pragma GCC diagnostic ignored "-Wliteral-suffix"
constexpr double operator"" LF(long double value)
{
  return static_cast<double>(value);
}

#define SM_OUT(type) type&
#define SM_OUT_ARRAY(type, name, size) type* name
#define SM_ARRAY(type, name, size) const type* name

#endif
