#include "Detail/smOffsetParts.h"

#include "smGaussLegendre.h"
#include "smParallelFor.h"
#include "smUnitRoundoff.h"

#include "vtkTrimmedNURBSModel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

namespace sm
{
namespace
{
/// Points of both rules on each piece of an edge.
constexpr int CoarseEdgeNodes = 4;
constexpr int FineEdgeNodes = 8;
/// Half of the step of a difference of tangents, and the way from a pole to the points that normals are taken
/// at, relative to the range of the parameter.
constexpr double TangentStep = 1e-4;
constexpr double PoleStep = 1e-5;
/// Points along a pole.
constexpr int PoleNodes = 12;
/// An edge is straight if its control points are no farther from a line, relative to its length.
constexpr double StraightTolerance = 1e-12;
/// Relative rounding error of the terms of a slope.
constexpr double AreaRounding = 64.0 * UnitRoundoff;
constexpr std::size_t FaceGrain = 8;
constexpr std::size_t FacesBetweenPolls = 1024;
constexpr std::size_t UseGrain = 64;

/// A use of an edge by a face, whose outward normal has the factor Side of that of the face alone.
struct OffsetUse
{
  std::size_t Index = 0;
  const Face* Source = nullptr;
  const Coedge* Boundary = nullptr;
  double Side = 1.0;

