#include "smSpecialFiles.h"

#include "smExactSolids.h"
#include "smStepFile.h"

#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace smtest
{
namespace
{
void WriteText(const std::string& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
}

std::string ReadText(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

TopoDS_Shell MakeOpenBoxShell()
{
  BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  TopExp_Explorer explorer(BRepPrimAPI_MakeBox(30.0, 20.0, 10.0).Shape(), TopAbs_FACE);
  for (explorer.Next(); explorer.More(); explorer.Next())
  {
    builder.Add(shell, explorer.Current());
  }
  return shell;
}

TopoDS_Shape MakeOpenSolid()
{
  BRep_Builder builder;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, MakeOpenBoxShell());
  return solid;
}

/// A frustum that is not symmetric about its part's origin, so that a wrong placement shows in every value.
TopoDS_Shape MakePart()
{
  return BRepPrimAPI_MakeCone(3.0, 2.0, 5.0).Shape();
}

ExactMoments PartMoments()
{
  return ConeFrustum(3, 2, 5);
}

SpecialFile WriteAssembly(const std::string& folder)
{
  Handle(TDocStd_Document) document;
  const Handle(XCAFApp_Application) application = XCAFApp_Application::GetApplication();
  application->NewDocument("MDTV-XCAF", document);
  const Handle(XCAFDoc_ShapeTool) tool = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const TDF_Label part = tool->AddShape(MakePart(), false);
  TDataStd_Name::Set(part, "frustum");
  const TDF_Label assembly = tool->NewShape();
  TDataStd_Name::Set(assembly, "five hundred");
  SpecialFile special;
  special.Name = "assembly";
  special.File = "assembly.step";
  special.Solids = AssemblyInstances;
  for (int i = 0; i < AssemblyInstances; ++i)
  {
    const Placement placement = GetAssemblyPlacement(i);
    const Matrix& r = placement.Rotation;
    auto entry = [&](int row, int column) { return static_cast<double>(r[row][column]); };
    auto shift = [&](int row) { return static_cast<double>(placement.Translation[row]); };
    gp_Trsf transform;
    transform.SetValues(entry(0, 0), entry(0, 1), entry(0, 2), shift(0), entry(1, 0), entry(1, 1),
      entry(1, 2), shift(1), entry(2, 0), entry(2, 1), entry(2, 2), shift(2));
    tool->AddComponent(assembly, part, TopLoc_Location(transform));
    const ExactMoments instance = Moved(PartMoments(), placement);
    special.Total = i == 0 ? instance : Combined(special.Total, instance, +1);
  }
  tool->UpdateAssemblies();
  special.Size = 300;
  Interface_Static::SetIVal("write.surfacecurve.mode", 1);
  Interface_Static::SetCVal("write.step.unit", "MM");
  STEPCAFControl_Writer writer;
  if (!writer.Transfer(document) || writer.Write((folder + "/" + special.File).c_str()) != IFSelect_RetDone)
  {
    throw std::runtime_error("OCCT cannot write the assembly");
  }
  application->Close(document);
  return special;
}

SpecialFile WriteTwoSolids(const std::string& folder)
{
  BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  builder.Add(compound, BRepPrimAPI_MakeBox(30.0, 20.0, 10.0).Shape());
  builder.Add(compound, BRepPrimAPI_MakeSphere(gp_Pnt(60.0, 10.0, 5.0), 10.0).Shape());
  WriteStep(compound, folder + "/two_solids.step");
  Placement placement;
  placement.Translation = { 60, 10, 5 };
  return { "two_solids", "two_solids.step", 2, Combined(Box(30, 20, 10), Moved(Sphere(10), placement), +1),
    75 };
}
}

Placement GetAssemblyPlacement(int i)
{
  Placement placement;
  // A quarter turn about z for every instance, and 36.87 degrees (0.6, 0.8) about x for every other one.
  const int c[] = { 1, 0, -1, 0 };
  const int s[] = { 0, 1, 0, -1 };
  const Real a = i % 2 ? 0.8L : 1.0L;
  const Real b = i % 2 ? 0.6L : 0.0L;
  const int q = i % 4;
  placement.Rotation = { { { static_cast<Real>(c[q]), -s[q] * a, s[q] * b },
    { static_cast<Real>(s[q]), c[q] * a, -c[q] * b }, { 0, b, a } } };
  placement.Translation = { 12.0L * (i % 10), 15.0L * (i / 10 % 10), 20.0L * (i / 100) + 0.125L * i };
  return placement;
}

std::vector<SpecialFile> WriteSpecialFiles(const std::string& folder)
{
  std::vector<SpecialFile> files;
  auto add = [&](const std::string& name) -> std::string
  {
    files.push_back({ name, name + ".step", 0, {}, 0 });
    return folder + "/" + name + ".step";
  };
  const std::string header = "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
                             "FILE_NAME('','2024-01-01T00:00:00',(''),(''),'','','');\n"
                             "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\n";
  WriteText(add("empty"), "");
  WriteText(
    add("not_step"), "solid cube\n facet normal 0 0 1\n  outer loop\n  endloop\n endfacet\nendsolid cube\n");
  WriteText(add("no_geometry"),
    header + "DATA;\n#1=APPLICATION_CONTEXT('automotive design');\nENDSEC;\nEND-ISO-10303-21;\n");
  WriteStep(BRepBuilderAPI_MakeVertex(gp_Pnt(1, 2, 3)).Shape(), add("points_only"));
  WriteStep(MakeOpenBoxShell(), add("open_shell"));
  WriteStep(MakeOpenSolid(), add("open_solid"));

  const std::string whole = ReadText(folder + "/box-plain.step");
  WriteText(add("truncated"), whole.substr(0, whole.size() / 2));
  files.push_back({ "junk_header", "junk_header.step", 1, Box(30, 20, 10), std::sqrt(1400.0) });
  WriteText(folder + "/junk_header.step", "s\n" + whole);
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(12.0, 0.0, 20.0).Shape();
  for (const bool allDigits : { true, false })
  {
    const std::string name = allDigits ? "cone_tip" : "cone_tip_digits12";
    files.push_back(
      { name, name + ".step", 1, ConeFrustum(12, 0, 20), std::sqrt(24.0 * 24.0 * 2.0 + 400.0) });
    WriteStep(cone, folder + "/" + name + ".step", { true, allDigits });
  }
  files.push_back(WriteTwoSolids(folder));
  files.push_back(WriteAssembly(folder));
  return files;
}
}
