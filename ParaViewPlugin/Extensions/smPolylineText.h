/**
 * @file smPolylineText.h
 * @brief Polylines as one text; a property with a number for each coordinate would send one message for each
 */
#ifndef smPolylineText_h
#define smPolylineText_h

#include "smVector.h"

#include <string>
#include <vector>

namespace sm
{
/// Writes a line of text for each polyline: x y z of its points, with digits that read back as the same
/// doubles.
std::string FormatPolylines(const std::vector<std::vector<Vector3>>& polylines);
/// Reads such a text. A line ends before the first word that is not a number.
std::vector<std::vector<Vector3>> ParsePolylines(const std::string& text);
}

#endif
