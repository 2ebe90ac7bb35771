#include "smBodyCheck.h"

#include <algorithm>

namespace sm
{
namespace
{
/// Vector areas that differ by less than this, relative to the larger one, are the same region.
constexpr double SameRegion = 1e-3;

/// Area of a mesh relative to that of its surface, above which it covers more than this.
constexpr double MeshMargin = 1.05;

/// Radius of a closed surface relative to the length of the bounds below which the mesh says nothing about
/// areas: its triangles are longer than the surface is wide (a torus of 1000 mm and 0.01 mm has 13 times its
/// area).
constexpr double ThinRadius = 1e-3;

/// A face whose edges bound less than this part of the square of its perimeter may have no triangles.
constexpr double SliverArea = 1e-4;

/// Returns true if edges bound the face, of which not all are seams.
bool HasBorder(const FaceStatement& statement)
{
  std::unordered_map<std::uint64_t, int> sums;
  for (const EdgeUseStatement& use : statement.Uses)
  {
    sums[use.Edge] += use.IsForward ? 1 : -1;
  }
  return std::any_of(sums.begin(), sums.end(), [](const auto& sum) { return sum.second != 0; });
}

/// A use of an edge by a face.
struct UseOfEdge
{
  std::size_t Face;
  bool IsForward;
  bool IsArc;
};

class ContradictionFinder
{
public:
  ContradictionFinder(const std::vector<CheckedFace>& faces, bool isInsideOut, const ClosedTest& isClosed)
    : Faces(faces)
    , IsInsideOut(isInsideOut)
    , Test(isClosed)
    , Known(faces.size(), -1)
    , IsReported(faces.size(), false)
  {
  }

  std::vector<BodyContradiction> Run()
  {
    for (std::size_t i = 0; i < this->Faces.size(); ++i)
    {
      // A face of which only one side is finite has that side, whatever the file says.
      const bool isMended = this->IsReversed(i) && !this->IsClosed(i);
      for (const EdgeUseStatement& use : this->Faces[i].Statement->Uses)
      {
        this->Uses[use.Edge].push_back({ i, use.IsForward != isMended, use.IsArc });
      }
    }
    for (std::size_t i = 0; i < this->Faces.size(); ++i)
    {
      if (this->IsInDoubt(i) && this->HasEdgeInside(i) && this->HasWitness(i))
      {
        this->ReverseUses(i);
      }
      else if (this->IsInDoubt(i))
      {
        this->Add(BodyContradiction::Type::Reversed, i, i, 0);
      }
      if (this->IsInsideOut && HasBorder(*this->Faces[i].Statement) && this->IsClosed(i))
      {
        this->Add(BodyContradiction::Type::InsideOut, i, i, 0);
      }
    }
    for (std::size_t i = 0; i < this->Faces.size(); ++i)
    {
      this->CheckExtent(i);
    }
    // In the order of the faces, so that the result does not depend on a hash.
    for (std::size_t i = 0; i < this->Faces.size(); ++i)
    {
      for (const EdgeUseStatement& use : this->Faces[i].Statement->Uses)
      {
        this->CheckEdge(i, use.Edge);
      }
    }
    return std::move(this->Result);
  }

private:
  bool IsClosed(std::size_t face)
  {
    if (this->Known[face] < 0)
    {
      this->Known[face] = this->Faces[face].IsClosed || (this->Test && this->Test(face)) ? 1 : 0;
    }
    return this->Known[face] > 0;
  }

  bool IsReversed(std::size_t face) const
  {
    return this->Faces[face].Finding.Verdict == FaceVerdict::Reversed;
  }

  /// Returns true if the face is on the other side of its bounds than the file says, and both are finite.
  bool IsInDoubt(std::size_t face) { return this->IsReversed(face) && this->IsClosed(face); }

  /// Returns true if the face uses an edge in both directions, so that it is on both sides of the edge: the
  /// other part of the surface has no such edge.
  bool HasEdgeInside(std::size_t face) const
  {
    std::unordered_map<std::uint64_t, bool> directions;
    const std::vector<EdgeUseStatement>& uses = this->Faces[face].Statement->Uses;
    return std::any_of(uses.begin(), uses.end(),
      [&directions](const EdgeUseStatement& use)
      { return directions.emplace(use.Edge, use.IsForward).first->second != use.IsForward; });
  }

