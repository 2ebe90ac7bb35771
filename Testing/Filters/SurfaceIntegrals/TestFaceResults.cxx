// The results of a face are the same bits whatever faces it is integrated with, where rows are short of room
// too.
#include "Items/smCPUItemRunner.h"
#include "smSurfaceIntegrator.h"
#include "smTesting.h"

#include <cstring>

namespace
{
using namespace smtest;

/// A runner whose rows have room for a given number of items only.
class ShortRunner : public sm::CPUItemRunner
{
public:
  explicit ShortRunner(std::size_t rows)
    : Rows(rows)
  {
  }
  std::size_t GetRowLimit() const override { return this->Rows; }

private:
  std::size_t Rows;
};

/// A sheet that turns back at the line u = `fold`, where its normal vanishes: panels there are bisected
/// without end.
sm::FacePointer MakeFolded(double fold, double height)
{
  auto face = std::make_shared<sm::Face>();
  face->Id = sm::NewId();
  sm::NURBSSurface& surface = face->Surface;
  surface.Degree[0] = 2;
  surface.Degree[1] = 2;
  surface.NumberOfControlPoints[0] = surface.NumberOfControlPoints[1] = 3;
  surface.Knots[0] = surface.Knots[1] = { 0.0, 0.0, 0.0, 1.0, 1.0, 1.0 };
  // Bernstein coefficients of (u - fold)^2.
  const double x[3] = { fold * fold, fold * fold - fold, (1.0 - fold) * (1.0 - fold) };
  for (int j = 0; j < 3; ++j)
  {
    for (int i = 0; i < 3; ++i)
    {
      surface.ControlPoints.push_back({ x[i], 0.5 * j + 0.1 * x[i] * j * j, height * x[i] * (j - 1.0), 1.0 });
    }
  }
  return face;
}

std::vector<sm::FaceIntegrals> Integrate(const std::vector<sm::FacePointer>& faces, std::size_t rows)
{
  sm::SurfaceIntegrator integrator;
  integrator.SetRunner(std::make_unique<ShortRunner>(rows));
  integrator.SetIntegrands(
    { sm::Integrand::VolumeMoment("V", 0, 0, 0), sm::Integrand::AreaMoment("A", 0, 0, 0) });
  std::vector<sm::FaceTask> tasks;
  for (const sm::FacePointer& face : faces)
  {
    tasks.push_back({ face, nullptr, { 1e-12, 1e-12 }, {} });
  }
  std::vector<sm::FaceIntegrals> results;
  CheckTrue("integrated", integrator.Integrate(tasks, results, nullptr), integrator.GetError());
  return results;
}

/// Runs that were stopped before they asked for any face do not make it old.
void CheckStopped()
{
  sm::SurfaceIntegrator integrator;
  integrator.SetRunner(std::make_unique<sm::CPUItemRunner>());
  integrator.SetIntegrands({ sm::Integrand::AreaMoment("A", 0, 0, 0) });
  const std::vector<sm::FaceTask> tasks = { { MakeFolded(0.3, 0.5), nullptr, { 1e-9 }, {} } };
  std::vector<sm::FaceIntegrals> results;
  CheckTrue("integrated", integrator.Integrate(tasks, results, nullptr), integrator.GetError());
  CheckTrue("evaluated", integrator.GetEvaluations() > 0);
  const double area = results[0].Face[0];
  for (int i = 0; i < 12; ++i)
  {
    CheckTrue("stopped", !integrator.Integrate(tasks, results, [](double) { return false; }));
  }
  CheckTrue("integrated again", integrator.Integrate(tasks, results, nullptr), integrator.GetError());
  CheckEqual("for nothing", 0, integrator.GetEvaluations());
  Check("the same", area, results[0].Face[0], 0.0);
}

bool AreSameIntegrals(const std::vector<double>& a, const std::vector<double>& b)
{
  return !a.empty() && a.size() == b.size() &&
    std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}
}

int TestFaceResults(int, char*[])
{
  std::vector<sm::FacePointer> faces;
  for (int i = 0; i < 7; ++i)
  {
    faces.push_back(MakeFolded(0.31 + 0.05 * i, 0.2 + 0.3 * i));
  }
  for (const std::size_t rows : { 7, 30, 61, 137, 300, 65536 })
  {
    const std::vector<sm::FaceIntegrals> together = Integrate(faces, rows);
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      const sm::FaceIntegrals alone = Integrate({ faces[i] }, rows)[0];
      CheckTrue(std::to_string(rows) + " rows, face " + std::to_string(i) + ": the bits of a run of its own",
        AreSameIntegrals(alone.Face, together[i].Face) &&
          AreSameIntegrals(alone.Rounding, together[i].Rounding) &&
          AreSameIntegrals(alone.QuadratureError, together[i].QuadratureError));
      CheckTrue("something was compared", alone.Estimated && alone.Face[1] > 0.1);
    }
  }
  CheckStopped();
  return Finish();
}
