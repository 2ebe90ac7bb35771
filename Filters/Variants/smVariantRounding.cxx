#include "Detail/smVariantOrdersInternals.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
// Roundings of a product of forms, of a weight, and of sums of at most 1,024 samples (smVariantSums.h).
constexpr double RoundingsOfSums = 160.0;
}

void SetBound(TangentForms<ErrorBound>& to, const TangentForms<double>& from)
{
  for (int c = 0; c < 3; ++c)
  {
    for (std::size_t a = 0; a < from.Position[c].size(); ++a)
    {
      to.Position[c][a].Value = from.Position[c][a];
      to.First[c][a].Value = from.First[c][a];
      to.Second[c][a].Value = from.Second[c][a];
    }
  }
}

TrimReach GetTrimReach(const double* local, int degree)
{
  TrimReach reach;
  reach.Degree = std::max(degree, 1);
  for (int i = 0; i <= degree; ++i)
  {
    for (int d = 0; d < 2; ++d)
    {
      const double* at = local + 2 * i + d;
      reach.Size[d] = std::max(reach.Size[d], std::abs(at[0]));
      reach.Step[d] = std::max(reach.Step[d], i < degree ? std::abs(at[2] - at[0]) : 0.0);
      reach.Bend[d] = std::max(reach.Bend[d], i + 1 < degree ? std::abs(at[4] - 2.0 * at[2] + at[0]) : 0.0);
      reach.IsConstant[d] = reach.IsConstant[d] && at[0] == local[d];
    }
  }
  return reach;
}

/// Rounding of a ribbon: errors of both curves at its points, where the gap is known.
void VariantOrders::AddRibbonRounding(const VariantRibbon& ribbon)
{
  const PatchState& state = this->GetState(ribbon.Patch);
  const VariantPatch& patch = state.Source;
  const int variables = patch.Variables;
  const TrimReach reach = GetTrimReach(this->Chain.Coefficients.data() + ribbon.Trim, ribbon.TrimDegree);
  const double width = ribbon.End - ribbon.Start;
  const double inverse = state.Near ? 1.0 / state.NearDistance : NoBound;
  const double moved[2] = { reach.GetError(0), reach.GetError(1) };
  const double turned[2] = { reach.GetSlopeError(0, width), reach.GetSlopeError(1, width) };
  // |s'| and |r'| on the part.
  const double slopes[2] = { reach.GetSlope(0) * width, reach.GetSlope(1) * width };
  VariantError rounding;
  rounding.ValueFactor = RoundingsOfSums * UnitRoundoff;
  rounding.ErrorFactor = 1.0;
  rounding.Forms = TangentForms<ErrorBound>(variables);
  std::vector<double> gaps(3 * static_cast<std::size_t>(variables), 0.0);
  std::vector<double> tangents(gaps.size(), 0.0);
  VisitRibbonNodes(this->Chain, ribbon,
    [&](const RibbonNode& node)
    {
      for (std::size_t i = 0; i < gaps.size(); ++i)
      {
        gaps[i] = std::max(gaps[i], std::abs(node.Edge[i] - node.Face[i]));
        tangents[i] = std::max({ tangents[i], std::abs(node.FaceTangent[i]), std::abs(node.EdgeTangent[i]) });
      }
    });
  this->Chain.Gaps.resize(variables, 0.0);
  const int n = ribbon.EdgeDegree + 1;
  for (int a = 0; a < variables; ++a)
  {
    this->Chain.Gaps[a] = std::max(this->Chain.Gaps[a],
      std::hypot(gaps[a], gaps[variables + a], gaps[2 * static_cast<std::size_t>(variables) + a]));
    for (int c = 0; c < 3; ++c)
    {
      const std::size_t at = static_cast<std::size_t>(c) * variables + a;
      const ErrorBound& position = state.Local.Position[c][a];
      const ErrorBound& first = state.Local.First[c][a];
      const ErrorBound& second = state.Local.Second[c][a];
      double largest = 0.0;
      for (int k = 0; k < n; ++k)
      {
        largest = std::max(largest,
          std::abs(this->Chain.Coefficients[ribbon.Edge + 3 * (static_cast<std::size_t>(n) * a + k) + c]));
      }
      const double edgeError = (9.0 * n + 8.0) * UnitRoundoff * largest;
      const double center = std::abs(patch.Centers[a][c]);
      // The vertex of a corner is given relative to the reference point.
      const double error = position.Error + first.Value * moved[0] + second.Value * moved[1] + edgeError +
        (ribbon.Coedge < 0 ? 4.0 * UnitRoundoff * center : 0.0);
      rounding.Forms.Position[c][a] = { center + std::max(position.Value, largest),
        error + 4.0 * UnitRoundoff * center };
      rounding.Forms.First[c][a] = { gaps[at] + error, error };
      double bend = 0.0;
      if (state.Near)
      {
        bend = (moved[0] + moved[1]) * inverse *
          (state.Near->Forms.First[c][a] * slopes[0] + state.Near->Forms.Second[c][a] * slopes[1]);
      }
      const double tangentError = first.Error * slopes[0] + second.Error * slopes[1] +
        first.Value * turned[0] + second.Value * turned[1] + (state.Near ? bend : NoBound) +
        4.0 * n * (15.0 * n + 8.0) * UnitRoundoff * largest;
      rounding.Forms.Second[c][a] = { tangents[at] + tangentError, tangentError };
    }
  }
  this->Chain.Errors.push_back(std::move(rounding));
}

