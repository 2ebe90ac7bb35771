// TestMassSensitivity FOLDER: derivatives of mass properties by an offset of a face, against differences of
// boxes and formulas of cylinders and balls, in the world's axes, within their bounds.
#include "smBoxBodies.h"
#include "smComputeMassProperties.h"
#include "smTestManifest.h"
#include "smTestPipeline.h"

#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkMassSensitivity.h>
#include <vtkMatrix4x4.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkTable.h>

namespace
{
using namespace smtest;
namespace names = sm::names;

constexpr double Pi = 3.14159265358979323846;

/// A column of the table of faces.
double Get(vtkMassSensitivity* filter, const std::string& name, vtkIdType row, int component = 0)
{
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(3));
  vtkDataArray* array = table->GetRowData()->GetArray(name.c_str());
  return array ? array->GetComponent(row, component) : vtkMath::Nan();
}

double GetBound(vtkMassSensitivity* filter, const std::string& name, vtkIdType row)
{
  return Get(filter, name + names::BoundSuffix, row);
}

/// A box of 3 by 4 by 6, one of whose sides is moved outwards by `offset`.
vtkSmartPointer<vtkNURBSDataSet> MakeBox(int side, double offset)
{
  BoxShell box{ { 1.0, 2.0, 3.0 }, { 4.0, 6.0, 9.0 } };
  (side % 2 == 0 ? box.Low : box.High)[side / 2] += (side % 2 == 0 ? -1.0 : 1.0) * offset;
  BoxBody body;
  body.Add(box);
  return body.Make();
}

void CheckBox()
{
  std::printf("--- a box in a placement, against differences\n");
  vtkNew<vtkMatrix4x4> placement;
  const double rows[16] = { 0.6, -0.8, 0, 10, 0.8, 0.6, 0, -20, 0, 0, 1, 30, 0, 0, 0, 1 };
  placement->DeepCopy(rows);
  const auto place = [&placement](vtkNURBSDataSet* leaf)
  {
    leaf->SetPlacement(placement);
    return leaf;
  };
  const auto base = MakeBox(0, 0.0);
  vtkNew<vtkMassSensitivity> filter;
  filter->SetBackend(vtkMassPropertiesGPU::CPU);
  filter->SetDensity(2700.0);
  filter->SetInputDataObject(place(base));
  filter->Update();
  CheckEqual("status", names::StatusOk, filter->GetStatus());
  Check("volume", 72.0, filter->GetVolume(), 1e-12);
  constexpr double h = 1e-3;
  sm::MassPropertiesOptions options;
  options.Density = 2700.0;
  for (int side = 0; side < 6; ++side)
  {
    const std::string what = "side " + std::to_string(side) + ": ";
    sm::BodyMassProperties ends[2];
    for (int i = 0; i < 2; ++i)
    {
      const auto moved = MakeBox(side, i == 0 ? -h : h);
      ends[i] = sm::ComputeMassProperties(place(moved), options).Total;
    }
    const auto slope = [](double low, double high) { return (high - low) / (2.0 * h); };
    Check(what + "volume", slope(ends[0].Volume.Value, ends[1].Volume.Value),
      Get(filter, names::VolumePerOffset, side), 1e-9, "rounding of a difference");
    Check(what + "mass", slope(ends[0].Mass.Value, ends[1].Mass.Value),
      Get(filter, names::MassPerOffset, side), 1e-14);
    Check(what + "area", slope(ends[0].Area.Value, ends[1].Area.Value),
      Get(filter, names::SurfaceAreaPerOffset, side), 1e-9);
    CheckRange(what + "bound of the area", 0.0, GetBound(filter, names::SurfaceAreaPerOffset, side), 1e-10);
    for (int d = 0; d < 3; ++d)
    {
      Check(what + "centre", slope(ends[0].Center.Value[d], ends[1].Center.Value[d]),
        Get(filter, names::CenterOfMassPerOffset, side, d), 1e-9);
      // The third derivative of a moment is some 100.
      Check(what + "principal moment",
        slope(ends[0].PrincipalMoments.Value[d], ends[1].PrincipalMoments.Value[d]),
        Get(filter, names::PrincipalMomentsPerOffset, side, d), 100.0 * h * h);
    }
    for (const char* name : { names::VolumePerOffset, names::CenterOfMassPerOffset,
           names::PrincipalMomentsPerOffset, names::MassPerOffset })
    {
      CheckRange(what + name + " bound", 0.0, GetBound(filter, name, side), 1e-7, "1e-9 of some 100");
    }
  }
  // Without a density there is no mass; an open solid has no volume that a face adds to with certainty.
  filter->SetDensity(0.0);
  filter->Update();
  CheckTrue("no density, no mass", std::isnan(Get(filter, names::MassPerOffset, 0)));
  Check("but a volume", 24.0, Get(filter, names::VolumePerOffset, 0), 1e-12);
}

