// Benchmark variants [FILE.step]: variants a second as polynomials and at frozen points, and full updates.
#include "smBenchmark.h"
#include "smComputeMassProperties.h"
#include "smEditSession.h"
#include "smFreeFormBody.h"
#include "smModelEdit.h"
#include "smRates.h"
#include "smVariantIntegrator.h"

#include <vtkPartitionedDataSetCollection.h>
#include <vtkSMPTools.h>
#include <vtkSTEPReader.h>
#include <vtkTrimmedNURBSModel.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

namespace
{
using namespace smtest;

struct VariantBenchmark
{
  std::string Path;
  int Directions = 10;
  int Checks = 1000;
  double Seconds = 1.0;
  bool UsesOpenGL = false;

  int Run() const;
  std::shared_ptr<const sm::VariantShape> MakeShape(vtkTrimmedNURBSModel* model) const;
  void Measure(
    const std::string& title, const sm::VariantIntegrator& variants, double range, double updates) const;
  bool Check(const sm::VariantIntegrator& variants, const sm::VariantShape& shape, double range) const;
  std::vector<double> MakeNumbers(std::size_t count, double range) const;
};

double GetSeconds(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

vtkSmartPointer<vtkNURBSDataSet> ReadPart(const std::string& path)
{
  if (path.empty())
  {
    return FreeFormBody().Make();
  }
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  auto* product = vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(0));
  return product && product->GetNumberOfPartitionedDataSets() > 0
    ? vtkNURBSDataSet::SafeDownCast(product->GetPartition(0, 0))
    : nullptr;
}

/// One control point for each direction, of faces in the order of their numbers of control points, with what
/// is tied to it.
std::shared_ptr<const sm::VariantShape> VariantBenchmark::MakeShape(vtkTrimmedNURBSModel* model) const
{
  const std::vector<sm::FacePointer>& faces = model->GetFaces();
  std::vector<int> order(faces.size());
  for (std::size_t f = 0; f < order.size(); ++f)
  {
    order[f] = static_cast<int>(f);
  }
  std::stable_sort(order.begin(), order.end(),
    [&](int a, int b)
    { return faces[a]->Surface.ControlPoints.size() > faces[b]->Surface.ControlPoints.size(); });
  std::vector<sm::MovedModel> moved;
  for (int k = 0; k < this->Directions; ++k)
  {
    const int face = order[static_cast<std::size_t>(k) % order.size()];
    const int* count = faces[face]->Surface.NumberOfControlPoints;
    const sm::ControlPointIndex index{ (k + 1) % count[0], (k / 2 + 1) % count[1] };
    const sm::ModelEdit edit =
      sm::MoveControlPoints(model, face, { index }, { 0.3, 0.5, 1.0 }, sm::EditRule::MoveSharedBoundary);
    moved.push_back({ edit.Model, 1.0 });
  }
  std::string error;
  const auto shape = sm::VariantShape::Make(model, moved, error);
  if (!shape)
  {
    std::fprintf(stderr, "%s\n", error.c_str());
  }
  return shape;
}

std::vector<double> VariantBenchmark::MakeNumbers(std::size_t count, double range) const
{
  std::mt19937 random(3);
  std::vector<double> c(count * static_cast<std::size_t>(this->Directions));
  for (double& number : c)
  {
    number = std::uniform_real_distribution<double>(-range, range)(random);
  }
  return c;
}

/// A mode of evaluation: values, with bounds, with gradients.
void Evaluate(const sm::VariantIntegrator& variants, int mode, const std::vector<double>& c,
  std::size_t count, std::vector<double>& results)
{
  const std::size_t size = 10 * count;
  results.resize(size * (2 + (mode == 2 ? static_cast<std::size_t>(variants.GetNumberOfDirections()) : 0)));
  double* const bounds = mode > 0 ? results.data() + size : nullptr;
  variants.Evaluate(c.data(), count, results.data(), bounds, mode == 2 ? results.data() + 2 * size : nullptr);
}

/// Prints rows of values alone, with bounds, and with gradients. On a device a call gets so many variants
/// that it takes a fifth of a second, or a million.
void VariantBenchmark::Measure(
  const std::string& title, const sm::VariantIntegrator& variants, double range, double updates) const
{
  std::vector<double> results;
  for (int mode = 0; mode < (variants.GetPolynomial() ? 3 : 2); ++mode)
  {
    std::size_t count = variants.GetPolynomial() ? 16384 : 512;
    std::vector<double> c = this->MakeNumbers(count, range);
    const bool isOnDevice = variants.GetBackend() == sm::BackendChoice::OpenGL;
    for (double seconds = 0.0; isOnDevice && seconds < 0.2 && count < 1000000;)
    {
      count *= 2;
      c = this->MakeNumbers(count, range);
      const auto begin = std::chrono::steady_clock::now();
      Evaluate(variants, mode, c, count, results);
      seconds = GetSeconds(begin);
    }
    const char* const names[] = { "values", "values, bounds", "values, bounds, gradients" };
    const std::string name = title + ", " + names[mode];
    const double rate = static_cast<double>(count) *
      MeasureRate(name, this->Seconds, [&]() { Evaluate(variants, mode, c, count, results); });
    std::printf("| %s | %.0f | %.1f |\n", name.c_str(), rate, rate / updates);
  }
  std::fflush(stdout);
}

/// Compares variants with the mass properties of their models; returns false if one is outside both bounds.
bool VariantBenchmark::Check(
  const sm::VariantIntegrator& variants, const sm::VariantShape& shape, double range) const
{
  const auto count = static_cast<std::size_t>(this->Checks);
  const std::vector<double> c = this->MakeNumbers(count, range);
  std::vector<double> values(10 * count);
  std::vector<double> bounds(values.size());
  variants.Evaluate(c.data(), count, values.data(), bounds.data());
  int outside = 0;
  double ratio = 0.0;
  for (std::size_t t = 0; t < count; ++t)
  {
    vtkNew<vtkNURBSDataSet> leaf;
    leaf->SetModel(shape.MakeModel(c.data() + t * static_cast<std::size_t>(this->Directions)));
    const sm::BodyMassProperties full = sm::ComputeMassProperties(leaf).Total;
    const sm::VariantProperties own =
      sm::DeriveProperties(values.data() + 10 * t, bounds.data() + 10 * t, variants.GetReference());
    bool isInside = std::abs(own.Volume - full.Volume.Value) <= own.VolumeBound + full.Volume.Bound;
    for (int i = 0; i < 9; ++i)
    {
      isInside =
        isInside && std::abs(own.Inertia[i] - full.Inertia.Value[i]) <= own.InertiaBound + full.Inertia.Bound;
      isInside = isInside &&
        (i > 2 || std::abs(own.Center[i] - full.Center.Value[i]) <= own.CenterBound + full.Center.Bound);
    }
    outside += isInside ? 0 : 1;
    ratio = std::max(ratio, own.VolumeBound / full.Volume.Bound);
  }
  std::printf(
    "%zu variants compared with their own models, %d outside both bounds; the volume's bound is up to %.2g "
    "times that of the full path\n",
    count, outside, ratio);
  return outside == 0;
}

int VariantBenchmark::Run() const
{
  // One thread.
  vtkSMPTools::SetBackend("Sequential");
  const vtkSmartPointer<vtkNURBSDataSet> leaf = ReadPart(this->Path);
  if (!leaf || !leaf->GetModel())
  {
    std::fprintf(stderr, "%s holds no solid.\n", this->Path.c_str());
    return 1;
  }
  const auto shape = this->MakeShape(leaf->GetModel());
  if (!shape)
  {
    return 1;
  }
  const double* box = leaf->GetModel()->GetLocalBounds();
  const double range = 0.005 * std::hypot(box[1] - box[0], box[3] - box[2], box[5] - box[4]);
  EditSession session(leaf, vtkMassPropertiesGPU::CPU, 1e-9);
  session.Update(EditKind::FullRun, 0);
  int updates = 0;
  double evaluating = 0.0;
  const double rate = MeasureRate("full update", this->Seconds,
    [&]() { evaluating += session.Update(EditKind::FullRun, ++updates).Integrate; });
  std::printf(
    "%d faces, %d directions, one thread, measured by %s\n\n| one variant | a second | times a full update "
    "|\n|---|---|---|\n"
    "| full update | %.1f | 1 |\n| full update, its evaluation without cutting and planning | %.0f | %.1f "
    "|\n",
    static_cast<int>(leaf->GetModel()->GetNumberOfFaces()), this->Directions, GetRateMethod(), rate,
    updates / evaluating, updates / evaluating / rate);
  sm::VariantOptions options;
  options.Ranges.assign(static_cast<std::size_t>(this->Directions), range);
  bool isGood = true;
  std::string notes;
  std::vector<std::shared_ptr<const sm::VariantIntegrator>> all;
  for (const sm::VariantMethod method : { sm::VariantMethod::Points, sm::VariantMethod::Polynomial })
  {
    std::string error;
    const auto variants = sm::VariantIntegrator::Make(shape, options, error,
      { method, this->UsesOpenGL ? sm::BackendChoice::OpenGL : sm::BackendChoice::CPU });
    if (!variants)
    {
      std::fprintf(stderr, "%s\n", error.c_str());
      return 1;
    }
    all.push_back(variants);
    this->Measure(
      method == sm::VariantMethod::Points ? "frozen points" : "polynomials", *variants, range, rate);
  }
  std::printf("\n");
  for (const auto& variants : all)
  {
    std::printf("%s by %s: %s\n", variants->GetPolynomial() ? "polynomials" : "frozen points",
      variants->GetBackend() == sm::BackendChoice::OpenGL ? "OpenGL" : "the CPU",
      variants->GetReason().c_str());
    if (!variants->GetPolynomial())
    {
      std::printf("%lld samples for each variant; ", static_cast<long long>(variants->GetNumberOfSamples()));
    }
    isGood = this->Check(*variants, *shape, range) && isGood;
  }
  return isGood ? 0 : 1;
}

void Add(CLI::App& app, int& status)
{
  static VariantBenchmark benchmark;
  CLI::App* command = app.add_subcommand("variants",
    "Variants a second of a solid whose control points move along directions: as polynomials, at frozen "
    "points, "
    "and full updates, all on one thread. Variants are compared with the mass properties of their models. "
    "Without a file the solid is a free-form one of 42 faces. Exit status 1: a variant is outside both "
    "bounds");
  command->add_option("FILE", benchmark.Path, "STEP file, of which the first solid is taken");
  command->add_option("--directions", benchmark.Directions, "Number of directions, 1 to 24")
    ->check(CLI::Range(1, 24));
  command->add_option("--checks", benchmark.Checks, "Number of variants to compare")
    ->check(CLI::Range(1, 100000));
  command
    ->add_option_function<std::string>(
      "--backend", [](const std::string& name) { benchmark.UsesOpenGL = name == "opengl"; },
      "The device that evaluates variants: cpu (default) or opengl")
    ->check(CLI::IsMember({ "cpu", "opengl" }));
  command->add_option("--seconds", benchmark.Seconds, "Seconds of each row")->check(CLI::Range(0.0, 100.0));
  command->callback([&status]() { status = benchmark.Run(); });
}
const BenchmarkEntry Entry(Add);
}
