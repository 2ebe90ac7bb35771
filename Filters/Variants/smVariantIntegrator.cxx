#include "smVariantIntegrator.h"

#include "Detail/smVariantIntegratorInternals.h"
#include "Detail/smVariantKernels.h"
#include "Detail/smVariantPointsWriter.h"
#include "Detail/smVariantScales.h"
#include "Detail/smVariantSums.h"
#include "smFormat.h"
#include "smParallelFor.h"
#include "smUnitRoundoff.h"

#include "vtkSMPTools.h"

#include <cmath>
#include <exception>

namespace sm
{
namespace
{
/// Times of the CPU are measured on one thread; calls use all.
double GetThreads()
{
  return std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads());
}
}

std::string FormatMicroseconds(double seconds)
{
  return FormatDigits(1e6 * seconds, 4) + " us";
}

void VariantIntegrator::Internals::AddFaces(std::vector<VariantFaceChain>& chains, bool isNeededAgain)
{
  const VariantMonomials one(1);
  VariantTotals totals(one);
  const VariantMap map(one, {}, one);
  for (VariantFaceChain& chain : chains)
  {
    PointsErrors errors{ chain.Directions, {} };
    errors.Terms = isNeededAgain ? chain.Errors : std::move(chain.Errors);
    this->Terms += errors.Terms.size();
    if (!chain.Directions.empty())
    {
      this->Samples += CountSamples(chain);
      this->Faces.push_back(WritePoints(chain));
      this->Errors.push_back(std::move(errors));
      continue;
    }
    VariantSums sums(one, map, totals);
    VisitSamples(chain, [&sums](const VariantSample& sample) { sums.Add(sample); });
    sums.Flush();
    AddErrors(errors, { 1.0 }, this->ConstantBound);
  }
  for (int m = 0; m < NumberOfMoments; ++m)
  {
    this->Constant[m] = totals.Get(m, 0);
  }
}

void VariantIntegrator::Internals::EvaluatePoints(
  const double* c, std::size_t n, double* values, double* bounds) const
{
  const std::size_t lanes = GetVariantLanes();
  const std::size_t directions = this->GetDirections();
  ParallelFor((n + lanes - 1) / lanes, 8,
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<double> sums(NumberOfMoments * lanes);
      std::vector<double> carries(sums.size());
      std::vector<double> scratch;
      std::vector<double> sizes;
      for (std::size_t batch = begin; batch < end; ++batch)
      {
        const std::size_t first = batch * lanes;
        const std::size_t count = std::min(lanes, n - first);
        for (std::size_t i = 0; i < sums.size(); ++i)
        {
          sums[i] = this->Constant[i / lanes];
          carries[i] = 0.0;
        }
        for (const PointsFace& face : this->Faces)
        {
          AddPoints(face, c + first * directions, directions, count, sums.data(), carries.data(), scratch);
        }
        for (std::size_t lane = 0; lane < count; ++lane)
        {
          for (int m = 0; m < NumberOfMoments; ++m)
          {
            values[(first + lane) * NumberOfMoments + m] = sums[m * lanes + lane] + carries[m * lanes + lane];
          }
          if (!bounds)
          {
            continue;
          }
          std::array<double, NumberOfMoments> total = this->ConstantBound;
          AddErrors(this->Errors, c + (first + lane) * directions, sizes, total);
          for (int m = 0; m < NumberOfMoments; ++m)
          {
            const double value = values[(first + lane) * NumberOfMoments + m];
            const double bound = GetSumRounding(this->Terms) * total[m] +
              4.0 * UnitRoundoff * (std::abs(value) + std::abs(this->Constant[m]));
            bounds[(first + lane) * NumberOfMoments + m] =
              std::isfinite(bound) ? bound : std::numeric_limits<double>::quiet_NaN();
          }
        }
      }
    });
}

double VariantIntegrator::Internals::MeasurePoints() const
{
  const std::size_t n = 4 * static_cast<std::size_t>(GetVariantLanes());
  const std::vector<double> c(n * this->GetDirections(), 0.0);
  std::vector<double> values(n * NumberOfMoments);
  return MeasureVariants(n,
    [&]()
    {
      this->EvaluatePoints(c.data(), n, values.data(), nullptr);
      return true;
    });
}

bool VariantIntegrator::Internals::MakePoints(
  const VariantSettings& settings, const VariantChainOptions& options, double& seconds, std::string& error)
{
  std::vector<VariantFaceChain> chains;
  if (!MakeChains(*this->Shape, options, GetPartOf(settings.Progress, 0.0, 0.5), chains, error))
  {
    return false;
  }
  this->Gaps = FindGaps(chains, this->Shape->GetNumberOfDirections());
  this->AddFaces(chains, settings.Backend != BackendChoice::CPU);
  const double onThread = this->MeasurePoints();
  this->Reason =
    "a variant takes " + FormatMicroseconds(onThread) + " at frozen points on a thread of the CPU";
  seconds = onThread / GetThreads();
  if (this->StartContext(settings, seconds))
  {
    DevicePointsWriter writer;
    for (const VariantFaceChain& chain : chains)
    {
      writer.AddFace(chain);
    }
    seconds = this->ChooseDevice(settings, writer.Finish(), seconds);
  }
  return true;
}

