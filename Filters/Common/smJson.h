/**
 * @file smJson.h
 * @brief The JSON type of results and programs: keys keep their order; not installed
 */
#ifndef smJson_h
#define smJson_h

// VTK's headers may include VTK's own copy, in another namespace, and two copies cannot be included in one
// file.
#if __has_include(<vtk_nlohmannjson.h>)
#include <vtk_nlohmannjson.h>
#include VTK_NLOHMANN_JSON(json.hpp)
#else
#include <nlohmann/json.hpp>
#endif

#include <cmath>
#include <string>

namespace sm
{
using Json = nlohmann::ordered_json;

/// Returns a number, or null if the value is not finite.
inline Json MakeNumber(double value)
{
  return std::isfinite(value) ? Json(value) : Json();
}

/// Returns JSON as text, on one line or with `indent` blanks for every level; bytes that are not UTF-8 are
/// replaced by U+FFFD.
inline std::string Dump(const Json& value, int indent = -1)
{
  return value.dump(indent, ' ', false, Json::error_handler_t::replace);
}
}

#endif
