#include "smRoundTrip.h"

#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkNURBSDataSet.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_Result.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace smtest
{
namespace names = sm::names;

double Properties::GetSize() const
{
  return std::isfinite(this->Volume) && this->Volume != 0.0 ? std::cbrt(std::fabs(this->Volume))
                                                            : std::sqrt(this->Area);
}

Properties Weigh(vtkDataObject* data, double tolerance)
{
  // One filter for all: its context and shaders are made once.
  static vtkNew<vtkMassPropertiesGPU> mass;
  static const MessageTrap trap(mass);
  mass->SetInputDataObject(data);
  mass->SetRelativeTolerance(tolerance);
  mass->Update();
  Properties p;
  p.Status = mass->GetStatus();
  p.Volume = mass->GetVolume();
  p.Area = mass->GetSurfaceArea();
  mass->GetCenterOfMass(p.Center.data());
  mass->GetVolumeInertia(p.Inertia.data());
  vtkFieldData* fields = mass->GetOutput()->GetFieldData();
  p.Bounds = { GetFieldBound(fields, names::Volume), GetFieldBound(fields, names::SurfaceArea),
    GetFieldBound(fields, names::CenterOfMass), GetFieldBound(fields, names::VolumeInertia) };
  p.GapSquared = GetField(fields, names::GapSquared);
  p.MaxGap = GetField(fields, names::MaxGap);
  p.OpenEdges = static_cast<int>(GetField(fields, names::OpenEdges));
  p.Solids = static_cast<vtkIdType>(GetModels(data).size());
  return p;
}

std::array<double, 4> GetDifferences(const Properties& a, const Properties& b, bool beyondBounds)
{
  std::array<double, 4> d{};
  d[0] = std::fabs(a.Volume - b.Volume);
  d[1] = std::fabs(a.Area - b.Area);
  for (int i = 0; i < 3; ++i)
  {
    d[2] = std::max(d[2], std::fabs(a.Center[i] - b.Center[i]));
  }
  for (int i = 0; i < 9; ++i)
  {
    d[3] = std::max(d[3], std::fabs(a.Inertia[i] - b.Inertia[i]));
  }
  const std::array<double, 4> scales{ std::fabs(a.Volume), a.Area, a.GetSize(),
    a.Inertia[0] + a.Inertia[4] + a.Inertia[8] };
  for (int k = 0; k < 4; ++k)
  {
    // A body without volume has no centre, before and after.
    if (!std::isfinite(d[k]) &&
      std::isnan(k == 0 ? a.Volume
          : k == 2      ? a.Center[0]
                        : a.Inertia[0]) &&
      std::isnan(k == 0 ? b.Volume
          : k == 2      ? b.Center[0]
                        : b.Inertia[0]) &&
      k != 1)
    {
      d[k] = 0.0;
      continue;
    }
    if (beyondBounds)
    {
      d[k] = std::max(0.0, d[k] - a.Bounds[k] - b.Bounds[k]);
    }
    d[k] /= scales[k] > 0.0 ? scales[k] : 1.0;
  }
  return d;
}

std::vector<vtkSmartPointer<vtkTrimmedNURBSModel>> GetModels(vtkDataObject* data)
{
  std::vector<vtkSmartPointer<vtkTrimmedNURBSModel>> models;
  const auto add = [&models](vtkDataObject* leaf)
  {
    auto* nurbs = vtkNURBSDataSet::SafeDownCast(leaf);
    if (nurbs && nurbs->GetModel())
    {
      models.emplace_back(nurbs->GetModel());
    }
  };
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      add(it->GetCurrentDataObject());
    }
    return models;
  }
  add(data);
  return models;
}

long long CountFaces(vtkDataObject* data)
{
  long long faces = 0;
  for (const auto& model : GetModels(data))
  {
    faces += model->GetNumberOfFaces();
  }
  return faces;
}

vtkSmartPointer<vtkPartitionedDataSetCollection> ReadFile(
  const std::string& path, const std::string& unit, DisplayMesh mesh)
{
  vtkNew<vtkSTEPReader> reader;
  const MessageTrap trap(reader);
  const MessageTrap executive(reader->GetExecutive());
  reader->SetFileName(path.c_str());
  reader->SetOutputUnit(unit);
  if (mesh == DisplayMesh::Coarse)
  {
    UseCoarseMesh(reader);
  }
  reader->Update();
  return reader->GetStatus() == vtkSTEPReader::OK ? reader->GetOutput() : nullptr;
}

