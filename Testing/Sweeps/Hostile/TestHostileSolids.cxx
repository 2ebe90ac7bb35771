// TestHostileSolids [--count N] [--first-seed S] [--seed S] [--tolerance T] [--perturbation F]: random exact
// solids, no bound exceeded.
//
// Every solid follows from its seed alone, and so does the tolerance of its batch of 50. `--seed S` runs one
// and prints every comparison. `--perturbation` multiplies every sample of the shaders, to see the sweep
// fail. The truth is that of the very doubles that the library gets, see smHostileShape.h.
#include "smHostileSolid.h"

#include "smMassPropertyNames.h"
#include "smWrongSamples.h"

#include <vtkBoundingBox.h>
#include <vtkDataArray.h>
#include <vtkMassPropertiesGPU.h>
#include <vtkMatrix4x4.h>
#include <vtkNURBSDataSet.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>

namespace
{
namespace names = sm::names;
using smhostile::HostileSolid;
using smhostile::Real;
using smhostile::ReferenceProperties;

constexpr std::uint64_t BatchSize = 50;
// Refinements of a truth: enough for the moments of every family; the area of a patch with a vanishing normal
// is known with fewer digits, and a single solid gets more.
constexpr int MaximumCells = 100;
constexpr int MaximumCellsOfOne = 5000;
// Solids whose exact area is known with a larger relative uncertainty are counted.
constexpr Real PreciseArea = 1e-14L;

// The truth is checked by other formulas for one solid in so many: they take longer than the truth.
constexpr std::uint64_t TruthCheckEvery = 5;

struct Options
{
  std::uint64_t First = 1;
  std::uint64_t Count = 300;
  bool Verbose = false;
  double Tolerance = 0.0;
  double Perturbation = 1.0;
};

struct Summary
{
  int Solids = 0;
  int Bodies = 0;
  long long Checks = 0;
  int Exceeded = 0;
  int BadStatus = 0;
  int Missing = 0;
  int NotMet = 0;
  int AboveTolerance = 0;
  int RoughAreas = 0;
  int BadTruths = 0;
  double FilterSeconds = 0.0;
  double TruthSeconds = 0.0;
  /// Worst |actual - exact| / bound, its seed, and failures per quantity.
  std::map<std::string, std::pair<double, std::uint64_t>> Worst;
  std::map<std::string, int> ExceededOf;
  std::map<std::string, std::pair<int, int>> Families;
};

/// One row of the table against one placed truth.
struct Comparison
{
  const HostileSolid& Solid;
  vtkTable* Table;
  vtkIdType Row;
  double Tolerance;
  bool Verbose;
  Summary& Totals;
  std::string Status;
  bool Failed = false;

  double Get(const std::string& name, int component = 0) const
  {
    auto* array = vtkDataArray::SafeDownCast(this->Table->GetColumnByName(name.c_str()));
    return array ? array->GetComponent(this->Row, component) : std::nan("");
  }

  /// Half the diagonal of the control points' box.
  Real GetRadius() const
  {
    vtkBoundingBox box;
    for (const sm::FacePointer& face : this->Solid.Model->GetFaces())
    {
      for (const std::array<double, 4>& p : face->Surface.ControlPoints)
      {
        box.AddPoint(p[0] / p[3], p[1] / p[3], p[2] / p[3]);
      }
    }
    return 0.5L * box.GetDiagonalLength();
  }

  void Report(
    const char* what, const std::string& name, Real exact, double actual, double bound, Real uncertainty)
  {
    std::printf(
      "%s seed %llu family %s quantity %s exact %.18Lg (to %.1Lg) actual %.17g difference %.3Lg bound "
      "%.3g tolerance "
      "%.0e status %s;%s\n",
      what, static_cast<unsigned long long>(this->Solid.Seed), this->Solid.Family.c_str(), name.c_str(),
      exact, uncertainty, actual, actual - exact, bound, this->Tolerance, this->Status.c_str(),
      this->Solid.Description.c_str());
  }

