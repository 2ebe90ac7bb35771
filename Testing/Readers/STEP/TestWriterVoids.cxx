// TestWriterVoids OUTPUT: the writers reverse voids that are oriented like the outer shell, and no others.
// Solids that OpenCASCADE makes are read, written, and integrated by OpenCASCADE.
#include "smRoundTrip.h"
#include "smWriterFiles.h"

#include <vtkBREPReader.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include <array>
#include <cmath>
#include <vector>

namespace
{
using namespace smtest;

using Ring = std::vector<std::array<double, 2>>;

/// A prism between two z; its normals point outwards.
struct Prism
{
  Ring Profile;
  double Low = 0.0;
  double High = 0.0;

  double GetVolume() const
  {
    double twice = 0.0;
    for (std::size_t i = 0; i < this->Profile.size(); ++i)
    {
      const auto& p = this->Profile[i];
      const auto& q = this->Profile[(i + 1) % this->Profile.size()];
      twice += p[0] * q[1] - p[1] * q[0];
    }
    return 0.5 * twice * (this->High - this->Low);
  }

  TopoDS_Shell Make() const
  {
    BRepBuilderAPI_MakePolygon polygon;
    for (const auto& p : this->Profile)
    {
      polygon.Add(gp_Pnt(p[0], p[1], this->Low));
    }
    polygon.Close();
    BRepPrimAPI_MakePrism prism(
      BRepBuilderAPI_MakeFace(polygon.Wire(), true).Face(), gp_Vec(0.0, 0.0, this->High - this->Low));
    const TopExp_Explorer shell(prism.Shape(), TopAbs_SHELL);
    return TopoDS::Shell(shell.Current());
  }
};

Prism MakeBox(double x, double y, double z, double dx, double dy, double dz)
{
  return { { { x, y }, { x + dx, y }, { x + dx, y + dy }, { x, y + dy } }, z, z + dz };
}

/// A base from y = 0 to `base`, and fins on it of this width and of height 70, one per unit of x.
Prism MakeComb(int fins, double width, double base, double low, double high)
{
  const double top = base + 70.0;
  Ring ring{ { 0.0, 0.0 }, { static_cast<double>(fins), 0.0 } };
  for (int k = fins; k-- > 0;)
  {
    const double right = k + 1.0;
    const double left = right - width;
    ring.insert(ring.end(), { { right, top }, { left, top }, { left, base }, { double(k), base } });
  }
  return { ring, low, high };
}

/// A shell of a solid: 1 as an outer shell, -1 as a void.
struct Part
{
  Prism Shape;
  int Side = 1;
};

/// Writes the shells as a solid to a BREP file, reads it and writes it by both writers. The volume is that
/// of the shells with `sides`. Returns the messages of the STEP writer.
std::string CheckSolid(const std::string& name, const std::vector<Part>& parts, const std::vector<int>& sides)
{
  const BRep_Builder builder;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  double volume = 0.0;
  double stated = 0.0;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const TopoDS_Shape shell = parts[i].Shape.Make();
    builder.Add(solid, parts[i].Side > 0 ? shell : shell.Reversed());
    stated += parts[i].Side * parts[i].Shape.GetVolume();
    volume += sides[i] * parts[i].Shape.GetVolume();
  }
  const std::string path = Output + "/" + name + "-made.brep";
  CheckTrue(name + ": made", BRepTools::Write(solid, path.c_str()));
  Check(name + ": volume that was made", stated, ViewBREP(path).Volume, 1e-9 * std::fabs(stated));

  vtkNew<vtkBREPReader> reader;
  const MessageTrap trap(reader);
  reader->SetFileName(path.c_str());
  reader->Update();
  const auto models = GetModels(reader->GetOutputDataObject(0));
  CheckEqual(name + ": solids", 1, static_cast<long long>(models.size()));
  if (models.empty())
  {
    return "";
  }
  CheckEqual(name + ": shells", static_cast<long long>(parts.size()),
    static_cast<long long>(models[0]->GetShells().size()));
  const std::string saved = Output + "/" + name + ".brep";
  vtkNew<vtkBREPWriter> writer;
  writer->SetInputDataObject(reader->GetOutputDataObject(0));
  writer->SetFileName(saved.c_str());
  CheckEqual(name + ": written", 1, writer->Write());
  Check(name + ": OpenCASCADE's volume of the file", volume, ViewBREP(saved).Volume, 1e-9 * std::fabs(volume),
    "planar faces");
  std::string messages;
  for (int i = 0; i < writer->GetNumberOfMessages(); ++i)
  {
    messages += writer->GetMessage(i) + "\n";
  }
  return messages;
}

