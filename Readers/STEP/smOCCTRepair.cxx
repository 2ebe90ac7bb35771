#include "smOCCTRepair.h"

#include "smOCCTClosing.h"
#include "smOCCTFaceInspection.h"
#include "smOCCTFailure.h"
#include "smOCCTShells.h"
#include "smParallelFor.h"

#include "vtkTimerLog.h"

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace sm
{
namespace
{
/// Largest number of reasons that are listed.
constexpr std::size_t MostReasons = 10;

/// Gaps between edges and surfaces up to this, relative to the size, need no repair. It is a quarter of the limit of the integrals, because
/// their bound of the distance of an edge beyond its surface may be several times too large.
constexpr double LargestGap = 2.5e-4;

/// Number of faces of the first group that is inspected in parallel; each further group has as many as all groups before it, and this many
/// more.
constexpr std::size_t FirstFaces = 32;

/// The sign of an estimated volume is certain if it exceeds this fraction of the sum of the absolute volumes of its faces' cones.
constexpr double LeastShare = 0.2;

/// Number and signed sum of the uses of an edge by faces.
struct EdgeUses
{
  int Count = 0;
  int Sum = 0;
};

/// The box around vertices and some points of edges.
class ShapeBox
{
public:
  explicit ShapeBox(const TopoDS_Shape& shape)
  {
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i)
    {
      double first = 0.0;
      double last = 0.0;
      const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(edges(i)), first, last);
      for (const double x : { 0.0, 0.25, 0.5, 0.75, 1.0 })
      {
        if (!curve.IsNull() && last > first)
        {
          this->Add(curve->Value((1.0 - x) * first + x * last).XYZ());
        }
      }
    }
  }

  double GetSize() const
  {
    return this->Low.X() <= this->High.X() ? (this->High - this->Low).Modulus() : 0.0;
  }
  bool Contains(const ShapeBox& other, double tolerance) const
  {
    return Contains(other.Low, tolerance) && Contains(other.High, tolerance);
  }
  gp_Pnt GetCenter() const { return gp_Pnt(0.5 * (this->Low + this->High)); }

private:
  bool Contains(const gp_XYZ& p, double tolerance) const
  {
    bool isInside = true;
    for (int c = 1; c <= 3; ++c)
    {
      isInside = isInside && p.Coord(c) >= this->Low.Coord(c) - tolerance &&
        p.Coord(c) <= this->High.Coord(c) + tolerance;
    }
    return isInside;
  }

  void Add(const gp_XYZ& p)
  {
    for (int c = 1; c <= 3; ++c)
    {
      this->Low.SetCoord(c, std::min(this->Low.Coord(c), p.Coord(c)));
      this->High.SetCoord(c, std::max(this->High.Coord(c), p.Coord(c)));
    }
  }

  gp_XYZ Low{ 1e300, 1e300, 1e300 };
  gp_XYZ High{ -1e300, -1e300, -1e300 };
};

class ShapeInspector
{
public:
  ShapeInspector(TopoDS_Shape& shape, const ShapeLabel& label, SoundFaceTable& faces)
    : Shape(shape)
    , Label(label)
    , SoundFaces(faces)
  {
  }

  std::string Run()
  {
    this->Measure();
    const bool isSolid = this->Shape.ShapeType() == TopAbs_SOLID;
    TopExp_Explorer it(this->Shape, TopAbs_SHELL);
    if (!it.More())
    {
      return "it has no shell";
    }
    const ShapeBox outer(it.Current());
    double sign = 0.0;
    for (; it.More(); it.Next())
    {
      double outwards = 0.0;
      const std::string problem = this->InspectShell(it.Current(), isSolid, outwards);
      if (!problem.empty())
      {
        return problem;
      }
      // A void with the wrong orientation is detected later by exact volumes, but the shell may also be no void: one outside the outer
      // shell needs a repair.
      if (sign * outwards > 0.0 && !outer.Contains(ShapeBox(it.Current()), this->Tolerance))
      {
        return "a void may lie outside its shell";
      }
      sign = sign != 0.0 ? sign : isSolid && outwards < -LeastShare ? -1.0 : 1.0;
    }
    if (sign < 0.0)
    {
      this->Shape.Reverse();
    }
    this->SoundFaces.merge(this->Inspected);
    return {};
  }

private:
  void Measure()
  {
    const ShapeBox box(this->Shape);
    TopTools_IndexedMapOfShape vertices;
    TopExp::MapShapes(this->Shape, TopAbs_VERTEX, vertices);
    for (int i = 1; i <= vertices.Extent(); ++i)
    {
      this->Tolerance = std::max(this->Tolerance, BRep_Tool::Tolerance(TopoDS::Vertex(vertices(i))));
    }
    this->Size = box.GetSize();
    this->Tolerance =
      LoopTolerance * this->Size + std::min(4.0 * this->Tolerance, VertexTolerance * this->Size);
  }

