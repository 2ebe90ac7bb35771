#include "smVariantPolynomial.h"

#include "Detail/smVariantErrors.h"
#include "Detail/smVariantFormTables.h"
#include "Detail/smVariantKernels.h"
#include "Detail/smVariantScales.h"
#include "Detail/smVariantSums.h"
#include "smParallelFor.h"
#include "smUnitRoundoff.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <numeric>

namespace sm
{
namespace
{
/**
 * The bound of a polynomial's value for |c|: constant and linear terms exactly; with theta = max |c_k| /
 * range_k, the terms of degree j >= 2 are at most theta^j times their sum at |c| = range. The same of its
 * derivatives.
 */
struct BoundTable
{
  double Constant = 0.0;
  std::vector<double> Linear;
  /// By degree j.
  std::array<double, MaximumFormDegree + 1> Sums{};
  /// [direction][j].
  std::vector<std::array<double, MaximumFormDegree + 1>> Slopes;
};

constexpr std::size_t FacesAtOnce = 16;
constexpr std::size_t FirstOfGroup[3] = { 0, 1, 4 };
constexpr std::size_t SizeOfGroup[3] = { 1, 3, 6 };

int CountConstants(const std::array<int, MaximumFormDegree>& factors, int degree)
{
  return static_cast<int>(std::count(factors.begin(), factors.begin() + degree, 0));
}
}

struct VariantPolynomial::Internals
{
  explicit Internals(std::shared_ptr<const VariantShape> shape)
    : Shape(std::move(shape))
    , Directions(this->Shape->GetNumberOfDirections())
    , Monomials(this->Directions + 1)
  {
  }

  void AddErrors(const std::vector<VariantFaceChain>& chains);
  /// Returns false if `progress` did.
  bool AddFaces(const std::vector<VariantFaceChain>& chains, const ProgressCallback& progress);
  void MakeTables();
  void MakeBounds(double roundings);
  void EvaluateBatch(const FormTables& tables, const double* c, std::size_t count, double* values,
    double* gradients, std::vector<double>& columns, std::vector<double>& scratch) const;
  void EvaluateBounds(const double* c, double* bounds, double* gradientBounds) const;

  std::shared_ptr<const VariantShape> Shape;
  int Directions;
  VariantMonomials Monomials;
  std::vector<double> Ranges;
  std::array<double, 3> Reference{};
  MomentForms<double> Coefficients;
  MomentForms<double> Bounds;
  FormTables Plain;
  FormTables Derivatives;
  std::array<BoundTable, NumberOfMoments> BoundTables;
  /// Covers the rounding of the bounds: sums of all errors and of all monomials.
  double BoundRounding = 1.0;
  std::vector<VariantGap> Gaps;
  std::int64_t Samples = 0;
  double Seconds = 0.0;
};

bool VariantPolynomial::Internals::AddFaces(
  const std::vector<VariantFaceChain>& chains, const ProgressCallback& progress)
{
  VariantTotals totals(this->Monomials);
  // Faces in parallel, and their sums in the order of the faces, so that the result does not depend on
  // threads. A batch at a time: the sums of one face with 24 directions take 12 MB.
  struct FaceSums
  {
    std::unique_ptr<VariantMonomials> Monomials;
    std::unique_ptr<VariantTotals> Totals;
  };
  for (std::size_t first = 0; first < chains.size(); first += FacesAtOnce)
  {
    if (progress && !progress(static_cast<double>(first) / static_cast<double>(chains.size())))
    {
      return false;
    }
    std::vector<FaceSums> faces(std::min(FacesAtOnce, chains.size() - first));
    ParallelFor(faces.size(), 1,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t f = begin; f < end; ++f)
        {
          const VariantFaceChain& chain = chains[first + f];
          FaceSums& face = faces[f];
          face.Monomials = std::make_unique<VariantMonomials>(chain.GetNumberOfVariables());
          face.Totals = std::make_unique<VariantTotals>(*face.Monomials);
          std::vector<int> own(chain.Directions.size());
          std::iota(own.begin(), own.end(), 0);
          const VariantMap map(*face.Monomials, own, *face.Monomials);
          VariantSums sums(*face.Monomials, map, *face.Totals);
          VisitSamples(chain, [&sums](const VariantSample& sample) { sums.Add(sample); });
          sums.Flush();
        }
      });
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      const VariantFaceChain& chain = chains[first + f];
      const VariantMap map(*faces[f].Monomials, chain.Directions, this->Monomials);
      for (int m = 0; m < NumberOfMoments; ++m)
      {
        const int degree = GetMomentDegree(m);
        for (std::size_t i = 0; i < faces[f].Monomials->GetCount(degree); ++i)
        {
          const double value = faces[f].Totals->Get(m, i);
          totals.Add(m, map.Get(degree, i), value);
          // The sum of the face, and the sum of the faces, are rounded.
          this->Bounds[m][map.Get(degree, i)] += 2.0 * UnitRoundoff * std::abs(value);
        }
      }
      this->Samples += CountSamples(chain);
    }
  }
  for (int m = 0; m < NumberOfMoments; ++m)
  {
    for (std::size_t i = 0; i < this->Coefficients[m].size(); ++i)
    {
      this->Coefficients[m][i] = totals.Get(m, i);
      this->Bounds[m][i] += 2.0 * UnitRoundoff * std::abs(this->Coefficients[m][i]);
    }
  }
  return true;
}

