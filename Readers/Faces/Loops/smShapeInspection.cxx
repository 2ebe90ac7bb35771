#include "smShapeInspection.h"

#include "Shapes/smShells.h"
#include "smCatchFailure.h"
#include "smClosing.h"
#include "smFaceDomain.h"
#include "smFaceInspection.h"
#include "smParallelFor.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>
#include <vector>

namespace sm
{
namespace
{
/// Gaps between edges and surfaces up to this, relative to the size, need no repair. It is a quarter of the
/// limit of the integrals, because their bound of the distance of an edge beyond its surface may be several
/// times too large.
constexpr double MaxGap = 2.5e-4;

/// Number of faces of the first group that is inspected in parallel; each further group has as many as all
/// groups before it, and this many more.
constexpr std::size_t FirstFaces = 32;

/// The sign of an estimated volume is certain if it exceeds this fraction of the sum of the absolute volumes
/// of its faces' cones.
constexpr double MinShare = 0.2;

/// A shell whose estimated volume has the wrong sign by at most this fraction of that sum may not be inside
/// out.
constexpr double UncertainShare = 0.02;

/// Choices of parts of surfaces are tried for so many faces of a shell at most.
constexpr std::size_t MaxOtherParts = 6;

/// One of so many faces of a shell at most is repaired by itself, but one face always; if more need it, the
/// body is repaired.
constexpr std::size_t FacesPerRepair = 48;

/// Number and signed sum of the uses of an edge by faces.
struct EdgeSum
{
  int Count = 0;
  int Sum = 0;
};

/// The box around some points of edges.
class EdgeBox
{
public:
  void Add(const EdgeShape& edge)
  {
    for (const double x : { 0.0, 0.25, 0.5, 0.75, 1.0 })
    {
      if (edge.HasCurve())
      {
        const Vector3 p = edge.EvaluateAt(x);
        this->Add(p, p);
      }
    }
  }
  void Add(const EdgeBox& other) { this->Add(other.Low, other.High); }

  double GetSize() const
  {
    return this->Low[0] <= this->High[0] ? Norm(Subtract(this->High, this->Low)) : 0.0;
  }
  bool Contains(const EdgeBox& other, double tolerance) const
  {
    return Contains(other.Low, tolerance) && Contains(other.High, tolerance);
  }
  Vector3 GetCenter() const { return Multiply(0.5, Sum(this->Low, this->High)); }

private:
  bool Contains(const Vector3& p, double tolerance) const
  {
    bool isInside = true;
    for (int c = 0; c < 3; ++c)
    {
      isInside = isInside && p[c] >= this->Low[c] - tolerance && p[c] <= this->High[c] + tolerance;
    }
    return isInside;
  }

  void Add(const Vector3& low, const Vector3& high)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Low[c] = std::min(this->Low[c], low[c]);
      this->High[c] = std::max(this->High[c], high[c]);
    }
  }

  Vector3 Low{ 1e300, 1e300, 1e300 };
  Vector3 High{ -1e300, -1e300, -1e300 };
};

/// The faces of a shell and its edges, which are numbered once.
struct ShellDraft
{
  std::vector<const FaceShape*> Faces;
  std::vector<DraftFace> Drafts;
  EdgeIndex Edges;
  EdgeBox Box;
  /// Largest tolerance of a vertex.
  double Tolerance = 0.0;
};

using FaceSet = std::unordered_set<const FaceShape*>;

ShellDraft CollectShell(const ShellUse& shell, const FaceSet& repaired)
{
  ShellDraft result;
  for (const FaceUse& use : shell.Shell->Faces)
  {
    const bool isRepaired = repaired.count(use.Face.get()) > 0;
    result.Faces.push_back(use.Face.get());
    result.Drafts.push_back(CollectFace(*use.Face, use.Reversed != shell.Reversed, result.Edges,
      isRepaired ? MissingTrim::None : MissingTrim::Feet));
    for (const DraftLoop& loop : result.Drafts.back().Loops)
    {
      for (const DraftCoedge& coedge : loop)
      {
        for (const VertexShape* vertex : { coedge.Start, coedge.End })
        {
          result.Tolerance = std::max(result.Tolerance, vertex ? vertex->Tolerance : 0.0);
        }
      }
    }
  }
  for (std::size_t i = 0; i < result.Edges.GetSize(); ++i)
  {
    result.Box.Add(*result.Edges[i]);
  }
  return result;
}

