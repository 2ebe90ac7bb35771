#include "smStageSeconds.h"

#include "smProcessorTime.h"

#include <vtkMassPropertiesGPU.h>
#include <vtkNURBSDataSet.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSTEPReader.h>
#include <vtkTimerLog.h>
#include <vtkTrimmedNURBSModel.h>

#include <algorithm>
#include <set>

namespace smtest
{
namespace
{
/// Processor time of an update. Its stages are known in seconds of a clock: they get their share of the processor's, and so does the rest.
class UpdateCost
{
public:
  void Stop()
  {
    this->Processor = this->Watch.GetSeconds();
    this->Clock = vtkTimerLog::GetUniversalTime() - this->Start;
  }
  double GetShare(double clock) const { return this->Processor * clock / this->Clock; }
  double GetRest(double clock) const { return this->GetShare(this->Clock - clock); }

private:
  ProcessorTime Watch;
  double Start = vtkTimerLog::GetUniversalTime();
  double Processor = 0.0;
  double Clock = 1.0;
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
      triangles += leaf->GetNumberOfPolys();
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
  return compute.GetShare(mass->GetIntegrateSeconds());
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
  seconds["cut"] = compute.GetShare(cut);
  seconds["plan"] = compute.GetShare(plan);
  seconds["upload"] = compute.GetShare(mass->GetPrepareSeconds() - cut - plan);
  double integrate = compute.GetShare(mass->GetIntegrateSeconds());
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
  UpdateCost read;
  reader->Update();
  read.Stop();
  const double mesh = reader->GetMeshSeconds();
  const double convert = reader->GetConversionSeconds();
  const double trims = reader->GetTrimSeconds();
  const double parse = reader->GetParseSeconds();
  seconds["parse"] = read.GetShare(parse);
  // The reader's work beside its stages belongs to the transfer.
  seconds["transfer"] = read.GetRest(parse + trims + mesh + convert);
  seconds["trims"] = read.GetShare(trims);
  seconds["mesh"] = read.GetShare(mesh);
  seconds["convert"] = read.GetShare(convert);
  Count(reader->GetOutput(), result);
  if (repeats > 0)
  {
    MeasureMass(reader, repeats, seconds, result);
  }
}
}
