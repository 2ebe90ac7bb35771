#include "smOCCTFoldedFaces.h"

#include "smOCCTFailure.h"
#include "smOCCTFootPoint.h"
#include "smOCCTNaturalBoundary.h"

#include <BRep_Tool.hxx>
#include <Geom_ElementarySurface.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>

namespace sm
{
namespace
{
/// Cosine of the angle between normals that are opposite: within 0.8 degrees. Smooth edges of real files
/// deviate by less.
constexpr double Opposite = -0.9999;
/// The same between planes and surfaces of the second order, and tori, whose edges are smooth to the digits
/// of their radii and places: within 0.1 degrees. A cap that is flatter than 1e-6 of its radius, and a ball
/// on a plate with a rim narrower than 1e-3 of its radius, have such edges.
constexpr double OppositeOfElementary = -0.999999;

/// Returns true if the direction of its loops has decided on which part of a closed surface the face is.
bool IsDecidedByLoops(const DraftFace& face)
{
  return face.IsOutside() || (face.AddedEdges > 0 && IsOnClosedSurface(face));
}

bool IsElementary(const TopoDS_Shape& face)
{
  TopLoc_Location location;
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(TopoDS::Face(face), location);
  return !surface.IsNull() && surface->IsKind(STANDARD_TYPE(Geom_ElementarySurface));
}

/// Finds the foot of a point on the surface of a face. A surface of revolution may have its points twice,
/// with opposite normals: the surface is the part that was inspected, if the face was.
Handle(Geom_Surface)
  FindFoot(const TopoDS_Shape& shape, const SoundFaceTable& faces, const gp_Pnt& point, gp_Pnt2d& foot)
{
  const auto found = faces.find(shape.TShape().get());
  if (found != faces.end() && found->second->IsPart)
  {
    const DraftFace& face = *found->second;
    const auto surface = Handle(Geom_Surface)::DownCast(face.Surface->Transformed(face.Location));
    const auto finder = FootPointFinder::Make(surface);
    double uv[2];
    if (finder && finder->Find(point, nullptr, uv))
    {
      foot.SetCoord(uv[0], uv[1]);
      return surface;
    }
  }
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(TopoDS::Face(shape));
  foot = ShapeAnalysis_Surface(surface).ValueOfUV(point, Precision::Confusion());
  return surface;
}

/// Returns the outer unit normal of a face at the foot of a point; null if it is not defined.
gp_Vec GetNormal(const TopoDS_Shape& shape, const SoundFaceTable& faces, const gp_Pnt& point)
{
  gp_Pnt2d foot;
  const Handle(Geom_Surface) surface = FindFoot(shape, faces, point, foot);
  gp_Pnt p;
  gp_Vec du;
  gp_Vec dv;
  surface->D1(foot.X(), foot.Y(), p, du, dv);
  const gp_Vec normal = du.Crossed(dv);
  const double length = normal.Magnitude();
  const double sign = shape.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0;
  return length > 0.0 ? normal * (sign / length) : gp_Vec();
}

bool FoldsBack(const TopoDS_Shape& face, const SoundFaceTable& faces,
  const TopTools_IndexedDataMapOfShapeListOfShape& neighbours)
{
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
  {
    double first = 0.0;
    double last = 0.0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(it.Current()), first, last);
    if (curve.IsNull() || !neighbours.Contains(it.Current()))
    {
      continue;
    }
    const gp_Pnt middle = curve->Value(0.5 * (first + last));
    for (const TopoDS_Shape& other : neighbours.FindFromKey(it.Current()))
    {
      const double limit = IsElementary(face) && IsElementary(other) ? OppositeOfElementary : Opposite;
      if (!other.IsSame(face) && GetNormal(face, faces, middle).Dot(GetNormal(other, faces, middle)) < limit)
      {
        return true;
      }
    }
  }
  return false;
}
}

std::vector<TopoDS_Shape> FindFoldedFaces(const TopoDS_Shape& body, const SoundFaceTable& faces)
{
  std::vector<TopoDS_Shape> folded;
  TopTools_IndexedDataMapOfShapeListOfShape neighbours;
  for (TopExp_Explorer it(body, TopAbs_FACE); it.More(); it.Next())
  {
    const auto found = faces.find(it.Current().TShape().get());
    if (found == faces.end() || !IsDecidedByLoops(*found->second))
    {
      continue;
    }
    if (neighbours.IsEmpty())
    {
      TopExp::MapShapesAndAncestors(body, TopAbs_EDGE, TopAbs_FACE, neighbours);
    }
    bool isFolded = false;
    CatchFailure([&] { isFolded = FoldsBack(it.Current(), faces, neighbours); });
    if (isFolded)
    {
      folded.push_back(it.Current());
    }
  }
  return folded;
}
}
