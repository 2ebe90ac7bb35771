#include "Detail/smOffsetGeometry.h"

#include "smUnitRoundoff.h"

#include "vtkMath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
/// Relative error of the sums.
constexpr double FewRoundings = 64.0 * UnitRoundoff;
/// Smallest factor by which a curvature radius is taken to shrink; a face whose radius shrinks more is tight,
/// and named.
constexpr double MinShrink = 0.1;
/// Normals around a point are those of an apex if one less their product with the mean is larger.
constexpr double SharpApex = 4e-4;
/// Rounding of a normal.
constexpr double NormalRounding = 1e-12;
/// Distance of an offset plane from the point where others meet, relative to the offsets.
constexpr double MeetTolerance = 1e-9;
/// Smallest product of normals with their mean direction that bounds how far a vertex moves.
constexpr double MinProduct = 0.05;

/// Returns the point where planes with the corners' normals and offsets meet, by least squares.
bool FindMeetingPoint(const OffsetVertex& vertex, const std::vector<double>& offsets, Vector3& point)
{
  double m[3][3] = {};
  double right[3] = {};
  double largest = 0.0;
  for (const OffsetCorner& corner : vertex.Corners)
  {
    const double t = offsets[corner.Face];
    largest = std::max(largest, std::abs(t));
    for (int i = 0; i < 3; ++i)
    {
      right[i] += t * corner.Normal[i];
      for (int j = 0; j < 3; ++j)
      {
        m[i][j] += corner.Normal[i] * corner.Normal[j];
      }
    }
  }
  if (!(vtkMath::Determinant3x3(m) > TangentSine * TangentSine))
  {
    return false;
  }
  vtkMath::LinearSolve3x3(m, right, point.data());
  return std::all_of(vertex.Corners.begin(), vertex.Corners.end(),
    [&](const OffsetCorner& corner)
    { return std::abs(Dot(corner.Normal, point) - offsets[corner.Face]) <= MeetTolerance * largest; });
}

/// Adds edges and vertices of an offset.
class OffsetEvaluation
{
public:
  OffsetEvaluation(const OffsetGeometry& geometry, const std::vector<double>& areas,
    const std::vector<double>& offsets, OffsetChange& change)
    : Geometry(geometry)
    , Areas(areas)
    , Offsets(offsets)
    , Change(change)
    , Growth(areas.size(), 0.0)
    , IsTight(areas.size(), 0)
    , IsInverted(areas.size(), 0)
  {
  }

  void Run()
  {
    for (std::size_t f = 0; f < this->Areas.size(); ++f)
    {
      this->AddFace(f);
    }
    std::vector<double> edges;
    for (const OffsetEdge& edge : this->Geometry.Edges)
    {
      edges.push_back(this->AddEdge(edge));
    }
    this->FindInverted();
    for (std::size_t f = 0; f < this->Areas.size(); ++f)
    {
      if (this->IsInverted[f] || this->Growth[f] > 0.5 * this->Areas[f])
      {
        this->Change.NarrowFaces.push_back(f);
        this->IsTight[f] = 1;
      }
    }
    // Where strips may overlap otherwise than expected, nothing is certain but their volumes.
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      const auto& faces = this->Geometry.Edges[i].Faces;
      this->Change.Remainder += this->IsTight[faces[0]] || this->IsTight[faces[1]] ? std::abs(edges[i]) : 0.0;
    }
    for (const OffsetVertex& vertex : this->Geometry.Vertices)
    {
      this->AddVertex(vertex);
    }
    this->Change.Second += this->Change.Remainder;
    this->Change.Remainder += FewRoundings * (this->First + this->Change.Second);
    if (!this->Change.UnmetFaces.empty())
    {
      const double nan = std::numeric_limits<double>::quiet_NaN();
      this->Change.Volume = this->Change.Remainder = this->Change.Second = this->Change.Reach = nan;
    }
  }

