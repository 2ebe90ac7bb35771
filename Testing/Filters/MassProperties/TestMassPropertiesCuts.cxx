// TestMassPropertiesCuts FOLDER: spheres, cylinders, cones and tori that planes cut near poles, apexes and
// seams, in STEP without parameter curves. Trim curves are the reader's, so that what they miss has to be in
// the bounds: volume and area against formulas.
#include "smStepText.h"
#include "smTestPipeline.h"
#include "smUnitRoundoff.h"

#include <vtkMath.h>

#include <cmath>
#include <cstdio>

namespace
{
using namespace smtest;
namespace names = sm::names;
using Point = StepText::Point;

std::string Folder;

std::string Number(double value)
{
  char text[40];
  std::snprintf(text, sizeof(text), "%.17E", value);
  return text;
}

/// A closed edge from a conic's start on its first axis.
std::string AddConic(
  StepText& text, const Point& center, const Point& axis, const Point& x, double a, double b)
{
  const std::string frame = text.AddFrame(center, axis, x);
  const std::string curve = a == b
    ? text.Add("CIRCLE(''," + frame + "," + Number(a) + ")")
    : text.Add("ELLIPSE(''," + frame + "," + Number(a) + "," + Number(b) + ")");
  const std::string start =
    text.AddVertex({ center[0] + a * x[0], center[1] + a * x[1], center[2] + a * x[2] });
  return text.Add("EDGE_CURVE(''," + start + "," + start + "," + curve + ",.T.)");
}

std::string AddLoop(StepText& text, const std::string& edge, bool forward, bool outer = true)
{
  return text.AddBound(text.AddEdgeLoop({ text.AddOriented(edge, forward) }), outer);
}

void CheckSolid(
  StepText& text, const std::vector<std::string>& faces, const std::string& name, double volume, double area)
{
  const std::string path = Folder + "/cut.step";
  text.Write(path, faces);
  Pipeline pipeline(path);
  pipeline.Mass->SetBackend(vtkMassPropertiesGPU::CPU);
  pipeline.Mass->Update();
  CheckTrue(name + ": status is ok", pipeline.Mass->GetStatus() == names::StatusOk,
    pipeline.Mass->GetStatus() + ": " + GetMessages(pipeline.Mass));
  vtkFieldData* fields = pipeline.Mass->GetOutput()->GetFieldData();
  const double bounds[2] = { GetFieldBound(fields, names::Volume),
    GetFieldBound(fields, names::SurfaceArea) };
  const double size = std::cbrt(volume);
  // The formulas themselves are good to a few roundings.
  Check(name + ": volume", volume, pipeline.Mass->GetVolume(), bounds[0] + 8.0 * sm::UnitRoundoff * volume,
    "the stated bound");
  Check(name + ": area", area, pipeline.Mass->GetSurfaceArea(), bounds[1] + 8.0 * sm::UnitRoundoff * area,
    "the stated bound");
  CheckRange(name + ": bound of the volume", 0.0, bounds[0], 1e-9 * volume, "the tolerance");
  CheckRange(name + ": bound of the area", 0.0, bounds[1], 1e-9 * area, "the tolerance");
  CheckRange(name + ": gap", 0.0, GetField(fields, names::MaxGap), 1e-9 * size, "edges lie on the surfaces");
}

/// The part of a sphere above z = h. Its axis is at an angle `off` away from the circle.
void CheckSphere(double h, double off, double turn)
{
  StepText text;
  const double radius = 3.0;
  const double angle = std::acos(h / radius) + off;
  const Point axis = { std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), std::cos(angle) };
  const Point x = std::abs(axis[2]) < 0.9 ? Point{ 0, 0, 1 } : Point{ 1, 0, 0 };
  const double r = std::sqrt(radius * radius - h * h);
  const std::string circle = AddConic(text, { 0, 0, h }, { 0, 0, 1 }, { 1, 0, 0 }, r, r);
  const std::string sphere =
    text.Add("SPHERICAL_SURFACE(''," + text.AddFrame({ 0, 0, 0 }, axis, x) + "," + Number(radius) + ")");
  const std::string plane =
    text.Add("PLANE(''," + text.AddFrame({ 0, 0, h }, { 0, 0, -1 }, { 1, 0, 0 }) + ")");
  char name[80];
  std::snprintf(name, sizeof(name), "sphere above %g, axis off by %g", h, off);
  const double pi = vtkMath::Pi();
  CheckSolid(text,
    { text.AddFace({ AddLoop(text, circle, true) }, sphere),
      text.AddFace({ AddLoop(text, circle, false) }, plane) },
    name, pi * std::pow(radius - h, 2) * (2.0 * radius + h) / 3.0,
    2.0 * pi * radius * (radius - h) + pi * r * r);
}

