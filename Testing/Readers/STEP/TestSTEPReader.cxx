/**
 * @file TestSTEPReader.cxx
 * @brief vtkSTEPReader at its edge: files that are not readable, units, product structure, colours, instances
 *
 * Usage: TestSTEPReader FOLDER [commas|memory], a folder for the files it writes; in a locale with a decimal comma, or with little
 * memory.
 */
#include "smOCCTMesh.h"
#include "smTesting.h"

#include "vtkSTEPReader.h"
#include "vtkSTEPWriter.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataAssembly.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkNURBSDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkTrimmedNURBSModel.h"
#include "vtkUnsignedCharArray.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_Label.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_MaterialTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gp_Pln.hxx>

#include <clocale>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
std::string Folder;

/// Counts error events and keeps the last text.
struct ErrorLog
{
  int Count = 0;
  std::string Text;

  static void Record(vtkObject*, unsigned long, void* client, void* text)
  {
    auto* self = static_cast<ErrorLog*>(client);
    ++self->Count;
    self->Text = static_cast<const char*>(text);
  }

  void Watch(vtkObject* object)
  {
    vtkNew<vtkCallbackCommand> callback;
    callback->SetClientData(this);
    callback->SetCallback(&ErrorLog::Record);
    object->AddObserver(vtkCommand::ErrorEvent, callback);
  }
};

