// TestBREPReader SOLIDS OUTPUT: BREP files, text and binary, have the exact volumes of what they hold, from a
// file and from memory.
#include "smLeafBytes.h"
#include "smRoundTrip.h"
#include "smTestManifest.h"
#include "smTesting.h"

#include <vtkBREPReader.h>
#include <vtkBREPWriter.h>
#include <vtkDataAssembly.h>
#include <vtkMath.h>
#include <vtkNew.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace
{
using namespace smtest;

const double PlateVolume = 40.0 * 30.0 * 10.0 - vtkMath::Pi() * 25.0 * 10.0;
const double BallVolume = 4.0 / 3.0 * vtkMath::Pi() * 64.0;
std::string Folder;

TopoDS_Compound Join(const std::vector<TopoDS_Shape>& shapes)
{
  TopoDS_Compound compound;
  BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& shape : shapes)
  {
    builder.Add(compound, shape);
  }
  return compound;
}

TopoDS_Shape MakePlate()
{
  const TopoDS_Shape bore =
    BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(20.0, 15.0, -1.0), gp_Dir(0, 0, 1)), 5.0, 12.0).Shape();
  return TopExp_Explorer(
    BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(40.0, 30.0, 10.0).Shape(), bore).Shape(), TopAbs_SOLID)
    .Current();
}

TopLoc_Location Move(double x)
{
  gp_Trsf move;
  move.SetTranslation(gp_Vec(x, 0.0, 0.0));
  return move;
}

/// The mirror image on the plane x = 100, with geometry of its own: locations cannot mirror.
TopoDS_Shape Mirror(const TopoDS_Shape& shape)
{
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(100.0, 0.0, 0.0), gp_Dir(1, 0, 0)));
  return BRepBuilderAPI_Transform(shape, mirror, true).Shape();
}

std::string WriteText(const std::string& name, const TopoDS_Shape& shape)
{
  const std::string path = Folder + "/" + name;
  CheckTrue(name + " written", BRepTools::Write(shape, path.c_str()));
  return path;
}

std::vector<char> GetOutput(vtkBREPReader* reader)
{
  sm::ByteWriter leaves;
  sm::PutLeaves(reader->GetOutput(), leaves);
  return leaves.GetBytes();
}

Properties CheckFile(const std::string& path, int bodies, int instances, double volume, double factor = 1.0,
  const std::string& unit = "mm")
{
  const std::string name = path.substr(path.find_last_of('/') + 1);
  vtkNew<vtkBREPReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetInputUnit(unit);
  reader->Update();
  CheckEqual(name + ": status", "ok", reader->GetStatusAsString());
  CheckEqual(name + ": bodies", bodies, reader->GetNumberOfBodies());
  CheckEqual(name + ": instances", instances, reader->GetNumberOfInstances());
  CheckEqual(name + ": file unit", unit, reader->GetFileUnit());
  const Properties found = Weigh(reader->GetOutput(), 1e-11);
  CheckEqual(name + ": result", "ok", found.Status);
  // The file has 15 digits: a coordinate is off by 5e-16 of it.
  Check(name + ": volume", volume * factor, found.Volume, found.Bounds[0] + 1e-13 * volume * factor);
  return found;
}

void CheckProducts()
{
  const TopoDS_Shape plate = MakePlate();
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(4.0).Shape();
  const TopoDS_Compound pair = Join({ plate, ball.Located(Move(60.0)) });
  const TopoDS_Compound top =
    Join({ pair, pair.Located(Move(200.0)), Mirror(plate), ball.Located(Move(-50.0)) });
  const double volume = 3.0 * PlateVolume + 3.0 * BallVolume;
  const Properties text = CheckFile(WriteText("brep_products.brep", top), 3, 6, volume);
  // Plates at 20, 220 and, mirrored, 180; balls at 60, 260 and -50.
  Check("centre", (PlateVolume * (20.0 + 220.0 + 180.0) + BallVolume * (60.0 + 260.0 - 50.0)) / volume,
    text.Center[0], text.Bounds[2] + 1e-12);
  const std::string binary = Folder + "/brep_binary.bin.brep";
  CheckTrue("binary written", BinTools::Write(top, binary.c_str()));
  const Properties other = CheckFile(binary, 3, 6, volume);
  Check("text and binary", text.Volume, other.Volume, 1e-13 * volume);
  CheckFile(WriteText("brep_located.brep", top.Located(Move(1e4))), 3, 6, volume);
  CheckFile(
    WriteText("brep_reversed.brep", Join({ plate, ball.Reversed() })), 2, 2, PlateVolume + BallVolume);
  CheckFile(WriteText("brep_inch.brep", plate), 1, 1, PlateVolume, 25.4 * 25.4 * 25.4, "inch");

  vtkNew<vtkBREPReader> reader;
  reader->SetFileName((Folder + "/brep_products.brep").c_str());
  reader->Update();
  vtkDataAssembly* tree = reader->GetOutput()->GetDataAssembly();
  CheckEqual("root", "BREP", tree->GetRootNodeName());
  CheckEqual("its label", "brep_products", tree->GetAttributeOrDefault(0, "label", ""));
  CheckEqual("children of the top", 4, tree->GetNumberOfChildren(tree->GetChild(0, 0)));
}

/// A solid without faces encloses nothing: the total is that of the others, with its bound, and suspect.
void CheckEmptySolid()
{
  TopoDS_Solid empty;
  BRep_Builder().MakeSolid(empty);
  vtkNew<vtkBREPReader> reader;
  reader->SetFileName(WriteText("brep_empty_solid.brep", Join({ MakePlate(), empty })).c_str());
  reader->Update();
  const Properties found = Weigh(reader->GetOutput(), 1e-11);
  CheckEqual("an empty solid: result", "suspect", found.Status);
  Check("  volume", PlateVolume, found.Volume, found.Bounds[0] + 1e-13 * PlateVolume);
  CheckTrue("  its bound", found.Bounds[0] > 0.0 && found.Bounds[0] < 1e-10 * PlateVolume,
    std::to_string(found.Bounds[0]));
}

