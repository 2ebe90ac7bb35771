// Benchmark speed [--balls N]... FILE.step...: seconds of the processor from file to numbers, compared with
// OpenCASCADE's, in one run.
//
// Per file: OpenCASCADE's default reader (parse, transfer); its BRepGProp, volume and area, by its default
// rule and with Eps = 1e-6; our reader and our mass properties on the CPU backend at a tolerance of 1e-9, by
// stages. One thread computes, and seconds are those of the process's processor time, so that other work on
// the machine hardly matters. The references of evaluations a second are the kernel by itself, on bicubic
// panels of 20 x 20 points that stay in the cache: with as many lanes as the processor has, and as a plain
// kernel with the two doubles of SSE2, for which compilers make code by default. Peak memory is the process's
// up to the end of a file.
#include "Items/smBatchParameters.h"
#include "Items/smItemKernels.h"
#include "smBenchmark.h"
#include "smJson.h"
#include "smProcessorTime.h"
#include "smScaleModels.h"
#include "smStageSeconds.h"

#include <vtkSMPTools.h>

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS_Shape.hxx>

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

namespace
{
using sm::Json;
using smtest::ProcessorTime;

/// The columns of the table.
const std::vector<std::string> Columns = []
{
  std::vector<std::string> columns = { "occt_parse", "occt_transfer", "occt_gprop", "occt_gprop_1e-6" };
  columns.insert(columns.end(), smtest::GetStageNames().begin(), smtest::GetStageNames().end());
  return columns;
}();

void MeasureKernel(const TopoDS_Shape& shape, bool adaptive, Json& seconds, Json& result)
{
  const char* name = adaptive ? "occt_gprop_1e-6" : "occt_gprop";
  const ProcessorTime watch;
  GProp_GProps volume;
  GProp_GProps area;
  if (adaptive)
  {
    BRepGProp::VolumeProperties(shape, volume, 1e-6);
    BRepGProp::SurfaceProperties(shape, area, 1e-6);
  }
  else
  {
    BRepGProp::VolumeProperties(shape, volume);
    BRepGProp::SurfaceProperties(shape, area);
  }
  seconds[name] = watch.GetSeconds();
  result[std::string(name) + "_volume"] = volume.Mass();
}

void MeasureOpenCASCADE(const std::string& path, bool onlyRead, Json& seconds, Json& result)
{
  STEPControl_Reader reader;
  const ProcessorTime parse;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
  {
    return;
  }
  seconds["occt_parse"] = parse.GetSeconds();
  const ProcessorTime transfer;
  reader.TransferRoots();
  const TopoDS_Shape shape = reader.OneShape();
  seconds["occt_transfer"] = transfer.GetSeconds();
  if (!onlyRead)
  {
    MeasureKernel(shape, false, seconds, result);
    MeasureKernel(shape, true, seconds, result);
  }
}

double GetPeakMegabytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// A gently curved bicubic patch with a straight trim piece across it.
sm::FacePanels MakeBicubicFace()
{
  sm::FacePanels face;
  face.Patches.push_back(
    { { 0.0, 0.0, 0.0 }, 2.0, { 0.0, 0.0 }, { 1.0, 1.0 }, 0, { 3, 3 }, { 3.0, 3.0 }, {}, {}, 1.0 });
  for (int j = 0; j < 4; ++j)
  {
    for (int i = 0; i < 4; ++i)
    {
      const double w = 1.0 + 0.05 * i * j;
      face.Points.push_back({ w * (i - 1.5), w * (j - 1.5), w * 0.1 * i * (3 - j), w });
    }
  }
  face.Coefficients = { 0.9, 0.1, 0.8, 0.9 };
  face.Panels.push_back({ 0, 0, 1, sm::PanelShape::General, false, false, 0.0, 1.0 });
  return face;
}

/// The doubles side by side that every x86-64 processor has.
constexpr int PlainLanes = 2;

/// Evaluations a second of the kernel alone: with as many lanes as it has, and with PlainLanes.
struct KernelRates
{
  double Widest;
  double Plain;
};

/// Returns how many points a second the kernel alone evaluates, with the ten moments and the area.
double MeasureArithmetic(int lanes)
{
  sm::ItemRunner::Setup setup;
  for (const auto& [i, j, k] : std::vector<std::array<int, 3>>{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 },
         { 0, 0, 1 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 }, { 1, 1, 0 }, { 0, 1, 1 }, { 1, 0, 1 } })
  {
    setup.Integrands.push_back(sm::Integrand::VolumeMoment("m", i, j, k));
  }
  setup.Integrands.push_back(sm::Integrand::AreaMoment("A", 0, 0, 0));
  const sm::RowLayout layout(setup.Integrands);
  const sm::BatchParameters parameters(
    { { 0, std::vector<double>(setup.Integrands.size(), 0.0), {} } }, false);
  const sm::SampleFormulas formulas(setup.Integrands, layout);
  std::vector<double> row(layout.GetStride());
  const sm::KernelData data = { &setup, &layout, &formulas, parameters.Values.data(),
    parameters.ToleranceOffset, parameters.PlacementOffset, row.data() };
  sm::CutFace cut;
  cut.Panels = MakeBicubicFace();
  cut.Degree[0] = cut.Degree[1] = 3;
  sm::WorkItems items;
  sm::AddItems(cut, 0, items);
  sm::SetItemOrders(items[0], { 20, 20, true, true }, false);
  const std::vector<sm::KernelItem> together(lanes, { &cut.Panels, &items[0] });
  std::vector<sm::KernelResult> results(lanes);
  sm::KernelScratch scratch(layout);
  // The best of some tries: other work on the machine takes the processor's caches, and its clock.
  double best = 0.0;
  for (int i = 0; i < 10; ++i)
  {
    const ProcessorTime watch;
    double evaluations = 0.0;
    while (watch.GetSeconds() < 0.05)
    {
      sm::EvaluateItems(data, together.data(), lanes, lanes, scratch, results.data());
      evaluations += 400.0 * lanes;
    }
    best = std::max(best, evaluations / watch.GetSeconds());
  }
  return best;
}