  /// Returns the unit normal that the loop runs around counter-clockwise; zero where there is none.
  Vector3 GetLoopNormal(const Point2& at) const
  {
    Vector3 point;
    Vector3 du;
    Vector3 dv;
    this->Source->Surface.Evaluate(at[0], at[1], point.data(), du.data(), dv.data());
    const Vector3 normal = Cross(du, dv);
    return Norm(normal) > 0.0 ? Normalized(normal) : Vector3{};
  }
  /// Returns the factor of that normal which makes it the outward one.
  double GetOutward() const { return (this->Source->Reversed ? -1.0 : 1.0) * this->Side; }
};

Vector3 ScaleBy(double factor, const Vector3& v)
{
  return { factor * v[0], factor * v[1], factor * v[2] };
}

/// Returns the unit tangent of an edge in the direction of a loop; zero where there is none.
Vector3 GetTangent(const Coedge& coedge, double t)
{
  Vector3 velocity;
  coedge.Use->Curve.Evaluate(t, &velocity);
  const double speed = Norm(velocity);
  return speed > 0.0 ? ScaleBy((coedge.Reversed ? -1.0 : 1.0) / speed, velocity) : Vector3{};
}

/// Returns by how much the normal of a face turns across an edge per length, over a step.
double MeasureAcross(const OffsetUse& use, double t, const Vector3& tangent, double step)
{
  const Point2 at = use.Boundary->Curve.Evaluate(t);
  Vector3 point;
  Vector3 du;
  Vector3 dv;
  use.Source->Surface.Evaluate(at[0], at[1], point.data(), du.data(), dv.data());
  const Vector3 normal = Cross(du, dv);
  const double squared = Dot(normal, normal);
  const Vector3 across = Cross(normal, tangent);
  const double size = Norm(across);
  if (!(squared > 0.0) || !(size > 0.0))
  {
    return 0.0;
  }
  const Vector3 unit = ScaleBy(1.0 / size, across);
  const double u = Dot(Cross(unit, dv), normal) / squared;
  const double v = Dot(Cross(du, unit), normal) / squared;
  return Norm(Subtract(use.GetLoopNormal({ at[0] + step * u, at[1] + step * v }),
           use.GetLoopNormal({ at[0] - step * u, at[1] - step * v }))) /
    (2.0 * step);
}

/// Returns the sum of the angles of an edge's corners between pieces; infinity if one is above MaxCrease.
/// Velocities are those of the pieces' ends.
double MeasureTurns(const EdgeCurve& curve)
{
  double sum = 0.0;
  for (int k = 1; k < curve.GetNumberOfPieces(); ++k)
  {
    Vector3 before;
    Vector3 behind;
    curve.GetPiece(k - 1).Evaluate(1.0, &before);
    curve.GetPiece(k).Evaluate(0.0, &behind);
    const double turn = std::atan2(Norm(Cross(before, behind)), Dot(before, behind));
    if (!(turn <= MaxCrease) || !(Norm(before) > 0.0) || !(Norm(behind) > 0.0))
    {
      return std::numeric_limits<double>::infinity();
    }
    sum += turn;
  }
  return sum;
}

/// Evaluates the angle between two faces; false where a normal is missing.
bool EvaluateAngle(const OffsetUse& first, const OffsetUse& second, double t, OffsetEdgeSample& sample)
{
  const Vector3 inLoop = first.GetLoopNormal(first.Boundary->Curve.Evaluate(t));
  const Vector3 a = ScaleBy(first.GetOutward(), inLoop);
  const Vector3 b = ScaleBy(second.GetOutward(), second.GetLoopNormal(second.Boundary->Curve.Evaluate(t)));
  const Vector3 tangent = GetTangent(*first.Boundary, t);
  sample.Cosine = Dot(a, b);
  sample.Sine = std::copysign(Norm(Cross(a, b)), Dot(b, Cross(tangent, inLoop)));
  return Norm(a) > 0.0 && Norm(b) > 0.0 && Norm(tangent) > 0.0;
}

/// Appends samples of an interval of an edge's parameter.
bool AddSamples(const OffsetUse& first, const OffsetUse& second, double start, double end, int nodes,
  std::vector<OffsetEdgeSample>& samples)
{
  const EdgeCurve& curve = first.Boundary->Use->Curve;
  const double* rule = GetRuleTable().data() + static_cast<std::size_t>(nodes) * (nodes - 1);
  bool isKnown = true;
  for (int i = 0; i < nodes; ++i)
  {
    const double t = start + (end - start) * rule[2 * i];
    OffsetEdgeSample sample;
    Vector3 velocity;
    curve.Evaluate(t, &velocity);
    sample.Length = rule[2 * i + 1] * (end - start) * Norm(velocity);
    const double step = TangentStep * (end - start);
    const Vector3 turn =
      Subtract(GetTangent(*first.Boundary, t + step), GetTangent(*first.Boundary, t - step));
    sample.Bend = Norm(velocity) > 0.0 ? Norm(turn) / (2.0 * step * Norm(velocity)) : 0.0;
    isKnown = EvaluateAngle(first, second, t, sample) && isKnown;
    const double across = step * Norm(velocity);
    const Vector3 tangent = GetTangent(*first.Boundary, t);
    sample.Across = { MeasureAcross(first, t, tangent, across), MeasureAcross(second, t, tangent, across) };
    samples.push_back(sample);
  }
  return isKnown;
}

/// Measures an edge between two uses; false if it could not be evaluated.
bool MeasureOffsetEdge(const OffsetUse& first, const OffsetUse& second, OffsetEdge& edge)
{
  const EdgeCurve& curve = first.Boundary->Use->Curve;
  std::vector<double> breaks = curve.Breaks;
  for (const OffsetUse* use : { &first, &second })
  {
    breaks.insert(breaks.end(), use->Boundary->Curve.Breaks.begin(), use->Boundary->Curve.Breaks.end());
  }
  std::sort(breaks.begin(), breaks.end());
  const double smallest = 1e-9 * (curve.GetEnd() - curve.GetStart());
  edge.Faces = { first.Index, second.Index };
  edge.Turn = MeasureTurns(curve);
  std::vector<OffsetEdgeSample> coarse;
  double start = curve.GetStart();
  bool isKnown = true;
  for (const double end : breaks)
  {
    if (end - start > smallest && end <= curve.GetEnd())
    {
      isKnown = AddSamples(first, second, start, end, FineEdgeNodes, edge.Samples) &&
        AddSamples(first, second, start, end, CoarseEdgeNodes, coarse) && isKnown;
      start = end;
    }
  }
  double other = 0.0;
  double ways = 0.0;
  for (const OffsetEdgeSample& sample : coarse)
  {
    other += sample.Length * sample.GetHalfTangent();
    ways += sample.Length * sample.GetWay();
  }
  for (const OffsetEdgeSample& sample : edge.Samples)
  {
    edge.HalfTangent += sample.Length * sample.GetHalfTangent();
    ways -= sample.Length * sample.GetWay();
    edge.Length += sample.Length;
  }
  edge.WayError = 10.0 * std::abs(ways);
  edge.HalfTangentError = 10.0 * std::abs(other - edge.HalfTangent);
  return isKnown && std::isfinite(edge.HalfTangent + other);
}

bool IsStraight(const EdgeCurve& curve)
{
  const Vector3 way = Subtract(curve.GetEndPoint(), curve.GetStartPoint());
  const double length = Norm(way);
  return length > 0.0 &&
    std::all_of(curve.Coefficients.begin(), curve.Coefficients.end(),
      [&](const Vector3& point)
      {
        const Vector3 from = Subtract(point, curve.GetStartPoint());
        return Norm(Cross(from, way)) <= StraightTolerance * length * (length + Norm(point));
      });
}

/// Returns the smallest product of normals around a pole of a face with their mean direction.
double MeasureApex(const OffsetUse& pole)
{
  const TrimCurve& trim = pole.Boundary->Curve;
  const NURBSSurface& surface = pole.Source->Surface;
  std::vector<Vector3> normals;
  Vector3 sum{};
  for (int i = 0; i < PoleNodes; ++i)
  {
    Point2 slope;
    Point2 at =
      trim.Evaluate(trim.GetStart() + (trim.GetEnd() - trim.GetStart()) * (i + 0.5) / PoleNodes, &slope);
    // The face lies to the left of its loops.
    const double sign = pole.Boundary->Reversed ? -1.0 : 1.0;
    const double length = std::hypot(slope[0], slope[1]);
    if (!(length > 0.0))
    {
      return 1.0;
    }
    at[0] -= sign * slope[1] / length * PoleStep * (surface.GetDomainEnd(0) - surface.GetDomainStart(0));
    at[1] += sign * slope[0] / length * PoleStep * (surface.GetDomainEnd(1) - surface.GetDomainStart(1));
    normals.push_back(pole.GetLoopNormal(at));
    for (int d = 0; d < 3; ++d)
    {
      sum[d] += normals.back()[d];
    }
  }
  const double size = Norm(sum);
  double smallest = 1.0;
  for (const Vector3& normal : normals)
  {
    smallest = size > 0.0 ? std::min(smallest, Dot(normal, sum) / size) : 0.0;
  }
  return smallest;
}

/// Collects the uses of edges and the corners of loops.
class OffsetCollector
{
public:
  OffsetCollector(
    const vtkTrimmedNURBSModel& model, const std::vector<signed char>& sides, OffsetGeometry& geometry)
    : Geometry(geometry)
  {
    const std::vector<FacePointer>& faces = model.GetFaces();
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      const double side = sides.empty() ? 1.0 : sides[f];
      for (const Loop& loop : faces[f]->Loops)
      {
        this->AddLoop(loop, { f, faces[f].get(), nullptr, side });
      }
    }
  }

