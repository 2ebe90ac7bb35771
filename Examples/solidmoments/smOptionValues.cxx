#include "smOptionValues.h"

#include "smText.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace sm
{
bool ParseDirection(const std::string& text, std::array<double, 3>& direction)
{
  direction = { 0.0, 0.0, 0.0 };
  const bool sign = !text.empty() && (text[0] == '+' || text[0] == '-');
  if (text.size() == (sign ? 2u : 1u) && text.back() >= 'x' && text.back() <= 'z')
  {
    direction[text.back() - 'x'] = text[0] == '-' ? -1.0 : 1.0;
    return true;
  }
  const std::vector<double> numbers = ParseNumbers(text);
  if (numbers.size() != 3 ||
    !std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); }))
  {
    return false;
  }
  std::copy(numbers.begin(), numbers.end(), direction.begin());
  return direction[0] != 0.0 || direction[1] != 0.0 || direction[2] != 0.0;
}

std::string CheckDirection(const std::string& text)
{
  std::array<double, 3> direction;
  return ParseDirection(text, direction)
    ? ""
    : text + " is not a direction; write x, y, z, -x, -y, -z, or three numbers such as 0,0.1,-1";
}

bool ParsePlane(const std::string& text, std::array<double, 6>& plane)
{
  const std::vector<double> numbers = ParseNumbers(text);
  if (numbers.size() != plane.size() ||
    !std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); }))
  {
    return false;
  }
  std::copy(numbers.begin(), numbers.end(), plane.begin());
  return plane[3] != 0.0 || plane[4] != 0.0 || plane[5] != 0.0;
}

bool ParseFrame(const std::string& text, std::vector<double>& frame)
{
  const std::vector<double> given = LowerCase(text) == "origin" ? std::vector<double>(3) : ParseNumbers(text);
  frame = { 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0 };
  if ((given.size() != 3 && given.size() != 9) ||
    !std::all_of(given.begin(), given.end(), [](double number) { return std::isfinite(number); }))
  {
    return false;
  }
  std::copy(given.begin(), given.end(), frame.begin());
  // The smallest sine that vtkMassPropertiesBase accepts, with a margin.
  double across[3];
  vtkMath::Cross(frame.data() + 3, frame.data() + 6, across);
  return vtkMath::Norm(across) > 2e-6 * vtkMath::Norm(frame.data() + 3) * vtkMath::Norm(frame.data() + 6);
}

bool ParseQuantityTolerance(
  const std::string& text, std::string& quantity, double& relative, double& absolute)
{
  const std::string::size_type equals = text.find('=');
  if (equals == std::string::npos)
  {
    return false;
  }
  quantity = text.substr(0, equals);
  quantity = quantity == "centre" ? "center" : quantity;
  if (quantity != "volume" && quantity != "area" && quantity != "center" && quantity != "inertia")
  {
    return false;
  }
  const std::vector<double> numbers = ParseNumbers(text.substr(equals + 1));
  if (numbers.empty() || numbers.size() > 2)
  {
    return false;
  }
  relative = numbers[0];
  absolute = numbers.size() == 2 ? numbers[1] : 0.0;
  return relative >= 0.0 && relative <= 1.0 && absolute >= 0.0 && std::isfinite(absolute);
}
}
