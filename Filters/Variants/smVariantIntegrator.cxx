#include "smVariantIntegrator.h"

#include "Detail/smVariantKernels.h"
#include "Detail/smVariantPoints.h"
#include "Detail/smVariantScales.h"
#include "Detail/smVariantSums.h"
#include "smBernstein.h"
#include "smGaussLegendre.h"
#include "smParallelFor.h"
#include "smUnitRoundoff.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>

namespace sm
{
namespace
{
constexpr double PointsRounding = 1.0 + 1e-11;

/// Writes the samples of a face and the nets that they refer to.
class PointsWriter
{
public:
  explicit PointsWriter(const VariantFaceChain& chain)
    : Chain(chain)
    , Variables(chain.GetNumberOfVariables())
  {
    this->Face.Directions = chain.Directions;
  }

  PointsFace Write()
  {
    for (const VariantPatch& patch : this->Chain.Patches)
    {
      this->NetOfPatch.push_back(this->AddPatch(patch));
    }
    for (const VariantPanel& panel : this->Chain.Panels)
    {
      this->AddPanel(panel);
    }
    for (const VariantRibbon& ribbon : this->Chain.Ribbons)
    {
      this->AddRibbon(ribbon);
    }
    for (const VariantCap& cap : this->Chain.Caps)
    {
      this->AddCap(cap);
    }
    return std::move(this->Face);
  }

private:
  /// Appends a number of the nets: get(variable).
  template <typename Get>
  void AddNumber(const Get& get)
  {
    for (int a = 0; a < this->Variables; ++a)
    {
      this->Face.Nets.push_back(get(a));
    }
    ++this->Face.NetSize;
  }
  void AddNet(const std::vector<double>& net, int count)
  {
    for (int c = 0; c < 3; ++c)
    {
      for (int i = 0; i < count; ++i)
      {
        this->AddNumber([&](int a) { return net[(3 * static_cast<std::size_t>(a) + c) * count + i]; });
      }
    }
  }
  std::size_t AddPatch(const VariantPatch& patch)
  {
    const std::size_t first = this->Face.NetSize;
    for (int c = 0; c < 3; ++c)
    {
      this->AddNumber([&](int a) { return patch.Centers[a][c]; });
    }
    this->AddNet(patch.Points, patch.GetNumberOfPoints());
    this->AddNet(patch.StepsS, patch.GetNumberOfStepsS());
    this->AddNet(patch.StepsR, patch.GetNumberOfStepsR());
    return first;
  }
  PointsBlock MakeBlock(PointsKind kind, std::uint32_t index) const
  {
    const VariantPatch& patch = this->Chain.Patches[index];
    return { kind, patch.GetNumberOfPoints(), patch.GetNumberOfStepsS(), patch.GetNumberOfStepsR(), 0,
      this->NetOfPatch[index], 0, this->Face.Records.size(), 0, 0 };
  }
  void Append(const std::vector<double>& values, double factor)
  {
    for (const double value : values)
    {
      this->Face.Records.push_back(factor * value);
    }
  }

  void AddPanel(const VariantPanel& panel)
  {
    const VariantPatch& patch = this->Chain.Patches[panel.Patch];
    PointsBlock block = this->MakeBlock(PointsKind::Panel, panel.Patch);
    block.RecordSize = 3 + static_cast<std::size_t>(block.Points + block.StepsS + block.StepsR);
    PatchBasis basis;
    VisitPanelNodes(this->Chain, panel,
      [&](double weight, double s, double r)
      {
        patch.FillBasis(s, r, basis);
        this->Face.Records.insert(this->Face.Records.end(), { weight, basis.TurnS, basis.TurnR });
        this->Append(basis.Position, 1.0);
        this->Append(basis.First, 1.0);
        this->Append(basis.Second, 1.0);
        ++block.Count;
      });
    this->Face.Blocks.push_back(block);
  }