bool VariantIntegrator::Internals::TryPolynomial(
  const VariantSettings& settings, const VariantOptions& options, double ofPoints, std::string& error)
{
  const bool isOnly = settings.Method == VariantMethod::Polynomial;
  const auto polynomial = VariantPolynomial::Make(
    this->Shape, options, error, GetPartOf(settings.Progress, isOnly ? 0.0 : 0.5, 1.0));
  if (!polynomial)
  {
    return false;
  }
  const std::size_t n = 16 * static_cast<std::size_t>(GetVariantLanes());
  const std::vector<double> c(n * this->GetDirections(), 0.0);
  std::vector<double> values(n * NumberOfMoments);
  const double seconds = MeasureVariants(n,
    [&]()
    {
      polynomial->Evaluate(c.data(), n, values.data());
      return true;
    });
  this->AddReason((this->Reason.empty() ? "a variant takes " : "") + FormatMicroseconds(seconds) +
    " as a polynomial, which took " + FormatDigits(polynomial->GetSeconds(), 4) + " s to make");
  if (this->ChooseFormDevice(settings, polynomial, seconds / GetThreads()) < ofPoints || isOnly)
  {
    this->Gaps = polynomial->GetGaps();
    this->Samples = 0;
    this->Faces.clear();
    this->Errors.clear();
    this->Device = nullptr;
  }
  else
  {
    this->Polynomial = nullptr;
    this->FormDevice = nullptr;
  }
  return true;
}

VariantIntegrator::VariantIntegrator(std::unique_ptr<Internals> implementation)
  : Implementation(std::move(implementation))
{
}

VariantIntegrator::~VariantIntegrator() = default;

std::shared_ptr<const VariantIntegrator> VariantIntegrator::Make(
  const std::shared_ptr<const VariantShape>& shape, const VariantOptions& options, std::string& error,
  const VariantSettings& settings)
try
{
  const VariantMethod method = settings.Method;
  error = !shape ? "there is no shape: make one first" : FindProblem(options, shape->GetNumberOfDirections());
  if (error.empty() && method == VariantMethod::Polynomial &&
    shape->GetNumberOfDirections() > VariantPolynomial::MaximumDirections)
  {
    error = "more than " + std::to_string(VariantPolynomial::MaximumDirections) +
      " directions are too many for polynomials: use frozen points";
  }
  if (!error.empty())
  {
    return nullptr;
  }
  auto internals = std::make_unique<Internals>();
  internals->Shape = shape;
  const VariantChainOptions chainOptions = MakeChainOptions(*shape, options);
  internals->Ranges = chainOptions.Ranges;
  for (int c = 0; c < 3; ++c)
  {
    internals->Reference[c] = chainOptions.Reference[c] + shape->GetBase()->GetOrigin()[c];
  }
  double ofPoints = 0.0;
  if (method != VariantMethod::Polynomial && !internals->MakePoints(settings, chainOptions, ofPoints, error))
  {
    return nullptr;
  }
  const bool isTried = method == VariantMethod::Polynomial ||
    (method == VariantMethod::Automatic &&
      shape->GetNumberOfDirections() <= VariantPolynomial::MaximumDirections &&
      // Below the time that a small polynomial takes there is nothing to gain.
      ofPoints * static_cast<double>(settings.Expected) > 0.01);
  if (isTried && !internals->TryPolynomial(settings, options, ofPoints, error))
  {
    return nullptr;
  }
  return std::shared_ptr<const VariantIntegrator>(new VariantIntegrator(std::move(internals)));
}
catch (...)
{
  error = ExplainFailure(std::current_exception());
  return nullptr;
}

VariantMethod VariantIntegrator::GetMethod() const
{
  return this->Implementation->Polynomial ? VariantMethod::Polynomial : VariantMethod::Points;
}

BackendChoice VariantIntegrator::GetBackend() const
{
  const std::lock_guard<std::mutex> lock(this->Implementation->Mutex);
  return this->Implementation->Device || this->Implementation->FormDevice ? BackendChoice::OpenGL
                                                                          : BackendChoice::CPU;
}

std::string VariantIntegrator::GetReason() const
{
  const std::lock_guard<std::mutex> lock(this->Implementation->Mutex);
  return this->Implementation->Reason;
}

int VariantIntegrator::GetNumberOfDirections() const
{
  return this->Implementation->Shape->GetNumberOfDirections();
}

const std::array<double, 3>& VariantIntegrator::GetReference() const
{
  return this->Implementation->Reference;
}

const std::vector<VariantGap>& VariantIntegrator::GetGaps() const
{
  return this->Implementation->Gaps;
}

const VariantPolynomial* VariantIntegrator::GetPolynomial() const
{
  return this->Implementation->Polynomial.get();
}

std::int64_t VariantIntegrator::GetNumberOfSamples() const
{
  return this->Implementation->Samples;
}

void VariantIntegrator::Evaluate(const double* c, std::size_t n, double* values, double* bounds,
  double* gradients, double* gradientBounds) const
{
  Internals& self = *this->Implementation;
  const std::size_t directions = self.GetDirections();
  const VariantPolynomial* polynomial = self.Polynomial.get();
  if (polynomial && !self.EvaluateFormsOnDevice(c, n, values, gradients))
  {
    polynomial->Evaluate(c, n, values, bounds, gradients, gradientBounds);
    return;
  }
  if (polynomial)
  {
    polynomial->EvaluateBounds(c, n, bounds, gradientBounds);
  }
  else if (!self.EvaluateOnDevice(c, n, values, bounds))
  {
    self.EvaluatePoints(c, n, values, bounds);
  }
  for (double* unknown : { gradients, gradientBounds })
  {
    if (unknown && !polynomial)
    {
      std::fill_n(unknown, n * NumberOfValues * directions, std::numeric_limits<double>::quiet_NaN());
    }
  }
  HideNotFinite(c, directions, n,
    { { values, NumberOfValues }, { bounds, NumberOfValues }, { gradients, NumberOfValues * directions },
      { gradientBounds, NumberOfValues * directions } });
}
}