private:
  /// Finds the faces with an edge that is shorter than its ends move along it, so that it turns around or
  /// vanishes.
  void FindInverted()
  {
    std::vector<double> shorter(this->Geometry.Edges.size(), 0.0);
    for (const OffsetVertex& vertex : this->Geometry.Vertices)
    {
      Vector3 point;
      if (!FindMeetingPoint(vertex, this->Offsets, point))
      {
        continue;
      }
      // Each edge is in two corners, behind one and before the other.
      for (const OffsetCorner& corner : vertex.Corners)
      {
        shorter[corner.Edges[0]] += 0.5 * std::max(-Dot(point, corner.Before), 0.0);
        shorter[corner.Edges[1]] += 0.5 * std::max(Dot(point, corner.Behind), 0.0);
      }
    }
    for (std::size_t i = 0; i < shorter.size(); ++i)
    {
      const OffsetEdge& edge = this->Geometry.Edges[i];
      for (const std::size_t f : edge.Faces)
      {
        this->IsInverted[f] = this->IsInverted[f] || shorter[i] >= edge.Length ? 1 : 0;
      }
    }
  }

  void AddFace(std::size_t f)
  {
    const OffsetFace& face = this->Geometry.Faces[f];
    const double t = this->Offsets[f];
    const double size = std::abs(t);
    const double squared = 0.5 * t * t;
    const double cubed = size * t * t / 3.0;
    const double second = squared * face.Mean;
    const double third = std::copysign(cubed, t) * face.Gauss;
    const double sweep = squared * face.AbsoluteMean + cubed * face.AbsoluteGauss;
    this->First += size * this->Areas[f];
    this->Change.Volume += t * this->Areas[f] + second + third;
    this->Change.Remainder += squared * face.MeanError + cubed * face.GaussError;
    this->Change.Second += sweep;
    this->Change.Reach = std::max(this->Change.Reach, size);
    this->Growth[f] += size * std::abs(face.Mean);
    // Outwards concave curvature decides, inwards convex.
    const double curvature = t > 0.0 ? -face.Smallest : face.Largest;
    if (curvature * size > 1.0 - MinShrink)
    {
      this->Change.TightFaces.push_back(f);
      this->IsTight[f] = 1;
      this->Change.Remainder += sweep + std::abs(second + third);
    }
  }

  /// Returns the volume at the edge.
  double AddEdge(const OffsetEdge& edge)
  {
    const double t[2] = { this->Offsets[edge.Faces[0]], this->Offsets[edge.Faces[1]] };
    const double largest = std::max(std::abs(t[0]), std::abs(t[1]));
    const bool isFlat =
      this->Geometry.Faces[edge.Faces[0]].IsFlat && this->Geometry.Faces[edge.Faces[1]].IsFlat;
    double whole = 0.0;
    double turned = 0.0;
    for (const OffsetEdgeSample& sample : edge.Samples)
    {
      const double half = sample.GetWay();
      // Ways of the edge across both faces.
      double way[2];
      const double step = t[0] - t[1];
      bool isMet = true;
      for (int i = 0; i < 2; ++i)
      {
        const double lead = step == 0.0 ? 0.0 : (i == 0 ? -step : step) / sample.Sine;
        way[i] = t[i] * half + lead;
        isMet = isMet && (step == 0.0 || std::abs(way[i]) <= MaxOffsetWay * largest);
      }
      double volume = 0.5 * (t[0] * way[0] + t[1] * way[1]);
      if (!isMet && std::abs(sample.Sine) > TangentSine)
      {
        // Planes meet there, however far it is.
        isMet = isFlat;
        if (!isMet)
        {
          this->AddUnmet(edge.Faces);
        }
      }
      else if (!isMet)
      {
        // Tangent: a step joins the faces, anywhere near the edge.
        volume = t[0] * t[1] * half;
        this->Change.Remainder += sample.Length * std::abs(step) * (std::abs(t[0]) + std::abs(t[1]));
        way[0] = t[0] * half;
        way[1] = t[1] * half;
      }
      const double reach = std::hypot(largest, std::max(std::abs(way[0]), std::abs(way[1])));
      const double swept = 0.5 * (std::abs(t[0] * way[0]) + std::abs(t[1] * way[1]));
      // Edges that are cut off meet nowhere.
      const bool isCut = std::abs(half) >= MaxOffsetWay;
      const double slope = 1.0 +
        (isCut ? MaxOffsetWay : 1.0 / std::max(std::abs(sample.Sine), std::numeric_limits<double>::min()));
      double rest = sample.Bend * reach * swept;
      for (int i = 0; i < 2; ++i)
      {
        // On planes, and at tangent neighbours, ways are straight or have no length.
        rest += way[i] == 0.0 ? 0.0 : GetCurvature(sample.Across[i], t[i]) * way[i] * way[i] * reach * slope;
        this->Growth[edge.Faces[i]] += sample.Length * std::abs(way[i]);
      }
      turned = std::max(turned, reach * swept);
      whole += sample.Length * volume;
      this->Change.Remainder += sample.Length * rest;
      this->Change.Second += sample.Length * swept;
      this->Change.Reach = std::max(this->Change.Reach, reach);
    }
    this->Change.Volume += whole;
    // A corner of an edge bends it in one point.
    this->Change.Remainder += edge.WayError * largest * largest + (turned > 0.0 ? edge.Turn * turned : 0.0);
    return whole;
  }

  void AddUnmet(const std::array<std::size_t, 2>& faces)
  {
    std::vector<std::size_t>& all = this->Change.UnmetFaces;
    for (const std::size_t f : faces)
    {
      if (std::find(all.begin(), all.end(), f) == all.end())
      {
        all.push_back(f);
      }
    }
  }

  /// Returns no less than a curvature, and than that of the face with an offset.
  static double GetCurvature(double curvature, double offset)
  {
    return curvature / std::max(1.0 - curvature * std::abs(offset), MinShrink);
  }

  void AddApex(double apex, double largest)
  {
    // The cone between the normals, and no more than the ball.
    const double share = std::min(4.0 * (1.0 - apex), 1.0);
    const double reach = largest / std::max(apex, MinProduct);
    this->Change.Remainder +=
      (apex < 1.0 - SharpApex ? 1.0 : share) * 4.0 * vtkMath::Pi() / 3.0 * reach * reach * reach;
    this->Change.Reach = std::max(this->Change.Reach, reach);
  }

  void AddVertex(const OffsetVertex& vertex)
  {
    double largest = 0.0;
    double smallest = std::numeric_limits<double>::infinity();
    // The largest sine between normals that count as one, the smallest between others.
    double same = 0.0;
    double apart = 1.0;
    std::vector<Vector3> normals;
    bool isTight = false;
    for (const OffsetCorner& corner : vertex.Corners)
    {
      const double t = std::abs(this->Offsets[corner.Face]);
      largest = std::max(largest, t);
      smallest = std::min(smallest, t);
      isTight = isTight || this->IsTight[corner.Face];
      bool isNew = true;
      for (const Vector3& normal : normals)
      {
        const double sine = Norm(Cross(normal, corner.Normal));
        const bool isSame = Dot(normal, corner.Normal) > 0.0 && sine <= TangentSine;
        same = isSame ? std::max(same, sine) : same;
        apart = isSame ? apart : std::min(apart, sine);
        isNew = isNew && !isSame;
      }
      if (isNew)
      {
        normals.push_back(corner.Normal);
      }
    }
    const double spread = largest - std::min(smallest, largest);
    this->AddApex(vertex.Apex, largest);
    const double reach = GetReach(vertex, normals, largest);
    const double ball =
      (static_cast<double>(vertex.Corners.size()) + 2.0 * vtkMath::Pi() / 3.0) * reach * reach * reach;
    if (same > NormalRounding)
    {
      // What lies between normals that count as one: sectors with that angle.
      this->Change.Remainder += same * ball;
      this->Change.Reach = std::max(this->Change.Reach, reach);
    }
    if (normals.size() < 3)
    {
      this->Change.Remainder += normals.size() == 2 ? spread * largest * largest : 0.0;
      return;
    }
    Vector3 point;
    if (FindMeetingPoint(vertex, this->Offsets, point))
    {
      double volume = 0.0;
      double size = 0.0;
      for (const OffsetCorner& corner : vertex.Corners)
      {
        const double before = Dot(point, corner.BeforeOut) * Dot(point, corner.Before);
        const double behind = Dot(point, corner.BehindOut) * Dot(point, corner.Behind);
        volume += this->Offsets[corner.Face] * (before - behind) / 6.0;
        size += std::abs(this->Offsets[corner.Face]) * (std::abs(before) + std::abs(behind)) / 6.0;
      }
      this->Change.Volume += volume;
      this->Change.Second += size;
      this->Change.Remainder += vertex.IsPolyhedral && !isTight ? 0.0 : size;
      this->Change.Reach = std::max(this->Change.Reach, Norm(point));
      return;
    }
    if (spread > 0.0 && apart * MaxOffsetWay < 1.0)
    {
      // The faces meet far from there, and nothing says where.
      for (const OffsetCorner& corner : vertex.Corners)
      {
        this->AddUnmet({ corner.Face, corner.Face });
      }
    }
    this->Change.Remainder += ball;
    this->Change.Reach = std::max(this->Change.Reach, reach);
  }

  /// Returns how far a vertex may move by offsets of at most `largest`; `normals` are its different ones.
  static double GetReach(const OffsetVertex& vertex, const std::vector<Vector3>& normals, double largest)
  {
    Vector3 sum{};
    for (const Vector3& normal : normals)
    {
      for (int d = 0; d < 3; ++d)
      {
        sum[d] += normal[d];
      }
    }
    const double size = Norm(sum);
    double product = 1.0;
    for (const OffsetCorner& corner : vertex.Corners)
    {
      product = std::min(product, size > 0.0 ? Dot(corner.Normal, sum) / size : 0.0);
    }
    return largest / std::max(product, MinProduct);
  }

  const OffsetGeometry& Geometry;
  const std::vector<double>& Areas;
  const std::vector<double>& Offsets;
  OffsetChange& Change;
  double First = 0.0;
  /// By how much each face grows or shrinks, and whether strips next to it overlap otherwise than expected.
  std::vector<double> Growth;
  std::vector<char> IsTight;
  std::vector<char> IsInverted;
};
}

OffsetChange EvaluateOffsets(
  const OffsetGeometry& geometry, const std::vector<double>& areas, const std::vector<double>& offsets)
{
  OffsetChange change;
  if (!geometry.IsKnown)
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    change.Volume = change.Remainder = change.Second = change.Reach = nan;
    return change;
  }
  OffsetEvaluation(geometry, areas, offsets, change).Run();
  return change;
}
}
