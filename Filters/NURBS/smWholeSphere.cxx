#include "smWholeSphere.h"

#include "smBernstein.h"
#include "smBernsteinNet.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Largest distance of a surface from its sphere, and of points that are one, relative to the radius.
constexpr double MaxError = 1e-10;
/// Largest distance of a trim curve from the border of the domain, and of the region within the loops from
/// the domain, relative to the domain.
constexpr double BorderShare = 1e-9;
/// Largest error of the area without its bound, and of the area and the volume, relative to those of the
/// sphere.
constexpr double MaxAreaError = 1e-3;
constexpr double MaxMismatch = 0.25;
/// The square of a patch has twice its degree.
constexpr int MaxDegree = MaximumDegree / 2;

using Parameters = std::array<double, 2>;

/// Returns control point k of the border at the start or end of direction d.
const Homogeneous& GetBorderPoint(const NURBSSurface& surface, int d, bool atEnd, int k)
{
  const int across = atEnd ? surface.NumberOfControlPoints[d] - 1 : 0;
  const int i = d == 0 ? across : k;
  const int j = d == 0 ? k : across;
  return surface.ControlPoints[i + static_cast<std::size_t>(j) * surface.NumberOfControlPoints[0]];
}

/// Returns true if the knots of a direction are clamped, so that its borders have the first and last control
/// points.
bool IsClamped(const NURBSSurface& surface, int d)
{
  const std::vector<double>& knots = surface.Knots[d];
  return knots.front() == surface.GetDomainStart(d) && knots.back() == surface.GetDomainEnd(d);
}

bool IsOnePoint(const NURBSSurface& surface, int d, bool atEnd, double slack)
{
  const Vector3 first = Project(GetBorderPoint(surface, d, atEnd, 0));
  for (int k = 1; k < surface.NumberOfControlPoints[1 - d]; ++k)
  {
    if (!(Norm(Subtract(Project(GetBorderPoint(surface, d, atEnd, k)), first)) <= slack))
    {
      return false;
    }
  }
  return true;
}

bool IsClosed(const NURBSSurface& surface, int d, double slack)
{
  for (int k = 0; k < surface.NumberOfControlPoints[1 - d]; ++k)
  {
    const Homogeneous& first = GetBorderPoint(surface, d, false, k);
    const Homogeneous& last = GetBorderPoint(surface, d, true, k);
    if (!(Norm(Subtract(Project(first), Project(last))) <= slack) ||
      !(std::abs(first[3] - last[3]) <= MaxError * first[3]))
    {
      return false;
    }
  }
  return true;
}

/// Returns a bound of the distance of a patch from the sphere.
double BoundDistance(const BernsteinNet& net, const Vector3& center, double radius)
{
  const int p = net.P;
  const int q = net.Q;
  double lightest = HUGE_VAL;
  BernsteinNet centered = net;
  for (Homogeneous& h : centered.B)
  {
    lightest = std::min(lightest, h[3]);
    for (int d = 0; d < 3; ++d)
    {
      h[d] -= center[d] * h[3];
    }
  }
  double largest = 0.0;
  for (int m = 0; m <= 2 * q; ++m)
  {
    for (int l = 0; l <= 2 * p; ++l)
    {
      double sum = 0.0;
      for (int j = std::max(0, m - q); j <= std::min(q, m); ++j)
      {
        for (int i = std::max(0, l - p); i <= std::min(p, l); ++i)
        {
          const Homogeneous& a = centered.At(i, j);
          const Homogeneous& b = centered.At(l - i, m - j);
          sum += Binomials[p][i] * Binomials[p][l - i] * Binomials[q][j] * Binomials[q][m - j] *
            (Dot(a.data(), b.data()) - radius * radius * a[3] * b[3]);
        }
      }
      largest = std::max(largest, std::abs(sum) / (Binomials[2 * p][l] * Binomials[2 * q][m]));
    }
  }
  return lightest > 0.0 ? largest / (lightest * lightest * radius) : HUGE_VAL;
}

/// Returns a bound of the distance of the surface from the sphere, or one above `limit`.
double BoundDistance(const NURBSSurface& surface, const Vector3& center, double radius, double limit)
{
  const std::vector<double> u = surface.GetSpanBreaks(0);
  const std::vector<double> v = surface.GetSpanBreaks(1);
  BernsteinNet net;
  net.Resize(surface.Degree[0], surface.Degree[1]);
  double bound = 0.0;
  for (std::size_t b = 0; b + 1 < v.size() && bound <= limit; ++b)
  {
    for (std::size_t a = 0; a + 1 < u.size() && bound <= limit; ++a)
    {
      const std::array<double, 3> rounding =
        surface.ExtractBezier(u[a], u[a + 1], v[b], v[b + 1], net.B.data());
      bound = std::max(bound, BoundDistance(net, center, radius) + Norm(rounding));
    }
  }
  return bound;
}