void CheckColors()
{
  std::printf("--- cell arrays\n");
  vtkNew<vtkMassSensitivity> filter;
  filter->SetBackend(vtkMassPropertiesGPU::CPU);
  const auto box = MakeBox(0, 0.0);
  filter->SetInputDataObject(box);
  filter->Update(5);
  auto* meshes = vtkPartitionedDataSetCollection::SafeDownCast(filter->GetOutputDataObject(5));
  auto* mesh = vtkDataSet::SafeDownCast(meshes->GetPartitionAsDataObject(0, 0));
  CheckTrue("a mesh", mesh && mesh->GetNumberOfCells() == 12);
  for (const char* name : { "VolumePerOffset", "MassPerOffset", "SurfaceAreaPerOffset",
         "CenterOfMassPerOffset_X", "CenterOfMassPerOffset_Y", "CenterOfMassPerOffset_Z",
         "PrincipalMomentsPerOffset_1", "PrincipalMomentsPerOffset_2", "PrincipalMomentsPerOffset_3" })
  {
    CheckTrue(std::string("array ") + name, mesh && mesh->GetCellData()->GetArray(name) != nullptr);
  }
  vtkDataArray* volume = mesh ? mesh->GetCellData()->GetArray(names::VolumePerOffset) : nullptr;
  for (vtkIdType cell = 0; volume && cell < 12; ++cell)
  {
    Check("colour of a cell", Get(filter, names::VolumePerOffset, cell / 2), volume->GetTuple1(cell), 1e-5);
  }
}

void Run(vtkMassSensitivity* filter, vtkSTEPReader* reader, const Expected& expected)
{
  reader->SetFileName(expected.Path.c_str());
  UseCoarseMesh(reader);
  filter->SetBackend(vtkMassPropertiesGPU::CPU);
  filter->SetInputConnection(reader->GetOutputPort());
  filter->Update();
}

void CheckRound(const Manifest& manifest)
{
  for (const char* variant : { "plain", "moved", "mirrored" })
  {
    std::printf("--- cylinder and ball, %s\n", variant);
    vtkNew<vtkSTEPReader> reader;
    vtkNew<vtkMassSensitivity> filter;
    Run(filter, reader, manifest.GetSolid("cylinder", variant)[0]);
    const double v = filter->GetVolume();
    double cap = std::numeric_limits<double>::infinity();
    vtkIdType side = 0;
    double sum = 0.0;
    for (vtkIdType row = 0; row < 3; ++row)
    {
      const double area = Get(filter, names::VolumePerOffset, row);
      sum += area;
      cap = std::min(cap, area);
      side = area > Get(filter, names::VolumePerOffset, side) ? row : side;
    }
    Check("sum over the faces", filter->GetSurfaceArea(), sum, 1e-9 * sum);
    const double r = std::sqrt(cap / Pi);
    const double h = v / cap;
    Check("side", 2.0 * Pi * r * h, Get(filter, names::VolumePerOffset, side),
      GetBound(filter, names::VolumePerOffset, side) + 1e-9 * sum, "the caps' bounds");
    const auto checkArea = [](vtkMassSensitivity* run, vtkIdType row, double expected)
    {
      Check("area", expected, Get(run, names::SurfaceAreaPerOffset, row),
        GetBound(run, names::SurfaceAreaPerOffset, row) + 1e-9 * std::abs(expected), "the digits of r and h");
      CheckRange("bound of the area", 0.0, GetBound(run, names::SurfaceAreaPerOffset, row), 1e-5 * expected);
    };
    for (vtkIdType row = 0; row < 3; ++row)
    {
      checkArea(filter, row, row == side ? 4.0 * Pi * r + 2.0 * Pi * h : 2.0 * Pi * r);
    }
    const double axial = 2.0 * Pi * r * r * r * h;
    int known = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double slope = Get(filter, names::PrincipalMomentsPerOffset, side, k);
      if (!std::isnan(slope))
      {
        ++known;
        Check("moment about the axis", axial, slope, 1e-9 * axial);
      }
      Check("centre", 0.0, Get(filter, names::CenterOfMassPerOffset, side, k), 1e-9);
    }
    CheckEqual("the other two coincide", 1, known);

    vtkNew<vtkSTEPReader> second;
    vtkNew<vtkMassSensitivity> ball;
    Run(ball, second, manifest.GetSolid("sphere", variant)[0]);
    const double radius = std::cbrt(0.75 * ball->GetVolume() / Pi);
    Check("ball", 4.0 * Pi * radius * radius, Get(ball, names::VolumePerOffset, 0),
      1e-9 * ball->GetSurfaceArea());
    checkArea(ball, 0, 8.0 * Pi * radius);
    CheckTrue("whose moments coincide",
      std::isnan(Get(ball, names::PrincipalMomentsPerOffset, 0, 0)) &&
        std::isnan(GetBound(ball, names::PrincipalMomentsPerOffset, 0)));
  }
}

void CheckOpen()
{
  std::printf("--- a shell\n");
  BoxBody body;
  body.Add({ { 0, 0, 0 }, { 1, 2, 3 }, true, 5 });
  vtkNew<vtkMassSensitivity> filter;
  MessageTrap trap(filter);
  filter->SetBackend(vtkMassPropertiesGPU::CPU);
  filter->SetInputDataObject(body.Make(false));
  filter->Update();
  CheckTrue("has no volume", std::isnan(filter->GetVolume()));
  CheckTrue("and no derivatives",
    std::isnan(Get(filter, names::VolumePerOffset, 0)) &&
      std::isnan(Get(filter, names::CenterOfMassPerOffset, 0)));
}
}

int TestMassSensitivity(int argc, char* argv[])
{
  RequireUsage(argc == 2, "TestMassSensitivity FOLDER");
  CheckBox();
  CheckColors();
  CheckRound(Manifest(argv[1]));
  CheckOpen();
  return Finish();
}
