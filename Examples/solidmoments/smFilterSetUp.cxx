#include "smFilterSetUp.h"

#include "smCountedBodies.h"
#include "smFileJob.h"
#include "smMassPropertyNames.h"
#include "smMessageList.h"
#include "smResults.h"

#include "vtkComputeContext.h"
#include "vtkMassPropertiesBase.h"

namespace sm
{
void SetUpFilter(vtkSurfaceIntegralBase* filter, const JobOptions& options)
{
  filter->SetMaximumEvaluations(static_cast<vtkTypeInt64>(options.MaximumEvaluations));
  SetTimeLimit(filter, options);
  for (const std::string& selector : options.Selectors)
  {
    filter->AddSelector(selector);
  }
  if (LeavesOutBodies(options.Materials))
  {
    filter->SetLeftOut([rules = options.Materials](vtkDataObject* input, std::vector<BodyIntegrals>& bodies)
      { return LeaveOutBodies(rules, input, false, bodies); });
  }
  filter->SetGapLimit(options.GapLimit);
  filter->SetBackend(options.Backend == "auto" ? vtkSurfaceIntegralBase::AUTOMATIC
      : options.Backend == "cpu"               ? vtkSurfaceIntegralBase::CPU
                                               : vtkSurfaceIntegralBase::OPENGL);
  filter->GetComputeContext()->SetSource(options.Backend == "egl" ? vtkComputeContext::EGL
      : options.Backend == "x"                                    ? vtkComputeContext::X
                                                                  : vtkComputeContext::AUTOMATIC);
}

void SetUpMass(vtkMassPropertiesBase* filter, const JobOptions& options)
{
  filter->SetDensity(options.Density);
  filter->SetDensityTolerance(options.DensityTolerance);
  for (const MaterialRule& rule : options.Materials)
  {
    const Material& material = rule.Material;
    if (rule.IsLeftOut)
    {
      filter->AddLeftOut(rule.Pattern.c_str());
    }
    else if (rule.Counting != Counting::Every)
    {
      filter->AddCountedOnce(rule.Pattern.c_str(), rule.Counting == Counting::OnceInPlace);
    }
    else if (rule.IsOfProduct)
    {
      filter->AddProductMass(rule.Pattern.c_str(), material.Name.c_str(), material.Mass, material.Tolerance);
    }
    else if (material.Mass > 0.0)
    {
      filter->AddMass(rule.Pattern.c_str(), material.Name.c_str(), material.Mass, material.Tolerance);
    }
    else
    {
      filter->AddMaterial(rule.Pattern.c_str(), material.Name.c_str(), material.Density, material.Tolerance);
    }
  }
}

void SetTimeLimit(vtkSurfaceIntegralBase* filter, const JobOptions& options)
{
  if (options.MaximumSeconds > 0.0)
  {
    filter->SetMaximumSeconds(options.GetSecondsLeft());
  }
}

vtkOpenGLRenderWindow* StartWindow(vtkSurfaceIntegralBase* filter, std::string& problem)
{
  vtkComputeContext* context = filter->GetComputeContext();
  context->Start();
  vtkOpenGLRenderWindow* window = context->GetRenderWindow();
  problem = window ? std::string() : "there is no OpenGL context to draw in: " + context->GetReason();
  return window;
}

void AddStatus(const std::string& status, FileResult& file)
{
  const bool isWorse = file.Status == names::StatusToleranceNotMet && status == names::StatusSuspect;
  file.Status = file.Status == names::StatusOk || isWorse ? status : file.Status;
}

void AddEffort(vtkSurfaceIntegralBase* filter, FileResult& file, MessageList& messages)
{
  AddStatus(filter->GetStatus(), file);
  file.Evaluations += filter->GetEvaluations();
  file.Dispatches += filter->GetDispatches();
  messages.AddFilter(filter);
}
}