  void AddRibbon(const VariantRibbon& ribbon)
  {
    const VariantPatch& patch = this->Chain.Patches[ribbon.Patch];
    const int n = ribbon.EdgeDegree;
    PointsBlock block = this->MakeBlock(PointsKind::Ribbon, ribbon.Patch);
    block.EdgePoints = n + 1;
    block.EdgeNet = this->Face.NetSize;
    block.RecordSize =
      2 + static_cast<std::size_t>(block.Points + block.StepsS + block.StepsR + 2 * block.EdgePoints);
    for (int c = 0; c < 3; ++c)
    {
      for (int i = 0; i <= n; ++i)
      {
        this->AddNumber(
          [&](int a) {
            return this->Chain
              .Coefficients[ribbon.Edge + 3 * ((n + 1) * static_cast<std::size_t>(a) + i) + c];
          });
      }
    }
    const double* rule =
      GetRuleTable().data() + static_cast<std::ptrdiff_t>(ribbon.Along) * (ribbon.Along - 1);
    const double width = ribbon.End - ribbon.Start;
    const double edgeWidth = ribbon.EdgeEnd - ribbon.EdgeStart;
    PatchBasis basis;
    for (int i = 0; i < ribbon.Along; ++i)
    {
      double point[2];
      double slope[2];
      EvaluateTrim(this->Chain.Coefficients.data() + ribbon.Trim, ribbon.TrimDegree,
        ribbon.Start + width * rule[2 * i], point, slope);
      patch.FillBasis(point[0], point[1], basis);
      const double slopes[2] = { width * slope[0], width * slope[1] };
      this->Face.Records.push_back(ribbon.Sign * rule[2 * i + 1]);
      this->Face.Records.push_back(slopes[0] * basis.TurnS + slopes[1] * basis.TurnR);
      this->Append(basis.Position, 1.0);
      this->Append(basis.First, slopes[0]);
      this->Append(basis.Second, slopes[1]);
      const double e = ribbon.EdgeStart + edgeWidth * rule[2 * i];
      std::vector<double> own(n + 1);
      std::vector<double> lower(n + 1, 0.0);
      FillBernsteinBasis(n, e, own.data());
      std::vector<double> derivative(n + 1, 0.0);
      if (n > 0)
      {
        FillBernsteinBasis(n - 1, e, lower.data());
        for (int k = 0; k <= n; ++k)
        {
          derivative[k] = n * ((k > 0 ? lower[k - 1] : 0.0) - (k < n ? lower[k] : 0.0));
        }
      }
      this->Append(own, 1.0);
      this->Append(derivative, edgeWidth);
      ++block.Count;
    }
    this->Face.Blocks.push_back(block);
  }

  void AddCap(const VariantCap& cap)
  {
    PointsBlock block{ PointsKind::Cap, 0, 0, 0, 0, this->Face.NetSize, 0, this->Face.Records.size(), 1, 1 };
    for (const auto& corner : cap.Corners)
    {
      for (int c = 0; c < 3; ++c)
      {
        this->AddNumber([&](int a) { return corner[c][a]; });
      }
    }
    this->Face.Records.push_back(cap.Sign);
    this->Face.Blocks.push_back(block);
  }

  const VariantFaceChain& Chain;
  const int Variables;
  std::vector<std::size_t> NetOfPatch;
  PointsFace Face;
};

/// The errors of a face's items as numbers, for any |c|: three vectors of forms, [coordinate][variable].
struct PointsErrors
{
  std::vector<int> Directions;
  std::vector<VariantError> Terms;
};

std::array<ErrorBound, 3> EvaluateForms3(
  const std::array<std::vector<ErrorBound>, 3>& forms, const std::vector<double>& sizes)
{
  std::array<ErrorBound, 3> sums{};
  for (int c = 0; c < 3; ++c)
  {
    for (std::size_t a = 0; a < sizes.size(); ++a)
    {
      sums[c].Value += sizes[a] * forms[c][a].Value;
      sums[c].Error += sizes[a] * forms[c][a].Error;
    }
  }
  return sums;
}

/**
 * Adds the bounds of a face's items. A net is a sum of products with c, which adds one rounding for each
 * variable and two more to the numbers of the net; errors of positions and tangents are at least 2 unit
 * roundoffs of these, those of a patch's centre no more.
 */
void AddErrors(
  const PointsErrors& face, const std::vector<double>& sizes, std::array<double, NumberOfMoments>& bounds)
{
  const double growth = 1.0001 * (1.0 + (static_cast<double>(sizes.size()) + 2.0) / 2.0);
  for (const VariantError& term : face.Terms)
  {
    const auto flux = GetFluxBounds(EvaluateForms3(term.Forms.Position, sizes),
      EvaluateForms3(term.Forms.First, sizes), EvaluateForms3(term.Forms.Second, sizes));
    for (int m = 0; m < NumberOfMoments; ++m)
    {
      bounds[m] +=
        PointsRounding * (term.ValueFactor * flux[m].Value + term.ErrorFactor * growth * flux[m].Error);
    }
  }
}

double Now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
}

struct VariantIntegrator::Internals
{
  std::shared_ptr<const VariantShape> Shape;
  std::shared_ptr<const VariantPolynomial> Polynomial;
  std::array<double, 3> Reference{};
  std::vector<PointsFace> Faces;
  std::vector<PointsErrors> Errors;
  /// Of the faces that nothing moves.
  std::array<double, NumberOfMoments> Constant{};
  std::array<double, NumberOfMoments> ConstantBound{};
  std::vector<VariantGap> Gaps;
  std::int64_t Samples = 0;
  std::string Reason;

