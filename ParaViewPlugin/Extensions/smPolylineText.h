/**
 * @file smPolylineText.h
 * @brief Polylines as one text, since a property with a number for each coordinate sends a message for each
 */
#ifndef smPolylineText_h
#define smPolylineText_h

#include "smVector.h"

#include <string>
#include <vector>

namespace sm
{
/// A line of text for each polyline: x y z of its points, with digits that read back to the bit.
std::string FormatPolylines(const std::vector<std::vector<Vector3>>& polylines);
/// Lines end before the first word that is no number.
std::vector<std::vector<Vector3>> ParsePolylines(const std::string& text);
}

#endif