  void MeasureEdges()
  {
    this->Geometry.Edges.resize(this->Edges.size());
    std::vector<char> known(this->Edges.size(), 0);
    ParallelFor(this->Edges.size(), UseGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          const std::vector<OffsetUse>& uses = this->Edges[i];
          known[i] = uses.size() == 2 && MeasureOffsetEdge(uses[0], uses[1], this->Geometry.Edges[i]) ? 1 : 0;
        }
      });
    this->Geometry.IsKnown =
      this->Geometry.IsKnown && std::find(known.begin(), known.end(), 0) == known.end();
    for (const OffsetEdge& edge : this->Geometry.Edges)
    {
      for (const std::size_t f : edge.Faces)
      {
        this->Geometry.Faces[f].IsCreased = this->Geometry.Faces[f].IsCreased || std::isinf(edge.Turn);
      }
    }
  }

private:
  void AddLoop(const Loop& loop, OffsetUse use)
  {
    std::vector<const Coedge*> coedges;
    for (const Coedge& coedge : loop.Coedges)
    {
      use.Boundary = &coedge;
      if (coedge.Use->Degenerate)
      {
        OffsetVertex& vertex = this->GetVertex(coedge.Use->StartVertex);
        vertex.Apex = std::min(vertex.Apex, MeasureApex(use));
        continue;
      }
      coedges.push_back(&coedge);
      const auto [entry, isNew] = this->Places.emplace(coedge.Use.get(), this->Edges.size());
      if (isNew)
      {
        this->Edges.emplace_back();
      }
      this->Edges[entry->second].push_back(use);
    }
    for (std::size_t i = 0; i < coedges.size(); ++i)
    {
      this->AddCorner(use, *coedges[i], *coedges[(i + 1) % coedges.size()]);
    }
  }

  OffsetVertex& GetVertex(const Vector3& position)
  {
    const auto [entry, isNew] = this->VertexPlaces.emplace(position, this->Geometry.Vertices.size());
    if (isNew)
    {
      this->Geometry.Vertices.emplace_back();
    }
    return this->Geometry.Vertices[entry->second];
  }

  void AddCorner(OffsetUse use, const Coedge& before, const Coedge& behind)
  {
    OffsetVertex& vertex = this->GetVertex(before.Reversed ? before.Use->StartVertex : before.Use->EndVertex);
    const auto getNormal = [&use](const Coedge& coedge, bool atEnd)
    {
      const TrimCurve& trim = coedge.Curve;
      const double way = PoleStep * (trim.GetEnd() - trim.GetStart());
      const Vector3 normal = use.GetLoopNormal(trim.Evaluate(atEnd ? trim.GetEnd() : trim.GetStart()));
      // Next to a pole, where there is none.
      return Norm(normal) > 0.0
        ? normal
        : use.GetLoopNormal(trim.Evaluate(atEnd ? trim.GetEnd() - way : trim.GetStart() + way));
    };
    const Vector3 normal = getNormal(before, !before.Reversed);
    OffsetCorner corner;
    corner.Face = use.Index;
    corner.Edges = { this->Places.at(before.Use.get()), this->Places.at(behind.Use.get()) };
    corner.Normal = ScaleBy(use.GetOutward(), normal);
    corner.Before =
      GetTangent(before, before.Reversed ? before.Use->Curve.GetStart() : before.Use->Curve.GetEnd());
    corner.Behind =
      GetTangent(behind, behind.Reversed ? behind.Use->Curve.GetEnd() : behind.Use->Curve.GetStart());
    corner.BeforeOut = Cross(corner.Before, normal);
    corner.BehindOut = Cross(corner.Behind, normal);
    vertex.IsPolyhedral = vertex.IsPolyhedral && this->Geometry.Faces[use.Index].IsFlat &&
      IsStraight(before.Use->Curve) && IsStraight(behind.Use->Curve);
    vertex.Corners.push_back(corner);
    this->Geometry.IsKnown = this->Geometry.IsKnown && Norm(normal) > 0.0;
  }

  OffsetGeometry& Geometry;
  std::vector<std::vector<OffsetUse>> Edges;
  std::unordered_map<const Edge*, std::size_t> Places;
  std::map<Vector3, std::size_t> VertexPlaces;
};
}

