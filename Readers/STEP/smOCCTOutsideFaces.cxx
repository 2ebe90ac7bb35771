#include "smOCCTOutsideFaces.h"

#include "smOCCTFaceInspection.h"
#include "smOCCTFailure.h"
#include "smOCCTNaturalBoundary.h"

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <cmath>
#include <limits>

namespace sm
{
namespace
{
/// Loops with larger gaps, and narrower ones, relative to the size of the body, have no certain direction.
constexpr double Tolerance = 1e-5;

bool IsOutside(const TopoDS_Face& shape, double size)
{
  bool isOutside = false;
  CatchFailure(
    [&]
    {
      TopTools_IndexedMapOfShape edges;
      DraftFace face = CollectFace(shape, edges, MissingTrim::Feet);
      isOutside = IsOnClosedSurface(face) &&
        InspectFace(face, gp_Pnt(), Tolerance * size, std::numeric_limits<double>::infinity()).Outside;
    });
  return isOutside;
}
}

std::vector<TopoDS_Shape> FindOutsideFaces(const TopoDS_Shape& body)
{
  std::vector<TopoDS_Shape> faces;
  Bnd_Box box;
  for (TopExp_Explorer it(body, TopAbs_EDGE); it.More(); it.Next())
  {
    BRepBndLib::Add(it.Current(), box);
  }
  const double size = box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
  for (TopExp_Explorer it(body, TopAbs_FACE); it.More(); it.Next())
  {
    if (IsOutside(TopoDS::Face(it.Current()), size))
    {
      faces.push_back(it.Current());
    }
  }
  return faces;
}
}
