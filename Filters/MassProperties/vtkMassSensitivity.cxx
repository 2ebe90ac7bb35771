#include "vtkMassSensitivity.h"

#include "Detail/smMassSensitivity.h"
#include "smBodyMeshes.h"
#include "smColumns.h"
#include "smMassAnalysis.h"
#include "smMassPropertyNames.h"

#include "vtkDataSetAttributes.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <algorithm>
#include <functional>
#include <memory>

vtkStandardNewMacro(vtkMassSensitivity);

vtkMassSensitivity::vtkMassSensitivity() = default;
vtkMassSensitivity::~vtkMassSensitivity() = default;

void vtkMassSensitivity::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

sm::IntegralRequest vtkMassSensitivity::MakeRequest() const
{
  sm::IntegralRequest request = this->Superclass::MakeRequest();
  request.Integrands = sm::GetSensitivityIntegrands();
  request.GetTolerances = [share = request.GetTolerances](const sm::BodyIntegrals& body)
  { return sm::AddAreaTolerances(share(body), *body.Model); };
  return request;
}

void vtkMassSensitivity::AnalyzeBodies(std::vector<sm::BodyIntegrals>& bodies)
{
  const std::function<bool()> shouldContinue =
    sm::MakeContinue(this->MakeLimits(), this->GetEngine().GetReport());
  this->Superclass::AnalyzeBodies(bodies);
  this->Offsets = std::make_unique<sm::BodyOffsets>(bodies, shouldContinue);
}

void vtkMassSensitivity::ResetResults()
{
  this->Superclass::ResetResults();
  this->Offsets.reset();
}

const sm::BodyOffsets& vtkMassSensitivity::GetOffsets() const
{
  return *this->Offsets;
}

void vtkMassSensitivity::WriteOutputs(
  const std::vector<sm::BodyIntegrals>& bodies, const Outputs& outputs) const
{
  this->Superclass::WriteOutputs(bodies, outputs);
  std::size_t rows = 0;
  for (const sm::BodyIntegrals& body : bodies)
  {
    rows += body.Model->GetFaces().size();
  }
  sm::columns::Writer writer(outputs.Arrays, outputs.Faces->GetRowData(), rows);
  const auto add = [&writer](const char* name, int components)
  {
    double* values = writer.AddDoubles(name, components);
    return std::make_pair(values, writer.AddDoubles(std::string(name) + sm::names::BoundSuffix));
  };
  auto volume = add(sm::names::VolumePerOffset, 1);
  auto mass = add(sm::names::MassPerOffset, 1);
  auto area = add(sm::names::SurfaceAreaPerOffset, 1);
  auto center = add(sm::names::CenterOfMassPerOffset, 3);
  auto principal = add(sm::names::PrincipalMomentsPerOffset, 3);
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    for (std::size_t f = 0; f < bodies[b].Model->GetFaces().size(); ++f)
    {
      const sm::FaceSensitivity face =
        sm::ComputeSensitivity(bodies[b], this->GetAnalysis().Rows[b], this->GetOffsets().Get(b), f);
      *volume.first++ = face.Volume;
      *volume.second++ = face.VolumeBound;
      *mass.first++ = face.Mass;
      *mass.second++ = face.MassBound;
      *area.first++ = face.Area;
      *area.second++ = face.AreaBound;
      center.first = std::copy(face.Center.begin(), face.Center.end(), center.first);
      *center.second++ = face.CenterBound;
      principal.first = std::copy(face.Principal.begin(), face.Principal.end(), principal.first);
      *principal.second++ = face.PrincipalBound;
    }
  }
}

std::vector<sm::MeshArray> vtkMassSensitivity::GetMeshArrays(
  const std::vector<sm::BodyIntegrals>& bodies) const
{
  std::vector<sm::MeshArray> arrays = this->Superclass::GetMeshArrays(bodies);
  const auto compute = [this, &bodies](std::size_t body, std::size_t face)
  {
    return sm::ComputeSensitivity(
      bodies[body], this->GetAnalysis().Rows[body], this->GetOffsets().Get(body), face);
  };
  arrays.push_back({ sm::names::VolumePerOffset,
    [compute](std::size_t body, std::size_t face) { return compute(body, face).Volume; } });
  arrays.push_back({ sm::names::MassPerOffset,
    [compute](std::size_t body, std::size_t face) { return compute(body, face).Mass; } });
  arrays.push_back({ sm::names::SurfaceAreaPerOffset,
    [compute](std::size_t body, std::size_t face) { return compute(body, face).Area; } });
  for (int i = 0; i < 3; ++i)
  {
    const std::string axis = i == 0 ? "_X" : i == 1 ? "_Y" : "_Z";
    arrays.push_back({ sm::names::CenterOfMassPerOffset + axis,
      [compute, i](std::size_t body, std::size_t face) { return compute(body, face).Center[i]; } });
    arrays.push_back({ sm::names::PrincipalMomentsPerOffset + ("_" + std::to_string(i + 1)),
      [compute, i](std::size_t body, std::size_t face) { return compute(body, face).Principal[i]; } });
  }
  return arrays;
}
