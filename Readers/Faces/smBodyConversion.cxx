#include "smBodyConversion.h"

#include "Geometry/smReadingRounding.h"
#include "Geometry/smSurfaceConversion.h"
#include "Loops/smClosing.h"
#include "Loops/smFaceDomain.h"
#include "Trims/smCommonParameter.h"
#include "Trims/smFaceTrims.h"
#include "Trims/smTrimResidual.h"
#include "smCatchFailure.h"
#include "smEdgeConversion.h"
#include "smFormat.h"
#include "smParallelFor.h"

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
  const bool isTrimmed = face.Source->IsTrimmed(0) || face.Source->IsTrimmed(1);
  for (int d = 0; d < 2 && isTrimmed && !face.Loops.empty(); ++d)
  {
    const ParameterRange domain = face.Source->GetDomain(d);
    const double width = domain.High - domain.Low;
    const double slack = std::isfinite(width) ? Slack * width : 0.0;
    const double period = face.Period[d];
    const double shift = period > 0.0 ? std::ceil((domain.Low - slack - box.Low[d]) / period) * period : 0.0;
    if (box.Low[d] + shift < domain.Low - slack || box.High[d] + shift > domain.High + slack)
    {
      return std::string("Its loops lead beyond its RECTANGULAR_TRIMMED_SURFACE in ") + (d == 0 ? "u" : "v") +
        "; the surface is taken without its borders.";
    }
  }
  return {};
}

std::string Label(const char* kind, std::int64_t fileId, std::size_t index)
{
  return fileId > 0 ? std::string(kind) + " #" + std::to_string(fileId)
                    : std::string(kind) + " number " + std::to_string(index + 1) + " of its body";
}

class BodyConverter
{
public:
  BodyConverter(const BodyShape& shape, const Placement& scale, double unit, const double origin[3],
    const ProgressCallback& progress, int roundings, const Vector3& moved)
    : Shape(shape)
    , Place{ scale, unit, { origin[0], origin[1], origin[2] } }
    , Report(progress)
    , Roundings(roundings)
    , Moved(moved)
  {
  }

