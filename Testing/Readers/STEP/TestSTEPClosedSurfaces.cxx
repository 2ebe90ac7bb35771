/**
 * @file TestSTEPClosedSurfaces.cxx
 * @brief Balls and ellipsoids with flats, holes and knobs, written by OpenCASCADE, against closed forms
 *
 * OpenCASCADE writes the parameter curve of a cut seam a whole turn of its circle away, where v is beyond the
 * poles of the sphere, and the profile of an ellipsoid as a whole ellipse, whose revolution has every point
 * twice.
 */
#include "smReaderTesting.h"
#include "smStepText.h"

#include "smComputeMassProperties.h"

#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Elips.hxx>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <regex>
#include <string>

namespace
{
using namespace smtest;

const double Pi = vtkMath::Pi();

/// The argument of the test, whose modes run at the same time and write files of their own.
std::string ShapeMode;

std::string WriteShape(const TopoDS_Shape& shape, bool hasTrims)
{
  Interface_Static::SetIVal("write.surfacecurve.mode", hasTrims ? 1 : 0);
  STEPControl_Writer writer;
  writer.Transfer(shape, STEPControl_AsIs);
  const std::string path = Folder + "/closed_surface_" + ShapeMode + ".step";
  writer.Write(path.c_str());
  Interface_Static::SetIVal("write.surfacecurve.mode", 1);
  return path;
}

/// OpenCASCADE's intersection curves are good to about 1e-7 of a length.
void CheckFile(const std::string& title, const std::string& path, double expected)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  const sm::MassPropertiesResult result = sm::ComputeMassProperties(reader->GetOutputDataObject(0));
  CheckEqual(title, "ok", result.Total.Status);
  Check("  volume", expected, result.Total.Volume.Value, 2e-9 * expected);
}

/// Writes a shape and compares what is read with the volume.
void CheckShape(const std::string& name, const TopoDS_Shape& shape, double expected)
{
  for (const bool hasTrims : { true, false })
  {
    CheckFile(name + (hasTrims ? "" : ", no parameter curves"), WriteShape(shape, hasTrims), expected);
  }
}

/// Replaces the ellipse that is revolved in a file by a closed spline which begins and ends on the equator.
std::string ReplaceProfile(const std::string& path, double a, double c)
{
  std::string text = ReadAll(path);
  std::smatch found;
  CheckTrue("a profile", std::regex_search(text, found, std::regex("SURFACE_OF_REVOLUTION\\('',(#[0-9]+)")));
  text.replace(
    static_cast<std::size_t>(found.position(1)), static_cast<std::size_t>(found.length(1)), "#900100");
  const int x[] = { 1, 1, 0, -1, -1, -1, 0, 1, 1 };
  const int z[] = { 0, 1, 1, 1, 0, -1, -1, -1, 0 };
  std::string entities;
  std::string poles;
  std::string weights;
  for (int i = 0; i < 9; ++i)
  {
    const std::string id = "#" + std::to_string(900101 + i);
    entities +=
      id + "=CARTESIAN_POINT('',(" + std::to_string(a * x[i]) + ",0.," + std::to_string(c * z[i]) + "));\n";
    poles += (i == 0 ? "" : ",") + id;
    weights += std::string(i == 0 ? "" : ",") + (i % 2 == 0 ? "1." : "0.70710678118654752");
  }
  entities += "#900100=(BOUNDED_CURVE()B_SPLINE_CURVE(2,(" + poles +
    "),.UNSPECIFIED.,.F.,.F.)B_SPLINE_CURVE_WITH_KNOTS((3,2,2,2,3),(0.,1.,2.,3.,4.),.UNSPECIFIED.)CURVE()"
    "GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((" +
    weights + "))REPRESENTATION_ITEM(''));\n";
  return Make("closed_surface_spline.step", text.insert(text.rfind("ENDSEC;"), entities));
}

/// The half space beyond a plane at this distance from the origin, as a large box.
TopoDS_Shape MakeBeyond(const gp_Dir& direction, double distance)
{
  gp_Ax2 frame(gp_Pnt(distance * direction.XYZ()), direction);
  frame.SetLocation(
    gp_Pnt(frame.Location().XYZ() - 40.0 * (frame.XDirection().XYZ() + frame.YDirection().XYZ())));
  return BRepPrimAPI_MakeBox(frame, 80.0, 80.0, 80.0).Shape();
}

TopoDS_Shape MakeRod(const gp_Pnt& start, const gp_Dir& direction, double radius, double length)
{
  return BRepPrimAPI_MakeCylinder(gp_Ax2(start, direction), radius, length).Shape();
}

/// Volume of a cap of the unit ball beyond this distance from the centre.
double GetCap(double distance)
{
  const double height = 1.0 - distance;
  return Pi * height * height * (3.0 - height) / 3.0;
}

const gp_Dir Directions[] = { gp_Dir(0, 0, 1), gp_Dir(1, 0, 0), gp_Dir(0, 1, 0), gp_Dir(1, 1, 1),
  gp_Dir(-2, 1, -3) };