std::string ReadAll(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

void WriteAll(const std::string& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
}

void CheckFails(const std::string& path, const char* status, const char* word)
{
  vtkNew<vtkSTEPReader> reader;
  ErrorLog log;
  ErrorLog executive;
  log.Watch(reader);
  executive.Watch(reader->GetExecutive());
  reader->SetFileName(path.c_str());
  reader->Update();
  smtest::CheckEqual("errors for " + path, 1, log.Count);
  smtest::CheckTrue("  names the file", log.Text.find(path) != std::string::npos, log.Text);
  smtest::CheckTrue(std::string("  says ") + word, log.Text.find(word) != std::string::npos);
  smtest::CheckEqual("  status", status, reader->GetStatusAsString());
  smtest::CheckEqual("  output is empty", 0, reader->GetOutput()->GetNumberOfPartitionedDataSets());
  smtest::CheckTrue("  has a message", reader->GetNumberOfMessages() > 0);
}

vtkNURBSDataSet* GetLeaf(vtkSTEPReader* reader, unsigned int index)
{
  return vtkNURBSDataSet::SafeDownCast(
    reader->GetOutput()->GetPartitionedDataSet(index)->GetPartitionAsDataObject(0));
}

/// An assembly: two instances of a bored plate with a red face, a blue sphere of steel, and a loose face.
void WriteAssembly(const std::string& path, bool solids = true)
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

void CheckAssembly(const std::string& path, const char* unit, double millimetres)
{
  vtkNew<vtkSTEPReader> reader;
  ErrorLog log;
  log.Watch(reader);
  double progress = -1.0;
  bool rising = true;
  vtkNew<vtkCallbackCommand> callback;
  struct Client
  {
    double* Progress;
    bool* Rising;
  } client{ &progress, &rising };
  callback->SetClientData(&client);
  callback->SetCallback(
    [](vtkObject*, unsigned long, void* data, void* value)
    {
      auto* c = static_cast<Client*>(data);
      *c->Rising = *c->Rising && *static_cast<double*>(value) >= *c->Progress - 1e-12;
      *c->Progress = *static_cast<double*>(value);
    });
  reader->AddObserver(vtkCommand::ProgressEvent, callback);
  reader->SetFileName(path.c_str());
  reader->SetOutputUnit(unit);
  reader->Update();
  smtest::CheckEqual("no error", 0, log.Count);
  smtest::CheckEqual("status", "ok", reader->GetStatusAsString());
  smtest::CheckTrue("progress rises to 1", rising && progress == 1.0);
  smtest::CheckEqual("unit of the file", "millimetre", reader->GetFileUnit());
  smtest::CheckEqual("bodies", 2, reader->GetNumberOfBodies());
  smtest::CheckEqual("instances", 3, reader->GetNumberOfInstances());
  smtest::CheckEqual("free faces", 1, reader->GetNumberOfFreeFaces());
  smtest::CheckEqual("leaves", 3, reader->GetOutput()->GetNumberOfPartitionedDataSets());
  vtkNURBSDataSet* leaves[3];
  const char* names[3] = { "Plate", "Plate", "Ball" };
  for (unsigned int i = 0; i < 3; ++i)
  {
    leaves[i] = GetLeaf(reader, i);
    smtest::CheckEqual(
      "name", names[i], reader->GetOutput()->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()));
  }
  smtest::CheckTrue(
    "instances share their model", leaves[0]->GetModel() && leaves[0]->GetModel() == leaves[1]->GetModel());
  smtest::CheckTrue("and their triangles", leaves[0]->GetPolys() == leaves[1]->GetPolys());
  smtest::CheckEqual("defects of the plate", 0, leaves[0]->GetModel()->GetNumberOfDefects());
  smtest::CheckEqual("missing faces of the plate", 0, leaves[0]->GetModel()->GetNumberOfMissingFaces());
  smtest::CheckEqual("faces of the plate", 7, leaves[0]->GetModel()->GetNumberOfFaces());
  smtest::CheckTrue("every face has its number in the file",
    leaves[0]->GetModel()->GetFaces()[3]->FileId > 0 && leaves[0]->GetModel()->GetFileId() > 0);
  const double* placement = leaves[1]->GetPlacementData();
  smtest::Check("placement", 100.0 / millimetres, placement[3], 1e-13 / millimetres, "one product");
  smtest::Check("placement turns", -1.0, placement[1], 1e-15, "cosine of a right angle");
  double bounds[6];
  leaves[1]->GetBounds(bounds);
  smtest::Check(
    "second plate in x", 70.0 / millimetres, bounds[0], 1e-12 / millimetres, "a corner is a mesh point");
  smtest::Check(
    "second plate in z", 60.0 / millimetres, bounds[5], 1e-12 / millimetres, "a corner is a mesh point");
  const double volume = (40.0 * 30.0 * 10.0 - std::acos(-1.0) * 250.0) / std::pow(millimetres, 3);
  smtest::CheckRange("volume scale / volume", 0.99, leaves[0]->GetModel()->GetVolumeScale() / volume, 1.01);
  smtest::CheckEqual("material", "Steel", leaves[2]->GetModel()->GetMaterial());
  smtest::Check("density", 7850.0, leaves[2]->GetModel()->GetDensity(), 1e-9, "7.85 g/cm^3");
  auto* color = vtkUnsignedCharArray::SafeDownCast(leaves[2]->GetCellData()->GetArray("Color"));
  smtest::CheckTrue(
    "the ball is blue", color && color->GetComponent(0, 0) == 0 && color->GetComponent(0, 2) == 255);
  smtest::CheckTrue("the plate has no colour", !leaves[0]->GetCellData()->GetArray("Color"));

  vtkDataAssembly* assembly = reader->GetOutput()->GetDataAssembly();
  smtest::CheckTrue("there is an assembly", assembly != nullptr);
  const int top = assembly->GetChild(vtkDataAssembly::GetRootNode(), 0);
  smtest::CheckEqual("top label", "Top 1", assembly->GetAttributeOrDefault(top, "label", ""));
  smtest::CheckTrue("top name is valid", vtkDataAssembly::IsNodeNameValid(assembly->GetNodeName(top)));
  smtest::CheckEqual("children", 4, assembly->GetNumberOfChildren(top));
  const auto indices = assembly->GetDataSetIndices(top);
  smtest::CheckEqual("leaves below top", 3,
    static_cast<long long>(std::set<unsigned int>(indices.begin(), indices.end()).size()));
}

