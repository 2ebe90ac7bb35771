#include "smLengthUnits.h"

#include <cctype>
#include <map>

namespace sm
{
double GetUnitInMillimetres(const std::string& unit)
{
  static const std::map<std::string, double> units = { { "mm", 1.0 }, { "millimetre", 1.0 },
    { "millimeter", 1.0 }, { "cm", 10.0 }, { "centimetre", 10.0 }, { "centimeter", 10.0 }, { "dm", 100.0 },
    { "decimetre", 100.0 }, { "decimeter", 100.0 }, { "m", 1000.0 }, { "metre", 1000.0 }, { "meter", 1000.0 },
    { "km", 1e6 }, { "kilometre", 1e6 }, { "kilometer", 1e6 }, { "um", 1e-3 }, { "micrometre", 1e-3 },
    { "micrometer", 1e-3 }, { "micron", 1e-3 }, { "inch", 25.4 }, { "in", 25.4 }, { "inches", 25.4 },
    { "ft", 304.8 }, { "foot", 304.8 }, { "feet", 304.8 }, { "yard", 914.4 }, { "mile", 1609344.0 },
    { "mil", 0.0254 }, { "thou", 0.0254 } };
  std::string name;
  for (const char c : unit)
  {
    name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  const auto found = units.find(name);
  return found == units.end() ? 0.0 : found->second;
}

double GetMetres(const std::string& unit)
{
  // Divided, not multiplied by 1e-3: the quotient is the double nearest to the length (0.0254, 0.3048).
  return GetUnitInMillimetres(unit) / 1000.0;
}

std::string GetShortUnit(double millimetres)
{
  for (const char* name : { "mm", "m", "cm", "inch", "ft", "um" })
  {
    if (GetUnitInMillimetres(name) == millimetres)
    {
      return name;
    }
  }
  return {};
}
}