/// Returns true if both measured the same: only then times can be compared.
bool IsSame(const Json& file)
{
  const double expected = file.value("occt_gprop_1e-6_volume", std::nan(""));
  const double volume = file.value("volume", std::nan(""));
  // The volume is NaN for surfaces, and for files that one of the programs cannot read.
  return !std::isfinite(volume) || !std::isfinite(expected) ||
    std::abs(volume - expected) <= 1e-3 * std::abs(expected);
}

double Get(const Json& seconds, const std::string& name)
{
  return seconds.contains(name) ? seconds[name].get<double>() : std::nan("");
}

void PrintRow(const std::string& name, const Json& seconds, double evaluations, const KernelRates& kernel)
{
  std::printf("| %s |", name.c_str());
  for (const std::string& column : Columns)
  {
    std::printf(" %.3f |", Get(seconds, column));
  }
  const double rate = evaluations / Get(seconds, "integrate");
  std::printf(" %.1f | %.2f | %.2f |\n", 1e-6 * rate, rate / kernel.Widest, rate / kernel.Plain);
}

struct Options
{
  std::vector<std::string> Files;
  /// Numbers of balls of files that are written.
  std::vector<int> Balls;
  std::string Folder = ".";
  std::string Json;
  bool OnlyRead = false;
  bool OnlyOurs = false;
  int Repeats = 1;
};

Json MeasureFile(const std::string& path, const Options& options)
{
  Json result = { { "file", path.substr(path.rfind('/') + 1) } };
  Json seconds = Json::object();
  try
  {
    if (!options.OnlyOurs)
    {
      MeasureOpenCASCADE(path, options.OnlyRead, seconds, result);
    }
  }
  catch (const Standard_Failure& failure)
  {
    result["occt_error"] = failure.GetMessageString();
  }
  smtest::MeasureStages(path, options.OnlyRead ? 0 : options.Repeats, seconds, result);
  result["seconds"] = seconds;
  result["peak_megabytes"] = GetPeakMegabytes();
  return result;
}

/// Returns the seconds of our reading and converting over those of OpenCASCADE's reader.
double GetReadRatio(const Json& seconds)
{
  return (Get(seconds, "parse") + Get(seconds, "transfer") + Get(seconds, "trims") +
           Get(seconds, "convert")) /
    (Get(seconds, "occt_parse") + Get(seconds, "occt_transfer"));
}

/// The sums over all files that OpenCASCADE reads, too, and the ratios that matter.
Json AddUp(const Json& all, bool onlyOurs)
{
  Json files = Json::array();
  for (const Json& file : all)
  {
    if (onlyOurs || file["seconds"].contains("occt_parse"))
    {
      files.push_back(file);
    }
  }
  Json sum = { { "files", files.size() }, { "seconds", Json::object() }, { "evaluations", 0 } };
  for (const std::string& column : Columns)
  {
    double total = 0.0;
    for (const Json& file : files)
    {
      const double seconds = Get(file["seconds"], column);
      total += std::isfinite(seconds) ? seconds : 0.0;
    }
    sum["seconds"][column] = total;
  }
  for (const Json& file : files)
  {
    sum["evaluations"] =
      sum["evaluations"].get<std::int64_t>() + file.value("evaluations", std::int64_t{ 0 });
  }
  const Json s = sum["seconds"];
  const double properties = Get(s, "occt_gprop");
  const double prepare = Get(s, "cut") + Get(s, "plan") + Get(s, "upload");
  sum["prepare_and_integrate_over_gprop"] = (prepare + Get(s, "integrate")) / properties;
  sum["integrate_over_gprop"] = Get(s, "integrate") / properties;
  sum["read_over_occt"] = GetReadRatio(s);
  sum["worst_read_over_occt"] = 0.0;
  for (const Json& file : files)
  {
    const double ratio = GetReadRatio(file["seconds"]);
    if (file["faces"].get<int>() > 100 && ratio > sum["worst_read_over_occt"].get<double>())
    {
      sum["worst_read_over_occt"] = ratio;
      sum["worst_read"] = file["file"];
    }
  }
  return sum;
}