/// Triangles, exact normals and parameters agree with each other and with the exact surfaces.
void CheckMesh(const std::string& path)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  for (unsigned int i = 0; i < 3; ++i)
  {
    vtkNURBSDataSet* leaf = GetLeaf(reader, i);
    vtkTrimmedNURBSModel* model = leaf->GetModel();
    vtkDataArray* face = leaf->GetPointData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName());
    vtkDataArray* uv = leaf->GetPointData()->GetArray(vtkNURBSDataSet::ParametersArrayName());
    vtkDataArray* normals = leaf->GetPointData()->GetNormals();
    const double* m = leaf->GetPlacementData();
    double worst = 0.0;
    for (vtkIdType p = 0; p < leaf->GetNumberOfPoints(); ++p)
    {
      double q[3];
      model->GetFaces()[static_cast<int>(face->GetTuple1(p))]->Surface.Evaluate(
        uv->GetComponent(p, 0), uv->GetComponent(p, 1), q);
      double x[3];
      leaf->GetPoint(p, x);
      for (int r = 0; r < 3; ++r)
      {
        double y = m[4 * r + 3];
        for (int c = 0; c < 3; ++c)
        {
          y += m[4 * r + c] * (q[c] + model->GetOrigin()[c]);
        }
        worst = std::max(worst, std::abs(x[r] - y));
      }
    }
    smtest::CheckRange(
      "points lie on their surfaces", 0.0, worst, 1e-6, "OpenCASCADE's vertex tolerance is 1e-7");
    double least = 1.0;
    double volume = 0.0;
    vtkNew<vtkIdList> ids;
    for (vtkIdType c = 0; c < leaf->GetNumberOfCells(); ++c)
    {
      leaf->GetCellPoints(c, ids);
      double a[3];
      double b[3];
      double d[3];
      leaf->GetPoint(ids->GetId(0), a);
      leaf->GetPoint(ids->GetId(1), b);
      leaf->GetPoint(ids->GetId(2), d);
      const double e[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
      const double f[3] = { d[0] - a[0], d[1] - a[1], d[2] - a[2] };
      const double n[3] = { e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0] };
      const double length = std::hypot(n[0], n[1], n[2]);
      volume += (a[0] * n[0] + a[1] * n[1] + a[2] * n[2]) / 6.0;
      const double* normal = normals->GetTuple3(ids->GetId(0));
      least = std::min(least, (n[0] * normal[0] + n[1] * normal[1] + n[2] * normal[2]) / length);
    }
    smtest::CheckRange("normals and triangles point the same way", 0.8, least, 1.0);
    smtest::CheckRange("triangles point outward", 0.98, volume / model->GetVolumeScale(), 1.02);
  }
}

/// Bodies that are not what their file says, made without a file.
void CheckBrokenBodies()
{
  const BRep_Builder builder;
  const double origin[3] = { 0.0, 0.0, 0.0 };
  TopoDS_Edge edge;
  builder.MakeEdge(edge, new Geom_Line(gp_Pnt(), gp_Dir(1, 0, 0)), 1e-7);
  builder.Range(edge, 1.0, 1.0);
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  builder.Add(wire, edge);
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(gp_Pln()), 1e-7);
  builder.Add(face, wire);
  sm::ConvertedBody body = sm::ConvertBody(face, gp_Trsf(), 1.0, origin, {});
  smtest::CheckEqual(
    "a face whose edges are empty is not the whole plane", 0, static_cast<long long>(body.Faces.size()));
  smtest::CheckEqual("  but missing", 1, body.MissingFaces);

  const TopoDS_Face rectangle = BRepBuilderAPI_MakeFace(gp_Pln(), 0.0, 7.0, 0.0, 8.0).Face();
  wire = TopoDS::Wire(TopoDS_Iterator(rectangle).Value());
  wire.Free(true);
  builder.Add(wire, edge);
  body = sm::ConvertBody(rectangle, gp_Trsf(), 1.0, origin, {});
  smtest::CheckEqual(
    "an edge that is left out leaves its face", 1, static_cast<long long>(body.Faces.size()));
  smtest::CheckTrue("  and is a defect", body.Defects > 0 && !body.Messages.empty());

  const Handle(Geom_Surface) tube =
    new Geom_RectangularTrimmedSurface(new Geom_CylindricalSurface(gp_Ax3(), 2.0), 0.0, 1.0, 3.0, 5.0);
  TopoDS_Face patch;
  builder.MakeFace(patch, tube, 1e-7);
  body = sm::ConvertBody(patch, gp_Trsf(), 1.0, origin, {});
  smtest::CheckEqual("a face without loops", 1, static_cast<long long>(body.Faces.size()));
  smtest::CheckEqual("  has no defect", 0, body.Defects);
  const sm::NURBSSurface& surface = body.Faces.at(0).Result->Surface;
  double p[3];
  surface.Evaluate(surface.GetDomainEnd(0), surface.GetDomainEnd(1), p);
  smtest::Check("  ends where its trims do, in x", 2.0 * std::cos(1.0), p[0], 1e-14, "4 eps radius");
  smtest::Check("  and in z", 5.0, p[2], 1e-14, "2 eps height");
}

