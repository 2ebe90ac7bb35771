#include "smFacePieces.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Samples of each piece of a trim curve.
constexpr int PieceSamples = 8;

/// Loops with less area, relative to their boxes, are too narrow to have a direction.
constexpr double NarrowLoop = 1e-3;

/// Points whose distances from both parts of a torus differ by less than this, relative to its minor radius,
/// are on both.
constexpr double SamePart = 1e-3;

/// Calls visit(u, v) for samples of a loop, in its direction.
template <class Visit>
void VisitLoop(const Loop& loop, const Visit& visit)
{
  for (const Coedge& coedge : loop.Coedges)
  {
    const int pieces = coedge.Curve.GetNumberOfPieces();
    for (int i = 0; i < pieces; ++i)
    {
      const BernsteinPiece<2> piece = coedge.Curve.GetPiece(coedge.Reversed ? pieces - 1 - i : i);
      for (int k = 0; k <= PieceSamples; ++k)
      {
        visit(piece.Evaluate(static_cast<double>(coedge.Reversed ? PieceSamples - k : k) / PieceSamples));
      }
    }
  }
}
}

int CountOuterLoops(const Face& face)
{
  int outer = 0;
  for (const Loop& loop : face.Loops)
  {
    double area = 0.0;
    TrimCurve::Point low{ 1e300, 1e300 };
    TrimCurve::Point high{ -1e300, -1e300 };
    TrimCurve::Point first{};
    TrimCurve::Point last{};
    bool isFirst = true;
    VisitLoop(loop,
      [&](const TrimCurve::Point& p)
      {
        for (int d = 0; d < 2; ++d)
        {
          low[d] = std::min(low[d], p[d]);
          high[d] = std::max(high[d], p[d]);
        }
        first = isFirst ? p : first;
        area += isFirst
          ? 0.0
          : 0.5 * ((last[0] - first[0]) * (p[1] - first[1]) - (last[1] - first[1]) * (p[0] - first[0]));
        last = p;
        isFirst = false;
      });
    outer += area > NarrowLoop * (high[0] - low[0]) * (high[1] - low[1]) ? 1 : 0;
  }
  return outer;
}

bool IsOnBothParts(const Face& face, const SpindleTorus& torus, const StatementPlace& place)
{
  bool isOnPart[2] = { false, false };
  Vector3 origin = place.Shift;
  Vector3 axis{};
  for (int i = 0; i < 3; ++i)
  {
    origin[i] += Dot(place.Linear[i], torus.Origin);
    axis[i] = Dot(place.Linear[i], torus.Axis);
  }
  const double scale = Norm(axis);
  for (const Loop& loop : face.Loops)
  {
    VisitLoop(loop,
      [&](const TrimCurve::Point& uv)
      {
        Vector3 x;
        face.Surface.Evaluate(uv[0], uv[1], x.data());
        x = Subtract(x, origin);
        const double height = Dot(x, axis) / (scale * scale);
        const double square = Dot(x, x) / (scale * scale);
        const double radial = std::sqrt(std::max(0.0, square - height * height));
        const double outer = std::abs(std::hypot(radial - torus.Major, height) - torus.Minor);
        const double inner = std::abs(std::hypot(radial + torus.Major, height) - torus.Minor);
        isOnPart[0] = isOnPart[0] || outer + SamePart * torus.Minor < inner;
        isOnPart[1] = isOnPart[1] || inner + SamePart * torus.Minor < outer;
      });
  }
  return isOnPart[0] && isOnPart[1];
}
}
