#include "smMassIntegrands.h"

#include "smMassPropertyNames.h"

namespace sm
{
namespace
{
std::vector<Integrand> MakeIntegrands()
{
  std::vector<Integrand> integrands;
  integrands.push_back(Integrand::VolumeMoment(names::Volume, 0, 0, 0));
  const int powers[9][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 },
    { 1, 1, 0 }, { 0, 1, 1 }, { 1, 0, 1 } };
  const char* const moments[9] = { "X", "Y", "Z", "XX", "YY", "ZZ", "XY", "YZ", "XZ" };
  for (int i = 0; i < 9; ++i)
  {
    integrands.push_back(Integrand::VolumeMoment(moments[i], powers[i][0], powers[i][1], powers[i][2]));
  }
  const char* const components[3] = { "NX", "NY", "NZ" };
  for (int i = 0; i < 3; ++i)
  {
    integrands.push_back(Integrand::VectorArea(components[i], i));
  }
  integrands.push_back(Integrand::AreaMoment(names::SurfaceArea, 0, 0, 0));
  return integrands;
}
}

const std::vector<Integrand>& GetMassIntegrands()
{
  static const std::vector<Integrand> integrands = MakeIntegrands();
  return integrands;
}
}