void CheckDeflection()
{
  vtkNew<vtkSTEPReader> reader;
  for (const double bad : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    reader->SetLinearDeflection(1.0);
    reader->SetLinearDeflection(bad);
    smtest::CheckEqual("a deflection that is none is the default", 0.001, reader->GetLinearDeflection());
  }
  reader->SetLinearDeflection(1e-20);
  smtest::CheckEqual("the least deflection", 1e-7, reader->GetLinearDeflection());
  reader->SetAngularDeflection(0.0);
  smtest::CheckEqual("the least angle", 0.01, reader->GetAngularDeflection());
  reader->SetAngularDeflection(10.0);
  smtest::CheckEqual("the largest angle", 3.0, reader->GetAngularDeflection());
  reader->SetAngularDeflection(std::numeric_limits<double>::quiet_NaN());
  smtest::CheckEqual("an angle that is none is the default", 0.35, reader->GetAngularDeflection());
  smtest::CheckEqual("the mesher's least deflection", 1e-5 * 200.0, sm::LimitDeflection(1e-9, 200.0));
  smtest::Check("and near its precision", 1e-6, sm::LimitDeflection(1e-9, 1e-4), 1e-18, "10 times 1e-7");

  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(4.0).Shape();
  const std::string said = sm::TriangulateShape(ball, 1e-3, 0.01, {}, 1e-9);
  smtest::CheckTrue("a mesher out of time says so", said.find("stopped") != std::string::npos, said);
  const double origin[3] = { 0.0, 0.0, 0.0 };
  sm::ConvertedBody body = sm::ConvertBody(ball, gp_Trsf(), 1.0, origin, {});
  const double exact = 4.0 / 3.0 * std::acos(-1.0) * 64.0;
  smtest::CheckRange("and a grid stands in", 0.99, sm::BuildMesh(body, gp_Trsf(), 1.0, origin).Volume / exact,
    1.0, "160 cells round the ball");
}

/// A reader inside an observer of another one's progress fails with a sentence, and the other one goes on.
void CheckNested(const std::string& path)
{
  struct Client
  {
    std::string Path;
    ErrorLog Log;
    int Runs = 0;
  } client;
  client.Path = path;
  vtkNew<vtkCallbackCommand> callback;
  callback->SetClientData(&client);
  callback->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* c = static_cast<Client*>(data);
      const double progress = static_cast<vtkSTEPReader*>(caller)->GetProgress();
      if (c->Runs > 0 || progress < 0.1 || progress >= 1.0)
      {
        return;
      }
      ++c->Runs;
      vtkNew<vtkSTEPReader> inner;
      ErrorLog ignored;
      c->Log.Watch(inner);
      ignored.Watch(inner->GetExecutive());
      inner->SetFileName(c->Path.c_str());
      inner->Update();
    });
  vtkNew<vtkSTEPReader> reader;
  reader->AddObserver(vtkCommand::ProgressEvent, callback);
  reader->SetFileName(path.c_str());
  reader->Update();
  smtest::CheckEqual("a nested reader ran", 1, client.Runs);
  smtest::CheckEqual("and failed", 1, client.Log.Count);
  smtest::CheckTrue(
    "with a sentence", client.Log.Text.find("another file is being read") != std::string::npos);
  smtest::CheckEqual("the outer one goes on", 3, reader->GetNumberOfInstances());
}

