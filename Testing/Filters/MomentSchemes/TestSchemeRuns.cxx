// TestSchemeRuns: the paper's schemes give bits that do not depend on the other faces, tiles may cut a face
// anywhere, and what cannot be computed is reported.
#include "smSchemeTesting.h"

#include <utility>

namespace
{
using namespace smtest;

void CheckBits()
{
  std::vector<sm::FacePointer> faces;
  for (const NamedFace& named : MakeFaces())
  {
    faces.push_back(named.Face);
  }
  sm::SchemeIntegrator::Setup setup;
  setup.Options.Factor = 7;
  for (const bool gpu : { true, false })
  {
    const Results together = Integrate(gpu, faces, setup);
    bool same = true;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      same = same && GetAll(Integrate(gpu, { faces[i] }, setup)[0]) == GetAll(together[i]);
    }
    CheckTrue("the same bits alone and in company", same);
    vtkSMPTools::Initialize(1);
    const Results again = Integrate(gpu, { faces.rbegin(), faces.rend() }, setup);
    vtkSMPTools::Initialize(0);
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      same = same && GetAll(again[faces.size() - 1 - i]) == GetAll(together[i]);
    }
    CheckTrue("in any order, with one thread", same);
    setup.Perturbation = 1.0 + 1.0 / 1024.0;
    const Results perturbed = Integrate(gpu, faces, setup);
    setup.Perturbation = 1.0;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      const bool planar = together[i].SubPatches == 0;
      const double area = together[i].Integrals.Face[sm::MassArea];
      Check(planar ? "a plane is not a shader's" : "perturbed", area * (planar ? 1.0 : 1.0 + 1.0 / 1024.0),
        perturbed[i].Integrals.Face[sm::MassArea], 1e-13 * area);
    }
  }
}

/// Many tiles and batches; then tiles that cut rows and columns anywhere, against the whole.
void CheckTiles()
{
  std::mt19937 random(5);
  const sm::FacePointer face =
    MakeFace(MakeRandomSurface(random, 3, 3, { 0.0, 1.5, 3.0 }, { 0.0, 1.5, 3.0 }, 0.1, 0.2),
      { MakeLeaf(1.45, 1.55, 1.31, 0.37, false), MakeLeaf(1.61, 1.4, 0.61, 0.2, true) });
  sm::SchemeIntegrator::Setup setup;
  setup.Points = 1;
  setup.Options.Factor = 150;
  setup.KeepTextures = true;
  const sm::SchemeResult gpu = Integrate(true, { face }, setup)[0];
  const sm::SchemeResult cpu = Integrate(false, { face }, setup)[0];
  CheckEqual("sub-patches", 90000, gpu.SubPatches);
  CheckTrue(
    "the same texture", gpu.Texture.Texels == cpu.Texture.Texels && gpu.Texture.Texels.size() == 1440000);
  const auto inside = std::count(gpu.Texture.Texels.begin(), gpu.Texture.Texels.end(), 1);
  const double area = GetLeafArea(1.31, 0.37) - GetLeafArea(0.61, 0.2);
  // 12 of length cross 4800 texels of 0.0025; each is wrong by at most half of itself, with a spread of
  // 1/sqrt(12): 4 sigma of their sum.
  Check(
    "area of the texels", area, 9.0 * inside / 1440000.0, 4.0 * std::sqrt(4800.0 / 12.0) * 0.0025 * 0.0025);
  Check("GPU and CPU", gpu.Integrals.Face[sm::MassArea], cpu.Integrals.Face[sm::MassArea],
    1e-13 * gpu.Integrals.Face[sm::MassArea]);

  sm::SchemeOptions options;
  options.Factor = 5;
  options.ChordTolerance = 1e-6;
  const sm::SubPatchFace prepared = sm::PrepareSubPatchFace(face, options);
  const std::vector<sm::TileRange> whole = sm::MakeTiles(0, prepared, 4);
  CheckTrue("one tile", whole.size() == 1 && whole[0].Columns == 10 && whole[0].Rows == 10);
  const std::vector<sm::TileRange> cut = { { 0, 0, 0, 3, 10 }, { 0, 3, 0, 6, 1 }, { 0, 3, 1, 6, 9 },
    { 0, 9, 0, 1, 4 }, { 0, 9, 4, 1, 6 } };
  for (const bool isGpu : { true, false })
  {
    const std::unique_ptr<sm::SchemeRunner> runner = MakeRunner(isGpu);
    std::vector<double> sums[2];
    for (const auto& [tiles, which] : { std::make_pair(whole, 0), std::make_pair(cut, 1) })
    {
      sm::SchemeBatch batch;
      for (const sm::TileRange& tile : tiles)
      {
        CheckTrue("room", batch.Add(tile, prepared, 4, runner->GetMaximumBytes()));
      }
      sm::SchemeRunner::Results results;
      CheckTrue("it runs", runner->Run(batch, {}, results, nullptr), runner->GetError());
      CheckTrue("texels are not kept unless asked for", results.Texels.empty());
      sums[which].assign(sm::NumberOfSchemeColumns, 0.0);
      for (std::size_t i = 0; i < results.Sums.size(); ++i)
      {
        sums[which][i % sm::NumberOfSchemeColumns] += results.Sums[i];
      }
    }
    for (const int column : { 0, 5, 13, 14, 15 })
    {
      Check("tiles add up to the whole, column " + std::to_string(column), sums[0][column], sums[1][column],
        1e-13 * std::fabs(sums[0][column]) + 1e-14 * sums[0][sm::MassArea]);
    }
  }
}

