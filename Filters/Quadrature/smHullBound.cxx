#include "Detail/smHullBound.h"

#include "Detail/smIntegerPower.h"
#include "smBernstein.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
constexpr double Infinite = std::numeric_limits<double>::infinity();

/// Room for the rounding of the coordinates of a hull, relative to its distance from the patch's centre.
constexpr double HullRoom = 1e-12;

// Below this ratio of neighbours' weights series of parts of the patch give better bounds.
constexpr double MinRatio = 8.0;

// A trim curve is divided into so many parts, whose control points bound its extent.
constexpr int TrimParts = 8;

/// A box in the coordinates of the model.
struct Hull
{
  std::array<double, 3> Low{ Infinite, Infinite, Infinite };
  std::array<double, 3> High{ -Infinite, -Infinite, -Infinite };

  void Add(const std::array<double, 3>& point)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Low[c] = std::min(this->Low[c], point[c]);
      this->High[c] = std::max(this->High[c], point[c]);
    }
  }

  void Widen(double room)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Low[c] -= room;
      this->High[c] += room;
    }
  }

  /// `degrees`: product of the degrees of a surface in the box.
  HullBound GetBound(double degrees, const std::array<double, 3>& shift) const
  {
    std::array<double, 3> size{};
    std::array<double, 3> farthest{};
    for (int c = 0; c < 3; ++c)
    {
      size[c] = this->High[c] - this->Low[c];
      farthest[c] = std::max(std::abs(this->Low[c] + shift[c]), std::abs(this->High[c] + shift[c]));
    }
    return { 2.0 * degrees * (size[0] * size[1] + size[1] * size[2] + size[2] * size[0]), Norm(farthest) };
  }
};

/// Returns by how much the piece of a trim curve leaves its patch at most, relative to the patch.
double GetBeyond(const double* coefficients, int degree, const Patch& patch, double start, double end)
{
  double beyond = 0.0;
  const double step = (end - start) / TrimParts;
  for (int part = 0; part < TrimParts; ++part)
  {
    std::array<double, 2> points[MaximumDegree + 1] = {};
    for (int i = 0; i <= degree; ++i)
    {
      points[i] = { coefficients[2 * i], coefficients[2 * i + 1] };
    }
    RestrictBernstein(points, degree, 1, start + part * step, start + (part + 1) * step);
    for (int i = 0; i <= degree; ++i)
    {
      for (int d = 0; d < 2; ++d)
      {
        const double local = (points[i][d] - patch.Start[d]) / patch.Width[d];
        beyond = std::max({ beyond, -local, local - 1.0 });
      }
    }
  }
  return beyond;
}

/**
 * Adds the part of a patch that the trim curve encloses with the patch's left edge. Returns false if its
 * weight may vanish.
 *
 * Beyond the patch by d, with weights of neighbours up to q apart and n = p + q degrees, the negative terms
 * of the Bernstein sums add up to at most N = (1 + q d)^n - 1 times the positive ones, see
 * TrimSeries::IsOnPatch(): a point is N / (1 - N) of the hull's diameter away from it, which is less than a
 * quarter of the patch's radius for n q d <= 0.1.
 */
bool AddPatch(const FacePanels& panels, std::uint32_t index, double beyond, Hull& hull)
{
  const Patch& patch = panels.Patches[index];
  if (!((patch.Degree[0] + patch.Degree[1]) * patch.WeightRatio * beyond <= 0.1))
  {
    return false;
  }
  Hull own;
  const int count = (patch.Degree[0] + 1) * (patch.Degree[1] + 1);
  for (int i = 0; i < count; ++i)
  {
    const std::array<double, 4>& p = panels.Points[patch.FirstPoint + i];
    own.Add({ patch.Center[0] + p[0] / p[3], patch.Center[1] + p[1] / p[3], patch.Center[2] + p[2] / p[3] });
  }
  own.Widen(HullRoom * (patch.Radius + Norm(patch.Center)) + (beyond > 0.0 ? 0.25 * patch.Radius : 0.0));
  hull.Add(own.Low);
  hull.Add(own.High);
  return true;
}

/// Adds what a panel or a ribbon, along its trim curve, has of its patch. Returns false if it has no hull, or
/// needs none.
template <class Item>
bool AddPatchOf(const FacePanels& panels, const Item& item, Hull& hull)
{
  const Patch& patch = panels.Patches[item.Patch];
  return patch.WeightRatio >= MinRatio &&
    AddPatch(panels, item.Patch,
      GetBeyond(panels.Coefficients.data() + item.Trim, item.TrimDegree, patch, item.Start, item.End), hull);
}

/// Where the weight may vanish, or need not be bounded so.
constexpr HullBound Unbounded = { Infinite, Infinite };
}

double HullBound::GetMagnitude(const BoundClass& integrand) const
{
  const int k = integrand.Degree;
  switch (integrand.Kind)
  {
    case BoundClass::VolumeMoment:
      return this->Area * IntegerPower(this->Reach, k + 1) / (3 + k);
    case BoundClass::HeightMoment:
      return this->Area * IntegerPower(this->Reach, k + 1);
    case BoundClass::AreaMoment:
      return this->Area * IntegerPower(this->Reach, k);
    case BoundClass::NormalBasis:
    case BoundClass::FluxBasis:
    case BoundClass::AreaBasis:
      // The hull does not bound the weight.
      return std::numeric_limits<double>::infinity();
    default:
      return this->Area;
  }
}

HullBound BoundPatchByHull(const FacePanels& panels, std::uint32_t patch, const std::array<double, 3>& shift)
{
  Hull hull;
  const int* degree = panels.Patches[patch].Degree;
  return panels.Patches[patch].WeightRatio >= MinRatio && AddPatch(panels, patch, 0.0, hull)
    ? hull.GetBound(static_cast<double>(degree[0]) * degree[1], shift)
    : Unbounded;
}

HullBound BoundPanelByHull(const FacePanels& panels, const Panel& panel, const std::array<double, 3>& shift)
{
  Hull hull;
  if (!AddPatchOf(panels, panel, hull))
  {
    return Unbounded;
  }
  // A point of the patch is covered once for every t with its r, of which there are no more than r(t)'s
  // degree.
  const int* degree = panels.Patches[panel.Patch].Degree;
  return hull.GetBound(
    static_cast<double>(std::max<int>(panel.TrimDegree, 1)) * degree[0] * degree[1], shift);
}

HullBound BoundRibbonByHull(
  const FacePanels& panels, const Ribbon& ribbon, const std::array<double, 3>& shift)
{
  Hull hull;
  if (!AddPatchOf(panels, ribbon, hull))
  {
    return Unbounded;
  }
  // The part of the edge's curve, whose piece ends at 0 and 1, lies in the box of the piece's coefficients.
  const double* edge = panels.Coefficients.data() + ribbon.Edge;
  for (int i = 0; i <= ribbon.EdgeDegree; ++i)
  {
    hull.Add({ edge[3 * i], edge[3 * i + 1], edge[3 * i + 2] });
  }
  hull.Widen(HullRoom * (Norm(hull.Low) + Norm(hull.High)));
  const int* degree = panels.Patches[ribbon.Patch].Degree;
  // (1-l) P/w + l C has the denominator w and the numerator (1-l) P + l C w, of degree 1 in l.
  const double along = (degree[0] + degree[1]) * std::max<int>(ribbon.TrimDegree, 1) + ribbon.EdgeDegree;
  return hull.GetBound(along, shift);
}
}
