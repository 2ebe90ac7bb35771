#include "Detail/smSubPatches.h"

#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>

namespace sm
{
namespace
{
using Homogeneous = std::array<double, 4>;

// Number of points of a rise that are compared with the surface's domain: its ends, where v is extreme, and
// points between.
constexpr int PointsOfRise = 5;

// Tolerance of planarity relative to the size of the coordinates. The corners of a plane were rounded at
// their position in the file, which may be far from the model's origin. The volume error of treating a
// surface as a plane is less than this tolerance times size times area.
constexpr double PlanarGap = 1e-12;

std::vector<double> DivideIntervals(const std::vector<double>& breaks, int factor)
{
  std::vector<double> borders;
  borders.reserve((breaks.size() - 1) * factor + 1);
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
  {
    for (int k = 0; k < factor; ++k)
    {
      borders.push_back(k == 0 ? breaks[i] : breaks[i] + (breaks[i + 1] - breaks[i]) * k / factor);
    }
  }
  borders.push_back(breaks.back());
  return borders;
}

/// Checks the requirements on a face and the options. Throws std::runtime_error with the reason.
void CheckFace(const Face& face, const SchemeOptions& options)
{
  const std::string reason = face.Surface.Check();
  if (!reason.empty())
  {
    throw std::runtime_error(reason);
  }
  for (const std::vector<double>& knots : face.Surface.Knots)
  {
    if (!std::all_of(knots.begin(), knots.end(), [](double knot) { return std::isfinite(knot); }))
    {
      throw std::runtime_error("a knot is not finite");
    }
  }
  if (options.Factor < 1 || options.TextureFactor < 1)
  {
    throw std::runtime_error("the factors of sub-patches and of the trim texture must be at least 1");
  }
  for (const Loop& loop : face.Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      if (coedge.Curve.GetNumberOfPieces() == 0)
      {
        throw std::runtime_error("a coedge has no trim curve");
      }
      for (int k = 0; k < coedge.Curve.GetNumberOfPieces(); ++k)
      {
        if (coedge.Curve.GetDegree(k) > MaximumDegree)
        {
          throw std::runtime_error("a trim curve has a degree above " + std::to_string(MaximumDegree));
        }
      }
      for (const Point2& point : coedge.Curve.Coefficients)
      {
        if (!std::isfinite(point[0]) || !std::isfinite(point[1]))
        {
          throw std::runtime_error("a trim curve is not finite");
        }
      }
    }
  }
}

void AddPatch(SubPatchFace& face, double u0, double u1, double v0, double v1)
{
  const NURBSSurface& surface = face.Source->Surface;
  Patch patch{};
  patch.FirstPoint = static_cast<std::uint32_t>(face.Points.size());
  patch.Degree[0] = surface.Degree[0];
  patch.Degree[1] = surface.Degree[1];
  patch.Start[0] = u0;
  patch.Start[1] = v0;
  patch.Width[0] = u1 - u0;
  patch.Width[1] = v1 - v0;
  const std::size_t count = static_cast<std::size_t>(patch.Degree[0] + 1) * (patch.Degree[1] + 1);
  face.Points.resize(face.Points.size() + count);
  Homogeneous* points = face.Points.data() + patch.FirstPoint;
  surface.ExtractBezier(u0, u1, v0, v1, points);
  for (int c = 0; c < 3; ++c)
  {
    const auto less = [c](const Homogeneous& a, const Homogeneous& b) { return a[c] / a[3] < b[c] / b[3]; };
    const auto ends = std::minmax_element(points, points + count, less);
    patch.Center[c] = 0.5 * ((*ends.first)[c] / (*ends.first)[3] + (*ends.second)[c] / (*ends.second)[3]);
    for (std::size_t i = 0; i < count; ++i)
    {
      points[i][c] -= patch.Center[c] * points[i][3];
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const Homogeneous& p = points[i];
    patch.Radius = std::max(patch.Radius, Norm(p.data()) / p[3]);
  }
  face.Patches.push_back(patch);
}

/// Returns the approximate distance, a length, by which the trim curves leave the surface's domain, by the
/// size of the adjacent patch.
double MeasureOutside(const SubPatchFace& face)
{
  const std::vector<double>* const borders[2] = { &face.Grid.U, &face.Grid.V };
  const std::size_t columns = static_cast<std::size_t>(face.Grid.GetNumberOfColumns()) / face.Grid.Factor;
  double outside = 0.0;
  for (const TrimRise& rise : face.Rises)
  {
    const BernsteinPiece<2> piece{ rise.data(), static_cast<int>(rise.size()) - 1 };
    for (int i = 0; i < PointsOfRise; ++i)
    {
      const Point2 point = piece.Evaluate(static_cast<double>(i) / (PointsOfRise - 1));
      std::size_t span[2];
      Point2 beyond;
      for (int d = 0; d < 2; ++d)
      {
        const std::vector<double>& x = *borders[d];
        const auto after = std::upper_bound(x.begin() + 1, x.end() - 1, point[d]);
        span[d] = static_cast<std::size_t>(after - x.begin() - 1) / face.Grid.Factor;
        beyond[d] = std::max({ x.front() - point[d], point[d] - x.back(), 0.0 });
      }
      const Patch& patch = face.Patches[span[0] + columns * span[1]];
      for (int d = 0; d < 2; ++d)
      {
        outside = std::max(outside, 2.0 * patch.Radius * beyond[d] / patch.Width[d]);
      }
    }
  }
  return outside;
}

void PreparePlane(SubPatchFace& face, const SchemeOptions& options)
{
  face.Planar = true;
  if (face.Source->Loops.empty())
  {
    return;
  }
  if (!(options.ChordTolerance > 0.0))
  {
    throw std::runtime_error("the chord tolerance of planes must be positive");
  }
  const NURBSSurface& surface = face.Source->Surface;
  double position[3];
  double du[3];
  double dv[3];
  surface.Evaluate(surface.GetDomainStart(0), surface.GetDomainStart(1), position, du, dv);
  const auto shareOf = [&options](const double(&d)[3])
  {
    const double length = Norm(d);
    return 0.5 * options.ChordTolerance / std::max(length, 1e-300);
  };
  // |S(c) - S(chord)| <= |du| |Su| + |dv| |Sv|, and the derivatives are constant.
  face.Polygons = FlattenLoops(*face.Source, Point2{ shareOf(du), shareOf(dv) });
}

void PrepareCurved(SubPatchFace& face, const SchemeOptions& options)
{
  const NURBSSurface& surface = face.Source->Surface;
  const std::vector<double> breaks[2] = { surface.GetSpanBreaks(0), surface.GetSpanBreaks(1) };
  const double count =
    static_cast<double>(breaks[0].size() - 1) * (breaks[1].size() - 1) * options.Factor * options.Factor;
  if (count > MaximumSubPatches)
  {
    throw std::runtime_error(std::to_string(static_cast<long long>(std::min(count, 1e18))) +
      " sub-patches are more than " + std::to_string(MaximumSubPatches));
  }
  face.Grid = MakeSubPatchGrid(surface, options.Factor);
  for (std::size_t row = 0; row + 1 < breaks[1].size(); ++row)
  {
    for (std::size_t column = 0; column + 1 < breaks[0].size(); ++column)
    {
      AddPatch(face, breaks[0][column], breaks[0][column + 1], breaks[1][row], breaks[1][row + 1]);
    }
  }
  face.Deviations.assign(static_cast<std::size_t>(count), 0.0);
  face.Rises = CutIntoRises(*face.Source);
  face.Outside = MeasureOutside(face);
}
}

SubPatchGrid MakeSubPatchGrid(const NURBSSurface& surface, int factor)
{
  SubPatchGrid grid;
  grid.Factor = std::max(factor, 1);
  grid.U = DivideIntervals(surface.GetSpanBreaks(0), grid.Factor);
  grid.V = DivideIntervals(surface.GetSpanBreaks(1), grid.Factor);
  return grid;
}

bool IsPlanar(const NURBSSurface& surface)
{
  if (surface.Degree[0] != 1 || surface.Degree[1] != 1 || surface.NumberOfControlPoints[0] != 2 ||
    surface.NumberOfControlPoints[1] != 2)
  {
    return false;
  }
  const Homogeneous* p = surface.ControlPoints.data();
  const double w = p[0][3];
  double size = 0.0;
  double gap = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    gap = std::max(gap, std::abs((p[0][c] - p[1][c]) - (p[2][c] - p[3][c])));
    for (int i = 0; i < 4; ++i)
    {
      size = std::max(size, std::abs(p[i][c]));
    }
  }
  return p[1][3] == w && p[2][3] == w && p[3][3] == w && gap <= PlanarGap * size;
}

