#include "smPartFile.h"

#include "smSafeFile.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Curve.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_Label.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_WorkSession.hxx>
#include <gp_Vec2d.hxx>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace smpaper
{
namespace
{
/// Returns true if a trim curve is a line of constant parameter.
bool IsIsoLine(const TopoDS_Edge& edge, const TopoDS_Face& face)
{
  double first = 0.0;
  double last = 0.0;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (curve.IsNull())
  {
    return false;
  }
  const int samples = 8;
  const gp_Pnt2d start = curve->Value(first);
  double widthU = 0.0;
  double widthV = 0.0;
  for (int i = 1; i <= samples; ++i)
  {
    const gp_Vec2d away(start, curve->Value(first + (last - first) * i / samples));
    widthU = std::max(widthU, std::abs(away.X()));
    widthV = std::max(widthV, std::abs(away.Y()));
  }
  return std::min(widthU, widthV) <= 1e-6 * std::max(widthU, widthV);
}

bool IsTrimmed(const TopoDS_Face& face)
{
  int wires = 0;
  for (TopExp_Explorer wire(face, TopAbs_WIRE); wire.More(); wire.Next())
  {
    ++wires;
  }
  for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next())
  {
    if (!IsIsoLine(TopoDS::Edge(edge.Current()), face))
    {
      return true;
    }
  }
  return wires > 1;
}

void CheckSolid(const std::string& name, const TopoDS_Shape& solid)
{
  if (solid.IsNull() || solid.ShapeType() != TopAbs_SOLID)
  {
    throw std::runtime_error(name + " is not a solid");
  }
  if (!BRepCheck_Analyzer(solid).IsValid())
  {
    throw std::runtime_error(name + " does not pass OpenCASCADE's check of validity");
  }
  for (TopExp_Explorer shell(solid, TopAbs_SHELL); shell.More(); shell.Next())
  {
    if (!BRep_Tool::IsClosed(shell.Current()))
    {
      throw std::runtime_error(name + " has an open shell");
    }
  }
  GProp_GProps properties;
  BRepGProp::VolumeProperties(solid, properties);
  if (!(properties.Mass() > 0.0))
  {
    throw std::runtime_error(name + " has the volume " + std::to_string(properties.Mass()));
  }
}

Handle(TDocStd_Document) MakeDocument(const PaperPart& part)
{
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  if (part.Components.size() == 1 && part.Components[0].Placements.size() == 1)
  {
    TDataStd_Name::Set(shapes->AddShape(part.Components[0].Solid, false), part.Name.c_str());
    return document;
  }
  const TDF_Label assembly = shapes->NewShape();
  TDataStd_Name::Set(assembly, part.Name.c_str());
  for (const Component& component : part.Components)
  {
    const TDF_Label solid = shapes->AddShape(component.Solid, false);
    TDataStd_Name::Set(solid, component.Name.c_str());
    int number = 0;
    for (const TopLoc_Location& placement : component.Placements)
    {
      const std::string name = component.Name + " " + std::to_string(++number);
      TDataStd_Name::Set(shapes->AddComponent(assembly, solid, placement), name.c_str());
    }
  }
  shapes->UpdateAssemblies();
  return document;
}

void SetHeader(const Handle(StepData_StepModel) & model, const std::string& name)
{
  APIHeaderSection_MakeHeader header(model);
  header.SetName(new TCollection_HAsciiString((name + ".step").c_str()));
  header.SetTimeStamp(new TCollection_HAsciiString("2025-01-01T00:00:00"));
  header.SetAuthorValue(1, new TCollection_HAsciiString("SolidMoments"));
  header.SetOrganizationValue(1, new TCollection_HAsciiString("SolidMoments"));
  header.SetOriginatingSystem(new TCollection_HAsciiString("make_paper_parts"));
  header.SetDescriptionValue(
    1, new TCollection_HAsciiString(("SolidMoments part of Table 1: " + name).c_str()));
}
}

PartCounts Count(const PaperPart& part)
{
  PartCounts counts;
  for (const Component& component : part.Components)
  {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(component.Solid, TopAbs_FACE, faces);
    int trimmed = 0;
    for (int i = 1; i <= faces.Extent(); ++i)
    {
      trimmed += IsTrimmed(TopoDS::Face(faces(i))) ? 1 : 0;
    }
    const int placements = static_cast<int>(component.Placements.size());
    counts.Solids += placements;
    counts.Faces += placements * faces.Extent();
    counts.TrimmedFaces += placements * trimmed;
    counts.DistinctFaces += faces.Extent();
  }
  return counts;
}

void Check(const PaperPart& part)
{
  for (const Component& component : part.Components)
  {
    CheckSolid(component.Name, component.Solid);
  }
}

void QuietOpenCascade()
{
  Message::DefaultMessenger()->ChangePrinters().Clear();
  STEPCAFControl_Controller::Init();
}

void WriteStep(const PaperPart& part, const std::string& path)
{
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  const Handle(TDocStd_Document) document = MakeDocument(part);
  STEPCAFControl_Writer writer;
  if (!writer.Transfer(document, STEPControl_AsIs))
  {
    throw std::runtime_error("OpenCASCADE cannot translate " + part.Name);
  }
  const Handle(StepData_StepModel) model = writer.ChangeWriter().Model();
  SetHeader(model, part.Name);
  StepData_StepWriter text(model);
  text.FloatWriter().SetFormat("%.16E");
  text.SendModel(Handle(StepData_Protocol)::DownCast(writer.ChangeWriter().WS()->Protocol()));
  std::ostringstream bytes;
  const std::string problem =
    text.Print(bytes) ? sm::SaveFile(path, bytes.str()) : "OpenCASCADE cannot print it";
  if (!problem.empty())
  {
    throw std::runtime_error(path + " cannot be written: " + problem);
  }
  XCAFApp_Application::GetApplication()->Close(document);
}
}
