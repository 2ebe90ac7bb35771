// Benchmark edit [FILE.step]: updates a second of a solid that is edited, and where their time goes.
#include "smBenchmark.h"
#include "smEditSession.h"
#include "smFreeFormBody.h"

#include <vtkPartitionedDataSetCollection.h>
#include <vtkSMPTools.h>
#include <vtkSTEPReader.h>
#include <vtkTrimmedNURBSModel.h>

#include <chrono>
#include <cstdio>
#include <string>

namespace
{
using namespace smtest;

/// Wall-clock seconds of each case.
constexpr double SecondsOfCase = 1.0;

vtkSmartPointer<vtkNURBSDataSet> ReadLeaf(const std::string& path)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path.c_str());
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

/// Prints a row; returns false if an update failed.
bool Measure(vtkNURBSDataSet* leaf, int backend, const char* title, double tolerance, EditKind kind)
{
  EditSession session(leaf, backend, tolerance);
  int number = 0;
  // Compiles the shaders, and evaluates the faces that no edit changes.
  session.Update(EditKind::FullRun, 0);
  session.Update(kind, ++number);
  session.Update(kind, ++number);
  UpdateCost total;
  int updates = 0;
  double seconds = 0.0;
  for (const auto start = std::chrono::steady_clock::now(); seconds < SecondsOfCase; ++updates)
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
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  if (!session.GetError().empty())
  {
    std::fprintf(stderr, "%s: %s\n", title, session.GetError().c_str());
    return false;
  }
  std::printf("| %s, %.0e, %s | %.1f |", title, tolerance, GetName(kind), updates / seconds);
  for (const double part : { total.Edit, total.Display, total.Mass, total.Prepare, total.Integrate })
  {
    std::printf(" %.2f |", 1e3 * part / updates);
  }
  for (const long long count :
    { total.ChangedFaces, total.ChangedPoints, total.Evaluations, total.Dispatches })
  {
    std::printf(" %.0f |", static_cast<double>(count) / updates);
  }
  std::printf("\n");
  std::fflush(stdout);
  return true;
}

int Run(const std::string& path)
{
  // ParaView's VTK starts sequential.
  vtkSMPTools::SetBackend("STDThread");
  const vtkSmartPointer<vtkNURBSDataSet> leaf = path.empty() ? FreeFormBody().Make() : ReadLeaf(path);
  if (!leaf || !leaf->GetModel())
  {
    std::fprintf(stderr, "%s holds no solid.\n", path.c_str());
    return 1;
  }
  std::printf(
    "%d faces, %d display points\n\n| backend, tolerance, edit | updates/s | edit ms | display ms | mass ms "
    "| prepare ms | integrate ms | faces | points | evaluations | dispatches |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|\n",
    static_cast<int>(leaf->GetModel()->GetNumberOfFaces()), static_cast<int>(leaf->GetNumberOfPoints()));
  bool isGood = true;
  for (const int backend : { vtkMassPropertiesGPU::OPENGL, vtkMassPropertiesGPU::CPU })
  {
    const char* const title = backend == vtkMassPropertiesGPU::OPENGL ? "opengl" : "cpu";
    for (const double tolerance : { 1e-9, 1e-6 })
    {
      for (const EditKind kind : { EditKind::Point, EditKind::Row, EditKind::Lattice, EditKind::FullRun })
      {
        isGood = Measure(leaf, backend, title, tolerance, kind) && isGood;
      }
    }
  }
  return isGood ? 0 : 1;
}

void Add(CLI::App& app, int& status)
{
  static std::string path;
  CLI::App* command = app.add_subcommand("edit",
    "Updates a second of a solid that is edited: edit, display points and mass properties, of these cutting, "
    "planning and uploading (prepare) and evaluating (integrate), in milliseconds of the processor, of all "
    "threads. "
    "Without a file the solid is a free-form one of 42 faces. Exit status 1: an update failed");
  command->add_option("FILE", path, "STEP file, of which the first solid is taken");
  command->callback([&status]() { status = Run(path); });
}
const BenchmarkEntry Entry(Add);
}