/// A cylinder (apex height 0) or a cone from z = 0 up to a plane through (0, 0, h) that is tilted in
/// direction `turn`.
void CheckTilted(double apex, double h, double tilt, double turn)
{
  StepText text;
  const double pi = vtkMath::Pi();
  const double radius = 2.0;
  const double sine = std::sin(tilt);
  const double cosine = std::cos(tilt);
  const double slope = apex > 0.0 ? radius / apex : 0.0;
  const Point normal = { sine * std::cos(turn), sine * std::sin(turn), cosine };
  const Point along = { cosine * std::cos(turn), cosine * std::sin(turn), -sine };
  // The ends of the ellipse's first axis, as distances from (0, 0, h).
  const double wide = apex > 0.0 ? (apex - h) * slope : radius;
  const double ends[2] = { wide / (cosine - sine * slope), -wide / (cosine + sine * slope) };
  const double middle = 0.5 * (ends[0] + ends[1]);
  const double a = 0.5 * (ends[0] - ends[1]);
  const double b =
    std::sqrt((wide + middle * (sine * slope - cosine)) * (wide + middle * (sine * slope + cosine)));
  const Point center = { middle * along[0], middle * along[1], h + middle * along[2] };
  const std::string top = AddConic(text, center, normal, along, a, tilt == 0.0 ? a : b);
  const std::string base = AddConic(text, { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, radius, radius);
  const std::string down = text.AddFrame({ 0, 0, 0 }, { 0, 0, -1 }, { 1, 0, 0 });
  const std::string side = text.Add((apex > 0.0 ? "CONICAL_SURFACE(''," : "CYLINDRICAL_SURFACE('',") + down +
    "," + Number(radius) + (apex > 0.0 ? "," + Number(std::atan(slope)) : std::string()) + ")");
  char name[80];
  std::snprintf(name, sizeof(name), "%s to %g, tilted by %g", apex > 0.0 ? "cone" : "cylinder", h, tilt);
  const double ellipse = pi * a * b;
  const double coneSine = slope / std::sqrt(1.0 + slope * slope);
  const double volume = apex > 0.0 ? (pi * radius * radius * apex - ellipse * (apex - h) * cosine) / 3.0
                                   : pi * radius * radius * h;
  const double lateral =
    apex > 0.0 ? (pi * radius * radius - ellipse * cosine) / coneSine : 2.0 * pi * radius * h;
  CheckSolid(text,
    { text.AddFace({ AddLoop(text, base, false) }, text.Add("PLANE(''," + down + ")")),
      text.AddFace(
        { AddLoop(text, top, true) }, text.Add("PLANE(''," + text.AddFrame(center, normal, along) + ")")),
      text.AddFace({ AddLoop(text, base, true), AddLoop(text, top, false, false) }, side) },
    name, volume, lateral + ellipse + pi * radius * radius);
}

/// The part of a torus above z = h.
void CheckTorus(double h, double turn)
{
  StepText text;
  const double pi = vtkMath::Pi();
  const double major = 6.0;
  const double minor = 2.0;
  const double w = std::sqrt(minor * minor - h * h);
  const std::string outer = AddConic(text, { 0, 0, h }, { 0, 0, 1 }, { 1, 0, 0 }, major + w, major + w);
  const std::string inner = AddConic(text, { 0, 0, h }, { 0, 0, 1 }, { 1, 0, 0 }, major - w, major - w);
  const std::string torus = text.Add("TOROIDAL_SURFACE(''," +
    text.AddFrame({ 0, 0, 0 }, { 0, 0, 1 }, { std::cos(turn), std::sin(turn), 0 }) + "," + Number(major) +
    "," + Number(minor) + ")");
  const std::string plane =
    text.Add("PLANE(''," + text.AddFrame({ 0, 0, h }, { 0, 0, -1 }, { 1, 0, 0 }) + ")");
  char name[80];
  std::snprintf(name, sizeof(name), "torus above %g, seam rotated by %g", h, turn);
  const double angle = std::acos(h / minor);
  CheckSolid(text,
    { text.AddFace({ AddLoop(text, outer, true), AddLoop(text, inner, false, false) }, torus),
      text.AddFace({ AddLoop(text, outer, false), AddLoop(text, inner, true, false) }, plane) },
    name, 2.0 * pi * major * (minor * minor * angle - h * w), 4.0 * pi * major * (minor * angle + w));
}
}

int TestMassPropertiesCuts(int argc, char* argv[])
{
  RequireUsage(argc == 2, "TestMassPropertiesCuts FOLDER");
  Folder = argv[1];
  double turn = 0.3;
  for (const double h : { 0.0, 1.3, -2.2, 2.99 })
  {
    for (const double off : { 0.3, 0.03, 1e-3, 1e-5, 1e-7, 1e-8, 1e-10, 0.0, -1e-3, -0.03, -0.3 })
    {
      CheckSphere(h, off, turn += 1.1);
    }
  }
  for (const double tilt : { 0.0, 1e-10, 1e-8, 1e-6, 1e-4, 0.01, 0.3, 0.8 })
  {
    CheckTilted(0.0, 5.0, tilt, turn += 1.1);
    CheckTilted(0.0, 5.0, tilt, 1e-9);
    for (const double below : { 1.0, 1e-2, 1e-4 })
    {
      CheckTilted(4.0, 4.0 - below, tilt, turn += 1.1);
    }
  }
  for (const double h : { 0.0, 1.3, -1.9 })
  {
    for (const double seam : { 0.0, 1e-9, -1e-6, 1.0 })
    {
      CheckTorus(h, seam);
    }
  }
  return Finish();
}
