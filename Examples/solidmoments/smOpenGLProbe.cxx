#include "smOpenGLProbe.h"

#include "smArguments.h"
#include "smProbe.h"

#include "vtkComputeContext.h"
#include "vtkNew.h"

#include <cmath>
#include <cstdio>
#include <iostream>

namespace sm
{
int PrintOpenGLProbe()
{
  vtkNew<vtkComputeContext> context;
  if (context->Start() != vtkComputeContext::READY)
  {
    return Complain(context->GetReason());
  }
  std::cout << "Renderer: " << context->GetRenderer() << "\nOpenGL: " << context->GetVersionString()
            << "\n\n| construct | used by shaders | largest relative error | |\n|---|---|---|---|\n";
  int status = AllOk;
  for (const ProbeResult& result : ProbeAllConstructs(context))
  {
    char error[32];
    std::snprintf(error, sizeof(error), "%.1e", result.Error);
    std::cout << "| " << result.Construct << " | " << (result.IsUsed ? "yes" : "no") << " | "
              << (std::isfinite(result.Error) ? error : "not built, or NaN") << " | "
              << (result.IsFlushed    ? "0, as GLSL allows"
                     : result.IsRight ? "right"
                                      : "wrong")
              << " |\n";
    status = result.IsUsed && !result.IsRight ? UsageOrOutput : status;
  }
  return status;
}
}
