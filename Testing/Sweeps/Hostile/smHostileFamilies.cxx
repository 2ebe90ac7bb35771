#include "smHostileBlock.h"

#include <algorithm>
#include <cmath>

namespace smhostile
{
namespace
{
// Bits of a coordinate: what is left of 53 goes to weights and knots.
constexpr int CoordinateBits = 20;
constexpr Real Pi = 3.14159265358979323846264338327950288L;

/// A random matrix: rotation times scales in [smallest, 1].
std::array<double, 9> MakeFrame(Random& random, double smallest)
{
  std::array<double, 9> m = MakeRotation(random);
  for (int column = 0; column < 3; ++column)
  {
    const double scale = random.LogUniform(smallest, 1.0);
    for (int row = 0; row < 3; ++row)
    {
      m[3 * row + column] *= scale;
    }
  }
  return m;
}

/// Cartesian control points of a perturbed, bent, rotated block, quantised.
std::vector<Point3> MakeNet(Random& random, const int degree[3], double size, bool planarSections)
{
  const std::array<double, 9> frame = MakeFrame(random, random.Chance(0.2) ? 0.01 : 0.3);
  const double strength = random.Chance(0.15) ? random.Uniform(0.3, 0.9)
    : random.Chance(0.1)                      ? 0.0
                                              : random.LogUniform(1e-3, 0.3);
  const double bend = random.Chance(0.5) ? random.Uniform(-0.8, 0.8) : 0.0;
  const double twist = random.Chance(0.3) ? random.Uniform(-1.0, 1.0) : 0.0;
  Point3 offset = { 0.0, 0.0, 0.0 };
  double reach = 4.0 * size;
  if (random.Chance(0.1))
  {
    // Far from the local origin: digits are lost, and the bound must say so.
    for (double& x : offset)
    {
      x = size * random.Uniform(-20.0, 20.0);
    }
    reach = 32.0 * size;
  }
  std::vector<Point3> net;
  const int layer = (degree[0] + 1) * (degree[1] + 1);
  for (int k = 0; k <= degree[2]; ++k)
  {
    for (int j = 0; j <= degree[1]; ++j)
    {
      for (int i = 0; i <= degree[0]; ++i)
      {
        Point3 x = { 2.0 * i / degree[0] - 1.0, 2.0 * j / degree[1] - 1.0, 2.0 * k / degree[2] - 1.0 };
        for (int c = 0; c < 3; ++c)
        {
          x[c] += strength * random.Uniform(-1.0, 1.0) * (planarSections ? (c < 2 ? 1.0 : 0.0) : 1.0);
        }
        x[1] += bend * x[0] * x[0];
        x[2] += planarSections ? 0.0 : twist * x[0] * x[1];
        Point3 point;
        for (int c = 0; c < 3; ++c)
        {
          double sum = offset[c];
          for (int e = 0; e < 3; ++e)
          {
            sum += size * frame[3 * c + e] * x[e];
          }
          point[c] = Quantize(sum, reach, CoordinateBits);
        }
        if (planarSections && k > 0)
        {
          // An extrusion: the first layer moved by one and the same vector.
          for (int c = 0; c < 3; ++c)
          {
            point[c] =
              net[net.size() - layer][c] + Quantize(2.0 * size * frame[3 * c + 2], reach, CoordinateBits);
          }
        }
        net.push_back(point);
      }
    }
  }
  return net;
}

void ChooseDegrees(Random& random, int degree[3])
{
  const int maximum = random.Chance(0.05) ? 9 : random.Chance(0.5) ? 3 : 5;
  for (int d = 0; d < 3; ++d)
  {
    degree[d] = random.Integer(1, maximum);
  }
}

/// Collapses a random edge of the cube to its first point: two faces get a pole.
void CollapseEdge(Random& random, const int degree[3], std::vector<Point3>& net)
{
  const int d = random.Integer(0, 2);
  int at[3] = { random.Integer(0, 1) * degree[0], random.Integer(0, 1) * degree[1],
    random.Integer(0, 1) * degree[2] };
  const auto index = [&]
  { return at[0] + (degree[0] + 1) * (at[1] + static_cast<std::size_t>(degree[1] + 1) * at[2]); };
  at[d] = 0;
  const Point3 first = net[index()];
  for (at[d] = 1; at[d] <= degree[d]; ++at[d])
  {
    net[index()] = first;
  }
}

/// Weight factors c^i of a Möbius reparametrisation t -> c t / (1 - t + c t), within `budget` bits.
std::vector<double> MakeMoebius(Random& random, int degree, int budget)
{
  double c = 1.0;
  if (random.Chance(0.75))
  {
    const double odd[] = { 1.0, 1.0, 3.0, 5.0, 7.0 };
    c = odd[random.Integer(0, 4)];
    if (degree * std::log2(c) > budget)
    {
      c = 1.0;
    }
    // Up to about 1e3 from one end to the other.
    const int maximum = std::max(1, 9 / degree);
    c *= std::ldexp(1.0, random.Integer(-maximum, maximum) - (c > 1.0 ? 2 : 0));
  }
  std::vector<double> factors(degree + 1, 1.0);
  for (int i = 1; i <= degree; ++i)
  {
    factors[i] = factors[i - 1] * c;
  }
  return factors;
}

void AddPoint(BlockPoints& points, const Point3& x, double w, bool truthIsPolynomial)
{
  // Exact: the factors have few bits.
  points.Homogeneous.push_back({ x[0] * w, x[1] * w, x[2] * w, w });
  const Real weight = truthIsPolynomial ? 1.0L : static_cast<Real>(w);
  points.Truth.Points.push_back({ x[0] * weight, x[1] * weight, x[2] * weight, weight });
}
}

void MakePolynomialBlock(Random& random, Shape& shape)
{
  BlockPoints points;
  ChooseDegrees(random, points.Degree);
  const bool extruded = random.Chance(0.15);
  if (extruded)
  {
    points.Degree[2] = 1;
  }
  std::vector<Point3> net = MakeNet(random, points.Degree, shape.Size, extruded);
  shape.Family = extruded ? "extruded" : "polynomial";
  if (!extruded && random.Chance(0.15))
  {
    CollapseEdge(random, points.Degree, net);
    shape.Family = "pole";
  }
  const bool moebius = random.Chance(0.4);
  std::vector<double> factors[3];
  for (int d = 0; d < 3; ++d)
  {
    factors[d].assign(points.Degree[d] + 1, 1.0);
    if (moebius)
    {
      factors[d] = MakeMoebius(random, points.Degree[d], 10);
    }
  }
  shape.Family += moebius ? "-moebius" : "";
  std::copy_n(points.Degree, 3, points.Truth.Degree);
  std::size_t index = 0;
  for (int k = 0; k <= points.Degree[2]; ++k)
  {
    for (int j = 0; j <= points.Degree[1]; ++j)
    {
      for (int i = 0; i <= points.Degree[0]; ++i)
      {
        AddPoint(points, net[index++], factors[0][i] * factors[1][j] * factors[2][k], true);
      }
    }
  }
  BuildBlock(points, random, shape);
}

void MakeRationalBlock(Random& random, Shape& shape)
{
  shape.Family = "rational";
  BlockPoints points;
  ChooseDegrees(random, points.Degree);
  const std::vector<Point3> net = MakeNet(random, points.Degree, shape.Size, false);
  const double ratio = random.LogUniform(1.1, 1e3);
  std::copy_n(points.Degree, 3, points.Truth.Degree);
  for (const Point3& x : net)
  {
    AddPoint(points, x, Quantize(random.LogUniform(1.0, ratio), 1024.0, 16), false);
  }
  BuildBlock(points, random, shape);
}

void MakeBallOctant(Random& random, Shape& shape)
{
  // rho (1) x latitude (2) x longitude (2). The quarter circle (1 - t^2, 2 t) / (1 + t^2) has integer control
  // points: the ball is exact in doubles.
  shape.Family = "ball-octant";
  BlockPoints points;
  points.Degree[0] = 1;
  points.Degree[1] = points.Degree[2] = 2;
  const double arc[3][3] = { { 1, 0, 1 }, { 1, 1, 1 }, { 0, 2, 2 } };
  const double radius = Quantize(shape.Size, shape.Size, CoordinateBits);
  // A shear and scales of few bits, or none.
  double image[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  const bool sheared = random.Chance(0.6);
  if (sheared)
  {
    for (double& entry : image)
    {
      entry = random.Integer(-8, 8) / 8.0;
    }
    for (int d = 0; d < 3; ++d)
    {
      // Dominant diagonal: never singular.
      image[4 * d] = 2.25 + random.Integer(0, 8) / 8.0;
    }
  }
  std::copy_n(points.Degree, 3, points.Truth.Degree);
  for (int k = 0; k < 3; ++k)
  {
    for (int j = 0; j < 3; ++j)
    {
      for (int i = 0; i < 2; ++i)
      {
        const double w = arc[j][2] * arc[k][2];
        const double x[3] = { i * radius * arc[j][0] * arc[k][0], i * radius * arc[j][0] * arc[k][1],
          i * radius * arc[j][1] * arc[k][2] };
        std::array<double, 4> h = { 0, 0, 0, w };
        for (int c = 0; c < 3; ++c)
        {
          h[c] = image[3 * c] * x[0] + image[3 * c + 1] * x[1] + image[3 * c + 2] * x[2];
        }
        points.Homogeneous.push_back(h);
        points.Truth.Points.push_back({ h[0], h[1], h[2], h[3] });
      }
    }
  }
  points.Omitted[0] = true; // rho = 0: the centre
  points.Omitted[3] = true; // the pole's axis
  const auto* m = image;
  const Real determinant = static_cast<Real>(m[0]) * (m[4] * m[8] - m[5] * m[7]) -
    static_cast<Real>(m[1]) * (m[3] * m[8] - m[5] * m[6]) +
    static_cast<Real>(m[2]) * (m[3] * m[7] - m[4] * m[6]);
  shape.FormulaVolume = determinant * Pi / 6.0L * radius * radius * radius;
  BuildBlock(points, random, shape);
}

namespace
{
/// A piece of a profile in homogeneous (w r, w z, w).
using ProfilePiece = std::vector<std::array<double, 3>>;

/// The quarter circle from angle q 90 degrees on, about (center, 0); integer weights.
ProfilePiece MakeQuarter(int q, double center, double radius)
{
  const double arc[3][3] = { { 1, 0, 1 }, { 1, 1, 1 }, { 0, 2, 2 } };
  ProfilePiece piece;
  for (const auto& a : arc)
  {
    double x = a[0];
    double y = a[1];
    for (int turn = 0; turn < q; ++turn)
    {
      const double old = x;
      x = -y;
      y = old;
    }
    piece.push_back({ center * a[2] + radius * x, radius * y, a[2] });
  }
  return piece;
}

/// Polynomial pieces through corners; interior control points at random next to the chord.
std::vector<ProfilePiece> MakePolynomialProfile(Random& random, double size, bool fromAxisToAxis)
{
  const int corners = random.Integer(3, 5);
  std::vector<std::array<double, 2>> corner;
  const double center = fromAxisToAxis ? 0.0 : random.Uniform(1.2, 2.0);
  for (int i = 0; i < corners; ++i)
  {
    const double angle =
      fromAxisToAxis ? 3.14159265 * (static_cast<double>(i) / (corners - 1) - 0.5) : 6.2831853 * i / corners;
    const double radius = random.Uniform(0.5, 1.0);
    corner.push_back({ center + radius * std::cos(angle), radius * std::sin(angle) });
  }
  if (fromAxisToAxis)
  {
    corner.front()[0] = corner.back()[0] = 0.0;
  }
  else
  {
    corner.push_back(corner.front());
  }
  std::vector<ProfilePiece> profile;
  for (std::size_t i = 0; i + 1 < corner.size(); ++i)
  {
    const int degree = random.Chance(0.4) ? 1 : random.Integer(2, 5);
    ProfilePiece piece;
    for (int j = 0; j <= degree; ++j)
    {
      const double x = static_cast<double>(j) / degree;
      std::array<double, 3> point = { 0.0, 0.0, 1.0 };
      for (int c = 0; c < 2; ++c)
      {
        double value = (1.0 - x) * corner[i][c] + x * corner[i + 1][c];
        if (j > 0 && j < degree)
        {
          value += random.Uniform(-0.15, 0.15);
          value = c == 0 ? std::max(value, 0.05) : value;
        }
        point[c] = Quantize(size * value, 4.0 * size, CoordinateBits);
      }
      piece.push_back(point);
    }
    profile.push_back(piece);
  }
  return profile;
}

std::vector<ProfilePiece> MakeProfile(Random& random, Shape& shape)
{
  std::vector<ProfilePiece> profile;
  const double radius = Quantize(shape.Size, shape.Size, CoordinateBits);
  const int kind = random.Integer(0, 3);
  if (kind == 0)
  {
    shape.Family = "ball";
    profile = { MakeQuarter(3, 0.0, radius), MakeQuarter(0, 0.0, radius) };
    shape.FormulaVolume = 4.0L / 3.0L * Pi * radius * radius * radius;
  }
  else if (kind == 1)
  {
    shape.Family = "torus";
    const double center = radius * (1.0 + random.Integer(1, 16) / 8.0);
    for (int q = 0; q < 4; ++q)
    {
      profile.push_back(MakeQuarter(q, center, radius));
    }
    shape.FormulaVolume = 2.0L * Pi * Pi * center * radius * radius;
  }
  else
  {
    shape.Family = kind == 2 ? "revolved-axis" : "revolved-ring";
    profile = MakePolynomialProfile(random, shape.Size, kind == 2);
  }
  return profile;
}
}

void MakeRevolved(Random& random, Shape& shape)
{
  const std::vector<ProfilePiece> profile = MakeProfile(random, shape);
  // Nine integer control points of the circle: weights 1 1 2 1 1 1 2 1 1.
  const double circle[9][3] = { { 1, 0, 1 }, { 1, 1, 1 }, { 0, 2, 2 }, { -1, 1, 1 }, { -1, 0, 1 },
    { -1, -1, 1 }, { 0, -2, 2 }, { 1, -1, 1 }, { 1, 0, 1 } };
  const int axis = random.Integer(0, 2);
  const auto place = [axis](double x, double y, double z, double w)
  {
    std::array<double, 4> h = { 0, 0, 0, w };
    h[(axis + 1) % 3] = x;
    h[(axis + 2) % 3] = y;
    h[axis] = z;
    return h;
  };
  const auto toReal = [](const std::array<double, 4>& h) { return RealPoint{ h[0], h[1], h[2], h[3] }; };
  const int pieces = static_cast<int>(profile.size());
  const bool closed = profile.front().front()[0] != 0.0;
  // Rails 0 .. pieces-1: seams; then the circles at the pieces' ends.
  const int circles = closed ? pieces : pieces + 1;
  for (int i = 0; i < circles; ++i)
  {
    const std::array<double, 3> p = i < pieces ? profile[i].front() : profile[i - 1].back();
    const std::array<double, 4> h = place(p[0] / p[2], 0.0, p[1] / p[2], 1.0);
    shape.Vertices.push_back({ h[0], h[1], h[2] });
  }
  for (int i = 0; i < pieces; ++i)
  {
    Rail seam;
    seam.StartVertex = i;
    seam.EndVertex = (i + 1) % circles;
    seam.Pieces.resize(1);
    for (const std::array<double, 3>& p : profile[i])
    {
      seam.Pieces[0].push_back(toReal(place(p[0], 0.0, p[1], p[2])));
    }
    shape.Rails.push_back(seam);
  }
  for (int i = 0; i < circles; ++i)
  {
    const std::array<double, 3> p = i < pieces ? profile[i].front() : profile[i - 1].back();
    Rail rail;
    rail.StartVertex = rail.EndVertex = i;
    rail.Degenerate = p[0] == 0.0;
    for (int quarter = 0; quarter < 4; ++quarter)
    {
      rail.Pieces.emplace_back();
      for (int k = 0; k < 3; ++k)
      {
        const double* c = circle[2 * quarter + k];
        rail.Pieces.back().push_back(toReal(place(p[0] * c[0], p[0] * c[1], p[1] * c[2], p[2] * c[2])));
      }
    }
    shape.Rails.push_back(rail);
  }
  for (int i = 0; i < pieces; ++i)
  {
    const int degree = static_cast<int>(profile[i].size()) - 1;
    Sheet sheet;
    // Profiles run counter-clockwise in (r, z): the solid is to their left, and Su x Sv points to it.
    sheet.Reversed = true;
    sheet.Surface.Degree[0] = degree;
    sheet.Surface.Degree[1] = 2;
    sheet.Surface.NumberOfControlPoints[0] = degree + 1;
    sheet.Surface.NumberOfControlPoints[1] = 9;
    sheet.Surface.Knots[0].assign(degree + 1, 0.0);
    sheet.Surface.Knots[0].insert(sheet.Surface.Knots[0].end(), degree + 1, 1.0);
    sheet.Surface.Knots[1] = { 0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1 };
    sheet.Surface.Rational = true;
    for (const double* c : circle)
    {
      for (const std::array<double, 3>& p : profile[i])
      {
        sheet.Surface.ControlPoints.push_back(place(p[0] * c[0], p[0] * c[1], p[1] * c[2], p[2] * c[2]));
      }
    }
    sheet.Sides[BOTTOM] = sheet.Sides[TOP] = i;
    sheet.Sides[LEFT] = pieces + i;
    sheet.Sides[RIGHT] = pieces + (i + 1) % circles;
    shape.Sheets.push_back(sheet);
    for (int quarter = 0; quarter < 4; ++quarter)
    {
      ReferencePatch patch;
      patch.Degree[0] = degree;
      patch.Degree[1] = 2;
      patch.Reversed = true;
      const auto first =
        sheet.Surface.ControlPoints.begin() + static_cast<std::ptrdiff_t>(2 * quarter) * (degree + 1);
      std::transform(first, first + 3 * (degree + 1), std::back_inserter(patch.Points), toReal);
      shape.Patches.push_back(patch);
    }
  }
}
}
