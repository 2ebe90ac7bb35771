/**
 * @file TestSTEPRewrites.cxx
 * @brief Files that say the same in another way, and files with a flag that makes edges overlap
 *
 * MutantSweep.py rewrites files and turns their flags; here are the kinds that it found. Lines that are
 * revolved or extruded have no ends, so that faces on them were left to OpenCASCADE's repair where the file
 * has no parameter curves. An arc with the wrong sense covers its neighbours on the same circle.
 */
#include "smReaderTesting.h"
#include "smStepText.h"

#include "smComputeMassProperties.h"

#include "vtkMath.h"
#include "vtkNew.h"

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS_Shape.hxx>

#include <cmath>
#include <string>
#include <vector>

namespace
{
using namespace smtest;

const double Pi = vtkMath::Pi();

/// What is said of a file, and its numbers.
struct Rewritten
{
  std::string Messages;
  sm::MassPropertiesResult Result;
};

Rewritten ReadRewritten(const std::string& path)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  Rewritten reading;
  for (int i = 0; i < reader->GetNumberOfMessages(); ++i)
  {
    reading.Messages += std::string(reader->GetMessage(i)) + "\n";
  }
  reading.Result = sm::ComputeMassProperties(reader->GetOutputDataObject(0));
  return reading;
}

std::string AddCircle(StepText& step, double radius, double z, const std::string& vertex)
{
  const std::string circle = step.Add(
    "CIRCLE(''," + step.AddFrame({ 0, 0, z }, { 0, 0, 1 }, { 1, 0, 0 }) + "," + std::to_string(radius) + ")");
  return step.Add("EDGE_CURVE(''," + vertex + "," + vertex + "," + circle + ",.T.)");
}

std::string AddLine(StepText& step, const StepText::Point& origin, const StepText::Point& along)
{
  return step.Add("LINE(''," + step.AddPoint(origin) + "," +
    step.Add("VECTOR(''," + step.AddDirection(along) + ",1.)") + ")");
}

/// A plane z = `z` as the extrusion of a line; its normal is `side` times the axis.
std::string AddExtrudedPlane(StepText& step, double z, double side)
{
  return step.Add("SURFACE_OF_LINEAR_EXTRUSION(''," + AddLine(step, { 3, 5, z }, { 1, 0, 0 }) + "," +
    step.Add("VECTOR(''," + step.AddDirection({ 0.3, side, 0 }) + ",2.)") + ")");
}

/// Revolves the line between two points round the axis z; the disks at its ends are planes that are extruded.
/// A point on the axis is an apex.
void CheckRevolvedLine(
  const std::string& name, const StepText::Point& start, const StepText::Point& end, double volume)
{
  StepText step;
  const StepText::Point along = { end[0] - start[0], end[1] - start[1], end[2] - start[2] };
  const std::string axis =
    step.Add("AXIS1_PLACEMENT(''," + step.AddPoint({ 0, 0, 7 }) + "," + step.AddDirection({ 0, 0, 1 }) + ")");
  // The line begins off its edge.
  const StepText::Point origin = { start[0] - along[0], start[1] - along[1], start[2] - along[2] };
  const std::string side =
    step.Add("SURFACE_OF_REVOLUTION(''," + AddLine(step, origin, along) + "," + axis + ")");
  std::vector<std::string> vertices;
  std::vector<std::string> circles;
  std::vector<std::string> faces;
  for (const StepText::Point& point : { start, end })
  {
    const double radius = std::hypot(point[0], point[1]);
    vertices.push_back(step.AddVertex(point));
    if (radius > 0.0)
    {
      const bool isTop = vertices.size() == 2;
      circles.push_back(AddCircle(step, radius, point[2], vertices.back()));
      faces.push_back(
        step.AddFace({ step.AddBound(step.AddEdgeLoop({ step.AddOriented(circles.back(), isTop) }), true) },
          AddExtrudedPlane(step, point[2], isTop ? 1.0 : -1.0)));
    }
  }
  const std::string seam = step.AddLine(vertices[0], vertices[1], start, end);
  std::vector<std::string> loop = { step.AddOriented(circles[0], true), step.AddOriented(seam, true) };
  if (circles.size() > 1)
  {
    loop.push_back(step.AddOriented(circles[1], false));
  }
  loop.push_back(step.AddOriented(seam, false));
  faces.push_back(step.AddFace({ step.AddBound(step.AddEdgeLoop(loop), true) }, side));
  const std::string path = Folder + "/rewrite.step";
  step.Write(path, faces);
  const Rewritten reading = ReadRewritten(path);
  CheckEqual(name, "ok", reading.Result.Total.Status);
  CheckEqual("  no messages", "", reading.Messages);
  // The radii and the seam are rounded.
  const auto& value = reading.Result.Total.Volume;
  Check("  volume", volume, value.Value, value.Bound + 1e-14 * volume);
  CheckRange("  its bound", 0.0, value.Bound / volume, 1e-9);
}

/// Turns the sense of each edge of a ball of radius 1 with a unit cube on it. Arcs end on the seam of the
/// ball, so that one with the other sense covers the arc beyond the seam.
void CheckReversedEdges()
{
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(1.0).Shape();
  const TopoDS_Shape cube = BRepPrimAPI_MakeBox(gp_Pnt(0.5, -0.5, -0.5), 1.0, 1.0, 1.0).Shape();
  STEPControl_Writer writer;
  writer.Transfer(BRepAlgoAPI_Fuse(ball, cube).Shape(), STEPControl_AsIs);
  const std::string path = Folder + "/rewrite_boss.step";
  writer.Write(path.c_str());
  const std::string text = ReadAll(path);
  const double volume = ReadRewritten(path).Result.Total.Volume.Value;
  // By an integral over the part of the cube beyond the ball.
  Check("ball with a cube", 4.77782435777, volume, 1e-9);
  int edges = 0;
  const std::string word = "= EDGE_CURVE(";
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
  {
    const std::size_t flag = text.find(')', at) - 2;
    std::string turned = text;
    turned[flag] = turned[flag] == 'T' ? 'F' : 'T';
    const Rewritten reading = ReadRewritten(Make("rewrite_turned.step", turned));
    const double other = reading.Result.Total.Volume.Value;
    CheckTrue("edge " + std::to_string(++edges) + " reversed",
      reading.Result.Total.Status != "ok" || std::abs(other - volume) < 1e-9, std::to_string(other));
  }
  CheckTrue("all edges", edges > 15);
}
}

int TestSTEPRewrites(int argc, char* argv[])
{
  Folder = argc > 1 ? argv[1] : ".";
  CheckRevolvedLine("cylinder", { 1, 0, 0 }, { 1, 0, 2 }, 2.0 * Pi);
  CheckRevolvedLine("frustum", { 2, 0, 0 }, { 1, 0, 1 }, Pi * 7.0 / 3.0);
  CheckRevolvedLine("cone", { 0, 2, 0 }, { 0, 0, 2 }, Pi * 8.0 / 3.0);
  CheckRevolvedLine("hyperboloid", { 1, -1, -1 }, { 1, 1, 1 }, Pi * 8.0 / 3.0);

  CheckReversedEdges();
  return Finish();
}
