#include "Detail/smNetGradient.h"

#include "smUnitRoundoff.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace sm
{
namespace
{
using Wide = long double;

// Roundings of the few operations at the end.
constexpr double FinalRoundings = 32.0 * UnitRoundoff;
// Makes up for the rounding of sums of bounds.
constexpr double BoundGrowth = 1.0 + 1e-10;

/// Row k: the coefficients of control points span - p .. span in the Bezier point k of [start, end], which
/// lies in that span. They are not negative, and their sum is 1: a blossom of the B-splines.
class Extraction
{
public:
  Extraction(const std::vector<double>& knots, int degree, double start, double end)
    : Degree(degree)
    , Rows((degree + 1) * (degree + 1))
  {
    const double middle = 0.5 * (start + end);
    const auto first = knots.begin() + degree;
    const auto last = knots.end() - degree - 1;
    this->Span = static_cast<int>(
      std::clamp(std::upper_bound(first, last, middle) - 1, first, last - 1) - knots.begin());
    std::vector<Wide> values(degree + 1);
    for (int i = 0; i <= degree; ++i)
    {
      for (int k = 0; k <= degree; ++k)
      {
        std::fill(values.begin(), values.end(), Wide(0));
        values[i] = 1;
        for (int level = 1; level <= degree; ++level)
        {
          const Wide x = level <= k ? end : start;
          for (int j = degree; j >= level; --j)
          {
            const Wide low = knots[this->Span - degree + j];
            const Wide high = knots[this->Span + j - level + 1];
            const Wide alpha = (x - low) / (high - low);
            values[j] = (1 - alpha) * values[j - 1] + alpha * values[j];
          }
        }
        this->Rows[k * (degree + 1) + i] = values[degree];
      }
    }
  }

  int GetFirst() const { return this->Span - this->Degree; }
  Wide Get(int k, int i) const { return this->Rows[k * (this->Degree + 1) + i]; }

private:
  int Degree;
  int Span = 0;
  std::vector<Wide> Rows;
};

/// Sums for one control point.
struct Entry
{
  Wide Sums[channel::Count] = {};
  /// Bounds of the quadrature errors: of n and of x.n with a moment of degree 0, 1, 2, and of the area's
  /// vector and scalar, these with roundings and what residuals of trim curves sweep.
  double Quadrature[8] = {};
  /// Bound of the area of strips where the point moves.
  double Strips = 0.0;
};

std::vector<BoundClass> GetClasses()
{
  std::vector<BoundClass> classes;
  for (const BoundClass::KindType kind : { BoundClass::NormalBasis, BoundClass::FluxBasis })
  {
    for (int degree = 0; degree < 3; ++degree)
    {
      classes.push_back({ kind, degree });
    }
  }
  classes.push_back({ BoundClass::AreaBasis, 0 });
  classes.push_back({ BoundClass::AreaBasis, 1 });
  return classes;
}

/// The area of strips by which the derivative depends on how edges follow the faces: the ribbons in a patch,
/// those of other coedges of the same edges, and caps and ribbons at the corners of all faces at their
/// vertices. Their points move at most as fast as those of the patch's border, by less than 1 for a unit of a
/// control point. Infinite if one of them is not known.
double GetStripArea(const NetGradientTask& task, std::uint32_t patch, const std::vector<const Edge*>& edges)
{
  const FacePanels& panels = task.Cut->Panels;
  std::set<int> coedges;
  double area = 0.0;
  bool hasRibbon = false;
  bool hasCorner = false;
  for (std::size_t i = 0; i < panels.Ribbons.size(); ++i)
  {
    const Ribbon& ribbon = panels.Ribbons[i];
    if (ribbon.Patch != patch)
    {
      continue;
    }
    hasRibbon = true;
    area += task.Strips->Ribbons[i].Swept;
    if (ribbon.Coedge < 0)
    {
      hasCorner = true;
      continue;
    }
    area += task.Strips->Ribbons[i].Area;
    coedges.insert(ribbon.Coedge);
  }
  if (!hasRibbon)
  {
    return 0.0;
  }
  for (const int coedge : coedges)
  {
    for (const BodyStrips::Use& use : task.Body->Edges.at(edges[coedge]))
    {
      area += use.Face == task.Index && use.Coedge == coedge ? 0.0 : use.Area;
    }
  }
  // A corner does not say at which vertex it is.
  for (int coedge = 0; hasCorner && coedge < static_cast<int>(edges.size()); ++coedge)
  {
    coedges.insert(coedge);
  }
  std::set<std::size_t> faces{ task.Index };
  for (const int coedge : coedges)
  {
    for (const std::array<double, 3>& vertex : { edges[coedge]->StartVertex, edges[coedge]->EndVertex })
    {
      const std::vector<std::size_t>& others = task.Body->Vertices.at(vertex);
      faces.insert(others.begin(), others.end());
    }
  }
  for (const std::size_t face : faces)
  {
    area += task.Body->Corners[face];
  }
  return std::isnan(area) ? std::numeric_limits<double>::infinity() : area;
}

/// Bounds on a patch and where trim curves leave it: the Bernstein polynomials' absolute values add up to at
/// most `growth` and they to 1, so that negative ones add up to less than (growth - 1) / 2.
struct WeightBounds
{
  /// A lower bound of the weight; not positive where it may vanish.
  double Minimum;
  /// An upper bound of the sum of all |R|: of the weight plus twice the negative terms, over the weight.
  double Speed;

  WeightBounds(const FacePanels& panels, const Patch& patch, double growth)
  {
    const std::array<double, 4>* points = panels.Points.data() + patch.FirstPoint;
    const int count = (patch.Degree[0] + 1) * (patch.Degree[1] + 1);
    const auto [minimum, maximum] =
      std::minmax_element(points, points + count, [](const auto& a, const auto& b) { return a[3] < b[3]; });
    const bool isEven = (*minimum)[3] == (*maximum)[3];
    const double negative = 0.5 * (growth - 1.0) * (*maximum)[3];
    this->Minimum = isEven ? (*minimum)[3] : (*minimum)[3] - negative;
    this->Speed = isEven    ? growth
      : this->Minimum > 0.0 ? 1.0 + 2.0 * negative / this->Minimum
                            : std::numeric_limits<double>::infinity();
  }
};

/// What residuals of trim curves sweep of the parameters of a patch.
struct SweptParameters
{
  /// A bound of the area: a curve that moves by ds and dr sweeps ds |r'| + dr |s'|, and a coordinate's way is
  /// no longer than that of its coefficients.
  double Area = 0.0;
  /// A factor for BoundBasis(), which holds on the curves, to hold there, too.
  double Growth = 1.0;
};

SweptParameters GetSweptParameters(
  const FacePanels& panels, std::uint32_t patch, const std::vector<const Coedge*>& coedges, bool isTransposed)
{
  SweptParameters swept;
  double farthest[2] = { 0.0, 0.0 };
  for (const Ribbon& ribbon : panels.Ribbons)
  {
    if (ribbon.Patch != patch || ribbon.Coedge < 0)
    {
      continue;
    }
    const TrimCurve::Point& residual = coedges[ribbon.Coedge]->Curve.GetResidual(ribbon.Piece);
    const double* trim = panels.Coefficients.data() + ribbon.Trim;
    double way[2] = { 0.0, 0.0 };
    for (int i = 0; i < ribbon.TrimDegree; ++i)
    {
      way[0] += std::abs(trim[2 * i + 2] - trim[2 * i]);
      way[1] += std::abs(trim[2 * i + 3] - trim[2 * i + 1]);
    }
    const double moved[2] = { residual[isTransposed ? 1 : 0], residual[isTransposed ? 0 : 1] };
    const double* width = panels.Patches[patch].Width;
    swept.Area += (moved[0] * way[1] + moved[1] * way[0]) / (width[0] * width[1]);
    farthest[0] = std::max(farthest[0], moved[0] / width[0]);
    farthest[1] = std::max(farthest[1], moved[1] / width[1]);
  }
  for (int d = 0; d < 2; ++d)
  {
    swept.Growth *= std::pow(1.0 + 2.0 * farthest[d], panels.Patches[patch].Degree[d]);
  }
  return swept;
}

/// A bound of |R_s| |Sr| + |R_r| |Ss|, with the sums of all R, on a patch and beyond it; `growth`: a bound of
/// the sum of the absolute values of the Bernstein polynomials, and of those of lower degrees.
double GetAreaSlope(const FacePanels& panels, const Patch& patch, double growth)
{
  const std::array<double, 4>* points = panels.Points.data() + patch.FirstPoint;
  const int columns = patch.Degree[0] + 1;
  const WeightBounds bounds(panels, patch, growth);
  const double weight = bounds.Minimum;
  if (!(weight > 0.0))
  {
    return std::numeric_limits<double>::infinity();
  }
  // The largest steps of weights, and of points relative to the patch's centre, times weights.
  double ofWeight[2] = { 0.0, 0.0 };
  double ofPoint[2] = { 0.0, 0.0 };
  for (int j = 0; j <= patch.Degree[1]; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const std::array<double, 4>& point = points[i + columns * j];
      for (int d = 0; d < 2; ++d)
      {
        if ((d == 0 ? i : j) > 0)
        {
          const std::array<double, 4>& before = points[d == 0 ? i - 1 + columns * j : i + columns * (j - 1)];
          ofWeight[d] = std::max(ofWeight[d], std::abs(point[3] - before[3]));
          ofPoint[d] = std::max(ofPoint[d],
            Norm(std::array<double, 3>{ point[0] - before[0], point[1] - before[1], point[2] - before[2] }));
        }
      }
    }
  }
  // A derivative is p times a sum of steps with polynomials of degree p - 1; a single polynomial has two
  // steps of 1. R_s = (B_s - B w_s / w) / w and Ss = ((w S)_s - w_s S) / w, where |S| is at most the patch's
  // radius times the sum of all |R|.
  double ofBasis[2];
  double ofSurface[2];
  for (int d = 0; d < 2; ++d)
  {
    const double factor = patch.Degree[d] * growth / weight;
    ofBasis[d] = factor * (2.0 + growth * ofWeight[d] / weight);
    ofSurface[d] = factor * (ofPoint[d] + bounds.Speed * patch.Radius * ofWeight[d]);
  }
  return ofBasis[0] * ofSurface[1] + ofBasis[1] * ofSurface[0];
}

double GetUnknown(double bound)
{
  return std::isfinite(bound) ? bound : std::numeric_limits<double>::quiet_NaN();
}
}

