// The CPU runner by itself: rows depend on nothing but their items, sums of any segments are right to
// rounding, and neither order, portions nor threads change a bit.
#include "Items/smCPUItemRunner.h"
#include "Items/smItemKernels.h"
#include "smIntegrand.h"
#include "smTesting.h"
#include "smUnitRoundoff.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using namespace smtest;
using sm::ItemRunner;

constexpr int Caps = 5000;

/// A face of nothing but caps.
sm::CutFacePointer MakeCaps(std::mt19937& random, int count)
{
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  auto cut = std::make_shared<sm::CutFace>();
  cut->Source = std::make_shared<sm::Face>();
  for (int i = 0; i < count; ++i)
  {
    sm::Cap cap{};
    for (std::array<double, 3>* point : { &cap.Apex, &cap.From, &cap.To })
    {
      std::generate(point->begin(), point->end(), [&]() { return uniform(random); });
    }
    cap.FlipNormal = i % 2 == 1;
    cut->Panels.Caps.push_back(cap);
  }
  return cut;
}

double GetVolume(const sm::Cap& cap)
{
  const std::array<double, 3>& p = cap.Apex;
  const std::array<double, 3>& q = cap.From;
  const std::array<double, 3>& r = cap.To;
  const double det = p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) +
    p[2] * (q[0] * r[1] - q[1] * r[0]);
  return (cap.FlipNormal ? -1.0 : 1.0) * det / 6.0;
}

ItemRunner::Setup MakeSetup()
{
  ItemRunner::Setup setup;
  setup.Integrands = { sm::Integrand::VolumeMoment("V", 0, 0, 0), sm::Integrand::VolumeMoment("xz", 1, 0, 1),
    sm::Integrand::AreaMoment("A", 0, 0, 0) };
  return setup;
}

struct Job
{
  sm::CPUItemRunner Runner;
  sm::WorkItems Items;
  std::vector<std::size_t> All;

  explicit Job(const std::vector<sm::CutFacePointer>& faces)
  {
    this->Runner.Configure(MakeSetup());
    CheckTrue("acquire", this->Runner.Acquire(faces, nullptr), this->Runner.GetError());
    std::vector<ItemRunner::BatchFace> batch;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      batch.push_back({ i, { 1.0, 1.0, 1.0 }, {} });
      sm::AddItems(*faces[i], static_cast<std::uint32_t>(i), this->Items);
    }
    for (std::size_t i = 0; i < this->Items.size(); ++i)
    {
      this->Items[i].Work.Item[2] = static_cast<std::uint32_t>(i);
      sm::SetItemOrders(this->Items[i], { 3, 3, true, true }, false);
      this->All.push_back(i);
    }
    CheckTrue("begin", this->Runner.BeginBatch(batch) && this->Runner.BeginRows(this->Items.size()));
  }

  bool Run(const std::vector<std::size_t>& active, const sm::ContinueCallback& shouldContinue = nullptr)
  {
    std::vector<std::uint8_t> unconverged;
    std::int64_t evaluations = 0;
    const bool done = this->Runner.Run(this->Items, active, evaluations, shouldContinue);
    return done && this->Runner.GetUnconverged(unconverged) &&
      std::count(unconverged.begin(), unconverged.end(), 0) == static_cast<long>(active.size());
  }

  /// Every row by itself, then everything at once.
  std::vector<double> GetRows()
  {
    std::vector<sm::CPUItemRunner::Segment> segments;
    for (unsigned int i = 0; i < this->Items.size(); ++i)
    {
      segments.emplace_back(i, i + 1);
    }
    segments.emplace_back(0u, static_cast<unsigned int>(this->Items.size()));
    std::vector<double> sums;
    std::vector<double> largest;
    CheckTrue("sum", this->Runner.Sum(segments, sums, largest), this->Runner.GetError());
    return sums;
  }
};

void CheckRowsAndThreads(const std::vector<sm::CutFacePointer>& faces)
{
  std::vector<double> first;
  for (const int threads : { 1, 2, 3 })
  {
    vtkSMPTools::Initialize(threads);
    // vtkSMPTools takes no more than the machine has cores.
    const int actual = vtkSMPTools::GetEstimatedNumberOfThreads();
    CheckRange("threads", 1, actual, threads);
    CheckTrue("the description says them",
      sm::CPUItemRunner::GetDescription() ==
        "CPU, " + std::to_string(actual) + (actual == 1 ? " thread" : " threads"),
      sm::CPUItemRunner::GetDescription());
    Job job(faces);
    CheckTrue("run", job.Run(job.All));
    const std::vector<double> rows = job.GetRows();
    first = first.empty() ? rows : first;
    CheckTrue("same bits for any number of threads", rows == first);

    for (const int lanes : sm::GetLaneCounts())
    {
      Job narrow(faces);
      narrow.Runner.SetLaneCount(lanes);
      CheckTrue("same bits for any number of lanes", narrow.Run(narrow.All) && narrow.GetRows() == first);
    }

    // Backwards, in two portions.
    Job portions(faces);
    std::vector<std::size_t> order(portions.All.rbegin(), portions.All.rend());
    const auto half = order.begin() + 1234;
    CheckTrue(
      "run in portions", portions.Run({ order.begin(), half }) && portions.Run({ half, order.end() }));
    CheckTrue("same bits for any order", portions.GetRows() == first);
  }
  const sm::RowLayout layout(MakeSetup().Integrands);
  double worst = 0.0;
  double scale = 0.0;
  std::size_t row = 0;
  for (const sm::CutFacePointer& face : faces)
  {
    for (const sm::Cap& cap : face->Panels.Caps)
    {
      const double* values = first.data() + row++ * layout.GetStride();
      scale = std::max(scale, std::abs(GetVolume(cap)));
      worst = std::max(worst, std::abs(values[layout.GetValue(0)] - GetVolume(cap)));
    }
  }
  Check("volumes over the caps", 0.0, worst, 64 * sm::UnitRoundoff, "coordinates up to 1, 9 samples");
  CheckTrue("they are not all zero", scale > 0.1);
}

