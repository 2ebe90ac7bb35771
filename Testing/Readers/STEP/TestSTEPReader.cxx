/**
 * @file TestSTEPReader.cxx
 * @brief vtkSTEPReader: units, product structure, colours, instances, meshes, bodies without a file
 *
 * Usage: TestSTEPReader FOLDER [commas], a folder for the files it writes; in a locale with a decimal comma.
 */
#include "smBodyConversion.h"
#include "smDisplayMesh.h"
#include "smReaderTesting.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataAssembly.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkTrimmedNURBSModel.h"
#include "vtkUnsignedCharArray.h"

#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace
{
using namespace smtest;

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
  CheckEqual("no error", 0, log.Count);
  CheckEqual("status", "ok", reader->GetStatusAsString());
  CheckTrue("progress rises to 1", rising && progress == 1.0);
  CheckEqual("unit of the file", "millimetre", reader->GetFileUnit());
  CheckEqual("bodies", 2, reader->GetNumberOfBodies());
  CheckEqual("instances", 3, reader->GetNumberOfInstances());
  CheckEqual("free faces", 1, reader->GetNumberOfFreeFaces());
  CheckEqual("leaves", 3, reader->GetOutput()->GetNumberOfPartitionedDataSets());
  vtkNURBSDataSet* leaves[3];
  const char* names[3] = { "Plate (1)", "Plate (2)", "Ball" };
  for (unsigned int i = 0; i < 3; ++i)
  {
    leaves[i] = GetLeaf(reader, i);
    CheckEqual("name", names[i], reader->GetOutput()->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()));
  }
  CheckTrue(
    "instances share their model", leaves[0]->GetModel() && leaves[0]->GetModel() == leaves[1]->GetModel());
  CheckTrue("and their triangles", leaves[0]->GetPolys() == leaves[1]->GetPolys());
  CheckEqual("defects of the plate", 0, leaves[0]->GetModel()->GetNumberOfDefects());
  CheckEqual("missing faces of the plate", 0, leaves[0]->GetModel()->GetNumberOfMissingFaces());
  CheckEqual("faces of the plate", 7, leaves[0]->GetModel()->GetNumberOfFaces());
  CheckTrue("every face has its number in the file",
    leaves[0]->GetModel()->GetFaces()[3]->FileId > 0 && leaves[0]->GetModel()->GetFileId() > 0);
  Check("the uncertainty that the file states", 1e-7 / millimetres,
    leaves[0]->GetModel()->GetFileUncertainty(), 1e-22, "1e-7 mm");
  CheckEqual("outer shells", 1, leaves[0]->GetModel()->GetNumberOfOuterShells());
  const double* placement = leaves[1]->GetPlacementData();
  Check("placement", 100.0 / millimetres, placement[3], 1e-13 / millimetres, "one product");
  Check("placement turns", -1.0, placement[1], 1e-15, "cosine of a right angle");
  double bounds[6];
  leaves[1]->GetBounds(bounds);
  Check("second plate in x", 70.0 / millimetres, bounds[0], 1e-12 / millimetres, "a corner is a mesh point");
  Check("second plate in z", 60.0 / millimetres, bounds[5], 1e-12 / millimetres, "a corner is a mesh point");
  const double volume = (40.0 * 30.0 * 10.0 - std::acos(-1.0) * 250.0) / std::pow(millimetres, 3);
  CheckRange("volume scale / volume", 0.99, leaves[0]->GetModel()->GetVolumeScale() / volume, 1.01);
  CheckEqual("material", "Steel", leaves[2]->GetModel()->GetMaterial());
  Check("density", 7850.0, leaves[2]->GetModel()->GetDensity(), 1e-9, "7.85 g/cm^3");
  auto* color = vtkUnsignedCharArray::SafeDownCast(leaves[2]->GetCellData()->GetArray("Color"));
  CheckTrue("the ball is blue", color && color->GetComponent(0, 0) == 0 && color->GetComponent(0, 2) == 255);
  CheckTrue("the plate has no colour", !leaves[0]->GetCellData()->GetArray("Color"));

  vtkDataAssembly* assembly = reader->GetOutput()->GetDataAssembly();
  CheckTrue("there is an assembly", assembly != nullptr);
  const int top = assembly->GetChild(vtkDataAssembly::GetRootNode(), 0);
  CheckEqual("top label", "Top 1", assembly->GetAttributeOrDefault(top, "label", ""));
  CheckTrue("top name is valid", vtkDataAssembly::IsNodeNameValid(assembly->GetNodeName(top)));
  CheckEqual("children", 4, assembly->GetNumberOfChildren(top));
  const auto indices = assembly->GetDataSetIndices(top);
  CheckEqual("leaves below top", 3,
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
    CheckRange("points lie on their surfaces", 0.0, worst, 1e-6, "OpenCASCADE's vertex tolerance is 1e-7");
    double area = 0.0;
    double tilted = 0.0;
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
      area += length;
      tilted += n[0] * normal[0] + n[1] * normal[1] + n[2] * normal[2] < 0.8 * length ? length : 0.0;
    }
    CheckRange("share of triangles that do not point as their normals do", 0.0, tilted / area, 1e-4,
      "slivers at a pole");
    CheckRange("triangles point outward", 0.98, volume / model->GetVolumeScale(), 1.02);
  }
}