FaceStrips FaceStrips::Make(const CutFace& face, double tolerance)
{
  FaceStrips strips;
  const FacePanels& panels = face.Panels;
  strips.Ribbons = BoundStrips(*face.Source, panels, { 0.0, 0.0, 0.0 }, tolerance);
  std::size_t coedges = 0;
  for (const Loop& loop : face.Source->Loops)
  {
    coedges += loop.Coedges.size();
  }
  strips.Coedges.assign(coedges, 0.0);
  for (std::size_t i = 0; i < panels.Ribbons.size(); ++i)
  {
    const Ribbon& ribbon = panels.Ribbons[i];
    (ribbon.Coedge >= 0 ? strips.Coedges[ribbon.Coedge] : strips.Corners) += strips.Ribbons[i].Area;
    for (int k = 0; k <= ribbon.EdgeDegree; ++k)
    {
      strips.Reach = std::max(strips.Reach, Norm(panels.Coefficients.data() + ribbon.Edge + 3 * k));
    }
  }
  for (const Patch& patch : panels.Patches)
  {
    strips.Reach = std::max(strips.Reach, Norm(patch.Center) + patch.Radius);
  }
  strips.Reach += panels.Outside.Distance;
  for (const Cap& cap : panels.Caps)
  {
    strips.Corners += 0.5 * Norm(Subtract(cap.From, cap.Apex)) * Norm(Subtract(cap.To, cap.Apex));
    strips.Reach = std::max({ strips.Reach, Norm(cap.Apex), Norm(cap.From), Norm(cap.To) });
  }
  return strips;
}

