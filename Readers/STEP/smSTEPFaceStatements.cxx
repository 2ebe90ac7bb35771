#include "smSTEPFaceStatements.h"

#include "smSTEPCurves.h"
#include "smSTEPFrames.h"
#include "smSTEPTopologyAttributes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sm
{
namespace
{
constexpr STEPAttribute SenseOfEdgeCurve = { "EDGE_CURVE", 1, 4, "same sense" };
/// CLOSED_SHELL has no such attribute.
constexpr STEPAttribute SenseOfShell = { "ORIENTED_CLOSED_SHELL", 1, 3, "orientation" };
constexpr STEPAttribute PolygonOfLoop = { "POLY_LOOP", 0, 1, "polygon" };
constexpr STEPAttribute VertexOfStatedLoop = { "VERTEX_LOOP", 0, 1, "vertex" };
constexpr STEPAttribute BasisOfTrimmedSurface = { "RECTANGULAR_TRIMMED_SURFACE", 0, 1, "basis surface" };
constexpr STEPAttribute PlaceOfStatedSurface = { "ELEMENTARY_SURFACE", 0, 1, "position" };
constexpr STEPAttribute RadiusOfStatedSphere = { "SPHERICAL_SURFACE", 0, 2, "radius" };
constexpr STEPAttribute RadiiOfStatedTorus[] = { { "TOROIDAL_SURFACE", 0, 2, "major radius" },
  { "TOROIDAL_SURFACE", 1, 3, "minor radius" } };
constexpr STEPAttribute ElementOfOrientedFace = { "ORIENTED_FACE", 0, 2, "face" };
constexpr STEPAttribute SenseOfOrientedFace = { "ORIENTED_FACE", 1, 3, "orientation" };

/// Vertices of a loop that are closer than this, relative to its extent, are one, as in smSTEPLoops.cxx.
constexpr double SameLoopVertex = 1e-3;

constexpr double Pi2 = 2.0 * 3.14159265358979323846;

/// An edge as a face uses it.
struct StatedEdge
{
  bool IsKnown = false;
  Vector3 Ends[2]{};
  LineIntegrals Integrals;
  bool IsStraight = false;
  bool IsArc = false;
  /// Vector area of the whole curve of an arc, in the direction of the arc.
  Vector3 WholeCurve{};
  /// The curve of an arc, and the parameters between which it lies, in ascending order.
  SpaceCurve Curve;
  double Range[2] = { 0.0, 0.0 };

  double GetRadius() const { return std::max(this->Curve.Radii[0], this->Curve.Radii[1]); }
};

/// Points within this of a curve, relative to its size, are on it.
constexpr double SameCurve = 1e-6;

/// An arc covers what is farther from its ends than this part of it.
constexpr double InnerPart = 1e-2;

double GetParameter(const SpaceCurve& curve, const Vector3& point)
{
  const Vector3 away = Subtract(point, curve.Origin);
  return std::atan2(Dot(away, curve.Axes[1]) / curve.Radii[1], Dot(away, curve.Axes[0]) / curve.Radii[0]);
}

/// Fills in the curve of an arc; `isForward`: the arc has the curve's direction.
void SetArc(const SpaceCurve& curve, bool isForward, StatedEdge& edge)
{
  edge.Curve = curve;
  edge.Range[0] = GetParameter(curve, edge.Ends[isForward ? 0 : 1]);
  edge.Range[1] = GetParameter(curve, edge.Ends[isForward ? 1 : 0]);
  edge.Range[1] += edge.Range[1] <= edge.Range[0] ? Pi2 : 0.0;
}

/// Returns true if `arc` covers a point.
bool IsCovered(const StatedEdge& arc, const Vector3& point)
{
  double t = GetParameter(arc.Curve, point);
  t += Pi2 * std::ceil((arc.Range[0] - t) / Pi2);
  const double margin = InnerPart * (arc.Range[1] - arc.Range[0]);
  return t > arc.Range[0] + margin && t < arc.Range[1] - margin &&
    Norm(Subtract(arc.Curve.Evaluate(t), point)) <= SameCurve * arc.GetRadius();
}

/// Returns true if two arcs of one curve that follow each other in a loop cover the same part of it, and only
/// one of them ends there: the longer one passes a vertex of the other one.
bool Overlap(const StatedEdge& a, const StatedEdge& b)
{
  if (!a.IsArc || !b.IsArc || a.Curve.Radii[0] <= 0.0 || a.Curve.Radii[1] <= 0.0)
  {
    return false;
  }
  const bool isFirstLonger = a.Range[1] - a.Range[0] >= b.Range[1] - b.Range[0];
  const StatedEdge& longer = isFirstLonger ? a : b;
  const StatedEdge& shorter = isFirstLonger ? b : a;
  return IsCovered(longer, shorter.Curve.Evaluate(0.5 * (shorter.Range[0] + shorter.Range[1]))) &&
    (IsCovered(longer, shorter.Ends[0]) || IsCovered(longer, shorter.Ends[1]));
}

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
        const Index use = this->File.Find(this->Census.ShellUses[s].Id);
        const bool isForward = this->Entities.Get(use, SenseOfShell).Text != "F";
        for (std::uint32_t f = shell.FirstFace; f < shell.FirstFace + shell.NumberOfFaces; ++f)
        {
          this->ReadFace(this->Census.Faces[this->Census.FaceUses[f]], unit, isForward);
        }
      }
    }
    return std::move(this->Result);
  }

