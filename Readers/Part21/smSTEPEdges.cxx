// Finds edges whose curve contradicts their vertices.
#include "smSTEPCensusTaker.h"
#include "smSTEPFrames.h"
#include "smSTEPPropertyAttributes.h"
#include "smSTEPTopologyAttributes.h"
#include "smVector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
constexpr STEPAttribute SenseOfEdge = { "EDGE_CURVE", 1, 4, "same sense" };
constexpr STEPAttribute PointOfLine = { "LINE", 0, 1, "point" };
constexpr STEPAttribute VectorOfLine = { "LINE", 1, 2, "vector" };
constexpr STEPAttribute DirectionOfVector = { "VECTOR", 0, 1, "direction" };
constexpr STEPAttribute PolesOfSpline = { "B_SPLINE_CURVE", 1, 2, "control points" };
constexpr STEPAttribute PositionOfConic = { "CONIC", 0, 1, "position" };
constexpr STEPAttribute RadiusOfCircle = { "CIRCLE", 0, 2, "radius" };
constexpr STEPAttribute RadiiOfEllipse[] = { { "ELLIPSE", 0, 2, "first radius" },
  { "ELLIPSE", 1, 3, "second radius" } };

/// Distance of a vertex from its edge's curve, relative to the extent of the body's vertices, above which the
/// two contradict each other. It is twice the default limit of gaps; real files have up to 1.3e-3.
constexpr double VertexLimit = 2e-3;
/// The same for a closed circle or ellipse, relative to its smaller radius: its vertex only says where the
/// edge begins, which no area and no volume depends on. A wrong curve lies off the faces that it bounds,
/// which is found there.
constexpr double ClosedCurveLimit = 0.1;
/// The same in units of the file's stated uncertainty, which is added.
constexpr double UncertaintyLimit = 2.0;

double GetLength(const Point3& a)
{
  return std::hypot(a[0], a[1], a[2]);
}
}

/// Reads the three numbers of a point or a direction; returns false if there are no such.
bool STEPCensusTaker::ReadNumbers(Index entity, const STEPAttribute& attribute, Point3& numbers) const
{
  const Part21Value list = this->Entities.Get(entity, attribute);
  Part21Values values(list.Text);
  Part21Value value;
  for (double& number : numbers)
  {
    if (!list.IsList() || !values.Next(value) || !value.GetNumber(number))
    {
      return false;
    }
  }
  return true;
}

/// Reads point and unit direction of a line.
bool STEPCensusTaker::ReadLine(Index line, Point3& point, Point3& direction) const
{
  const Index vector = this->Entities.Follow(this->Entities.Get(line, VectorOfLine));
  return this->ReadNumbers(
           this->Entities.Follow(this->Entities.Get(line, PointOfLine)), CoordinatesOfPoint, point) &&
    ReadSTEPDirection(
      this->Entities, this->Entities.Follow(this->Entities.Get(vector, DirectionOfVector)), direction);
}

/// Reads place and radii of a circle or an ellipse; returns false if the curve is neither, or cannot be read.
bool STEPCensusTaker::ReadConic(Index conic, STEPFrame& frame, double radii[2]) const
{
  std::string_view record;
  radii[0] = radii[1] = 0.0;
  if (this->Entities.FindRecord(conic, "CIRCLE", record))
  {
    this->Entities.Get(conic, RadiusOfCircle).GetNumber(radii[0]);
    radii[1] = radii[0];
  }
  else if (this->Entities.FindRecord(conic, "ELLIPSE", record))
  {
    this->Entities.Get(conic, RadiiOfEllipse[0]).GetNumber(radii[0]);
    this->Entities.Get(conic, RadiiOfEllipse[1]).GetNumber(radii[1]);
  }
  return radii[0] > 0.0 && radii[1] > 0.0 &&
    ReadSTEPFrame(this->Entities, this->Entities.Follow(this->Entities.Get(conic, PositionOfConic)), frame);
}

/// Returns true for an edge that begins and ends at one vertex.
bool STEPCensusTaker::IsClosedEdge(Index edge) const
{
  const Part21Value start = this->Entities.Get(edge, StartOfEdge);
  return start.IsReference() && start.Id == this->Entities.Get(edge, EndOfEdge).Id;
}

/**
 * Returns the distance of a point from a circle, a lower bound of that from an ellipse, and -1 if the curve
 * is neither, or cannot be read. The bound: f = sqrt((x/a)^2 + (y/b)^2) is 1 on the ellipse, and its slope is
 * at most 1 / min(a, b).
 */
double STEPCensusTaker::GetConicDistance(Index conic, const Point3& point) const
{
  double radii[2];
  STEPFrame frame;
  if (!this->ReadConic(conic, frame, radii))
  {
    return -1.0;
  }
  const Point3 away = Subtract(point, frame.Origin);
  const double height = Dot(away, frame.Axes[2]);
  const double size = GetLength(away);
  const double radial = std::sqrt(std::max(0.0, (size - height) * (size + height)));
  if (radii[0] == radii[1])
  {
    return std::hypot(radial - radii[0], height);
  }
  const double u = Dot(away, frame.Axes[0]);
  const double v = std::sqrt(std::max(0.0, (radial - u) * (radial + u)));
  const double inPlane = (std::hypot(u / radii[0], v / radii[1]) - 1.0) * std::min(radii[0], radii[1]);
  return std::hypot(inPlane, height);
}

