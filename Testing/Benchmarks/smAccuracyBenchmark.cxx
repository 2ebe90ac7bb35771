// Benchmark accuracy FILE.step...: errors of volumes against the
// seconds of the processor that they take once the file is read, by our filter, by OpenCASCADE's BRepGProp,
// and by meshes of OpenCASCADE and vtkMassProperties.
//
// The true volume of a file that FILE.json names is the middle of its interval there; of others it is ours at
// a tolerance of 1e-13, so that ours are compared with themselves. Files are left out that one of them cannot
// read, whose volume is not known to 1e-10, or that OpenCASCADE repairs into another body (more than 1e-3
// apart).
#include "smBenchmark.h"
#include "smJson.h"
#include "smProcessorTime.h"

#include <smFormat.h>
#include <smSafeFile.h>
#include <vtkCellArray.h>
#include <vtkMassProperties.h>
#include <vtkMassPropertiesGPU.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkSTEPReader.h>
#include <vtkSmartPointer.h>

#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace
{
using sm::Json;
using smtest::ProcessorTime;

/// A volume in mm^3 and the seconds that it took; Bound: half the width of an interval that holds the true
/// one, or infinity.
struct Measured
{
  double Volume = std::nan("");
  double Bound = HUGE_VAL;
  double Seconds = 0.0;
};

enum class Program
{
  Ours,
  Kernel,
  Mesh
};

/// One way to a volume. Accuracy: our tolerance, BRepGProp's Eps (0: its default rule), or the deflection as
/// a part of the diagonal.
struct Method
{
  Program By;
  double Accuracy;
};

const std::vector<Method> Methods = { { Program::Ours, 1e-3 }, { Program::Ours, 1e-6 },
  { Program::Ours, 1e-9 }, { Program::Ours, 1e-12 }, { Program::Kernel, 0.0 }, { Program::Kernel, 1e-3 },
  { Program::Kernel, 1e-6 }, { Program::Mesh, 1e-2 }, { Program::Mesh, 1e-3 }, { Program::Mesh, 1e-4 } };

constexpr double ReferenceTolerance = 1e-13;
/// Relative half width of a reference: a file whose reference is known less well is left out.
constexpr double MinKnown = 1e-10;
constexpr double SameBody = 1e-3;
/// The mesher's angle: OpenCASCADE's usual one.
constexpr double MeshAngle = 0.5;

std::string GetName(const Method& method)
{
  char text[80];
  switch (method.By)
  {
    case Program::Ours:
      std::snprintf(text, sizeof text, "SolidMoments, tolerance %.0e", method.Accuracy);
      break;
    case Program::Kernel:
      std::snprintf(text, sizeof text, method.Accuracy > 0.0 ? "BRepGProp, Eps %.0e" : "BRepGProp, default",
        method.Accuracy);
      break;
    case Program::Mesh:
      std::snprintf(text, sizeof text, "BRepMesh at %.0e, vtkMassProperties", method.Accuracy);
  }
  return text;
}

/// Measures our filter with a reader of its own, so that nothing is kept from one measurement to the next.
Measured MeasureOurs(const std::string& path, double tolerance)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetInputConnection(reader->GetOutputPort());
  mass->SetBackend(vtkMassPropertiesGPU::CPU);
  mass->SetRelativeTolerance(tolerance);
  const ProcessorTime watch;
  mass->Update();
  return { mass->GetVolume(), mass->GetVolumeBound(), watch.GetSeconds() };
}

Measured MeasureKernel(const TopoDS_Shape& shape, double eps)
{
  GProp_GProps volume;
  const ProcessorTime watch;
  if (eps > 0.0)
  {
    BRepGProp::VolumeProperties(shape, volume, eps);
  }
  else
  {
    BRepGProp::VolumeProperties(shape, volume);
  }
  return { volume.Mass(), HUGE_VAL, watch.GetSeconds() };
}