/// Stops at the first report of at least `threshold`.
void CheckAbort(const std::string& path, double threshold)
{
  vtkNew<vtkSTEPReader> reader;
  ErrorLog log;
  log.Watch(reader);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetClientData(&threshold);
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void* least, void* progress)
    {
      if (*static_cast<double*>(progress) >= *static_cast<double*>(least))
      {
        static_cast<vtkSTEPReader*>(caller)->SetAbortExecute(1);
      }
    });
  reader->AddObserver(vtkCommand::ProgressEvent, stop);
  reader->SetFileName(path.c_str());
  reader->Update();
  smtest::CheckEqual("stopped", "aborted", reader->GetStatusAsString());
  smtest::CheckEqual("without an error", 0, log.Count);
  smtest::CheckEqual("and empty", 0, reader->GetOutput()->GetNumberOfPartitionedDataSets());
}

std::string Make(const std::string& name, const std::string& content)
{
  WriteAll(Folder + "/" + name, content);
  return Folder + "/" + name;
}

void CheckUnreadable(const std::string& text)
{
  CheckFails(Folder + "/does_not_exist.step", "unreadable", "opened");
  CheckFails(Make("reader_nothing.step", ""), "unreadable", "empty");
  CheckFails(Make("reader_text.step", "solid cube\nfacet normal 0 0 1\n"), "unreadable", "not a STEP file");
  CheckFails(Make("reader_gzip.step", "\x1f\x8b\x08 and so on"), "unreadable", "gzip");
  CheckFails(
    Make("reader_header.step", text.substr(0, text.find("DATA;")) + "DATA;\nENDSEC;\nEND-ISO-10303-21;\n"),
    "empty", "no solid");
  CheckFails(
    Make("reader_cut.step", text.substr(0, text.size() / 3)), "unreadable", "copy or export it again");
  CheckFails(Folder, "unreadable", "opened");
}

void CheckSettings(const std::string& good)
{
  vtkNew<vtkSTEPReader> nameless;
  ErrorLog log;
  log.Watch(nameless);
  ErrorLog ignored;
  ignored.Watch(nameless->GetExecutive());
  nameless->Update();
  smtest::CheckEqual("no file name is one error", 1, log.Count);
  nameless->SetFileName(good.c_str());
  nameless->SetOutputUnit("parsec");
  nameless->Update();
  smtest::CheckTrue(
    "an unknown unit is named", log.Count == 2 && log.Text.find("parsec") != std::string::npos, log.Text);
  nameless->SetOutputUnit("mm");
  nameless->Update();
  smtest::CheckEqual("the reader recovers", 3, nameless->GetOutput()->GetNumberOfPartitionedDataSets());
}

/// Junk before the header is skipped, and said.
void CheckJunk(const std::string& text)
{
  const std::string junk = Make("reader_junk.step", "xyz " + text);
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(junk.c_str());
  reader->Update();
  smtest::CheckEqual("junk is skipped", 3, reader->GetNumberOfInstances());
  smtest::CheckTrue(
    "junk is said", reader->GetMessage(0).find("before \"ISO-10303-21;\"") != std::string::npos);
  smtest::CheckEqual("CanReadFile", 1, vtkSTEPReader::CanReadFile(junk.c_str()));
  smtest::CheckEqual(
    "CanReadFile of text", 0, vtkSTEPReader::CanReadFile((Folder + "/reader_text.step").c_str()));
  smtest::CheckEqual("CanReadFile of nothing", 0, vtkSTEPReader::CanReadFile(nullptr));
}