void CheckSegments(const std::vector<sm::CutFacePointer>& faces)
{
  Job job(faces);
  job.Run(job.All);
  const sm::RowLayout layout(MakeSetup().Integrands);
  const int stride = layout.GetStride();
  const std::vector<double> rows = job.GetRows();
  const std::vector<sm::CPUItemRunner::Segment> segments = { { 0u, 5000u }, { 17u, 18u }, { 100u, 3000u },
    { 90u, 110u }, { 4000u, 4000u }, { 4999u, 5000u } };
  std::vector<double> sums;
  std::vector<double> largest;
  CheckTrue("sum", job.Runner.Sum(segments, sums, largest));
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    const auto [from, to] = segments[i];
    double worst = 0.0;
    for (int column = 0; column < stride; ++column)
    {
      long double expected = 0.0L;
      for (unsigned int row = from; row < to; ++row)
      {
        expected += rows[row * stride + column];
      }
      worst = std::max(worst,
        static_cast<double>(std::abs(sums[i * stride + column] - expected)) /
          std::max(1e-300, static_cast<double>(std::abs(expected))));
    }
    Check("segment " + std::to_string(i), 0.0, worst, 4 * sm::UnitRoundoff,
      "a compensated sum, relative to itself");
  }
  Check("an empty segment has no gap", 0.0, largest[4], 0.0);
  CheckTrue("a segment outside is refused", !job.Runner.Sum({ { 4999u, 5001u } }, sums, largest));
  CheckTrue("it says which", job.Runner.GetError().find("5001") != std::string::npos, job.Runner.GetError());
}

void CheckNoNumbers(std::mt19937& random)
{
  auto face = std::make_shared<sm::CutFace>(*MakeCaps(random, 100));
  face->Panels.Caps[40].Apex[0] = std::nan("");
  face->Panels.Caps[70].Apex = { 1e300, 1e300, 1e300 };
  Job job({ face });
  job.Run(job.All);
  const sm::RowLayout layout(MakeSetup().Integrands);
  std::vector<double> sums;
  std::vector<double> largest;
  job.Runner.Sum({ { 0u, 40u }, { 0u, 60u }, { 60u, 100u } }, sums, largest);
  const auto get = [&](int segment) { return sums[segment * layout.GetStride() + layout.GetValue(1)]; };
  CheckTrue("a number", std::isfinite(get(0)));
  CheckTrue("NaN is not lost", std::isnan(get(1)));
  CheckTrue("nor an overflow", !std::isfinite(get(2)));
}

void CheckObstacleAndAbort(const std::vector<sm::CutFacePointer>& faces)
{
  Job job(faces);
  CheckEqual("no obstacle", "", job.Runner.GetObstacle(sm::Integrand::VolumeMoment("V", 0, 0, 0)));
  const std::string obstacle = job.Runner.GetObstacle(sm::Integrand::User("mine", "1.0LF", false));
  CheckTrue("an expression is named with the remedy",
    obstacle.find("mine") != std::string::npos &&
      obstacle.find("needs OpenGL 4.3 with doubles") != std::string::npos,
    obstacle);
  for (sm::WorkItem& item : job.Items)
  {
    // As costly as a part of the work: progress is asked for after each.
    item.Cost = 4000000;
  }
  int asked = 0;
  CheckTrue("stopped", !job.Run(job.All, [&asked]() { return ++asked < 3; }));
  CheckEqual("at once", 3, asked);
}
}

int TestCPUItemRunner(int, char*[])
{
  vtkSMPTools::SetBackend("STDThread");
  std::mt19937 random(17);
  const std::vector<sm::CutFacePointer> faces = { MakeCaps(random, 1700), MakeCaps(random, Caps - 1700) };
  CheckRowsAndThreads(faces);
  CheckSegments(faces);
  CheckNoNumbers(random);
  CheckObstacleAndAbort(faces);
  return Finish();
}
