// TestShaderFault FOLDER: shaders that keep arrays of doubles as floats, as some drivers do, and what sees
// it: the probe when a context starts, the comparison with the CPU when a program is used first, and the
// values. And a driver that takes subnormal numbers for 0.
#include "smContextResources.h"
#include "smMassPropertyNames.h"
#include "smRoundFaces.h"
#include "smShaderFault.h"
#include "smTestManifest.h"
#include "smTestPipeline.h"
#include "smWindowResources.h"
#include "smWrongSamples.h"

#include <vtkComputeContext.h>
#include <vtkNew.h>

#include <cmath>
#include <limits>

namespace
{
using namespace smtest;
namespace names = sm::names;

/// Shaders on for the life of the object.
struct Fault
{
  explicit Fault(const std::set<std::string>& shaders) { sm::GetFaultyShaders() = shaders; }
  ~Fault() { sm::GetFaultyShaders().clear(); }
};
const std::set<std::string> Probe = { "smProbeCS" };
const std::set<std::string> Integration = { "smPanelCS", "smRibbonCS" };

vtkFieldData* Run(Pipeline& pipeline)
{
  pipeline.Mass->Update();
  return pipeline.Mass->GetOutput()->GetFieldData();
}

/// A pipeline that takes OpenGL where there is one, and the CPU elsewhere.
void ChooseFreely(Pipeline& pipeline)
{
  pipeline.Mass->SetBackend(vtkMassPropertiesGPU::AUTOMATIC);
  pipeline.Mass->GetComputeContext()->SetSource(vtkComputeContext::EGL);
}

void CheckVolume(const std::string& what, vtkFieldData* fields, const Expected& expected)
{
  Check(what, expected.Volume, GetField(fields, names::Volume), GetFieldBound(fields, names::Volume),
    "the bound");
}

void CheckProbe(const Expected& expected)
{
  const Fault fault(Probe);
  Pipeline pipeline(expected.Path);
  ChooseFreely(pipeline);
  vtkFieldData* fields = Run(pipeline);
  CheckEqual("the probe fails: the CPU takes over", names::BackendCPU, GetFieldText(fields, names::Backend));
  const std::string reason = pipeline.Mass->GetComputeContext()->GetReason();
  CheckTrue(
    "it names the construct", reason.find("an array of doubles as uints wrong") != std::string::npos, reason);
  CheckVolume("its volume", fields, expected);
}

void CheckComparison(const Expected& expected)
{
  const Fault fault(Integration);
  Pipeline pipeline(expected.Path);
  ChooseFreely(pipeline);
  vtkFieldData* fields = Run(pipeline);
  CheckEqual(
    "the comparison fails: the CPU takes over", names::BackendCPU, GetFieldText(fields, names::Backend));
  const std::string reason = GetFieldText(fields, names::BackendReason);
  CheckTrue("it names the item", reason.find("computes a panel wrong: ") != std::string::npos, reason);
  CheckVolume("its volume", fields, expected);
  CheckEqual("status", "ok", GetFieldText(fields, names::Status));
  pipeline.Mass->Modified();
  CheckEqual(
    "the next run has not forgotten", names::BackendCPU, GetFieldText(Run(pipeline), names::Backend));

  Pipeline forced(expected.Path);
  forced.Mass->GetComputeContext()->SetSource(vtkComputeContext::EGL);
  fields = Run(forced);
  CheckTrue("nothing is computed where OpenGL was asked for", std::isnan(GetField(fields, names::Volume)));
  CheckEqual("its status", "not-computed", GetFieldText(fields, names::Status));
  forced.Mass->Modified();
  CheckEqual("nor in the next run", "not-computed", GetFieldText(Run(forced), names::Status));
}

void CheckValues(const Expected& expected)
{
  Pipeline pipeline(expected.Path);
  pipeline.Mass->GetComputeContext()->SetSource(vtkComputeContext::EGL);
  vtkFieldData* fields = Run(pipeline);
  CheckEqual("OpenGL", names::BackendOpenGL, GetFieldText(fields, names::Backend));
  CheckVolume("its volume", fields, expected);
  // The programs are proved now, and built again for another factor of every sample.
  const Fault fault(Integration);
  const WrongSamples wrong(pipeline.Mass, 1.0 + std::numeric_limits<double>::epsilon());
  fields = Run(pipeline);
  const double error = std::abs(GetField(fields, names::Volume) - expected.Volume);
  CheckTrue("a test of values sees it", error > 100.0 * GetFieldBound(fields, names::Volume),
    std::to_string(error / expected.Volume));
}

/// A ball whose weights are multiplied by a factor, which changes nothing in the surface.
vtkSmartPointer<vtkNURBSDataSet> MakeWeightedBall(double factor)
{
  auto face = std::make_shared<sm::Face>(*MakeBall({ 0.0, 0.0, 0.0 }, 2.0));
  face->Id = sm::NewId();
  for (std::array<double, 4>& point : face->Surface.ControlPoints)
  {
    for (double& number : point)
    {
      number *= factor;
    }
  }
  return MakeRoundBody({ face });
}

/// A driver that takes subnormal numbers for 0 is used, except for weights that come near to these.
void CheckSubnormals()
{
  const double volume = 32.0 / 3.0 * std::acos(-1.0);
  for (const double factor : { 1.0, 1e-90, 1e-110 })
  {
    for (const int backend : { vtkMassPropertiesGPU::OPENGL, vtkMassPropertiesGPU::AUTOMATIC })
    {
      vtkNew<vtkMassPropertiesGPU> mass;
      mass->SetInputDataObject(MakeWeightedBall(factor));
      mass->SetBackend(backend);
      vtkComputeContext* context = mass->GetComputeContext();
      context->SetSource(vtkComputeContext::EGL);
      CheckEqual("a context", int{ vtkComputeContext::READY }, context->Start());
      context->GetResources()->Window->FlushesSubnormals = true;
      mass->Update();
      vtkFieldData* fields = mass->GetOutput()->GetFieldData();
      const std::string what = "weights by " + std::to_string(std::lround(std::log10(factor)));
      const std::string reason = GetFieldText(fields, names::BackendReason);
      const bool isRefused = factor < 1e-100;
      if (isRefused && backend == vtkMassPropertiesGPU::OPENGL)
      {
        CheckEqual(what + ": nothing is computed", "not-computed", GetFieldText(fields, names::Status));
        continue;
      }
      CheckEqual(what + ": backend", isRefused ? names::BackendCPU : names::BackendOpenGL,
        GetFieldText(fields, names::Backend));
      CheckTrue(what + ": the reason",
        (reason.find("takes numbers below 2.3e-308 for 0") != std::string::npos) == isRefused, reason);
      Check(what + ": volume", volume, GetField(fields, names::Volume),
        GetFieldBound(fields, names::Volume) + 1e-15 * volume, "the bound, and the net's rounding");
    }
  }
}
}

int TestShaderFault(int argc, char* argv[])
{
  if (argc < 2)
  {
    return 1;
  }
  const Manifest manifest(argv[1]);
  for (const char* solid : { "sphere", "spline_ring" })
  {
    const Expected expected = manifest.GetSolid(solid).front();
    CheckProbe(expected);
    CheckComparison(expected);
    CheckValues(expected);
  }
  CheckSubnormals();
  return Finish();
}