  /// Inspects a shell. `outwards` is set to its signed volume, relative to the sum of the absolute volumes of its faces' cones.
  std::string InspectShell(const TopoDS_Shape& shell, bool isSolid, double& outwards)
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
    const ShapeBox box(shell);
    double volume = 0.0;
    double sum = 0.0;
    std::vector<FaceInspection> results;
    // Only the first problem is reported, so the inspection stops after the group that has it.
    for (std::size_t start = 0; start < drafts.size(); start += results.size())
    {
      results.assign(std::min(start + FirstFaces, drafts.size() - start), {});
      ParallelFor(results.size(), 16,
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            const std::string failure = CatchFailure(
              [&] {
                results[i] =
                  InspectFace(drafts[start + i], box.GetCenter(), this->Tolerance, LargestGap * this->Size);
              });
            results[i].Problem = failure.empty() ? results[i].Problem : failure;
          }
        });
      for (std::size_t i = 0; i < results.size(); ++i)
      {
        if (!results[i].Problem.empty())
        {
          return this->Label(faces[start + i]) + ": " + results[i].Problem;
        }
        volume += (drafts[start + i].Reversed ? -1.0 : 1.0) * results[i].ConeVolume;
        sum += std::abs(results[i].ConeVolume);
      }
    }
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      this->Inspected.emplace(
        faces[i].TShape().get(), std::make_shared<const DraftFace>(std::move(drafts[i])));
    }
    outwards = sum > 0.0 ? volume / sum : 0.0;
    return {};
  }

  /// Checks that every edge of a solid has two uses, one in each direction, and that the faces of a shell are connected.
  static std::string InspectStructure(const std::vector<TopoDS_Shape>& faces, bool isSolid)
  {
    std::unordered_map<const TopoDS_TShape*, EdgeUses> uses;
    for (const TopoDS_Shape& face : faces)
    {
      for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
      {
        if (IsBoundary(it.Current()))
        {
          EdgeUses& use = uses[it.Current().TShape().get()];
          ++use.Count;
          use.Sum += it.Current().Orientation() == TopAbs_FORWARD ? 1 : -1;
        }
      }
    }
    // The reason must not depend on the order of the hash table.
    bool isContrary = false;
    for (const auto& [edge, use] : uses)
    {
      if (isSolid && use.Sum != 0 && use.Count == 1)
      {
        return "a shell is open";
      }
      // An edge along which parts of a solid touch has two uses in either direction.
      isContrary = isContrary || (use.Count > 2 && !isSolid) || (use.Count > 1 && use.Sum != 0);
    }
    if (isContrary)
    {
      return "its faces do not agree about their sides";
    }
    const std::vector<std::size_t> groups = GroupFaces(faces);
    const bool isOne =
      std::all_of(groups.begin(), groups.end(), [](std::size_t group) { return group == 0; });
    return isSolid && !isOne ? "a shell is in several parts" : std::string();
  }

  TopoDS_Shape& Shape;
  const ShapeLabel& Label;
  SoundFaceTable& SoundFaces;
  SoundFaceTable Inspected;
  double Size = 0.0;
  double Tolerance = 0.0;
};

/// Keeps the sides of the faces, which a repair may turn.
void KeepSides(const TopoDS_Shape& shape, RepairLog& log)
{
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
  {
    TopLoc_Location location;
    const Handle(Geom_Surface)& surface = BRep_Tool::Surface(TopoDS::Face(it.Current()), location);
    const FaceSide side{ surface, it.Current().Orientation() == TopAbs_REVERSED, false };
    const auto [known, isNew] = log.Sides.emplace(surface.get(), side);
    known->second.Ambiguous = !isNew;
  }
}

/// Returns true if the body needs no repair; the result is added to `log`.
bool IsSoundBody(TopoDS_Shape& shape, RepairLog& log, const ShapeLabel& label)
{
  if (shape.IsNull() || (shape.ShapeType() != TopAbs_SOLID && shape.ShapeType() != TopAbs_SHELL))
  {
    return false;
  }
  // Labels are made for listed reasons only, because each needs a search through all transferred entities.
  const bool isTold = log.Reasons.size() < MostReasons;
  const ShapeLabel none = [](const TopoDS_Shape&) { return std::string(); };
  std::string problem;
  const TopAbs_Orientation before = shape.Orientation();
  const double start = vtkTimerLog::GetUniversalTime();
  const std::string failure =
    CatchFailure([&] { problem = FindShapeDamage(shape, isTold ? label : none, log.SoundFaces); });
  log.Seconds += vtkTimerLog::GetUniversalTime() - start;
  problem = failure.empty() ? problem : failure;
  if (problem.empty())
  {
    ++log.SoundBodies;
    if (shape.Orientation() != before)
    {
      log.TurnedBodies.push_back(shape);
    }
    return true;
  }
  ++log.RepairedBodies;
  KeepSides(shape, log);
  if (isTold)
  {
    log.Reasons.push_back(problem);
  }
  return false;
}
}

RepairOnNeed::RepairOnNeed(RepairLog& log, ShapeLabel label)
  : Filter([&log, label = std::move(label)](TopoDS_Shape& shape) { return IsSoundBody(shape, log, label); })
{
}

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

std::string FindShapeDamage(TopoDS_Shape& shape, const ShapeLabel& label, SoundFaceTable& faces)
{
  return ShapeInspector(shape, label, faces).Run();
}
}
