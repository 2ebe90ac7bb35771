// The portions of a face's plan, planned by several threads at once: they share the series of its patches,
// and have the bits of a plan by one thread.
#include "smQuadraturePlan.h"
#include "smTesting.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

namespace
{
using namespace smtest;

constexpr int Threads = 4;

/// A rational patch of the degree with many panels between its left side and a curved trim piece.
sm::FacePanels MakePanels(int degree, int panels)
{
  sm::FacePanels face;
  sm::Patch patch{};
  patch.Degree[0] = patch.Degree[1] = degree;
  patch.Width[0] = patch.Width[1] = 1.0;
  for (int j = 0; j <= degree; ++j)
  {
    for (int i = 0; i <= degree; ++i)
    {
      const double w = 1.0 + 0.1 * i * j / degree;
      const double x = static_cast<double>(i) / degree;
      const double y = static_cast<double>(j) / degree;
      face.Points.push_back({ w * x, w * y, w * 0.4 * std::sin(2.0 * x + y * y), w });
    }
  }
  sm::MeasurePatch(face.Points.data(), patch);
  face.Patches.push_back(patch);
  face.Coefficients = { 0.9, 0.0, 0.7, 0.5, 0.8, 1.0 };
  for (int i = 0; i < panels; ++i)
  {
    const double start = static_cast<double>(i) / panels;
    face.Panels.push_back({ 0, 0, 2, sm::PanelShape::General, false, false, start, start + 1.0 / panels });
  }
  return face;
}

bool IsSame(const sm::FacePlan& a, const sm::FacePlan& b)
{
  bool isSame = a.Items.size() == b.Items.size() && a.QuadratureBound == b.QuadratureBound &&
    a.Magnitude == b.Magnitude && a.Evaluations == b.Evaluations;
  for (std::size_t i = 0; isSame && i < a.Items.size(); ++i)
  {
    isSame = a.Items[i].Index == b.Items[i].Index && a.Items[i].Along == b.Items[i].Along &&
      a.Items[i].Across == b.Items[i].Across;
  }
  return isSame;
}

void CheckThreads(int degree, double tolerance, int repeats)
{
  const sm::Face face;
  const sm::FacePanels panels = MakePanels(degree, 128);
  sm::PlanRequest request;
  request.Classes = { { sm::BoundClass::VolumeMoment, 0 }, { sm::BoundClass::VolumeMoment, 2 },
    sm::PlainArea };
  request.Tolerances.assign(request.Classes.size(), tolerance);
  const sm::FacePlan expected = sm::PlanFace(face, panels, request);
  int different = 0;
  for (int repeat = 0; repeat < repeats; ++repeat)
  {
    sm::FacePlanner planner(face, panels, request);
    std::atomic<std::size_t> next{ 0 };
    std::vector<std::thread> threads;
    for (int i = 0; i < Threads; ++i)
    {
      threads.emplace_back(
        [&]()
        {
          for (std::size_t k = next++; k < planner.GetNumberOfPortions(); k = next++)
          {
            planner.PlanPortion(k);
          }
        });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
    different += IsSame(expected, planner.Join()) ? 0 : 1;
  }
  CheckTrue("the face has many portions", expected.Items.size() >= 128);
  CheckEqual("plans by several threads that differ, degree " + std::to_string(degree), 0, different);
}

/// A plane is continued to trim curves beyond its patch, and so are the bounds.
void CheckBeyond(double extent)
{
  const double bend = 1e-15;
  sm::FacePanels face;
  sm::Patch patch{};
  patch.Degree[0] = patch.Degree[1] = 1;
  patch.Width[0] = patch.Width[1] = 1.0;
  face.Points = { { 0, 0, 0, 1 }, { 1, 0, 0, 1 }, { 0, 1, 0, 1 }, { 1, 1, bend, 1 } };
  sm::MeasurePatch(face.Points.data(), patch);
  face.Patches.push_back(patch);
  face.Coefficients = { extent, 0.0, extent, extent };
  face.Panels.push_back({ 0, 0, 1, sm::PanelShape::Flat, false, false, 0.0, 1.0 });
  sm::PlanRequest request;
  request.Classes = { { sm::BoundClass::VolumeMoment, 1 }, { sm::BoundClass::AreaMoment, 1 } };
  request.Tolerances = { 1e-9, 1e-9 };
  const sm::FacePlan plan = sm::PlanFace({}, face, request);
  const std::string label = "plane to " + std::to_string(extent);
  // The flux of x is that of |x . n| = bend s r, and the area's moment of x half of the cube of the extent.
  CheckRange(label + ", largest moment", 0.5 * std::pow(extent, 3.0), plan.Magnitude[1],
    100.0 * std::pow(extent, 3.0));
  // One point misses the square in x of a square's x y x by a twelfth.
  CheckRange(label + ", bound", bend * std::pow(extent, 5.0) / (12.0 * 2.0 * 4.0), plan.QuadratureBound[0],
    100.0 * bend * std::pow(extent, 5.0));
}

/// The end of a covered edge is where trim pieces cross it, whose coefficients may be large compared with the
/// surface's parameters.
void CheckCoveredEnd(double largest)
{
  sm::FacePanels face = MakePanels(2, 1);
  face.Coefficients = { 1.0, 0.0, 1.0, 0.5 };
  face.Panels[0].TrimDegree = 1;
  face.Panels[0].Covered = true;
  face.MaxTrim[1] = largest;
  sm::PlanRequest request;
  request.Classes = { { sm::BoundClass::AreaMoment, 0 } };
  request.Tolerances = { 1e-18 };
  const double bound = sm::PlanFace({}, face, request).QuadratureBound[0];
  CheckRange("covered end of pieces of " + std::to_string(largest), 50.0 * 1.1e-16 * std::max(largest, 1.0),
    bound, 1e3 * 1.1e-16 * std::max(largest, 1e2));
}
}

int TestFacePlanner(int, char*[])
{
  for (const int degree : { 2, 3, 6 })
  {
    for (const double tolerance : { 1e-6, 1e-12 })
    {
      CheckThreads(degree, tolerance, 40);
    }
  }
  for (const double largest : { 0.5, 1e2, 1e7 })
  {
    CheckCoveredEnd(largest);
  }
  for (const double extent : { 1.0, 3.0, 30.0, 1000.0 })
  {
    CheckBeyond(extent);
  }
  return Finish();
}