vtkSmartPointer<vtkPolyData> CollectTriangles(const TopoDS_Shape& shape)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
  {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(TopoDS::Face(it.Current()), location);
    if (mesh.IsNull())
    {
      continue;
    }
    const vtkIdType first = points->GetNumberOfPoints() - 1;
    for (int i = 1; i <= mesh->NbNodes(); ++i)
    {
      const gp_Pnt p = mesh->Node(i).Transformed(location.Transformation());
      points->InsertNextPoint(p.X(), p.Y(), p.Z());
    }
    for (int i = 1; i <= mesh->NbTriangles(); ++i)
    {
      int a = 0;
      int b = 0;
      int c = 0;
      mesh->Triangle(i).Get(a, b, c);
      const bool reversed = it.Current().Orientation() == TopAbs_REVERSED;
      const vtkIdType corners[3] = { first + a, first + (reversed ? c : b), first + (reversed ? b : c) };
      cells->InsertNextCell(3, corners);
    }
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(cells);
  return result;
}

Measured MeasureMesh(const TopoDS_Shape& shape, double deflection)
{
  Bnd_Box box;
  BRepBndLib::Add(shape, box);
  BRepTools::Clean(shape);
  const ProcessorTime watch;
  BRepMesh_IncrementalMesh(shape, deflection * std::sqrt(box.SquareExtent()), false, MeshAngle, false);
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(CollectTriangles(shape));
  mass->Update();
  return { mass->GetVolume(), HUGE_VAL, watch.GetSeconds() };
}

Measured Measure(const Method& method, const std::string& path, const TopoDS_Shape& shape)
{
  switch (method.By)
  {
    case Program::Ours:
      return MeasureOurs(path, method.Accuracy);
    case Program::Kernel:
      return MeasureKernel(shape, method.Accuracy);
    default:
      return MeasureMesh(shape, method.Accuracy);
  }
}

std::string GetFileName(const std::string& path)
{
  return path.substr(path.rfind('/') + 1);
}

/// Volumes and half widths of the intervals of a certified set, in mm^3, by file.
std::map<std::string, Measured> ReadCertified(const std::string& path)
{
  static const std::map<std::string, double> units = { { "mm", 1.0 }, { "cm", 10.0 }, { "m", 1000.0 },
    { "inch", 25.4 } };
  std::ifstream file(path);
  const Json set = Json::parse(file);
  std::map<std::string, Measured> result;
  for (const Json& solid : set["solids"])
  {
    const double cube = std::pow(units.at(solid["length_unit"].get<std::string>()), 3.0);
    const double low = cube * std::strtod(solid["volume"][0].get<std::string>().c_str(), nullptr);
    const double high = cube * std::strtod(solid["volume"][1].get<std::string>().c_str(), nullptr);
    result[solid["file"]] = { 0.5 * (low + high), 0.5 * (high - low), 0.0 };
  }
  return result;
}

TopoDS_Shape ReadShape(const std::string& path)
{
  STEPControl_Reader reader;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
  {
    return {};
  }
  reader.TransferRoots();
  return reader.OneShape();
}

/// Relative errors and seconds of one method on all files.
struct Column
{
  std::vector<double> Errors;
  double Seconds = 0.0;
  double MaxBound = 0.0;

  double GetMedian() const { return this->GetQuantile(0.5); }
  double GetQuantile(double share) const
  {
    std::vector<double> sorted = this->Errors;
    const auto at = static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1) + 0.5);
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(at), sorted.end());
    return sorted[at];
  }
};