int Run(const Options& options)
{
  // Until here the process has only loaded its libraries, ours and OpenCASCADE's.
  const double processStart = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  Message::DefaultMessenger()->ChangePrinters().Clear();
  vtkSMPTools::SetBackend("Sequential");
  const int lanes = sm::GetLaneCounts().back();
  const KernelRates kernel = { MeasureArithmetic(lanes), MeasureArithmetic(PlainLanes) };
  std::printf("process start: %.3f s; million evaluations a second by the kernel alone: %.1f with %d lanes, "
              "%.1f with %d\n\n| file |",
    processStart, 1e-6 * kernel.Widest, lanes, 1e-6 * kernel.Plain, PlainLanes);
  for (const std::string& column : Columns)
  {
    std::printf(" %s |", column.c_str());
  }
  std::printf(" Mevaluations/s | of the kernel's | of the plain kernel's |\n|---|");
  for (std::size_t i = 0; i < Columns.size() + 3; ++i)
  {
    std::printf("---|");
  }
  std::printf("\n");
  Json document = { { "process_start", processStart }, { "lanes", lanes },
    { "kernel_evaluations_per_second", kernel.Widest },
    { "plain_kernel_evaluations_per_second", kernel.Plain }, { "files", Json::array() } };
  bool same = true;
  std::vector<std::string> paths = options.Files;
  for (const int balls : options.Balls)
  {
    paths.push_back(options.Folder + "/balls_" + std::to_string(balls) + ".step");
    std::ofstream(paths.back(), std::ios::binary) << smtest::MakeBalls(balls).Text;
  }
  for (const std::string& path : paths)
  {
    document["files"].push_back(MeasureFile(path, options));
    const Json& file = document["files"].back();
    PrintRow(file["file"], file["seconds"], file.value("evaluations", std::int64_t{ 0 }), kernel);
    std::fflush(stdout);
    if (!IsSame(file))
    {
      std::fprintf(stderr, "%s: another volume than OpenCASCADE's\n", path.c_str());
      same = false;
    }
  }
  std::for_each(paths.begin() + static_cast<std::ptrdiff_t>(options.Files.size()), paths.end(),
    [](const std::string& path) { std::remove(path.c_str()); });
  document["sum"] = AddUp(document["files"], options.OnlyOurs);
  const Json& sum = document["sum"];
  const auto summed = sum["files"].get<std::size_t>();
  PrintRow(summed < paths.size() ? "sum of those that OpenCASCADE reads" : "sum", sum["seconds"],
    sum["evaluations"], kernel);
  std::printf(
    "\ncut, plan, upload and integrate over BRepGProp: %.2f; integrate alone: %.2f; read and convert over "
    "OpenCASCADE's reader: %.2f, at most %.2f on files of more than 100 faces; peak %.0f MB\n",
    sum["prepare_and_integrate_over_gprop"].get<double>(), sum["integrate_over_gprop"].get<double>(),
    sum["read_over_occt"].get<double>(), sum["worst_read_over_occt"].get<double>(), GetPeakMegabytes());
  if (!options.Json.empty())
  {
    std::ofstream file(options.Json);
    file << document.dump(1) << "\n";
    file.close();
    same = same && file;
  }
  return same ? 0 : 1;
}

void Add(CLI::App& app, int& status)
{
  static Options options;
  CLI::App* command = app.add_subcommand("speed",
    "Seconds of the processor from file to numbers, compared with OpenCASCADE's. Exit status 1: a volume is "
    "not "
    "OpenCASCADE's to a thousandth");
  command->add_option("FILE", options.Files, "STEP files");
  command
    ->add_option("--balls", options.Balls,
      "a file with so many balls, a square number, in addition; may be given several times")
    ->check(CLI::PositiveNumber)
    ->allow_extra_args(false);
  command->add_option("--folder", options.Folder, "folder of the temporary STEP files");
  command->add_option("--json", options.Json, "file for the numbers");
  command->add_flag("--read", options.OnlyRead, "reading alone");
  command->add_flag("--ours", options.OnlyOurs, "without OpenCASCADE");
  command
    ->add_option(
      "--repeat", options.Repeats, "runs of the integrals, of which the minimum of the seconds counts")
    ->check(CLI::PositiveNumber);
  command->callback([&status]() { status = Run(options); });
}
const smtest::BenchmarkEntry Entry(Add);
}
