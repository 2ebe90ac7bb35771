// Gradients by compute shaders against the processor's, entry by entry, for faces of all degrees; and what
// happens without a context, with a wrong shader, and where OpenGL does not pay.
#include "smBoxBodies.h"
#include "smContextResources.h"
#include "smGradientSums.h"
#include "smRoundFaces.h"
#include "smShaderFault.h"
#include "smSubnormals.h"
#include "smTestPipeline.h"
#include "smWindowResources.h"

#include <cstring>

namespace
{
using namespace smtest;

sm::MomentGradientResult Compute(
  vtkDataObject* model, sm::BackendChoice backend, vtkComputeContext* context, double tolerance = 1e-9)
{
  sm::MomentGradientOptions options;
  options.Backend = backend;
  options.Context = context;
  options.RelativeTolerance = tolerance;
  return sm::ComputeMomentGradient(model, options);
}

bool AreSame(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

/// All entries differ by no more than both bounds, bounds by little, and NaN is at the same places.
void CheckModel(const std::string& what, vtkDataObject* model, vtkComputeContext* context)
{
  const sm::MomentGradientResult known = Compute(model, sm::BackendChoice::CPU, nullptr);
  context->ResetCounters();
  const sm::MomentGradientResult own = Compute(model, sm::BackendChoice::OpenGL, context);
  const sm::MomentGradientResult again = Compute(model, sm::BackendChoice::OpenGL, context);
  CheckTrue(what + ": by OpenGL",
    own.Backend == sm::BackendChoice::OpenGL && context->GetNumberOfDispatches() > 0, own.BackendReason);
  CheckTrue(what + ": the CPU without a reason",
    known.Backend == sm::BackendChoice::CPU && known.BackendReason.empty());
  if (!CheckEqual(what + ": faces", known.Faces.size(), own.Faces.size()))
  {
    return;
  }
  CheckEqual(what + ": evaluations", known.Evaluations, own.Evaluations);
  long long outside = 0;
  long long unlike = 0;
  long long other = 0;
  long long entries = 0;
  double worst = 0.0;
  double wider = 1.0;
  for (std::size_t f = 0; f < known.Faces.size(); ++f)
  {
    const sm::FaceMomentGradient& a = own.Faces[f];
    const sm::FaceMomentGradient& b = known.Faces[f];
    other += AreSame(a.Values, again.Faces[f].Values) && AreSame(a.Bounds, again.Faces[f].Bounds) ? 0 : 1;
    for (std::size_t k = 0; k < b.Values.size(); ++k)
    {
      unlike += std::isnan(a.Values[k]) == std::isnan(b.Values[k]) &&
          std::isnan(a.Bounds[k]) == std::isnan(b.Bounds[k])
        ? 0
        : 1;
      const double bound = a.Bounds[k] + b.Bounds[k];
      if (std::isfinite(bound))
      {
        ++entries;
        const double apart = std::abs(a.Values[k] - b.Values[k]);
        outside += apart <= bound ? 0 : 1;
        worst = std::max(worst, apart == 0.0 ? 0.0 : apart / bound);
        wider = b.Bounds[k] > 0.0 ? std::max(wider, a.Bounds[k] / b.Bounds[k]) : wider;
      }
    }
  }
  std::printf(
    "     %s: %lld entries, apart by up to %.1e of both bounds, bounds up to %.12f times the CPU's\n",
    what.c_str(), entries, worst, wider);
  CheckEqual(what + ": outside both bounds", 0LL, outside);
  CheckEqual(what + ": NaN elsewhere", 0LL, unlike);
  CheckEqual(what + ": faces with other bits in a second run", 0LL, other);
  // A bound of rounding has positive terms, which are evaluated by a few operations each.
  CheckRange(what + ": its bounds", 1.0, wider, 1.0 + 1e-9, "roundings of the bound");
}

void CheckFallbacks()
{
  const auto torus = MakeRoundBody({ MakeTorus({ 0.0, 1.0, 2.0 }, 3.0, 1.0) });
  const sm::MomentGradientResult known = Compute(torus, sm::BackendChoice::CPU, nullptr);
  const auto check =
    [&](const std::string& what, const sm::MomentGradientResult& result, const std::string& reason)
  {
    CheckTrue(what + ": the CPU computes",
      result.Backend == sm::BackendChoice::CPU && result.Status == "ok" &&
        AreSame(result.Faces[0].Values, known.Faces[0].Values));
    CheckTrue(
      what + ": the reason", result.BackendReason.find(reason) != std::string::npos, result.BackendReason);
  };
  vtkNew<vtkComputeContext> none;
  none->SetSource(vtkComputeContext::WINDOW);
  check("no context", Compute(torus, sm::BackendChoice::OpenGL, none), "no OpenGL");
  vtkNew<vtkComputeContext> old;
  old->SetSource(vtkComputeContext::EGL);
  old->SetMaximumVersion(4, 2);
  check("an old driver", Compute(torus, sm::BackendChoice::OpenGL, old), "4.3");
  vtkNew<vtkComputeContext> context;
  for (const char* shader : { "smGradientRowsCS", "smGradientLinesCS", "smGradientSumsCS" })
  {
    sm::GetFaultyShaders().insert(shader);
    check(shader, Compute(torus, sm::BackendChoice::OpenGL, context), "computes a gradient wrong");
    sm::GetFaultyShaders().clear();
  }
  const sm::MomentGradientResult right = Compute(torus, sm::BackendChoice::OpenGL, context);
  CheckTrue("right again", right.Backend == sm::BackendChoice::OpenGL, right.BackendReason);
  context->GetResources()->Window->FlushesSubnormals = true;
  check("subnormal numbers are 0", Compute(torus, sm::BackendChoice::OpenGL, context), "for 0");
  context->GetResources()->Window->FlushesSubnormals = false;
  // A torus takes milliseconds.
  const sm::MomentGradientResult small = Compute(torus, sm::BackendChoice::Automatic, context);
  CheckTrue("OpenGL does not pay for a torus",
    small.Backend == sm::BackendChoice::CPU && small.BackendReason.empty(), small.BackendReason);
}

/// A net of many spans: more rows than a batch of a software renderer has.
void CheckFiles(int count, char* files[], vtkComputeContext* context)
{
  for (int k = 0; k < count; ++k)
  {
    vtkNew<vtkSTEPReader> reader;
    reader->SetFileName(files[k]);
    UseCoarseMesh(reader);
    reader->Update();
    CheckModel(files[k], reader->GetOutputDataObject(0), context);
  }
}
}

int TestMomentGradientDevice(int argc, char* argv[])
{
  if (FlushesSubnormals())
  {
    return Skipped;
  }
  vtkNew<vtkComputeContext> context;
  CheckModel("ball", MakeRoundBody({ MakeBall({ 1.5, -2.0, 3.0 }, 2.0) }), context);
  CheckModel("torus", MakeRoundBody({ MakeTorus({ -1.0, 4.0, 2.0 }, 3.0, 1.25) }), context);
  BoxBody box;
  box.Add({ { 1.0, 2.0, 3.0 }, { 4.0, 6.0, 9.0 } });
  CheckModel("box", box.Make(), context);
  CheckFiles(argc - 1, argv + 1, context);
  CheckFallbacks();
  return Finish();
}