FaceStrips FaceStrips::MakeWithout(const CutFace& face)
{
  FaceStrips strips;
  strips.Ribbons.resize(face.Panels.Ribbons.size());
  std::size_t coedges = 0;
  for (const Loop& loop : face.Source->Loops)
  {
    coedges += loop.Coedges.size();
  }
  strips.Coedges.assign(coedges, 0.0);
  for (const Patch& patch : face.Panels.Patches)
  {
    strips.Reach = std::max(strips.Reach, Norm(patch.Center) + patch.Radius);
  }
  return strips;
}

void BodyStrips::Add(const Face& face, const FaceStrips& strips)
{
  const std::size_t index = this->Corners.size();
  this->Corners.push_back(strips.Corners);
  int coedge = 0;
  for (const Loop& loop : face.Loops)
  {
    for (const Coedge& use : loop.Coedges)
    {
      this->Edges[use.Use.get()].push_back({ index, coedge, strips.Coedges[coedge] });
      ++coedge;
      for (const std::array<double, 3>& vertex : { use.Use->StartVertex, use.Use->EndVertex })
      {
        std::vector<std::size_t>& faces = this->Vertices[vertex];
        if (faces.empty() || faces.back() != index)
        {
          faces.push_back(index);
        }
      }
    }
  }
}