template <class Value>
sm::SurfacePointer MakeSurface(const Value& value)
{
  std::string problem;
  return sm::GeometricSurface::Make(value, problem);
}

/// An edge along the x axis, or one that is moved from it.
sm::CoedgeShape MakeEdge(const sm::Vector3& from, const sm::Vector3& along, double first, double last)
{
  std::string problem;
  sm::CoedgeShape use;
  use.Edge = std::make_shared<sm::EdgeShape>();
  use.Edge->Curve = sm::GeometricCurve<3>::Make(sm::LineCurve<3>{ from, along }, problem);
  use.Edge->First = first;
  use.Edge->Last = last;
  return use;
}

sm::ConvertedBody Convert(const std::shared_ptr<sm::FaceShape>& face)
{
  const double origin[3] = { 0.0, 0.0, 0.0 };
  sm::BodyShape body;
  body.Faces.push_back({ face, false });
  return sm::ConvertBody(body, sm::Placement(), 1.0, origin);
}

/// Bodies that are not what their file says, made without a file.
void CheckBrokenBodies()
{
  const sm::CoedgeShape empty = MakeEdge({}, { 1.0, 0.0, 0.0 }, 1.0, 1.0);
  const auto face = std::make_shared<sm::FaceShape>();
  face->Surface = MakeSurface(sm::ElementarySurface());
  face->Wires.push_back({ { empty }, false });
  sm::ConvertedBody body = Convert(face);
  CheckEqual(
    "a face whose edges are empty is not the whole plane", 0, static_cast<long long>(body.Faces.size()));
  CheckEqual("  but missing", 1, body.MissingFaces);

  face->Wires = { { { MakeEdge({}, { 1.0, 0.0, 0.0 }, 0.0, 7.0),
                      MakeEdge({ 7.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, 0.0, 8.0),
                      MakeEdge({ 7.0, 8.0, 0.0 }, { -1.0, 0.0, 0.0 }, 0.0, 7.0),
                      MakeEdge({ 0.0, 8.0, 0.0 }, { 0.0, -1.0, 0.0 }, 0.0, 8.0), empty },
    false } };
  body = Convert(face);
  CheckEqual("an edge that is left out leaves its face", 1, static_cast<long long>(body.Faces.size()));
  CheckTrue("  and is a defect", body.Defects > 0 && !body.Messages.empty());

  sm::ElementarySurface tube;
  tube.Kind = sm::ElementarySurface::Type::Cylinder;
  tube.Radii[0] = 2.0;
  const auto patch = std::make_shared<sm::FaceShape>();
  patch->Surface = MakeSurface(tube);
  patch->Range[0] = { 0.0, 1.0 };
  patch->Range[1] = { 3.0, 5.0 };
  body = Convert(patch);
  CheckEqual("a face without loops", 1, static_cast<long long>(body.Faces.size()));
  CheckEqual("  has no defect", 0, body.Defects);
  const sm::NURBSSurface& surface = body.Faces.at(0).Result->Surface;
  double p[3];
  surface.Evaluate(surface.GetDomainEnd(0), surface.GetDomainEnd(1), p);
  Check("  ends where its trims do, in x", 2.0 * std::cos(1.0), p[0], 1e-14, "4 eps radius");
  Check("  and in z", 5.0, p[2], 1e-14, "2 eps height");
}

void CheckDeflection()
{
  vtkNew<vtkSTEPReader> reader;
  for (const double bad : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    reader->SetLinearDeflection(1.0);
    reader->SetLinearDeflection(bad);
    CheckEqual("a deflection that is none is the default", 0.001, reader->GetLinearDeflection());
  }
  reader->SetLinearDeflection(1e-20);
  CheckEqual("the smallest deflection", 1e-20, reader->GetLinearDeflection());
  reader->SetAngularDeflection(0.0);
  CheckEqual("the smallest angle", 0.01, reader->GetAngularDeflection());
  reader->SetAngularDeflection(10.0);
  CheckEqual("the largest angle", 3.0, reader->GetAngularDeflection());
  reader->SetAngularDeflection(std::numeric_limits<double>::quiet_NaN());
  CheckEqual("an angle that is none is the default", 0.35, reader->GetAngularDeflection());
  CheckEqual("the mesher's smallest deflection", 1e-5 * 200.0, sm::LimitDeflection(1e-9, 200.0));
}

/// Lengths near the kernel's precision: the mesher must come back.
void CheckNanometres(const std::string& text)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(
    Make("reader_nano.step", std::regex_replace(text, std::regex("\\.MILLI\\."), ".NANO.")).c_str());
  reader->Update();
  CheckTrue("a file in nanometres ends, with a mesh", GetLeaf(reader, 0)->GetNumberOfPolys() > 0);
}