void VariantPolynomial::Internals::AddErrors(const std::vector<VariantFaceChain>& chains)
{
  std::size_t terms = this->Monomials.GetCount(MaximumFormDegree) + chains.size();
  for (const VariantFaceChain& chain : chains)
  {
    terms += chain.Errors.size();
    const VariantMonomials monomials(chain.GetNumberOfVariables());
    const VariantMap map(monomials, chain.Directions, this->Monomials);
    for (const VariantError& error : chain.Errors)
    {
      MomentForms<ErrorBound> sums;
      AddFluxBounds(monomials, error.Forms, sums);
      for (int m = 0; m < NumberOfMoments; ++m)
      {
        const int degree = GetMomentDegree(m);
        for (std::size_t i = 0; i < sums[m].size(); ++i)
        {
          this->Bounds[m][map.Get(degree, i)] +=
            PointsRounding * (error.ValueFactor * sums[m][i].Value + error.ErrorFactor * sums[m][i].Error);
        }
      }
    }
  }
  this->BoundRounding = GetSumRounding(terms);
}

void VariantPolynomial::Internals::MakeTables()
{
  const int variables = this->Directions + 1;
  this->Plain.Begin(this->Monomials, MaximumFormDegree);
  this->Derivatives.Begin(this->Monomials, MaximumFormDegree - 1);
  for (int group = 0; group < 3; ++group)
  {
    const int degree = 3 + group;
    this->Plain.Add(degree, this->Monomials.GetCount(degree), SizeOfGroup[group],
      [&](std::size_t row, std::size_t column)
      { return this->Coefficients[FirstOfGroup[group] + column][row]; });
    this->Derivatives.Add(degree - 1, this->Monomials.GetCount(degree - 1), SizeOfGroup[group] * variables,
      [&](std::size_t row, std::size_t column)
      {
        const auto variable = static_cast<int>(column % variables);
        const std::array<int, MaximumFormDegree> factors = this->Monomials.GetFactors(degree - 1, row);
        const auto power = 1 + std::count(factors.begin(), factors.begin() + degree - 1, variable);
        const std::size_t index = this->Monomials.Multiply(degree - 1, row, variable);
        return static_cast<double>(power) *
          this->Coefficients[FirstOfGroup[group] + column / variables][index];
      });
  }
  this->Plain.Finish();
  this->Derivatives.Finish();
  double roundings = 0.0;
  for (const FormTables* tables : { &this->Plain, &this->Derivatives })
  {
    for (const VariantMatrix& matrix : tables->Matrices)
    {
      roundings = std::max(roundings, GetRoundingsOfForm(matrix.Rows));
    }
  }
  // Euler's identity adds a product and a sum of all variables, and a quotient.
  this->MakeBounds((roundings + variables + 4.0) * UnitRoundoff);
}

void VariantPolynomial::Internals::MakeBounds(double roundings)
{
  for (int m = 0; m < NumberOfMoments; ++m)
  {
    const int degree = GetMomentDegree(m);
    BoundTable& table = this->BoundTables[m];
    table.Linear.assign(this->Directions, 0.0);
    table.Slopes.assign(this->Directions, {});
    for (std::size_t i = 0; i < this->Coefficients[m].size(); ++i)
    {
      const std::array<int, MaximumFormDegree> factors = this->Monomials.GetFactors(degree, i);
      const int constants = CountConstants(factors, degree);
      const int j = degree - constants;
      const double bound = this->Bounds[m][i] + roundings * std::abs(this->Coefficients[m][i]);
      if (j == 0)
      {
        table.Constant += bound;
        continue;
      }
      if (j == 1)
      {
        table.Linear[factors[degree - 1] - 1] += bound;
      }
      double size = bound;
      for (int k = constants; k < degree; ++k)
      {
        size *= this->Ranges[factors[k] - 1];
      }
      table.Sums[j] += size;
      for (int k = constants; k < degree; ++k)
      {
        table.Slopes[factors[k] - 1][j] += size / this->Ranges[factors[k] - 1];
      }
    }
  }
}

