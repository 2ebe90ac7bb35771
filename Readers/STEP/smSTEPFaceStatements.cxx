#include "smSTEPFaceStatements.h"

#include "smSTEPCurves.h"
#include "smSTEPTopologyAttributes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sm
{
namespace
{
constexpr STEPAttribute SenseOfBound = { "FACE_BOUND", 1, 2, "orientation" };
constexpr STEPAttribute SenseOfOriented = { "ORIENTED_EDGE", 1, 4, "orientation" };
constexpr STEPAttribute SenseOfEdgeCurve = { "EDGE_CURVE", 1, 4, "same sense" };
constexpr STEPAttribute SurfaceOfStatedFace = { "FACE_SURFACE", 0, 2, "surface" };
constexpr STEPAttribute SenseOfFace = { "FACE_SURFACE", 1, 3, "same sense" };
constexpr STEPAttribute PolygonOfLoop = { "POLY_LOOP", 0, 1, "polygon" };
constexpr STEPAttribute VertexOfStatedLoop = { "VERTEX_LOOP", 0, 1, "vertex" };
constexpr STEPAttribute BasisOfTrimmedSurface = { "RECTANGULAR_TRIMMED_SURFACE", 0, 1, "basis surface" };
constexpr STEPAttribute RadiusOfStatedSphere = { "SPHERICAL_SURFACE", 0, 2, "radius" };
constexpr STEPAttribute RadiiOfStatedTorus[] = { { "TOROIDAL_SURFACE", 0, 2, "major radius" },
  { "TOROIDAL_SURFACE", 1, 3, "minor radius" } };
constexpr STEPAttribute ElementOfOrientedFace = { "ORIENTED_FACE", 0, 2, "face" };

constexpr double Pi2 = 2.0 * 3.14159265358979323846;

/// An edge as a face uses it.
struct StatedEdge
{
  bool IsKnown = false;
  Vector3 Ends[2]{};
  LineIntegrals Integrals;
};

class StatementReader
{
public:
  using Index = Part21File::Index;

  StatementReader(const Part21File& file, const STEPCensus& census)
    : File(file)
    , Census(census)
    , Entities(file)
  {
  }

  FaceStatements Read()
  {
    this->FindOrientedFaces();
    for (const CensusBody& body : this->Census.Bodies)
    {
      const bool hasUnit =
        body.Context >= 0 && this->Census.Contexts[body.Context].Length.Status == CensusUnit::State::Stated;
      const double unit = hasUnit ? this->Census.Contexts[body.Context].Length.Factor : 1.0;
      for (std::uint32_t s = body.FirstShell; body.Instances > 0 && s < body.FirstShell + body.NumberOfShells;
           ++s)
      {
        const CensusShell& shell = this->Census.Shells[this->Census.ShellUses[s].Shell];
        for (std::uint32_t f = shell.FirstFace; f < shell.FirstFace + shell.NumberOfFaces; ++f)
        {
          this->ReadFace(this->Census.Faces[this->Census.FaceUses[f]], unit);
        }
      }
    }
    return std::move(this->Result);
  }

private:
  /// The normal of an oriented face may be that of its element or the opposite one: such faces are not known.
  void FindOrientedFaces()
  {
    const std::vector<std::string>& names = this->File.GetTypeNames();
    if (std::find(names.begin(), names.end(), ElementOfOrientedFace.Record) == names.end())
    {
      return;
    }
    for (Index i = 0; i < this->File.GetNumberOfInstances(); ++i)
    {
      std::string_view record;
      if (this->Entities.FindRecord(i, ElementOfOrientedFace.Record, record))
      {
        const Index face = this->Entities.Follow(this->Entities.Get(i, ElementOfOrientedFace));
        this->Result[face == Part21File::None ? 0 : this->File.GetId(face)].Id = 0;
      }
    }
  }

  void ReadFace(const CensusFace& census, double unit)
  {
    const auto [found, isNew] = this->Result.emplace(census.Id, FaceStatement());
    const Index face = this->File.Find(census.Id);
    if (!isNew || face == Part21File::None || this->File.IsDamaged(face))
    {
      return;
    }
    FaceStatement& statement = found->second;
    statement.Id = census.Id;
    statement.IsForward = this->Entities.Get(face, SenseOfFace).Text != "F";
    this->ReadSurface(this->Entities.Follow(this->Entities.Get(face, SurfaceOfStatedFace)), unit, statement);
    this->Vertices.clear();
    this->Parts.clear();
    this->Gaps.clear();
    statement.IsKnown = true;
    for (std::uint32_t b = 0; b < census.NumberOfBounds && statement.IsKnown; ++b)
    {
      const Index bound = this->File.Find(this->Census.Bounds[census.FirstBound + b]);
      statement.IsKnown = bound != Part21File::None && this->ReadBound(bound, statement);
    }
    if (statement.IsKnown && std::isfinite(unit))
    {
      this->Finish(unit, statement);
    }
  }

  void ReadSurface(Index surface, double unit, FaceStatement& statement) const
  {
    std::string_view record;
    if (this->Entities.FindRecord(surface, BasisOfTrimmedSurface.Record, record))
    {
      surface = this->Entities.Follow(this->Entities.Get(surface, BasisOfTrimmedSurface));
    }
    double radii[2] = { 0.0, 0.0 };
    if (this->Entities.FindRecord(surface, RadiusOfStatedSphere.Record, record) &&
      this->Entities.Get(surface, RadiusOfStatedSphere).GetNumber(radii[0]))
    {
      statement.Extent = SurfaceExtent::Closed;
      statement.WholeArea = 2.0 * Pi2 * radii[0] * radii[0] * unit * unit;
    }
    else if ((this->Entities.FindRecord(surface, "TOROIDAL_SURFACE", record) ||
               this->Entities.FindRecord(surface, "DEGENERATE_TOROIDAL_SURFACE", record)) &&
      this->Entities.Get(surface, RadiiOfStatedTorus[0]).GetNumber(radii[0]) &&
      this->Entities.Get(surface, RadiiOfStatedTorus[1]).GetNumber(radii[1]))
    {
      statement.Extent = SurfaceExtent::Closed;
      // With a negative radius the normal is opposite to that of the same torus with the positive one, which
      // is read.
      statement.IsForward = statement.IsForward == (radii[0] >= 0.0);
      // A torus that crosses itself has an apple and a lemon, which together have no more than this area.
      const double major = std::max(std::abs(radii[0]), radii[1]);
      statement.WholeArea = Pi2 * Pi2 * major * radii[1] * unit * unit;
    }
  }

  const StatedEdge& GetEdge(Index edge)
  {
    const auto [found, isNew] = this->Edges.emplace(edge, StatedEdge());
    StatedEdge& result = found->second;
    if (isNew)
    {
      SpaceCurve curve;
      bool isReversed = false;
      const Index start = this->Entities.Follow(this->Entities.Get(edge, StartOfEdge));
      const Index end = this->Entities.Follow(this->Entities.Get(edge, EndOfEdge));
      const bool isForward = this->Entities.Get(edge, SenseOfEdgeCurve).Text != "F";
      result.IsKnown = this->ReadVertexPoint(start, result.Ends[0]) &&
        this->ReadVertexPoint(end, result.Ends[1]) &&
        ReadSTEPCurve(
          this->Entities, this->Entities.Follow(this->Entities.Get(edge, CurveOfEdge)), curve, isReversed) &&
        IntegrateEdge(curve, result.Ends[0], result.Ends[1], isForward != isReversed, result.Integrals) &&
        std::isfinite(result.Integrals.Length);
    }
    return result;
  }

  bool ReadVertexPoint(Index vertex, Vector3& point) const
  {
    return ReadSTEPPoint(
      this->Entities, this->Entities.Follow(this->Entities.Get(vertex, PointOfVertex)), point);
  }

  bool ReadBound(Index bound, FaceStatement& statement)
  {
    const double sense = this->Entities.Get(bound, SenseOfBound).Text == "F" ? -1.0 : 1.0;
    const Index loop = this->Entities.Follow(this->Entities.Get(bound, LoopOfBound));
    std::string_view record;
    if (this->Entities.FindRecord(loop, VertexOfStatedLoop.Record, record))
    {
      ++statement.VertexLoops;
      Vector3 point;
      const bool isRead =
        this->ReadVertexPoint(this->Entities.Follow(this->Entities.Get(loop, VertexOfStatedLoop)), point);
      this->Vertices.push_back(point);
      return isRead;
    }
    ++statement.EdgeLoops;
    if (this->Entities.FindRecord(loop, PolygonOfLoop.Record, record))
    {
      return this->ReadPolygon(loop, sense);
    }
    return this->ReadEdges(loop, sense, statement);
  }

  bool ReadPolygon(Index loop, double sense)
  {
    Part21Values values(this->Entities.Get(loop, PolygonOfLoop).Text);
    const std::size_t first = this->Vertices.size();
    for (Part21Value value; values.Next(value);)
    {
      Vector3 point;
      if (!ReadSTEPPoint(this->Entities, this->Entities.Follow(value), point))
      {
        return false;
      }
      this->Vertices.push_back(point);
    }
    for (std::size_t k = first; k < this->Vertices.size(); ++k)
    {
      this->AddGap(this->Vertices[k], this->Vertices[k + 1 < this->Vertices.size() ? k + 1 : first], sense);
    }
    return this->Vertices.size() > first;
  }

  bool ReadEdges(Index loop, double sense, FaceStatement& statement)
  {
    Part21Values values(this->Entities.Get(loop, EdgesOfLoop).Text);
    bool isFirst = true;
    Vector3 begin{};
    Vector3 at{};
    for (Part21Value value; values.Next(value);)
    {
      const Index oriented = this->Entities.Follow(value);
      const Index edge = this->Entities.Has(oriented, STEPRole::OrientedEdge)
        ? this->Entities.Follow(this->Entities.Get(oriented, EdgeOfOriented))
        : Part21File::None;
      if (!this->Entities.Has(edge, STEPRole::Edge))
      {
        return false;
      }
      const StatedEdge& stated = this->GetEdge(edge);
      if (!stated.IsKnown)
      {
        return false;
      }
      const bool isForward = this->Entities.Get(oriented, SenseOfOriented).Text != "F";
      const Vector3& start = stated.Ends[isForward ? 0 : 1];
      this->Vertices.push_back(start);
      this->Parts.push_back({ &stated.Integrals, stated.Ends[0], isForward ? sense : -sense });
      statement.Uses.push_back({ this->File.GetId(edge), isForward == (sense > 0.0) });
      if (isFirst)
      {
        begin = start;
      }
      else
      {
        statement.LargestGap = std::max(statement.LargestGap, Norm(Subtract(start, at)));
        this->AddGap(at, start, sense);
      }
      isFirst = false;
      at = stated.Ends[isForward ? 1 : 0];
    }
    if (!isFirst)
    {
      statement.LargestGap = std::max(statement.LargestGap, Norm(Subtract(begin, at)));
      this->AddGap(at, begin, sense);
    }
    return !isFirst;
  }

  void AddGap(const Vector3& from, const Vector3& to, double sense)
  {
    if (from != to)
    {
      this->Gaps.push_back({ from, to, sense });
    }
  }

  void Finish(double unit, FaceStatement& statement)
  {
    Vector3 center{};
    for (const Vector3& vertex : this->Vertices)
    {
      for (int c = 0; c < 3; ++c)
      {
        center[c] += vertex[c] / static_cast<double>(this->Vertices.size());
      }
    }
    LineIntegrals sum;
    for (const Part& part : this->Parts)
    {
      sum.Add(*part.Integrals, Subtract(part.Start, center), part.Sign);
    }
    for (const Gap& gap : this->Gaps)
    {
      LineIntegrals segment;
      segment.AddSegment(Subtract(gap.From, center), Subtract(gap.To, center));
      sum.Add(segment, { 0.0, 0.0, 0.0 }, gap.Sign);
    }
    const Matrix3 scale{ Vector3{ unit, 0.0, 0.0 }, Vector3{ 0.0, unit, 0.0 }, Vector3{ 0.0, 0.0, unit } };
    statement.Boundary = sum.Map(scale);
    statement.LargestGap *= unit;
    for (int c = 0; c < 3; ++c)
    {
      statement.Center[c] = unit * center[c];
    }
  }

  struct Part
  {
    const LineIntegrals* Integrals;
    Vector3 Start;
    double Sign;
  };
  struct Gap
  {
    Vector3 From;
    Vector3 To;
    double Sign;
  };

  const Part21File& File;
  const STEPCensus& Census;
  STEPAttributes Entities;
  std::unordered_map<Index, StatedEdge> Edges;
  FaceStatements Result;
  /// Of the face that is being read.
  std::vector<Vector3> Vertices;
  std::vector<Part> Parts;
  std::vector<Gap> Gaps;
};
}

FaceStatements ReadFaceStatements(const Part21File& file, const STEPCensus& census)
{
  return StatementReader(file, census).Read();
}
}