void CheckBalls()
{
  const double ball = 4.0 / 3.0 * Pi * 1000.0;
  const double bead = 4.0 / 3.0 * Pi * std::pow(91.0, 1.5);
  for (const gp_Dir& axis : { gp_Dir(0, 0, 1), gp_Dir(1, 2, 3) })
  {
    const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(gp_Ax2(gp_Pnt(), axis), 10.0).Shape();
    for (const gp_Dir& d : Directions)
    {
      CheckShape(
        "ball with a flat", BRepAlgoAPI_Cut(sphere, MakeBeyond(d, 8.0)).Shape(), ball - 1000.0 * GetCap(0.8));
      CheckShape("ball with a hole",
        BRepAlgoAPI_Cut(sphere, MakeRod(gp_Pnt(-20.0 * d.XYZ()), d, 3.0, 40.0)).Shape(), bead);
      CheckShape("ball with a knob", BRepAlgoAPI_Fuse(sphere, MakeRod(gp_Pnt(), d, 3.0, 14.0)).Shape(),
        ball + Pi * 9.0 * 14.0 - 0.5 * (ball - bead));
    }
  }
}

/// Parameter curves of the rims of a bead that begin elsewhere on their circles of latitude, a turn beyond a
/// pole or on its other side, are the curves of their edges all the same.
/// A wall that is thinner than the deviation of the triangles by which shells are compared.
void CheckThinWall()
{
  const double radius = 10.001;
  const TopoDS_Shape halves = BRepAlgoAPI_Fuse(BRepPrimAPI_MakeSphere(radius, -Pi / 2.0, 0.0).Shape(),
    BRepPrimAPI_MakeSphere(radius, 0.0, Pi / 2.0).Shape());
  const TopoDS_Shape hollow = BRepAlgoAPI_Cut(halves, BRepPrimAPI_MakeSphere(10.0).Shape());
  CheckShape("a hollow ball of two halves", hollow, 4.0 / 3.0 * Pi * (std::pow(radius, 3.0) - 1000.0));
}

void CheckFarTrims()
{
  const TopoDS_Shape bead = BRepAlgoAPI_Cut(
    BRepPrimAPI_MakeSphere(10.0).Shape(), MakeRod(gp_Pnt(0, 0, -20), gp_Dir(0, 0, 1), 3.0, 40.0))
                              .Shape();
  const std::string text = ReadAll(WriteShape(bead, true));
  const double latitude = std::acos(0.3);
  char number[40];
  std::snprintf(number, sizeof number, "%.12f", latitude);
  const std::regex point("CARTESIAN_POINT\\('',\\(([^,]*),(-?)" + std::string(number) + "\\)\\)");
  for (const double beyond : { 2.0 * Pi + latitude, Pi - latitude, latitude + 0.1 })
  {
    // A later start, as a curve that is compared at equal parameters would have it.
    const std::string changed =
      std::regex_replace(text, point, "CARTESIAN_POINT('',(0.7,$02" + std::to_string(beyond) + "))");
    CheckTrue("the files differ", changed != text);
    vtkNew<vtkSTEPReader> reader;
    reader->SetFileName(Make("closed_surface_far.step", changed).c_str());
    reader->Update();
    bool isTold = false;
    for (int i = 0; i < reader->GetNumberOfMessages(); ++i)
    {
      isTold = isTold || std::string(reader->GetMessage(i)).find("from its curve") != std::string::npos;
    }
    CheckEqual("a trim curve at " + std::to_string(beyond), beyond == latitude + 0.1, isTold);
  }
}

/// Half an ellipse with x >= 0 and semi-axes a along x and c along z about the height z; with `isUpper` its
/// upper quarter. `turn` reverses the first axis of the ellipse (1) or its direction (2).
TopoDS_Edge MakeProfile(double a, double c, double z, bool isUpper, int turn)
{
  gp_Dir x = a > c ? gp_Dir(1, 0, 0) : gp_Dir(0, 0, 1);
  x = turn == 1 ? x.Reversed() : x;
  const gp_Elips ellipse(
    gp_Ax2(gp_Pnt(0, 0, z), gp_Dir(0, turn == 2 ? 1 : -1, 0), x), std::max(a, c), std::min(a, c));
  const gp_Pnt low = isUpper ? gp_Pnt(a, 0, z) : gp_Pnt(0, 0, z - c);
  const gp_Pnt high(0, 0, z + c);
  return turn == 2 ? BRepBuilderAPI_MakeEdge(ellipse, high, low).Edge()
                   : BRepBuilderAPI_MakeEdge(ellipse, low, high).Edge();
}

TopoDS_Edge MakeSide(double x0, double z0, double x1, double z1)
{
  return BRepBuilderAPI_MakeEdge(gp_Pnt(x0, 0, z0), gp_Pnt(x1, 0, z1)).Edge();
}