/// Adds a file to all columns. Returns why it was left out, or an empty text; sets `exceeded` where a bound
/// is.
std::string AddFile(const std::string& path, const std::map<std::string, Measured>& certified,
  std::vector<Column>& columns, bool& exceeded)
{
  const TopoDS_Shape shape = ReadShape(path);
  const auto known = certified.find(GetFileName(path));
  const Measured truth = known != certified.end() ? known->second : MeasureOurs(path, ReferenceTolerance);
  if (shape.IsNull() || !(truth.Bound <= MinKnown * truth.Volume))
  {
    return "the volume is not known";
  }
  std::vector<Measured> all;
  for (const Method& method : Methods)
  {
    try
    {
      all.push_back(Measure(method, path, shape));
    }
    catch (const Standard_Failure& failure)
    {
      return GetName(method) + ": " + failure.GetMessageString();
    }
    const Measured& now = all.back();
    const double rest = method.By == Program::Mesh ? HUGE_VAL : SameBody * truth.Volume;
    if (!(std::abs(now.Volume - truth.Volume) <= std::max(rest, now.Bound)))
    {
      return GetName(method) + ": another body";
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const double error = std::abs(all[i].Volume - truth.Volume);
    columns[i].Errors.push_back(error / truth.Volume);
    columns[i].Seconds += all[i].Seconds;
    columns[i].MaxBound = std::max(columns[i].MaxBound, all[i].Bound / truth.Volume);
    exceeded = exceeded || error > all[i].Bound + truth.Bound;
  }
  return "";
}

/// Writes the numbers for draw_figures.py. Returns an error message, empty when they are written.
std::string WriteTable(const std::vector<Column>& columns, const std::string& path)
{
  std::string text = "method,seconds,median_error,largest_error,largest_bound\n";
  for (std::size_t i = 0; i < Methods.size(); ++i)
  {
    const Column& c = columns[i];
    text += "\"" + GetName(Methods[i]) + "\"," + sm::FormatDigits(c.Seconds, 17) + "," +
      sm::FormatDigits(c.GetMedian(), 17) + "," + sm::FormatDigits(c.GetQuantile(1.0), 17) + "," +
      (Methods[i].By == Program::Ours ? sm::FormatDigits(c.MaxBound, 17) : "") + "\n";
  }
  const std::string problem = sm::SaveFile(path, text);
  return problem.empty() ? "" : path + " could not be written: " + problem;
}

int Run(const std::vector<std::string>& paths, const std::string& certifiedPath, const std::string& folder)
{
  std::map<std::string, Measured> certified;
  if (!certifiedPath.empty())
  {
    certified = ReadCertified(certifiedPath);
  }
  std::vector<Column> columns(Methods.size());
  bool exceeded = false;
  for (const std::string& path : paths)
  {
    const std::string problem = AddFile(path, certified, columns, exceeded);
    if (!problem.empty())
    {
      std::printf("%s is left out: %s\n", GetFileName(path).c_str(), problem.c_str());
    }
  }
  if (columns[0].Errors.empty())
  {
    std::fprintf(stderr, "no file is left\n");
    return 1;
  }
  std::printf(
    "%zu files\n| | seconds | median error | largest error | largest bound |\n|---|---|---|---|---|\n",
    columns[0].Errors.size());
  for (std::size_t i = 0; i < Methods.size(); ++i)
  {
    const Column& c = columns[i];
    std::printf("| %s | %.3f | %.1e | %.1e | ", GetName(Methods[i]).c_str(), c.Seconds, c.GetMedian(),
      c.GetQuantile(1.0));
    std::printf(Methods[i].By == Program::Ours ? "%.1e |\n" : "|\n", c.MaxBound);
  }
  if (!folder.empty())
  {
    const std::string problem = WriteTable(columns, folder + "/accuracy_over_time.csv");
    if (!problem.empty())
    {
      std::fprintf(stderr, "%s\n", problem.c_str());
      return 1;
    }
  }
  if (exceeded)
  {
    std::fprintf(stderr, "a bound is exceeded\n");
  }
  return exceeded ? 1 : 0;
}

int RunGuarded(const std::vector<std::string>& paths, const std::string& certified, const std::string& folder)
{
  vtkObject::GlobalWarningDisplayOff();
  Message::DefaultMessenger()->ChangePrinters().Clear();
  vtkSMPTools::SetBackend("Sequential");
  try
  {
    return Run(paths, certified, folder);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
  }
  catch (const Standard_Failure& failure)
  {
    std::fprintf(stderr, "OpenCASCADE: %s\n", failure.GetMessageString());
  }
  return 1;
}

void Add(CLI::App& app, int& status)
{
  static std::string certified;
  static std::string folder;
  static std::vector<std::string> paths;
  CLI::App* command = app.add_subcommand("accuracy",
    "Errors of volumes against the seconds that they take. Exit status 1: a volume is farther from the true "
    "one than "
    "its bound and the interval allow, or nothing could be written");
  command->add_option("FILE", paths, "STEP files")->required();
  command->add_option("--certified", certified, "JSON of a certified set with the intervals of volumes");
  command->add_option(
    "--output", folder, "folder for accuracy_over_time.csv, which Examples/Paper/draw_figures.py draws");
  command->callback([&status]() { status = RunGuarded(paths, certified, folder); });
}
const smtest::BenchmarkEntry Entry(Add);
}
