#include "smSTEPShapes.h"

#include "smFormat.h"
#include "smOCCTFailure.h"
#include "smSTEPGeometryReading.h"
#include "smSTEPPolygons.h"
#include "smSTEPPropertyAttributes.h"
#include "smSTEPTopologyAttributes.h"
#include "smSTEPTrims.h"
#include "smTextEncoding.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace sm
{
namespace
{
constexpr STEPAttribute SenseOfBound = { "FACE_BOUND", 1, 2, "orientation" };
constexpr STEPAttribute SenseOfOriented = { "ORIENTED_EDGE", 1, 4, "orientation" };
constexpr STEPAttribute SurfaceOfFace = { "FACE_SURFACE", 0, 2, "surface" };
constexpr STEPAttribute SenseOfFace = { "FACE_SURFACE", 1, 3, "same sense" };
constexpr STEPAttribute SenseOfShell = { "ORIENTED_CLOSED_SHELL", 1, 3, "orientation" };
constexpr STEPAttribute PolygonOfLoop = { "POLY_LOOP", 0, 1, "polygon" };
constexpr STEPAttribute VertexOfLoop = { "VERTEX_LOOP", 0, 1, "vertex" };

/// Accuracy in millimetres of a file that states none: OpenCASCADE's.
constexpr double DefaultPrecision = 1e-4;

/// Distance of a vertex from the apex of its cone, relative to the cone's size, above which they contradict.
constexpr double ApexLimit = 2e-3;

/// An arc below this part of its radius is not certain.
constexpr double ShortArc = 1e-9;

/// Rounding of coordinates, relative to them.
constexpr double Rounding = 1e-14;

using Index = Part21File::Index;

gp_Pnt ToKernelPoint(const Vector3& p)
{
  return { p[0], p[1], p[2] };
}

std::string GetShapeName(std::string_view text)
{
  std::string name = DecodePart21Text(text);
  return name == "NONE" ? std::string() : name;
}
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
  {
  }

  TopoDS_Shape Make()
  {
    const STEPCensus& census = this->Shapes.Census;
    const bool isSolid = this->Body.Kind == CensusBodyKind::Solid;
    TopoDS_Shape whole;
    if (isSolid)
    {
      TopoDS_Solid solid;
      this->Builder.MakeSolid(solid);
      whole = solid;
    }
    else
    {
      TopoDS_Compound compound;
      this->Builder.MakeCompound(compound);
      whole = compound;
    }
    bool hasFaces = false;
    for (std::uint32_t s = this->Body.FirstShell; s < this->Body.FirstShell + this->Body.NumberOfShells; ++s)
    {
      const CensusShellUse& use = census.ShellUses[s];
      TopoDS_Shape shell = this->MakeShell(census.Shells[use.Shell]);
      if (shell.IsNull())
      {
        continue;
      }
      hasFaces = true;
      const Index entity = this->Entities.File.Find(use.Id);
      if (use.Void && this->Entities.Get(entity, SenseOfShell).Text == "F")
      {
        shell.Reverse();
      }
      if (!isSolid)
      {
        this->Describe(shell, this->Body.Id, this->Body.Name);
      }
      this->Builder.Add(whole, shell);
    }
    if (!hasFaces)
    {
      return {};
    }
    if (isSolid)
    {
      this->Describe(whole, this->Body.Id, this->Body.Name);
    }
    return whole;
  }

private:
  /// An oriented edge of a loop.
  struct LoopUse
  {
    Index Edge;
    bool IsForward;
  };

  void Describe(const TopoDS_Shape& shape, std::uint64_t id, std::string_view name)
  {
    ShapeInfo& info = AddShapeInfo(this->Shapes.Table, shape);
    info.FileId = static_cast<int>(id);
    info.Name = GetShapeName(name);
  }

  /// Returns the shell of the faces that are made; null if there is none.
  TopoDS_Shape MakeShell(const CensusShell& shell)
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
    TopoDS_Shell result;
    this->Builder.MakeShell(result);
    bool hasFaces = false;
    for (const std::uint32_t f : uses)
    {
      TopoDS_Shape made = this->TryFace(census.Faces[census.FaceUses[f]]);
      if (!made.IsNull())
      {
        if (census.IsReversedUse[f])
        {
          made.Reverse();
        }
        this->Builder.Add(result, made);
        hasFaces = true;
      }
      else
      {
        this->Lose(census.Faces[census.FaceUses[f]]);
      }
    }
    result.Closed(this->Body.Kind == CensusBodyKind::Solid);
    if (this->NumberOfLostFaces > lost)
    {
      AddShapeInfo(this->Shapes.Table, result).LostFaces = this->NumberOfLostFaces - lost;
    }
    return hasFaces ? TopoDS_Shape(result) : TopoDS_Shape();
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

  /// Reads the oriented edges of a loop; returns false for a loop of another kind.
  bool ReadLoop(Index loop, std::vector<LoopUse>& uses) const
  {
    std::string_view record;
    if (!this->Entities.FindRecord(loop, EdgesOfLoop.Record, record) &&
      !this->Entities.FindRecord(loop, "EDGE_LOOP", record))
    {
      return false;
    }
    Part21Values values(this->Entities.Get(loop, EdgesOfLoop).Text);
    for (Part21Value value; values.Next(value);)
    {
      const Index oriented = this->Entities.Follow(value);
      const Index edge = this->Entities.Follow(this->Entities.Get(oriented, EdgeOfOriented));
      if (!this->Entities.Has(edge, STEPRole::Edge))
      {
        return false;
      }
      uses.push_back({ edge, this->Entities.Get(oriented, SenseOfOriented).Text != "F" });
    }
    return !uses.empty();
  }

  Index GetVertexEntity(Index edge, bool isStart) const
  {
    return this->Entities.Follow(this->Entities.Get(edge, isStart ? StartOfEdge : EndOfEdge));
  }

  /// Returns the vertex that stands for all that are the same.
  Index FindVertex(Index vertex)
  {
    auto found = this->Joined.find(vertex);
    while (found != this->Joined.end() && found->second != vertex)
    {
      vertex = found->second;
      found = this->Joined.find(vertex);
    }
    return vertex;
  }

  /// Returns the positions of the ends of an edge of the file.
  std::array<Vector3, 2> GetEnds(const STEPEdge& edge) const
  {
    return edge.IsForward ? std::array<Vector3, 2>{ edge.Start, edge.End }
                          : std::array<Vector3, 2>{ edge.End, edge.Start };
  }

  void Join(Index a, Index b)
  {
    a = this->FindVertex(a);
    b = this->FindVertex(b);
    if (a != b)
    {
      this->Joined[std::max(a, b)] = std::min(a, b);
    }
  }

  /// Joins the vertices of the edges of a face that are the same. Returns false if an edge has a row.
  bool JoinVertices(const CensusFace& face)
  {
    for (std::uint32_t b = 0; b < face.NumberOfBounds; ++b)
    {
      const Index bound = this->Entities.File.Find(this->Shapes.Census.Bounds[face.FirstBound + b]);
      std::vector<LoopUse> uses;
      this->ReadLoop(this->Entities.Follow(this->Entities.Get(bound, LoopOfBound)), uses);
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
          this->Join(this->GetVertexEntity(use.Edge, true), this->GetVertexEntity(use.Edge, false));
        }
      }
      for (std::size_t i = 0; i < uses.size(); ++i)
      {
        const std::size_t k = (i + 1) % uses.size();
        const Vector3& from = ends[i][uses[i].IsForward ? 1 : 0];
        const Vector3& to = ends[k][uses[k].IsForward ? 0 : 1];
        if (Norm(Subtract(to, from)) <= this->Precision)
        {
          this->Join(this->GetVertexEntity(uses[i].Edge, !uses[i].IsForward),
            this->GetVertexEntity(uses[k].Edge, uses[k].IsForward));
        }
      }
    }
    return true;
  }

  TopoDS_Vertex GetVertex(Index entity, const Vector3& position)
  {
    TopoDS_Vertex& vertex = this->Vertices[this->FindVertex(entity)];
    if (vertex.IsNull())
    {
      this->Builder.MakeVertex(vertex, ToKernelPoint(position), Precision::Confusion());
    }
    return vertex;
  }

  TopoDS_Edge GetEdge(Index entity)
  {
    TopoDS_Edge& result = this->Edges[entity];
    const STEPEdge* edge = this->Shared.Edges.GetEdge(entity);
    if (!result.IsNull() || !edge)
    {
      return result;
    }
    double range[2];
    const Handle(Geom_Curve) curve = this->Shared.MakeCurve(entity, *edge, range);
    if (curve.IsNull())
    {
      return result;
    }
    this->Builder.MakeEdge(result, curve, Precision::Confusion());
    const Vector3* const ends[2] = { &edge->Start, &edge->End };
    for (int i = 0; i < 2; ++i)
    {
      TopoDS_Vertex vertex =
        this->GetVertex(this->GetVertexEntity(entity, edge->IsForward == (i == 0)), *ends[i]);
      this->Builder.UpdateVertex(vertex, 1.000001 * curve->Value(range[i]).Distance(BRep_Tool::Pnt(vertex)));
      this->Builder.Add(result, vertex.Oriented(i == 0 ? TopAbs_FORWARD : TopAbs_REVERSED));
    }
    this->Builder.Range(result, range[0], range[1]);
    this->CheckArc(*edge);
    this->Shapes.Extend(edge->Start);
    this->Shapes.Extend(edge->End);
    this->Shapes.Extend(edge->Curve->Evaluate(0.5 * (edge->First + edge->Last)));
    this->Describe(result, edge->Id, edge->Name);
    return result;
  }

  /// Returns a face; null, with a row, if it is not made.
  TopoDS_Shape TryFace(const CensusFace& census)
  {
    TopoDS_Shape face;
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
      face.Nullify();
    }
    return face;
  }

  TopoDS_Shape MakeFace(const CensusFace& census)
  {
    const Index entity = this->Entities.File.Find(census.Id);
    const Index surfaceEntity = this->Entities.Follow(this->Entities.Get(entity, SurfaceOfFace));
    const STEPKernelGeometry::Surface& surface = this->Shared.GetSurface(surfaceEntity);
    if (surface.Kernel.IsNull())
    {
      return {};
    }
    const bool isForward = (this->Entities.Get(entity, SenseOfFace).Text != "F") != surface.IsFlipped;
    const Handle(Geom_Surface) kernel = this->HasEdges(census)
      ? surface.Kernel
      : STEPKernelGeometry::TakeSelectedPart(*surface.Value, surface.Kernel);
    TopoDS_Face face;
    this->Builder.MakeFace(face, kernel, Precision::Confusion());
    bool isBounded = false;
    for (std::uint32_t b = 0; b < census.NumberOfBounds; ++b)
    {
      const Index bound = this->Entities.File.Find(this->Shapes.Census.Bounds[census.FirstBound + b]);
      const Index loop = this->Entities.Follow(this->Entities.Get(bound, LoopOfBound));
      const bool isSame = (this->Entities.Get(bound, SenseOfBound).Text != "F") == isForward;
      std::string_view record;
      std::vector<LoopUse> uses;
      if (this->Entities.FindRecord(loop, VertexOfLoop.Record, record))
      {
        this->CheckApex(loop, census.Id, surfaceEntity, *surface.Value);
        this->AddVertexLoop(loop, census.NumberOfBounds == 1, kernel, face);
      }
      else if (this->Entities.FindRecord(loop, PolygonOfLoop.Record, record))
      {
        isBounded = this->Polygons.Add(this->ReadPolygon(loop), isSame, face) || isBounded;
      }
      else if (!this->ReadLoop(loop, uses) || !this->AddEdgeLoop(uses, isSame, surfaceEntity, face))
      {
        this->Shared.AddRow(entity,
          "its loops have edges that are left out, or are of a kind that is not read", "its solid lacks it");
        return {};
      }
      isBounded = isBounded || !uses.empty();
    }
    if (census.NumberOfBounds == 0)
    {
      this->AddNaturalBounds(kernel, face);
    }
    if (surface.Value->IsReversed())
    {
      this->Shapes.ReversedFaces.push_back(census.Id);
    }
    this->CheckTorus(census.Id, surfaceEntity, *surface.Value, isBounded);
    this->Describe(face, census.Id, this->Entities.Get(entity, NameOfItem).Text);
    ShapeInfo& info = AddShapeInfo(this->Shapes.Table, face);
    info.OwnSurface = surface.Own;
    info.Bounded = isBounded;
    face.Orientation(isForward ? TopAbs_FORWARD : TopAbs_REVERSED);
    return face;
  }

  /// Returns false for a face that is bounded by nothing but vertices.
  bool HasEdges(const CensusFace& census) const
  {
    for (std::uint32_t b = 0; b < census.NumberOfBounds; ++b)
    {
      const Index bound = this->Entities.File.Find(this->Shapes.Census.Bounds[census.FirstBound + b]);
      std::string_view record;
      if (!this->Entities.FindRecord(
            this->Entities.Follow(this->Entities.Get(bound, LoopOfBound)), VertexOfLoop.Record, record))
      {
        return true;
      }
    }
    return false;
  }

  static bool HasNaturalBounds(const Handle(Geom_Surface) & surface)
  {
    return surface->IsKind(STANDARD_TYPE(Geom_SphericalSurface)) ||
      surface->IsKind(STANDARD_TYPE(Geom_BSplineSurface)) ||
      surface->IsKind(STANDARD_TYPE(Geom_SurfaceOfRevolution));
  }

  void AddNaturalBounds(const Handle(Geom_Surface) & surface, TopoDS_Face& face)
  {
    if (HasNaturalBounds(surface))
    {
      BRepBuilderAPI_MakeFace natural(surface, Precision::Confusion());
      for (TopoDS_Iterator it(natural.Face()); it.More(); it.Next())
      {
        this->Builder.Add(face, it.Value());
      }
    }
  }

  /// A sphere, a closed spline surface or a surface of revolution without other bounds is whole; elsewhere
  /// the vertex is a pole, except on a torus.
  void AddVertexLoop(Index loop, bool isOnlyBound, const Handle(Geom_Surface) & surface, TopoDS_Face& face)
  {
    if (HasNaturalBounds(surface))
    {
      if (isOnlyBound)
      {
        this->AddNaturalBounds(surface, face);
      }
      return;
    }
    if (surface->IsKind(STANDARD_TYPE(Geom_ToroidalSurface)) || surface->IsKind(STANDARD_TYPE(Geom_Plane)))
    {
      return;
    }
    const Index entity = this->Entities.Follow(this->Entities.Get(loop, VertexOfLoop));
    const TopoDS_Vertex vertex = this->GetVertex(entity, this->ReadVertex(entity));
    TopoDS_Edge edge;
    this->Builder.MakeEdge(edge);
    this->Builder.Add(edge, vertex.Oriented(TopAbs_FORWARD));
    this->Builder.Add(edge, vertex.Oriented(TopAbs_REVERSED));
    this->Builder.Degenerated(edge, true);
    TopoDS_Wire wire;
    this->Builder.MakeWire(wire);
    this->Builder.Add(wire, edge);
    this->Builder.Add(face, wire);
  }

  double GetUnit() const
  {
    const double factor =
      this->Body.Context < 0 ? 1.0 : this->Shapes.Census.Contexts[this->Body.Context].Length.Factor;
    return factor > 0.0 ? factor : 1.0;
  }

  bool AddEdgeLoop(const std::vector<LoopUse>& uses, bool isSame, Index surfaceEntity, TopoDS_Face& face)
  {
    std::unordered_map<Index, int> counts;
    for (const LoopUse& use : uses)
    {
      ++counts[use.Edge];
    }
    TopoDS_Wire wire;
    this->Builder.MakeWire(wire);
    for (const LoopUse& use : uses)
    {
      const TopoDS_Edge edge = this->GetEdge(use.Edge);
      if (edge.IsNull())
      {
        return false;
      }
      const bool isForward = use.IsForward == this->Shared.Edges.GetEdge(use.Edge)->IsForward;
      this->Trims.Add(use.Edge, counts[use.Edge], surfaceEntity, edge, face);
      this->Builder.Add(wire, edge.Oriented(isForward ? TopAbs_FORWARD : TopAbs_REVERSED));
    }
    wire.Closed(BRep_Tool::IsClosed(wire));
    wire.Orientation(isSame ? TopAbs_FORWARD : TopAbs_REVERSED);
    this->Builder.Add(face, wire);
    return true;
  }

  /// Reports a whole torus whose minor radius exceeds the major one.
  void CheckTorus(std::uint64_t face, Index surfaceEntity, const STEPSurface& surface, bool isBounded)
  {
    const auto* torus = surface.Value->GetIf<ElementarySurface>();
    if (torus && torus->Kind == ElementarySurface::Type::Torus && !isBounded &&
      torus->Selected == ElementarySurface::Part::Whole && torus->Radii[1] > std::abs(torus->Radii[0]))
    {
      this->Shapes.Defects.push_back("Face #" + std::to_string(face) +
        " of the file is a whole torus that crosses itself (#" +
        std::to_string(this->Entities.File.GetId(surfaceEntity)) +
        ", its minor radius exceeds the major one): both its outer and its inner part are taken.");
    }
  }

  /// Reports a loop of one vertex that is not the apex of its cone: it is the only other statement of the
  /// cone's size on this side.
  void CheckApex(Index loop, std::uint64_t face, Index surfaceEntity, const STEPSurface& surface)
  {
    const auto* cone = surface.Value->GetIf<ElementarySurface>();
    if (!cone || cone->Kind != ElementarySurface::Type::Cone)
    {
      return;
    }
    const Index vertex = this->Entities.Follow(this->Entities.Get(loop, VertexOfLoop));
    const double height = -cone->Radii[0] / std::tan(cone->Angle);
    Vector3 apex = cone->Frame.Origin;
    for (int c = 0; c < 3; ++c)
    {
      apex[c] += height * cone->Frame.Axes[2][c];
    }
    const double distance = Norm(Subtract(this->ReadVertex(vertex), apex));
    if (!(distance <= ApexLimit * std::max(cone->Radii[0], std::abs(height))))
    {
      this->Shapes.Defects.push_back("Face #" + std::to_string(face) + " of the file: the vertex #" +
        std::to_string(this->Entities.File.GetId(vertex)) + " of its loop is " + FormatDistance(distance) +
        " mm away from the apex of its cone #" + std::to_string(this->Entities.File.GetId(surfaceEntity)) +
        ", which is taken. Export the file again.");
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

  /// Reports an arc between two points that are closer to each other than STEPEdges::SameVertex.
  void CheckArc(const STEPEdge& edge)
  {
    const double distance = Norm(Subtract(edge.End, edge.Start));
    const auto* conic = edge.Curve->GetIf<ConicCurve<3>>();
    if (conic && conic->Kind == ConicCurve<3>::Type::Ellipse && distance > STEPEdges::SameVertex &&
      distance <= ShortArc * conic->Radii[0])
    {
      this->Shapes.Defects.push_back("Edge #" + std::to_string(edge.Id) +
        " of the file is an arc of less than 1e-9 of its radius: its parameters have too few digits.");
    }
    if (conic && distance <= STEPEdges::SameVertex &&
      distance > Rounding * (Norm(edge.Start) + Norm(edge.End)))
    {
      this->Shapes.ShortArcs.Add(
        [&]
        {
          return "Edge #" + std::to_string(edge.Id) +
            " of the file is on a closed curve, between two vertices that are " + FormatDistance(distance) +
            " mm apart: they are taken as one, and the curve as a whole. The short part between them may be "
            "meant.";
        });
    }
  }

  STEPShapes& Shapes;
  const STEPAttributes& Entities;
  const CensusBody& Body;
  STEPKernelGeometry& Shared;
  const double Precision;
  STEPTrims Trims;
  int NumberOfLostFaces = 0;
  BRep_Builder Builder;
  std::unordered_map<Index, Index> Joined;
  std::unordered_map<Index, TopoDS_Vertex> Vertices;
  std::unordered_map<Index, TopoDS_Edge> Edges;
  STEPPolygons Polygons;
};

STEPShapes::STEPShapes(
  const STEPAttributes& entities, const STEPCensus& census, STEPLedger& ledger, ShapeTable& table)
  : Entities(entities)
  , Census(census)
  , Ledger(ledger)
  , Table(table)
  , Perils(entities.File, census)
{
}

STEPShapes::~STEPShapes() = default;

STEPKernelGeometry& STEPShapes::GetGeometry(int context)
{
  std::unique_ptr<STEPKernelGeometry>& geometry = this->Geometries[context];
  if (!geometry)
  {
    STEPUnitSizes units;
    if (context >= 0)
    {
      const CensusContext& stated = this->Census.Contexts[context];
      units.Length = stated.Length.Factor > 0.0 ? stated.Length.Factor : 1.0;
      units.Angle = stated.Angle.Factor > 0.0 ? stated.Angle.Factor : 1.0;
    }
    geometry = std::make_unique<STEPKernelGeometry>(this->Entities, units, this->Ledger);
  }
  return *geometry;
}

double STEPShapes::GetPrecision(const CensusBody& body) const
{
  const double stated = body.Context < 0 ? 0.0 : this->Census.Contexts[body.Context].Uncertainty;
  return stated > 0.0 ? stated : DefaultPrecision;
}

TopoDS_Shape STEPShapes::MakeBody(const CensusBody& body)
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
  ReportParameterCurves(this->ParameterCurves, Norm(Subtract(this->High, this->Low)), messages, defects);
}

std::string STEPShapes::GetLabel(const TopoDS_Shape& shape) const
{
  const auto info = this->Table.find(shape.TShape().get());
  const bool isKnown = info != this->Table.end() && info->second.FileId > 0;
  return isKnown
    ? (shape.ShapeType() == TopAbs_FACE ? "face #" : "shell #") + std::to_string(info->second.FileId)
    : "a shape";
}
}
