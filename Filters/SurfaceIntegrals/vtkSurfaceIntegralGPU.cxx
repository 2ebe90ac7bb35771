#include "vtkSurfaceIntegralGPU.h"

#include "Engine/vtkSurfaceIntegralGPUInternals.h"
#include "smBodyMeshes.h"
#include "smBodyScales.h"
#include "smColumns.h"
#include "smFormat.h"
#include "smIntegralEngine.h"
#include "smUnitRoundoff.h"

#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <numeric>

vtkStandardNewMacro(vtkSurfaceIntegralGPU);

namespace
{
/// Largest number of integrands that are added to the meshes; more arrays would need more memory than the
/// meshes themselves.
constexpr std::size_t MaxNumberOfMeshArrays = 16;

/// Returns the scale of relative tolerances of an integrand.
double GetScale(const sm::Integrand& integrand, const sm::BodyIntegrals& body)
{
  vtkTrimmedNURBSModel& model = *body.Model;
  if (integrand.ScalePower != 0)
  {
    return sm::GetAreaScale(model) * std::pow(sm::GetRadius(model), integrand.ScalePower);
  }
  // Integral of a monomial over a body of volume V (or area A) whose farthest point is at this distance from
  // the origin.
  const double size = std::pow(sm::GetReach(body), std::max(integrand.Degree, 0));
  return size *
    (integrand.ClosedChain && integrand.Degree >= 0 ? sm::GetVolumeScale(model) : sm::GetAreaScale(model));
}

double GetFaceValue(
  const sm::BodyIntegrals& body, std::size_t face, const sm::Integrand& integrand, std::size_t index)
{
  const sm::FaceIntegrals* result = body.Faces ? &(*body.Faces)[face] : nullptr;
  const double side = integrand.ClosedChain ? (body.InsideOut ? -1.0 : 1.0) * body.GetSide(face) : 1.0;
  return result && result->Error.empty() ? side * (result->Face[index] + result->Closing[index])
                                         : vtkMath::Nan();
}

/// Returns the index of the volume if all integrands are moments, whose signs follow from the sides of
/// shells; otherwise -1.
int FindVolume(const std::vector<sm::Integrand>& integrands)
{
  int volume = -1;
  for (std::size_t k = 0; k < integrands.size(); ++k)
  {
    if (integrands[k].Form == sm::Integrand::Kind::User)
    {
      return -1;
    }
    const bool isVolume =
      integrands[k].Form == sm::Integrand::Kind::VolumeMoment && integrands[k].Degree == 0;
    volume = isVolume ? static_cast<int>(k) : volume;
  }
  return volume;
}

/// Reverses shells that are inside out, in the sums of fluxes, as vtkMassPropertiesGPU does.
void OrientBody(sm::BodyIntegrals& body, const std::vector<sm::Integrand>& integrands, int volume)
{
  sm::ReverseShells(body, integrands, volume);
  for (std::size_t k = 0; k < integrands.size() && body.InsideOut; ++k)
  {
    body.Value[k] = integrands[k].ClosedChain ? -body.Value[k] : body.Value[k];
  }
}
}

vtkSurfaceIntegralGPU::vtkSurfaceIntegralGPU()
  : Implementation(new Internals)
{
}

vtkSurfaceIntegralGPU::~vtkSurfaceIntegralGPU() = default;

void vtkSurfaceIntegralGPU::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RelativeTolerance: " << this->RelativeTolerance << "\n"
     << indent << "CacheFaceResults: " << this->CacheFaceResults << "\n"
     << indent << "Integrands: " << this->GetNumberOfIntegrands() << "\n"
     << indent << "Constants: " << this->Implementation->Constants.size() << "\n"
     << indent << "FaceIds: " << this->Implementation->FaceIds.size() << "\n";
}

double vtkSurfaceIntegralGPU::GetIntegral(const std::string& name) const
{
  const auto found = this->Implementation->Totals.find(name);
  return found == this->Implementation->Totals.end() ? vtkMath::Nan() : found->second.first;
}

double vtkSurfaceIntegralGPU::GetIntegralBound(const std::string& name) const
{
  const auto found = this->Implementation->Totals.find(name);
  return found == this->Implementation->Totals.end() ? vtkMath::Nan() : found->second.second;
}

void vtkSurfaceIntegralGPU::ResetResults()
{
  this->Superclass::ResetResults();
  this->Implementation->Totals.clear();
}

