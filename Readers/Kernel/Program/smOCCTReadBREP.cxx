#include "smOCCTReadBREP.h"

#include "smBREPFormat.h"
#include "smMemoryBuffer.h"
#include "smOCCTFailure.h"
#include "smOCCTFile.h"
#include "smOCCTImport.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <BinTools.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shape.hxx>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <istream>
#include <unordered_map>
#include <utility>

namespace sm
{
namespace
{
/// Counts the sub-shapes of a shape, with repetitions.
class ShapeCounter
{
public:
  struct Count
  {
    std::uint64_t Nodes = 0;
    std::uint64_t Faces = 0;
    bool HasSolid = false;
    int Depth = 0;
  };

  const Count& Get(const TopoDS_Shape& shape, int level = 0)
  {
    const void* key = shape.TShape().get();
    const auto known = this->Counts.find(key);
    if (known != this->Counts.end())
    {
      return known->second;
    }
    Count count;
    count.Nodes = shape.ShapeType() < TopAbs_FACE ? 1 : 0;
    count.Faces = shape.ShapeType() == TopAbs_FACE ? 1 : 0;
    count.HasSolid = shape.ShapeType() == TopAbs_SOLID;
    // The recursion stops at the limit, where the depth is refused anyway.
    for (TopoDS_Iterator it(shape, Standard_False, Standard_False);
         it.More() && shape.ShapeType() < TopAbs_FACE && level <= MaxLevels; it.Next())
    {
      const Count& below = this->Get(it.Value(), level + 1);
      // Above the limits the exact number does not matter.
      count.Nodes = std::min(count.Nodes + below.Nodes, Endless);
      count.Faces = std::min(count.Faces + below.Faces, Endless);
      count.HasSolid = count.HasSolid || below.HasSolid;
      count.Depth = std::max(count.Depth, below.Depth + 1);
    }
    return this->Counts.emplace(key, count).first->second;
  }

  /// Returns the reason why a shape cannot be read: it has more instances, faces or levels than the limits;
  /// empty if it can.
  std::string FindExcess(const TopoDS_Shape& shape)
  {
    const Count& count = this->Get(shape);
    return count.Depth > MaxLevels
      ? "its compounds are nested more than " + std::to_string(MaxLevels) + " times"
      : count.Nodes > MaxInstances
      ? "it has more than " + std::to_string(MaxInstances) + " instances of solids, shells and compounds"
      : count.Faces > MaxFaces ? "it has more than " + std::to_string(MaxFaces) + " faces"
                               : std::string();
  }

private:
  static constexpr int MaxLevels = 100;
  static constexpr std::uint64_t MaxFaces = 10000000;
  static constexpr std::uint64_t Endless = std::uint64_t{ 1 } << 40;

  std::unordered_map<const void*, Count> Counts;
};

/// Makes the tree of a shape.
class TreeMaker
{
public:
  explicit TreeMaker(ShapeCounter& counter)
    : Counter(counter)
  {
  }

  void Make(const TopoDS_Shape& shape, BREPContent& content)
  {
    content.Shapes = this->Import.MakeGroup(shape);
    ShapeNode product =
      this->Visit(shape.Located(TopLoc_Location()), ToPlacement(shape.Location().Transformation()));
    if (!shape.Location().IsIdentity())
    {
      // The file places one product.
      ShapeNode root;
      root.Children.push_back(std::move(product));
      product = std::move(root);
    }
    content.Root.Children.push_back(std::move(product));
  }

private:
  /// Returns true if every member of a compound is a solid, or a compound with solids. Any other compound is
  /// one part.
  bool IsAssembly(const TopoDS_Shape& shape)
  {
    if (shape.ShapeType() > TopAbs_COMPSOLID)
    {
      return false;
    }
    int members = 0;
    for (TopoDS_Iterator it(shape, Standard_False, Standard_False); it.More(); it.Next(), ++members)
    {
      if (!this->Counter.Get(it.Value()).HasSolid)
      {
        return false;
      }
    }
    return members > 0;
  }

  /// `shape` has no location.
  ShapeNode Visit(const TopoDS_Shape& shape, const Placement& placement)
  {
    ShapeNode node;
    if (!this->IsAssembly(shape))
    {
      node.Shapes = this->Import.MakeGroup(shape);
      node.Place = placement;
      return node;
    }
    // The members' orientations include that of the assembly.
    for (TopoDS_Iterator it(shape, Standard_True, Standard_False); it.More(); it.Next())
    {
      const TopoDS_Shape& member = it.Value();
      node.Children.push_back(this->Visit(member.Located(TopLoc_Location()),
        Compose(placement, ToPlacement(member.Location().Transformation()))));
    }
    return node;
  }

  ShapeImport Import;
  ShapeCounter& Counter;
};

/// Reports closed shells outside of the solids of a file, which are left out although they may be meant as
/// solids.
void FindLostShells(const TopoDS_Shape& shape, BREPContent& content)
{
  int shells = 0;
  for (TopExp_Explorer it(shape, TopAbs_SHELL, TopAbs_SOLID); it.More(); it.Next())
  {
    shells += BRep_Tool::IsClosed(it.Current()) ? 1 : 0;
  }
  if (shells > 0)
  {
    content.Defects.push_back(
      "Closed shells outside the solids of the file belong to none of them and are left out: " +
      std::to_string(shells) + ".");
  }
}

void Read(std::string_view bytes, const ProgressCallback& progress, BREPContent& content)
{
  TopoDS_Shape shape;
  MemoryBuffer buffer(bytes);
  std::istream stream(&buffer);
  const Handle(KernelProgress) indicator = new KernelProgress(progress);
  if (IsTextBREP(bytes))
  {
    BRepTools::Read(shape, stream, BRep_Builder(), indicator->Start());
  }
  else
  {
    BinTools::Read(shape, stream, indicator->Start());
  }
  indicator->Rethrow();
  if (!progress(1.0))
  {
    content.IsStopped = true;
    return;
  }
  // Three bytes of FreeCAD's file are left, and the shape may be any of its parts.
  if (!IsTextBREP(bytes) && stream.good() && stream.peek() != std::istream::traits_type::eof() &&
    IsBREPOfFreeCAD(bytes))
  {
    content.Problem = FreeCADProblem;
    return;
  }
  if (shape.IsNull() || stream.fail())
  {
    content.Problem = "OpenCASCADE cannot parse it: it is damaged, or of a newer version; save it again";
    return;
  }
  ShapeCounter counter;
  content.Problem = counter.FindExcess(shape);
  if (!content.Problem.empty())
  {
    content.Problem += "; save its parts one by one";
    return;
  }
  TreeMaker(counter).Make(shape, content);
  if (counter.Get(shape).HasSolid)
  {
    FindLostShells(shape, content);
  }
}
}

BREPContent ReadKernelBREP(std::string_view bytes, const ProgressCallback& progress)
{
  BREPContent content;
  if (!LooksLikeBREP(bytes))
  {
    content.Problem = NotBREP;
    return content;
  }
  if (IsTextBREP(bytes) && !IsWholeBREP(bytes))
  {
    content.Problem = "it ends in the middle, or without a line end: copy or save it again";
    return content;
  }
  const std::string failure = CatchKernelFailure([&]() { Read(bytes, progress, content); });
  const bool isFailed = !failure.empty() || !content.Problem.empty();
  if (isFailed && !IsTextBREP(bytes) && IsBREPOfFreeCAD(bytes))
  {
    content.Problem = FreeCADProblem;
  }
  else if (!failure.empty())
  {
    content.Problem = "it could not be read (" + failure + "); save it again";
  }
  return content;
}
}