/// The uses of the seams of a whole torus meet at one vertex, so that their order in the wire is free.
void CheckTorus()
{
  const double volume = 80.0 * vtkMath::Pi() * vtkMath::Pi();
  const TopoDS_Face face =
    TopoDS::Face(TopExp_Explorer(BRepPrimAPI_MakeTorus(10.0, 2.0).Shape(), TopAbs_FACE).Current());
  std::vector<TopoDS_Shape> uses;
  for (TopoDS_Iterator it(TopExp_Explorer(face, TopAbs_WIRE).Current()); it.More(); it.Next())
  {
    uses.push_back(it.Value());
  }
  CheckEqual("uses of two seams", 4, static_cast<int>(uses.size()));
  const std::vector<std::vector<std::size_t>> orders = { { 0, 1, 2, 3 }, { 1, 0, 2, 3 }, { 2, 1, 0, 3 },
    { 3, 2, 1, 0 }, { 0, 2, 1, 3 }, { 3, 1, 2, 0 } };
  for (const std::vector<std::size_t>& order : orders)
  {
    BRep_Builder builder;
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (const std::size_t i : order)
    {
      builder.Add(wire, uses[i]);
    }
    TopoDS_Face whole = TopoDS::Face(face.EmptyCopied());
    builder.Add(whole, wire);
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    builder.Add(shell, whole);
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    builder.Add(solid, shell);
    vtkNew<vtkBREPReader> reader;
    reader->SetFileName(WriteText("brep_torus.brep", solid).c_str());
    reader->Update();
    const auto found = Weigh(reader->GetOutput(), 1e-9);
    CheckEqual("a whole torus", "ok", found.Status);
    Check("  volume", volume, found.Volume, found.Bounds[0] + 1e-13 * volume);
    Check("  area", volume, found.Area, 1e-9 * volume);
  }
}

void CheckFaces()
{
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(), 0.0, 7.0, 0.0, 8.0).Face();
  vtkNew<vtkBREPReader> reader;
  reader->SetFileName(WriteText("brep_beside.brep", Join({ MakePlate(), face })).c_str());
  reader->Update();
  CheckEqual("a face outside a solid: bodies", 1, reader->GetNumberOfBodies());
  CheckEqual("free faces", 1, reader->GetNumberOfFreeFaces());
  CheckEqual("and a message",
    "1 face of the file lies outside its solids; it belongs to no body and is left out.",
    reader->GetMessage(0));
  CheckEqual("its result", "ok", Weigh(reader->GetOutput(), 1e-11).Status);
  const TopoDS_Shape shell = TopExp_Explorer(MakePlate(), TopAbs_SHELL).Current();
  reader->SetFileName(
    WriteText("brep_shell.brep", Join({ BRepPrimAPI_MakeSphere(4.0).Shape(), shell })).c_str());
  reader->Update();
  CheckEqual("a closed shell outside a solid: bodies", 1, reader->GetNumberOfBodies());
  CheckEqual("makes the result", "suspect", Weigh(reader->GetOutput(), 1e-11).Status);
  reader->SetFileName(WriteText("brep_faces.brep", Join({ face, face.Located(Move(7.0)) })).c_str());
  reader->Update();
  CheckEqual("two faces alone: bodies", 1, reader->GetNumberOfBodies());
  Check("their area", 112.0, Weigh(reader->GetOutput()).Area, 1e-10);
}

void CheckWays()
{
  vtkNew<vtkBREPReader> reader;
  reader->SetFileName((Folder + "/brep_products.brep").c_str());
  reader->SetInputUnit("cm");
  reader->Update();
  const std::vector<char> here = GetOutput(reader);
  std::ifstream file(Folder + "/brep_products.brep", std::ios::binary);
  const std::string bytes{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  CheckEqual("bytes of a BREP file", 1, vtkBREPReader::CanReadContent(bytes));
  CheckEqual("other bytes", 0, vtkBREPReader::CanReadContent("ISO-10303-21;"));
  vtkNew<vtkBREPReader> memory;
  memory->SetContent(bytes);
  memory->SetFileName("brep_products.brep");
  memory->SetInputUnit("cm");
  memory->Update();
  CheckTrue("from memory: the same bits", GetOutput(memory) == here && here.size() > 100);
  CheckEqual("messages", 0, memory->GetNumberOfMessages());
}

void CheckRoundTrip(const std::string& solids)
{
  for (const char* const variant : { "plain", "mirrored" })
  {
    for (const Expected& solid : Manifest(solids).GetVariant(variant))
    {
      const auto data = ReadFile(solid.Path);
      const std::string path = Folder + "/brep_round.brep";
      vtkNew<vtkBREPWriter> writer;
      writer->SetInputDataObject(data);
      writer->SetFileName(path.c_str());
      CheckEqual(solid.Solid + " written", 1, writer->Write());
      vtkNew<vtkBREPReader> reader;
      reader->SetFileName(path.c_str());
      reader->SetLinearDeflection(0.05);
      reader->Update();
      CompareProperties(solid.Solid + ", " + variant, data, reader->GetOutput(), 1e-13, solid.GetDistance());
    }
  }
}
}

int TestBREPReader(int argc, char** argv)
{
  if (argc < 3)
  {
    return 1;
  }
  Folder = argv[2];
  CheckProducts();
  CheckTorus();
  CheckEmptySolid();
  CheckFaces();
  CheckWays();
  CheckRoundTrip(argv[1]);
  return Finish();
}