void VariantPolynomial::Internals::EvaluateBatch(const FormTables& tables, const double* c, std::size_t count,
  double* values, double* gradients, std::vector<double>& columns, std::vector<double>& scratch) const
{
  const std::size_t lanes = GetVariantLanes();
  columns.resize(tables.Forms.TotalColumns * lanes);
  EvaluateForms(tables.Forms, c, count, columns.data(), scratch);
  const double* column = columns.data();
  for (int group = 0; group < 3; ++group)
  {
    const double* next = column + tables.Matrices[group].Columns * lanes;
    for (std::size_t k = 0; k < SizeOfGroup[group]; ++k)
    {
      const std::size_t m = FirstOfGroup[group] + k;
      for (std::size_t lane = 0; lane < count; ++lane)
      {
        if (!gradients)
        {
          values[lane * NumberOfMoments + m] = column[k * lanes + lane];
          continue;
        }
        // Euler's identity for homogeneous forms.
        const double* own = column + k * (this->Directions + 1) * lanes + lane;
        double* to = gradients + (lane * NumberOfMoments + m) * this->Directions;
        double sum = own[0];
        for (int a = 0; a < this->Directions; ++a)
        {
          to[a] = own[(a + 1) * lanes];
          sum += c[lane * this->Directions + a] * to[a];
        }
        values[lane * NumberOfMoments + m] = sum / (3.0 + group);
      }
    }
    column = next;
  }
}

void VariantPolynomial::Internals::EvaluateBounds(
  const double* c, double* bounds, double* gradientBounds) const
{
  double theta = 0.0;
  for (int k = 0; k < this->Directions; ++k)
  {
    const double share = std::abs(c[k]) / this->Ranges[k];
    theta = std::max(theta, share);
  }
  for (int m = 0; m < NumberOfMoments; ++m)
  {
    const BoundTable& table = this->BoundTables[m];
    const int degree = GetMomentDegree(m);
    if (bounds)
    {
      double bound = 0.0;
      for (int j = degree; j >= 2; --j)
      {
        bound = (bound + table.Sums[j]) * theta;
      }
      bound *= theta;
      for (int k = 0; k < this->Directions; ++k)
      {
        bound += table.Linear[k] * std::abs(c[k]);
      }
      bounds[m] = this->BoundRounding * (bound + table.Constant);
    }
    for (int k = 0; gradientBounds && k < this->Directions; ++k)
    {
      double bound = 0.0;
      for (int j = degree; j >= 2; --j)
      {
        bound = (bound + table.Slopes[k][j]) * theta;
      }
      gradientBounds[m * this->Directions + k] = this->BoundRounding * (bound + table.Linear[k]);
    }
  }
}

VariantPolynomial::VariantPolynomial(std::unique_ptr<Internals> implementation)
  : Implementation(std::move(implementation))
{
}

VariantPolynomial::~VariantPolynomial() = default;

std::shared_ptr<const VariantPolynomial> VariantPolynomial::Make(
  const std::shared_ptr<const VariantShape>& shape, const VariantOptions& options, std::string& error,
  const ProgressCallback& progress)
try
{
  error = !shape ? "there is no shape: make one first" : FindProblem(options, shape->GetNumberOfDirections());
  if (error.empty() && shape->GetNumberOfDirections() > MaximumDirections)
  {
    error = std::to_string(shape->GetNumberOfDirections()) + " directions are more than " +
      std::to_string(MaximumDirections) + ": use a VariantIntegrator";
  }
  if (!error.empty())
  {
    return nullptr;
  }
  const auto start = std::chrono::steady_clock::now();
  auto internals = std::make_unique<Internals>(shape);
  const VariantChainOptions chainOptions = MakeChainOptions(*shape, options);
  std::vector<VariantFaceChain> chains;
  if (!MakeChains(*shape, chainOptions, GetPartOf(progress, 0.0, 0.3), chains, error))
  {
    return nullptr;
  }
  internals->Ranges = chainOptions.Ranges;
  for (int c = 0; c < 3; ++c)
  {
    internals->Reference[c] = chainOptions.Reference[c] + shape->GetBase()->GetOrigin()[c];
  }
  for (int m = 0; m < NumberOfMoments; ++m)
  {
    internals->Coefficients[m].assign(internals->Monomials.GetCount(GetMomentDegree(m)), 0.0);
    internals->Bounds[m] = internals->Coefficients[m];
  }
  internals->AddErrors(chains);
  if (!internals->AddFaces(chains, GetPartOf(progress, 0.3, 1.0)))
  {
    error = StoppedReason;
    return nullptr;
  }
  internals->Gaps = FindGaps(chains, internals->Directions);
  internals->MakeTables();
  internals->Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return std::shared_ptr<const VariantPolynomial>(new VariantPolynomial(std::move(internals)));
}
catch (...)
{
  error = ExplainFailure(std::current_exception());
  return nullptr;
}

