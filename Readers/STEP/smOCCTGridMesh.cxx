#include "smOCCTGridMesh.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace sm
{
namespace
{
using Point = std::array<double, 2>;
constexpr int SamplesPerPiece = 6;

/// Straight segments along all loops, with the piece that closes each.
std::vector<std::array<Point, 2>> SampleLoops(const Face& face)
{
  std::vector<std::array<Point, 2>> segments;
  for (const Loop& loop : face.Loops)
  {
    std::vector<Point> polygon;
    for (const Coedge& coedge : loop.Coedges)
    {
      std::vector<Point> line;
      for (int k = 0; k < coedge.Curve.GetNumberOfPieces(); ++k)
      {
        const int steps = coedge.Curve.GetDegree(k) > 1 ? SamplesPerPiece : 1;
        for (int i = 0; i < steps; ++i)
        {
          line.push_back(coedge.Curve.GetPiece(k).Evaluate(static_cast<double>(i) / steps));
        }
      }
      line.push_back(coedge.Curve.GetEndPoint());
      if (coedge.Reversed)
      {
        std::reverse(line.begin(), line.end());
      }
      polygon.insert(polygon.end(), line.begin(), line.end());
    }
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      segments.push_back({ polygon[i], polygon[(i + 1) % polygon.size()] });
    }
  }
  return segments;
}

/// Where the loops cross the line on which coordinate `fixed` is `value`: the other coordinate, increasing.
std::vector<double> FindCrossings(const std::vector<std::array<Point, 2>>& segments, int fixed, double value)
{
  std::vector<double> crossings;
  for (const auto& s : segments)
  {
    if ((s[0][fixed] < value) != (s[1][fixed] < value))
    {
      const double x = (value - s[0][fixed]) / (s[1][fixed] - s[0][fixed]);
      crossings.push_back((1.0 - x) * s[0][1 - fixed] + x * s[1][1 - fixed]);
    }
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

bool IsInside(const std::vector<double>& crossings, double at)
{
  return (std::lower_bound(crossings.begin(), crossings.end(), at) - crossings.begin()) % 2 != 0;
}

/// A crossing between a and b; the middle when sampling lost it.
double FindCrossing(const std::vector<double>& crossings, double a, double b)
{
  const auto found = std::lower_bound(crossings.begin(), crossings.end(), std::min(a, b));
  return found != crossings.end() && *found <= std::max(a, b) ? *found : 0.5 * (a + b);
}
}

GridMesh MakeGridMesh(const Face& face, int cells)
{
  const std::vector<std::array<Point, 2>> segments = SampleLoops(face);
  double low[2];
  double high[2];
  for (int d = 0; d < 2; ++d)
  {
    low[d] = face.Surface.GetDomainStart(d);
    high[d] = face.Surface.GetDomainEnd(d);
    if (!segments.empty())
    {
      low[d] = high[d] = segments[0][0][d];
      for (const auto& s : segments)
      {
        low[d] = std::min(low[d], s[0][d]);
        high[d] = std::max(high[d], s[0][d]);
      }
    }
  }
  std::vector<double> lines[2];
  std::vector<std::vector<double>> crossings[2];
  for (int d = 0; d < 2; ++d)
  {
    for (int i = 0; i <= cells; ++i)
    {
      // Off the border by a little: there the loops run along the line, and inside is not defined.
      const double x = std::clamp(static_cast<double>(i) / cells, 1e-6, 1.0 - 1e-6);
      lines[d].push_back((1.0 - x) * low[d] + x * high[d]);
      crossings[d].push_back(FindCrossings(segments, d, lines[d].back()));
    }
  }
  const auto inside = [&](int i, int j)
  { return segments.empty() || IsInside(crossings[1][j], lines[0][i]); };

  GridMesh mesh;
  std::map<Point, int> known;
  const auto add = [&mesh, &known](const Point& p)
  {
    const auto entry = known.emplace(p, static_cast<int>(mesh.Parameters.size()));
    if (entry.second)
    {
      mesh.Parameters.push_back(p);
    }
    return entry.first->second;
  };
  for (int j = 0; j < cells; ++j)
  {
    for (int i = 0; i < cells; ++i)
    {
      const int corners[5][2] = { { i, j }, { i + 1, j }, { i + 1, j + 1 }, { i, j + 1 }, { i, j } };
      std::vector<int> polygon;
      for (int k = 0; k < 4; ++k)
      {
        const int* a = corners[k];
        const int* b = corners[k + 1];
        const bool here = inside(a[0], a[1]);
        if (here)
        {
          polygon.push_back(add({ lines[0][a[0]], lines[1][a[1]] }));
        }
        if (here != inside(b[0], b[1]))
        {
          const int along = k % 2;
          Point p{ lines[0][a[0]], lines[1][a[1]] };
          p[along] =
            FindCrossing(crossings[1 - along][a[1 - along]], lines[along][a[along]], lines[along][b[along]]);
          polygon.push_back(add(p));
        }
      }
      for (std::size_t k = 2; k < polygon.size(); ++k)
      {
        const std::array<int, 3> t{ polygon[0], polygon[k - 1], polygon[k] };
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
        {
          mesh.Triangles.push_back(t);
        }
      }
    }
  }
  return mesh;
}
}
