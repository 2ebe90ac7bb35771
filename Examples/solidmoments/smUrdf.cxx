#include "smUrdf.h"

#include "smLengthUnits.h"
#include "smText.h"

#include <algorithm>
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

/// Returns centre and central inertia, with the axes of the frame of --about if there is one.
const Json& GetPlaced(const Json& file)
{
  const Json& total = file["total"];
  return total["about"].is_null() ? total : total["about"];
}

const Json& GetInertia(const Json& file)
{
  return GetPlaced(file)[file["total"]["about"].is_null() ? "mass_inertia" : "mass_central_inertia"];
}
}

std::string FindUrdfProblem(const Json& file)
{
  const Json& total = file["total"];
  if (total["mass"].is_null() || !(total["mass"].get<double>() > 0.0))
  {
    return "it has no mass: give the densities that are missing, see --density and --materials";
  }
  const Json& moments = total["mass_principal_moments"];
  if (moments.is_null() || GetInertia(file).is_null())
  {
    return "it has no inertia";
  }
  const auto get = [&moments](size_t i) { return moments[i].get<double>(); };
  if (!(get(0) > 0.0))
  {
    return "its inertia is not positive definite";
  }
  // For thin plates the two sides are equal up to rounding.
  return get(2) > (get(0) + get(1)) * (1.0 + 1e-12)
    ? "its largest principal moment is more than the sum of the others"
    : "";
}

std::string FormatUrdf(const Json& files)
{
  std::string text =
    "<?xml version=\"1.0\"?>\n"
    "<!-- Inertial blocks by solidmoments: kg, m, kg m^2. The inertia is about the centre of mass (origin), "
    "with the axes of the\n"
    "     link; ixy, ixz and iyz are entries of the tensor, negative products of inertia. -->\n"
    "<robot name=\"solidmoments\">\n";
  std::set<std::string> taken;
  for (const Json& file : files)
  {
    if (!FindUrdfProblem(file).empty())
    {
      continue;
    }
    const std::string stem = GetStem(file["file"].get<std::string>());
    std::string name = stem;
    for (int i = 2; !taken.insert(name).second; ++i)
    {
      name = stem + "-" + std::to_string(i);
    }
    const double metres = GetMetres(file["length_unit"].get<std::string>());
    const auto scale = [](const Json& value, double factor)
    { return "\"" + Dump(Json(factor * value.get<double>())) + "\""; };
    const Json& center = GetPlaced(file)["mass_center"];
    const Json& inertia = GetInertia(file);
    const double area = metres * metres;
    const auto getMetres = [&](size_t i) { return Dump(Json(metres * center[i].get<double>())); };
    text += "  <link name=\"" + Escape(name) + "\">\n    <inertial>\n      <origin xyz=\"" + getMetres(0) +
      " " + getMetres(1) + " " + getMetres(2) +
      "\" rpy=\"0 0 0\"/>\n      <mass value=" + scale(file["total"]["mass"], 1.0) +
      "/>\n      <inertia ixx=" + scale(inertia[0][0], area) + " ixy=" + scale(inertia[0][1], area) +
      " ixz=" + scale(inertia[0][2], area) + " iyy=" + scale(inertia[1][1], area) +
      " iyz=" + scale(inertia[1][2], area) + " izz=" + scale(inertia[2][2], area) +
      "/>\n    </inertial>\n  </link>\n";
  }
  return text + "</robot>\n";
}
}