OffsetGeometry MeasureOffsets(const vtkTrimmedNURBSModel& model, const std::vector<signed char>& sides,
  const std::function<bool()>& shouldContinue)
{
  const std::vector<FacePointer>& faces = model.GetFaces();
  OffsetGeometry geometry;
  geometry.Faces.resize(faces.size());
  const auto measure = [&](std::size_t first, std::size_t begin, std::size_t end)
  {
    for (std::size_t f = first + begin; f < first + end; ++f)
    {
      OffsetFace& face = geometry.Faces[f];
      face = MeasureOffsetFace(*faces[f]);
      if (!sides.empty() && sides[f] < 0)
      {
        face.Mean = -face.Mean;
        face.Smallest = -face.Smallest;
        face.Largest = -face.Largest;
        std::swap(face.Smallest, face.Largest);
      }
    }
  };
  for (std::size_t first = 0; first < faces.size(); first += FacesBetweenPolls)
  {
    if (shouldContinue && !shouldContinue())
    {
      geometry.IsKnown = false;
      return geometry;
    }
    ParallelFor(std::min(FacesBetweenPolls, faces.size() - first), FaceGrain,
      [&](std::size_t begin, std::size_t end) { measure(first, begin, end); });
  }
  geometry.IsKnown = std::all_of(
    geometry.Faces.begin(), geometry.Faces.end(), [](const OffsetFace& face) { return face.IsKnown; });
  OffsetCollector(model, sides, geometry).MeasureEdges();
  geometry.IsKnown = geometry.IsKnown &&
    std::none_of(
      geometry.Faces.begin(), geometry.Faces.end(), [](const OffsetFace& face) { return face.IsCreased; });
  for (OffsetFace& face : geometry.Faces)
  {
    face.AreaSlope = face.Mean;
    face.AreaSlopeError = face.MeanError + AreaRounding * face.AbsoluteMean;
  }
  for (const OffsetEdge& edge : geometry.Edges)
  {
    // Where a face meets itself both sides move.
    for (const std::size_t f : edge.Faces)
    {
      geometry.Faces[f].AreaSlope += edge.HalfTangent;
      geometry.Faces[f].AreaSlopeError += edge.HalfTangentError + AreaRounding * std::abs(edge.HalfTangent);
    }
  }
  return geometry;
}
}
