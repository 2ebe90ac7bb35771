#include "smReaderTesting.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_Label.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopoDS.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_MaterialTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gp_Pln.hxx>

#include <cmath>
#include <fstream>
#include <iterator>

namespace smtest
{
void ErrorLog::Watch(vtkObject* object)
{
  vtkNew<vtkCallbackCommand> callback;
  callback->SetClientData(this);
  callback->SetCallback(
    [](vtkObject*, unsigned long, void* client, void* text)
    {
      auto* self = static_cast<ErrorLog*>(client);
      ++self->Count;
      self->Text = static_cast<const char*>(text);
    });
  object->AddObserver(vtkCommand::ErrorEvent, callback);
}

std::string ReadAll(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

std::string Make(const std::string& name, const std::string& content)
{
  const std::string path = Folder + "/" + name;
  std::ofstream(path, std::ios::binary) << content;
  return path;
}

void WriteAssembly(const std::string& path, bool solids)
{
  const Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const Handle(XCAFDoc_ColorTool) colors = XCAFDoc_DocumentTool::ColorTool(document->Main());
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(40.0, 30.0, 10.0).Shape();
  const TopoDS_Shape bore =
    BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(20.0, 15.0, -1.0), gp_Dir(0, 0, 1)), 5.0, 12.0).Shape();
  const TopoDS_Shape plate = BRepAlgoAPI_Cut(box, bore).Shape();
  const TopoDS_Face loose = BRepBuilderAPI_MakeFace(gp_Pln(), 0.0, 7.0, 0.0, 8.0).Face();
  const TDF_Label assembly = shapes->NewShape();
  TDataStd_Name::Set(assembly, "Top 1");
  if (solids)
  {
    const TDF_Label part = shapes->AddShape(plate, false);
    TDataStd_Name::Set(part, "Plate");
    const TDF_Label ball = shapes->AddShape(BRepPrimAPI_MakeSphere(4.0).Shape(), false);
    TDataStd_Name::Set(ball, "Ball");
    colors->SetColor(ball, Quantity_Color(0.0, 0.0, 1.0, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
    XCAFDoc_DocumentTool::MaterialTool(document->Main())
      ->SetMaterial(ball, new TCollection_HAsciiString("Steel"), new TCollection_HAsciiString("a steel"),
        7.85, new TCollection_HAsciiString("density measure"),
        new TCollection_HAsciiString("POSITIVE_RATIO_MEASURE"));
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(), gp_Dir(0, 0, 1)), std::acos(-1.0) / 2.0);
    turn.SetTranslationPart(gp_Vec(100.0, 0.0, 50.0));
    shapes->AddComponent(assembly, part, TopLoc_Location());
    shapes->AddComponent(assembly, part, TopLoc_Location(turn));
    gp_Trsf move;
    move.SetTranslation(gp_Vec(0.0, 0.0, -20.0));
    shapes->AddComponent(assembly, ball, TopLoc_Location(move));
  }
  const TDF_Label stray = shapes->AddShape(loose, false);
  TDataStd_Name::Set(stray, "Stray");
  shapes->AddComponent(assembly, stray, TopLoc_Location());
  shapes->UpdateAssemblies();
  STEPCAFControl_Writer writer;
  writer.Transfer(document, STEPControl_AsIs);
  writer.Write(path.c_str());
}

vtkNURBSDataSet* GetLeaf(vtkSTEPReader* reader, unsigned int index)
{
  return vtkNURBSDataSet::SafeDownCast(
    reader->GetOutput()->GetPartitionedDataSet(index)->GetPartitionAsDataObject(0));
}
}