private:
  /// Finds the faces whose shell uses them with the opposite normal. Faces that are used with both, or
  /// several times, are not known.
  void FindOrientedFaces()
  {
    const std::vector<std::string>& names = this->File.GetTypeNames();
    if (std::find(names.begin(), names.end(), ElementOfOrientedFace.Record) == names.end())
    {
      return;
    }
    std::unordered_map<std::uint64_t, int> uses;
    for (const std::uint32_t use : this->Census.FaceUses)
    {
      ++uses[this->Census.Faces[use].Id];
    }
    for (Index i = 0; i < this->File.GetNumberOfInstances(); ++i)
    {
      std::string_view record;
      if (!this->Entities.FindRecord(i, ElementOfOrientedFace.Record, record))
      {
        continue;
      }
      const Index face = this->Entities.Follow(this->Entities.Get(i, ElementOfOrientedFace));
      const std::uint64_t id = face == Part21File::None ? 0 : this->File.GetId(face);
      const bool isReversed = this->Entities.Get(i, SenseOfOrientedFace).Text == "F";
      if (uses[id] != 1 || !this->Oriented.emplace(id, isReversed).second)
      {
        this->Result[id].Id = 0;
      }
    }
  }

  void ReadFace(const CensusFace& census, double unit, bool isShellForward)
  {
    const auto [found, isNew] = this->Result.emplace(census.Id, FaceStatement());
    const Index face = this->File.Find(census.Id);
    if (!isNew || face == Part21File::None || this->File.IsDamaged(face))
    {
      return;
    }
    FaceStatement& statement = found->second;
    statement.Id = census.Id;
    statement.IsShellForward = isShellForward;
    const auto oriented = this->Oriented.find(census.Id);
    const bool isReversed = oriented != this->Oriented.end() && oriented->second;
    statement.IsForward = (this->Entities.Get(face, SenseOfFace).Text != "F") != isReversed;
    this->ReadSurface(this->Entities.Follow(this->Entities.Get(face, SurfaceOfFace)), unit, statement);
    this->Vertices.clear();
    this->Parts.clear();
    this->Gaps.clear();
    statement.IsKnown = true;
    for (std::uint32_t b = 0; b < census.NumberOfBounds && statement.IsKnown; ++b)
    {
      const Index bound = this->File.Find(this->Census.Bounds[census.FirstBound + b]);
      statement.IsKnown = bound != Part21File::None && this->ReadBound(bound, isReversed, statement);
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
      statement.WholeVolume = statement.WholeArea * radii[0] * unit / 3.0;
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
      if (std::abs(radii[0]) >= radii[1])
      {
        statement.WholeVolume = 0.5 * statement.WholeArea * radii[1] * unit;
      }
      STEPFrame frame;
      const Index place = this->Entities.Follow(this->Entities.Get(surface, PlaceOfStatedSurface));
      if (std::abs(radii[0]) < radii[1] && ReadSTEPFrame(this->Entities, place, frame))
      {
        statement.Spindle = { frame.Origin, frame.Axes[2], unit * std::abs(radii[0]), unit * radii[1] };
        for (double& coordinate : statement.Spindle.Origin)
        {
          coordinate *= unit;
        }
      }
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
      result.IsStraight = curve.Kind == SpaceCurve::Type::Line || curve.Points.size() == 2;
      result.IsArc =
        curve.Kind == SpaceCurve::Type::Ellipse && start != end && result.Ends[0] != result.Ends[1];
      if (result.IsKnown && result.IsArc)
      {
        SetArc(curve, isForward != isReversed, result);
      }
      const Vector3 normal = Cross(curve.Axes[0], curve.Axes[1]);
      const double area =
        0.5 * Pi2 * curve.Radii[0] * curve.Radii[1] * (isForward != isReversed ? 1.0 : -1.0);
      for (int c = 0; c < 3; ++c)
      {
        result.WholeCurve[c] = result.IsArc ? area * normal[c] : 0.0;
      }
    }
    return result;
  }

  bool ReadVertexPoint(Index vertex, Vector3& point) const
  {
    return ReadSTEPPoint(
      this->Entities, this->Entities.Follow(this->Entities.Get(vertex, PointOfVertex)), point);
  }

  bool ReadBound(Index bound, bool isReversed, FaceStatement& statement)
  {
    const double sense = (this->Entities.Get(bound, SenseOfBound).Text == "F") != isReversed ? -1.0 : 1.0;
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
    this->Loop.clear();
    Part21Values values(this->Entities.Get(loop, EdgesOfLoop).Text);
    for (Part21Value value; values.Next(value);)
    {
      const Index oriented = this->Entities.Follow(value);
      const Index edge = this->Entities.Has(oriented, STEPRole::OrientedEdge)
        ? this->Entities.Follow(this->Entities.Get(oriented, EdgeOfOriented))
        : Part21File::None;
      if (!this->Entities.Has(edge, STEPRole::Edge) || !this->GetEdge(edge).IsKnown)
      {
        return false;
      }
      const bool isForward = this->Entities.Get(oriented, SenseOfOriented).Text != "F";
      this->Loop.push_back({ &this->GetEdge(edge), this->File.GetId(edge), isForward });
    }
    this->MendLines();
    for (std::size_t k = 0; k < this->Loop.size(); ++k)
    {
      const LoopUse& use = this->Loop[k];
      const double sign = use.IsForward ? sense : -sense;
      this->Vertices.push_back(use.GetStart());
      this->Parts.push_back({ &use.Edge->Integrals, use.Edge->Ends[0], sign });
      statement.Uses.push_back({ use.Id, sign > 0.0, use.Edge->IsArc });
      for (int c = 0; c < 3; ++c)
      {
        statement.OtherArcs[c] -= sign * use.Edge->WholeCurve[c];
      }
      const LoopUse& next = this->Loop[k + 1 < this->Loop.size() ? k + 1 : 0];
      statement.MaxGap = std::max(statement.MaxGap, Norm(Subtract(next.GetStart(), use.GetEnd())));
      this->AddGap(use.GetEnd(), next.GetStart(), sense);
      if (use.Id != next.Id && Overlap(*use.Edge, *next.Edge))
      {
        statement.Overlap[0] = use.Id;
        statement.Overlap[1] = next.Id;
      }
    }
    return !this->Loop.empty();
  }

  /// Reverses straight edges that run against their loop, if the loop closes then. They have the same points
  /// in both directions, so that the order of the loop is certain.
  void MendLines()
  {
    double size = 0.0;
    for (const LoopUse& use : this->Loop)
    {
      size = std::max(size, Norm(Subtract(use.GetStart(), this->Loop[0].GetStart())));
      size = std::max(size, Norm(Subtract(use.GetEnd(), this->Loop[0].GetStart())));
    }
    const auto meet = [size](const LoopUse& from, const LoopUse& to)
    { return Norm(Subtract(to.GetStart(), from.GetEnd())) <= SameLoopVertex * size; };
    bool isChain = true;
    for (std::size_t k = 0; k < this->Loop.size(); ++k)
    {
      isChain = isChain && meet(this->Loop[k], this->Loop[k + 1 < this->Loop.size() ? k + 1 : 0]);
    }
    std::size_t fewest = this->Loop.size() + 1;
    for (const bool isFirstReversed : { false, true })
    {
      if (isChain || this->Loop.size() < 3 || (isFirstReversed && !this->Loop[0].Edge->IsStraight))
      {
        continue;
      }
      std::vector<LoopUse> mended = this->Loop;
      mended[0].IsForward = mended[0].IsForward != isFirstReversed;
      std::size_t reversed = isFirstReversed ? 1 : 0;
      bool isClosed = true;
      for (std::size_t k = 1; k < mended.size() && isClosed; ++k)
      {
        if (!meet(mended[k - 1], mended[k]) && mended[k].Edge->IsStraight)
        {
          mended[k].IsForward = !mended[k].IsForward;
          ++reversed;
        }
        isClosed = meet(mended[k - 1], mended[k]);
      }
      if (isClosed && meet(mended.back(), mended[0]) && reversed < fewest)
      {
        fewest = reversed;
        this->Mended = std::move(mended);
      }
    }
    if (fewest <= this->Loop.size())
    {
      this->Loop.swap(this->Mended);
    }
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
    statement.MaxGap *= unit;
    for (int c = 0; c < 3; ++c)
    {
      statement.Center[c] = unit * center[c];
      statement.OtherArcs[c] *= unit * unit;
    }
  }

  /// Use of an edge in a loop.
  struct LoopUse
  {
    const StatedEdge* Edge;
    std::uint64_t Id;
    bool IsForward;
    const Vector3& GetStart() const { return this->Edge->Ends[this->IsForward ? 0 : 1]; }
    const Vector3& GetEnd() const { return this->Edge->Ends[this->IsForward ? 1 : 0]; }
  };
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
  /// Faces by their numbers that a shell uses as an oriented face, and whether this reverses them.
  std::unordered_map<std::uint64_t, bool> Oriented;
  FaceStatements Result;
  /// Data of the face that is being read.
  std::vector<Vector3> Vertices;
  std::vector<LoopUse> Loop;
  std::vector<LoopUse> Mended;
  std::vector<Part> Parts;
  std::vector<Gap> Gaps;
};
}

FaceStatements ReadFaceStatements(const Part21File& file, const STEPCensus& census)
{
  return StatementReader(file, census).Read();
}
}
