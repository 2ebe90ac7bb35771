#include "Detail/smVariantErrors.h"

#include <cmath>

namespace sm
{
namespace
{
std::array<ErrorBound, 3> EvaluateForms3(
  const std::array<std::vector<ErrorBound>, 3>& forms, const std::vector<double>& sizes)
{
  std::array<ErrorBound, 3> sums{};
  for (int c = 0; c < 3; ++c)
  {
    for (std::size_t a = 0; a < sizes.size(); ++a)
    {
      sums[c].Value += sizes[a] * forms[c][a].Value;
      sums[c].Error += sizes[a] * forms[c][a].Error;
    }
  }
  return sums;
}
}

double GetErrorGrowth(std::size_t variables)
{
  return 1.0001 * (1.0 + (static_cast<double>(variables) + 2.0) / 2.0);
}

void AddErrors(
  const PointsErrors& face, const std::vector<double>& sizes, std::array<double, NumberOfMoments>& bounds)
{
  const double growth = GetErrorGrowth(sizes.size());
  for (const VariantError& term : face.Terms)
  {
    const auto flux = GetFluxBounds(EvaluateForms3(term.Forms.Position, sizes),
      EvaluateForms3(term.Forms.First, sizes), EvaluateForms3(term.Forms.Second, sizes));
    for (int m = 0; m < NumberOfMoments; ++m)
    {
      bounds[m] +=
        PointsRounding * (term.ValueFactor * flux[m].Value + term.ErrorFactor * growth * flux[m].Error);
    }
  }
}

void AddErrors(const std::vector<PointsErrors>& faces, const double* c, std::vector<double>& sizes,
  std::array<double, NumberOfMoments>& bounds)
{
  for (const PointsErrors& face : faces)
  {
    sizes.assign(1, 1.0);
    for (const int direction : face.Directions)
    {
      sizes.push_back(std::abs(c[direction]));
    }
    AddErrors(face, sizes, bounds);
  }
}
}
