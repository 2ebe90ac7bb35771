#include "smBackendComparison.h"
#include "smContextResources.h"

#include "vtkComputeContext.h"

#include <algorithm>
#include <cstdio>

namespace smtest
{
namespace names = sm::names;

namespace
{
/// `scale` times `relative` limits the difference too, where relative is not 0.
void CheckArrays(const std::string& what, vtkMassPropertiesGPU* gpu, vtkMassPropertiesGPU* cpu, double scale,
  double relative)
{
  const std::vector<double> expected = GetArray(gpu, what);
  const std::vector<double> actual = GetArray(cpu, what);
  CheckTrue(what + " is there", !expected.empty() && expected.size() == actual.size());
  double worst = 0.0;
  bool isNumber = true;
  for (std::size_t i = 0; i < std::min(expected.size(), actual.size()); ++i)
  {
    isNumber = isNumber && std::isnan(expected[i]) == std::isnan(actual[i]);
    worst = std::isnan(expected[i]) ? worst : std::max(worst, std::fabs(actual[i] - expected[i]));
  }
  CheckTrue(what + " is a number on both or on none", isNumber);
  const std::vector<double> bounds[2] = { GetArray(gpu, what + names::BoundSuffix),
    GetArray(cpu, what + names::BoundSuffix) };
  if (!bounds[0].empty() && bounds[0].size() == bounds[1].size() && !std::isnan(bounds[0][0]))
  {
    Check(what + " within the bounds of both", 0.0, worst, bounds[0][0] + bounds[1][0]);
  }
  if (relative > 0.0)
  {
    Check(what + " relative", 0.0, worst / scale, relative);
  }
}
}

void CompareBackends(vtkSTEPReader* reader, double relative, bool asDevice)
{
  std::printf("--- %s\n", reader->GetFileName());
  // One pair of filters for all files: their context and shaders are made once.
  static vtkNew<vtkMassPropertiesGPU> gpu;
  static vtkNew<vtkMassPropertiesGPU> cpu;
  const MessageTrap trap(gpu);
  const MessageTrap cpuTrap(cpu);
  gpu->SetInputConnection(reader->GetOutputPort());
  cpu->SetInputConnection(reader->GetOutputPort());
  gpu->SetBackend(vtkMassPropertiesGPU::OPENGL);
  cpu->SetBackend(vtkMassPropertiesGPU::CPU);
  if (asDevice && gpu->GetComputeContext()->Start() == vtkComputeContext::READY)
  {
    gpu->GetComputeContext()->GetResources()->IsSoftware = false;
  }
  gpu->Update();
  cpu->Update();
  CheckEqual("backend", names::BackendOpenGL, gpu->GetBackendName());
  CheckEqual("backend", names::BackendCPU, cpu->GetBackendName());
  CheckEqual("status", gpu->GetStatus(), cpu->GetStatus());
  // Equal orders but where a decision is a matter of rounding.
  CheckRange("evaluations, of OpenGL's", 0.99,
    static_cast<double>(cpu->GetEvaluations()) / static_cast<double>(gpu->GetEvaluations()), 1.01);
  const double volume = std::fabs(gpu->GetVolume());
  double inertia[9];
  gpu->GetVolumeInertia(inertia);
  const double length = std::cbrt(volume);
  CheckArrays(names::Volume, gpu, cpu, volume, relative);
  CheckArrays(names::SurfaceArea, gpu, cpu, gpu->GetSurfaceArea(), relative);
  CheckArrays(names::CenterOfMass, gpu, cpu, length, relative);
  CheckArrays(names::VolumeInertia, gpu, cpu, inertia[0] + inertia[4] + inertia[8], relative);
  // Without bounds: gaps are rounded like positions.
  const double reach = length + std::sqrt(gpu->GetSurfaceArea());
  CheckArrays(names::MaxGap, gpu, cpu, reach, relative > 0.0 ? 1e-12 : 0.0);
  CheckArrays(names::GapArea, gpu, cpu, reach * reach, relative > 0.0 ? 1e-12 : 0.0);
}
}
