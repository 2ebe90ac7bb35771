// Benchmark scale: how time and memory grow with a model.
//
// Plates of 900, 3,600, 10,000 and 30,000 holes, lattices of 9,000 to 100,000 different faces, 196, 784 and
// 3,136 balls, assemblies of 900, 3,600 and 10,000 instances (smScaleModels.h). Each is written as a STEP
// file, read, and integrated to 1e-9 on the CPU backend in a process of its own, by one thread. Printed are
// the processor's seconds of every stage, the growth exponents from each model of a family to the next and
// from the smallest to the largest, log(time ratio) / log(size ratio), and the growth of the peak memory per
// face or instance.
#include "smAllocatedBytes.h"
#include "smBenchmark.h"
#include "smHelperProcess.h"
#include "smScaleModels.h"
#include "smStageSeconds.h"
#include "smTesting.h"

#include <vtkSMPTools.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace
{
using sm::Json;

struct Family
{
  const char* Name;
  /// The thing that the sizes of the family count.
  const char* Unit;
  std::function<smtest::ScaleModel(int)> Make;
  std::vector<int> Sizes, SmallSizes;
  std::function<double(const smtest::ScaleModel&)> GetSize;
};

double CountFaces(const smtest::ScaleModel& model)
{
  return static_cast<double>(model.Faces);
}

double CountInstances(const smtest::ScaleModel& model)
{
  return static_cast<double>(model.Instances);
}

const std::vector<Family>& GetFamilies()
{
  static const std::vector<Family> families = {
    { "plate", "face", smtest::MakePlate, { 900, 3600, 10000, 30000 }, { 36, 144, 576 }, CountFaces },
    { "lattice", "face", smtest::MakeLattice, { 10, 16, 23 }, { 4, 6, 9 }, CountFaces },
    { "balls", "ball", smtest::MakeBalls, { 196, 784, 3136 }, { 16, 64, 256 }, CountInstances },
    { "assembly", "instance",
      [](int instances) { return smtest::MakeAssembly(instances, smtest::Placing::InOrder); },
      { 900, 3600, 10000 }, { 30, 120, 480 }, CountInstances },
    // This family has small sizes only.
    { "swapped", "instance",
      [](int instances) { return smtest::MakeAssembly(instances, smtest::Placing::Swapped); }, {},
      { 30, 120, 480 }, CountInstances },
    { "alternating", "instance",
      [](int instances) { return smtest::MakeAssembly(instances, smtest::Placing::Alternating); }, {},
      { 30, 120, 480 }, CountInstances },
  };
  return families;
}

/// Relative error of the volume by the number of digits that the file has; the bound of the program includes
/// the part of it that reading adds.
constexpr double FileDigits = 1e-12;

Json MeasureHere(const std::string& path)
{
  Json result = Json::object();
  Json seconds = Json::object();
  vtkSMPTools::SetBackend("Sequential");
  const long long before = smtest::GetAllocatedBytes();
  smtest::MeasureStages(path, 1, seconds, result);
  result["seconds"] = seconds;
  result["allocated_bytes"] = smtest::GetAllocatedBytes() - before;
  return result;
}

/// Measures in a child, so that the peak memory is that of one model.
Json Measure(const std::string& path)
{
  Json result;
  sm::HelperProcess helper(
    [&result](char, const sm::Bytes& content) { result = Json::parse(content, nullptr, false); });
  helper.Fork(
    [&path](int descriptor)
    {
      const std::string text = MeasureHere(path).dump();
      sm::SendMessage(descriptor, 'r', text.data(), text.size());
    });
  while (helper.IsRunning())
  {
    sm::HelperProcess::Wait({ &helper }, 1.0);
  }
  if (result.is_object())
  {
    result["peak_megabytes"] = helper.GetEnd().PeakMegabytes;
  }
  return result;
}

/// Writes a model of the family, measures it, and adds what it should be.
Json MeasureModel(const Family& family, int size, const std::string& folder)
{
  const std::string path = folder + "/scale_" + family.Name + "_" + std::to_string(size) + ".step";
  double volume = 0.0;
  std::array<double, 3> center{};
  double faces = 0.0;
  double counted = 0.0;
  double megabytes = 0.0;
  {
    const smtest::ScaleModel model = family.Make(size);
    std::ofstream(path, std::ios::binary) << model.Text;
    volume = model.Volume;
    center = model.Center;
    faces = static_cast<double>(model.Faces);
    counted = family.GetSize(model);
    megabytes = 1e-6 * static_cast<double>(model.Text.size());
  }
  Json result = Measure(path);
  std::remove(path.c_str());
  if (!result.is_object())
  {
    result = Json::object();
  }
  result["family"] = family.Name;
  result["size"] = counted;
  result["file_megabytes"] = megabytes;
  result["expected_volume"] = volume;
  result["expected_center"] = center;
  result["expected_faces"] = faces;
  return result;
}

bool IsRight(const Json& result)
{
  const double expected = result["expected_volume"];
  const double limit = result.value("volume_bound", std::nan("")) + FileDigits * expected;
  return result.value("status", "") == "ok" &&
    std::abs(result.value("volume", std::nan("")) - expected) <= limit &&
    result.value("faces", 0.0) == result["expected_faces"].get<double>();
}

double GetExponent(double first, double last, double sizeRatio)
{
  return std::log(last / first) / std::log(sizeRatio);
}

/// Prints the growth exponents of all stages between two models of a family, and the memory.
void PrintGrowth(const Family& family, const Json& first, const Json& last)
{
  const double sizes[2] = { first["size"], last["size"] };
  const double ratio = sizes[1] / sizes[0];
  std::printf("| %s | exponent, %.0f to %.0f | |", family.Name, sizes[0], sizes[1]);
  for (const std::string& stage : smtest::GetStageNames())
  {
    std::printf(" %.2f |", GetExponent(first["seconds"][stage], last["seconds"][stage], ratio));
  }
  const double memory =
    last.value("peak_megabytes", std::nan("")) - first.value("peak_megabytes", std::nan(""));
  std::printf(" %.2f | %.1f kB per %s |\n",
    GetExponent(first["seconds"]["all"], last["seconds"]["all"], ratio),
    1024.0 * memory / (sizes[1] - sizes[0]), family.Unit);
  std::fflush(stdout);
}

int PrintTable(const std::string& only, const std::string& folder, const std::string& json)
{
  std::printf("| model | size | MB of text |");
  for (const std::string& stage : smtest::GetStageNames())
  {
    std::printf(" %s |", stage.c_str());
  }
  std::printf(" all | peak MB |\n|---|---|---|");
  for (std::size_t i = 0; i < smtest::GetStageNames().size() + 2; ++i)
  {
    std::printf("---|");
  }
  std::printf("\n");
  Json document = Json::array();
  bool right = true;
  for (const Family& family : GetFamilies())
  {
    if (family.Sizes.empty() || (!only.empty() && only != family.Name))
    {
      continue;
    }
    std::vector<Json> results;
    for (const int size : family.Sizes)
    {
      results.push_back(MeasureModel(family, size, folder));
      Json& result = results.back();
      std::printf("| %s | %.0f %ss | %.1f |", family.Name, result["size"].get<double>(), family.Unit,
        result["file_megabytes"].get<double>());
      double all = 0.0;
      for (const std::string& stage : smtest::GetStageNames())
      {
        const double seconds =
          result.contains("seconds") ? result["seconds"][stage].get<double>() : std::nan("");
        all += seconds;
        std::printf(" %.3f |", seconds);
      }
      result["seconds"]["all"] = all;
      std::printf(" %.3f | %.0f |\n", all, result.value("peak_megabytes", std::nan("")));
      std::fflush(stdout);
      if (!IsRight(result))
      {
        std::fprintf(stderr, "%s: wrong: %s\n", family.Name, result.dump().c_str());
        right = false;
      }
      document.push_back(result);
    }
    for (std::size_t i = 1; i < results.size(); ++i)
    {
      PrintGrowth(family, results[i - 1], results[i]);
    }
    PrintGrowth(family, results.front(), results.back());
  }
  if (!json.empty())
  {
    std::ofstream file(json);
    file << document.dump(1) << "\n";
    right = right && file.good();
  }
  return right ? 0 : 1;
}

/// Triangles that a ball may have for its scales: spheres are measured by formulas.
constexpr double MaxTrianglesOfBall = 100.0;

/// Counts of the small models: `maximum` is how much a count may grow faster than the model, which has a part
/// that does not grow.
int CheckCounts(const std::string& folder)
{
  using namespace smtest;
  for (const Family& family : GetFamilies())
  {
    std::vector<Json> results;
    for (const int size : family.SmallSizes)
    {
      results.push_back(MeasureModel(family, size, folder));
      const Json& result = results.back();
      const std::string name = std::string(family.Name) + " " + std::to_string(size);
      CheckEqual(name + ": status", "ok", result.value("status", "none"));
      Check(name + ": faces", result["expected_faces"], result.value("faces", -1.0), 0.0);
      Check(name + ": volume", result["expected_volume"], result.value("volume", std::nan("")),
        result.value("volume_bound", 0.0) + FileDigits * result["expected_volume"].get<double>(),
        "the bound, and the digits of the file");
      if (std::string(family.Name) == "balls")
      {
        CheckRange(name + ": triangles of a ball", 1.0,
          result.value("triangles", std::nan("")) / result["size"].get<double>(), MaxTrianglesOfBall);
      }
      const Json& center = result["expected_center"];
      const double reach =
        std::hypot(center[0].get<double>(), center[1].get<double>(), center[2].get<double>());
      for (int d = 0; result.contains("center") && d < 3; ++d)
      {
        Check(name + ": centre", center[d], result["center"][d],
          result["center_bound"].get<double>() + FileDigits * reach, "the bound, and the digits of the file");
      }
    }
    for (std::size_t i = 1; i < results.size(); ++i)
    {
      const double ratio = results[i]["size"].get<double>() / results[i - 1]["size"].get<double>();
      for (const char* count : { "evaluations", "triangles", "allocated_bytes" })
      {
        const double before = results[i - 1].value(count, std::nan(""));
        const double after = results[i].value(count, std::nan(""));
        CheckRange(std::string(family.Name) + ": exponent of " + count, 0.0,
          after == before ? 0.0 : GetExponent(before, after, ratio), 1.1, "quadratic is 2");
      }
    }
  }
  return Finish();
}

int Write(const std::string& name, int size)
{
  for (const Family& family : GetFamilies())
  {
    if (name == family.Name && size > 0)
    {
      const std::string text = family.Make(size).Text;
      return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() ? 0 : 1;
    }
  }
  return 1;
}

void Add(CLI::App& app, int& status)
{
  static std::string json;
  static std::string folder = ".";
  static std::string only;
  static std::string counts;
  static std::string written;
  static int size = 0;
  CLI::App* command = app.add_subcommand("scale",
    "How time and memory grow with a model. Exit status 1: a volume is not within its bound and the file's "
    "digits, or "
    "a check of --counts failed");
  command->add_option("--json", json, "file for the numbers");
  command->add_option("--folder", folder, "folder of the temporary STEP files");
  command->add_option("--only", only, "plate, lattice, balls or assembly");
  command->add_option("--counts", counts,
    "folder for small models; checks status, volumes, faces, and that evaluations, triangles and allocated "
    "bytes per "
    "hole, face and instance do not grow");
  command->add_option("--write", written, "writes such a model to the standard output, for a profiler");
  command->add_option("--size", size, "size of the model of --write");
  command->callback(
    [&status]()
    {
      status = !counts.empty() ? CheckCounts(counts)
        : !written.empty()     ? Write(written, size)
                               : PrintTable(only, folder, json);
    });
}
const smtest::BenchmarkEntry Entry(Add);
}
