// TestMassPropertiesInstances FOLDER: 500 instances of one part, two solids in one file, a mirrored and a
// reversed placement: integrated once, carried exactly.
#include "smTestManifest.h"
#include "smTestPipeline.h"

#include <vtkMatrix4x4.h>
#include <vtkNURBSDataSet.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkTable.h>

#include <cstdio>
#include <set>

namespace
{
using namespace smtest;
namespace names = sm::names;

void CheckTotal(const Expected& expected, vtkMassPropertiesGPU* mass)
{
  vtkFieldData* fields = mass->GetOutput()->GetFieldData();
  CheckEqual("status", names::StatusOk, mass->GetStatus());
  CheckEqual("solids", expected.Solids, mass->GetNumberOfSolids());
  Check("volume", expected.Volume, mass->GetVolume(), 1e-9 * expected.Volume);
  Check("volume within its bound", expected.Volume, mass->GetVolume(),
    mass->GetVolumeBound() + expected.VolumeAccuracy);
  Check("area", expected.Area, mass->GetSurfaceArea(), 1e-8 * expected.Area);
  const char* const bounded[] = { names::Volume, names::SurfaceArea, names::CenterOfMass,
    names::VolumeInertia };
  for (int i = 0; i < 4; ++i)
  {
    // Faces are curved, or placements are read: no bound is without an estimated part, and quadrature is
    // proved.
    CheckRange(std::string("estimated part of the bound of ") + bounded[i], 1e-6,
      GetField(fields, names::BoundsMeasured, i) / GetFieldBound(fields, bounded[i]), 1.0);
  }
  const double trace = expected.GetInertiaTrace();
  for (int i = 0; i < 3; ++i)
  {
    Check("centre " + std::to_string(i), expected.Center[i], GetField(fields, names::CenterOfMass, i),
      1e-9 * expected.Size);
  }
  for (int i = 0; i < 9; ++i)
  {
    Check("inertia " + std::to_string(i), expected.Inertia[i], GetField(fields, names::VolumeInertia, i),
      1e-8 * trace);
    Check("inertia " + std::to_string(i) + " within its bound", expected.Inertia[i],
      GetField(fields, names::VolumeInertia, i),
      GetFieldBound(fields, names::VolumeInertia) + expected.InertiaAccuracy);
  }
}

void CheckAssembly(const Manifest& manifest)
{
  std::printf("--- assembly\n");
  const Expected expected = manifest.GetSpecial("assembly");
  Pipeline pipeline(expected.Path);
  pipeline.Mass->Update();
  CheckTotal(expected, pipeline.Mass);
  CheckEqual("bodies", 1, pipeline.Reader->GetNumberOfBodies());
  CheckEqual("instances", 500, pipeline.Reader->GetNumberOfInstances());

  auto* output = vtkPartitionedDataSetCollection::SafeDownCast(pipeline.Reader->GetOutputDataObject(0));
  std::set<vtkTrimmedNURBSModel*> models;
  for (unsigned int i = 0; i < output->GetNumberOfPartitionedDataSets(); ++i)
  {
    auto* leaf = vtkNURBSDataSet::SafeDownCast(output->GetPartition(i, 0));
    models.insert(leaf ? leaf->GetModel() : nullptr);
  }
  CheckEqual("models shared by the instances", 1, static_cast<long long>(models.size()));

  auto* table = vtkTable::SafeDownCast(pipeline.Mass->GetOutputDataObject(1));
  std::set<std::string> ids;
  double worst = 0.0;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    ids.insert(table->GetValueByName(row, names::Id).ToString());
    worst = std::fmax(
      worst, std::fabs(table->GetValueByName(row, names::Volume).ToDouble() - expected.Volume / 500));
  }
  CheckEqual("rows of the table", 500, table->GetNumberOfRows());
  CheckEqual("different ids", 500, static_cast<long long>(ids.size()));
  Check("volume of every row", 0.0, worst, 1e-9 * expected.Volume / 500);
  // One part is integrated, not five hundred: as many evaluations as the part alone needs.
  const double evaluations = static_cast<double>(pipeline.Mass->GetEvaluations());
  CheckRange("evaluations", 1.0, evaluations, 1e5, "(three faces)");
}