int VariantPolynomial::GetNumberOfDirections() const
{
  return this->Implementation->Directions;
}

const VariantShape& VariantPolynomial::GetShape() const
{
  return *this->Implementation->Shape;
}

const std::array<double, 3>& VariantPolynomial::GetReference() const
{
  return this->Implementation->Reference;
}

std::size_t VariantPolynomial::GetNumberOfCoefficients(int moment) const
{
  return this->Implementation->Coefficients[moment].size();
}

double VariantPolynomial::GetCoefficient(int moment, std::size_t index) const
{
  return this->Implementation->Coefficients[moment][index];
}

double VariantPolynomial::GetCoefficientBound(int moment, std::size_t index) const
{
  const double bound = this->Implementation->BoundRounding * this->Implementation->Bounds[moment][index];
  return std::isfinite(bound) ? bound : std::numeric_limits<double>::quiet_NaN();
}

std::vector<int> VariantPolynomial::GetPowers(int moment, std::size_t index) const
{
  const int degree = GetMomentDegree(moment);
  const std::array<int, MaximumFormDegree> factors =
    this->Implementation->Monomials.GetFactors(degree, index);
  std::vector<int> powers(this->GetNumberOfDirections(), 0);
  for (int i = 0; i < degree; ++i)
  {
    if (factors[i] > 0)
    {
      ++powers[factors[i] - 1];
    }
  }
  return powers;
}

const FormTables& VariantPolynomial::GetTables(bool areDerivatives) const
{
  return areDerivatives ? this->Implementation->Derivatives : this->Implementation->Plain;
}

void VariantPolynomial::EvaluateBounds(
  const double* c, std::size_t n, double* bounds, double* gradientBounds) const
{
  const auto directions = static_cast<std::size_t>(this->GetNumberOfDirections());
  ParallelFor(bounds || gradientBounds ? n : 0, 1024,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        this->Implementation->EvaluateBounds(c + i * directions,
          bounds ? bounds + i * NumberOfMoments : nullptr,
          gradientBounds ? gradientBounds + i * NumberOfMoments * directions : nullptr);
      }
    });
  const auto hideUnknown = [](double* to, std::size_t size)
  {
    for (std::size_t i = 0; to && i < size; ++i)
    {
      to[i] = std::isfinite(to[i]) ? to[i] : std::numeric_limits<double>::quiet_NaN();
    }
  };
  hideUnknown(bounds, n * NumberOfMoments);
  hideUnknown(gradientBounds, n * NumberOfMoments * directions);
}

void VariantPolynomial::Evaluate(const double* c, std::size_t n, double* values, double* bounds,
  double* gradients, double* gradientBounds) const
{
  const Internals& self = *this->Implementation;
  const auto directions = static_cast<std::size_t>(self.Directions);
  const std::size_t lanes = GetVariantLanes();
  const std::size_t batches = (n + lanes - 1) / lanes;
  const FormTables& tables = gradients ? self.Derivatives : self.Plain;
  ParallelFor(batches, 64,
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<double> columns;
      std::vector<double> scratch;
      for (std::size_t batch = begin; batch < end; ++batch)
      {
        const std::size_t first = batch * lanes;
        const std::size_t count = std::min(lanes, n - first);
        self.EvaluateBatch(tables, c + first * directions, count, values + first * NumberOfMoments,
          gradients ? gradients + first * NumberOfMoments * directions : nullptr, columns, scratch);
      }
    });
  this->EvaluateBounds(c, n, bounds, gradientBounds);
  HideNotFinite(c, directions, n,
    { { values, NumberOfMoments }, { bounds, NumberOfMoments }, { gradients, NumberOfMoments * directions },
      { gradientBounds, NumberOfMoments * directions } });
}

const std::vector<VariantGap>& VariantPolynomial::GetGaps() const
{
  return this->Implementation->Gaps;
}

std::int64_t VariantPolynomial::GetNumberOfSamples() const
{
  return this->Implementation->Samples;
}

double VariantPolynomial::GetSeconds() const
{
  return this->Implementation->Seconds;
}
}