/// A reference to an entity that is not there crashes OpenCASCADE: the one face that has it is left out.
void CheckDamage(const std::string& text)
{
  vtkNew<vtkSTEPReader> reader;
  std::string broken = text;
  const std::size_t surface = broken.find("),#", broken.find("ADVANCED_FACE('',(")) + 2;
  smtest::CheckTrue("a face to break", surface > 2 && surface < broken.size());
  broken.replace(surface, broken.find(',', surface) - surface, "#99999999");
  const std::string damaged = Make("reader_damaged.step", broken);
  reader->SetFileName(damaged.c_str());
  reader->Update();
  smtest::CheckEqual("status of a damaged file", "ok", reader->GetStatusAsString());
  smtest::CheckEqual("one face is left out", 6, GetLeaf(reader, 0)->GetModel()->GetNumberOfFaces());
  smtest::CheckEqual("and counted", 1, GetLeaf(reader, 0)->GetModel()->GetNumberOfMissingFaces());
  smtest::CheckEqual("in its body only", 0, GetLeaf(reader, 2)->GetModel()->GetNumberOfMissingFaces());
  smtest::CheckTrue(
    "and said", reader->GetMessage(0).find("damaged") != std::string::npos, reader->GetMessage(0));
}

/// An edge between one vertex and itself, whose curve goes elsewhere.
void CheckWrongVertex(const std::string& text)
{
  vtkNew<vtkSTEPReader> reader;
  const std::regex ends("EDGE_CURVE\\('',(#[0-9]+),(#[0-9]+),");
  reader->SetFileName(Make("reader_vertex.step",
    std::regex_replace(text, ends, "EDGE_CURVE('',$1,$1,", std::regex_constants::format_first_only))
                        .c_str());
  reader->Update();
  vtkTrimmedNURBSModel* torn = GetLeaf(reader, 0)->GetModel();
  smtest::CheckTrue("a wrong vertex is a defect, or its faces are missing",
    torn->GetNumberOfDefects() + torn->GetNumberOfMissingFaces() > 0);
  vtkNew<vtkTrimmedNURBSModel> copy;
  copy->ShallowCopy(torn);
  smtest::CheckEqual("which a copy has too", torn->GetNumberOfDefects(), copy->GetNumberOfDefects());
}

/// Lengths near the kernel's precision: the mesher must come back.
void CheckNanometres(const std::string& text)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(
    Make("reader_nano.step", std::regex_replace(text, std::regex("\\.MILLI\\."), ".NANO.")).c_str());
  reader->Update();
  smtest::CheckTrue("a file in nanometres ends, with a mesh", GetLeaf(reader, 0)->GetNumberOfPolys() > 0);
}

/// An instance that loses its scale.
void CheckLostScale(const std::string& text)
{
  vtkNew<vtkSTEPReader> reader;
  const std::regex part(
    "(#[0-9]+) = (ADVANCED_BREP_SHAPE_REPRESENTATION\\('',\\((#[0-9]+),#[0-9]+\\),(#[0-9]+)\\);)");
  reader->SetFileName(Make("reader_scaled.step",
    std::regex_replace(text, part,
      "$1 = SHAPE_REPRESENTATION('',($3,#900001),$4);\n#900000 = $2\n"
      "#900001 = MAPPED_ITEM('',#900002,#900003);\n#900002 = REPRESENTATION_MAP($3,#900000);\n"
      "#900003 = CARTESIAN_TRANSFORMATION_OPERATOR_3D('','','',$$,$$,#900004,2.5,$$);\n"
      "#900004 = CARTESIAN_POINT('',(100.,0.,0.));",
      std::regex_constants::format_first_only))
                        .c_str());
  reader->Update();
  int misplaced = 0;
  for (int i = 0; i < reader->GetNumberOfInstances(); ++i)
  {
    misplaced += GetLeaf(reader, i)->GetModel()->GetNumberOfDefects() > 0 ? 1 : 0;
  }
  smtest::CheckTrue("a lost scale is a defect", misplaced > 0);
}

