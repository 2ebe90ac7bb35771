/**
 * @file smSchemeTesting.h
 * @brief Runs the integrator of the paper's schemes on faces made by hand, on the GPU or the CPU
 */
#ifndef smSchemeTesting_h
#define smSchemeTesting_h

#include "smSchemeFaces.h"

#include "Detail/smCPUSchemeRunner.h"
#include "Detail/smGPUSchemeRunner.h"
#include "Detail/smMassTolerance.h"
#include "Detail/smSchemeIntegrator.h"
#include "smTesting.h"

#include <vtkComputeContext.h>
#include <vtkNew.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <memory>

namespace smtest
{
using Results = std::vector<sm::SchemeResult>;

inline vtkComputeContext* GetContext()
{
  static vtkNew<vtkComputeContext> context;
  return context;
}

inline std::unique_ptr<sm::SchemeRunner> MakeRunner(bool gpu)
{
  if (gpu)
  {
    return std::make_unique<sm::GPUSchemeRunner>(GetContext());
  }
  return std::make_unique<sm::CPUSchemeRunner>();
}

inline Results Integrate(bool gpu, const std::vector<sm::FacePointer>& faces,
  const sm::SchemeIntegrator::Setup& setup, std::int64_t* evaluations = nullptr)
{
  sm::SchemeIntegrator integrator;
  integrator.SetRunner(MakeRunner(gpu));
  std::vector<sm::SchemeTask> tasks;
  for (const sm::FacePointer& face : faces)
  {
    tasks.push_back({ face, 1e-6 });
  }
  Results results;
  CheckTrue(gpu ? "the GPU integrates" : "the CPU integrates",
    integrator.Integrate(tasks, setup, results, nullptr), integrator.GetError());
  if (evaluations)
  {
    *evaluations = integrator.GetEvaluations();
  }
  results.resize(faces.size());
  for (sm::SchemeResult& result : results)
  {
    result.Integrals.Face.resize(sm::NumberOfMassIntegrands, std::nan(""));
  }
  return results;
}

inline std::vector<double> GetAll(const sm::SchemeResult& result)
{
  std::vector<double> all = result.Integrals.Face;
  all.push_back(result.Estimate);
  all.push_back(result.EstimateWithBoundary);
  all.push_back(static_cast<double>(result.SubPatches));
  return all;
}

/// The size that rounding of each integral is relative to: area times the matching power of the farthest
/// control point.
inline std::vector<double> GetScales(const sm::Face& face, double area)
{
  double reach = 0.0;
  for (const std::array<double, 4>& p : face.Surface.ControlPoints)
  {
    reach = std::max(reach, std::hypot(p[0], p[1], p[2]) / p[3]);
  }
  std::vector<double> scales = { area * reach };
  scales.insert(scales.end(), 3, area * reach * reach);
  scales.insert(scales.end(), 6, area * reach * reach * reach);
  scales.insert(scales.end(), 4, area);
  return scales;
}

struct NamedFace
{
  std::string Name;
  sm::FacePointer Face;
};

inline std::vector<NamedFace> MakeFaces()
{
  std::mt19937 random(41);
  const std::vector<double> one = { 0.0, 1.0 };
  const std::vector<double> two = { -1.0, 0.25, 1.0 };
  const std::vector<double> three = { 0.0, 0.5, 2.0, 3.0 };
  std::vector<NamedFace> faces;
  faces.push_back({ "paraboloid", MakeFace(MakeParaboloid(0.3, -0.7, 1.1, three, two), {}) });
  faces.push_back({ "quarter cylinder", MakeFace(MakeQuarterCylinder(3.0, 5.0), {}, true) });
  faces.push_back({ "degrees 1 2", MakeFace(MakeRandomSurface(random, 1, 2, two, three, 0.2, 0.3), {}) });
  faces.push_back({ "degrees 3 3", MakeFace(MakeRandomSurface(random, 3, 3, three, two, 0.2, 0.4), {}) });
  faces.push_back({ "degrees 5 4", MakeFace(MakeRandomSurface(random, 5, 4, two, two, 0.2, 0.2), {}, true) });
  faces.push_back({ "degree 25", MakeFace(MakeRandomSurface(random, 25, 2, one, one, 0.1, 0.1), {}) });
  faces.push_back({ "trimmed, polygon",
    MakeFace(MakeRandomSurface(random, 3, 3, three, three, 0.2, 0.4),
      { MakePolygonLoop(
        { { 0.31, 0.17 }, { 2.83, 0.41 }, { 2.2, 2.77 }, { 1.21, 1.13 }, { 0.2, 2.9 } }) }) });
  faces.push_back({ "trimmed, leaf with a hole",
    MakeFace(MakeQuarterCylinder(2.0, 3.0),
      { MakeLeaf(0.5, 0.49, 0.43, 0.41, false), MakeLeaf(0.44, 0.52, 0.19, 0.3, true) }, true) });
  faces.push_back({ "trimmed, loops inside out and twice around",
    MakeFace(MakeParaboloid(0.3, -0.7, 1.1, three, two),
      { MakeLeaf(1.1, -0.2, 0.71, 0.41, true), MakeLeaf(1.94, 0.3, 0.61, 0.3, false),
        MakeLeaf(2.07, 0.11, 0.43, 0.35, false) }) });
  faces.push_back({ "trimmed, a hole in all of it",
    MakeFace(MakeRandomSurface(random, 2, 4, three, three, 0.2, 0.2),
      { MakePolygonLoop({ { 0.0, 0.0 }, { 3.0, 0.0 }, { 3.0, 3.0 }, { 0.0, 3.0 } }),
        MakeLeaf(1.6, 1.3, 1.1, 0.4142, true) }) });
  faces.push_back({ "plane",
    MakeFace(MakePlane({ 1.0, 2.0, 3.0 }, { 2.0, 0.5, 0.25 }, { -0.25, 1.5, 1.0 }, 0.0, 1.0, 0.0, 1.0),
      { MakeLeaf(0.5, 0.49, 0.43, 0.41, false), MakeLeaf(0.44, 0.52, 0.19, 0.3, true) }, true) });
  return faces;
}

/// Threads for the CPU; false when there is no context to compare with, and it says why.
inline bool Start()
{
  vtkSMPTools::SetBackend("STDThread");
  const bool ready = GetContext()->Start() == vtkComputeContext::READY;
  if (!ready)
  {
    std::printf("skipped: %s\n", GetContext()->GetReason().c_str());
  }
  return ready;
}
}

#endif
