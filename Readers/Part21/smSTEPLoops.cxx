// Finds loops whose edges run against one another.
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
constexpr STEPAttribute Orientation = { "ORIENTED_EDGE", 1, 4, "orientation" };

constexpr STEPAttribute VertexOfLoop = { "VERTEX_LOOP", 0, 1, "vertex" };
constexpr STEPAttribute PositionOfSurface = { "ELEMENTARY_SURFACE", 0, 1, "position" };
constexpr STEPAttribute RadiusOfSphere = { "SPHERICAL_SURFACE", 0, 2, "radius" };
constexpr STEPAttribute MajorRadiusOfTorus = { "TOROIDAL_SURFACE", 0, 2, "major radius" };
constexpr STEPAttribute MinorRadiusOfTorus = { "TOROIDAL_SURFACE", 1, 3, "minor radius" };

/// Distance of a vertex from the sphere or torus that has no edges, relative to its radius, above which they
/// contradict each other: that of vertices from curves, by the extent.
constexpr double SurfaceLimit = 4e-3;

/// Ends of edges that are closer than this, relative to the extent of the loop's vertices, are connected. A
/// wider gap is detected by the integrals, too.
constexpr double LoopTolerance = 1e-3;

/// An edge of a loop, as the loop runs along it.
struct LoopEdge
{
  std::uint64_t Id = 0;
  Point3 Start{};
  Point3 End{};
  bool Straight = false;
};

/// Finds the indices of the edges that run against the others if the first one is kept, or reversed. Returns
/// false if the edges form no loop in this order.
bool FindReversed(const std::vector<LoopEdge>& edges, double tolerance, bool isFirstReversed,
  std::vector<std::size_t>& reversed)
{
  reversed.clear();
  const Point3& start = isFirstReversed ? edges[0].End : edges[0].Start;
  Point3 at = start;
  for (std::size_t k = 0; k < edges.size(); ++k)
  {
    const LoopEdge& edge = edges[k];
    const bool isReversed = k == 0 ? isFirstReversed : GetDistance(at, edge.Start) > tolerance;
    if (isReversed && GetDistance(at, edge.End) > tolerance)
    {
      return false;
    }
    if (isReversed)
    {
      reversed.push_back(k);
    }
    at = isReversed ? edge.Start : edge.End;
  }
  return GetDistance(at, start) <= tolerance;
}

bool IsChained(const std::vector<LoopEdge>& edges, double tolerance)
{
  std::vector<std::size_t> reversed;
  return FindReversed(edges, tolerance, false, reversed) && reversed.empty();
}
}

bool STEPCensusTaker::ReadVertex(Index vertex, Point3& point)
{
  const Part21Value reference = this->Entities.Get(vertex, PointOfVertex);
  const Part21Value list = this->Entities.Get(this->Entities.Follow(reference), CoordinatesOfPoint);
  Part21Values values(list.Text);
  Part21Value value;
  const bool isKnown = list.IsList() && values.Next(value) && value.GetNumber(point[0]) &&
    values.Next(value) && value.GetNumber(point[1]) && values.Next(value) && value.GetNumber(point[2]);
  if (list.IsList() && !isKnown && !this->GeometricDamage[vertex])
  {
    // OpenCASCADE would dereference the null pointer of a point that it cannot make.
    this->AddPeril(CensusDefect::ValueOutOfRange, vertex, reference.Id, "point without three coordinates");
  }
  return isKnown;
}

/// Returns the curve of an edge, without the pcurves that may accompany it; None if there is none.
STEPCensusTaker::Index STEPCensusTaker::FindSpatialCurve(Index edge) const
{
  const Index curve = this->Entities.Follow(this->Entities.Get(edge, CurveOfEdge));
  std::string_view parameters;
  const bool isOnSurfaces = this->Entities.FindRecord(curve, "SURFACE_CURVE", parameters) ||
    this->Entities.FindRecord(curve, "SEAM_CURVE", parameters) ||
    this->Entities.FindRecord(curve, "INTERSECTION_CURVE", parameters);
  return isOnSurfaces ? this->Entities.Follow(this->Entities.Get(curve, CurveInSpace)) : curve;
}

/// Returns the vertices of an edge, which are read once; null if they cannot be read. The pointer is valid
/// until the next call.
const STEPCensusTaker::VertexPair* STEPCensusTaker::ReadEdge(Index edge)
{
  if (this->EdgePlaces[edge] == None)
  {
    VertexPair found{ edge, {}, false };
    if (!this->ReadVertex(this->Entities.Follow(this->Entities.Get(edge, StartOfEdge)), found.Ends[0]) ||
      !this->ReadVertex(this->Entities.Follow(this->Entities.Get(edge, EndOfEdge)), found.Ends[1]))
    {
      return nullptr;
    }
    std::string_view line;
    found.Straight = this->Entities.FindRecord(this->FindSpatialCurve(edge), "LINE", line);
    this->EdgePlaces[edge] = static_cast<Index>(this->Edges.size());
    this->Edges.push_back(found);
  }
  return &this->Edges[this->EdgePlaces[edge]];
}

