// Shapes of boxes by hand: moments of the faces against formulas, placements, and the rotations that carry
// one shape to another.
#include "smBoxBodies.h"
#include "smPartMatch.h"
#include "smTesting.h"

#include <cmath>
#include <cstdio>

namespace
{
using namespace smtest;
using Boxes = std::vector<BoxShell>;

sm::PartShape Measure(const Boxes& boxes)
{
  BoxBody body;
  for (const BoxShell& box : boxes)
  {
    body.Add(box);
  }
  const auto leaf = body.Make();
  return sm::MeasureShapes({ leaf->GetModel() }, 1e-12)[0];
}

sm::PartShape MeasureCentered(const Boxes& boxes)
{
  sm::PartShape shape = Measure(boxes);
  shape.Center();
  return shape;
}

/// Three boxes on one corner, of different heights: no mirror image of itself.
Boxes MakeChiral(double sign)
{
  const auto make = [sign](double x0, double x1, double y0, double y1, double z1)
  {
    return BoxShell{ { std::min(sign * x0, sign * x1), y0, 0.0 },
      { std::max(sign * x0, sign * x1), y1, z1 } };
  };
  return { make(0, 4, 0, 3, 5), make(6, 7, 0, 2, 1), make(0, 1, 5, 8, 2) };
}

/// Rotation by the angle about a unit axis, and a translation; mirrored at x = 0 before.
std::array<double, 12> MakePlacement(const std::array<double, 3>& axis, double angle, bool mirrored)
{
  std::array<double, 12> m{};
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const int next[3] = { 1, 2, 0 };
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      const double cross = i == j ? 0.0 : j == next[i] ? -axis[3 - i - j] : axis[3 - i - j];
      m[4 * i + j] =
        (mirrored && j == 0 ? -1.0 : 1.0) * ((i == j ? c : 0.0) + s * cross + (1.0 - c) * axis[i] * axis[j]);
    }
    m[4 * i + 3] = 100.0 * (i + 1);
  }
  return m;
}

void CheckMoments()
{
  std::printf("--- moments of the faces of a box\n");
  const sm::PartShape shape = Measure({ { { 0, 0, 0 }, { 2, 3, 5 } } });
  CheckEqual("faces", 6, static_cast<int>(shape.Faces.size()));
  CheckTrue("no problem", shape.Problem.empty());
  // The face z = 5: area 6, x from 0 to 2, y from 0 to 3, about the reference.
  const sm::FaceAreaMoments& top = shape.Faces[5];
  const auto& r = shape.Reference;
  const double area = 6.0;
  const double x[2] = { 0 - r[0], 2 - r[0] };
  const double y[2] = { 0 - r[1], 3 - r[1] };
  const double z = 5 - r[2];
  Check("area", area, top.Area, top.AreaBound);
  Check("x", area * (x[0] + x[1]) / 2, top.First[0], top.FirstBound);
  Check("z", area * z, top.First[2], top.FirstBound);
  Check("xx", 3 * (std::pow(x[1], 3) - std::pow(x[0], 3)) / 3, top.Second[0], top.SecondBound);
  Check("zz", area * z * z, top.Second[2], top.SecondBound);
  Check(
    "xy", (x[1] * x[1] - x[0] * x[0]) / 2 * (y[1] * y[1] - y[0] * y[0]) / 2, top.Second[3], top.SecondBound);
  Check("yz", 2 * z * (y[1] * y[1] - y[0] * y[0]) / 2, top.Second[4], top.SecondBound);
  Check("outward", area, top.VectorArea[2], top.VectorAreaBound);
  CheckRange("bound of the area", 0.0, top.AreaBound, 1e-11, "(some roundings)");
  CheckRange("bound of xx", 0.0, top.SecondBound, 1e-10, "(some roundings)");

  sm::PartShape centered = shape;
  centered.Center();
  Check("centre x", 1.0, centered.Reference[0], 1e-14);
  Check("centre z", 2.5, centered.Reference[2], 1e-14);
  Check("zz about the centre", area * 2.5 * 2.5, centered.Faces[5].Second[2], 1e-12);
}

void CheckRotation(const char* what, const sm::PartShape& a, sm::PartShape b,
  const std::array<double, 3>& axis, double angle, double expected)
{
  const std::array<double, 12> placement = MakePlacement(axis, angle, false);
  b.Place(placement.data());
  const sm::Rotation found = sm::FindRotation(a, b, 1e-9);
  CheckTrue(what, found.IsFound);
  Check("its angle", expected, found.Angle, 1e-9);
  CheckEqual("parallel", expected == 0.0, sm::AreParallel(a, b, 1e-9));
}