void CheckRefusals()
{
  std::mt19937 random(5);
  const sm::FacePointer good =
    MakeFace(MakeRandomSurface(random, 3, 3, { 0.0, 1.0 }, { 0.0, 1.0 }, 0.1, 0.2), {});
  auto broken = std::make_shared<sm::Face>(*good);
  broken->Id = sm::NewId();
  broken->FileId = 77;
  broken->Surface.Knots[0].pop_back();
  const std::vector<sm::SchemeTask> tasks{ { good, 1.0 } };
  sm::SchemeIntegrator::Setup setup;
  for (const bool gpu : { true, false })
  {
    const Results results = Integrate(gpu, { good, broken }, setup);
    CheckTrue("a broken face names itself", results[1].Integrals.Error.find("#77") != std::string::npos,
      results[1].Integrals.Error);
    CheckTrue("the other is there", results[0].Integrals.Error.empty() && results[0].SubPatches == 4);

    sm::SchemeIntegrator integrator;
    integrator.SetRunner(MakeRunner(gpu));
    Results none;
    sm::SchemeIntegrator::Setup costly = setup;
    costly.MaximumEvaluations = 15;
    CheckTrue("too costly", !integrator.Integrate(tasks, costly, none, nullptr) && none.empty());
    CheckTrue(
      "it says so", integrator.GetError().find("16 evaluations") != std::string::npos, integrator.GetError());
    costly.MaximumEvaluations = 16;
    CheckTrue("just enough", integrator.Integrate(tasks, costly, none, nullptr), integrator.GetError());
    double last = 0.0;
    const auto stop = [&last](double fraction)
    {
      last = fraction;
      return fraction < 0.5;
    };
    costly.MaximumEvaluations = 2000000000;
    costly.Options.Factor = 400;
    CheckTrue("stopped", !integrator.Integrate(tasks, costly, none, stop) && integrator.WasAborted());
    CheckTrue("half way", last >= 0.5 && last <= 1.0 && !integrator.WasTimedOut(), std::to_string(last));
    costly.MaximumSeconds = 1e-6;
    CheckTrue("out of time",
      !integrator.Integrate(tasks, costly, none, nullptr) && integrator.WasTimedOut() && none.empty());
    CheckTrue("and on", integrator.Integrate(tasks, setup, none, nullptr) && none.size() == 1);
    CheckTrue("the same bits", GetAll(none[0]) == GetAll(results[0]));
  }
}