  /// `scale` > 0: with status ok the bound must be below tolerance * scale.
  template <std::size_t Count>
  void Check(const char* name, const std::array<Real, Count>& exact, Real uncertainty, Real scale)
  {
    const double bound = this->Get(std::string(name) + names::BoundSuffix);
    Real worst = 0;
    int at = 0;
    bool number = true;
    for (std::size_t i = 0; i < Count; ++i)
    {
      const double actual = this->Get(name, static_cast<int>(i));
      if (!std::isfinite(exact[i]))
      {
        // A folded solid may have a negative principal moment, and no radius of gyration: then the value is
        // NaN, too.
        number = number && std::isnan(actual);
        continue;
      }
      number = number && std::isfinite(actual);
      const Real difference = std::abs(actual - exact[i]);
      if (difference > worst)
      {
        worst = difference;
        at = static_cast<int>(i);
      }
    }
    const double actual = this->Get(name, at);
    ++this->Totals.Checks;
    if (!number || !std::isfinite(bound))
    {
      ++this->Totals.Missing;
      this->Failed = true;
      this->Report("MISSING", name, exact[at], actual, bound, uncertainty);
      return;
    }
    const Real beyond = std::max<Real>(0.0L, worst - uncertainty);
    const double ratio = beyond == 0.0L ? 0.0 : static_cast<double>(beyond / bound);
    auto& record = this->Totals.Worst[name];
    if (ratio > record.first)
    {
      record = { ratio, this->Solid.Seed };
    }
    if (!(beyond <= bound))
    {
      ++this->Totals.Exceeded;
      ++this->Totals.ExceededOf[name];
      this->Failed = true;
      this->Report("EXCEEDED", name, exact[at], actual, bound, uncertainty);
    }
    else if (scale > 0 && this->Status == names::StatusOk && !(bound <= this->Tolerance * scale))
    {
      ++this->Totals.AboveTolerance;
      this->Failed = true;
      this->Report("ABOVE-TOLERANCE", name, exact[at], actual, bound, uncertainty);
    }
    else if (this->Verbose)
    {
      this->Report("ok", name, exact[at], actual, bound, uncertainty);
    }
  }

  void Run(const ReferenceProperties& truth)
  {
    auto* status = vtkStringArray::SafeDownCast(this->Table->GetColumnByName(names::Status));
    this->Status = status ? std::string(status->GetValue(this->Row)) : "(missing)";
    ++this->Totals.Bodies;
    if (this->Status == names::StatusToleranceNotMet)
    {
      ++this->Totals.NotMet;
    }
    // A folded solid may have moments that no body has: that is to be said, and its radii have no common
    // bound.
    const auto& principal = truth.Principal.Value;
    const bool isBody = principal[0] >= 0 && principal[2] <= principal[0] + principal[1];
    if (this->Status != (isBody ? names::StatusOk : names::StatusSuspect) &&
      this->Status != names::StatusToleranceNotMet)
    {
      ++this->Totals.BadStatus;
      this->Failed = true;
      this->Report("STATUS", names::Volume, truth.Volume.Value[0], this->Get(names::Volume),
        this->Get(std::string(names::Volume) + names::BoundSuffix), truth.Volume.Error);
    }
    const Real volume = truth.Volume.Value[0];
    const auto& c = truth.Center.Value;
    const Real length = std::max(
      { std::cbrt(volume), this->GetRadius(), 1e-6L * std::sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]) });
    const auto& i = truth.Inertia.Value;
    this->Totals.RoughAreas += truth.Area.Error <= PreciseArea * truth.Area.Value[0] ? 0 : 1;
    // The library takes its scales from its own values, which are off by up to the tolerance.
    const Real slack = 1.0L + 1e-3L;
    this->Check(names::Volume, truth.Volume.Value, truth.Volume.Error, slack * volume);
    this->Check(names::SurfaceArea, truth.Area.Value, truth.Area.Error, slack * truth.Area.Value[0]);
    this->Check(names::CenterOfMass, truth.Center.Value, truth.Center.Error, slack * length);
    this->Check(names::FirstMoments, truth.First.Value, truth.First.Error, 0.0L);
    this->Check(names::SecondMoments, truth.Second.Value, truth.Second.Error, 0.0L);
    this->Check(names::VolumeInertia, i, truth.Inertia.Error, slack * (i[0] + i[4] + i[8]));
    this->Check(names::VolumeInertiaAtOrigin, truth.InertiaAtOrigin.Value, truth.InertiaAtOrigin.Error, 0.0L);
    this->Check(names::PrincipalMoments, truth.Principal.Value, truth.Principal.Error, 0.0L);
    if (isBody)
    {
      this->Check(names::RadiiOfGyration, truth.Gyration.Value, truth.Gyration.Error, 0.0L);
    }
  }
};