/// Rounding of a triangle, whose corners are off by no more than the samples of their patches.
void VariantOrders::AddCapRounding(const VariantCap& cap)
{
  const int variables = this->Chain.GetNumberOfVariables();
  VariantError rounding;
  rounding.ValueFactor = RoundingsOfSums * UnitRoundoff;
  rounding.ErrorFactor = 1.0;
  rounding.Forms = TangentForms<ErrorBound>(variables);
  for (int a = 0; a < variables; ++a)
  {
    for (int c = 0; c < 3; ++c)
    {
      double error = 0.0;
      for (std::size_t i = 0; i < this->States.size(); ++i)
      {
        const PatchState& state = this->GetState(static_cast<std::uint32_t>(i));
        error = std::max(error,
          state.Local.Position[c][a].Error + 2.0 * UnitRoundoff * std::abs(state.Source.Centers[a][c]));
      }
      const double x[3] = { cap.Corners[0][c][a], cap.Corners[1][c][a], cap.Corners[2][c][a] };
      const double largest = std::max({ std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) });
      error += 8.0 * UnitRoundoff * largest;
      rounding.Forms.Position[c][a] = { largest + error, error };
      rounding.Forms.First[c][a] = { std::abs(x[1] - x[0]) + 2.0 * error, 2.0 * error };
      rounding.Forms.Second[c][a] = { std::abs(x[2] - x[0]) + 2.0 * error, 2.0 * error };
    }
  }
  this->Chain.Errors.push_back(std::move(rounding));
}

void VariantOrders::Finish()
{
  for (const std::unique_ptr<PatchState>& state : this->States)
  {
    if (!(state->Weight > 0.0))
    {
      continue;
    }
    VariantError rounding;
    rounding.ValueFactor = RoundingsOfSums * UnitRoundoff * state->Weight;
    rounding.ErrorFactor = state->Weight;
    rounding.Forms = BoundSamples(state->Source, state->Outside, true);
    rounding.Patch = static_cast<int>(&state - this->States.data());
    this->Chain.Errors.push_back(std::move(rounding));
    for (Target& target : state->Targets)
    {
      const double factor = target.Factor + (&target == state->Near ? state->ParameterError : 0.0);
      if (factor > 0.0)
      {
        VariantError error;
        error.ValueFactor = factor;
        error.Forms = TangentForms<ErrorBound>(state->Source.Variables);
        SetBound(error.Forms, target.Forms);
        this->Chain.Errors.push_back(std::move(error));
      }
    }
    if (!state->Near)
    {
      this->Chain.Errors.back().ValueFactor = NoBound;
    }
  }
  for (const VariantRibbon& ribbon : this->Chain.Ribbons)
  {
    this->AddRibbonRounding(ribbon);
  }
  for (const VariantCap& cap : this->Chain.Caps)
  {
    this->AddCapRounding(cap);
  }
}
}
