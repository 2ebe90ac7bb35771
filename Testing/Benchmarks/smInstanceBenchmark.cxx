// Benchmark instances N: what instances of one solid cost with and without a display mesh.
#include "smBenchmark.h"
#include "smHelperProcess.h"
#include "smProcessorTime.h"
#include "smScaleModels.h"

#include <vtkMassPropertiesGPU.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSTEPReader.h>

#include <cstdio>
#include <fstream>
#include <string>

namespace
{
using namespace smtest;

/// Returns the results of a run, "16 instances 0 triangles volume ... ok"; there is no volume of a reader for
/// a view.
std::string Run(const std::string& path, const std::string& mode)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path.c_str());
  std::string volume;
  if (mode == "need" || mode == "always")
  {
    reader->SetDisplayMesh(mode == "always" ? vtkSTEPReader::MESH_ALWAYS : vtkSTEPReader::MESH_BY_NEED);
    vtkNew<vtkMassPropertiesGPU> mass;
    mass->SetBackend(vtkMassPropertiesGPU::CPU);
    mass->SetInputConnection(reader->GetOutputPort());
    mass->Update();
    char text[40];
    std::snprintf(text, sizeof(text), "%.17g", mass->GetVolume());
    volume = std::string("volume ") + text + " " + mass->GetStatus();
  }
  else
  {
    reader->SetCoarseAbove(100000);
    reader->SetRefined(mode == "refined");
    reader->Update();
  }
  return std::to_string(reader->GetNumberOfInstances()) + " instances " +
    std::to_string(reader->GetOutput()->GetNumberOfCells()) + " triangles " + volume;
}

/// Prints a line; returns the part of it that has the volume, which is empty if there is none.
std::string Measure(const std::string& path, const std::string& mode)
{
  std::string line;
  sm::HelperProcess helper(
    [&line](char, const sm::Bytes& content) { line.assign(content.begin(), content.end()); });
  helper.Fork(
    [&](int descriptor)
    {
      const ProcessorTime watch;
      const std::string results = Run(path, mode);
      char seconds[40];
      std::snprintf(seconds, sizeof(seconds), "%7.2f s ", watch.GetSeconds());
      const std::string text = seconds + results;
      sm::SendMessage(descriptor, 'l', text.data(), text.size());
    });
  while (helper.IsRunning())
  {
    sm::HelperProcess::Wait({ &helper }, 1.0);
  }
  std::printf("%-8s %s, %.1f MB at most\n", mode.c_str(), line.c_str(), helper.GetEnd().PeakMegabytes);
  std::fflush(stdout);
  const std::size_t at = line.find("volume");
  return at == std::string::npos ? std::string() : line.substr(at);
}

int Run(int instances, const std::string& folder)
{
  const std::string path = folder + "/instances.step";
  std::ofstream(path, std::ios::binary) << MakeAssembly(instances, Placing::InOrder).Text;
  const std::string need = Measure(path, "need");
  const std::string always = Measure(path, "always");
  Measure(path, "coarse");
  Measure(path, "refined");
  std::remove(path.c_str());
  const bool isSame = !need.empty() && need == always;
  std::printf(isSame ? "the same bits\n" : "different results\n");
  return isSame ? 0 : 1;
}

void Add(CLI::App& app, int& status)
{
  static int instances = 0;
  static std::string folder = ".";
  CLI::App* command = app.add_subcommand("instances",
    "What instances of one solid cost, each line in a process of its own, with the seconds of its processor "
    "and its "
    "peak memory: mass properties alone (need), with a mesh (always), and a reader for a view, with its "
    "coarse mesh "
    "above 100,000 triangles, and refined. Exit status 1: the volumes differ");
  command->add_option("NUMBER", instances, "instances of the solid")->required()->check(CLI::PositiveNumber);
  command->add_option("--folder", folder, "folder of the temporary STEP file");
  command->callback([&status]() { status = Run(instances, folder); });
}
const BenchmarkEntry Entry(Add);
}
