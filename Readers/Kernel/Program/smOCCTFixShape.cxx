#include "smOCCTFixShape.h"

#include "smOCCTFailure.h"

#include <BRep_Builder.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Face.hxx>
#include <ShapeFix_Shape.hxx>
#include <ShapeFix_Solid.hxx>
#include <ShapeFix_Wire.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shell.hxx>

namespace sm
{
namespace
{
/// Repairs a shape; `changes` gets what was replaced.
TopoDS_Shape Fix(
  const TopoDS_Shape& shape, double precision, double maximum, Handle(ShapeBuild_ReShape) & changes)
{
  const Handle(ShapeFix_Shape) fix = new ShapeFix_Shape(shape);
  fix->SetPrecision(precision);
  fix->SetMaxTolerance(maximum);
  fix->FixFaceTool()->FixWireTool()->FixSameParameterMode() = false;
  fix->FixSolidTool()->CreateOpenSolidMode() = false;
  fix->Perform();
  if (fix->Shape().IsNull())
  {
    return shape;
  }
  changes = fix->Context();
  return fix->Shape();
}

/// Visits the parts of a shape of some types that were replaced.
void VisitChanges(const TopoDS_Shape& shape, const Handle(ShapeBuild_ReShape) & changes,
  TopAbs_ShapeEnum first, TopAbs_ShapeEnum last, const ShapeVisitor& visit)
{
  TopTools_IndexedMapOfShape parts;
  TopExp::MapShapes(shape, parts);
  for (int i = 1; i <= parts.Extent() && !changes.IsNull(); ++i)
  {
    const TopoDS_Shape& part = parts(i);
    if (part.ShapeType() < first || part.ShapeType() > last)
    {
      continue;
    }
    const TopoDS_Shape replaced = changes->Apply(part);
    if (!replaced.IsNull() && !replaced.IsSame(part))
    {
      visit(part, replaced);
    }
  }
}
}

TopoDS_Shape FixShape(
  const TopoDS_Shape& shape, double precision, double maximum, const ShapeVisitor& visitChanges)
{
  Handle(ShapeBuild_ReShape) changes;
  TopoDS_Shape result = Fix(shape, precision, maximum, changes);
  VisitChanges(shape, changes, TopAbs_COMPOUND, TopAbs_EDGE, visitChanges);
  return result;
}

TopoDS_Shape FixFaces(const TopoDS_Shape& whole, const std::vector<TopoDS_Shape>& faces, double precision,
  double maximum, const ShapeVisitor& visitChanges, std::vector<TopoDS_Shape>& repaired)
{
  const Handle(ShapeBuild_ReShape) changes = new ShapeBuild_ReShape();
  for (const TopoDS_Shape& face : faces)
  {
    // By itself a face would be repaired with other settings than in a shell.
    TopoDS_Shell shell;
    BRep_Builder().MakeShell(shell);
    BRep_Builder().Add(shell, changes->Apply(face));
    Handle(ShapeBuild_ReShape) own;
    CatchKernelFailure([&] { Fix(shell, precision, maximum, own); });
    VisitChanges(shell, own, TopAbs_FACE, TopAbs_VERTEX,
      [&changes](const TopoDS_Shape& from, const TopoDS_Shape& to) { changes->Replace(from, to); });
  }
  TopoDS_Shape result = changes->Apply(whole);
  for (const TopoDS_Shape& face : faces)
  {
    for (TopExp_Explorer it(changes->Apply(face), TopAbs_FACE); it.More(); it.Next())
    {
      repaired.push_back(it.Current());
    }
  }
  VisitChanges(whole, changes, TopAbs_COMPOUND, TopAbs_EDGE, visitChanges);
  return result;
}
}