/// Adds the uses of edges by a face. `numbers` numbers the edges; null if the coedges have these numbers.
void AddUses(
  const DraftFace& face, std::size_t index, const EdgeIndex* numbers, std::vector<EdgeOfFace>& uses)
{
  for (const DraftLoop& loop : face.Loops)
  {
    for (const DraftCoedge& coedge : loop)
    {
      if (!coedge.Degenerate && coedge.EdgeIndex >= 0)
      {
        const int edge = numbers ? numbers->Find(coedge.Edge) : coedge.EdgeIndex;
        uses.push_back({ index, static_cast<std::size_t>(edge), coedge.Reversed != face.Reversed });
      }
    }
  }
}

/// Checks that every edge of a solid has two uses, one in each direction, and that the faces of a shell are
/// connected.
std::string InspectStructure(
  const std::vector<EdgeOfFace>& uses, std::size_t faceCount, std::size_t edgeCount, bool isSolid)
{
  std::vector<EdgeSum> sums(edgeCount);
  for (const EdgeOfFace& use : uses)
  {
    ++sums[use.Edge].Count;
    sums[use.Edge].Sum += use.Reversed ? -1 : 1;
  }
  bool isContrary = false;
  for (const EdgeSum& edge : sums)
  {
    if (isSolid && edge.Sum != 0 && edge.Count == 1)
    {
      return "a shell is open";
    }
    // An edge along which parts of a solid touch has two uses in either direction.
    isContrary = isContrary || (edge.Count > 2 && !isSolid) || (edge.Count > 1 && edge.Sum != 0);
  }
  if (isContrary)
  {
    return "its faces do not agree about their sides";
  }
  const std::vector<std::size_t> groups = GroupFaces(uses, faceCount, edgeCount);
  const bool isOne = std::all_of(groups.begin(), groups.end(), [](std::size_t group) { return group == 0; });
  return isSolid && !isOne ? "a shell is in several parts" : std::string();
}

class ShapeInspector
{
public:
  explicit ShapeInspector(const BodyShape& shape)
    : Shape(shape)
  {
  }

  ShapeDamage Run(const FaceRepair& repair)
  {
    ShapeDamage damage;
    damage.Problem = this->Inspect();
    if (!this->Damaged.empty())
    {
      damage.Problem = GetLabel(*this->Damaged[0]) + ": " + this->FirstProblem;
    }
    if (!this->Damaged.empty() && repair)
    {
      const std::vector<const FaceShape*> damaged = std::move(this->Damaged);
      std::vector<const FaceShape*> repaired;
      this->Shape = repair(this->Shape, damaged, repaired);
      this->Repaired.insert(repaired.begin(), repaired.end());
      if (!repaired.empty() && this->Inspect().empty() && this->Damaged.empty())
      {
        damage.RepairedFaces = static_cast<int>(damaged.size());
      }
    }
    damage.ReversedEdges = this->ReversedEdges;
    return damage;
  }

  /// Returns the shape after Run(), with a solid that is inside out reversed.
  BodyShape GetShape() const
  {
    BodyShape shape = this->Shape;
    for (ShellUse& shell : shape.Shells)
    {
      shell.Reversed = shell.Reversed != this->IsInsideOut();
    }
    return shape;
  }
  bool IsInsideOut() const { return this->Sign < 0.0; }