/// A single face whose deviations alone would take long: the clock and the caller are heard while it is
/// prepared.
void CheckPreparing()
{
  std::mt19937 random(5);
  const sm::FacePointer face =
    MakeFace(MakeRandomSurface(random, 5, 5, { 0.0, 1.0 }, { 0.0, 1.0 }, 0.1, 0.2), {});
  sm::SchemeIntegrator::Setup setup;
  setup.Points = 1;
  setup.Options.Factor = 1024;
  const std::int64_t all = 1024 * 1024;
  sm::SchemeIntegrator integrator;
  integrator.SetRunner(MakeRunner(false));
  const std::vector<sm::SchemeTask> tasks{ { face, 1.0 } };
  Results none;
  for (const int last : { 1, 2, 3, 4, 6 })
  {
    int calls = 0;
    std::int64_t seen = -1;
    const auto stop = [&](double)
    {
      seen = integrator.GetPrepared().GetDeviations();
      return ++calls < last;
    };
    const std::string name = "stopped by call " + std::to_string(last);
    CheckTrue(name, !integrator.Integrate(tasks, setup, none, stop) && integrator.WasAborted());
    CheckEqual(name + ", calls", last, calls);
    CheckEqual(name + ", nothing is prepared after it", seen, integrator.GetPrepared().GetDeviations());
    // At the start, after the face's shape, and after portions of 256 sub-patches, at most twice as many, and
    // so on.
    const double maximum = last < 3 ? 0.0 : 256.0 * (std::pow(2.0, last - 2) - 1.0);
    CheckRange(
      name + ", sub-patches", last < 3 ? 0.0 : 256.0, static_cast<double>(seen), maximum, "portions");
  }
  setup.MaximumSeconds = 0.05;
  CheckTrue("out of time", !integrator.Integrate(tasks, setup, none, nullptr));
  CheckTrue("it was the time", integrator.WasTimedOut());
  CheckRange("sub-patches prepared in time", 1.0,
    static_cast<double>(integrator.GetPrepared().GetDeviations()), static_cast<double>(all / 2),
    "it would take seconds");

  // The values are those of the face in one go, however it is divided, and what was stopped is not kept.
  setup.MaximumSeconds = 0.0;
  setup.Options.Factor = 64;
  CheckTrue("and on", integrator.Integrate(tasks, setup, none, nullptr), integrator.GetError());
  CheckEqual("all of it", 64 * 64, integrator.GetPrepared().GetDeviations());
  sm::SchemeOptions options = setup.Options;
  options.ChordTolerance = 1.0;
  const sm::SubPatchFace whole = sm::PrepareSubPatchFace(face, options);
  sm::PreparedFaces parts;
  CheckTrue("prepared", parts.Prepare(tasks, options, [](double) { return true; }));
  CheckTrue("the same deviations",
    parts.Get()[0]->Deviations == whole.Deviations &&
      std::count(whole.Deviations.begin(), whole.Deviations.end(), 0.0) == 0);
  CheckRange("in several portions", 256.0, static_cast<double>(parts.GetMaxPortion()), 2048.0);
  CheckTrue("kept", parts.Prepare(tasks, options, nullptr) && parts.GetDeviations() == 0);

  // Kept within the budget that all caches share; what it removed is prepared again, with the same values.
  sm::CacheBudget budget(std::size_t{ 1 } << 30);
  sm::PreparedFaces counted(budget);
  CheckTrue("in a budget", counted.Prepare(tasks, options, [](double) { return true; }));
  CheckTrue("its bytes count", budget.GetBytes() > whole.Deviations.size() * sizeof(double),
    std::to_string(budget.GetBytes()));
  budget.SetLimit(1);
  CheckEqual("and are freed", 0LL, static_cast<long long>(budget.GetBytes()));
  CheckTrue("prepared again", counted.Prepare(tasks, options, [](double) { return true; }));
  CheckTrue(
    "all of it", counted.GetDeviations() == 64 * 64 && counted.Get()[0]->Deviations == whole.Deviations);
}
}

int TestSchemeRuns(int, char*[])
{
  if (!Start())
  {
    return Skipped;
  }
  CheckBits();
  CheckTiles();
  CheckRefusals();
  CheckPreparing();
  return Finish();
}
