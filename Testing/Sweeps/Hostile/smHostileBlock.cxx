#include "smHostileBlock.h"

#include <algorithm>
#include <cmath>

namespace smhostile
{
namespace
{
__extension__ typedef __float128 Quad;
using QuadPoint = std::array<Quad, 4>;

RealPoint ToReal(const std::array<double, 4>& p)
{
  return { p[0], p[1], p[2], p[3] };
}

bool IsDouble(Quad x)
{
  const Quad rest = x - static_cast<Quad>(static_cast<double>(x));
  const Quad size = x < 0 ? -x : x;
  return (rest < 0 ? -rest : rest) <= size * static_cast<Quad>(1e-28);
}

std::size_t IndexOf(const BlockPoints& points, const int at[3])
{
  return at[0] +
    static_cast<std::size_t>(points.Degree[0] + 1) *
    (at[1] + static_cast<std::size_t>(points.Degree[1] + 1) * at[2]);
}

/// The two directions other than d, ascending.
void GetOthers(int d, int others[2])
{
  others[0] = d == 0 ? 1 : 0;
  others[1] = d == 2 ? 1 : 2;
}

bool SamePosition(const RealPoint& a, const RealPoint& b)
{
  return a[0] * b[3] == b[0] * a[3] && a[1] * b[3] == b[1] * a[3] && a[2] * b[3] == b[2] * a[3];
}

/// Rail along direction d where the other two are at the sides given by two bits.
int RailIndex(int d, int firstSide, int secondSide)
{
  return 4 * d + firstSide + 2 * secondSide;
}

void BuildRails(const BlockPoints& points, Shape& shape, int alias[12])
{
  int vertexAlias[8];
  RealPoint corners[8];
  for (int v = 0; v < 8; ++v)
  {
    const int at[3] = { (v & 1) * points.Degree[0], (v >> 1 & 1) * points.Degree[1],
      (v >> 2) * points.Degree[2] };
    corners[v] = ToReal(points.Homogeneous[IndexOf(points, at)]);
    vertexAlias[v] = v;
    for (int w = 0; w < v && vertexAlias[v] == v; ++w)
    {
      vertexAlias[v] = SamePosition(corners[v], corners[w]) ? w : v;
    }
    shape.Vertices.push_back({ static_cast<double>(corners[v][0] / corners[v][3]),
      static_cast<double>(corners[v][1] / corners[v][3]),
      static_cast<double>(corners[v][2] / corners[v][3]) });
  }
  for (int r = 0; r < 12; ++r)
  {
    const int d = r / 4;
    int others[2];
    GetOthers(d, others);
    int at[3];
    at[others[0]] = (r & 1) * points.Degree[others[0]];
    at[others[1]] = (r >> 1 & 1) * points.Degree[others[1]];
    Rail rail;
    rail.Pieces.resize(1);
    for (at[d] = 0; at[d] <= points.Degree[d]; ++at[d])
    {
      rail.Pieces[0].push_back(ToReal(points.Homogeneous[IndexOf(points, at)]));
    }
    const std::vector<RealPoint>& own = rail.Pieces[0];
    rail.Degenerate =
      std::all_of(own.begin(), own.end(), [&own](const RealPoint& p) { return SamePosition(p, own[0]); });
    const int start = ((r & 1) << others[0]) | ((r >> 1 & 1) << others[1]);
    rail.StartVertex = vertexAlias[start];
    rail.EndVertex = vertexAlias[start | 1 << d];
    alias[r] = r;
    for (int other = 4 * d; other < r && alias[r] == r; ++other)
    {
      const std::vector<RealPoint>& theirs = shape.Rails[other].Pieces[0];
      if (!rail.Degenerate && std::equal(own.begin(), own.end(), theirs.begin(), theirs.end(), SamePosition))
      {
        alias[r] = alias[other];
      }
    }
    shape.Rails.push_back(rail);
  }
}
}

void BuildBlock(const BlockPoints& points, Random& random, Shape& shape)
{
  int alias[12];
  BuildRails(points, shape, alias);
  shape.Block = points.Truth;
  const ReferenceBlock& truth = points.Truth;
  for (int f = 0; f < 6; ++f)
  {
    if (points.Omitted[f])
    {
      continue;
    }
    const int d = f / 2;
    const int side = f % 2;
    int others[2];
    GetOthers(d, others);
    Sheet sheet;
    ReferencePatch patch;
    // d/d(first) x d/d(second) points along +d for d = 0 and 2, along -d for d = 1.
    sheet.Reversed = patch.Reversed = (d == 1) == (side == 1);
    // Every face may carry a weight of its own.
    const double factor = random.Chance(0.2) ? std::ldexp(1.0, random.Integer(-5, 5)) : 1.0;
    int at[3];
    at[d] = side * points.Degree[d];
    for (int k = 0; k < 2; ++k)
    {
      const int degree = points.Degree[others[k]];
      sheet.Surface.Degree[k] = patch.Degree[k] = degree;
      sheet.Surface.NumberOfControlPoints[k] = degree + 1;
      sheet.Surface.Knots[k].assign(degree + 1, 0.0);
      sheet.Surface.Knots[k].insert(sheet.Surface.Knots[k].end(), degree + 1, 1.0);
    }
    for (at[others[1]] = 0; at[others[1]] <= points.Degree[others[1]]; ++at[others[1]])
    {
      for (at[others[0]] = 0; at[others[0]] <= points.Degree[others[0]]; ++at[others[0]])
      {
        std::array<double, 4> h = points.Homogeneous[IndexOf(points, at)];
        std::for_each(h.begin(), h.end(), [factor](double& x) { x *= factor; });
        sheet.Surface.ControlPoints.push_back(h);
        patch.Points.push_back(truth.Points[IndexOf(points, at)]);
      }
    }
    const std::vector<std::array<double, 4>>& net = sheet.Surface.ControlPoints;
    sheet.Surface.Rational = std::any_of(
      net.begin(), net.end(), [&net](const std::array<double, 4>& p) { return p[3] != net[0][3]; });
    // Side `k` of the sheet's own pair runs along one of the other directions; find its two fixed bits.
    const auto railAt = [&](int along, int across, int acrossSide)
    {
      int fixed[2];
      GetOthers(along, fixed);
      const int bits[2] = { fixed[0] == across ? acrossSide : side, fixed[1] == across ? acrossSide : side };
      return alias[RailIndex(along, bits[0], bits[1])];
    };
    sheet.Sides[BOTTOM] = railAt(others[0], others[1], 0);
    sheet.Sides[TOP] = railAt(others[0], others[1], 1);
    sheet.Sides[LEFT] = railAt(others[1], others[0], 0);
    sheet.Sides[RIGHT] = railAt(others[1], others[0], 1);
    shape.Sheets.push_back(sheet);
    shape.Patches.push_back(patch);
  }
}

void InsertKnots(Sheet& sheet, int direction, Random& random)
{
  sm::NURBSSurface& surface = sheet.Surface;
  const int degree = surface.Degree[direction];
  const int other = 1 - direction;
  if (surface.NumberOfControlPoints[direction] != degree + 1)
  {
    return;
  }
  // Few bits: every multiplication by a knot adds them.
  const int bits = degree <= 2 ? random.Integer(1, 4) : degree <= 4 ? random.Integer(1, 2) : 1;
  std::vector<double> interior;
  const int wanted = random.Integer(1, 3);
  for (int i = 0; i < wanted; ++i)
  {
    const double knot = std::ldexp(random.Integer(1, (1 << bits) - 1), -bits);
    const int multiplicity = random.Chance(0.3) ? random.Integer(1, degree) : 1;
    if (std::find(interior.begin(), interior.end(), knot) == interior.end())
    {
      interior.insert(interior.end(), multiplicity, knot);
    }
  }
  std::sort(interior.begin(), interior.end());
  const bool unclamped = random.Chance(0.2);
  std::vector<double> knots;
  for (int i = degree; i >= 0; --i)
  {
    knots.push_back(unclamped ? -i * 0.25 : 0.0);
  }
  knots.insert(knots.end(), interior.begin(), interior.end());
  for (int i = 0; i <= degree; ++i)
  {
    knots.push_back(1.0 + (unclamped ? i * 0.25 : 0.0));
  }
  const int count = static_cast<int>(knots.size()) - degree - 1;
  const int rows = surface.NumberOfControlPoints[other];
  std::vector<std::array<double, 4>> net(static_cast<std::size_t>(count) * rows);
  const auto at = [direction](int along, int across, int alongCount, int acrossCount)
  {
    return static_cast<std::size_t>(
      direction == 0 ? along + across * alongCount : across + along * acrossCount);
  };
  for (int row = 0; row < rows; ++row)
  {
    for (int i = 0; i < count; ++i)
    {
      // Control point i is the blossom at knots i+1 .. i+degree.
      std::vector<QuadPoint> b(degree + 1);
      for (int j = 0; j <= degree; ++j)
      {
        const std::array<double, 4>& p = surface.ControlPoints[at(j, row, degree + 1, rows)];
        b[j] = { p[0], p[1], p[2], p[3] };
      }
      for (int level = 1; level <= degree; ++level)
      {
        const Quad x = knots[i + level];
        for (int j = 0; j + level <= degree; ++j)
        {
          for (int c = 0; c < 4; ++c)
          {
            b[j][c] = (1 - x) * b[j][c] + x * b[j + 1][c];
          }
        }
      }
      std::array<double, 4>& point = net[at(i, row, count, rows)];
      for (int c = 0; c < 4; ++c)
      {
        if (!IsDouble(b[0][c]))
        {
          return;
        }
        point[c] = static_cast<double>(b[0][c]);
      }
      if (!(point[3] > 0.0))
      {
        return;
      }
    }
  }
  surface.Knots[direction] = knots;
  surface.NumberOfControlPoints[direction] = count;
  surface.ControlPoints = net;
}

void MoveDomain(Sheet& sheet, Random& random)
{
  for (int d = 0; d < 2; ++d)
  {
    if (random.Chance(0.3))
    {
      // Exact: parameters on rails are multiples of 2^-42.
      sheet.Width[d] = std::ldexp(1.0, random.Integer(-3, 3));
      sheet.Low[d] = random.Integer(-8, 8) * sheet.Width[d];
      for (double& knot : sheet.Surface.Knots[d])
      {
        knot = sheet.Low[d] + sheet.Width[d] * knot;
      }
    }
  }
}
}