TopoDS_Shape Revolve(std::initializer_list<TopoDS_Edge> edges)
{
  BRepBuilderAPI_MakeWire wire;
  for (const TopoDS_Edge& edge : edges)
  {
    wire.Add(edge);
  }
  return BRepPrimAPI_MakeRevol(
    BRepBuilderAPI_MakeFace(wire.Wire(), true).Face(), gp_Ax1(gp_Pnt(), gp_Dir(0, 0, 1)))
    .Shape();
}

void CheckEllipsoids()
{
  for (const bool isLong : { false, true })
  {
    const double a = isLong ? 8.0 : 12.0;
    const double c = isLong ? 13.0 : 7.0;
    const double whole = 4.0 / 3.0 * Pi * a * a * c;
    for (const int turn : { 0, 1, 2 })
    {
      const TopoDS_Shape egg = Revolve({ MakeProfile(a, c, 0, false, turn), MakeSide(0, c, 0, -c) });
      CheckShape("ellipsoid", egg, whole);
      for (const gp_Dir& d : { gp_Dir(0, 0, 1), gp_Dir(1, 0, 0), gp_Dir(-1, 0.2, 0), gp_Dir(1, -2, 1.5) })
      {
        const double width = std::sqrt(a * a * (d.X() * d.X() + d.Y() * d.Y()) + c * c * d.Z() * d.Z());
        const TopoDS_Shape flattened = BRepAlgoAPI_Cut(egg, MakeBeyond(d, 0.6 * width)).Shape();
        const double volume = whole - a * a * c * GetCap(0.6);
        CheckShape("ellipsoid with a flat", flattened, volume);
        if (turn == 0 && !isLong)
        {
          // The part between its poles passes the ends of the spline.
          CheckFile("  of a closed spline", ReplaceProfile(WriteShape(flattened, false), a, c), volume);
        }
      }
      CheckShape("ellipsoid with a hole along its axis",
        BRepAlgoAPI_Cut(egg, MakeRod(gp_Pnt(0, 0, -20), gp_Dir(0, 0, 1), 3.0, 40.0)).Shape(),
        whole * std::pow(1.0 - 9.0 / (a * a), 1.5));
      CheckShape("dome",
        Revolve({ MakeProfile(a, c, 5, true, turn), MakeSide(0, 5 + c, 0, 0), MakeSide(0, 0, a, 0),
          MakeSide(a, 0, a, 5) }),
        2.0 / 3.0 * Pi * a * a * c + Pi * a * a * 5.0);
      CheckShape("dished end",
        Revolve({ MakeProfile(a, c, 5, true, turn), MakeSide(0, 5 + c, 0, 4 + c),
          MakeProfile(a - 1, c - 1, 5, true, turn), MakeSide(a - 1, 5, a - 1, 0), MakeSide(a - 1, 0, a, 0),
          MakeSide(a, 0, a, 5) }),
        2.0 / 3.0 * Pi * (a * a * c - (a - 1) * (a - 1) * (c - 1)) + Pi * 5.0 * (2.0 * a - 1.0));
    }
  }
}

/// A circle that is revolved about a chord crosses itself: without edges nothing says whether its outer or
/// its inner part is meant.
void CheckChord()
{
  for (const double sign : { 1.0, -1.0 })
  {
    StepText text;
    const std::string frame =
      text.AddFrame({ sign, 0, 0 }, { 0, -1, 0 }, { -1.0 / 3.0, 0, -std::sqrt(8.0) / 3.0 });
    const std::string circle = text.Add("CIRCLE(''," + frame + ",3.)");
    const std::string axis = text.Add(
      "AXIS1_PLACEMENT(''," + text.AddPoint({ 0, 0, 0 }) + "," + text.AddDirection({ 0, 0, 1 }) + ")");
    const std::string surface = text.Add("SURFACE_OF_REVOLUTION(''," + circle + "," + axis + ")");
    const std::string loop = text.AddVertexLoop(text.AddVertex({ 0, 0, std::sqrt(8.0) }));
    const std::string path = Folder + "/chord.step";
    text.Write(path, { text.AddFace({ text.AddBound(loop, false) }, surface) });
    vtkNew<vtkSTEPReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    const sm::MassPropertiesResult result = sm::ComputeMassProperties(reader->GetOutputDataObject(0));
    CheckEqual("a circle about a chord", "suspect", result.Total.Status);
    bool isTold = false;
    for (int i = 0; i < reader->GetNumberOfMessages(); ++i)
    {
      isTold = isTold || std::string(reader->GetMessage(i)).find("crosses its own axis") != std::string::npos;
    }
    for (const sm::BodyMassProperties& solid : result.Solids)
    {
      for (const std::string& message : solid.Messages)
      {
        isTold = isTold || message.find("crosses its own axis") != std::string::npos;
      }
    }
    CheckTrue("  with a message", isTold);
  }
}
}

int TestSTEPClosedSurfaces(int argc, char* argv[])
{
  if (argc < 3)
  {
    return 1;
  }
  Folder = argv[1];
  ShapeMode = argv[2];
  if (ShapeMode == "balls")
  {
    CheckBalls();
    CheckThinWall();
    CheckFarTrims();
  }
  else
  {
    CheckEllipsoids();
    CheckChord();
  }
  return Finish();
}