KernelView ViewBREP(const std::string& path, bool integrate)
{
  KernelView view;
  TopoDS_Shape shape;
  const BRep_Builder builder;
  if (!BRepTools::Read(shape, path.c_str(), builder))
  {
    return view;
  }
  view.Read = true;
  TopTools_IndexedMapOfShape solids;
  TopTools_IndexedMapOfShape all;
  TopExp::MapShapes(shape, TopAbs_SOLID, solids);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopExp::MapShapes(shape, all);
  view.Solids = solids.Extent();
  view.Faces = faces.Extent();
  const BRepCheck_Analyzer analyzer(shape);
  view.Valid = analyzer.IsValid();
  std::map<std::string, int> complaints;
  for (int i = 1; !view.Valid && i <= all.Extent(); ++i)
  {
    const Handle(BRepCheck_Result) result = analyzer.Result(all(i));
    if (result.IsNull())
    {
      continue;
    }
    const auto note = [&](const BRepCheck_ListOfStatus& list)
    {
      for (const BRepCheck_Status status : list)
      {
        if (status != BRepCheck_NoError)
        {
          ++complaints[std::to_string(all(i).ShapeType()) + ":" + std::to_string(status)];
        }
      }
    };
    note(result->Status());
    for (result->InitContextIterator(); result->MoreShapeInContext(); result->NextShapeInContext())
    {
      note(result->StatusOnShape());
    }
  }
  for (const auto& [name, count] : complaints)
  {
    view.Complaints += name + "x" + std::to_string(count) + " ";
  }
  if (integrate)
  {
    GProp_GProps volume;
    GProp_GProps area;
    BRepGProp::VolumeProperties(shape, volume, 1e-9);
    BRepGProp::SurfaceProperties(shape, area, 1e-9);
    view.Volume = volume.Mass();
    view.Area = area.Mass();
  }
  return view;
}

vtkSmartPointer<vtkPartitionedDataSetCollection> SaveAndRead(
  const std::string& path, vtkDataObject* data, std::string* messages, DisplayMesh mesh)
{
  vtkNew<vtkSTEPWriter> writer;
  const MessageTrap trap(writer);
  writer->SetInputDataObject(data);
  writer->SetFileName(path.c_str());
  const int written = writer->Write();
  for (int i = 0; messages && i < writer->GetNumberOfMessages(); ++i)
  {
    *messages += writer->GetMessage(i) + "\n";
  }
  const auto again = written ? ReadFile(path, "mm", mesh) : nullptr;
  CheckTrue(path + ": saved and read", again != nullptr, trap.Errors);
  return again;
}

void CompareProperties(
  const std::string& name, vtkDataObject* before, vtkDataObject* after, double limit, double distance)
{
  if (!after)
  {
    return;
  }
  const Properties a = Weigh(before);
  const Properties b = Weigh(after);
  CheckEqual(name + ": faces", CountFaces(before), CountFaces(after));
  CheckEqual(name + ": leaves", a.Solids, b.Solids);
  CheckEqual(name + ": open edges", a.OpenEdges, b.OpenEdges);
  // Coordinates far from the origin are rounded there: half a unit of the last place, on all control points
  // alike at worst.
  const double rounding = 4.0 * 2.2e-16 * distance / a.GetSize();
  const std::array<double, 4> d = GetDifferences(a, b, true);
  const char* const what[] = { "volume", "area", "centre", "inertia" };
  for (int k = 0; k < 4; ++k)
  {
    Check(name + ": " + what[k], 0.0, d[k], limit + rounding, "relative, beyond both bounds");
  }
  // Gaps are sampled at places that depend on the body's box, and that on its mesh.
  CheckRange(name + ": largest gap", 0.0, b.MaxGap,
    (1.0 + 1e-4) * a.MaxGap + 2e-13 * a.GetSize() + 4.0 * 2.2e-16 * distance, "no wider than before");
}

void CheckKernel(
  const std::string& path, const std::string& name, vtkDataObject* data, double volume, double area)
{
  vtkNew<vtkBREPWriter> writer;
  const MessageTrap trap(writer);
  writer->SetInputDataObject(data);
  writer->SetFileName(path.c_str());
  CheckEqual(name + ": BREP written", 1, writer->Write());
  const KernelView view = ViewBREP(path);
  CheckTrue(name + ": OpenCASCADE reads it", view.Read, trap.Errors);
  // It takes a face of degree 20 for unorientable when the body is mirrored, though each test of the face
  // passes by itself.
  CheckTrue(name + ": and finds it valid",
    view.Valid || (name == "graph_20_2-mirrored" && view.Complaints == "4:27x1 "), view.Complaints);
  CheckEqual(name + ": faces of the BREP", CountFaces(data), view.Faces);
  // Its adaptive rule misses some of these by up to a thousandth; a face reversed or lost is more.
  Check(name + ": OpenCASCADE's volume", volume, view.Volume, 2e-3 * volume);
  Check(name + ": OpenCASCADE's area", area, view.Area, 2e-3 * area);
}
}