/// A file without solids gives its shells; process-wide settings are as they were.
void CheckLoose()
{
  vtkNew<vtkSTEPReader> reader;
  const std::string loose = Folder + "/reader_loose.step";
  WriteAssembly(loose, false);
  Interface_Static::SetCVal("xstep.cascade.unit", "M");
  const int printers = Message::DefaultMessenger()->Printers().Length();
  reader->SetFileName(loose.c_str());
  reader->Update();
  smtest::CheckEqual("xstep.cascade.unit is restored", "M", Interface_Static::CVal("xstep.cascade.unit"));
  smtest::CheckEqual("printers are restored", printers, Message::DefaultMessenger()->Printers().Length());
  smtest::CheckEqual("a loose face is a leaf", 1, reader->GetNumberOfInstances());
  vtkNURBSDataSet* leaf = GetLeaf(reader, 0);
  smtest::CheckEqual("it is a shell", vtkTrimmedNURBSModel::SHELL, leaf->GetModel()->GetBody());
  smtest::Check("area scale in mm^2", 56.0, leaf->GetModel()->GetAreaScale(), 1e-12, "a rectangle");
}

/// An exception that an observer throws while the file is read is an error, whatever its type.
void CheckExceptions(const std::string& path)
{
  struct Client
  {
    double Threshold = 0.0;
    bool Standard = true;
  } client;
  vtkNew<vtkCallbackCommand> callback;
  callback->SetClientData(&client);
  callback->SetCallback(
    [](vtkObject*, unsigned long, void* data, void* progress)
    {
      const auto* c = static_cast<Client*>(data);
      const double fraction = *static_cast<double*>(progress);
      if (fraction >= c->Threshold && fraction < 1.0)
      {
        if (c->Standard)
        {
          throw std::runtime_error("thrown by an observer");
        }
        throw 5;
      }
    });
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path.c_str());
  ErrorLog log;
  ErrorLog executive;
  log.Watch(reader);
  executive.Watch(reader->GetExecutive());
  const unsigned long tag = reader->AddObserver(vtkCommand::ProgressEvent, callback);
  int errors = 0;
  // While the file is parsed, before the first body, and with a body in hand.
  for (const double threshold : { 0.01, 0.5, 0.76 })
  {
    client = { threshold, false };
    reader->Modified();
    bool crossed = false;
    try
    {
      reader->Update();
    }
    catch (...)
    {
      crossed = true;
    }
    const std::string what = "an exception at " + std::to_string(threshold);
    smtest::CheckTrue(what + " stays inside", !crossed);
    smtest::CheckEqual(what + " is an error", ++errors, log.Count);
    smtest::CheckEqual(what + ": status", "unreadable", reader->GetStatusAsString());
    smtest::CheckEqual(what + ": leaves", 0, reader->GetOutput()->GetNumberOfPartitionedDataSets());
  }
  client = { 0.5, true };
  reader->Modified();
  reader->Update();
  smtest::CheckTrue(
    "a standard one is quoted", log.Text.find("thrown by an observer") != std::string::npos, log.Text);
  reader->RemoveObserver(tag);
  reader->Modified();
  reader->Update();
  smtest::CheckEqual("and the reader recovers", 3, reader->GetNumberOfInstances());
}

/// Numbers in messages have a decimal point in every locale.
void CheckCommas(const std::string& text)
{
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8"))
  {
    std::exit(smtest::Skipped);
  }
  smtest::CheckEqual("the locale's decimal point", ",", std::localeconv()->decimal_point);
  // The first vertex moves by 0.25 mm: edges end beside it.
  const std::regex vertex("VERTEX_POINT\\('',(#[0-9]+)\\)");
  std::smatch found;
  smtest::CheckTrue("a vertex to move", std::regex_search(text, found, vertex));
  const std::string moved =
    std::regex_replace(text, vertex, "VERTEX_POINT('',#900001)", std::regex_constants::format_first_only);
  vtkNew<vtkSTEPReader> reader;
  const std::size_t end = moved.rfind("ENDSEC;");
  reader->SetFileName(Make("reader_commas.step",
    moved.substr(0, end) + "#900001 = CARTESIAN_POINT('',(-9.25,-9.25,-9.25));\n" + moved.substr(end))
                        .c_str());
  reader->Update();
  const std::vector<std::string>& messages = GetLeaf(reader, 0)->GetModel()->GetMessages();
  const std::regex number("[0-9]\\.[0-9]");
  const std::regex comma("[0-9],[0-9]");
  int points = 0;
  int commas = 0;
  for (const std::string& message : messages)
  {
    std::printf("     %s\n", message.c_str());
    points += std::regex_search(message, number) ? 1 : 0;
    commas += std::regex_search(message, comma) ? 1 : 0;
  }
  smtest::CheckTrue("messages with a decimal point", points > 0);
  smtest::CheckEqual("messages with a decimal comma", 0, commas);
}