/// Returns true if the loops run along the borders of the domain, around it once.
bool CoversDomain(const Face& face)
{
  if (face.Loops.empty())
  {
    return true;
  }
  Parameters low;
  Parameters size;
  for (int d = 0; d < 2; ++d)
  {
    low[d] = face.Surface.GetDomainStart(d);
    size[d] = face.Surface.GetDomainEnd(d) - low[d];
  }
  double twiceArea = 0.0;
  for (const Loop& loop : face.Loops)
  {
    Parameters before{};
    bool isFirst = true;
    Parameters first{};
    for (const Coedge& coedge : loop.Coedges)
    {
      if (coedge.Curve.GetNumberOfPieces() == 0)
      {
        return false;
      }
      bool isOnLine[4] = { true, true, true, true };
      for (const Parameters& c : coedge.Curve.Coefficients)
      {
        for (int d = 0; d < 2; ++d)
        {
          const double x = (c[d] - low[d]) / size[d];
          isOnLine[2 * d] = isOnLine[2 * d] && std::abs(x) <= BorderShare;
          isOnLine[2 * d + 1] = isOnLine[2 * d + 1] && std::abs(x - 1.0) <= BorderShare;
        }
      }
      if (std::none_of(isOnLine, isOnLine + 4, [](bool is) { return is; }))
      {
        return false;
      }
      const Parameters* ends[2] = { &coedge.Curve.GetStartPoint(), &coedge.Curve.GetEndPoint() };
      if (coedge.Reversed)
      {
        std::swap(ends[0], ends[1]);
      }
      for (const Parameters* end : ends)
      {
        const Parameters at{ ((*end)[0] - low[0]) / size[0], ((*end)[1] - low[1]) / size[1] };
        twiceArea += isFirst ? 0.0 : before[0] * at[1] - before[1] * at[0];
        first = isFirst ? at : first;
        before = at;
        isFirst = false;
      }
    }
    twiceArea += before[0] * first[1] - before[1] * first[0];
    // A loop that leaves a border without a coedge would cross the domain.
    for (std::size_t i = 0; i < loop.Coedges.size(); ++i)
    {
      const Coedge& a = loop.Coedges[i];
      const Coedge& b = loop.Coedges[(i + 1) % loop.Coedges.size()];
      const Parameters& end = a.Reversed ? a.Curve.GetStartPoint() : a.Curve.GetEndPoint();
      const Parameters& start = b.Reversed ? b.Curve.GetEndPoint() : b.Curve.GetStartPoint();
      for (int d = 0; d < 2; ++d)
      {
        if (!(std::abs(end[d] - start[d]) <= BorderShare * size[d]))
        {
          return false;
        }
      }
    }
  }
  return std::abs(0.5 * twiceArea - 1.0) <= 8.0 * BorderShare;
}

/// Returns parameters that divide every span of a direction equally, into at least `steps` in all.
std::vector<double> DivideSpans(const NURBSSurface& surface, int d, int steps)
{
  const std::vector<double> breaks = surface.GetSpanBreaks(d);
  const auto spans = static_cast<int>(breaks.size()) - 1;
  const int parts = std::max(1, (steps + spans - 1) / spans);
  std::vector<double> at;
  for (int s = 0; s < spans; ++s)
  {
    for (int k = 0; k < parts; ++k)
    {
      const double share = static_cast<double>(k) / parts;
      at.push_back((1.0 - share) * breaks[s] + share * breaks[s + 1]);
    }
  }
  at.push_back(breaks.back());
  return at;
}
}

double WholeSphere::GetArea() const
{
  return 4.0 * vtkMath::Pi() * this->Radius * this->Radius;
}

double WholeSphere::GetSignedVolume() const
{
  return (this->Inward ? -1.0 : 1.0) * this->GetArea() * this->Radius / 3.0;
}

