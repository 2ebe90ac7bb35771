// TestBREPReaderErrors OUTPUT: what is not a BREP file, or a part of one, is an error that says so; damage
// ends no process that isolates it.
#include "smMessageTrap.h"
#include "smTesting.h"

#include <vtkBREPReader.h>
#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSetCollection.h>

#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>

#include <fstream>
#include <random>
#include <sstream>
#include <string>

namespace
{
using namespace smtest;

std::string OutputFolder;

std::string Make(const std::string& name, const std::string& content)
{
  const std::string path = OutputFolder + "/" + name;
  std::ofstream(path, std::ios::binary) << content;
  return path;
}

void CheckProblem(vtkBREPReader* reader, const std::string& what, const std::string& part)
{
  const MessageTrap trap(reader);
  reader->Modified();
  reader->Update();
  CheckEqual(what + ": status", "unreadable", reader->GetStatusAsString());
  CheckEqual(what + ": errors", 1, trap.NumberOfErrors);
  CheckTrue(what + ": says " + part, trap.Errors.find(part) != std::string::npos, trap.Errors);
  CheckTrue(what + ": error code", reader->GetErrorCode() != vtkErrorCode::NoError);
  CheckEqual(what + ": output", 0, reader->GetOutput()->GetNumberOfPartitionedDataSets());
}

/// Parts of a binary file: none is read as if it were whole.
void CheckBinary()
{
  std::ostringstream stream;
  BinTools::Write(BRepPrimAPI_MakeCylinder(5.0, 12.0).Shape(), stream);
  const std::string sound = stream.str();
  vtkNew<vtkBREPReader> reader;
  const MessageTrap trap(reader);
  reader->SetMaximumSeconds(2.0);
  for (const double share : { 0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99 })
  {
    reader->SetContent(sound.substr(0, static_cast<std::size_t>(share * static_cast<double>(sound.size()))));
    reader->Update();
    CheckTrue(
      "a part of a binary file", reader->GetStatus() >= vtkBREPReader::UNREADABLE, std::to_string(share));
  }
  reader->SetContent(sound);
  reader->SetMaximumSeconds(0.0);
  reader->Update();
  CheckEqual("a binary file", "ok", reader->GetStatusAsString());
}

/// What FreeCAD's exportBinary() writes: the shapes as OpenCASCADE does, and then three numbers of four
/// bytes.
std::string WriteAsFreeCAD(const TopoDS_Shape& shape)
{
  std::ostringstream stream;
  BinTools_ShapeSet shapes;
  const int number = shapes.Add(shape);
  const int location = shapes.Locations().Index(shape.Location());
  shapes.Write(stream);
  for (const int value : { number, location, static_cast<int>(shape.Orientation()) })
  {
    BinTools::PutInteger(stream, value);
  }
  return stream.str();
}

/// Files of few and of many shapes, of which OpenCASCADE reads another one.
void CheckFreeCAD(vtkBREPReader* reader)
{
  TopoDS_Compound many;
  BRep_Builder().MakeCompound(many);
  for (int count = 0; count < 100; ++count)
  {
    BRep_Builder().Add(many, BRepPrimAPI_MakeCylinder(5.0, 12.0).Shape());
    if (count % 9 == 0)
    {
      reader->SetFileName(Make("brep_freecad.brep", WriteAsFreeCAD(many)).c_str());
      CheckProblem(reader, "a binary file of FreeCAD, " + std::to_string(count), "a binary BREP of FreeCAD");
    }
  }
}

TopoDS_Shape Nest(TopoDS_Shape shape, int levels, int copies)
{
  BRep_Builder builder;
  for (int i = 0; i < levels; ++i)
  {
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    for (int k = 0; k < copies; ++k)
    {
      builder.Add(compound, shape);
    }
    shape = compound;
  }
  return shape;
}

/// Files of more instances or levels than the reader accepts; 2^17 is the first power above its limit.
void CheckExcess(vtkBREPReader* reader)
{
  const TopoDS_Shape solid = BRepPrimAPI_MakeCylinder(5.0, 12.0).Shape();
  const TopoDS_Shape face = TopExp_Explorer(solid, TopAbs_FACE).Current();
  const std::string path = OutputFolder + "/brep_nested.brep";
  reader->SetFileName(path.c_str());
  BRepTools::Write(Nest(solid, 17, 2), path.c_str());
  CheckProblem(reader, "2^17 solids", "more than 100000 instances");
  BRepTools::Write(Nest(face, 17, 2), path.c_str());
  CheckProblem(reader, "2^17 faces", "more than 100000 instances");
  BRepTools::Write(Nest(solid, 200, 1), path.c_str());
  CheckProblem(reader, "200 levels", "nested more than 100 times");
}

/// Files with a number, a word or a byte that is another one: each ends with a status, and the next sound
/// file is read.
void CheckDamage(const std::string& sound)
{
  vtkNew<vtkBREPReader> reader;
  const MessageTrap trap(reader);
  reader->SetMaximumSeconds(2.0);
  std::mt19937 random(7);
  int counts[4] = { 0, 0, 0, 0 };
  for (int i = 0; i < 12; ++i)
  {
    std::string damaged = sound;
    const std::size_t at = 60 + random() % (damaged.size() - 70);
    switch (i % 3)
    {
      case 0:
        damaged[at] = static_cast<char>('0' + random() % 10);
        break;
      case 1:
        damaged.erase(at, 1 + random() % 20);
        break;
      default:
        damaged.insert(at, " 99999999 ");
    }
    reader->SetContent(damaged);
    reader->Update();
    ++counts[reader->GetStatus()];
  }
  std::printf("ok, empty, unreadable, aborted: %d %d %d %d\n", counts[0], counts[1], counts[2], counts[3]);
  CheckTrue("some are read and some are not", counts[0] > 0 && counts[2] > 0);
  reader->SetContent(sound);
  reader->SetMaximumSeconds(0.0);
  reader->Update();
  CheckEqual("and a sound one", "ok", reader->GetStatusAsString());
}
}

