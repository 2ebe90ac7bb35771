#include "smOCCTRepair.h"

#include "smOCCTFaceInspection.h"
#include "smOCCTFailure.h"
#include "smParallelFor.h"

#include <BRep_Tool.hxx>
#include <Standard_Version.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <XSAlgo.hxx>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace sm
{
namespace
{
/// Reasons that are told.
constexpr std::size_t MostReasons = 10;

/// A gap of that part of the size leaves a loop closed; a vertex excuses no more than the second.
constexpr double LoopTolerance = 1e-5;
constexpr double VertexTolerance = 1e-3;

/// A volume that is less than that part of size^3 has no sign that its estimate could tell.
constexpr double LeastVolume = 1e-7;

/// How faces use an edge.
struct EdgeUses
{
  int Count = 0;
  int Sum = 0;
  std::size_t FirstFace = 0;
};

class ShapeInspector
{
public:
  ShapeInspector(const TopoDS_Shape& shape, const ShapeLabel& label)
    : Shape(shape)
    , Label(label)
  {
  }

  std::string Run()
  {
    this->Measure();
    bool any = false;
    for (TopExp_Explorer it(this->Shape, TopAbs_SHELL); it.More(); it.Next())
    {
      const bool isSolid = this->Shape.ShapeType() == TopAbs_SOLID;
      const std::string problem = this->InspectShell(it.Current(), isSolid, !any);
      any = true;
      if (!problem.empty())
      {
        return problem;
      }
    }
    return any ? std::string() : "it has no shell";
  }

private:
  void Measure()
  {
    gp_XYZ low(1e300, 1e300, 1e300);
    gp_XYZ high(-1e300, -1e300, -1e300);
    TopTools_IndexedMapOfShape vertices;
    TopExp::MapShapes(this->Shape, TopAbs_VERTEX, vertices);
    for (int i = 1; i <= vertices.Extent(); ++i)
    {
      const TopoDS_Vertex vertex = TopoDS::Vertex(vertices(i));
      const gp_XYZ p = BRep_Tool::Pnt(vertex).XYZ();
      this->Tolerance = std::max(this->Tolerance, BRep_Tool::Tolerance(vertex));
      for (int c = 1; c <= 3; ++c)
      {
        low.SetCoord(c, std::min(low.Coord(c), p.Coord(c)));
        high.SetCoord(c, std::max(high.Coord(c), p.Coord(c)));
      }
    }
    if (!vertices.IsEmpty())
    {
      this->Size = (high - low).Modulus();
      this->Origin = gp_Pnt(0.5 * (low + high));
    }
    this->Tolerance =
      LoopTolerance * this->Size + std::min(4.0 * this->Tolerance, VertexTolerance * this->Size);
  }

  std::string InspectShell(const TopoDS_Shape& shell, bool isSolid, bool isOuter)
  {
    std::vector<DraftFace> drafts;
    std::vector<TopoDS_Shape> faces;
    TopTools_IndexedMapOfShape edges;
    for (TopExp_Explorer it(shell, TopAbs_FACE); it.More(); it.Next())
    {
      faces.push_back(it.Current());
      drafts.push_back(CollectFace(TopoDS::Face(it.Current()), edges, MissingTrim::Feet));
    }
    const std::string structure = InspectStructure(faces, isSolid);
    if (!structure.empty())
    {
      return structure;
    }
    std::vector<FaceInspection> results(drafts.size());
    ParallelFor(drafts.size(), 16,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          const std::string failure =
            CatchFailure([&] { results[i] = InspectFace(drafts[i], this->Origin, this->Tolerance); });
          results[i].Problem = failure.empty() ? results[i].Problem : failure;
        }
      });
    double volume = 0.0;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      if (!results[i].Problem.empty())
      {
        return this->Label(faces[i]) + ": " + results[i].Problem;
      }
      volume += (drafts[i].Reversed ? -1.0 : 1.0) * results[i].ConeVolume;
    }
    const double outwards = isOuter ? volume : -volume;
    return !isSolid || outwards > LeastVolume * std::pow(this->Size, 3) ? std::string()
                                                                        : "a shell may be turned inside out";
  }

  /// Every edge of a solid has two uses, one in each direction; the faces of a shell hang together.
  static std::string InspectStructure(const std::vector<TopoDS_Shape>& faces, bool isSolid)
  {
    std::unordered_map<const TopoDS_TShape*, EdgeUses> uses;
    std::vector<std::size_t> group(faces.size());
    std::iota(group.begin(), group.end(), std::size_t{ 0 });
    const auto find = [&group](std::size_t i)
    {
      while (group[i] != i)
      {
        i = group[i] = group[group[i]];
      }
      return i;
    };
    std::size_t groups = faces.size();
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      for (TopExp_Explorer it(faces[i], TopAbs_EDGE); it.More(); it.Next())
      {
        const TopAbs_Orientation orientation = it.Current().Orientation();
        if (BRep_Tool::Degenerated(TopoDS::Edge(it.Current())) ||
          (orientation != TopAbs_FORWARD && orientation != TopAbs_REVERSED))
        {
          continue;
        }
        EdgeUses& use = uses[it.Current().TShape().get()];
        use.FirstFace = use.Count == 0 ? i : use.FirstFace;
        ++use.Count;
        use.Sum += orientation == TopAbs_FORWARD ? 1 : -1;
        const std::size_t a = find(use.FirstFace);
        const std::size_t b = find(i);
        groups -= a != b ? 1 : 0;
        group[b] = a;
      }
    }
    for (const auto& [edge, use] : uses)
    {
      if (isSolid && use.Sum != 0 && use.Count == 1)
      {
        return "a shell is open";
      }
      if (use.Count > 2 || (use.Count == 2 && use.Sum != 0))
      {
        return "its faces do not agree about their sides";
      }
    }
    return isSolid && groups > 1 ? "a shell is in several parts" : std::string();
  }

  const TopoDS_Shape& Shape;
  const ShapeLabel& Label;
  gp_Pnt Origin;
  double Size = 0.0;
  double Tolerance = 0.0;
};