WholeSphere FindWholeSphere(const Face& face)
{
  const NURBSSurface& surface = face.Surface;
  const auto [lowest, highest] = std::minmax(surface.Degree[0], surface.Degree[1]);
  if (!surface.Rational || lowest < 2 || highest > MaxDegree || !IsClamped(surface, 0) ||
    !IsClamped(surface, 1))
  {
    return {};
  }
  for (int d = 1; d >= 0; --d)
  {
    const Vector3 poles[2] = { Project(GetBorderPoint(surface, d, false, 0)),
      Project(GetBorderPoint(surface, d, true, 0)) };
    WholeSphere sphere;
    sphere.PoleDirection = d;
    sphere.Radius = 0.5 * Norm(Subtract(poles[0], poles[1]));
    for (int c = 0; c < 3; ++c)
    {
      sphere.Center[c] = 0.5 * (poles[0][c] + poles[1][c]);
    }
    const double slack = MaxError * sphere.Radius;
    if (!(sphere.Radius > 0.0) || !IsOnePoint(surface, d, false, slack) ||
      !IsOnePoint(surface, d, true, slack) || !IsClosed(surface, 1 - d, slack) || !CoversDomain(face))
    {
      continue;
    }
    sphere.Error = BoundDistance(surface, sphere.Center, sphere.Radius, slack);
    if (!(sphere.Error <= slack))
    {
      continue;
    }
    Parameters middle;
    for (int k = 0; k < 2; ++k)
    {
      middle[k] = 0.5 * (surface.GetDomainStart(k) + surface.GetDomainEnd(k));
    }
    Vector3 position;
    Vector3 du;
    Vector3 dv;
    surface.Evaluate(middle[0], middle[1], position.data(), du.data(), dv.data());
    sphere.Inward = (Dot(Cross(du, dv), Subtract(position, sphere.Center)) < 0.0) != face.Reversed;
    return sphere;
  }
  return {};
}

std::vector<WholeSphere> FindWholeSpheres(const std::vector<FacePointer>& faces)
{
  std::vector<WholeSphere> spheres;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const WholeSphere sphere = FindWholeSphere(*faces[f]);
    if (sphere)
    {
      spheres.resize(faces.size());
      spheres[f] = sphere;
    }
  }
  return spheres;
}

bool Covers(const WholeSphere& sphere, double area, double areaBound, double volume)
{
  const double whole = sphere.GetArea();
  return std::abs(area - whole) <= std::min(MaxAreaError * whole + areaBound, MaxMismatch * whole) &&
    std::abs(std::abs(volume / sphere.GetSignedVolume()) - 1.0) <= MaxMismatch;
}

SphereGrid MakeSphereGrid(const Face& face, const WholeSphere& sphere, int steps)
{
  const int d = sphere.PoleDirection;
  std::vector<double> at[2];
  at[d] = DivideSpans(face.Surface, d, (steps + 1) / 2);
  at[1 - d] = DivideSpans(face.Surface, 1 - d, steps);
  const auto columns = static_cast<int>(at[0].size());
  const auto rows = static_cast<int>(at[1].size());
  SphereGrid grid;
  NURBSSurface::Walker walker(face.Surface);
  for (const double v : at[1])
  {
    for (const double u : at[0])
    {
      Vector3 position;
      walker.Evaluate(u, v, position.data());
      grid.Parameters.push_back({ u, v });
      grid.Points.push_back(position);
      Vector3 normal = Normalized(Subtract(position, sphere.Center));
      for (double& x : normal)
      {
        x = sphere.Inward ? -x : x;
      }
      grid.Normals.push_back(normal);
    }
  }
  double nearest = sphere.Radius;
  double longest = 0.0;
  const auto add = [&](int a, int b, int c)
  {
    const Vector3 ab = Subtract(grid.Points[b], grid.Points[a]);
    const Vector3 ac = Subtract(grid.Points[c], grid.Points[a]);
    const Vector3 normal = Cross(ab, ac);
    const Vector3 from = Subtract(grid.Points[a], sphere.Center);
    nearest = std::min(nearest, std::abs(Dot(from, normal)) / Norm(normal));
    longest = std::max({ longest, Norm(ab), Norm(ac), Norm(Subtract(ac, ab)) });
    const bool isOutward = Dot(from, normal) > 0.0;
    grid.Triangles.push_back(
      isOutward != sphere.Inward ? std::array<int, 3>{ a, b, c } : std::array<int, 3>{ a, c, b });
  };
  for (int j = 0; j + 1 < rows; ++j)
  {
    for (int i = 0; i + 1 < columns; ++i)
    {
      const int corner = i + j * columns;
      const int step = d == 1 ? j : i;
      const int last = (d == 1 ? rows : columns) - 2;
      // Corners 0 1 / 2 3 of a cell; at a pole, two of them are one point.
      const int c[4] = { corner, corner + 1, corner + columns, corner + columns + 1 };
      const int far = d == 1 ? 1 : 2;
      if (step > 0)
      {
        add(c[0], c[far], c[3 - far]);
      }
      if (step < last)
      {
        add(c[far], c[3], c[3 - far]);
      }
    }
  }
  // Corners are on the sphere, so that triangles are within it and outside of the one that their planes
  // touch; and a spherical triangle is nowhere wider than its longest side.
  grid.Deviation = sphere.Radius - nearest + 2.0 * sphere.Error;
  grid.NormalTurn = 2.0 * std::asin(std::min(1.0, 0.5 * longest / sphere.Radius)) + 1e-9;
  return grid;
}
}