/// A file without solids gives its shells.
void CheckLoose()
{
  vtkNew<vtkSTEPReader> reader;
  const std::string loose = Folder + "/reader_loose.step";
  WriteAssembly(loose, false);
  reader->SetFileName(loose.c_str());
  reader->Update();
  CheckEqual("a loose face is a leaf", 1, reader->GetNumberOfInstances());
  vtkNURBSDataSet* leaf = GetLeaf(reader, 0);
  CheckEqual("it is a shell", vtkTrimmedNURBSModel::SHELL, leaf->GetModel()->GetBody());
  Check("area scale in mm^2", 56.0, leaf->GetModel()->GetAreaScale(), 1e-12, "a rectangle");
}

/// Numbers in messages have a decimal point in every locale.
void CheckCommas(const std::string& text)
{
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8"))
  {
    std::exit(Skipped);
  }
  CheckEqual("the locale's decimal point", ",", std::localeconv()->decimal_point);
  // The first vertex moves by 0.25 mm: edges end away from it.
  const std::regex vertex("VERTEX_POINT\\('',(#[0-9]+)\\)");
  std::smatch found;
  CheckTrue("a vertex to move", std::regex_search(text, found, vertex));
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
  CheckTrue("messages with a decimal point", points > 0);
  CheckEqual("messages with a decimal comma", 0, commas);
}
}

int TestSTEPReader(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::fprintf(stderr, "usage: %s FOLDER [commas]\n", argv[0]);
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
    return Finish();
  }
  CheckAssembly(good, "mm", 1.0);
  CheckAssembly(good, "inch", 25.4);
  CheckAssembly(good, "file", 1.0);
  CheckMesh(good);
  CheckBrokenBodies();
  CheckDeflection();
  CheckNanometres(text);
  CheckLoose();
  return Finish();
}
