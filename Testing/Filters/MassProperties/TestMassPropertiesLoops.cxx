// TestMassPropertiesLoops FOLDER: solids from hand-written STEP whose faces have loops that touch, several
// outer loops, loops that are one vertex, and edges shorter than any tolerance: volumes from formulas.
#include "smStepText.h"
#include "smTestPipeline.h"

#include <vtkMath.h>

#include <cstdio>

namespace
{
using namespace smtest;
namespace names = sm::names;
using Corner = StepPrism::Corner;
using Polygon = StepPrism::Polygon;

std::string Folder;
void CheckVolume(const std::string& name, double volume, double relative, const char* reason,
  const std::string& status = names::StatusOk)
{
  std::printf("--- %s\n", name.c_str());
  Pipeline pipeline(Folder + "/loops_" + name + ".step");
  MessageTrap reader(pipeline.Reader);
  MessageTrap filter(pipeline.Mass);
  pipeline.Mass->Update();
  CheckEqual("errors", "", reader.Errors + filter.Errors);
  CheckTrue("status is " + status, pipeline.Mass->GetStatus() == status,
    pipeline.Mass->GetStatus() + ": " + GetMessages(pipeline.Mass));
  Check("volume", volume, pipeline.Mass->GetVolume(), relative * volume, reason);
  vtkFieldData* fields = pipeline.Mass->GetOutput()->GetFieldData();
  CheckEqual("open edges", 0, static_cast<long long>(GetField(fields, names::OpenEdges)));
  CheckEqual("flipped shells", 0, static_cast<long long>(GetField(fields, names::FlippedShells)));
}

void WritePrism(const std::string& name, const std::vector<Polygon>& polygons)
{
  StepPrism().Write(Folder + "/loops_" + name + ".step", polygons, 3.0);
}

/// A square from (x,y), counter-clockwise or not, its corners numbered from `number`.
Polygon Square(double x, double y, double side, int number, bool outer)
{
  Polygon square{ { { x, y, number }, { x + side, y, number + 1 }, { x + side, y + side, number + 2 },
                    { x, y + side, number + 3 } },
    outer };
  if (!outer)
  {
    std::swap(square.Corners[1], square.Corners[3]);
  }
  return square;
}

void CheckPolygons()
{
  const char* exact = "planes: rounding";
  const Polygon outer = Square(0.0, 0.0, 10.0, 0, true);
  WritePrism("plain", { outer });
  CheckVolume("plain", 300.0, 1e-12, exact);
  WritePrism("hole", { outer, Square(2.0, 2.0, 3.0, 10, false) });
  CheckVolume("hole", 273.0, 1e-12, exact);

  // Two holes that share a vertex, and two that merely touch there.
  Polygon second = Square(5.0, 5.0, 2.0, 20, false);
  WritePrism("holes_touching", { outer, Square(2.0, 2.0, 3.0, 10, false), second });
  CheckVolume("holes_touching", 300.0 - 27.0 - 12.0, 1e-12, exact);
  second.Corners[0].Number = 12;
  WritePrism("holes_sharing", { outer, Square(2.0, 2.0, 3.0, 10, false), second });
  CheckVolume("holes_sharing", 300.0 - 27.0 - 12.0, 1e-12, exact);
  // A hole whose corner lies on the outer loop's edge, where that has no vertex.
  WritePrism(
    "hole_at_the_border", { outer, { { { 0.0, 5.0, 10 }, { 3.0, 7.0, 11 }, { 3.0, 3.0, 12 } }, false } });
  CheckVolume("hole_at_the_border", 300.0 - 18.0, 1e-12, exact);
  // A hole that shares a vertex with the outer loop.
  WritePrism(
    "hole_at_a_corner", { outer, { { { 0.0, 0.0, 0 }, { 2.0, 4.0, 11 }, { 4.0, 2.0, 12 } }, false } });
  CheckVolume("hole_at_a_corner", 300.0 - 18.0, 1e-12, exact);
  // A loop that passes through one of its own vertices twice.
  WritePrism("bow_tie",
    { { { { 0, 0, 0 }, { 5, 5, 1 }, { 10, 0, 2 }, { 10, 10, 3 }, { 5, 5, 1 }, { 0, 10, 4 } }, true } });
  CheckVolume("bow_tie", 150.0, 1e-12, exact);

  // Two and three outer loops on one face.
  WritePrism("two_outer_loops", { outer, Square(20.0, 0.0, 5.0, 10, true) });
  CheckVolume("two_outer_loops", 300.0 + 75.0, 1e-12, exact);
  WritePrism("three_outer_loops",
    { outer, Square(2.0, 2.0, 3.0, 30, false), Square(20.0, 0.0, 5.0, 10, true),
      Square(0.0, 20.0, 5.0, 20, true) });
  CheckVolume("three_outer_loops", 273.0 + 150.0, 1e-12, exact);

  // Edges of a tenth, and of a thousandth, of the file's accuracy of 1e-7.
  for (const double length : { 1e-8, 1e-10 })
  {
    const std::string name = length > 1e-9 ? "tiny_edge" : "tinier_edge";
    WritePrism(
      name, { { { { 0, 0, 0 }, { 10, 0, 1 }, { 10, length, 2 }, { 10, 10, 3 }, { 0, 10, 4 } }, true } });
    CheckVolume(name, 300.0, 1e-9, "the length of the edge times the face");
  }

  // An isolated vertex in a face: it bounds nothing.
  StepPrism prism;
  prism.BottomBounds.push_back(
    prism.Text.AddBound(prism.Text.AddVertexLoop(prism.Text.AddVertex({ 4.0, 4.0, 0.0 })), false));
  prism.Write(Folder + "/loops_vertex_in_a_face.step", { outer }, 3.0);
  CheckVolume("vertex_in_a_face", 300.0, 1e-12, exact);
}

/// A cone bounded by a circle and by the vertex at its tip, without a seam.
void CheckCone()
{
  StepText text;
  const double radius = 3.0;
  const double height = 4.0;
  const std::string start = text.AddVertex({ radius, 0, 0 });
  const std::string frame = text.AddFrame({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 });
  char number[40];
  std::snprintf(number, sizeof(number), "%.1f", radius);
  const std::string circle = text.Add("CIRCLE(''," + frame + "," + number + ")");
  const std::string edge = text.Add("EDGE_CURVE(''," + start + "," + start + "," + circle + ",.T.)");
  const std::string down = text.AddFrame({ 0, 0, 0 }, { 0, 0, -1 }, { 1, 0, 0 });
  const std::string base =
    text.AddFace({ text.AddBound(text.AddEdgeLoop({ text.AddOriented(edge, false) }), true) },
      text.Add("PLANE(''," + down + ")"));
  char angle[40];
  std::snprintf(angle, sizeof(angle), "%.17g", std::atan2(radius, height));
  // The surface opens along its axis: from the base, downwards.
  const std::string surface = text.Add("CONICAL_SURFACE(''," + down + "," + number + "," + angle + ")");
  const std::string side =
    text.AddFace({ text.AddBound(text.AddEdgeLoop({ text.AddOriented(edge, true) }), true),
                   text.AddBound(text.AddVertexLoop(text.AddVertex({ 0, 0, height })), false) },
      surface);
  text.Write(Folder + "/loops_cone.step", { base, side });
  CheckVolume("cone", vtkMath::Pi() * radius * radius * height / 3.0, 1e-9, "the tolerance");
}

/// A sphere and a torus, each one face bounded by a vertex.
void CheckRound()
{
  StepText sphere;
  const std::string frame = sphere.AddFrame({ 1, 2, 3 }, { 0, 0, 1 }, { 1, 0, 0 });
  const std::string ball =
    sphere.AddFace({ sphere.AddBound(sphere.AddVertexLoop(sphere.AddVertex({ 1, 2, -2 })), true) },
      sphere.Add("SPHERICAL_SURFACE(''," + frame + ",5.)"));
  sphere.Write(Folder + "/loops_sphere.step", { ball });
  CheckVolume("sphere", 4.0 / 3.0 * vtkMath::Pi() * 125.0, 1e-9, "the tolerance");

  StepText torus;
  const std::string axis = torus.AddFrame({ 1, 2, 3 }, { 0, 0, 1 }, { 1, 0, 0 });
  const std::string ring =
    torus.AddFace({ torus.AddBound(torus.AddVertexLoop(torus.AddVertex({ 9, 2, 3 })), true) },
      torus.Add("TOROIDAL_SURFACE(''," + axis + ",6.,2.)"));
  torus.Write(Folder + "/loops_torus.step", { ring });
  CheckVolume("torus", 2.0 * vtkMath::Pi() * vtkMath::Pi() * 6.0 * 4.0, 1e-9, "the tolerance");
}
}

int TestMassPropertiesLoops(int argc, char* argv[])
{
  RequireUsage(argc == 2, "TestMassPropertiesLoops FOLDER");
  Folder = argv[1];
  CheckPolygons();
  CheckCone();
  CheckRound();
  return Finish();
}