  void AddFaces(std::vector<VariantFaceChain>& chains);
  void EvaluatePoints(const double* c, std::size_t n, double* values, double* bounds) const;
  double MeasurePoints() const;
};

void VariantIntegrator::Internals::AddFaces(std::vector<VariantFaceChain>& chains)
{
  const VariantMonomials one(1);
  VariantTotals totals(one);
  const VariantMap map(one, {}, one);
  for (VariantFaceChain& chain : chains)
  {
    PointsErrors errors{ chain.Directions, std::move(chain.Errors) };
    if (!chain.Directions.empty())
    {
      this->Samples += CountSamples(chain);
      this->Faces.push_back(PointsWriter(chain).Write());
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
  const auto directions = static_cast<std::size_t>(this->Shape->GetNumberOfDirections());
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
          for (const PointsErrors& errors : this->Errors)
          {
            sizes.assign(1, 1.0);
            for (const int direction : errors.Directions)
            {
              sizes.push_back(std::abs(c[(first + lane) * directions + static_cast<std::size_t>(direction)]));
            }
            AddErrors(errors, sizes, total);
          }
          for (int m = 0; m < NumberOfMoments; ++m)
          {
            const double value = values[(first + lane) * NumberOfMoments + m];
            const double bound = PointsRounding * total[m] +
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
  const std::vector<double> c(n * static_cast<std::size_t>(this->Shape->GetNumberOfDirections()), 0.0);
  std::vector<double> values(n * NumberOfMoments);
  double seconds = std::numeric_limits<double>::max();
  for (int i = 0; i < 3; ++i)
  {
    const double start = Now();
    this->EvaluatePoints(c.data(), n, values.data(), nullptr);
    seconds = std::min(seconds, Now() - start);
  }
  return seconds / static_cast<double>(n);
}

VariantIntegrator::VariantIntegrator(std::unique_ptr<Internals> implementation)
  : Implementation(std::move(implementation))
{
}

VariantIntegrator::~VariantIntegrator() = default;

std::shared_ptr<const VariantIntegrator> VariantIntegrator::Make(
  const std::shared_ptr<const VariantShape>& shape, const VariantOptions& options, std::string& error,
  VariantMethod method, std::int64_t expected)
try
{
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
  for (int c = 0; c < 3; ++c)
  {
    internals->Reference[c] = chainOptions.Reference[c] + shape->GetBase()->GetOrigin()[c];
  }
  double ofPoints = 0.0;
  if (method != VariantMethod::Polynomial)
  {
    std::vector<VariantFaceChain> chains;
    if (!MakeChains(*shape, chainOptions, chains, error))
    {
      return nullptr;
    }
    internals->Gaps = FindGaps(chains, shape->GetNumberOfDirections());
    internals->AddFaces(chains);
    ofPoints = internals->MeasurePoints();
    internals->Reason = "a variant takes " + std::to_string(1e6 * ofPoints) + " us at frozen points";
  }
  const bool isTried = method == VariantMethod::Polynomial ||
    (method == VariantMethod::Automatic &&
      shape->GetNumberOfDirections() <= VariantPolynomial::MaximumDirections &&
      // Below the time that a small polynomial takes there is nothing to gain.
      ofPoints * static_cast<double>(expected) > 0.01);
  if (isTried)
  {
    const auto polynomial = VariantPolynomial::Make(shape, options, error);
    if (!polynomial)
    {
      return nullptr;
    }
    const std::size_t n = 16 * static_cast<std::size_t>(GetVariantLanes());
    const std::vector<double> c(n * static_cast<std::size_t>(shape->GetNumberOfDirections()), 0.0);
    std::vector<double> values(n * NumberOfMoments);
    double seconds = std::numeric_limits<double>::max();
    for (int i = 0; i < 3; ++i)
    {
      const double start = Now();
      polynomial->Evaluate(c.data(), n, values.data());
      seconds = std::min(seconds, Now() - start);
    }
    seconds /= static_cast<double>(n);
    internals->Reason += (internals->Reason.empty() ? "a variant takes " : ", ") +
      std::to_string(1e6 * seconds) + " us as a polynomial, which took " +
      std::to_string(polynomial->GetSeconds()) + " s to make";
    if (method == VariantMethod::Polynomial || seconds < ofPoints)
    {
      internals->Polynomial = polynomial;
      internals->Gaps = polynomial->GetGaps();
      internals->Samples = 0;
      internals->Faces.clear();
      internals->Errors.clear();
    }
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

const std::string& VariantIntegrator::GetReason() const
{
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

void VariantIntegrator::Evaluate(const double* c, std::size_t n, double* values, double* bounds) const
{
  if (this->Implementation->Polynomial)
  {
    this->Implementation->Polynomial->Evaluate(c, n, values, bounds);
    return;
  }
  this->Implementation->EvaluatePoints(c, n, values, bounds);
  HideNotFinite(c, static_cast<std::size_t>(this->GetNumberOfDirections()), n,
    { { values, NumberOfValues }, { bounds, NumberOfValues } });
}
}