double Now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double ChooseTolerance(std::uint64_t batch)
{
  const double tolerances[] = { 1e-9, 1e-4, 1e-12, 1e-6 };
  return tolerances[batch % 4];
}

void RunBatch(vtkMassPropertiesGPU* mass, const std::vector<HostileSolid>& solids, double tolerance,
  bool verbose, Summary& summary)
{
  vtkNew<vtkPartitionedDataSetCollection> collection;
  unsigned int leaves = 0;
  for (const HostileSolid& solid : solids)
  {
    for (const std::array<double, 16>& placement : solid.Placements)
    {
      vtkNew<vtkNURBSDataSet> leaf;
      leaf->SetModel(solid.Model);
      vtkNew<vtkMatrix4x4> matrix;
      matrix->DeepCopy(placement.data());
      leaf->SetPlacement(matrix);
      collection->SetPartition(leaves++, 0, leaf);
    }
  }
  const double start = Now();
  mass->SetRelativeTolerance(tolerance);
  mass->SetInputDataObject(collection);
  mass->Update();
  summary.FilterSeconds += Now() - start;
  auto* table = vtkTable::SafeDownCast(mass->GetOutputDataObject(1));
  if (!table || table->GetNumberOfRows() != leaves)
  {
    std::printf("ROWS expected %u actual %lld: %s\n", leaves,
      static_cast<long long>(table ? table->GetNumberOfRows() : -1), mass->GetStatus().c_str());
    ++summary.Missing;
    return;
  }
  vtkIdType row = 0;
  for (const HostileSolid& solid : solids)
  {
    ++summary.Solids;
    bool failed = false;
    // Both sides are off by the stated error at most.
    if (!(solid.TruthDisagreement <= 2.0L))
    {
      ++summary.BadTruths;
      failed = true;
      std::printf("TRUTH seed %llu family %s: two formulas differ by %.3Lg of the stated error\n",
        static_cast<unsigned long long>(solid.Seed), solid.Family.c_str(), solid.TruthDisagreement);
    }
    for (const std::array<double, 16>& placement : solid.Placements)
    {
      const ReferenceProperties truth =
        smhostile::PlaceReference(solid.Truth, solid.Model->GetOrigin(), placement.data());
      Comparison comparison{ solid, table, row++, tolerance, verbose, summary, "", false };
      comparison.Run(truth);
      failed = failed || comparison.Failed;
    }
    auto& family = summary.Families[solid.Family];
    ++family.first;
    family.second += failed ? 1 : 0;
  }
  for (int i = 0; verbose && i < mass->GetNumberOfMessages(); ++i)
  {
    std::printf("message: %s\n", mass->GetMessage(i).c_str());
  }
}