int TestBREPReaderErrors(int argc, char** argv)
{
  if (argc < 2)
  {
    return 1;
  }
  OutputFolder = argv[1];
  std::ostringstream stream;
  BRepTools::Write(BRepPrimAPI_MakeCylinder(5.0, 12.0).Shape(), stream);
  const std::string sound = stream.str();
  vtkNew<vtkBREPReader> reader;
  CheckProblem(reader, "no name", "no file name was given");
  reader->SetFileName("/nowhere/part.brep");
  CheckProblem(reader, "no file", "it cannot be opened");
  reader->SetFileName(Make("brep_empty.brep", "").c_str());
  CheckProblem(reader, "an empty file", "it is empty");
  reader->SetFileName(Make("brep_step.brep", "ISO-10303-21;\nHEADER;\n").c_str());
  CheckProblem(reader, "a STEP file", "it is not a BREP file");
  CheckEqual("its content says STEP", 0, vtkBREPReader::CanReadFile(reader->GetFileName()));
  CheckEqual("a name that says BREP", 1, vtkBREPReader::CanReadFile(Make("brep_text.brep", "text").c_str()));
  for (const double share : { 0.05, 0.3, 0.6, 0.9, 0.97 })
  {
    const auto length = static_cast<std::size_t>(share * static_cast<double>(sound.size()));
    reader->SetFileName(Make("brep_part.brep", sound.substr(0, length)).c_str());
    CheckProblem(reader, "a part of a file", "it ends in the middle");
  }
  reader->SetFileName(Make("brep_stripped.brep", sound.substr(0, sound.find_last_not_of(" \n") + 1)).c_str());
  reader->Update();
  CheckEqual("a file without its last line end", "ok", reader->GetStatusAsString());
  // As OpenCASCADE's test harness saves a shape.
  const std::string drawn = "DBRep_DrawableShape\n" + sound + "\n0\n";
  for (const std::string& text :
    { drawn, drawn.substr(0, drawn.size() - 1), drawn.substr(0, drawn.size() - 3) })
  {
    reader->SetFileName(Make("brep_drawn.brep", text).c_str());
    reader->Update();
    CheckEqual("a file of DRAW", "ok", reader->GetStatusAsString());
    CheckEqual("its bodies", 1, reader->GetNumberOfBodies());
  }
  for (const double share : { 0.3, 0.9, 0.97 })
  {
    const auto length = static_cast<std::size_t>(share * static_cast<double>(drawn.size()));
    reader->SetFileName(Make("brep_drawn.brep", drawn.substr(0, length)).c_str());
    CheckProblem(reader, "a part of a file of DRAW", "it ends in the middle");
  }
  reader->SetFileName(Make("brep_numbered.brep", sound + "\n0\n").c_str());
  CheckProblem(reader, "a number behind a file that is not of DRAW", "it ends in the middle");
  CheckBinary();
  CheckFreeCAD(reader);
  CheckExcess(reader);
  reader->SetFileName(Make("brep_sound.txt", sound).c_str());
  CheckEqual("a BREP file of another name", 1, vtkBREPReader::CanReadFile(reader->GetFileName()));
  reader->SetInputUnit("mile");
  CheckProblem(reader, "unit", "InputUnit \"mile\" is not known");
  reader->SetInputUnit("mm");
  reader->Update();
  CheckEqual("a sound file", "ok", reader->GetStatusAsString());
  CheckDamage(sound);
  return Finish();
}
