// TestSTEPRepairReasons FOLDER: trim curves off their edges are a reason for a repair; a torus with a
// negative radius, a pole on an edge, edges that run against both their loops and shells that are not
// connected are none, and these are parted all the same. One face that lies off its edges is repaired by
// itself. FOLDER takes the file.
#include "smIntegralNames.h"
#include "smOCCTImport.h"
#include "smReaderTesting.h"
#include "smRepair.h"

#include "vtkMassPropertiesGPU.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkTrimmedNURBSModel.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Shell.hxx>

#include <cmath>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace smtest;

std::string WriteShape(const std::string& name, const TopoDS_Shape& shape, STEPControl_StepModelType type)
{
  STEPControl_Writer writer;
  writer.Transfer(shape, type);
  const std::string path = Folder + "/" + name;
  writer.Write(path.c_str());
  return path;
}

/// The message about repairs.
std::string GetRepairs(vtkSTEPReader* reader)
{
  std::string repairs;
  for (int i = 0; i < reader->GetNumberOfMessages(); ++i)
  {
    const std::string message = reader->GetMessage(i);
    repairs += message.find("repaired by OpenCASCADE") != std::string::npos ? message : "";
  }
  return repairs;
}

/// Gives the rim of the bore at height 10 another trim curve on the bore: a parabola through (pole, 10 +
/// bump) half way.
void SetTrim(const sm::BodyShape& bored, double pole, double bump)
{
  bool isDone = false;
  bored.VisitFaces(
    [&](const sm::FaceUse& face)
    {
      const bool isBore = sm::FindElementary(*face.Face->Surface, sm::ElementarySurface::Type::Cylinder);
      for (std::size_t i = 0; isBore && i < face.Face->Wires.size(); ++i)
      {
        for (sm::CoedgeShape& use : face.Face->Wires[i].Coedges)
        {
          const sm::Point2 a = use.Trim->Evaluate(use.First);
          const sm::Point2 b = use.Trim->Evaluate(use.Last);
          if (!isDone && std::abs(a[1] - 10.0) < 1e-9 && std::abs(b[1] - 10.0) < 1e-9)
          {
            sm::SplineCurve<2> parabola;
            parabola.Basis.Degree = 2;
            parabola.Basis.Knots = { use.First, use.Last };
            parabola.Basis.Multiplicities = { 3, 3 };
            parabola.Poles = { a, { (1.0 - pole) * a[0] + pole * b[0], 10.0 + bump }, b };
            std::string problem;
            use.Trim = sm::GeometricCurve<2>::Make(parabola, problem);
            isDone = true;
          }
        }
      }
    });
}

TopoDS_Shape MakeBoredBox()
{
  const TopoDS_Shape bore =
    BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(20.0, 15.0, 0.0), gp_Dir(0, 0, 1)), 5.0, 10.0).Shape();
  const TopoDS_Shape bored = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(40.0, 30.0, 10.0).Shape(), bore).Shape();
  return TopExp_Explorer(bored, TopAbs_SOLID).Current();
}

/// Trim curves that leave their edges between the ends, where the loops close all the same, and one at
/// another speed.
void CheckTrimReasons()
{
  sm::ShapeImport import;
  sm::BodyShape solid = sm::MakeBody(import.MakeGroup(MakeBoredBox()).Solids.at(0));
  sm::SoundFaceTable faces;
  const auto check = [&](const char* name, double pole, double bump, bool isSound)
  {
    SetTrim(solid, pole, bump);
    faces.clear();
    CheckEqual(name, isSound ? "" : "a face: an edge lies off it", sm::FindShapeDamage(solid, faces).Problem);
    CheckEqual("  faces taken as they are", isSound ? 7 : 0, static_cast<int>(faces.size()));
  };
  check("trim on its edge", 0.5, 0.0, true);
  check("trim on its edge at another speed", 0.3, 0.0, true);
  check("trim off its edge by a thousandth of the size", 0.5, -0.1, false);
  check("trim off its edge, off the surface's face", 0.5, 0.1, false);
  check("trim off its edge by less than gaps may be", 0.5, -0.01, true);
}

std::vector<TopoDS_Shape> MakeBoxFaces(const gp_Pnt& corner)
{
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(BRepPrimAPI_MakeBox(corner, 1.0, 2.0, 3.0).Shell(), TopAbs_FACE); it.More();
       it.Next())
  {
    faces.push_back(it.Current());
  }
  return faces;
}

