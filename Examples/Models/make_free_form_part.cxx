// Models the part that Examples/edit_part edits, and writes it as STEP:
//   make_free_form_part free_form_part.step
// A closed pull handle in mm: a periodic bicubic B-spline surface over a lattice of 16 x 10 control points,
// smooth to the second derivative, cut at every second knot line into 8 x 5 faces. Neighbours share their
// boundary rows bit for bit, and no face is trimmed, so that the solid stays closed when control points move.
// (The free-form part of the paper, Examples/Paper/smFreeForm.cxx, has trimmed faces, and moving their
// control points opens it.)
#include "smModelFile.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Pnt.hxx>

#include <cmath>
#include <functional>

namespace
{
const double Pi = std::acos(-1.0);
const int PatchesAlong = 8;
const int PatchesAround = 5;
const int Spans = 2; // of a patch, in each direction
const int Degree = 3;

/// Returns control point (i, j) of the periodic lattice: i along the handle, j around its section, from
/// outside over the top.
gp_Pnt LatticePoint(int i, int j)
{
  const double along = 2.0 * Pi * i / (PatchesAlong * Spans);
  const double around = 2.0 * Pi * j / (PatchesAround * Spans);
  // The weight of the grip, which is at -y: 0 to 1.
  const double grip = std::pow(0.5 - 0.5 * std::sin(along), 2.0);
  const double fingers = 3.2 * std::cos(8.0 * along) * grip;
  const double thick = 8.0 + 7.0 * grip + fingers;
  const double tall = 8.0 + 4.0 * grip - 1.5 * std::cos(2.0 * along);
  const double out = thick * std::cos(around) * (1.0 + 0.18 * std::sin(around));
  const double up = tall * std::sin(around) + 2.0 * std::cos(2.0 * around);
  // The centre line: an oval, flatter at the grip, out of its plane at both sides.
  const double x = 58.0 * std::cos(along) * (1.0 + 0.10 * std::sin(along));
  const double y = 46.0 * std::sin(along) + 5.0 * grip;
  const double z = 9.0 * std::cos(2.0 * along) - 8.0 * grip;
  // The outward normal of the oval.
  const double tangentX = -58.0 * std::sin(along);
  const double tangentY = 46.0 * std::cos(along);
  const double length = std::hypot(tangentX, tangentY);
  return { x + out * tangentY / length, y - out * tangentX / length, z + up };
}

using Row = std::function<gp_Pnt(int)>;

gp_Pnt Mean(double a, const gp_Pnt& p, double b, const gp_Pnt& q)
{
  return gp_Pnt((a * p.XYZ() + b * q.XYZ()) / (a + b));
}

/// Returns control point k of the spline over uniform knots with the control points `row`, after the
/// insertion of every second knot up to the multiplicity 3: its blossoms at (0,0,0), (0,0,1), (0,1,2),
/// (1,2,2) for k = 0 to 3, and so on for every two knots.
gp_Pnt Refine(const Row& row, int k)
{
  const int first = k / 4 * Spans;
  switch (k % 4)
  {
    case 0:
      return gp_Pnt((row(first - 1).XYZ() + 4.0 * row(first).XYZ() + row(first + 1).XYZ()) / 6.0);
    case 1:
      return Mean(2.0, row(first), 1.0, row(first + 1));
    case 2:
      return row(first + 1);
    default:
      return Mean(1.0, row(first + 1), 2.0, row(first + 2));
  }
}

gp_Pnt RefinedPoint(int k, int l)
{
  const auto wrap = [](int i, int count) { return (i % count + count) % count; };
  // The last row of a face is the first row of the next one.
  k = wrap(k, 4 * PatchesAlong);
  l = wrap(l, 4 * PatchesAround);
  const auto across = [&](int i)
  {
    return Refine(
      [&](int j) { return LatticePoint(wrap(i, Spans * PatchesAlong), wrap(j, Spans * PatchesAround)); }, l);
  };
  return Refine(across, k);
}

TopoDS_Shape Patch(int along, int around)
{
  const int count = Degree + Spans;
  TColgp_Array2OfPnt points(1, count, 1, count);
  for (int k = 0; k < count; ++k)
  {
    for (int l = 0; l < count; ++l)
    {
      points(k + 1, l + 1) = RefinedPoint(4 * along + k, 4 * around + l);
    }
  }
  TColStd_Array1OfReal knots(1, Spans + 1);
  TColStd_Array1OfInteger multiplicities(1, Spans + 1);
  for (int i = 1; i <= Spans + 1; ++i)
  {
    knots(i) = static_cast<double>(i - 1) / Spans;
    multiplicities(i) = i == 1 || i == Spans + 1 ? Degree + 1 : 1;
  }
  Handle(Geom_BSplineSurface) surface =
    new Geom_BSplineSurface(points, knots, knots, multiplicities, multiplicities, Degree, Degree);
  return BRepBuilderAPI_MakeFace(surface, 1e-7).Shape();
}

TopoDS_Shape PullHandle()
{
  BRepBuilderAPI_Sewing sewing(1e-6);
  for (int along = 0; along < PatchesAlong; ++along)
  {
    for (int around = 0; around < PatchesAround; ++around)
    {
      sewing.Add(Patch(along, around));
    }
  }
  sewing.Perform();
  TopTools_IndexedMapOfShape shells;
  TopExp::MapShapes(sewing.SewedShape(), TopAbs_SHELL, shells);
  BRepBuilderAPI_MakeSolid solid;
  for (int i = 1; i <= shells.Extent(); ++i)
  {
    solid.Add(TopoDS::Shell(shells(i)));
  }
  TopoDS_Solid body = solid.Solid();
  BRepLib::OrientClosedSolid(body);
  return body;
}
}

int main(int argc, char** argv)
{
  return smmodel::Run(argc, argv,
    { "free_form_part", "SolidMoments free-form part: a pull handle", "make_free_form_part" }, PullHandle);
}