void CheckRotations()
{
  std::printf("--- rotations\n");
  const double pi = std::acos(-1.0);
  const std::array<double, 3> tilted{ 2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0 };
  const sm::PartShape chiral = MeasureCentered(MakeChiral(1.0));
  for (const double angle : { 0.0, 0.1, 1.0, 0.5 * pi, 3.0, pi })
  {
    CheckRotation("a part without symmetry", chiral, chiral, tilted, angle, angle);
  }
  // The smallest of the four, or 24, rotations that carry it to itself.
  const sm::PartShape square = MeasureCentered({ { { 0, 0, 0 }, { 2, 2, 7 } } });
  CheckRotation("a square bar, by a quarter", square, square, { 0, 0, 1 }, 0.5 * pi, 0.0);
  CheckRotation("by a little more", square, square, { 0, 0, 1 }, 0.5 * pi + 0.2, 0.2);
  const sm::PartShape cube = MeasureCentered({ { { 0, 0, 0 }, { 2, 2, 2 } } });
  CheckRotation("a cube, by a third about its diagonal", cube, cube,
    { std::sqrt(1.0 / 3.0), std::sqrt(1.0 / 3.0), std::sqrt(1.0 / 3.0) }, 2.0 * pi / 3.0, 0.0);
}

void CheckOthers()
{
  std::printf("--- other shapes\n");
  const sm::PartShape chiral = MeasureCentered(MakeChiral(1.0));
  const sm::PartShape box = MeasureCentered({ { { 0, 0, 0 }, { 2, 3, 7 } } });
  for (const sm::PartShape& shape : { chiral, box })
  {
    sm::PartShape mirrored = shape;
    mirrored.Place(MakePlacement({ 0, 0, 1 }, 0.3, true).data());
    const bool isSymmetric = shape.Faces.size() == 6;
    CheckEqual("mirrored", isSymmetric, sm::FindRotation(shape, mirrored, 1e-9).IsFound);
    CheckEqual("of another hand", !isSymmetric, sm::AreMirrored(shape, mirrored, 1e-9));
    CheckTrue("not the mirror image of itself", !sm::AreMirrored(shape, shape, 1e-9));
  }
  CheckTrue(
    "as it was modelled: the mirror image", sm::AreMirrored(chiral, MeasureCentered(MakeChiral(-1.0)), 1e-9));
  Boxes stretched = MakeChiral(-1.0);
  stretched.back().High[2] += 1e-6;
  CheckTrue("the mirror image of another shape", !sm::AreMirrored(chiral, MeasureCentered(stretched), 1e-9));
  CheckTrue("  within a wider tolerance", sm::AreMirrored(chiral, MeasureCentered(stretched), 1e-5));
  CheckTrue("modelled as its mirror image",
    !sm::FindRotation(chiral, MeasureCentered(MakeChiral(-1.0)), 1e-9).IsFound);
  sm::PartShape again = MeasureCentered(MakeChiral(-1.0));
  again.Place(MakePlacement({ 0, 0, 1 }, 0.0, true).data());
  CheckTrue("mirrored twice", sm::AreParallel(chiral, again, 1e-9));

  // Differences within the tolerance, and beyond it.
  for (const auto& [change, isEqual] : { std::pair(1e-11, true), std::pair(1e-6, false) })
  {
    const sm::PartShape longer = MeasureCentered({ { { 0, 0, 0 }, { 2, 3, 7 + change } } });
    CheckEqual("longer", isEqual, sm::FindRotation(box, longer, 1e-9).IsFound);
    CheckTrue("equal with more tolerance", sm::FindRotation(box, longer, 1e-5).IsFound);
  }
  CheckTrue("fewer faces", !sm::AreParallel(box, chiral, 1e-9));
  sm::PartShape surface = box;
  surface.IsSolid = false;
  CheckTrue("a surface is not a solid", !sm::AreParallel(box, surface, 1e-9));
  sm::PartShape unknown = box;
  unknown.Problem = "nobody knows";
  CheckTrue("an unknown shape equals none", !sm::FindRotation(unknown, unknown, 1e-9).IsFound);
  // Two boxes whose order is another.
  const BoxShell one{ { 0, 0, 0 }, { 1, 1, 1 } };
  const BoxShell two{ { 3, 0, 0 }, { 4, 2, 1 } };
  CheckTrue("the order of the faces",
    sm::AreParallel(MeasureCentered({ one, two }), MeasureCentered({ two, one }), 1e-9));
  BoxBody body;
  body.Add(one);
  const auto leaf = body.Make();
  CheckTrue("no time", !sm::MeasureShapes({ leaf->GetModel() }, 1e-12, 1e-9)[0].Problem.empty());
}
}

int TestPartMatch(int, char*[])
{
  CheckMoments();
  CheckRotations();
  CheckOthers();
  return Finish();
}
