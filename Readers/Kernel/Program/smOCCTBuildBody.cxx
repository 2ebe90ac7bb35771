#include "smOCCTBuildBody.h"

#include "smExportTopology.h"
#include "smFormat.h"
#include "smOCCTBuildGeometry.h"
#include "smOCCTFailure.h"
#include "smOCCTOrientVoids.h"

#include "vtkTrimmedNURBSModel.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

namespace sm
{
namespace
{
/// A message states gaps between a face's boundary and its edge above this, relative to the body's size.
constexpr double GapToTell = 1e-5;

double GetDistance(const Vector3& a, const Vector3& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

gp_Pnt ToPoint(const Vector3& p)
{
  return { p[0], p[1], p[2] };
}

class BodyBuilder
{
public:
  BodyBuilder(vtkTrimmedNURBSModel* model, const AffineMap& map)
    : Model(model)
    , Map(map)
    , Scale(map.GetScale())
    , Topology(model)
    , Curves(this->Topology.GetEdges().size())
    , Copies(this->Topology.GetEdges().size())
  {
  }

  BuiltBody Build()
  {
    this->BuildVertices();
    this->Result.Faces.resize(this->Model->GetFaces().size());
    for (std::size_t i = 0; i < this->Result.Faces.size(); ++i)
    {
      this->TryFace(i);
    }
    this->Assemble();
    this->AddGapWarning();
    return std::move(this->Result);
  }

private:
  using EdgeRecord = ExportTopology::EdgeRecord;

  double GetTolerance(double gap) const
  {
    // One per cent is added for points between the samples.
    return std::max(Precision::Confusion(), 1.01 * this->Scale * gap);
  }

  void BuildVertices()
  {
    const BRep_Builder builder;
    for (const ExportTopology::VertexRecord& vertex : this->Topology.GetVertices())
    {
      this->Vertices.emplace_back();
      if (vertex.IsUsed)
      {
        const gp_XYZ p = ToPoint(vertex.Position).XYZ();
        builder.MakeVertex(
          this->Vertices.back(), ToPoint(this->Map.MapPoint(p)), this->GetTolerance(vertex.Reach));
      }
    }
  }

  /// Returns the curve of an edge. That of a degenerate edge is null, with the parameters of the model.
  const BuiltCurve& GetCurve(std::size_t index)
  {
    const Edge& source = *this->Topology.GetEdges()[index].Source;
    if (!source.Degenerate && this->Curves[index].Curve.IsNull())
    {
      this->Curves[index] = BuildCurve(source.Curve, this->Map);
    }
    return this->Curves[index];
  }

  /// Returns the edge, or a copy of it if this face has used it in this direction already.
  TopoDS_Edge GetEdge(std::size_t index, std::size_t copy)
  {
    std::vector<TopoDS_Edge>& copies = this->Copies[index];
    while (copies.size() <= copy)
    {
      const BRep_Builder builder;
      const EdgeRecord& record = this->Topology.GetEdges()[index];
      const Edge& source = *record.Source;
      TopoDS_Edge edge;
      if (source.Degenerate)
      {
        builder.MakeEdge(edge);
        builder.Degenerated(edge, true);
        builder.UpdateEdge(edge, this->GetTolerance(this->Topology.GetVertices()[record.Nodes[0]].Reach));
      }
      else
      {
        const BuiltCurve& curve = this->GetCurve(index);
        builder.MakeEdge(edge, curve.Curve, this->GetTolerance(record.Gap));
        builder.Range(edge, curve.Map(source.Curve.GetStart()), curve.Map(source.Curve.GetEnd()));
      }
      builder.SameRange(edge, true);
      builder.SameParameter(edge, true);
      builder.Add(edge, this->Vertices[record.Nodes[0]].Oriented(TopAbs_FORWARD));
      builder.Add(edge, this->Vertices[record.Nodes[1]].Oriented(TopAbs_REVERSED));
      copies.push_back(edge);
      this->Result.Edges.emplace_back(edge, record.Source);
      this->DoubledEdges += copy > 0 ? 1 : 0;
    }
    return copies[copy];
  }

  void TryFace(std::size_t index)
  {
    const Face& face = *this->Model->GetFaces()[index];
    const std::string problem =
      CatchKernelFailure([&]() { this->Result.Faces[index] = this->BuildFace(face); });
    if (problem.empty())
    {
      return;
    }
    this->Result.Warnings.push_back((face.FileId > 0 ? "Face #" + std::to_string(face.FileId)
                                                     : "Face number " + std::to_string(index + 1)) +
      " is not saved: " + problem + ".");
  }

  struct Use
  {
    /// For the edge forwards and reversed.
    Handle(Geom2d_Curve) Curves[2];
    std::size_t Edge = 0;
  };
  /// A use of an edge, and the number of uses in the same direction before.
  using UseKey = std::pair<const Edge*, std::size_t>;
  struct Uses
  {
    std::map<UseKey, Use> All;
    /// Those of each loop.
    std::vector<std::vector<UseKey>> Loops;
  };

  /// Returns the trim curve on the built surface; nothing if it cannot be carried over.
  Handle(Geom2d_Curve) BuildTrimOn(const BuiltSurface& surface, const Coedge& coedge)
  {
    const BuiltCurve& edge = this->GetCurve(this->Topology.GetEdge(coedge));
    if (!surface.Native)
    {
      return BuildTrim(coedge.Curve, edge);
    }
    if (coedge.Use->Degenerate)
    {
      // Nothing but its ends is given of a curve whose image is a point.
      TrimCurve straight;
      straight.Breaks.push_back(coedge.Curve.GetStart());
      const TrimCurve::Point ends[2] = { MapEnd(surface, coedge.Curve.GetStartPoint()),
        MapEnd(surface, coedge.Curve.GetEndPoint()) };
      straight.AppendPiece(coedge.Curve.GetEnd(), ends, 1);
      return BuildTrim(straight, edge);
    }
    const std::optional<TrimCurve> mapped = MapTrim(coedge.Curve, *surface.Native);
    return mapped ? BuildTrim(*mapped, edge) : nullptr;
  }

  static TrimCurve::Point MapEnd(const BuiltSurface& surface, const TrimCurve::Point& p)
  {
    return surface.Native ? surface.Native->Map(p[0], p[1]) : p;
  }

  /// Builds the trim curves of a face. Returns false if one cannot be carried over. Edges are not changed.
  bool BuildUses(const Face& source, const BuiltSurface& surface, Uses& uses)
  {
    for (const Loop& loop : source.Loops)
    {
      uses.Loops.emplace_back();
      for (const Coedge& coedge : loop.Coedges)
      {
        const int way = IsReversed(coedge, surface) ? 1 : 0;
        auto key = std::make_pair(static_cast<const Edge*>(coedge.Use.get()), std::size_t(0));
        while (!uses.All[key].Curves[way].IsNull())
        {
          ++key.second;
        }
        Use& use = uses.All[key];
        use.Curves[way] = this->BuildTrimOn(surface, coedge);
        use.Edge = this->Topology.GetEdge(coedge);
        uses.Loops.back().push_back(key);
        if (use.Curves[way].IsNull())
        {
          return false;
        }
      }
    }
    return true;
  }

  /// Loops run the other way round where the parameters of the built surface are mirrored.
  static bool IsReversed(const Coedge& coedge, const BuiltSurface& surface)
  {
    return coedge.Reversed != surface.IsMirrored();
  }

  TopoDS_Face BuildFace(const Face& source)
  {
    if (std::optional<BuiltSurface> elementary = BuildElementarySurface(source.Surface, this->Map))
    {
      Uses uses;
      if (!source.Loops.empty() && this->BuildUses(source, *elementary, uses))
      {
        return this->BuildFaceOn(source, *elementary, uses);
      }
    }
    BuiltSurface surface;
    surface.Surface = BuildSurface(source.Surface, this->Map);
    Uses uses;
    this->BuildUses(source, surface, uses);
    return this->BuildFaceOn(source, surface, uses);
  }

  TopoDS_Face BuildFaceOn(const Face& source, const BuiltSurface& surface, Uses& uses)
  {
    const bool reversed = (source.Reversed != this->Map.IsMirrored()) != surface.IsMirrored();
    const TopAbs_Orientation orientation = reversed ? TopAbs_REVERSED : TopAbs_FORWARD;
    if (source.Loops.empty())
    {
      BRepBuilderAPI_MakeFace maker(surface.Surface, Precision::Confusion());
      if (!maker.IsDone())
      {
        throw std::runtime_error("OpenCASCADE finds no borders of its surface");
      }
      return TopoDS::Face(maker.Face().Oriented(orientation));
    }
    const BRep_Builder builder;
    TopoDS_Face face;
    builder.MakeFace(face, surface.Surface, TopLoc_Location(), Precision::Confusion());
    for (const auto& [key, use] : uses.All)
    {
      const TopoDS_Edge edge = this->GetEdge(use.Edge, key.second);
      const double tolerance = BRep_Tool::Tolerance(edge);
      const bool seam = !use.Curves[0].IsNull() && !use.Curves[1].IsNull();
      if (seam)
      {
        builder.UpdateEdge(edge, use.Curves[0], use.Curves[1], surface.Surface, TopLoc_Location(), tolerance);
      }
      else
      {
        builder.UpdateEdge(
          edge, use.Curves[use.Curves[0].IsNull() ? 1 : 0], surface.Surface, TopLoc_Location(), tolerance);
      }
      const EdgeCurve& curve = this->Topology.GetEdges()[use.Edge].Source->Curve;
      const BuiltCurve& built = this->GetCurve(use.Edge);
      builder.Range(
        edge, surface.Surface, TopLoc_Location(), built.Map(curve.GetStart()), built.Map(curve.GetEnd()));
    }
    for (std::size_t l = 0; l < source.Loops.size(); ++l)
    {
      const Loop& loop = source.Loops[l];
      TopoDS_Wire wire;
      builder.MakeWire(wire);
      for (std::size_t i = 0; i < loop.Coedges.size(); ++i)
      {
        const UseKey& key = uses.Loops[l][i];
        const TopoDS_Edge edge = this->Copies[uses.All[key].Edge][key.second];
        builder.Add(
          wire, edge.Oriented(IsReversed(loop.Coedges[i], surface) ? TopAbs_REVERSED : TopAbs_FORWARD));
        if (this->Topology.IsJump(loop, i))
        {
          builder.Add(wire,
            this->BuildJump(loop, i, surface)
              .Oriented(surface.IsMirrored() ? TopAbs_REVERSED : TopAbs_FORWARD));
        }
      }
      wire.Closed(BRep_Tool::IsClosed(wire));
      builder.Add(face, wire);
    }
    return TopoDS::Face(face.Oriented(orientation));
  }

  TopoDS_Edge BuildJump(const Loop& loop, std::size_t i, const BuiltSurface& surface)
  {
    const TrimCurve::Point ends[2] = { MapEnd(surface, ExportTopology::GetEnd(loop.Coedges[i], true)),
      MapEnd(surface, ExportTopology::GetEnd(loop.Coedges[(i + 1) % loop.Coedges.size()], false)) };
    TrimCurve straight;
    straight.Breaks.push_back(0.0);
    straight.AppendPiece(1.0, ends, 1);
    const int node = this->Topology.GetNode(loop.Coedges[i], true);
    const BRep_Builder builder;
    TopoDS_Edge edge;
    builder.MakeEdge(edge);
    builder.Degenerated(edge, true);
    builder.UpdateEdge(edge, BuildTrim(straight, BuiltCurve()), surface.Surface, TopLoc_Location(),
      this->GetTolerance(this->Topology.GetVertices()[node].Reach));
    builder.Range(edge, surface.Surface, TopLoc_Location(), 0.0, 1.0);
    builder.SameRange(edge, true);
    builder.SameParameter(edge, true);
    builder.Add(edge, this->Vertices[node].Oriented(TopAbs_FORWARD));
    builder.Add(edge, this->Vertices[node].Oriented(TopAbs_REVERSED));
    return edge;
  }

  void Assemble()
  {
    const BRep_Builder builder;
    std::vector<std::vector<int>> lists = this->Model->GetShells();
    if (lists.empty())
    {
      lists.emplace_back(this->Result.Faces.size());
      std::iota(lists[0].begin(), lists[0].end(), 0);
    }
    std::vector<TopoDS_Shell> shells;
    for (const std::vector<int>& list : lists)
    {
      TopoDS_Shell shell;
      builder.MakeShell(shell);
      bool any = false;
      for (const int index : list)
      {
        if (index >= 0 && index < static_cast<int>(this->Result.Faces.size()) &&
          !this->Result.Faces[index].IsNull())
        {
          builder.Add(shell, this->Result.Faces[index]);
          any = true;
        }
      }
      if (any)
      {
        shell.Closed(BRep_Tool::IsClosed(shell));
        shells.push_back(shell);
      }
    }
    if (shells.empty())
    {
      return;
    }
    const bool solid = this->Model->GetBody() == vtkTrimmedNURBSModel::SOLID;
    if (solid && this->Model->GetNumberOfOuterShells() == 1 && shells.size() > 1 &&
      shells.size() == lists.size() &&
      std::all_of(shells.begin(), shells.end(), [](const TopoDS_Shell& shell) { return shell.Closed(); }))
    {
      const std::string warning = OrientVoids(shells);
      if (!warning.empty())
      {
        this->Result.Warnings.push_back(warning);
      }
    }
    if (!solid && shells.size() == 1)
    {
      this->Result.Shape = shells[0];
      return;
    }
    TopoDS_Compound compound;
    TopoDS_Solid body;
    TopoDS_Shape& whole = solid ? static_cast<TopoDS_Shape&>(body) : static_cast<TopoDS_Shape&>(compound);
    solid ? builder.MakeSolid(body) : builder.MakeCompound(compound);
    int open = 0;
    for (const TopoDS_Shell& shell : shells)
    {
      builder.Add(whole, shell);
      open += shell.Closed() ? 0 : 1;
    }
    if (solid && open > 0)
    {
      this->Result.Warnings.push_back(
        "The solid is open: not every edge has its two faces. It is saved as it is.");
    }
    this->Result.Shape = whole;
  }

  void AddGapWarning()
  {
    int wide = 0;
    const EdgeRecord* widest = nullptr;
    for (const EdgeRecord& edge : this->Topology.GetEdges())
    {
      if (!edge.Source->Degenerate)
      {
        const std::vector<Vector3>& points = edge.Source->Curve.Coefficients;
        double length = 0.0;
        for (const Vector3& p : points)
        {
          length = std::max(length, GetDistance(p, points.front()));
        }
        length *= this->Scale;
        double& shortest = this->Result.ShortestEdge;
        shortest = shortest == 0.0 ? length : std::min(shortest, length);
        this->Result.Tolerance = std::max(this->Result.Tolerance, this->GetTolerance(edge.Gap));
      }
      wide += edge.Gap > GapToTell * this->Topology.GetSize() ? 1 : 0;
      widest = !widest || edge.Gap > widest->Gap ? &edge : widest;
    }
    if (wide > 0)
    {
      const std::int64_t id = widest->Source->FileId;
      this->Result.Warnings.push_back("Faces lie off " + std::to_string(wide) + " of their edges, by up to " +
        FormatDistance(widest->Gap) + " " + this->Model->GetLengthUnit() +
        (id > 0 ? " at edge #" + std::to_string(id) : std::string()) +
        ". They are saved as they are; programs that heal what they read may change them.");
    }
    if (this->Topology.GetOpenCorners() > 0)
    {
      this->Result.Warnings.push_back(std::to_string(this->Topology.GetOpenCorners()) +
        " corners of loops do not close: their edges end at different vertices, and are saved so.");
    }
    if (this->DoubledEdges > 0)
    {
      this->Result.Warnings.push_back(std::to_string(this->DoubledEdges) +
        " edges that one face uses twice in the same direction are saved twice.");
    }
  }

  vtkTrimmedNURBSModel* Model;
  const AffineMap& Map;
  double Scale;
  ExportTopology Topology;
  /// The curves of the edges that were asked for.
  std::vector<BuiltCurve> Curves;
  /// Each edge, followed by its copies for faces that use it twice in one direction.
  std::vector<std::vector<TopoDS_Edge>> Copies;
  std::vector<TopoDS_Vertex> Vertices;
  int DoubledEdges = 0;
  BuiltBody Result;
};
}

BuiltBody BuildBody(vtkTrimmedNURBSModel* model, const AffineMap& map)
{
  return BodyBuilder(model, map).Build();
}
}