  SoundFaceTable& GetFaces() { return this->Inspected; }

private:
  /// Returns a problem of the whole shape; empty if there is none, or only that of the faces in Damaged.
  std::string Inspect()
  {
    this->Damaged.clear();
    this->ReversedEdges = 0;
    this->Sign = 0.0;
    std::vector<ShellDraft> shells;
    EdgeBox box;
    double tolerance = 0.0;
    for (const ShellUse& shell : this->Shape.Shells)
    {
      shells.push_back(CollectShell(shell, this->Repaired));
      box.Add(shells.back().Box);
      tolerance = std::max(tolerance, shells.back().Tolerance);
    }
    if (shells.empty())
    {
      return "it has no shell";
    }
    this->Size = box.GetSize();
    this->Tolerance = LoopTolerance * this->Size + std::min(4.0 * tolerance, VertexTolerance * this->Size);
    std::string problem;
    for (ShellDraft& shell : shells)
    {
      double outwards = 0.0;
      problem = problem.empty() ? this->InspectShell(shell, outwards) : problem;
      // A void with the wrong orientation is detected later by exact volumes, but the shell may also not be a
      // void: one outside the outer shell needs a repair.
      if (problem.empty() && this->Sign * outwards > 0.0 &&
        !shells[0].Box.Contains(shell.Box, this->Tolerance))
      {
        problem = "a void may lie outside its shell";
      }
      this->Sign = this->Sign != 0.0 ? this->Sign : this->Shape.IsSolid && outwards < -MinShare ? -1.0 : 1.0;
    }
    if (!problem.empty())
    {
      this->Damaged.clear();
    }
    return problem;
  }

  FaceInspection InspectDraft(const ShellDraft& shell, std::size_t index, DraftFace& draft) const
  {
    FaceInspection result;
    const auto known = this->ConeVolumes.find(shell.Faces[index]);
    if (known != this->ConeVolumes.end())
    {
      result.ConeVolume = known->second;
      return result;
    }
    const std::string failure = CatchFailure(
      [&] { result = InspectFace(draft, shell.Box.GetCenter(), this->Tolerance, MaxGap * this->Size); });
    result.Problem = failure.empty() ? result.Problem : failure;
    return result;
  }