void CheckTwoSolids(const Manifest& manifest)
{
  std::printf("--- two solids\n");
  const Expected expected = manifest.GetSpecial("two_solids");
  Pipeline pipeline(expected.Path);
  pipeline.Mass->Update();
  CheckTotal(expected, pipeline.Mass);
  auto* table = vtkTable::SafeDownCast(pipeline.Mass->GetOutputDataObject(1));
  CheckEqual("rows", 2, table->GetNumberOfRows());
  const double ball = expected.Volume - 6000.0;
  const double first = table->GetValueByName(0, names::Volume).ToDouble();
  const double second = table->GetValueByName(1, names::Volume).ToDouble();
  Check("box", 6000.0, std::fmax(first, second), 1e-9 * 6000.0);
  Check("ball", ball, std::fmin(first, second), 1e-9 * ball);
}

/// The faces on port 3 add up to the total.
void CheckFaces(const Manifest& manifest)
{
  std::printf("--- faces\n");
  Pipeline pipeline(manifest.GetSolid("slanted_hole", "plain")[0].Path);
  pipeline.Mass->Update();
  auto* faces = vtkTable::SafeDownCast(pipeline.Mass->GetOutputDataObject(3));
  CheckEqual("rows", 7, faces->GetNumberOfRows());
  double area = 0.0;
  double bound = 0.0;
  for (vtkIdType row = 0; row < faces->GetNumberOfRows(); ++row)
  {
    area += faces->GetValueByName(row, names::SurfaceArea).ToDouble();
    bound +=
      faces->GetValueByName(row, (std::string(names::SurfaceArea) + names::BoundSuffix).c_str()).ToDouble();
    CheckTrue("face has an entity number", faces->GetValueByName(row, names::FaceId).ToInt() > 0);
  }
  // 16 roundings in adding seven faces.
  const double epsilon = 16 * std::numeric_limits<double>::epsilon();
  Check("sum of areas", pipeline.Mass->GetSurfaceArea(), area, epsilon * area);
  Check("sum of bounds", pipeline.Mass->GetSurfaceAreaBound(), bound, 1e-3 * bound + epsilon * area);
}

/// A leaf of the reader in a placement of our own, mirrored or not: c' = R c + t, C' = R C R^T.
void CheckPlacement(const Manifest& manifest, bool mirrored)
{
  std::printf("--- %s placement\n", mirrored ? "mirrored" : "rotated");
  const Expected part = manifest.GetSolid("slanted_hole", "plain")[0];
  Pipeline pipeline(part.Path);
  pipeline.Reader->Update();
  auto* output = vtkPartitionedDataSetCollection::SafeDownCast(pipeline.Reader->GetOutputDataObject(0));
  vtkNew<vtkNURBSDataSet> leaf;
  leaf->ShallowCopy(output->GetPartition(0, 0));
  const double sign = mirrored ? -1.0 : 1.0;
  const double r[3][3] = { { 0.6 * sign, -0.8, 0.0 }, { 0.8 * sign, 0.6, 0.0 }, { 0.0, 0.0, 1.0 } };
  const double t[3] = { 10.0, -20.0, 5.0 };
  vtkNew<vtkMatrix4x4> placement;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      placement->SetElement(i, j, r[i][j]);
    }
    placement->SetElement(i, 3, t[i]);
  }
  leaf->SetPlacement(placement);
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetInputData(leaf);
  mass->Update();
  Check("volume", part.Volume, mass->GetVolume(), 1e-9 * part.Volume, "(positive when mirrored, too)");
  double center[3];
  double inertia[9];
  mass->GetCenterOfMass(center);
  mass->GetVolumeInertia(inertia);
  for (int i = 0; i < 3; ++i)
  {
    double expected = t[i];
    for (int k = 0; k < 3; ++k)
    {
      expected += r[i][k] * part.Center[k];
    }
    Check("centre " + std::to_string(i), expected, center[i], 1e-9 * part.Size);
    for (int j = 0; j < 3; ++j)
    {
      double entry = 0.0;
      for (int k = 0; k < 9; ++k)
      {
        entry += r[i][k / 3] * part.Inertia[k] * r[j][k % 3];
      }
      Check("inertia " + std::to_string(3 * i + j), entry, inertia[3 * i + j], 1e-8 * part.GetInertiaTrace());
    }
  }
}
}

int TestMassPropertiesInstances(int argc, char* argv[])
{
  RequireUsage(argc == 2, "TestMassPropertiesInstances FOLDER");
  const Manifest manifest(argv[1]);
  CheckAssembly(manifest);
  CheckTwoSolids(manifest);
  CheckFaces(manifest);
  CheckPlacement(manifest, false);
  CheckPlacement(manifest, true);
  return Finish();
}
