#include "Detail/smStrip.h"

#include "Detail/smSignChanges.h"
#include "smChebyshev.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace sm
{
namespace
{
template <std::size_t Dimension>
std::vector<std::array<double, Dimension>> GetPoints(
  const FacePanels& panels, std::uint32_t first, int degree)
{
  std::vector<std::array<double, Dimension>> points(degree + 1);
  for (int i = 0; i <= degree; ++i)
  {
    std::copy_n(panels.Coefficients.data() + first + Dimension * i, Dimension, points[i].begin());
  }
  return points;
}
}

Strip::Strip(const FacePanels& panels, const Ribbon& ribbon)
  : Panels(panels)
  , Source(panels.Patches[ribbon.Patch])
  , Own(ribbon)
  , TrimPoints(GetPoints<2>(panels, ribbon.Trim, ribbon.TrimDegree))
  , EdgePoints(GetPoints<3>(panels, ribbon.Edge, ribbon.EdgeDegree))
  , Trim{ this->TrimPoints.data(), ribbon.TrimDegree }
  , EdgePiece{ this->EdgePoints.data(), ribbon.EdgeDegree }
{
  const Patch& patch = this->Source;
  this->FaceDegree = 0;
  double length = 0.0;
  for (int d = 0; d < 2; ++d)
  {
    double largest = 0.0;
    for (int i = 0; i < ribbon.TrimDegree; ++i)
    {
      largest =
        std::max(largest, std::abs(this->Trim.Coefficients[i + 1][d] - this->Trim.Coefficients[i][d]));
    }
    this->FaceDegree += largest > 0.0 ? patch.Degree[d] * ribbon.TrimDegree : 0;
    length += ribbon.TrimDegree * largest * (ribbon.End - ribbon.Start) * patch.Stretch[d] / patch.Width[d];
  }
  this->EdgeDegree = ribbon.EdgeDegree;
  double step = 0.0;
  for (int i = 0; i < ribbon.EdgeDegree; ++i)
  {
    const Point3& a = this->EdgePiece.Coefficients[i];
    const Point3& b = this->EdgePiece.Coefficients[i + 1];
    step = std::max(step, std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]));
  }
  this->Length = length + ribbon.EdgeDegree * step * std::abs(ribbon.EdgeEnd - ribbon.EdgeStart);
  for (const Point3& point : this->EdgePoints)
  {
    this->EdgeReach = std::max(this->EdgeReach, Norm(point));
  }
  this->MinWeight = std::numeric_limits<double>::infinity();
  for (int i = 0; i < (patch.Degree[0] + 1) * (patch.Degree[1] + 1); ++i)
  {
    this->MinWeight = std::min(this->MinWeight, panels.Points[patch.FirstPoint + i][3]);
  }
  this->Gap = this->GetGap(0.0, 1.0);
}

double Strip::GetGap(double start, double end) const
{
  // With the edge curve C, the patch's homogeneous position P and its weight w, C w - P is a polynomial along
  // the strip.
  const Patch& patch = this->Source;
  const int degree = this->FaceDegree + this->EdgeDegree;
  const auto sample = [&](double t)
  {
    const std::array<double, 2> at = this->EvaluateTrim(t);
    const double local[2] = { (at[0] - patch.Start[0]) / patch.Width[0],
      (at[1] - patch.Start[1]) / patch.Width[1] };
    std::array<double, 4> line[MaximumDegree + 1] = {};
    for (int j = 0; j <= patch.Degree[1]; ++j)
    {
      line[j] = BernsteinPiece<4>{ this->Panels.Points.data() + patch.FirstPoint + j * (patch.Degree[0] + 1),
        patch.Degree[0] }
                  .Evaluate(local[0]);
    }
    const std::array<double, 4> h = BernsteinPiece<4>{ line, patch.Degree[1] }.Evaluate(local[1]);
    const Point3 edge = this->EvaluateEdge(t);
    Point3 gap;
    for (int c = 0; c < 3; ++c)
    {
      gap[c] = (edge[c] - patch.Center[c]) * h[3] - h[c];
    }
    return gap;
  };
  if (degree >= ChebyshevRule::MaximumSize)
  {
    const Point3 gap = sample(0.5 * (start + end));
    return std::hypot(gap[0], gap[1], gap[2]) / this->MinWeight + this->Length * (end - start);
  }
  Point3 largest{};
  std::vector<double> series;
  // The three expansions ask for the same nodes in the same order.
  std::vector<Point3> samples;
  for (int c = 0; c < 3; ++c)
  {
    std::size_t node = 0;
    const auto getComponent = [&](double t)
    {
      if (c == 0)
      {
        samples.push_back(sample(t));
      }
      return samples[node++][c];
    };
    ExpandPolynomial(getComponent, degree, start, end, series);
    largest[c] = GetLargest(series);
  }
  return std::hypot(largest[0], largest[1], largest[2]) / this->MinWeight;
}
}
