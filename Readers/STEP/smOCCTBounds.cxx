#include "smOCCTBounds.h"

#include "smOCCTFailure.h"

#include <BRepBndLib.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Gets the bounding box of a shape. Returns false if it has none, or an infinite one.
bool GetFiniteBox(const TopoDS_Shape& shape, double bounds[6])
{
  bool finite = false;
  const std::string failure = CatchFailure(
    [&]()
    {
      Bnd_Box box;
      BRepBndLib::Add(shape, box, true);
      if (box.IsVoid() || box.IsOpen())
      {
        return;
      }
      box.SetGap(0.0);
      box.Get(bounds[0], bounds[2], bounds[4], bounds[1], bounds[3], bounds[5]);
      finite =
        std::all_of(bounds, bounds + 6, [](double b) { return std::abs(b) < 0.5 * Precision::Infinite(); });
    });
  return failure.empty() && finite;
}
}

bool GetEdgeBounds(const TopoDS_Shape& shape, double bounds[6])
{
  TopoDS_Compound edges;
  BRep_Builder builder;
  builder.MakeCompound(edges);
  for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next())
  {
    builder.Add(edges, it.Current());
  }
  return GetFiniteBox(edges, bounds);
}

bool GetShapeBounds(const TopoDS_Shape& shape, double bounds[6], int* unbounded)
{
  if (GetFiniteBox(shape, bounds))
  {
    return true;
  }
  bool any = false;
  int skipped = 0;
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
  {
    double own[6];
    if (!GetFiniteBox(faces.Current(), own))
    {
      ++skipped;
      continue;
    }
    for (int d = 0; d < 3; ++d)
    {
      bounds[2 * d] = any ? std::min(bounds[2 * d], own[2 * d]) : own[2 * d];
      bounds[2 * d + 1] = any ? std::max(bounds[2 * d + 1], own[2 * d + 1]) : own[2 * d + 1];
    }
    any = true;
  }
  if (unbounded)
  {
    *unbounded = skipped;
  }
  return any;
}
}