#if OCC_VERSION_HEX < 0x070900
// From 7.8 on ProcessShape() has one parameter more.
#if OCC_VERSION_HEX < 0x070800
#define SM_DETAIL_PARAMETER
#define SM_DETAIL
#else
#define SM_DETAIL_PARAMETER , const TopAbs_ShapeEnum detail
#define SM_DETAIL , detail
#endif
class SelectiveRepair : public XSAlgo_AlgoContainer
{
  DEFINE_STANDARD_RTTI_INLINE(SelectiveRepair, XSAlgo_AlgoContainer)
public:
  SelectiveRepair(RepairLog& log, ShapeLabel label)
    : Log(log)
    , Label(std::move(label))
  {
  }

  TopoDS_Shape ProcessShape(const TopoDS_Shape& shape, const Standard_Real precision,
    const Standard_Real maximum, const Standard_CString resource, const Standard_CString sequence,
    Handle(Standard_Transient) & info, const Message_ProgressRange& progress,
    const Standard_Boolean nonManifold SM_DETAIL_PARAMETER) const override
  {
    const bool isBody =
      !shape.IsNull() && (shape.ShapeType() == TopAbs_SOLID || shape.ShapeType() == TopAbs_SHELL);
    if (isBody && !nonManifold && std::strncmp(sequence, "read.", 5) == 0)
    {
      std::string problem;
      // A label is a search through all that was transferred.
      const bool isTold = this->Log.Reasons.size() < MostReasons;
      const ShapeLabel none = [](const TopoDS_Shape&) { return std::string(); };
      const std::string failure =
        CatchFailure([&] { problem = FindShapeDamage(shape, isTold ? this->Label : none); });
      problem = failure.empty() ? problem : failure;
      if (problem.empty())
      {
        ++this->Log.SoundBodies;
        for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
        {
          this->Log.SoundFaces.insert(it.Current().TShape().get());
        }
        return shape;
      }
      ++this->Log.RepairedBodies;
      if (isTold)
      {
        this->Log.Reasons.push_back(problem);
      }
    }
    return this->XSAlgo_AlgoContainer::ProcessShape(
      shape, precision, maximum, resource, sequence, info, progress, nonManifold SM_DETAIL);
  }

private:
  RepairLog& Log;
  ShapeLabel Label;
};
#endif
}

#if OCC_VERSION_HEX < 0x070900
RepairOnNeed::RepairOnNeed(RepairLog& log, ShapeLabel label)
  : Previous(XSAlgo::AlgoContainer())
{
  XSAlgo::SetAlgoContainer(new SelectiveRepair(log, std::move(label)));
}

RepairOnNeed::~RepairOnNeed()
{
  XSAlgo::SetAlgoContainer(this->Previous);
}
#else
RepairOnNeed::RepairOnNeed(RepairLog&, ShapeLabel) {}

RepairOnNeed::~RepairOnNeed() = default;
#endif

std::string Describe(const RepairLog& log)
{
  std::string text = std::to_string(log.RepairedBodies) + " of " +
    std::to_string(log.RepairedBodies + log.SoundBodies) +
    " solids and shells of the file were repaired by OpenCASCADE: ";
  for (const std::string& reason : log.Reasons)
  {
    text += (&reason == &log.Reasons[0] ? "" : "; ") + reason;
  }
  return text + (static_cast<int>(log.Reasons.size()) < log.RepairedBodies ? "; ..." : ".");
}

std::string FindShapeDamage(const TopoDS_Shape& shape, const ShapeLabel& label)
{
  return ShapeInspector(shape, label).Run();
}
}