  ConvertedBody Convert()
  {
    this->Collect();
    this->Edges.resize(this->EdgeShapes.GetSize());
    this->Run(
      this->EdgeShapes.GetSize(), [this](std::size_t i) { this->ConvertEdge(i); }, "Edge", 0.0);
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
    const auto add = [this](const FaceUse& use, std::vector<int>& shell)
    {
      DraftFace draft;
      const std::string failure = CatchFailure(
        [&]
        {
          draft = CollectFace(*use.Face, use.Reversed, this->EdgeShapes,
            use.Face->Completed ? MissingTrim::Feet : MissingTrim::None);
          if (draft.Loops.empty() && use.Face->Bounded)
          {
            throw std::runtime_error("the repair made nothing of the edges that bound it");
          }
        });
      if (!failure.empty())
      {
        this->Result.Messages.push_back(
          Label("Face", use.Face->Data.FileId, this->Drafts.size()) + " is left out: " + failure + ".");
        ++this->Result.MissingFaces;
        return;
      }
      shell.push_back(static_cast<int>(this->Drafts.size()));
      this->Drafts.push_back(std::move(draft));
    };
    for (const ShellUse& use : this->Shape.Shells)
    {
      const int lost = use.Shell->LostFaces;
      if (lost > 0)
      {
        this->Result.MissingFaces += lost;
        this->Result.Messages.push_back(
          std::to_string(lost) + " faces of the file are not here: they are damaged, or could not be read.");
      }
      std::vector<int> shell;
      for (const FaceUse& face : use.Shell->Faces)
      {
        add({ face.Face, face.Reversed != use.Reversed }, shell);
      }
      this->Shells.push_back(shell);
    }
    std::vector<int> loose;
    for (const FaceUse& face : this->Shape.Faces)
    {
      add(face, loose);
    }
    if (!loose.empty())
    {
      this->Shells.push_back(loose);
    }
    this->FirstUse.assign(this->EdgeShapes.GetSize(), { nullptr, nullptr });
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
        const ShapeData& data = *kind == 'E' ? this->EdgeShapes[i]->Data : this->Drafts[i].Source->Data;
        this->Result.Messages.push_back(Label(kind, data.FileId, i) + " is left out: " + failures[i] + ".");
        this->Result.MissingFaces += *kind == 'F' ? 1 : 0;
      }
    }
  }

  void ConvertEdge(std::size_t index)
  {
    const auto& [face, coedge] = this->FirstUse[index];
    this->Edges[index] = ConvertEdgeShape(*this->EdgeShapes[index], this->Place, *face, *coedge);
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

  /// Takes the loops that were completed when the face was inspected.
  void CompleteFace(const DraftFace& inspected, DraftFace& draft) const
  {
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
          coedge.EdgeIndex = this->EdgeShapes.Find(coedge.Edge);
        }
      }
    }
  }

  void ConvertFace(std::size_t index)
  {
    DraftFace& draft = this->Drafts[index];
    const FaceShape& source = *draft.Source;
    if (draft.AsInFile)
    {
      this->CompleteFace(*source.Completed, draft);
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
        if (!coedge.Projected && !coedge.Trim.GetLine())
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
    const SurfacePointer own = source.Own.Surface ? CoverBox(source.Own, draft.Surface, box) : nullptr;
    const SurfacePointer& native = own ? own : draft.Surface;
    ConvertedSurface surface = ConvertSurface(native, box, map);

    auto face = std::make_shared<Face>();
    face->Id = NewId();
    face->FileId = source.Data.FileId;
    face->Name = source.Data.Name;
    face->Color = source.Data.Color;
    face->Reversed = draft.Reversed != map.IsMirrored();
    face->Messages = draft.Messages;
    ConvertedFace& result = this->Faces[index];
    const std::vector<std::shared_ptr<const Edge>> added =
      MakeAddedEdges(draft, map, this->Place.MakeMap(Placement()), this->Place.GetMaxOrigin());
    for (std::size_t l = 0; l < draft.Loops.size(); ++l)
    {
      this->ConvertLoop(draft, draft.Loops[l], added, surface, box, trims[l], *face, result);
    }
    face->Surface = std::move(surface.Surface);
    face->Surface.Rounding =
      GetReadingRounding(*native, box, map, this->Place.Origin, this->Roundings, face->Surface);
    for (int c = 0; c < 3; ++c)
    {
      // A face that crosses the seam has control points that were moved.
      face->Surface.Rounding[c] += this->Moved[c] + (own ? 0.0 : source.Own.Distance * map.GetScale());
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
    result.Source = draft.Source;
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
        (from.Trim.Feet && coedge.Curve.GetMaxResidual() > 1e-12))
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
    }
    if (!loop.Coedges.empty())
    {
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

  const BodyShape& Shape;
  BodyPlace Place;
  const ProgressCallback& Report;
  int Roundings;
  Vector3 Moved;
  /// Diagonal of the box around all edges, in model units.
  double Size = 0.0;
  EdgeIndex EdgeShapes;
  std::vector<DraftFace> Drafts;
  std::vector<std::vector<int>> Shells;
  std::vector<std::pair<const DraftFace*, const DraftCoedge*>> FirstUse;
  std::vector<std::shared_ptr<const Edge>> Edges;
  std::vector<ConvertedFace> Faces;
  ConvertedBody Result;
};
}

bool IsAsInFile(const BodyShape& body)
{
  bool isAny = false;
  body.VisitFaces([&isAny](const FaceUse& use) { isAny = isAny || use.Face->Completed; });
  return isAny;
}

ConvertedBody ConvertBody(const BodyShape& body, const Placement& scale, double unit, const double origin[3],
  const ProgressCallback& progress, int roundings, const Vector3& moved)
{
  return BodyConverter(body, scale, unit, origin, progress, roundings, moved).Convert();
}
}
