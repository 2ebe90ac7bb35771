#include "smProbe.h"

#include "smComputeBuffer.h"
#include "smComputeProgram.h"
#include "smContextResources.h"
#include "smContextScope.h"
#include "smProbeCS.h"
#include "smShaderSource.h"
#include "vtkComputeContext.h"

#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace sm
{
bool ProbeDoubles(vtkComputeContext* context, std::string& complaint)
{
  const std::uint64_t dispatches = context->GetResources()->Dispatches;
  const double a = 1.0;
  const double b = 3.0;
  double values[3] = { 0.0, 0.0, 0.0 };
  {
    const ContextScope scope(context);
    ShaderSource source("smProbeCS", smProbeCS);
    ComputeProgram program;
    ComputeBuffer output(context);
    if (!scope || !source.Assemble() || !program.Build(context, "smProbeCS", source.GetSource()) ||
      !output.Allocate(sizeof(values)) || !output.Bind(0) || !program.SetUniform("smA", a) ||
      !program.SetUniform("smB", b) || !program.Dispatch(1, 1) || !output.Read(values, sizeof(values)))
    {
      complaint = "cannot run a compute shader with doubles: " + source.GetError() + program.GetError() +
        output.GetError();
      return false;
    }
  }
  context->GetResources()->Dispatches = dispatches;
  // Mesa's hardware drivers make quotients and roots by iteration, some units in the last place off; single
  // precision would be off by 1e-8. Sums must be exactly rounded, or no error-free transformation works.
  const double allowed = 8.0 * std::numeric_limits<double>::epsilon();
  const double sum = values[0] + b;
  const double error = (values[0] - (sum - (sum - values[0]))) + (b - (sum - values[0]));
  // The condition is written so that a NaN fails.
  if (!(std::fabs(values[0] - a / b) <= allowed && std::fabs(values[1] - std::sqrt(b)) <= allowed &&
        values[2] == error))
  {
    std::ostringstream text;
    text << std::setprecision(17) << "computes wrong doubles: 1/3 = " << values[0]
         << ", sqrt(3) = " << values[1] << ", rounding error of 1/3 + 3 = " << values[2] << " instead of "
         << error;
    complaint = text.str();
    return false;
  }
  return true;
}
}
