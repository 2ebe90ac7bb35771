#include "smClosing.h"

#include "smFormat.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Largest distance of the end of an edge from its vertex, relative to the body's size, before it counts as a
/// defect. Real files have distances of up to 1.3e-3.
constexpr double EndTolerance = 2e-3;
/// The same for an edge that is closed, relative to its own size: where it begins changes no area and no
/// volume.
constexpr double ClosedEndTolerance = 0.05;
}

double MeasureSize(const std::vector<std::shared_ptr<const Edge>>& edges)
{
  Vector3 low{ 1e300, 1e300, 1e300 };
  Vector3 high{ -1e300, -1e300, -1e300 };
  for (const auto& edge : edges)
  {
    for (std::size_t i = 0; edge && i < edge->Curve.Coefficients.size(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        low[c] = std::min(low[c], edge->Curve.Coefficients[i][c]);
        high[c] = std::max(high[c], edge->Curve.Coefficients[i][c]);
      }
    }
  }
  return low[0] <= high[0] ? std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) : 0.0;
}

double GetVertexGap(const Edge& edge)
{
  const auto distance = [](const Vector3& a, const Vector3& b)
  { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); };
  return std::max(distance(edge.StartVertex, edge.Curve.GetStartPoint()),
    distance(edge.EndVertex, edge.Curve.GetEndPoint()));
}

double GetVertexLimit(const Edge& edge, double size)
{
  const bool isClosed = edge.StartVertex == edge.EndVertex &&
    Norm(Subtract(edge.Curve.GetStartPoint(), edge.Curve.GetEndPoint())) <= LoopTolerance * size;
  const double own = isClosed ? MeasureSize({ std::make_shared<const Edge>(edge) }) : 0.0;
  return std::max(EndTolerance * size, ClosedEndTolerance * own);
}

void CheckClosing(double unit, double size, DraftFace& draft, Face& face)
{
  double largest = 0.0;
  int open = 0;
  double tolerance = 0.0;
  for (const WireShape& wire : draft.Source->Wires)
  {
    for (const CoedgeShape& use : wire.Coedges)
    {
      for (const VertexPointer& vertex : { use.Edge->Start, use.Edge->End })
      {
        tolerance = std::max(tolerance, vertex ? vertex->Tolerance : 0.0);
      }
    }
  }
  // The tolerance of a vertex contains the ends of all its edges, so it is limited here.
  tolerance = std::min(tolerance * unit, VertexTolerance * size);
  for (const Loop& loop : face.Loops)
  {
    for (std::size_t i = 0; i < loop.Coedges.size(); ++i)
    {
      const Coedge& a = loop.Coedges[i];
      const Coedge& b = loop.Coedges[(i + 1) % loop.Coedges.size()];
      const auto from = a.Reversed ? a.Curve.GetStartPoint() : a.Curve.GetEndPoint();
      const auto to = b.Reversed ? b.Curve.GetEndPoint() : b.Curve.GetStartPoint();
      Vector3 p;
      Vector3 q;
      face.Surface.Evaluate(from[0], from[1], p.data());
      face.Surface.Evaluate(to[0], to[1], q.data());
      const double gap = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
      const double beyond = gap - 2.0 * (a.Use->Tolerance + b.Use->Tolerance);
      // std::max is not used, because it may drop a NaN.
      largest = beyond <= largest ? largest : beyond;
      // The condition is written so that a NaN counts as open.
      open += beyond <= 2.0 * tolerance || gap <= LoopTolerance * size ? 0 : 1;
    }
  }
  draft.Defects += open;
  if (!(largest <= 2.0 * tolerance) || open > 0)
  {
    face.Messages.push_back("A loop does not close: its largest gap is " + FormatDistance(largest) +
      " beyond the file's tolerances. A straight line in (u,v) closes it.");
  }
}
}
