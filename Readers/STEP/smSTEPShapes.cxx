#include "smSTEPShapes.h"

#include "smCatchFailure.h"
#include "smSTEPEdgeShapes.h"
#include "smSTEPGeometryReading.h"
#include "smSTEPPolygons.h"
#include "smSTEPPropertyAttributes.h"
#include "smSTEPShapeChecks.h"
#include "smSTEPTopologyAttributes.h"
#include "smSTEPTrims.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace sm
{
namespace
{
constexpr STEPAttribute SenseOfShell = { "ORIENTED_CLOSED_SHELL", 1, 3, "orientation" };
constexpr STEPAttribute PolygonOfLoop = { "POLY_LOOP", 0, 1, "polygon" };
constexpr STEPAttribute VertexOfLoop = { "VERTEX_LOOP", 0, 1, "vertex" };

/// Accuracy in millimetres of a file that states none.
constexpr double DefaultPrecision = 1e-4;

using Index = Part21File::Index;
}

/// Makes the shapes of one body.
class STEPShapes::BodyShaper
{
public:
  BodyShaper(STEPShapes& shapes, const CensusBody& body)
    : Shapes(shapes)
    , Entities(shapes.Entities)
    , Body(body)
    , Shared(shapes.GetGeometry(body.Context))
    , Precision(shapes.GetPrecision(body))
    , Trims(this->Entities, this->Shared, this->Precision, shapes.ParameterCurves)
    , EdgeShapes(this->Entities, this->Shared.Edges)
  {
  }

  ShapeGroup Make()
  {
    const STEPCensus& census = this->Shapes.Census;
    const auto solid = std::make_shared<SolidShape>();
    ShapeGroup result;
    const bool isSolid = this->Body.Kind == CensusBodyKind::Solid;
    std::vector<ShellUse>& shells = isSolid ? solid->Shells : result.Shells;
    for (std::uint32_t s = this->Body.FirstShell; s < this->Body.FirstShell + this->Body.NumberOfShells; ++s)
    {
      const CensusShellUse& use = census.ShellUses[s];
      const ShellPointer shell = this->MakeShell(census.Shells[use.Shell]);
      if (!shell)
      {
        continue;
      }
      const Index entity = this->Entities.File.Find(use.Id);
      shells.push_back({ shell, use.Void && this->Entities.Get(entity, SenseOfShell).Text == "F", {} });
      if (!isSolid)
      {
        DescribeShape(this->Body.Id, this->Body.Name, shell->Data);
      }
    }
    this->Shapes.Checks.FinishBody(this->Shapes.GetUncertainty(this->Body));
    if (!solid->Shells.empty())
    {
      DescribeShape(this->Body.Id, this->Body.Name, solid->Data);
      result.Solids.push_back({ solid, false, {} });
    }
    return result;
  }

private:
  using LoopUse = STEPFaceLoop::Use;

  /// Returns the shell of the faces that are made; null if there is none.
  ShellPointer MakeShell(const CensusShell& shell)
  {
    const STEPCensus& census = this->Shapes.Census;
    const int lost = this->NumberOfLostFaces;
    std::vector<std::uint32_t> uses;
    for (std::uint32_t f = shell.FirstFace; f < shell.FirstFace + shell.NumberOfFaces; ++f)
    {
      const CensusFace& face = census.Faces[census.FaceUses[f]];
      if (this->IsReadable(face) && this->JoinVertices(face))
      {
        uses.push_back(f);
      }
      else
      {
        this->Lose(face);
      }
    }
    if (this->Body.Kind == CensusBodyKind::Solid)
    {
      this->JoinEdges(uses);
    }
    const auto result = std::make_shared<ShellShape>();
    for (const std::uint32_t f : uses)
    {
      const FaceUse made = this->TryFace(census.Faces[census.FaceUses[f]]);
      if (made.Face)
      {
        result->Faces.push_back({ made.Face, made.Reversed != census.IsReversedUse[f] });
      }
      else
      {
        this->Lose(census.Faces[census.FaceUses[f]]);
      }
    }
    result->Closed = this->Body.Kind == CensusBodyKind::Solid;
    result->LostFaces = this->NumberOfLostFaces - lost;
    return result->Faces.empty() ? nullptr : result;
  }

  /// Counts a face that is left out, and keeps the reason.
  void Lose(const CensusFace& face)
  {
    ++this->NumberOfLostFaces;
    this->Shapes.LostFaces.Add(
      [&]
      {
        return "Face #" + std::to_string(face.Id) + " of the file is left out: " +
          DescribeCause(this->Entities.File, this->Shapes.Ledger, this->Entities.File.Find(face.Id)) +
          "; export the file again.";
      });
  }

  /// Returns false, with a row, for a face that depends on an entity that no reader may follow.
  bool IsReadable(const CensusFace& face)
  {
    const CensusProblem* peril = this->Shapes.Perils.Find(this->Entities.File.Find(face.Id));
    if (peril)
    {
      this->Shared.AddRow(
        this->Entities.File.Find(peril->Id), GetName(peril->Defect), "faces that depend on it are missing");
    }
    return !peril;
  }

  /// Returns the positions of the ends of an edge of the file.
  std::array<Vector3, 2> GetEnds(const STEPEdge& edge) const
  {
    return edge.IsForward ? std::array<Vector3, 2>{ edge.Start, edge.End }
                          : std::array<Vector3, 2>{ edge.End, edge.Start };
  }

  /// Joins the vertices of the edges of a face that are the same. Returns false if an edge has a row.
  bool JoinVertices(const CensusFace& face)
  {
    for (const STEPFaceLoop& loop : this->Shapes.Loops[face])
    {
      const std::vector<LoopUse>& uses = loop.Uses;
      std::vector<std::array<Vector3, 2>> ends;
      for (const LoopUse& use : uses)
      {
        const STEPEdge* edge = this->Shared.Edges.GetEdge(use.Edge);
        if (!edge)
        {
          return false;
        }
        ends.push_back(this->GetEnds(*edge));
        if (Norm(Subtract(ends.back()[1], ends.back()[0])) <= STEPEdges::SameVertex)
        {
          this->EdgeShapes.JoinVertices(this->EdgeShapes.GetVertexEntity(use.Edge, true),
            this->EdgeShapes.GetVertexEntity(use.Edge, false));
        }
      }
      for (std::size_t i = 0; i < uses.size(); ++i)
      {
        const std::size_t k = (i + 1) % uses.size();
        const Vector3& from = ends[i][uses[i].IsForward ? 1 : 0];
        const Vector3& to = ends[k][uses[k].IsForward ? 0 : 1];
        if (Norm(Subtract(to, from)) <= this->Precision)
        {
          this->EdgeShapes.JoinVertices(this->EdgeShapes.GetVertexEntity(uses[i].Edge, !uses[i].IsForward),
            this->EdgeShapes.GetVertexEntity(uses[k].Edge, uses[k].IsForward));
        }
      }
      if (loop.Kind == STEPFaceLoop::Type::Edges)
      {
        this->Shapes.Checks.AddLoop(loop, this->Shared.Edges);
      }
    }
    return true;
  }

  /// Joins the edges of a closed shell that one face uses each and that lie on each other.
  void JoinEdges(const std::vector<std::uint32_t>& faces)
  {
    const STEPCensus& census = this->Shapes.Census;
    std::vector<Index> edges;
    for (const std::uint32_t f : faces)
    {
      for (const STEPFaceLoop& loop : this->Shapes.Loops[census.Faces[census.FaceUses[f]]])
      {
        for (const LoopUse& use : loop.Uses)
        {
          edges.push_back(use.Edge);
        }
      }
    }
    const STEPJoinedEdges& joints = this->EdgeShapes.JoinEdges(edges, this->Precision);
    if (!joints.Edges.empty())
    {
      this->Shapes.JoinedEdges.Add([&] { return DescribeJoinedEdges(this->Body.Id, joints); });
    }
  }

  /// Reports an edge of the file when it is used first, also one that others stand for.
  void ReportEdge(Index entity, const STEPEdge& edge)
  {
    if (!this->ReportedEdges.insert(entity).second)
    {
      return;
    }
    this->AddDefect(DescribeShortArc(edge));
    if (IsNearlyClosed(edge))
    {
      this->Shapes.ShortArcs.Add([&edge] { return DescribeNearlyClosed(edge); });
    }
    this->Shapes.Extend(edge.Start);
    this->Shapes.Extend(edge.End);
    this->Shapes.Extend(edge.Curve->Evaluate(0.5 * (edge.First + edge.Last)));
  }

  /// Returns a face; null, with a row, if it is not made.
  FaceUse TryFace(const CensusFace& census)
  {
    FaceUse face;
    std::string failure;
    try
    {
      failure = CatchFailure([&] { face = this->MakeFace(census); });
    }
    catch (const STEPGeometryFailure& other)
    {
      failure = other.Reason;
    }
    if (!failure.empty())
    {
      this->Shared.AddRow(this->Entities.File.Find(census.Id), failure, "its solid lacks it");
      face.Face = nullptr;
    }
    return face;
  }

  FaceUse MakeFace(const CensusFace& census)
  {
    const Index entity = this->Entities.File.Find(census.Id);
    const Index surfaceEntity = this->Shapes.GetSurfaceEntity(entity);
    const STEPBodyGeometry::Surface& surface = this->Shared.GetSurface(surfaceEntity);
    if (!surface.Native)
    {
      return {};
    }
    const bool isForward = (this->Entities.Get(entity, SenseOfFace).Text != "F") != surface.IsFlipped;
    const auto face = std::make_shared<FaceShape>();
    face->Surface = this->HasEdges(census) ? surface.Native : STEPBodyGeometry::TakeSelectedPart(surface);
    std::copy(surface.Range, surface.Range + 2, face->Range);
    face->Own = surface.Own;
    for (const STEPFaceLoop& loop : this->Shapes.Loops[census])
    {
      const bool isSame = loop.IsForward == isForward;
      if (loop.Kind == STEPFaceLoop::Type::Vertex)
      {
        this->CheckVertex(loop.Entity, census.Id, surfaceEntity, *surface.Value);
        this->AddVertexLoop(loop.Entity, census.NumberOfBounds == 1, *face);
      }
      else if (loop.Kind == STEPFaceLoop::Type::Polygon)
      {
        face->Bounded = this->Polygons.Add(this->ReadPolygon(loop.Entity), isSame, *face) || face->Bounded;
      }
      else if (loop.Kind == STEPFaceLoop::Type::Other ||
        !this->AddEdgeLoop(loop.Uses, isSame, surfaceEntity, *face))
      {
        this->Shared.AddRow(entity,
          "its loops have edges that are left out, or are of a kind that is not read", "its solid lacks it");
        return {};
      }
      face->Bounded = face->Bounded || loop.Kind == STEPFaceLoop::Type::Edges;
    }
    if (census.NumberOfBounds == 0 && HasNaturalBounds(*face->Surface))
    {
      AddNaturalWires(*face);
    }
    if (surface.Value->IsReversed())
    {
      this->Shapes.ReversedFaces.push_back(census.Id);
    }
    this->AddDefect(
      DescribeWholeTorus(census.Id, this->Entities.File.GetId(surfaceEntity), *surface.Value, face->Bounded));
    DescribeShape(census.Id, this->Entities.Get(entity, NameOfItem).Text, face->Data);
    return { face, !isForward };
  }

  /// Returns false for a face that is bounded by vertices only.
  bool HasEdges(const CensusFace& census) const
  {
    const Part21Range<STEPFaceLoop> loops = this->Shapes.Loops[census];
    return std::any_of(loops.begin(), loops.end(),
      [](const STEPFaceLoop& loop) { return loop.Kind != STEPFaceLoop::Type::Vertex; });
  }

  static bool HasNaturalBounds(const GeometricSurface& surface)
  {
    return FindElementary(surface, ElementarySurface::Type::Sphere) || surface.GetIf<SplineSurface>() ||
      surface.GetIf<RevolvedSurface>();
  }

  /// A sphere, a closed spline surface or a surface of revolution without other bounds is whole; elsewhere
  /// the vertex is a pole, except on a torus.
  void AddVertexLoop(Index loop, bool isOnlyBound, FaceShape& face)
  {
    if (HasNaturalBounds(*face.Surface))
    {
      if (isOnlyBound)
      {
        AddNaturalWires(face);
      }
      return;
    }
    if (FindElementary(*face.Surface, ElementarySurface::Type::Torus) ||
      FindElementary(*face.Surface, ElementarySurface::Type::Plane))
    {
      return;
    }
    const Index entity = this->Entities.Follow(this->Entities.Get(loop, VertexOfLoop));
    CoedgeShape pole;
    pole.Edge = std::make_shared<EdgeShape>();
    pole.Edge->Degenerate = true;
    pole.Edge->Start = pole.Edge->End = this->EdgeShapes.GetVertex(entity, this->ReadVertex(entity));
    face.Wires.push_back({ { pole }, false });
  }

  double GetUnit() const
  {
    const double factor =
      this->Body.Context < 0 ? 1.0 : this->Shapes.Census.Contexts[this->Body.Context].Length.Factor;
    return factor > 0.0 ? factor : 1.0;
  }

  bool AddEdgeLoop(const std::vector<LoopUse>& uses, bool isSame, Index surfaceEntity, FaceShape& face)
  {
    std::unordered_map<Index, int> counts;
    for (const LoopUse& use : uses)
    {
      ++counts[use.Edge];
    }
    WireShape wire;
    wire.Reversed = !isSame;
    for (const LoopUse& use : uses)
    {
      if (!this->AddUse(use, counts[use.Edge], isSame, surfaceEntity, wire))
      {
        return false;
      }
    }
    face.Wires.push_back(std::move(wire));
    return true;
  }

  /// Adds the coedge of a use, or those of the edges that stand for its edge. False if the edge has a row.
  bool AddUse(const LoopUse& use, int count, bool isSame, Index surfaceEntity, WireShape& wire)
  {
    const STEPEdge* edge = this->Shared.Edges.GetEdge(use.Edge);
    if (!edge)
    {
      return false;
    }
    this->ReportEdge(use.Edge, *edge);
    CoedgeShape coedge;
    const bool isForward = use.IsForward == edge->IsForward;
    const std::vector<STEPJoinedEdges::Use>* common = this->EdgeShapes.FindCommon(use.Edge);
    if (!common)
    {
      coedge.Edge = this->EdgeShapes.GetEdge(use.Edge);
      coedge.Reversed = isForward != isSame;
      this->Trims.Add(use.Edge, count, surfaceEntity, coedge);
      wire.Coedges.push_back(std::move(coedge));
      return true;
    }
    for (std::size_t i = 0; i < common->size(); ++i)
    {
      const STEPJoinedEdges::Use& part = (*common)[isForward ? i : common->size() - 1 - i];
      coedge.Edge = this->EdgeShapes.GetCommonEdge(part.Common);
      coedge.Reversed = (isForward != part.IsOpposite) != isSame;
      wire.Coedges.push_back(coedge);
    }
    return true;
  }

  /// Adds a defect, unless it is empty.
  void AddDefect(std::string text)
  {
    if (!text.empty())
    {
      this->Shapes.Defects.push_back(std::move(text));
    }
  }

  /// Reports a loop of one vertex that is not on its sphere or torus, or not the apex of its cone: it is the
  /// only other statement of place and size.
  void CheckVertex(Index loop, std::uint64_t face, Index surfaceEntity, const STEPSurface& surface)
  {
    using Kind = ElementarySurface::Type;
    const auto* native = surface.Value->GetIf<ElementarySurface>();
    if (!native ||
      (native->Kind != Kind::Cone && native->Kind != Kind::Sphere && native->Kind != Kind::Torus))
    {
      return;
    }
    const Index vertex = this->Entities.Follow(this->Entities.Get(loop, VertexOfLoop));
    const Vector3 point = this->ReadVertex(vertex);
    const std::uint64_t id = this->Entities.File.GetId(surfaceEntity);
    if (native->Kind == Kind::Cone)
    {
      this->AddDefect(DescribeApex(face, this->Entities.File.GetId(vertex), id, *native, point));
    }
    else if (IsOffSurface(*native, point))
    {
      this->Shapes.Census.AddProblem(
        CensusDefect::VertexOffSurface, this->Entities.File.GetId(loop), id, "vertex");
    }
  }

  std::vector<Vector3> ReadPolygon(Index loop)
  {
    std::vector<Vector3> points;
    for (const Index point : ReadGeometryList(this->Entities, this->Entities.Get(loop, PolygonOfLoop)))
    {
      points.push_back(ReadGeometryPoint<3>(this->Entities, point, this->GetUnit()));
      this->Shapes.Extend(points.back());
    }
    return points;
  }

  Vector3 ReadVertex(Index vertex) const
  {
    const Index point = this->Entities.Follow(this->Entities.Get(vertex, PointOfVertex));
    return ReadGeometryPoint<3>(this->Entities, point, this->GetUnit());
  }

  STEPShapes& Shapes;
  const STEPAttributes& Entities;
  const CensusBody& Body;
  STEPBodyGeometry& Shared;
  const double Precision;
  STEPTrims Trims;
  STEPEdgeShapes EdgeShapes;
  std::unordered_set<Index> ReportedEdges;
  int NumberOfLostFaces = 0;
  STEPPolygons Polygons;
};

STEPShapes::STEPShapes(const STEPAttributes& entities, STEPCensus& census, STEPLedger& ledger)
  : Entities(entities)
  , Census(census)
  , Ledger(ledger)
  , Perils(entities.File, census)
  , Loops(entities, census)
  , Checks(entities, census)
{
}

STEPShapes::~STEPShapes() = default;

double STEPShapes::GetUncertainty(const CensusBody& body) const
{
  const double stated = body.Context < 0 ? 0.0 : this->Census.Contexts[body.Context].Uncertainty;
  return stated > 0.0 ? stated : 0.0;
}

double STEPShapes::GetPrecision(const CensusBody& body) const
{
  const double stated = this->GetUncertainty(body);
  return stated > 0.0 ? stated : DefaultPrecision;
}

ShapeGroup STEPShapes::MakeBody(const CensusBody& body)
{
  return BodyShaper(*this, body).Make();
}

void STEPShapes::Extend(const Vector3& point)
{
  for (int c = 0; c < 3; ++c)
  {
    this->Low[c] = std::min(this->Low[c], point[c]);
    this->High[c] = std::max(this->High[c], point[c]);
  }
}

void STEPShapes::Report(std::vector<std::string>& messages, std::vector<std::string>& defects) const
{
  defects.insert(defects.end(), this->Defects.begin(), this->Defects.end());
  this->LostFaces.Report(messages);
  this->ShortArcs.Report(messages);
  this->JoinedEdges.Report(messages);
  ReportParameterCurves(this->ParameterCurves, Norm(Subtract(this->High, this->Low)), messages, defects);
}
}