  /// Returns true if an adjacent face is not in doubt itself, so that CheckEdge() compares directions with
  /// it.
  bool HasWitness(std::size_t face)
  {
    for (const EdgeUseStatement& own : this->Faces[face].Statement->Uses)
    {
      for (const UseOfEdge& use : this->Uses[own.Edge])
      {
        if (use.Face != face && !this->IsInDoubt(use.Face))
        {
          return true;
        }
      }
    }
    return false;
  }

  /// Takes the directions of a face's edges as they are around its other side.
  void ReverseUses(std::size_t face)
  {
    for (const EdgeUseStatement& own : this->Faces[face].Statement->Uses)
    {
      // An edge inside comes twice, and keeps its two directions.
      for (UseOfEdge& use : this->Uses[own.Edge])
      {
        use.IsForward = use.IsForward != (use.Face == face);
      }
    }
  }

  void Add(BodyContradiction::Type kind, std::size_t face, std::size_t other, std::uint64_t edge)
  {
    if (!this->IsReported[face])
    {
      this->IsReported[face] = true;
      this->Result.push_back({ kind, face, other, edge });
    }
  }

  void CheckExtent(std::size_t face)
  {
    const CheckedFace& checked = this->Faces[face];
    const FaceStatement& statement = *checked.Statement;
    if (checked.Pieces > 1 && this->IsClosed(face))
    {
      this->Add(BodyContradiction::Type::InPieces, face, face, 0);
    }
    if (checked.IsOnBothParts)
    {
      this->Add(BodyContradiction::Type::CrossesItself, face, face, 0);
    }
    // Half of it for a torus, a third for a sphere.
    const double radius = 2.0 * statement.WholeVolume / statement.WholeArea;
    const bool isThin = radius < ThinRadius * statement.Boundary.Length;
    if (checked.Area > MeshMargin * statement.WholeArea && !isThin)
    {
      this->Add(BodyContradiction::Type::TooLarge, face, face, 0);
    }
    const double perimeter = statement.Boundary.Length;
    if (checked.Area == 0.0 &&
      (perimeter == 0.0 || Norm(statement.Boundary.GetVectorArea()) > SliverArea * perimeter * perimeter))
    {
      this->Add(BodyContradiction::Type::NotInMesh, face, face, 0);
    }
  }

  void CheckEdge(std::size_t face, std::uint64_t edge)
  {
    const std::vector<UseOfEdge>& uses = this->Uses[edge];
    if (uses.size() == 2 && uses[0].Face != uses[1].Face && uses[0].IsForward == uses[1].IsForward &&
      this->IsClosed(face))
    {
      this->Add(BodyContradiction::Type::SameDirection, face,
        uses[0].Face == face ? uses[1].Face : uses[0].Face, edge);
    }
    const bool isBackwards = std::all_of(uses.begin(), uses.end(),
      [this](const UseOfEdge& use)
      { return use.IsArc && this->IsReversed(use.Face) && !this->IsClosed(use.Face); });
    if (isBackwards && this->HasOtherArcs(face))
    {
      this->Add(BodyContradiction::Type::Backwards, face, face, edge);
    }
  }

  /// Returns true if the face, with the other parts of the curves of all its arcs, has the side that the file
  /// says, and another region.
  bool HasOtherArcs(std::size_t face) const
  {
    const Vector3& read = this->Faces[face].Finding.Read;
    Vector3 other = this->Faces[face].Finding.Stated;
    for (int c = 0; c < 3; ++c)
    {
      other[c] += this->Faces[face].Statement->OtherArcs[c];
    }
    return Dot(other, read) > 0.0 &&
      Norm(Subtract(other, read)) > SameRegion * std::max(Norm(other), Norm(read));
  }

  const std::vector<CheckedFace>& Faces;
  bool IsInsideOut;
  const ClosedTest& Test;
  /// 1 and 0: whether the surface is closed; -1: not known yet.
  std::vector<signed char> Known;
  std::vector<bool> IsReported;
  std::unordered_map<std::uint64_t, std::vector<UseOfEdge>> Uses;
  std::vector<BodyContradiction> Result;
};
}

std::vector<BodyContradiction> FindContradictions(
  const std::vector<CheckedFace>& faces, bool isInsideOut, const ClosedTest& isClosed)
{
  return ContradictionFinder(faces, isInsideOut, isClosed).Run();
}
}