sm::IntegralRequest vtkSurfaceIntegralGPU::MakeRequest() const
{
  sm::IntegralRequest request;
  request.Integrands = this->Implementation->GetIntegrands();
  request.FaceIds = this->Implementation->FaceIds;
  request.GetTolerances = [integrands = request.Integrands, tolerance = this->RelativeTolerance](
                            const sm::BodyIntegrals& body)
  {
    std::vector<double> tolerances;
    for (const sm::Integrand& integrand : integrands)
    {
      tolerances.push_back(tolerance * GetScale(integrand, body));
    }
    return tolerances;
  };
  return request;
}

void vtkSurfaceIntegralGPU::AnalyzeBodies(std::vector<sm::BodyIntegrals>& bodies)
{
  this->Implementation->Integrated = this->Implementation->GetIntegrands();
  const std::vector<sm::Integrand>& integrands = this->Implementation->Integrated;
  const bool hasTotal = !bodies.empty() && sm::HaveOneUnit(bodies);
  if (!bodies.empty() && !hasTotal)
  {
    this->GetEngine().GetReport().Messages.push_back(sm::MixedUnitsMessage);
  }
  const int volume = this->Implementation->FaceIds.empty() ? FindVolume(integrands) : -1;
  for (sm::BodyIntegrals& body : bodies)
  {
    // The sign of an open body's volume depends on the origin.
    if (volume >= 0 && body.Faces && body.OpenEdges == 0)
    {
      OrientBody(body, integrands, volume);
    }
  }
  for (std::size_t k = 0; k < integrands.size(); ++k)
  {
    const std::string& name = integrands[k].Name;
    double total = hasTotal ? 0.0 : vtkMath::Nan();
    double bound = total;
    for (sm::BodyIntegrals& body : bodies)
    {
      if (body.Faces && !this->GetEngine().GetObstacle(k).empty())
      {
        body.Flag(sm::Status::NotComputed, name + " was not computed");
      }
      else if (body.Faces && !std::isfinite(body.Value[k]))
      {
        body.Value[k] = body.Bound[k] = vtkMath::Nan();
        body.Flag(sm::Status::Suspect,
          name +
            " is undefined or infinite somewhere on the faces, or dA, or normal, is not a factor of it just "
            "once");
      }
      else if (body.Faces && !(body.Bound[k] <= this->RelativeTolerance * GetScale(integrands[k], body)))
      {
        body.Flag(sm::Status::ToleranceNotMet, "the bound of " + name + " is above the tolerance");
      }
      total += body.Value[k];
      bound += body.Bound[k] + (bodies.size() > 1 ? 2.0 * sm::UnitRoundoff * std::abs(total) : 0.0);
    }
    this->Implementation->Totals[name] = { total, bound };
  }
}

void vtkSurfaceIntegralGPU::WriteOutputs(
  const std::vector<sm::BodyIntegrals>& bodies, const Outputs& outputs) const
{
  const std::vector<sm::Integrand>& integrands = this->Implementation->Integrated;
  std::string summary = this->FormatStatus(bodies);
  sm::columns::Writer solids(outputs.Arrays, outputs.Solids->GetRowData(), bodies.size());
  sm::columns::Writer totals(outputs.Arrays, outputs.Totals->GetFieldData());
  for (std::size_t k = 0; k < integrands.size(); ++k)
  {
    const std::string& name = integrands[k].Name;
    const auto& [total, bound] = this->Implementation->Totals.at(name);
    double* values = solids.AddDoubles(name);
    double* bounds = solids.AddDoubles(name + sm::names::BoundSuffix);
    for (const sm::BodyIntegrals& body : bodies)
    {
      *values++ = body.Value[k];
      *bounds++ = body.Bound[k];
    }
    totals.SetDouble(name, total);
    totals.SetDouble(name + sm::names::BoundSuffix, bound);
    summary += name + " = " + sm::FormatWithBound(total, bound, "", sm::SumClosing(bodies, k)) + "\n";
  }
  sm::columns::Writer(outputs.Arrays, outputs.Text->GetRowData()).SetString(sm::names::Text, summary);
  std::vector<int> all(integrands.size());
  std::iota(all.begin(), all.end(), 0);
  sm::columns::AddFaceRows(outputs.Arrays, bodies, integrands, outputs.Faces, all);
}

std::vector<sm::MeshArray> vtkSurfaceIntegralGPU::GetMeshArrays(
  const std::vector<sm::BodyIntegrals>& bodies) const
{
  const std::vector<sm::Integrand>& integrands = this->Implementation->Integrated;
  std::vector<sm::MeshArray> arrays;
  for (std::size_t k = 0; k < integrands.size() && integrands.size() <= MaxNumberOfMeshArrays; ++k)
  {
    arrays.push_back({ integrands[k].Name, [&bodies, &integrands, k](std::size_t body, std::size_t face) {
                        return GetFaceValue(bodies[body], face, integrands[k], k);
                      } });
  }
  return arrays;
}