bool Print(const Summary& s)
{
  std::printf("\nworst difference / bound, its seed, times exceeded:\n");
  for (const auto& [name, record] : s.Worst)
  {
    const auto exceeded = s.ExceededOf.find(name);
    std::printf("  %-24s %9.3g  seed %-8llu %d\n", name.c_str(), record.first,
      static_cast<unsigned long long>(record.second), exceeded == s.ExceededOf.end() ? 0 : exceeded->second);
  }
  std::printf("family: solids, with a failure\n");
  for (const auto& [name, counts] : s.Families)
  {
    std::printf("  %-24s %6d %6d\n", name.c_str(), counts.first, counts.second);
  }
  std::printf(
    "%d solids, %d bodies, %lld checks: %d bounds exceeded, %d bounds or values missing, %d bounds above the "
    "tolerance with status ok, %d other statuses, %d wrong truths\n",
    s.Solids, s.Bodies, s.Checks, s.Exceeded, s.Missing, s.AboveTolerance, s.BadStatus, s.BadTruths);
  std::printf("%d bodies ended tolerance-not-met; %d areas known to less than 1e-14; %.1f s in the filter, "
              "%.1f s in the truth\n",
    s.NotMet, s.RoughAreas, s.FilterSeconds, s.TruthSeconds);
  return s.Checks > 0 && s.Exceeded + s.Missing + s.AboveTolerance + s.BadStatus + s.BadTruths == 0;
}

bool Parse(int argc, char* argv[], Options& options)
{
  for (int i = 1; i + 1 < argc; i += 2)
  {
    if (std::strcmp(argv[i], "--count") == 0)
    {
      options.Count = std::strtoull(argv[i + 1], nullptr, 10);
    }
    else if (std::strcmp(argv[i], "--first-seed") == 0)
    {
      options.First = std::strtoull(argv[i + 1], nullptr, 10);
    }
    else if (std::strcmp(argv[i], "--seed") == 0)
    {
      options.First = std::strtoull(argv[i + 1], nullptr, 10);
      options.Count = 1;
      options.Verbose = true;
    }
    else if (std::strcmp(argv[i], "--tolerance") == 0)
    {
      options.Tolerance = std::strtod(argv[i + 1], nullptr);
    }
    else if (std::strcmp(argv[i], "--perturbation") == 0)
    {
      options.Perturbation = std::strtod(argv[i + 1], nullptr);
    }
    else
    {
      return false;
    }
  }
  return argc % 2 == 1;
}
}

int main(int argc, char* argv[])
{
  Options options;
  if (!Parse(argc, argv, options))
  {
    std::fprintf(stderr,
      "usage: TestHostileSolids [--count N] [--first-seed S] [--seed S] [--tolerance T] "
      "[--perturbation F]\n");
    return EXIT_FAILURE;
  }
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  vtkObject::GlobalWarningDisplayOff();
  vtkNew<vtkMassPropertiesGPU> mass;
  // Edges lie off their faces on purpose.
  mass->SetGapLimit(1.0);
  const smtest::WrongSamples wrong(mass, options.Perturbation);
  Summary summary;
  std::vector<HostileSolid> batch;
  const std::uint64_t end = options.First + options.Count;
  for (std::uint64_t seed = options.First; seed < end; ++seed)
  {
    const double start = Now();
    batch.push_back(smhostile::MakeHostileSolid(seed, options.Verbose ? MaximumCellsOfOne : MaximumCells,
      options.Verbose || seed % TruthCheckEvery == 0));
    summary.TruthSeconds += Now() - start;
    if (seed + 1 == end || (seed + 1) % BatchSize == 0)
    {
      const double tolerance =
        options.Tolerance > 0.0 ? options.Tolerance : ChooseTolerance(seed / BatchSize);
      RunBatch(mass, batch, tolerance, options.Verbose, summary);
      batch.clear();
      if (options.Count > 1)
      {
        std::printf("seeds up to %llu at tolerance %.0e: %d bounds exceeded so far, %.1f s\n",
          static_cast<unsigned long long>(seed), tolerance, summary.Exceeded, summary.FilterSeconds);
      }
    }
  }
  return Print(summary) ? EXIT_SUCCESS : EXIT_FAILURE;
}