  /// Inspects a shell and adds faces with problems to Damaged. `outwards` is set to its signed volume,
  /// relative to the sum of the absolute volumes of its faces' cones.
  std::string InspectShell(ShellDraft& shell, double& outwards)
  {
    const bool isWhole = std::all_of(
      shell.Drafts.begin(), shell.Drafts.end(), [](const DraftFace& face) { return face.Defects == 0; });
    const std::string structure =
      isWhole || !this->Repaired.empty() ? this->InspectUses(shell, false) : std::string();
    if (!structure.empty())
    {
      return structure;
    }
    std::vector<FaceInspection> results(shell.Drafts.size());
    std::vector<OtherPart> others = CopyOtherParts(shell);
    const std::size_t maximum = std::max<std::size_t>(1, shell.Drafts.size() / FacesPerRepair);
    std::size_t damaged = 0;
    // A body with many problems is repaired as a whole, so the inspection stops behind the group that has too
    // many.
    for (std::size_t start = 0; start < shell.Drafts.size() && damaged <= maximum;)
    {
      const std::size_t stop = std::min(2 * start + FirstFaces, shell.Drafts.size());
      ParallelFor(stop - start, 16,
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t i = start + begin; i < start + end; ++i)
          {
            results[i] = this->InspectDraft(shell, i, shell.Drafts[i]);
          }
        });
      for (; start < stop; ++start)
      {
        if (!results[start].Problem.empty() && this->Repaired.empty())
        {
          this->TryOtherPart(shell, start, others, results[start]);
        }
        if (!results[start].Problem.empty() && !this->IsRepaired(shell.Faces[start]))
        {
          ++damaged;
          this->FirstProblem = this->Damaged.empty() ? results[start].Problem : this->FirstProblem;
          this->Damaged.push_back(shell.Faces[start]);
        }
      }
    }
    if (damaged > maximum)
    {
      return GetLabel(*this->Damaged[0]) + ": " + this->FirstProblem;
    }
    if (damaged == 0 && this->Repaired.empty())
    {
      this->ChooseParts(shell, others, results);
    }
    return this->Conclude(shell, results, damaged > 0, outwards);
  }

  /// A face on the other one of two parts of a surface (DraftFace::OtherSurface).
  struct OtherPart
  {
    std::size_t Index;
    DraftFace Draft;
    FaceInspection Result;
  };

  static std::vector<OtherPart> CopyOtherParts(const ShellDraft& shell)
  {
    std::vector<OtherPart> others;
    for (std::size_t i = 0; i < shell.Drafts.size(); ++i)
    {
      if (shell.Drafts[i].OtherSurface)
      {
        others.push_back({ i, shell.Drafts[i], {} });
      }
    }
    return others;
  }

  /// Takes the other part of the surface for a face that has a problem on the first one and none on the
  /// other.
  void TryOtherPart(
    ShellDraft& shell, std::size_t index, std::vector<OtherPart>& others, FaceInspection& result) const
  {
    const auto other = std::find_if(
      others.begin(), others.end(), [index](const OtherPart& part) { return part.Index == index; });
    if (other != others.end() && this->InspectOther(shell, *other))
    {
      shell.Drafts[index] = std::move(other->Draft);
      result = other->Result;
      others.erase(other);
    }
  }

  /// Inspects a face on the other part of its surface; returns true if it has no problem there.
  bool InspectOther(const ShellDraft& shell, OtherPart& other) const
  {
    bool isTaken = false;
    CatchFailure([&] { isTaken = TakeOtherPart(other.Draft); });
    other.Result = isTaken ? this->InspectDraft(shell, other.Index, other.Draft) : FaceInspection();
    return isTaken && other.Result.Problem.empty();
  }

  /**
   * Chooses the parts of surfaces of revolution of which the file does not say which one is meant, so that
   * the shell is not inside out: with the first parts if they do, else with the first choice that does. Faces
   * that differ between choices that do so are marked.
   */
  void ChooseParts(
    ShellDraft& shell, std::vector<OtherPart>& others, std::vector<FaceInspection>& results) const
  {
    others.erase(std::remove_if(others.begin(), others.end(),
                   [&](OtherPart& other) { return !this->InspectOther(shell, other); }),
      others.end());
    if (others.empty() || others.size() > MaxOtherParts)
    {
      return;
    }
    // A void is inside out.
    const double sign = this->Sign != 0.0 ? -this->Sign : 1.0;
    std::vector<unsigned int> possible;
    for (unsigned int choice = 0; choice < 1u << others.size(); ++choice)
    {
      if (sign * this->GetOutwards(shell, others, results, choice) > -UncertainShare)
      {
        possible.push_back(choice);
      }
    }
    const unsigned int chosen = possible.empty() ? 0 : possible[0];
    for (std::size_t k = 0; k < others.size(); ++k)
    {
      const bool isOther = (chosen >> k & 1u) != 0;
      DraftFace& draft = shell.Drafts[others[k].Index];
      if (isOther)
      {
        draft = std::move(others[k].Draft);
        results[others[k].Index] = others[k].Result;
      }
      draft.IsEitherPart = std::any_of(possible.begin(), possible.end(),
        [&](unsigned int choice) { return ((choice >> k & 1u) != 0) != isOther; });
    }
  }

  /// Returns the signed volume of a shell, relative to the sum of the absolute volumes of its faces' cones,
  /// for a choice of other parts.
  static double GetOutwards(const ShellDraft& shell, const std::vector<OtherPart>& others,
    const std::vector<FaceInspection>& results, unsigned int choice)
  {
    std::vector<double> cones;
    cones.reserve(results.size());
    for (const FaceInspection& result : results)
    {
      cones.push_back(result.ConeVolume);
    }
    for (std::size_t k = 0; k < others.size(); ++k)
    {
      double& cone = cones[others[k].Index];
      cone = (choice >> k & 1u) != 0 ? others[k].Result.ConeVolume : cone;
    }
    double volume = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < cones.size(); ++i)
    {
      volume += shell.Drafts[i].Reversed ? -cones[i] : cones[i];
      sum += std::abs(cones[i]);
    }
    return sum > 0.0 ? volume / sum : 0.0;
  }

  bool IsRepaired(const FaceShape* face) const { return this->Repaired.count(face) > 0; }

  /// Takes over the faces of a shell that have no problems.
  std::string Conclude(
    ShellDraft& shell, const std::vector<FaceInspection>& results, bool isDamaged, double& outwards)
  {
    double volume = 0.0;
    double sum = 0.0;
    int reversed = 0;
    bool isKnown = true;
    this->Inspected.reserve(this->Inspected.size() + shell.Faces.size());
    for (std::size_t i = 0; i < results.size(); ++i)
    {
      const FaceShape* key = shell.Faces[i];
      const double own = results[i].ConeVolume;
      volume += shell.Drafts[i].Reversed ? -own : own;
      sum += std::abs(own);
      isKnown = isKnown && results[i].Problem.empty();
      if (results[i].Problem.empty() && !this->IsRepaired(shell.Faces[i]))
      {
        const auto face =
          this->Inspected.emplace(key, std::make_shared<const DraftFace>(std::move(shell.Drafts[i]))).first;
        reversed += face->second->ReversedEdges;
        if (isDamaged)
        {
          this->ConeVolumes.emplace(key, own);
        }
      }
    }
    outwards = sum > 0.0 ? volume / sum : 0.0;
    this->ReversedEdges += reversed;
    const std::string structure = reversed > 0 && !isDamaged ? this->InspectUses(shell, true) : std::string();
    // What a repaired face adds to the volume may not be known.
    return structure.empty() && !isDamaged && !isKnown && this->Shape.IsSolid && std::abs(outwards) < MinShare
      ? "on which side its material lies is not certain"
      : structure;
  }

  std::string InspectUses(const ShellDraft& shell, bool isInspected) const
  {
    std::vector<EdgeOfFace> uses;
    for (std::size_t i = 0; i < shell.Faces.size(); ++i)
    {
      const auto sound = isInspected ? this->Inspected.find(shell.Faces[i]) : this->Inspected.end();
      const bool isSound = sound != this->Inspected.end();
      AddUses(isSound ? *sound->second : shell.Drafts[i], i, isSound ? &shell.Edges : nullptr, uses);
    }
    return InspectStructure(uses, shell.Faces.size(), shell.Edges.GetSize(), this->Shape.IsSolid);
  }

  BodyShape Shape;
  /// Faces that passed, and, if others did not, the volumes of their cones.
  SoundFaceTable Inspected;
  std::unordered_map<const FaceShape*, double> ConeVolumes;
  /// Faces that did not pass, and the problem of the first.
  std::vector<const FaceShape*> Damaged;
  std::string FirstProblem;
  /// What a repair made of these.
  FaceSet Repaired;
  int ReversedEdges = 0;
  double Size = 0.0;
  double Tolerance = 0.0;
  /// -1: a solid that is inside out.
  double Sign = 0.0;
};

}

std::string GetLabel(const FaceShape& face)
{
  return face.Data.FileId > 0 ? "face #" + std::to_string(face.Data.FileId) : "a face";
}

ShapeDamage FindShapeDamage(BodyShape& body, SoundFaceTable& faces, const FaceRepair& repair)
{
  ShapeInspector inspector(body);
  ShapeDamage damage = inspector.Run(repair);
  if (damage.Problem.empty() || damage.RepairedFaces > 0)
  {
    body = inspector.GetShape();
    damage.IsReversed = inspector.IsInsideOut();
    faces.merge(inspector.GetFaces());
  }
  return damage;
}
}
