/**
 * @file smOptionValues.h
 * @brief Parses directions, planes, frames and tolerances in the text of options
 */
#ifndef smOptionValues_h
#define smOptionValues_h

#include <array>
#include <string>
#include <vector>

namespace sm
{
/// Parses an element of QuantityTolerances; false when it is not well formed.
bool ParseQuantityTolerance(
  const std::string& text, std::string& quantity, double& relative, double& absolute);

/// Parses "x", "+y", "-z", or three numbers, "0,0.1,-1"; false when the text is neither, or all three are 0.
bool ParseDirection(const std::string& text, std::array<double, 3>& direction);

/// Returns an error message for a text that is not a direction; empty otherwise.
std::string CheckDirection(const std::string& text);

/// Parses a plane "X,Y,Z,NX,NY,NZ", a point and a normal; false when it is not six numbers, or the normal is
/// 0.
bool ParsePlane(const std::string& text, std::array<double, 6>& plane);

/// Parses "origin", a point "X,Y,Z", or a frame of nine numbers: origin, direction of its z axis, direction
/// of its x axis. False when the text is none of them, or the directions make no frame.
bool ParseFrame(const std::string& text, std::vector<double>& frame);
}

#endif
