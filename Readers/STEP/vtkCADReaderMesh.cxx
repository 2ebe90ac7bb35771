// The display mesh of a reader: when it is made, and the output with and without it.
#include "vtkCADReaderInternals.h"

#include "smFormat.h"
#include "smMeshDemand.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNURBSDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <cmath>

void vtkCADReader::Update(int port)
{
  this->IsMeshRequested = true;
  this->Superclass::Update(port);
}

vtkTypeBool vtkCADReader::Update(int port, vtkInformationVector* requests)
{
  this->IsMeshRequested = true;
  return this->Superclass::Update(port, requests);
}

void vtkCADReader::UpdateWholeExtent()
{
  this->IsMeshRequested = true;
  this->Superclass::UpdateWholeExtent();
}

bool vtkCADReader::IsMeshWanted() const
{
  return this->DisplayMesh == MESH_ALWAYS || (this->DisplayMesh == MESH_BY_NEED && this->IsMeshRequested);
}

int vtkCADReader::ComputePipelineMTime(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector, int port, vtkMTimeType* time)
{
  // A reader that is updated itself was asked by Update().
  if (!sm::TakeExactMark(port >= 0 ? outputVector->GetInformationObject(port) : nullptr) && port >= 0)
  {
    this->IsMeshRequested = true;
  }
  if (this->Status == OK && !this->HasMesh && !this->IsMeshDue && this->IsMeshWanted())
  {
    this->IsMeshDue = true;
    this->MeshTime.Modified();
  }
  *time = std::max(this->GetMTime(), this->MeshTime.GetMTime());
  return 1;
}

void vtkCADReader::ModifyMesh()
{
  const bool isCurrent = this->GetMTime() <= this->SettledTime;
  this->Modified();
  if (isCurrent)
  {
    this->SettledTime = this->GetMTime();
  }
}

void vtkCADReader::SetDisplayMesh(int when)
{
  const int value = std::clamp<int>(when, MESH_BY_NEED, MESH_NEVER);
  if (value != this->DisplayMesh)
  {
    this->DisplayMesh = value;
    this->ModifyMesh();
  }
}

void vtkCADReader::SetCoarseAbove(vtkIdType triangles)
{
  const vtkIdType value = std::max<vtkIdType>(triangles, 0);
  if (value != this->CoarseAbove)
  {
    this->CoarseAbove = value;
    this->ModifyMesh();
  }
}

void vtkCADReader::SetRefined(bool isRefined)
{
  if (isRefined != this->Refined)
  {
    this->Refined = isRefined;
    this->ModifyMesh();
  }
}

void vtkCADReader::SetRelativeDeflection(bool isRelative)
{
  if (isRelative != this->RelativeDeflection)
  {
    this->RelativeDeflection = isRelative;
    this->ModifyMesh();
  }
}

void vtkCADReader::SetLinearDeflection(double deflection)
{
  const double value = deflection > 0.0 ? std::min(std::max(deflection, 1e-30), 1e30) : 0.001;
  if (value != this->LinearDeflection)
  {
    this->LinearDeflection = value;
    this->ModifyMesh();
  }
}

void vtkCADReader::SetAngularDeflection(double angle)
{
  const double value = std::isnan(angle) ? 0.35 : std::min(std::max(angle, 0.01), 3.0);
  if (value != this->AngularDeflection)
  {
    this->AngularDeflection = value;
    this->ModifyMesh();
  }
}

bool vtkCADReader::FillOutput(vtkPartitionedDataSetCollection* output)
{
  const double start = vtkTimerLog::GetUniversalTime();
  const std::vector<sm::LeafSource>& sources = this->Kept->Sources;
  sm::LeafMesher mesher(sources,
    { this->LinearDeflection, this->RelativeDeflection, this->AngularDeflection,
      this->Refined ? 0 : this->CoarseAbove });
  output->SetNumberOfPartitionedDataSets(static_cast<unsigned int>(sources.size()));
  for (unsigned int i = 0; i < sources.size(); ++i)
  {
    const auto report = [&](double x)
    { return this->Report(Reading::MeshStart + (1.0 - Reading::MeshStart) * (i + x) / sources.size()); };
    const bool isStopped = !report(0.0);
    const vtkSmartPointer<vtkNURBSDataSet> leaf = isStopped ? nullptr
      : this->HasMesh                                       ? mesher.MakeLeaf(sources[i], report)
                                                            : sm::MakeBareLeaf(sources[i]);
    if (!leaf)
    {
      output->Initialize();
      this->Stop();
      return false;
    }
    leaf->SetPartName(this->Kept->Names[i]);
    leaf->SetPartPath(this->Kept->Paths[i]);
    output->SetPartition(i, 0, leaf);
    output->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), this->Kept->BlockNames[i].c_str());
  }
  output->SetDataAssembly(this->Kept->Assembly);
  this->MeshIsCoarse = this->HasMesh && mesher.IsCoarse();
  std::vector<std::string>& messages = this->Last->Messages;
  messages.insert(messages.end(), mesher.GetMessages().begin(), mesher.GetMessages().end());
  if (this->MeshIsCoarse)
  {
    messages.push_back("The display mesh is coarse: as fine as asked for it would have more than " +
      std::to_string(this->CoarseAbove) + " triangles; Refined makes that one.");
  }
  if (mesher.GetSmallestDeflection() > 0.0)
  {
    messages.push_back(
      "The display mesh is as fine as it can be, 1e-5 of the diagonal of each solid: up to " +
      sm::FormatDigits(mesher.GetSmallestDeflection(), 3) + " " + this->GetLengthUnit() +
      " from the surface, which is more than was asked for.");
  }
  this->Last->MeshSeconds += vtkTimerLog::GetUniversalTime() - start;
  this->Status = OK;
  this->UpdateProgress(1.0);
  return true;
}