/// Returns true if an open spline leads from the last vertex to the first one, or the reverse if the edge has
/// the other sense. Its ends are its first and last control points; if its knots are not clamped, it ends
/// elsewhere, and nothing is found.
bool STEPCensusTaker::IsAgainstSpline(Index spline, bool isForward, const Point3 ends[2], double limit) const
{
  Part21Values poles(this->Entities.Get(spline, PolesOfSpline).Text);
  Part21Value value;
  Index first = None;
  Index last = None;
  while (poles.Next(value))
  {
    last = this->Entities.Follow(value);
    first = first == None ? last : first;
  }
  Point3 from;
  Point3 to;
  if (!this->ReadNumbers(isForward ? first : last, CoordinatesOfPoint, from) ||
    !this->ReadNumbers(isForward ? last : first, CoordinatesOfPoint, to))
  {
    return false;
  }
  return GetLength(Subtract(from, to)) > 2.0 * limit && GetLength(Subtract(ends[0], to)) <= limit &&
    GetLength(Subtract(ends[1], from)) <= limit;
}

void STEPCensusTaker::CheckEdge(Index edge, const Point3 ends[2], double limit)
{
  const Index curve = this->FindSpatialCurve(edge);
  std::string_view record;
  double distance = -1.0;
  const bool isForward = this->Entities.Get(edge, SenseOfEdge).Text != "F";
  if (this->Entities.FindRecord(curve, "LINE", record))
  {
    Point3 point;
    Point3 direction;
    if (!this->ReadLine(curve, point, direction))
    {
      return;
    }
    for (int k = 0; k < 2; ++k)
    {
      const Point3 away = Subtract(ends[k], point);
      const double along = Dot(away, direction);
      const double size = GetLength(away);
      distance = std::max(distance, std::sqrt(std::max(0.0, (size - along) * (size + along))));
    }
    const double advance = Dot(Subtract(ends[1], ends[0]), direction);
    if (distance <= limit && std::abs(advance) > limit && isForward != (advance > 0.0))
    {
      this->Add(CensusDefect::ReversedLine, edge, this->File.GetId(curve), "curve");
    }
  }
  else if (this->Entities.FindRecord(curve, "B_SPLINE_CURVE_WITH_KNOTS", record) &&
    this->IsAgainstSpline(curve, isForward, ends, limit))
  {
    this->Add(CensusDefect::ReversedLine, edge, this->File.GetId(curve), "curve");
  }
  else if (this->Entities.FindRecord(curve, "CIRCLE", record) ||
    this->Entities.FindRecord(curve, "ELLIPSE", record))
  {
    distance = std::max(this->GetConicDistance(curve, ends[0]), this->GetConicDistance(curve, ends[1]));
    double radii[2];
    STEPFrame frame;
    if (this->IsClosedEdge(edge) && this->ReadConic(curve, frame, radii))
    {
      limit = std::max(limit, ClosedCurveLimit * std::min(radii[0], radii[1]));
    }
  }
  if (distance > limit)
  {
    this->GeometricDamage[edge] = true;
    this->Add(CensusDefect::CurveOffVertex, edge, this->File.GetId(curve), "curve");
  }
}

/// Extends a box by the vertices of an edge, and by a circle or an ellipse that begins and ends at one.
void STEPCensusTaker::AddEdgeExtent(const VertexPair& edge, Point3& low, Point3& high) const
{
  const auto add = [&low, &high](const Point3& point, const Point3& reach)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], point[c] - reach[c]);
      high[c] = std::max(high[c], point[c] + reach[c]);
    }
  };
  add(edge.Ends[0], {});
  add(edge.Ends[1], {});
  double radii[2];
  STEPFrame frame;
  if (this->IsClosedEdge(edge.Edge) && this->ReadConic(this->FindSpatialCurve(edge.Edge), frame, radii))
  {
    Point3 reach;
    for (std::size_t c = 0; c < 3; ++c)
    {
      reach[c] = std::hypot(radii[0] * frame.Axes[0][c], radii[1] * frame.Axes[1][c]);
    }
    add(frame.Origin, reach);
  }
}

/// Checks the edges of a body: those that its faces, but no faces before them, have.
void STEPCensusTaker::CheckEdges(const CensusBody& body)
{
  Point3 low;
  Point3 high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  std::vector<std::size_t> found;
  for (std::uint32_t s = body.FirstShell; s < body.FirstShell + body.NumberOfShells; ++s)
  {
    const CensusShell& shell = this->Census.Shells[this->Census.ShellUses[s].Shell];
    for (std::uint32_t f = shell.FirstFace; f < shell.FirstFace + shell.NumberOfFaces; ++f)
    {
      const std::uint32_t face = this->Census.FaceUses[f];
      for (std::size_t k = this->FirstEdges[face]; k < this->FirstEdges[face + 1]; ++k)
      {
        found.push_back(k);
        this->AddEdgeExtent(this->Edges[k], low, high);
      }
    }
  }
  // The vertices of a body with one vertex have no extent.
  const double size = found.empty() ? 0.0 : GetLength(Subtract(high, low));
  double uncertainty = 0.0;
  if (body.Context >= 0)
  {
    const CensusContext& context = this->Census.Contexts[body.Context];
    uncertainty = context.Uncertainty / context.Length.Factor;
  }
  const double limit = VertexLimit * size +
    (uncertainty > 0.0 && std::isfinite(uncertainty) ? UncertaintyLimit * uncertainty : 0.0);
  for (const std::size_t k : found)
  {
    const VertexPair& edge = this->Edges[k];
    if (size > 0.0 && !this->GeometricDamage[edge.Edge])
    {
      this->CheckEdge(edge.Edge, edge.Ends, limit);
    }
  }
}

void STEPCensusTaker::CheckEdges()
{
  for (const CensusBody& body : this->Census.Bodies)
  {
    this->CheckEdges(body);
  }
}
}
