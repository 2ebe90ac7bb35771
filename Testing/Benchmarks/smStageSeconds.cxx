#include "smStageSeconds.h"

#include <vtkMassPropertiesGPU.h>
#include <vtkNURBSDataSet.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSTEPReader.h>
#include <vtkTimerLog.h>
#include <vtkTrimmedNURBSModel.h>

#include <algorithm>
#include <ctime>
#include <set>

/// In a program with this file the clock of VTK is the processor's time, and so are the seconds of our
/// stages, which go by it. A stage during which other programs have the processor is no longer then.
double vtkTimerLog::GetUniversalTime()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

namespace smtest
{
namespace
{
/// Seconds of an update.
class UpdateCost
{
public:
  void Stop() { this->Seconds = vtkTimerLog::GetUniversalTime() - this->Start; }
  /// The seconds that belong to no stage.
  double GetRest(double stages) const { return this->Seconds - stages; }

private:
  double Start = vtkTimerLog::GetUniversalTime();
  double Seconds = 0.0;
};

void Count(vtkPartitionedDataSetCollection* parts, sm::Json& result)
{
  long long faces = 0;
  long long triangles = 0;
  std::set<vtkTrimmedNURBSModel*> models;
  for (unsigned int i = 0; i < parts->GetNumberOfPartitionedDataSets(); ++i)
  {
    auto* leaf = vtkNURBSDataSet::SafeDownCast(parts->GetPartitionAsDataObject(i, 0));
    if (leaf && leaf->GetModel() && models.insert(leaf->GetModel()).second)
    {
      faces += leaf->GetModel()->GetNumberOfFaces();
      vtkPolyData* mesh = leaf->GetModel()->GetScaleMesh();
      triangles += mesh ? mesh->GetNumberOfPolys() : 0;
    }
  }
  result["faces"] = faces;
  result["triangles"] = triangles;
  result["instances"] = parts->GetNumberOfPartitionedDataSets();
}
}

const std::vector<std::string>& GetStageNames()
{
  static const std::vector<std::string> names = { "parse", "transfer", "trims", "mesh", "convert", "cut",
    "plan", "upload", "integrate", "analyse" };
  return names;
}

namespace
{
double GetIntegrateSeconds(vtkMassPropertiesGPU* mass)
{
  UpdateCost compute;
  mass->Update();
  compute.Stop();
  return mass->GetIntegrateSeconds();
}

void MeasureMass(vtkSTEPReader* reader, int repeats, sm::Json& seconds, sm::Json& result)
{
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetInputConnection(reader->GetOutputPort());
  mass->SetBackend(vtkMassPropertiesGPU::CPU);
  mass->CacheFaceResultsOff();
  UpdateCost compute;
  mass->Update();
  compute.Stop();
  const double cut = mass->GetCutSeconds();
  const double plan = mass->GetPlanSeconds();
  seconds["cut"] = cut;
  seconds["plan"] = plan;
  seconds["upload"] = mass->GetPrepareSeconds() - cut - plan;
  double integrate = mass->GetIntegrateSeconds();
  seconds["analyse"] = compute.GetRest(mass->GetPrepareSeconds() + mass->GetIntegrateSeconds());
  // Panels and plans are known, results are not.
  for (int i = 1; i < repeats; ++i)
  {
    mass->Modified();
    integrate = std::min(integrate, GetIntegrateSeconds(mass));
  }
  seconds["integrate"] = integrate;
  result["status"] = mass->GetStatus();
  result["volume"] = mass->GetVolume();
  result["volume_bound"] = mass->GetVolumeBound();
  double center[3];
  mass->GetCenterOfMass(center);
  result["center"] = { center[0], center[1], center[2] };
  result["center_bound"] = mass->GetCenterOfMassBound();
  result["evaluations"] = mass->GetEvaluations();
}
}

void MeasureStages(const std::string& path, int repeats, sm::Json& seconds, sm::Json& result)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path.c_str());
  // As in the program, where nothing is shown.
  reader->SetDisplayMeshToNever();
  UpdateCost read;
  reader->Update();
  read.Stop();
  const double mesh = reader->GetMeshSeconds();
  const double convert = reader->GetConversionSeconds();
  const double trims = reader->GetTrimSeconds();
  const double parse = reader->GetParseSeconds();
  seconds["parse"] = parse;
  // The reader's work outside its stages belongs to the transfer.
  seconds["transfer"] = read.GetRest(parse + trims + mesh + convert);
  seconds["trims"] = trims;
  seconds["mesh"] = mesh;
  seconds["convert"] = convert;
  Count(reader->GetOutput(), result);
  if (repeats > 0)
  {
    MeasureMass(reader, repeats, seconds, result);
  }
}
}