/// Reads and writes with no more than `extra` bytes of address space than now. 0: done, 1: an error said why not.
int RunWithMemory(const std::string& path, const std::string& copy, std::size_t extra)
{
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  vtkNew<vtkSTEPReader> reader;
  vtkNew<vtkSTEPWriter> writer;
  ErrorLog log;
  ErrorLog ignored;
  log.Watch(reader);
  log.Watch(writer);
  ignored.Watch(reader->GetExecutive());
  ignored.Watch(writer->GetExecutive());
  reader->SetFileName(path.c_str());
  writer->SetInputConnection(reader->GetOutputPort());
  writer->SetFileName(copy.c_str());
  const rlim_t bytes = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + extra;
  const rlimit limit{ bytes, bytes };
  setrlimit(RLIMIT_AS, &limit);
  const bool written = writer->Write() != 0;
  const bool said = log.Count > 0 && writer->GetErrorCode() != vtkErrorCode::NoError;
  return written && log.Count == 0 ? 0 : !written && said ? 1 : 2;
}

/// Reads and writes in child processes that have less and less memory.
void CheckMemory(const std::string& path)
{
  const std::string copy = Folder + "/reader_memory.step";
  int done = 0;
  int failed = 0;
  for (const std::size_t kibibytes :
    { 0, 256, 512, 1024, 2048, 3072, 4096, 4352, 4608, 4864, 5120, 5376, 5632, 5888, 6144, 8192, 524288 })
  {
    std::remove(copy.c_str());
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0)
    {
      _exit(RunWithMemory(path, copy, kibibytes << 10));
    }
    int status = 0;
    waitpid(child, &status, 0);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    smtest::CheckTrue("with " + std::to_string(kibibytes) + " KiB: done, or an error", code < 2,
      "exit status " + std::to_string(code));
    smtest::CheckTrue(
      "  a file is there when it is done", (code == 0) == static_cast<bool>(std::ifstream(copy)));
    done += code == 0 ? 1 : 0;
    failed += code == 1 ? 1 : 0;
  }
  smtest::CheckTrue("enough memory is enough", done > 0, std::to_string(done));
  smtest::CheckTrue("too little is too little", failed > 2, std::to_string(failed));
}
}

int TestSTEPReader(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::fprintf(stderr, "usage: %s FOLDER [commas|memory]\n", argv[0]);
    return EXIT_FAILURE;
  }
  Folder = argv[1];
  const std::string mode = argc > 2 ? argv[2] : "";
  const std::string good = Folder + "/reader_assembly" + mode + ".step";
  WriteAssembly(good);
  const std::string text = ReadAll(good);
  if (mode == "commas")
  {
    CheckCommas(text);
    return smtest::Finish();
  }
  if (mode == "memory")
  {
    CheckMemory(good);
    return smtest::Finish();
  }
  CheckAssembly(good, "mm", 1.0);
  CheckAssembly(good, "inch", 25.4);
  CheckAssembly(good, "file", 1.0);
  CheckMesh(good);
  CheckAbort(good, 0.0);
  // The last body's triangles, and its faces.
  CheckAbort(good, 0.76);
  CheckAbort(good, 0.96);
  CheckBrokenBodies();
  CheckDeflection();
  CheckNested(good);
  CheckExceptions(good);
  CheckUnreadable(text);
  CheckSettings(good);
  CheckJunk(text);
  CheckDamage(text);
  CheckWrongVertex(text);
  CheckNanometres(text);
  CheckLostScale(text);
  CheckLoose();
  return smtest::Finish();
}
