#include "smOCCTBody.h"

#include "smCommonParameter.h"
#include "smFormat.h"
#include "smOCCTClosing.h"
#include "smOCCTCompleteLoops.h"
#include "smOCCTEdge.h"
#include "smOCCTFaceDomain.h"
#include "smOCCTFaceInspection.h"
#include "smOCCTFaceTrims.h"
#include "smOCCTFailure.h"
#include "smOCCTNaturalBoundary.h"
#include "smOCCTRounding.h"
#include "smParallelFor.h"
#include "smTrimResidual.h"

#include <Geom_RectangularTrimmedSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace sm
{
namespace
{
/// Loops may lead beyond a trimmed surface by this fraction of its width.
constexpr double Slack = 1e-6;

/// Returns a sentence if loops that cover `box` in the parameters lead beyond the rectangular trimmed surface
/// that the face is on, of which the basis surface is taken; else an empty text.
std::string DescribeOverstep(const DraftFace& face, const NativeBox& box)
{
  const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(face.Stored);
  if (trimmed.IsNull() || face.Loops.empty())
  {
    return {};
  }
  double low[2];
  double high[2];
  trimmed->Bounds(low[0], high[0], low[1], high[1]);
  for (int d = 0; d < 2; ++d)
  {
    const double slack = Slack * (high[d] - low[d]);
    const double period = face.Period[d];
    const double shift = period > 0.0 ? std::ceil((low[d] - slack - box.Low[d]) / period) * period : 0.0;
    if (box.Low[d] + shift < low[d] - slack || box.High[d] + shift > high[d] + slack)
    {
      return std::string("Its loops lead beyond its RECTANGULAR_TRIMMED_SURFACE in ") + (d == 0 ? "u" : "v") +
        "; the surface is taken without its borders.";
    }
  }
  return {};
}

const ShapeInfo& Find(const ShapeTable& table, const TopoDS_Shape& shape)
{
  static const ShapeInfo none;
  const auto found = table.find(shape.TShape().get());
  return found == table.end() ? none : found->second;
}

std::string Label(const char* kind, int fileId, std::size_t index)
{
  return fileId > 0 ? std::string(kind) + " #" + std::to_string(fileId)
                    : std::string(kind) + " number " + std::to_string(index + 1) + " of its body";
}

class BodyConverter
{
public:
  BodyConverter(const TopoDS_Shape& shape, const gp_Trsf& trsf, double unit, const double origin[3],
    const ShapeTable& table, const ProgressCallback& progress, int roundings)
    : Shape(shape)
    , Place{ trsf, unit, { origin[0], origin[1], origin[2] } }
    , Table(table)
    , Report(progress)
    , Roundings(roundings)
  {
  }

  ConvertedBody Convert()
  {
    this->Collect();
    this->Edges.resize(this->EdgeShapes.Extent());
    this->Run(
      this->EdgeShapes.Extent(), [this](std::size_t i) { this->ConvertEdge(i); }, "Edge", 0.0);
    this->Size = MeasureSize(this->Edges);
    this->Faces.resize(this->Drafts.size());
    this->Run(
      this->Drafts.size(), [this](std::size_t i) { this->ConvertFace(i); }, "Face", EdgeShare);
    if (this->Result.Aborted)
    {
      ConvertedBody nothing;
      nothing.Aborted = true;
      return nothing;
    }
    this->Gather();
    return std::move(this->Result);
  }

private:
  /// Fraction of the progress for the edges.
  static constexpr double EdgeShare = 0.3;
  /// Number of edges or faces between two reports of progress.
  static constexpr std::size_t Chunk = 256;

  void Collect()
  {
    const auto add = [this](const TopoDS_Shape& face, std::vector<int>& shell)
    {
      if (face.Orientation() != TopAbs_FORWARD && face.Orientation() != TopAbs_REVERSED)
      {
        return;
      }
      DraftFace draft;
      const std::string failure = CatchFailure(
        [&]
        {
          const ShapeInfo& info = Find(this->Table, face);
          draft = CollectFace(TopoDS::Face(face), this->EdgeShapes,
            info.AsInFile ? MissingTrim::Feet : MissingTrim::Approximated);
          if (draft.Loops.empty() && info.Bounded)
          {
            throw std::runtime_error("OpenCASCADE made nothing of the edges that bound it");
          }
        });
      if (!failure.empty())
      {
        this->Result.Messages.push_back(Label("Face", Find(this->Table, face).FileId, this->Drafts.size()) +
          " is left out: " + failure + ".");
        ++this->Result.MissingFaces;
        return;
      }
      shell.push_back(static_cast<int>(this->Drafts.size()));
      this->Drafts.push_back(std::move(draft));
    };
    for (TopExp_Explorer shells(this->Shape, TopAbs_SHELL); shells.More(); shells.Next())
    {
      const int lost = Find(this->Table, shells.Current()).LostFaces;
      if (lost > 0)
      {
        this->Result.MissingFaces += lost;
        this->Result.Messages.push_back(std::to_string(lost) +
          " faces of the file are not here: they are damaged, or OpenCASCADE made nothing of them.");
      }
      std::vector<int> shell;
      for (TopExp_Explorer faces(shells.Current(), TopAbs_FACE); faces.More(); faces.Next())
      {
        add(faces.Current(), shell);
      }
      this->Shells.push_back(shell);
    }
    std::vector<int> loose;
    for (TopExp_Explorer faces(this->Shape, TopAbs_FACE, TopAbs_SHELL); faces.More(); faces.Next())
    {
      add(faces.Current(), loose);
    }
    if (!loose.empty())
    {
      this->Shells.push_back(loose);
    }
    this->FirstUse.assign(this->EdgeShapes.Extent(), { nullptr, nullptr });
    for (const DraftFace& face : this->Drafts)
    {
      for (const DraftLoop& loop : face.Loops)
      {
        for (const DraftCoedge& coedge : loop)
        {
          auto& use = this->FirstUse[coedge.EdgeIndex];
          use = use.first ? use : std::make_pair(&face, &coedge);
        }
      }
    }
  }

  /// Calls convert(i) for all i on the application's threads. An edge or face for which it throws is left
  /// out, and a message reports why.
  template <class Work>
  void Run(std::size_t count, const Work& convert, const char* kind, double done)
  {
    const double share = *kind == 'E' ? EdgeShare : 1.0 - EdgeShare;
    std::vector<std::string> failures(count);
    for (std::size_t start = 0; start < count && !this->Result.Aborted; start += Chunk)
    {
      const std::size_t stop = std::min(count, start + Chunk);
      ParallelFor(stop - start, 16,
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t i = start + begin; i < start + end; ++i)
          {
            failures[i] = CatchFailure([&] { convert(i); });
          }
        });
      this->Result.Aborted = this->Report && !this->Report(done + share * stop / count);
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      if (!failures[i].empty())
      {
        const TopoDS_Shape& shape = *kind == 'E' ? this->EdgeShapes(static_cast<int>(i) + 1)
                                                 : static_cast<const TopoDS_Shape&>(this->Drafts[i].Face);
        this->Result.Messages.push_back(
          Label(kind, Find(this->Table, shape).FileId, i) + " is left out: " + failures[i] + ".");
        this->Result.MissingFaces += *kind == 'F' ? 1 : 0;
      }
    }
  }

  void ConvertEdge(std::size_t index)
  {
    const TopoDS_Edge edge = TopoDS::Edge(this->EdgeShapes(static_cast<int>(index) + 1));
    const auto& [face, coedge] = this->FirstUse[index];
    this->Edges[index] = ConvertEdgeShape(edge, Find(this->Table, edge), this->Place, *face, *coedge);
  }

  /// Returns the trim curves of coedges without a pcurve: the edge's curve projected onto the plane. Entries
  /// of other coedges are empty.
  std::vector<std::vector<TrimCurve>> ProjectTrims(const DraftFace& draft, const AffineMap& map) const
  {
    std::vector<std::vector<TrimCurve>> trims(draft.Loops.size());
    bool any = draft.Loops.empty();
    for (std::size_t l = 0; l < draft.Loops.size(); ++l)
    {
      for (const DraftCoedge& coedge : draft.Loops[l])
      {
        const auto edge = coedge.EdgeIndex >= 0 ? this->Edges[coedge.EdgeIndex] : nullptr;
        any = any || edge != nullptr;
        trims[l].push_back(coedge.Projected && edge ? ProjectOnPlane(draft, map, edge->Curve) : TrimCurve());
      }
    }
    if (!any)
    {
      throw std::runtime_error("none of its edges could be carried over");
    }
    return trims;
  }

  /// Takes the loops that were completed when the face was inspected, unless it has another placement.
  void CompleteFace(const DraftFace& inspected, DraftFace& draft) const
  {
    if (!inspected.Face.IsEqual(draft.Face))
    {
      const double any = std::numeric_limits<double>::infinity();
      std::string problem =
        inspected.TurnedEdges > 0 ? InspectFace(draft, gp_Pnt(), any, any).Problem : CompleteLoops(draft);
      if (problem.empty() && inspected.HasNaturalBoundary && !draft.HasNaturalBoundary &&
        !AddNaturalBoundary(draft))
      {
        problem = "its surface has no boundary that could be added";
      }
      if (!problem.empty())
      {
        throw std::runtime_error(problem);
      }
      return;
    }
    draft.Surface = inspected.Surface;
    std::copy(inspected.Period, inspected.Period + 2, draft.Period);
    std::copy(inspected.Low, inspected.Low + 2, draft.Low);
    std::copy(inspected.High, inspected.High + 2, draft.High);
    std::copy(inspected.EndsAtPole, inspected.EndsAtPole + 2, draft.EndsAtPole);
    draft.IsEitherPart = inspected.IsEitherPart;
    draft.Loops = inspected.Loops;
    draft.AddedEdges = inspected.AddedEdges;
    for (DraftLoop& loop : draft.Loops)
    {
      for (DraftCoedge& coedge : loop)
      {
        if (coedge.EdgeIndex >= 0)
        {
          coedge.EdgeIndex = this->EdgeShapes.FindIndex(coedge.Edge.Oriented(TopAbs_FORWARD)) - 1;
          if (coedge.EdgeIndex < 0)
          {
            throw std::runtime_error("its edges are not those that were inspected");
          }
        }
      }
    }
  }

  void ConvertFace(std::size_t index)
  {
    DraftFace& draft = this->Drafts[index];
    const ShapeInfo& info = Find(this->Table, draft.Face);
    if (draft.AsInFile)
    {
      this->CompleteFace(*info.AsInFile, draft);
    }
    else
    {
      OrderLoops(draft);
      ShiftLoops(draft);
    }
    for (DraftLoop& loop : draft.Loops)
    {
      for (DraftCoedge& coedge : loop)
      {
        if (!coedge.Projected && coedge.Trim.GetLine().IsNull())
        {
          coedge.Trim.Samples = coedge.Trim.Sample();
        }
      }
    }
    const AffineMap map = this->Place.MakeMap(draft.Location);
    std::vector<std::vector<TrimCurve>> trims = this->ProjectTrims(draft, map);
    const NativeBox box = GetCoveredBox(draft, trims);
    const std::string overstep = DescribeOverstep(draft, box);
    if (!overstep.empty())
    {
      draft.Messages.push_back(overstep);
    }
    if (LeavesDomain(draft, box))
    {
      draft.Messages.push_back(
        "The curves of its edges in its parameters lead beyond a pole of its surface; export it again "
        "without such curves.");
      ++draft.Defects;
    }
    if (draft.IsEitherPart)
    {
      draft.Messages.push_back(
        "Its surface of revolution has two parameters with opposite normals at every point, "
        "and either gives a solid: one is taken. Export it with parameter curves.");
      ++draft.Defects;
    }
    if (draft.HasSeveralParts)
    {
      draft.Messages.push_back(
        "Its surface of revolution crosses its own axis, and its edges do not state which "
        "part of it is the face: one is taken. Export it with edges that bound it.");
      ++draft.Defects;
    }
    const Handle(Geom_Surface) own =
      info.OwnSurface.Surface.IsNull() ? nullptr : CoverBox(info.OwnSurface, draft.Surface, box);
    const Handle(Geom_Surface)& source = own.IsNull() ? draft.Surface : own;
    ConvertedSurface surface = ConvertSurface(source, box, map);

    auto face = std::make_shared<Face>();
    face->Id = NewId();
    face->FileId = info.FileId;
    face->Name = info.Name;
    face->Color = info.Color;
    face->Reversed = draft.Reversed != map.IsMirrored();
    face->Messages = draft.Messages;
    ConvertedFace& result = this->Faces[index];
    const std::vector<std::shared_ptr<const Edge>> added =
      MakeAddedEdges(draft, map, this->Place.MakeMap(gp_Trsf()), this->Place.GetLargestOrigin());
    for (std::size_t l = 0; l < draft.Loops.size(); ++l)
    {
      this->ConvertLoop(draft, draft.Loops[l], added, surface, box, trims[l], *face, result);
    }
    face->Surface = std::move(surface.Surface);
    // The unit of the file's own surface is converted by one more factor.
    face->Surface.Rounding = GetReadingRounding(
      source, box, map, this->Place.Origin, this->Roundings + (own.IsNull() ? 0 : 2), face->Surface);
    for (double& rounding : face->Surface.Rounding)
    {
      // The control points of a face that crosses the seam are those that OpenCASCADE moved.
      rounding += own.IsNull() ? info.OwnSurface.Distance * map.GetScale() : 0.0;
    }
    for (DraftLoop& loop : draft.Loops)
    {
      for (DraftCoedge& coedge : loop)
      {
        coedge.Trim.Samples = {};
      }
    }
    CheckClosing(this->Place.Unit, this->Size, draft, *face);
    result.Defects = draft.Defects;
    result.Source = draft.Face;
    for (int d = 0; d < 2; ++d)
    {
      result.Map[d] = surface.Map[d];
      result.Period[d] = draft.Period[d];
    }
    result.Result = face;
  }

  /// Appends a loop to `face`, and its edges to the source edges of `result`.
  void ConvertLoop(DraftFace& draft, const DraftLoop& draftLoop,
    const std::vector<std::shared_ptr<const Edge>>& added, const ConvertedSurface& surface,
    const NativeBox& box, std::vector<TrimCurve>& projected, Face& face, ConvertedFace& result) const
  {
    const std::vector<double> knots[2] = { surface.Surface.GetSpanBreaks(0),
      surface.Surface.GetSpanBreaks(1) };
    const double width[2] = { box.High[0] - box.Low[0], box.High[1] - box.Low[1] };
    Loop loop;
    std::vector<TopoDS_Edge> sources;
    for (std::size_t i = 0; i < draftLoop.size(); ++i)
    {
      const DraftCoedge& from = draftLoop[i];
      Coedge coedge;
      coedge.Use = from.EdgeIndex >= 0 ? this->Edges[from.EdgeIndex] : added[-1 - from.EdgeIndex];
      if (!coedge.Use)
      {
        face.Messages.push_back("An edge could not be carried over; its loop is closed by a straight line.");
        ++draft.Defects;
        continue;
      }
      coedge.Reversed = from.Reversed;
      coedge.Curve = from.Projected ? std::move(projected[i])
                                    : ConvertTrim(from.Trim, coedge.Use->Curve.GetStart(),
                                        coedge.Use->Curve.GetEnd(), surface.Map, width);
      if (from.Trim.Residual[0] + from.Trim.Residual[1] > 0.0 ||
        (from.Trim.Feet && coedge.Curve.GetLargestResidual() > 1e-12))
      {
        LowerResidual(surface.Surface, coedge.Use->Curve, coedge.Curve);
      }
      SnapToKnots(knots, coedge.Curve);
      if (!coedge.Use->Degenerate && !from.Projected)
      {
        const StepResult step = RestoreCommonParameter(
          surface.Surface, coedge.Use->Curve, this->Size, GetTrimTolerance(surface.Map, width), coedge.Curve);
        result.RestoredCoedges += step == StepResult::Restored ? 1 : 0;
        result.LaggingCoedges += step == StepResult::Failed ? 1 : 0;
      }
      loop.Coedges.push_back(std::move(coedge));
      sources.push_back(from.Edge);
    }
    if (!loop.Coedges.empty())
    {
      result.SourceEdges.push_back(std::move(sources));
      face.Loops.push_back(std::move(loop));
    }
  }

  void CheckVertices()
  {
    for (std::size_t i = 0; i < this->Edges.size(); ++i)
    {
      const auto& edge = this->Edges[i];
      if (!edge || edge->Degenerate)
      {
        continue;
      }
      const double gap = GetVertexGap(*edge);
      if (!(gap <= GetVertexLimit(*edge, this->Size)))
      {
        ++this->Result.Defects;
        this->Result.Messages.push_back(Label("Edge", edge->FileId, i) + " ends " + FormatDistance(gap) +
          " away from its vertex; its curve is taken as it is.");
      }
    }
  }

  void Gather()
  {
    this->CheckVertices();
    std::vector<int> place(this->Faces.size(), -1);
    int lagging = 0;
    for (std::size_t i = 0; i < this->Faces.size(); ++i)
    {
      if (!this->Faces[i].Result)
      {
        continue;
      }
      place[i] = static_cast<int>(this->Result.Faces.size());
      for (const std::string& message : this->Faces[i].Result->Messages)
      {
        this->Result.Messages.push_back(Label("Face", this->Faces[i].Result->FileId, i) + ": " + message);
      }
      this->Result.Defects += this->Faces[i].Defects;
      lagging += this->Faces[i].LaggingCoedges;
      this->Result.Faces.push_back(this->Faces[i]);
    }
    if (lagging > 0)
    {
      this->Result.Messages.push_back(
        FormatCount(lagging, "curve of an edge on a face is", "curves of edges on faces are") +
        " parametrised differently from the edge, and no common parameter could be found; gaps there may be "
        "overstated.");
    }
    for (const std::vector<int>& shell : this->Shells)
    {
      std::vector<int> kept;
      for (const int i : shell)
      {
        if (place[i] >= 0)
        {
          kept.push_back(place[i]);
        }
      }
      this->Result.Shells.push_back(kept);
    }
  }

  const TopoDS_Shape& Shape;
  BodyPlace Place;
  const ShapeTable& Table;
  const ProgressCallback& Report;
  int Roundings;
  /// Diagonal of the box around all edges, in model units.
  double Size = 0.0;
  TopTools_IndexedMapOfShape EdgeShapes;
  std::vector<DraftFace> Drafts;
  std::vector<std::vector<int>> Shells;
  std::vector<std::pair<const DraftFace*, const DraftCoedge*>> FirstUse;
  std::vector<std::shared_ptr<const Edge>> Edges;
  std::vector<ConvertedFace> Faces;
  ConvertedBody Result;
};
}

bool IsAsInFile(const TopoDS_Shape& shape, const ShapeTable& table)
{
  bool isAny = false;
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More() && !isAny; faces.Next())
  {
    isAny = Find(table, faces.Current()).AsInFile != nullptr;
  }
  return isAny;
}

ConvertedBody ConvertBody(const TopoDS_Shape& shape, const gp_Trsf& trsf, double unit, const double origin[3],
  const ShapeTable& table, const ProgressCallback& progress, int roundings)
{
  return BodyConverter(shape, trsf, unit, origin, table, progress, roundings).Convert();
}
}