void STEPCensusTaker::CheckLoop(Index face, Index loop)
{
  std::vector<LoopEdge> edges;
  Point3 low;
  Point3 high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  Part21Values values(this->Entities.Get(loop, EdgesOfLoop).Text);
  for (Part21Value value; values.Next(value);)
  {
    const Index oriented = this->Entities.Follow(value);
    if (!this->Entities.Has(oriented, STEPRole::OrientedEdge))
    {
      return;
    }
    const Index edge = this->Entities.Follow(this->Entities.Get(oriented, EdgeOfOriented));
    if (!this->Entities.Has(edge, STEPRole::Edge))
    {
      return;
    }
    const VertexPair* const ends = this->ReadEdge(edge);
    if (!ends)
    {
      return;
    }
    LoopEdge found{ this->File.GetId(edge), ends->Ends[0], ends->Ends[1], ends->Straight };
    if (this->Entities.Get(oriented, Orientation).Text == "F")
    {
      std::swap(found.Start, found.End);
    }
    for (const Point3& point : { found.Start, found.End })
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        low[c] = std::min(low[c], point[c]);
        high[c] = std::max(high[c], point[c]);
      }
    }
    edges.push_back(found);
  }
  const double tolerance = LoopTolerance * (edges.empty() ? 0.0 : GetDistance(low, high));
  if (edges.size() < 2 || IsChained(edges, tolerance))
  {
    return;
  }
  // The first edge is kept or reversed, whichever reverses fewer edges in total; if both reverse equally
  // many, either is possible. Edges in another order form one loop, or a gap that the integrals detect.
  std::vector<std::size_t> reversed;
  std::vector<std::size_t> others;
  const bool isLoop = FindReversed(edges, tolerance, false, reversed);
  const bool isOther = FindReversed(edges, tolerance, true, others);
  if (isOther && (!isLoop || others.size() <= reversed.size()))
  {
    reversed = isLoop && others.size() == reversed.size() ? reversed : std::vector<std::size_t>();
    reversed.insert(reversed.end(), others.begin(), others.end());
  }
  else if (!isLoop)
  {
    return;
  }
  // A straight edge has the same points in both directions, but a closed curve has two different parts
  // between two points.
  const auto curved =
    std::find_if(reversed.begin(), reversed.end(), [&edges](std::size_t k) { return !edges[k].Straight; });
  if (curved != reversed.end())
  {
    this->GeometricDamage[face] = true;
    this->Add(CensusDefect::ReversedEdge, loop, edges[*curved].Id, EdgesOfLoop.Name);
  }
  else if (!reversed.empty())
  {
    this->Add(CensusDefect::ReversedLine, loop, edges[reversed.front()].Id, EdgesOfLoop.Name);
  }
}

/// The vertex of a sphere or a torus without edges is the only other statement of its place and size.
void STEPCensusTaker::CheckVertexLoop(Index face, Index loop)
{
  const Index surface = this->Entities.Follow(this->Entities.Get(face, SurfaceOfFace));
  const Index vertex = this->Entities.Follow(this->Entities.Get(loop, VertexOfLoop));
  const Index place = this->Entities.Follow(this->Entities.Get(vertex, PointOfVertex));
  std::string_view record;
  const bool isSphere = this->Entities.FindRecord(surface, RadiusOfSphere.Record, record);
  const bool isTorus = this->Entities.FindRecord(surface, "TOROIDAL_SURFACE", record);
  double major = 0.0;
  double minor = 0.0;
  STEPFrame frame;
  Point3 point;
  if ((!isSphere && !isTorus) || this->GeometricDamage[surface] || place == None ||
    this->GeometricDamage[place] || !this->ReadNumbers(place, CoordinatesOfPoint, point) ||
    !this->Entities.Get(surface, isSphere ? RadiusOfSphere : MinorRadiusOfTorus).GetNumber(minor) ||
    (isTorus && !this->Entities.Get(surface, MajorRadiusOfTorus).GetNumber(major)) ||
    !ReadSTEPFrame(
      this->Entities, this->Entities.Follow(this->Entities.Get(surface, PositionOfSurface)), frame))
  {
    return;
  }
  double height = 0.0;
  double square = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const double away = point[c] - frame.Origin[c];
    height += away * frame.Axes[2][c];
    square += away * away;
  }
  const double radial = std::sqrt(std::max(0.0, square - height * height));
  // A negative major radius stands for the inner part of a torus that crosses itself.
  const double distance = std::abs(std::hypot(radial - major, height) - minor);
  if (distance > SurfaceLimit * (std::abs(major) + minor))
  {
    this->GeometricDamage[face] = true;
    this->Add(CensusDefect::VertexOffSurface, loop, this->File.GetId(surface), "vertex");
  }
}

void STEPCensusTaker::CheckLoops()
{
  this->EdgePlaces.assign(this->File.GetNumberOfInstances(), None);
  for (std::size_t k = 0; k < this->Census.Faces.size(); ++k)
  {
    this->FirstEdges.push_back(this->Edges.size());
    const CensusFace face = this->Census.Faces[k];
    for (std::uint32_t b = 0; b < face.NumberOfBounds; ++b)
    {
      const Index bound = this->File.Find(this->Census.Bounds[face.FirstBound + b]);
      const Index loop =
        bound != None ? this->Entities.Follow(this->Entities.Get(bound, LoopOfBound)) : Part21File::None;
      std::string_view record;
      if (this->Entities.FindRecord(loop, VertexOfLoop.Record, record))
      {
        this->CheckVertexLoop(this->FaceEntities[k], loop);
      }
      else if (this->Entities.Has(loop, STEPRole::Loop))
      {
        this->CheckLoop(this->FaceEntities[k], loop);
      }
    }
  }
  this->FirstEdges.push_back(this->Edges.size());
}
}
