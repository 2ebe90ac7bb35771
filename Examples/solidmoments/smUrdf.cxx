#include "smUrdf.h"

#include "smLengthUnits.h"
#include "smResults.h"
#include "smText.h"

#include <array>
#include <set>

namespace sm
{
namespace
{
std::string Escape(const std::string& text)
{
  std::string result;
  for (const char c : MakeUtf8(text))
  {
    result += c == '&' ? "&amp;"
      : c == '<'       ? "&lt;"
      : c == '>'       ? "&gt;"
      : c == '"'       ? "&quot;"
                       : std::string(1, c);
  }
  return result;
}

/// Returns the centre, with the axes of the frame of --about if there is one.
const std::array<double, 3>& GetCenter(const TotalResult& total)
{
  return total.About ? total.About->MassCenter.Value : total.MassCenter.Value;
}

/// Returns the inertia about the centre.
const TensorQuantity& GetInertia(const TotalResult& total)
{
  return total.About ? total.About->MassCentralInertia : total.MassInertia;
}

std::string Quote(double value)
{
  return "\"" + FormatExact(value) + "\"";
}
}

std::string FindUrdfProblem(const FileResult& file)
{
  const TotalResult& total = file.Total;
  if (!(total.Mass.Get() > 0.0))
  {
    return "it has no mass: give the densities that are missing, see --density and --materials";
  }
  const std::array<double, 3>& moments = total.MassPrincipalMoments.Value;
  if (!total.MassPrincipalMoments.IsKnown() || !GetInertia(total).IsKnown())
  {
    return "it has no inertia";
  }
  if (!(moments[0] > 0.0))
  {
    return "its inertia is not positive definite";
  }
  // For thin plates the two sides are equal up to rounding.
  return moments[2] > (moments[0] + moments[1]) * (1.0 + 1e-12)
    ? "its largest principal moment is more than the sum of the others"
    : "";
}

std::string FormatUrdf(const std::vector<FileResult>& files)
{
  std::string text =
    "<?xml version=\"1.0\"?>\n"
    "<!-- Inertial blocks by solidmoments: kg, m, kg m^2. The inertia is about the centre of mass (origin), "
    "with the axes of the\n"
    "     link; ixy, ixz and iyz are entries of the tensor, negative products of inertia. -->\n"
    "<robot name=\"solidmoments\">\n";
  std::set<std::string> taken;
  for (const FileResult& file : files)
  {
    if (!FindUrdfProblem(file).empty())
    {
      continue;
    }
    const std::string stem = GetStem(file.File);
    std::string name = stem;
    for (int i = 2; !taken.insert(name).second; ++i)
    {
      name = stem + "-" + std::to_string(i);
    }
    const double metres = GetMetres(file.LengthUnit.value_or(""));
    const double area = metres * metres;
    const std::array<double, 3>& center = GetCenter(file.Total);
    const std::array<double, 9>& inertia = GetInertia(file.Total).Value;
    text += "  <link name=\"" + Escape(name) + "\">\n    <inertial>\n      <origin xyz=\"" +
      FormatExact(metres * center[0]) + " " + FormatExact(metres * center[1]) + " " +
      FormatExact(metres * center[2]) +
      "\" rpy=\"0 0 0\"/>\n      <mass value=" + Quote(file.Total.Mass.Get()) +
      "/>\n      <inertia ixx=" + Quote(area * inertia[0]) + " ixy=" + Quote(area * inertia[1]) +
      " ixz=" + Quote(area * inertia[2]) + " iyy=" + Quote(area * inertia[4]) +
      " iyz=" + Quote(area * inertia[5]) + " izz=" + Quote(area * inertia[8]) +
      "/>\n    </inertial>\n  </link>\n";
  }
  return text + "</robot>\n";
}
}
