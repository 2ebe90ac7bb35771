#include "vtkMassPropertiesGPU.h"

#include "Detail/smMassTolerance.h"
#include "smFormat.h"
#include "smIntegralEngine.h"
#include "smMassAnalysis.h"

#include "vtkObjectFactory.h"

#include <cmath>

vtkStandardNewMacro(vtkMassPropertiesGPU);

vtkMassPropertiesGPU::vtkMassPropertiesGPU() = default;
vtkMassPropertiesGPU::~vtkMassPropertiesGPU() = default;

void vtkMassPropertiesGPU::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&os, indent](const char* name, const double tolerance[2])
  { os << indent << name << ": " << tolerance[0] << " " << tolerance[1] << "\n"; };
  print("VolumeTolerance", this->VolumeTolerance);
  print("SurfaceAreaTolerance", this->SurfaceAreaTolerance);
  print("CenterOfMassTolerance", this->CenterOfMassTolerance);
  print("InertiaTolerance", this->InertiaTolerance);
  os << indent << "RelativeTolerance: " << this->RelativeTolerance << "\n"
     << indent << "CacheFaceResults: " << this->CacheFaceResults << "\n";
}

sm::MassTolerance vtkMassPropertiesGPU::GetTolerance() const
{
  const auto make = [this](const double asked[2]) {
    return sm::Tolerance{ asked[0] > 0.0 ? asked[0] : this->RelativeTolerance, asked[1] };
  };
  return { make(this->VolumeTolerance), make(this->SurfaceAreaTolerance), make(this->CenterOfMassTolerance),
    make(this->InertiaTolerance) };
}

void vtkMassPropertiesGPU::SetTolerance(
  const char* name, double (&tolerance)[2], double relative, double absolute)
{
  if (!(relative >= 0.0 && relative <= 1.0) || !(absolute >= 0.0) || !std::isfinite(absolute))
  {
    vtkErrorMacro("The tolerance "
      << sm::FormatDigits(relative, 6) << ", " << sm::FormatDigits(absolute, 6) << " of the " << name
      << " is not used: give a relative one from 0 to 1, 0 for Relative Tolerance, and an absolute one "
         "that is not negative, 0 for none.");
    return;
  }
  if (tolerance[0] != relative || tolerance[1] != absolute)
  {
    tolerance[0] = relative;
    tolerance[1] = absolute;
    this->Modified();
  }
}

void vtkMassPropertiesGPU::SetVolumeTolerance(double relative, double absolute)
{
  this->SetTolerance("volume", this->VolumeTolerance, relative, absolute);
}

void vtkMassPropertiesGPU::SetSurfaceAreaTolerance(double relative, double absolute)
{
  this->SetTolerance("area", this->SurfaceAreaTolerance, relative, absolute);
}

void vtkMassPropertiesGPU::SetCenterOfMassTolerance(double relative, double absolute)
{
  this->SetTolerance("centre of mass", this->CenterOfMassTolerance, relative, absolute);
}

void vtkMassPropertiesGPU::SetInertiaTolerance(double relative, double absolute)
{
  this->SetTolerance("inertia", this->InertiaTolerance, relative, absolute);
}

sm::IntegralRequest vtkMassPropertiesGPU::MakeRequest() const
{
  return sm::MakeMassRequest(this->GetTolerance());
}

sm::MassAnalysisOptions vtkMassPropertiesGPU::MakeAnalysisOptions() const
{
  sm::MassAnalysisOptions options;
  options.Tolerance = this->GetTolerance();
  return options;
}
