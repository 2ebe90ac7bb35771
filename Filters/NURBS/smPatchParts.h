/**
 * @file smPatchParts.h
 * @brief Parts of a rational Bézier patch as patches of their own
 */
#ifndef smPatchParts_h
#define smPatchParts_h

#include "smFiltersNURBSModule.h"

#include "smFacePanels.h"

#include <array>
#include <cstdint>

namespace sm
{
/// Bernstein coefficients, `stride` apart, of a polynomial on [0,1] become those on [low, high], low < high. The interval may extend a
/// little beyond [0,1].
template <std::size_t Dimension>
void RestrictBernstein(
  std::array<double, Dimension>* coefficients, int degree, int stride, double low, double high)
{
  const auto split = [&](double x, bool keepLeft)
  {
    // The whole interval is kept.
    if (x == (keepLeft ? 1.0 : 0.0))
    {
      return;
    }
    for (int level = 1; level <= degree; ++level)
    {
      // In place: the finished coefficients fill the array from one end.
      for (int step = 0; step <= degree - level; ++step)
      {
        const int i = keepLeft ? degree - step : step;
        std::array<double, Dimension>& a = coefficients[stride * (keepLeft ? i - 1 : i)];
        std::array<double, Dimension>& b = coefficients[stride * (keepLeft ? i : i + 1)];
        std::array<double, Dimension>& to = keepLeft ? b : a;
        for (std::size_t c = 0; c < Dimension; ++c)
        {
          to[c] = (1.0 - x) * a[c] + x * b[c];
        }
      }
    }
  };
  // The larger part first, so that no coordinate is divided by a small number.
  if (high >= 1.0 - low)
  {
    split(high, true);
    split(low / high, false);
  }
  else
  {
    split(low, false);
    split((high - low) / (1.0 - low), true);
  }
}

/**
 * Appends to `to` the part [low, high] (in the parameters of `from`'s trim pieces) of a patch of `from` as a patch of its own,
 * and returns its index. `exchange`: with s and r exchanged, so that its Ss x Sr points the other way, and pieces of it have
 * their coordinates exchanged. Displacement grows by the rounding bound.
 */
SMFILTERSNURBS_EXPORT std::uint32_t AppendPatchPart(const FacePanels& from, std::uint32_t patch,
  const std::array<double, 2>& low, const std::array<double, 2>& high, bool exchange, FacePanels& to);
}

#endif
