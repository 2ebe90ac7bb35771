// Facts that hold for every body: each is violated once, by the moments of boxes added and taken away, and
// keeps quiet where the bound allows it.
#include "smPlausibility.h"
#include "smTesting.h"

#include "vtkNew.h"
#include "vtkTrimmedNURBSModel.h"

#include <cmath>
#include <limits>

namespace
{
using smtest::CheckEqual;
using smtest::CheckTrue;

/// Adds sign times a box, centred in y and z, to moments about the origin.
void AddBox(sm::Moments& moments, double sign, double x, const std::array<double, 3>& size)
{
  sm::Moments box;
  box.Volume = sign * size[0] * size[1] * size[2];
  box.First[0] = box.Volume * x;
  for (int i = 0; i < 3; ++i)
  {
    box.Second[i] = box.Volume * size[i] * size[i] / 12.0;
  }
  box.Second[0] += box.Volume * x * x;
  moments.Add(box);
}

void SetBounds(sm::Moments& moments, double relative)
{
  moments.VolumeBound = relative;
  moments.FirstBound.fill(relative);
  moments.SecondBound.fill(relative);
}

const std::array<double, 6> Box = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };

std::string Judge(const sm::Moments& moments)
{
  const sm::MassProperties p = sm::ComputeMassProperties(moments);
  std::string all;
  for (const std::string& violation : sm::FindImplausibilities(p, p.Center, Box, 1e-12))
  {
    all += violation + "; ";
  }
  return all;
}

bool Has(const std::string& text, const char* part)
{
  return text.find(part) != std::string::npos;
}
}

int TestPlausibility(int, char*[])
{
  sm::Moments sound;
  AddBox(sound, 1.0, 0.0, { 2.0, 2.0, 2.0 });
  SetBounds(sound, 1e-12);
  CheckEqual("a cube is sane", "", Judge(sound));
  // A needle's third moment nearly is the sum of the others, and its first nearly 0.
  sm::Moments needle;
  AddBox(needle, 1.0, 0.0, { 2.0, 1e-9, 1e-9 });
  CheckEqual("a needle is sane", "", Judge(needle));

  sm::Moments nothing;
  SetBounds(nothing, 1e-12);
  CheckEqual("no volume", "the volume is zero within its bound; ", Judge(nothing));
  sm::Moments wide = sound;
  SetBounds(wide, 9.0);
  CheckEqual("a bound too coarse to decide", "", Judge(wide));
  sm::Moments negative;
  AddBox(negative, -1.0, 0.0, { 2.0, 2.0, 2.0 });
  SetBounds(negative, 1e-12);
  CheckTrue("a negative volume", Has(Judge(negative), "the volume is negative"), Judge(negative));

  // 8 less 4 at x = 0.5 + 1: (0 - 4 * 1.5) / 4 = -1.5, half a length outside.
  sm::Moments outside;
  AddBox(outside, 1.0, 0.0, { 2.0, 2.0, 2.0 });
  AddBox(outside, -1.0, 1.5, { 1.0, 2.0, 2.0 });
  SetBounds(outside, 1e-12);
  CheckTrue("a centre outside",
    Has(Judge(outside), "the centre of mass lies outside the box of the solid, by 0.5"), Judge(outside));
  SetBounds(outside, 1.5);
  CheckTrue("unless its bound reaches the box", !Has(Judge(outside), "centre of mass"), Judge(outside));

  // About x everything but a wide plate is taken away again: I_xx = 8/12 (4+4) - 4/12 (16+16) < 0.
  sm::Moments indefinite;
  AddBox(indefinite, 1.0, 0.0, { 2.0, 2.0, 2.0 });
  AddBox(indefinite, -1.0, 0.0, { 0.25, 4.0, 4.0 });
  SetBounds(indefinite, 1e-12);
  CheckTrue(
    "an inertia that is not positive", Has(Judge(indefinite), "not positive definite"), Judge(indefinite));
  SetBounds(indefinite, 2.5);
  CheckTrue(
    "unless its bound reaches 0", !Has(Judge(indefinite), "not positive definite"), Judge(indefinite));

  // A negative second moment XX with a positive inertia: 8/12 * 4 - 0.5 * 4 * ... of two thin plates far out.
  sm::Moments triangle;
  AddBox(triangle, 1.0, 0.0, { 2.0, 2.0, 2.0 });
  AddBox(triangle, -1.0, 0.95, { 0.1, 4.0, 4.0 });
  AddBox(triangle, -1.0, -0.95, { 0.1, 4.0, 4.0 });
  AddBox(triangle, 1.0, 0.0, { 0.1, 4.0, 8.0 });
  SetBounds(triangle, 1e-12);
  CheckTrue(
    "principal moments of no body", Has(Judge(triangle), "the largest exceeds the sum"), Judge(triangle));
  CheckTrue("which are positive", !Has(Judge(triangle), "not positive definite"), Judge(triangle));

  sm::MassProperties unknown;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CheckTrue("what is not there violates nothing",
    sm::FindImplausibilities(unknown, { nan, nan, nan }, Box, 0.0).empty());

  // The hull: rational control points are divided by their weights, edges count.
  auto face = std::make_shared<sm::Face>();
  face->Surface.ControlPoints = { { 2.0, 0.0, 0.0, 2.0 }, { -3.0, 4.0, 0.5, 0.5 } };
  auto edge = std::make_shared<sm::Edge>();
  edge->StartVertex = { 0.0, 0.0, 9.0 };
  edge->EndVertex = { 1.0, 2.0, 0.0 };
  edge->Curve.Coefficients = { { 0.0, -5.0, 0.0 } };
  sm::Coedge coedge;
  coedge.Use = edge;
  face->Loops.resize(1);
  face->Loops[0].Coedges.push_back(coedge);
  vtkNew<vtkTrimmedNURBSModel> model;
  model->SetFaces({ face });
  const std::array<double, 6> expected = { -6.0, 1.0, -5.0, 8.0, 0.0, 9.0 };
  const std::array<double, 6> box = sm::GetHullBox(*model);
  for (int i = 0; i < 6; ++i)
  {
    smtest::Check("hull box " + std::to_string(i), expected[i], box[i], 0.0);
  }
  const std::array<double, 3> within = { 0.5, 1.0, 2.0 };
  CheckTrue("the vertices suffice for a point among them",
    sm::GetHullBox(*model, &within) == std::array<double, 6>{ 0.0, 1.0, 0.0, 2.0, 0.0, 9.0 });
  const std::array<double, 3> beyond = { -1.0, 1.0, 2.0 };
  CheckTrue("but not for another", sm::GetHullBox(*model, &beyond) == box);
  return smtest::Finish();
}