/// A shell of two faces that share an edge, and one elsewhere.
void CheckShells()
{
  const std::vector<TopoDS_Shape> faces = MakeBoxFaces(gp_Pnt());
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  // The first two lie opposite each other.
  for (const TopoDS_Shape& face : { faces[0], MakeBoxFaces(gp_Pnt(9.0, 0.0, 0.0))[0], faces[2] })
  {
    builder.Add(shell, face);
  }
  const std::string path = WriteShape("repair_shells.step", shell, STEPControl_ShellBasedSurfaceModel);
  for (const int repair : { vtkSTEPReader::ALWAYS, vtkSTEPReader::ON_NEED })
  {
    vtkNew<vtkSTEPReader> reader;
    reader->SetRepair(repair);
    reader->SetFileName(path.c_str());
    reader->Update();
    CheckEqual("connected parts are bodies", 2, reader->GetNumberOfBodies());
    for (unsigned int i = 0; reader->GetNumberOfBodies() == 2 && i < 2; ++i)
    {
      CheckEqual("faces of a part", i == 0 ? 2 : 1, GetLeaf(reader, i)->GetModel()->GetNumberOfFaces());
      CheckTrue("number in the file", GetLeaf(reader, i)->GetModel()->GetFileId() > 0);
    }
    CheckEqual("no repairs but where asked for", "", GetRepairs(reader));
  }
}

/// The solid is read as it is in the file and has this volume. The greatest gap is returned.
double CheckVolume(const std::string& name, const std::string& content, int faces, double volume)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(Make("repair_volume.step", content).c_str());
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetInputConnection(reader->GetOutputPort());
  mass->SetBackend(vtkMassPropertiesGPU::CPU);
  mass->Update();
  CheckEqual(name + ": not repaired", "", GetRepairs(reader));
  CheckEqual("  faces", faces, GetLeaf(reader, 0)->GetModel()->GetNumberOfFaces());
  CheckTrue("  volume", std::abs(mass->GetVolume() - volume) <= mass->GetVolumeBound() + 1e-12 * volume,
    std::to_string(mass->GetVolume() - volume));
  return mass->GetOutput()->GetFieldData()->GetArray(sm::names::MaxGap)->GetTuple1(0);
}

/// The text of a file without parameter curves.
std::string WriteEdgesOnly(const TopoDS_Shape& shape)
{
  Interface_Static::SetIVal("write.surfacecurve.mode", 0);
  const std::string text = ReadAll(WriteShape("repair_edges.step", shape, STEPControl_AsIs));
  Interface_Static::SetIVal("write.surfacecurve.mode", 1);
  return text;
}

/// A torus with a negative major radius is the same surface with its other side outside. OpenCASCADE's
/// transfer turns the loops of its face alone. A torus whose face has the wrong sense, on the other hand, is
/// repaired, and said.
void CheckTurnedTorus()
{
  const std::string text = WriteEdgesOnly(BRepPrimAPI_MakeTorus(30.0, 5.0, 1.5).Solid());
  std::smatch torus;
  CheckTrue(
    "a torus", std::regex_search(text, torus, std::regex("(#[0-9]+) = TOROIDAL_SURFACE\\('',#[0-9]+,30\\.")));
  const std::string flipped = std::regex_replace(
    text, std::regex("(ADVANCED_FACE\\('',\\([^)]*\\)," + torus[1].str() + ",)\\.T\\."), "$1.F.");
  const std::string turned =
    std::regex_replace(flipped, std::regex("(TOROIDAL_SURFACE\\('',#[0-9]+,)30\\."), "$1-30.");
  CheckTrue("the files differ", text.size() + 1 == turned.size());
  const double volume = vtkMath::Pi() * 25.0 * 30.0 * 1.5;
  CheckVolume("torus", text, 3, volume);
  CheckVolume("torus with a negative radius", turned, 3, volume);
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(Make("repair_flipped.step", flipped).c_str());
  reader->Update();
  const std::string repairs = GetRepairs(reader);
  CheckTrue("a face with the wrong sense", !repairs.empty(), repairs);
}

/// Reads a solid, and returns the messages that contain a text; a volume other than `volume`, within bound
/// and gaps, is an error.
std::string FindMessages(
  const std::string& name, const std::string& content, int faces, double volume, const std::string& part)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(Make("repair_faces.step", content).c_str());
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetInputConnection(reader->GetOutputPort());
  mass->SetBackend(vtkMassPropertiesGPU::CPU);
  mass->Update();
  const double allowed = mass->GetVolumeBound() + 1e-12 * volume +
    mass->GetOutput()->GetFieldData()->GetArray(sm::names::GapSquared)->GetTuple1(0);
  CheckTrue(name + ": volume", std::abs(mass->GetVolume() - volume) <= allowed,
    std::to_string(mass->GetVolume() - volume));
  CheckEqual("  faces", faces, GetLeaf(reader, 0)->GetModel()->GetNumberOfFaces());
  CheckEqual("  status", std::string("ok"), std::string(mass->GetStatus()));
  std::string found;
  for (int i = 0; i < reader->GetNumberOfMessages(); ++i)
  {
    const std::string message = reader->GetMessage(i);
    found += message.find(part) != std::string::npos ? message : "";
  }
  return found;
}