NetGradientPlan PlanNetGradient(const NetGradientTask& task)
{
  const FacePanels& panels = task.Cut->Panels;
  const NURBSSurface& surface = task.Cut->Source->Surface;
  PlanRequest request;
  request.Classes = GetClasses();
  double heaviest = 0.0;
  for (const std::array<double, 4>& point : surface.ControlPoints)
  {
    heaviest = std::max(heaviest, point[3]);
  }
  const double spans = (surface.Degree[0] + 1.0) * (surface.Degree[1] + 1.0);
  for (const BoundClass& c : request.Classes)
  {
    const int power = c.Degree +
      (c.Kind == BoundClass::FluxBasis      ? 1
          : c.Kind == BoundClass::AreaBasis ? -1
                                            : 0);
    request.Tolerances.push_back(task.Tolerance / (heaviest * spans) * std::pow(task.Length, power));
  }
  NetGradientPlan plan;
  plan.Plans = PlanPatches(panels, request);
  for (std::uint32_t k = 0; k < panels.Patches.size(); ++k)
  {
    if (!plan.Plans[k].Items.empty())
    {
      plan.Patches.push_back({ &panels, k, &plan.Plans[k], request.Shift, surface.Rounding });
    }
  }
  return plan;
}

NetGradient FinishNetGradient(
  const NetGradientTask& task, const NetGradientPlan& plan, const PatchSums* allSums)
{
  const Face& face = *task.Cut->Source;
  const FacePanels& panels = task.Cut->Panels;
  const NURBSSurface& surface = face.Surface;
  NetGradient result;
  std::copy_n(surface.NumberOfControlPoints, 2, result.Count);
  std::vector<Entry> entries(surface.ControlPoints.size());
  std::vector<const Edge*> edges;
  std::vector<const Coedge*> coedges;
  for (const Loop& loop : face.Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      edges.push_back(coedge.Use.get());
      coedges.push_back(&coedge);
    }
  }

  for (std::size_t n = 0; n < plan.Patches.size(); ++n)
  {
    const std::uint32_t k = plan.Patches[n].Index;
    const std::vector<double>& quadrature = plan.Plans[k].QuadratureBound;
    const PatchSums& sums = allSums[n];
    const Patch& patch = panels.Patches[k];
    result.Evaluations += sums.Evaluations;
    const double strips = GetStripArea(task, k, edges);
    const double moving = strips > 0.0 ? strips * WeightBounds(panels, patch, sums.Growth).Speed : 0.0;
    const SweptParameters swept = GetSweptParameters(panels, k, coedges, patch.Exchanged);
    const double ofSwept =
      swept.Area > 0.0 ? swept.Area * GetAreaSlope(panels, patch, swept.Growth * sums.Growth) : 0.0;
    double ofArea[2];
    for (int c = 0; c < 2; ++c)
    {
      ofArea[c] = UnitRoundoff * sums.AreaNoise[c] +
        (ofSwept > 0.0 ? ofSwept * (c == 0 ? 1.0 : 3.0 * task.Reach) : 0.0);
    }
    const int directions[2] = { patch.Exchanged ? 1 : 0, patch.Exchanged ? 0 : 1 };
    const Extraction inS(
      surface.Knots[directions[0]], patch.Degree[0], patch.Start[0], patch.Start[0] + patch.Width[0]);
    const Extraction inR(
      surface.Knots[directions[1]], patch.Degree[1], patch.Start[1], patch.Start[1] + patch.Width[1]);
    for (int j = 0; j <= patch.Degree[1]; ++j)
    {
      for (int i = 0; i <= patch.Degree[0]; ++i)
      {
        const int place[2] = { inS.GetFirst() + i, inR.GetFirst() + j };
        Entry& entry = entries[static_cast<std::size_t>(place[directions[0]]) +
          static_cast<std::size_t>(surface.NumberOfControlPoints[0]) * place[directions[1]]];
        for (int l = 0; l <= patch.Degree[1]; ++l)
        {
          for (int m = 0; m <= patch.Degree[0]; ++m)
          {
            const Wide factor = inS.Get(m, i) * inR.Get(l, j);
            const double* from = sums.Get(m, l);
            for (int c = 0; factor != 0 && c < channel::Count; ++c)
            {
              entry.Sums[c] += factor * from[c];
            }
          }
        }
        for (std::size_t c = 0; c < quadrature.size(); ++c)
        {
          entry.Quadrature[c] += quadrature[c];
        }
        entry.Quadrature[6] += ofArea[0];
        entry.Quadrature[7] += ofArea[1];
        entry.Strips += moving;
      }
    }
  }

  result.Values.resize(4 * NumberOfIntegrals * entries.size());
  result.Bounds.resize(result.Values.size());
  for (int i = 0; i < result.Count[0]; ++i)
  {
    for (int j = 0; j < result.Count[1]; ++j)
    {
      const std::size_t at = i + static_cast<std::size_t>(result.Count[0]) * j;
      const Entry& entry = entries[at];
      const std::array<double, 4>& point = surface.ControlPoints[at];
      const double weight = point[3];
      const double position[3] = { point[0] / weight, point[1] / weight, point[2] / weight };
      const double distance = Norm(position);
      for (int g = 0; g < NumberOfMoments; ++g)
      {
        const int degree = MomentDegrees[g];
        const double noise = UnitRoundoff * static_cast<double>(entry.Sums[channel::Noise + degree]);
        const double ofNormal = entry.Quadrature[degree] + noise;
        const double moving = entry.Strips > 0.0 ? entry.Strips * std::pow(task.Reach, degree) : 0.0;
        Wide along = 0;
        double size = 0.0;
        for (int c = 0; c < 3; ++c)
        {
          const Wide sum = entry.Sums[4 * g + c];
          const double value = static_cast<double>(weight * sum);
          result.Values[result.GetIndex(i, j, c) + g] = value;
          result.Bounds[result.GetIndex(i, j, c) + g] =
            GetUnknown(BoundGrowth * (weight * ofNormal + moving) + FinalRoundings * std::abs(value));
          along += position[c] * sum;
          size += static_cast<double>(std::abs(position[c] * sum));
        }
        const Wide flux = entry.Sums[4 * g + channel::Flux];
        size += static_cast<double>(std::abs(flux));
        result.Values[result.GetIndex(i, j, 3) + g] = static_cast<double>(along - flux);
        // With a weight the surface moves by R (P - x) / w.
        result.Bounds[result.GetIndex(i, j, 3) + g] = GetUnknown(BoundGrowth *
            ((std::abs(position[0]) + std::abs(position[1]) + std::abs(position[2])) * ofNormal +
              entry.Quadrature[3 + degree] +
              UnitRoundoff * static_cast<double>(entry.Sums[channel::Noise + degree + 1]) +
              moving * (distance + task.Reach) / weight) +
          FinalRoundings * size);
      }
      // The area, with trim curves that stay in (u,v).
      Wide along = -entry.Sums[channel::Area + 3];
      double size = static_cast<double>(std::abs(entry.Sums[channel::Area + 3]));
      for (int c = 0; c < 3; ++c)
      {
        const Wide sum = entry.Sums[channel::Area + c];
        const double value = static_cast<double>(weight * sum);
        result.Values[result.GetIndex(i, j, c) + NumberOfMoments] = value;
        result.Bounds[result.GetIndex(i, j, c) + NumberOfMoments] =
          GetUnknown(BoundGrowth * weight * entry.Quadrature[6] + FinalRoundings * std::abs(value));
        along += position[c] * sum;
        size += static_cast<double>(std::abs(position[c] * sum));
      }
      result.Values[result.GetIndex(i, j, 3) + NumberOfMoments] = static_cast<double>(along);
      result.Bounds[result.GetIndex(i, j, 3) + NumberOfMoments] = GetUnknown(BoundGrowth *
          ((std::abs(position[0]) + std::abs(position[1]) + std::abs(position[2])) * entry.Quadrature[6] +
            entry.Quadrature[7]) +
        FinalRoundings * size);
    }
  }
  return result;
}
}
