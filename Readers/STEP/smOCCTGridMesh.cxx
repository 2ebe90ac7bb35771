#include "smOCCTGridMesh.h"

#include <algorithm>
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

/// Cuts the cells of a grid over the box of the loops along the loops.
class GridMesher
{
public:
  GridMesher(const Face& face, int cells)
    : Segments(SampleLoops(face))
    , Cells(cells)
  {
    for (int d = 0; d < 2; ++d)
    {
      double low = face.Surface.GetDomainStart(d);
      double high = face.Surface.GetDomainEnd(d);
      if (!this->Segments.empty())
      {
        low = high = this->Segments[0][0][d];
        for (const auto& s : this->Segments)
        {
          low = std::min(low, s[0][d]);
          high = std::max(high, s[0][d]);
        }
      }
      for (int i = 0; i <= cells; ++i)
      {
        // Off the border by a little: there the loops run along the line, and inside is not defined.
        const double x = std::clamp(static_cast<double>(i) / cells, 1e-6, 1.0 - 1e-6);
        this->Lines[d].push_back((1.0 - x) * low + x * high);
        this->Crossings[d].push_back(FindCrossings(this->Segments, d, this->Lines[d].back()));
      }
    }
  }

  GridMesh Make()
  {
    for (int j = 0; j < this->Cells; ++j)
    {
      for (int i = 0; i < this->Cells; ++i)
      {
        this->AddCell(i, j);
      }
    }
    return std::move(this->Mesh);
  }

private:
  bool IsCovered(const int* corner) const
  {
    return this->Segments.empty() || IsInside(this->Crossings[1][corner[1]], this->Lines[0][corner[0]]);
  }

  /// Index of a point of the mesh.
  int AddPoint(const Point& p)
  {
    const auto entry = this->Known.emplace(p, static_cast<int>(this->Mesh.Parameters.size()));
    if (entry.second)
    {
      this->Mesh.Parameters.push_back(p);
    }
    return entry.first->second;
  }

  /// A fan over the corners that are inside and the crossings between them.
  void AddCell(int i, int j)
  {
    const int corners[5][2] = { { i, j }, { i + 1, j }, { i + 1, j + 1 }, { i, j + 1 }, { i, j } };
    std::vector<int> polygon;
    for (int k = 0; k < 4; ++k)
    {
      const int* a = corners[k];
      const int* b = corners[k + 1];
      const bool here = this->IsCovered(a);
      if (here)
      {
        polygon.push_back(this->AddPoint({ this->Lines[0][a[0]], this->Lines[1][a[1]] }));
      }
      if (here != this->IsCovered(b))
      {
        const int along = k % 2;
        const std::vector<double>& line = this->Lines[along];
        Point p{ this->Lines[0][a[0]], this->Lines[1][a[1]] };
        p[along] = FindCrossing(this->Crossings[1 - along][a[1 - along]], line[a[along]], line[b[along]]);
        polygon.push_back(this->AddPoint(p));
      }
    }
    for (std::size_t k = 2; k < polygon.size(); ++k)
    {
      const std::array<int, 3> t{ polygon[0], polygon[k - 1], polygon[k] };
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
      {
        this->Mesh.Triangles.push_back(t);
      }
    }
  }

  std::vector<std::array<Point, 2>> Segments;
  int Cells;
  std::vector<double> Lines[2];
  std::vector<std::vector<double>> Crossings[2];
  std::map<Point, int> Known;
  GridMesh Mesh;
};
}

GridMesh MakeGridMesh(const Face& face, int cells)
{
  return GridMesher(face, cells).Make();
}
}
