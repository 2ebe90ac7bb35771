// EditBenchmark [FILE.step] [Google Benchmark's options]: updates a second of a solid that is edited, and
// where their time goes.
//
// Without a file the solid is a free-form one of 42 faces (smFreeFormBody.h); of a file it is the first
// solid. Counters: updates a second; milliseconds of an update's edit, display points and mass properties, of
// these cutting, planning and uploading
// ("prepare") and evaluating ("integrate"); faces changed, points and evaluations of an update, dispatches.
#include "smEditSession.h"
#include "smFreeFormBody.h"

#include <vtkPartitionedDataSetCollection.h>
#include <vtkSMPTools.h>
#include <vtkSTEPReader.h>
#include <vtkTrimmedNURBSModel.h>

#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace
{
using namespace smtest;

vtkSmartPointer<vtkNURBSDataSet> ReadLeaf(const char* path)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path);
  reader->Update();
  auto* product = vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(0));
  for (unsigned int i = 0; product && i < product->GetNumberOfPartitionedDataSets(); ++i)
  {
    if (auto* leaf = vtkNURBSDataSet::SafeDownCast(product->GetPartition(i, 0)))
    {
      return leaf;
    }
  }
  return nullptr;
}

void Measure(benchmark::State& state, vtkNURBSDataSet* leaf, int backend, double tolerance, EditKind kind)
{
  EditSession session(leaf, backend, tolerance);
  int number = 0;
  // Compiles the shaders, and evaluates the faces that no edit changes.
  session.Update(EditKind::FullRun, 0);
  session.Update(kind, ++number);
  session.Update(kind, ++number);
  UpdateCost total;
  for (auto _ : state)
  {
    const UpdateCost cost = session.Update(kind, ++number);
    total.Edit += cost.Edit;
    total.Display += cost.Display;
    total.Mass += cost.Mass;
    total.Prepare += cost.Prepare;
    total.Integrate += cost.Integrate;
    total.ChangedFaces += cost.ChangedFaces;
    total.ChangedPoints += cost.ChangedPoints;
    total.Evaluations += cost.Evaluations;
    total.Dispatches += cost.Dispatches;
  }
  if (!session.GetError().empty())
  {
    state.SkipWithError(session.GetError().c_str());
    return;
  }
  const auto each = [](double value)
  { return benchmark::Counter(value, benchmark::Counter::kAvgIterations); };
  state.counters["updates/s"] = benchmark::Counter(1.0, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["edit_ms"] = each(1e3 * total.Edit);
  state.counters["display_ms"] = each(1e3 * total.Display);
  state.counters["mass_ms"] = each(1e3 * total.Mass);
  state.counters["prepare_ms"] = each(1e3 * total.Prepare);
  state.counters["integrate_ms"] = each(1e3 * total.Integrate);
  state.counters["faces"] = each(static_cast<double>(total.ChangedFaces));
  state.counters["points"] = each(static_cast<double>(total.ChangedPoints));
  state.counters["evaluations"] = each(static_cast<double>(total.Evaluations));
  state.counters["dispatches"] = each(static_cast<double>(total.Dispatches));
}
}

int main(int argc, char* argv[])
{
  // ParaView's VTK starts sequential.
  vtkSMPTools::SetBackend("STDThread");
  benchmark::Initialize(&argc, argv);
  if (argc > 2)
  {
    std::fprintf(stderr, "usage: EditBenchmark [FILE.step] [--benchmark_filter=REGEX ...]\n");
    return EXIT_FAILURE;
  }
  const vtkSmartPointer<vtkNURBSDataSet> leaf = argc == 2 ? ReadLeaf(argv[1]) : FreeFormBody().Make();
  if (!leaf || !leaf->GetModel())
  {
    std::fprintf(stderr, "%s holds no solid.\n", argv[1]);
    return EXIT_FAILURE;
  }
  std::printf("%d faces, %d display points\n", static_cast<int>(leaf->GetModel()->GetNumberOfFaces()),
    static_cast<int>(leaf->GetNumberOfPoints()));
  for (const auto& [backend, name] : { std::make_pair(vtkMassPropertiesGPU::OPENGL, "opengl"),
         std::make_pair(vtkMassPropertiesGPU::CPU, "cpu") })
  {
    for (const char* tolerance : { "1e-9", "1e-6" })
    {
      for (const EditKind kind : { EditKind::Point, EditKind::Row, EditKind::Lattice, EditKind::FullRun })
      {
        const std::string title = std::string(name) + "/" + tolerance + "/" + smtest::GetName(kind);
        benchmark::RegisterBenchmark(
          title.c_str(), Measure, leaf.Get(), static_cast<int>(backend), std::atof(tolerance), kind)
          ->Unit(benchmark::kMillisecond)
          ->MeasureProcessCPUTime()
          ->UseRealTime();
      }
    }
  }
  benchmark::RunSpecifiedBenchmarks();
  return EXIT_SUCCESS;
}
