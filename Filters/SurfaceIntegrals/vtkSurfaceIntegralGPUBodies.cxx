// Which bodies vtkSurfaceIntegralGPU integrates over, and the arrays that their meshes get.
#include "vtkSurfaceIntegralGPU.h"

#include "smBodyMeshes.h"
#include "smBodySelection.h"
#include "vtkSurfaceIntegralGPUInternals.h"

#include "vtkMath.h"

#include <algorithm>

namespace
{
/// More would take more memory than the meshes.
constexpr std::size_t LargestNumberOfMeshArrays = 16;

double GetFaceValue(const sm::BodyIntegrals& body, std::size_t face, std::size_t integrand)
{
  const sm::FaceIntegrals* result = body.Faces ? &(*body.Faces)[face] : nullptr;
  return result && result->Error.empty() ? result->Face[integrand] + result->Closing[integrand]
                                         : vtkMath::Nan();
}
}

void vtkSurfaceIntegralGPU::Internals::ChooseBodies(
  vtkDataObject* input, std::vector<sm::BodyIntegrals>& bodies)
{
  if (this->Selectors.empty())
  {
    return;
  }
  std::set<vtkDataObject*> chosen;
  std::vector<std::string> unmatched;
  const std::string problem = sm::SelectLeaves(input, this->AssemblyName, this->Selectors, chosen, unmatched);
  if (!problem.empty())
  {
    this->Last.Messages.push_back(problem);
  }
  for (const std::string& selector : unmatched)
  {
    this->Last.Messages.push_back("the selector \"" + selector + "\" names no solid");
  }
  bodies.erase(std::remove_if(bodies.begin(), bodies.end(),
                 [&chosen](const sm::BodyIntegrals& body) { return chosen.count(body.Mesh) == 0; }),
    bodies.end());
}

std::vector<sm::MeshArray> vtkSurfaceIntegralGPU::GetMeshArrays(const std::vector<sm::BodyIntegrals>& bodies)
{
  const std::vector<sm::Integrand>& integrands = this->Implementation->Integrands;
  std::vector<sm::MeshArray> arrays;
  for (std::size_t k = 0; k < integrands.size() && integrands.size() <= LargestNumberOfMeshArrays; ++k)
  {
    arrays.push_back({ integrands[k].Name,
      [&bodies, k](std::size_t body, std::size_t face) { return GetFaceValue(bodies[body], face, k); } });
  }
  return arrays;
}

void vtkSurfaceIntegralGPU::AddSelector(const std::string& selector)
{
  std::vector<std::string>& selectors = this->Implementation->Selectors;
  if (!selector.empty() && std::find(selectors.begin(), selectors.end(), selector) == selectors.end())
  {
    selectors.push_back(selector);
    this->Modified();
  }
}

void vtkSurfaceIntegralGPU::ClearSelectors()
{
  if (!this->Implementation->Selectors.empty())
  {
    this->Implementation->Selectors.clear();
    this->Modified();
  }
}

int vtkSurfaceIntegralGPU::GetNumberOfSelectors() const
{
  return static_cast<int>(this->Implementation->Selectors.size());
}

void vtkSurfaceIntegralGPU::SetAssemblyName(const std::string& name)
{
  if (this->Implementation->AssemblyName != name)
  {
    this->Implementation->AssemblyName = name;
    this->Modified();
  }
}

std::string vtkSurfaceIntegralGPU::GetAssemblyName() const
{
  return this->Implementation->AssemblyName;
}