SubPatchFace PrepareSubPatchShape(const FacePointer& face, const SchemeOptions& options)
{
  SubPatchFace result;
  std::string reason;
  try
  {
    if (!face)
    {
      throw std::runtime_error("there is no face");
    }
    result.Source = face;
    CheckFace(*face, options);
    if (IsPlanar(face->Surface))
    {
      PreparePlane(result, options);
    }
    else
    {
      PrepareCurved(result, options);
    }
    return result;
  }
  catch (const std::bad_alloc&)
  {
    throw; // a fault of the machine, not of the face
  }
  catch (const std::exception& error)
  {
    reason = error.what();
  }
  SubPatchFace failed;
  failed.Source = face;
  failed.Error = (face ? "face #" + std::to_string(face->FileId) + ": " : std::string()) + reason;
  return failed;
}

void ComputeDeviations(SubPatchFace& face, DeviationMode mode, std::size_t begin, std::size_t end)
{
  const std::size_t columns = static_cast<std::size_t>(face.Grid.GetNumberOfColumns());
  for (std::size_t i = begin; i < end; ++i)
  {
    const std::size_t column = i % columns;
    const std::size_t row = i / columns;
    face.Deviations[i] = ComputeDeviation(face.Source->Surface, face.Grid.U[column], face.Grid.U[column + 1],
      face.Grid.V[row], face.Grid.V[row + 1], mode);
  }
}

SubPatchFace PrepareSubPatchFace(const FacePointer& face, const SchemeOptions& options)
{
  SubPatchFace result = PrepareSubPatchShape(face, options);
  ComputeDeviations(result, options.Deviation, 0, result.Deviations.size());
  return result;
}
}