/// Reverses the uses of some edges of the first loop of a box, in this loop only, or in all loops.
std::string TurnUses(const std::string& text, int count, bool isEverywhere)
{
  std::smatch loop;
  std::regex_search(
    text, loop, std::regex("EDGE_LOOP\\('',\\((#[0-9]+),(#[0-9]+),(#[0-9]+),(#[0-9]+)\\)\\)"));
  std::string result = text;
  for (int i = 1; i <= count; ++i)
  {
    std::smatch use;
    std::regex_search(
      text, use, std::regex("\n" + loop[i].str() + " = ORIENTED_EDGE\\('',\\*,\\*,(#[0-9]+),"));
    const std::string head = isEverywhere ? "#[0-9]+" : loop[i].str();
    const std::string uses = "(\n" + head + " = ORIENTED_EDGE\\('',\\*,\\*," + use[1].str() + ",)";
    result = std::regex_replace(result, std::regex(uses + "\\.T\\."), "$1.X.");
    result = std::regex_replace(result, std::regex(uses + "\\.F\\."), "$1.T.");
    result = std::regex_replace(result, std::regex(uses + "\\.X\\."), "$1.F.");
  }
  return result;
}

/// Edges of a box that run against both their loops are reversed in these; an edge that runs against one of
/// them only is repaired. In a bored box whose bore lies off its edges only this face is repaired.
void CheckFaceRepairs()
{
  const std::string text = WriteEdgesOnly(BRepPrimAPI_MakeBox(40.0, 30.0, 10.0).Solid());
  const std::string against = "run against their loops";
  CheckEqual("a box", "", FindMessages("a box", text, 6, 12000.0, "of the file"));
  for (int count = 1; count <= 4; ++count)
  {
    const std::string name = std::to_string(count) + " edges against their loops";
    const std::string turned = TurnUses(text, count, true);
    CheckTrue("the files differ", turned != text && turned.size() == text.size());
    CheckEqual(name, "", FindMessages(name, turned, 6, 12000.0, "repaired by OpenCASCADE"));
    const std::string message = FindMessages(name, turned, 6, 12000.0, against);
    CheckTrue(
      name, message.find(std::to_string(2 * count) + " uses were reversed") != std::string::npos, message);
  }
  const std::string one =
    FindMessages("one use", TurnUses(text, 1, false), 6, 12000.0, "repaired by OpenCASCADE");
  CheckTrue("a use against its loop", one.find("do not agree about their sides") != std::string::npos, one);
  // Ribbons in the planes at both ends close what is between the bore and its edges.
  const TopoDS_Shape bored = MakeBoredBox();
  const std::string wide = std::regex_replace(
    WriteEdgesOnly(bored), std::regex("(CYLINDRICAL_SURFACE\\('',#[0-9]+,)5\\."), "$015.02");
  const std::string message = FindMessages(
    "a bore off its edges", wide, 7, 12000.0 - 252.004 * vtkMath::Pi(), "repaired by OpenCASCADE");
  CheckTrue("  one face", message.find("1 single face of 1 of 1 solids") == 0, message);
}

/// Half a sphere whose rim passes both poles, or where x leaves the sphere, or both; or near the poles, at a
/// thirtieth to a thousandth of the radius, where the angle turns so fast that the trim curve needs many
/// pieces: OpenCASCADE's approximation is off the edge by some hundredths of the radius there.
void CheckPolesOnEdges()
{
  const std::string text =
    WriteEdgesOnly(BRepPrimAPI_MakeSphere(3.0, 0.0, 0.5 * vtkMath::Pi(), 2.0 * vtkMath::Pi()).Solid());
  std::smatch sphere;
  CheckTrue("a sphere", std::regex_search(text, sphere, std::regex("SPHERICAL_SURFACE\\('',(#[0-9]+),3\\.")));
  for (const auto& [axis, reference] :
    std::vector<std::pair<std::string, std::string>>{ { "0.,0.,1.", "1.,0.,0." },
      { "0.6,0.8,0.", "0.,0.,1." }, { "0.6,0.8,0.", "-0.8,0.6,0." }, { "0.6,0.8,0.03", "0.,0.,1." },
      { "0.6,0.8,-0.03", "-0.8,0.6,0." }, { "0.6,0.8,0.001", "0.,0.,1." } })
  {
    const std::string placed = std::regex_replace(text,
      std::regex(sphere[1].str() + " = AXIS2_PLACEMENT_3D\\('',(#[0-9]+),#[0-9]+,#[0-9]+\\);"),
      "#900001=DIRECTION('',(" + axis + "));#900002=DIRECTION('',(" + reference + "));" + sphere[1].str() +
        "=AXIS2_PLACEMENT_3D('',$1,#900001,#900002);");
    CheckTrue("other poles", placed.size() > text.size());
    const double gap = CheckVolume("poles at " + axis, placed, 2, 18.0 * vtkMath::Pi());
    CheckRange("  greatest gap", 0.0, gap, 1e-11);
  }
}
}

int TestSTEPRepairReasons(int argc, char* argv[])
{
  if (argc < 2)
  {
    return 1;
  }
  Folder = argv[1];
  CheckTrimReasons();
  CheckShells();
  CheckTurnedTorus();
  CheckFaceRepairs();
  CheckPolesOnEdges();
  return Finish();
}