void CheckQuiet(const std::string& name, const std::vector<Part>& parts, const std::vector<int>& sides)
{
  const std::string messages = CheckSolid(name, parts, sides);
  CheckTrue(name + ": nothing to say", messages.empty(), messages);
}

void CheckWarned(
  const std::string& name, const std::vector<Part>& parts, const std::vector<int>& sides, int shells)
{
  const std::string messages = CheckSolid(name, parts, sides);
  const std::string expected =
    "not certain that " + std::to_string(shells) + " of the " + std::to_string(parts.size()) + " shells";
  CheckTrue(name + ": a warning", messages.find(expected) != std::string::npos, messages);
}
}

int TestWriterVoids(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::fprintf(stderr, "usage: TestWriterVoids OUTPUT\n");
    return 1;
  }
  Output = MakeFolder(argv[1], "writers-voids");

  // A heat sink, whose volume is small for its area; a box is within the box of an L, but not in the L.
  const Prism sink = MakeComb(100, 0.2, 30.0, 0.0, 100.0);
  const Prism angle{ { { 5, 5 }, { 95, 5 }, { 95, 8 }, { 8, 8 }, { 8, 25 }, { 5, 25 } }, 10.0, 90.0 };
  const Prism room = MakeBox(40.0, 12.0, 30.0, 20.0, 10.0, 30.0);
  Check("sink: volume", 408320.0, sink.GetVolume() - angle.GetVolume() - room.GetVolume(), 1e-6);
  CheckQuiet("sink", { { sink }, { angle, -1 }, { room, -1 } }, { 1, -1, -1 });
  CheckQuiet("sink_angle", { { sink }, { angle, 1 }, { room, -1 } }, { 1, -1, -1 });
  CheckQuiet("sink_room", { { sink }, { angle, -1 }, { room, 1 } }, { 1, -1, -1 });
  CheckQuiet("sink_both", { { sink }, { angle, 1 }, { room, 1 } }, { 1, -1, -1 });
  CheckQuiet("sink_inside_out", { { sink, -1 }, { angle, 1 }, { room, 1 } }, { -1, 1, 1 });

  const Prism box = MakeBox(0.0, 0.0, 0.0, 100.0, 90.0, 80.0);
  const Prism hollow = MakeBox(10.0, 10.0, 10.0, 60.0, 60.0, 60.0);
  CheckQuiet("box", { { box }, { hollow, -1 } }, { 1, -1 });
  CheckQuiet("box_inverted", { { box }, { hollow, 1 } }, { 1, -1 });

  // A body in a void is none; nothing is done to a shell that may be one.
  const Prism island = MakeBox(20.0, 20.0, 20.0, 10.0, 10.0, 10.0);
  CheckWarned("island", { { box }, { hollow, -1 }, { island, 1 } }, { 1, -1, 1 }, 1);
  // The outer shell is not the first: the two voids have the same orientation, and the right one.
  CheckWarned("void_first", { { angle, -1 }, { room, -1 }, { sink } }, { -1, -1, 1 }, 1);
  // A void outside.
  CheckWarned("outside", { { hollow }, { MakeBox(200, 0, 0, 5, 5, 5), 1 } }, { 1, 1 }, 1);
  // A void of many thin fins: its sign is below the errors of OpenCASCADE's quadrature.
  const Prism around = MakeBox(-1.0, -1.0, -1.0, 102.0, 90.0, 102.0);
  const Prism comb = MakeComb(100, 0.004, 0.02, 0.0, 100.0);
  CheckWarned("thin_void", { { around }, { comb, 1 } }, { 1, 1 }, 1);
  CheckWarned("thin_void_right", { { around }, { comb, -1 } }, { 1, -1 }, 1);
  return Finish();
}
