#include "Detail/smTotalMass.h"

#include "smCountedTexts.h"
#include "smFormat.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace sm
{
namespace
{
/// Bound of the relative rounding error of a product of a density, the third power of a unit in metres, which
/// is itself rounded, and a value: seven roundings.
constexpr double FactorRounding = 8.0 * UnitRoundoff;

/// Returns kg of a volume 1; NaN without a density.
double GetFactor(double density, const std::string& unit)
{
  const double metres = GetMetres(unit);
  return density > 0.0 && metres > 0.0 ? density * metres * metres * metres : vtkMath::Nan();
}

/// Multiplies values and their bound by a factor with a relative error of up to FactorRounding and `error`.
template <std::size_t N>
void Scale(std::array<double, N>& values, double& bound, double factor, double error = 0.0)
{
  double largest = 0.0;
  for (double& value : values)
  {
    value *= factor;
    largest = std::max(largest, std::abs(value));
  }
  bound = factor * bound * (1.0 + error) + (FactorRounding + error) * largest;
}

/// A mass that overrides volume times density: what has the volume as weight is multiplied by mass / volume.
struct StatedScale
{
  /// kg of a volume 1.
  double Factor;
  /// Largest relative error of the factor, without its rounding.
  double Reciprocal;

  /// `error` is the largest relative error of the mass.
  StatedScale(double mass, double volume, double volumeBound, double error)
    : Factor(mass / volume)
    , Reciprocal(GetReciprocalChange(volume, volumeBound) * (1.0 + error) + error)
  {
  }

  template <std::size_t N>
  void Scale(std::array<double, N>& values, double& bound) const
  {
    double largest = 0.0;
    for (const double value : values)
    {
      largest = std::max(largest, std::abs(value));
    }
    bound += (largest + bound) * this->Reciprocal;
    sm::Scale(values, bound, this->Factor);
  }

  void Scale(double& value, double& bound) const
  {
    std::array<double, 1> values{ value };
    this->Scale(values, bound);
    value = values[0];
  }
};

/// Largest relative error of a mass as a table has it: its decimals, and its unit.
constexpr double StatedRounding = 2.0 * UnitRoundoff;

/// Gives moments the mass, with a relative error of up to `error`, as their weight.
void StateMoments(Moments& moments, double mass, double error)
{
  const StatedScale scale(mass, moments.Volume, moments.VolumeBound, error);
  for (int i = 0; i < 3; ++i)
  {
    scale.Scale(moments.First[i], moments.FirstBound[i]);
  }
  for (int i = 0; i < 6; ++i)
  {
    scale.Scale(moments.Second[i], moments.SecondBound[i]);
  }
  moments.Volume = mass;
  moments.VolumeBound = (StatedRounding + error) * mass;
}

/// Gives the spread of moments about the centre the mass as their weight: the mass stays, and the second
/// moments of the row change as the reciprocal of the volume does.
void StateSpread(Moments& spread, const MassRow& row)
{
  const double volume = row.Properties.Volume;
  const double factor = row.Mass / volume;
  const double reciprocal = GetReciprocalChange(volume, spread.VolumeBound);
  for (double& bound : spread.FirstBound)
  {
    bound *= factor * (1.0 + reciprocal);
  }
  for (std::size_t i = 0; i < spread.SecondBound.size(); ++i)
  {
    const double second = std::abs(row.Properties.Second[i]) + row.Properties.SecondBound;
    spread.SecondBound[i] = factor * (spread.SecondBound[i] * (1.0 + reciprocal) + second * reciprocal);
  }
  spread.VolumeBound = 0.0;
}

/// Multiplies the spread of moments about the centre by a density that other closings may change, too: by a
/// share of up to `change`.
void ShareSpread(Moments& spread, const MassRow& row, double change)
{
  const double factor = row.Mass / row.Properties.Volume;
  spread.VolumeBound = factor * spread.VolumeBound * (1.0 + change) + change * row.Mass;
  for (double& bound : spread.FirstBound)
  {
    bound *= factor * (1.0 + change);
  }
  for (std::size_t i = 0; i < spread.SecondBound.size(); ++i)
  {
    const double second = std::abs(row.Properties.Second[i]) + row.Properties.SecondBound;
    spread.SecondBound[i] = factor * (spread.SecondBound[i] * (1.0 + change) + second * change);
  }
}

/// Multiplies moments by a factor with a relative error of up to FactorRounding and `error`.
void ScaleMoments(Moments& moments, double factor, double error = 0.0)
{
  const auto scale = [factor, error](double& value, double& bound)
  {
    value *= factor;
    bound = factor * bound * (1.0 + error) + (FactorRounding + error) * std::abs(value);
  };
  scale(moments.Volume, moments.VolumeBound);
  for (int i = 0; i < 3; ++i)
  {
    scale(moments.First[i], moments.FirstBound[i]);
  }
  for (int i = 0; i < 6; ++i)
  {
    scale(moments.Second[i], moments.SecondBound[i]);
  }
}

/// Bounds the rounding of a sum of at most three shares and of each of them.
constexpr double SumFactor = 1.0 + 16.0 * UnitRoundoff;

/// Returns the uncertainty of a mass: sum, by the density, by gaps, by the numerical bound, by the tolerance
/// of a mass that overrides the density. The shares of gaps and bound are those at the largest density; the
/// factor includes the rounding of the shares and of the sum.
std::array<double, 5> GetMassUncertainty(const MassRow& row, double tolerance, double factor)
{
  const bool isStated = row.OverriddenMass > 0.0;
  const double share = tolerance * std::abs(row.Mass);
  const double gaps = row.ShareOfProduct > 0.0 ? (1.0 + tolerance) * row.WeightedSpread.Volume
    : isStated                                 ? 0.0
                                               : (1.0 + tolerance) * factor * row.Spread.Volume;
  const double numerical = (1.0 + tolerance) * row.MassBound;
  return { SumFactor * (share + gaps + numerical), isStated ? 0.0 : share, gaps, numerical,
    isStated ? share : 0.0 };
}

/// Sets the properties that follow from moments with the densities as weight.
void SetWeighted(MassRow& total, const Moments& weighted, const MassAnalysisOptions& options)
{
  total.Weighted = ComputeMassProperties(weighted);
  total.MassInertia = total.Weighted.Inertia;
  total.MassInertiaBound = total.Weighted.InertiaBound;
  if (options.Frame.IsGiven)
  {
    total.WeightedInFrame = ComputeInFrame(weighted, options.Frame);
  }
}

/// Lists all bodies that have a volume and no mass.
std::string NameBodiesWithoutDensity(
  const std::vector<BodyIntegrals>& bodies, const std::vector<MassRow>& rows)
{
  CountedTexts names;
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    if (std::isfinite(rows[b].Properties.Volume) && !std::isfinite(rows[b].Mass))
    {
      names.Add(bodies[b].GetLabel());
    }
  }
  return names.List();
}
}

double GetReciprocalChange(double volume, double change)
{
  return change < volume ? change / (volume - change) : std::numeric_limits<double>::infinity();
}

const ProductShare* FindShare(const BodyIntegrals& body, const MassAnalysisOptions& options)
{
  const auto found = options.Shares.find(body.Id);
  return found == options.Shares.end() ? nullptr : &found->second;
}

Material ChooseMaterial(const BodyIntegrals& body, const MassAnalysisOptions& options)
{
  Material material;
  if (const ProductShare* share = FindShare(body, options))
  {
    material = share->Material;
  }
  else if (const MaterialRule* rule = FindRule(options.Materials, body.Name))
  {
    material = rule->Material;
  }
  else if (options.Density > 0.0)
  {
    material.Density = options.Density;
  }
  else
  {
    material.Name = body.Model->GetMaterial();
    material.Density = body.Model->GetDensity();
    const auto twin = options.Twins.find(body.Id);
    material = twin == options.Twins.end() ? material : twin->second;
  }
  if (!(material.Tolerance >= 0.0))
  {
    material.Tolerance = material.Mass > 0.0 ? 0.0 : options.DensityTolerance;
  }
  return material;
}

namespace
{
/// Multiplies the properties of a row by a density with a relative error of up to `error`. `factor` is kg of
/// a volume 1; NaN without a density.
void SetMassOfDensity(MassRow& row, double factor, double error)
{
  MassProperties& weighted = row.Weighted;
  std::array<double, 1> mass = { weighted.Volume };
  Scale(mass, weighted.VolumeBound, factor, error);
  weighted.Volume = mass[0];
  Scale(weighted.First, weighted.FirstBound, factor, error);
  Scale(weighted.Second, weighted.SecondBound, factor, error);
  Scale(weighted.Inertia, weighted.InertiaBound, factor, error);
  Scale(weighted.InertiaAtOrigin, weighted.InertiaAtOriginBound, factor, error);
  Scale(weighted.Principal, weighted.PrincipalBound, factor, error);
  row.WeightedSpread = row.Spread.GetWeighted(factor);
  if (!(factor > 0.0))
  {
    weighted = MassProperties();
    return;
  }
  Scale(row.WeightedInFrame.Inertia, row.WeightedInFrame.InertiaBound, factor, error);
  Scale(row.WeightedInFrame.CentralInertia, row.WeightedInFrame.CentralInertiaBound, factor, error);
}

/// Adds to the spreads of a row what a relative change of its density by up to `change` does.
void AddChangeOfDensity(MassRow& row, double change)
{
  const MassProperties& weighted = row.Weighted;
  MassSpread& spread = row.WeightedSpread;
  spread.Inertia += change * (spread.Inertia + GetLargest(weighted.Inertia));
  spread.Principal += change * (spread.Principal + GetLargest(weighted.Principal));
}

/// Gives the properties of a row a mass that does not depend on the volume, with a relative error of up to
/// `error`.
void SetStatedMass(MassRow& row, double stated, double error)
{
  MassProperties& weighted = row.Weighted;
  const double volume = weighted.Volume;
  const StatedScale scale(stated, volume, weighted.VolumeBound, error);
  weighted.Volume = stated;
  weighted.VolumeBound = (StatedRounding + error) * stated;
  scale.Scale(weighted.First, weighted.FirstBound);
  scale.Scale(weighted.Second, weighted.SecondBound);
  scale.Scale(weighted.Inertia, weighted.InertiaBound);
  scale.Scale(weighted.InertiaAtOrigin, weighted.InertiaAtOriginBound);
  scale.Scale(weighted.Principal, weighted.PrincipalBound);
  scale.Scale(row.WeightedInFrame.Inertia, row.WeightedInFrame.InertiaBound);
  scale.Scale(row.WeightedInFrame.CentralInertia, row.WeightedInFrame.CentralInertiaBound);
  // Other closings of the gaps move the shape, not the mass.
  row.WeightedSpread = row.Spread.GetWeighted(scale.Factor);
  row.WeightedSpread.Volume = 0.0;
  AddChangeOfDensity(row, GetReciprocalChange(volume, row.Spread.Volume));
}
}

void SetMass(MassRow& row, const Material& material, const ProductShare* share, const std::string& unit)
{
  const double factor = GetFactor(material.Density, unit);
  const bool isStated = material.Mass > 0.0 && row.Properties.Volume > 0.0;
  const bool isShared = share && share->Share > 0.0;
  row.Material = material.Name;
  row.Density = material.Density > 0.0 ? material.Density : vtkMath::Nan();
  row.Weighted = row.Properties;
  row.WeightedInFrame = row.InFrame;
  if (isStated)
  {
    SetStatedMass(row, material.Mass, share ? share->Error : 0.0);
    row.Density = material.Mass / (row.Properties.Volume * GetFactor(1.0, unit));
  }
  else
  {
    row.WeightedInFrame = factor > 0.0 ? row.InFrame : FrameProperties();
    SetMassOfDensity(row, factor, isShared ? share->Error : 0.0);
  }
  row.Mass = row.Weighted.Volume;
  row.MassBound = row.Weighted.VolumeBound;
  row.OverriddenMass = isStated || isShared ? row.Mass : 0.0 * row.Mass;
  if (isShared)
  {
    row.ShareOfProduct = share->Share;
    row.WeightedSpread.Volume += share->Spread * (row.WeightedSpread.Volume + row.Mass);
    AddChangeOfDensity(row, share->Spread);
  }
  row.MassUncertainty = GetMassUncertainty(row, material.Tolerance, factor);
  row.MassInertia = row.Weighted.Inertia;
  row.MassInertiaBound = row.Weighted.InertiaBound;
}

namespace
{
/// Adds the shares of a row to those of the total. Gaps do not change the sum of what solids have of the mass
/// of a product.
void AddUncertainty(const MassRow& row, std::array<double, 5>& uncertainty)
{
  std::array<double, 5> shares = row.MassUncertainty;
  if (row.ShareOfProduct > 0.0)
  {
    shares[2] = 0.0;
    shares[0] = SumFactor * (shares[3] + shares[4]);
  }
  for (std::size_t k = 0; k < uncertainty.size(); ++k)
  {
    uncertainty[k] += shares[k];
  }
}

/// Gives moments of a row and their spread the mass as their weight. `factor` is kg of a volume 1 where the
/// row has a density.
void SetWeight(const MassRow& row, const ProductShare* share, double factor, Moments& part, Moments& spread)
{
  if (share && share->Share > 0.0)
  {
    ScaleMoments(part, factor, share->Error);
    ShareSpread(spread, row, share->Spread);
  }
  else if (row.OverriddenMass > 0.0)
  {
    StateMoments(part, row.Mass, share ? share->Error : 0.0);
    StateSpread(spread, row);
  }
  else
  {
    ScaleMoments(part, factor);
    ScaleMoments(spread, factor);
  }
}
}

void SetTotalMass(const std::vector<BodyIntegrals>& bodies, const std::vector<Moments>& parts,
  const Moments& sum, const std::vector<Moments>& spreads, const MassAnalysisOptions& options,
  MassAnalysis& analysis)
{
  MassRow& total = analysis.Total;
  double mass = 0.0;
  double bound = 0.0;
  double overridden = 0.0;
  std::array<double, 5> uncertainty{};
  std::vector<Moments> weighted;
  std::vector<Moments> weightedSpreads;
  double spreadOfMass = 0.0;
  std::size_t next = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    const MassRow& row = analysis.Rows[b];
    if (!std::isfinite(row.Properties.Volume))
    {
      continue;
    }
    Moments spread = spreads[next];
    Moments part = parts[next++];
    if (std::isfinite(row.Mass))
    {
      mass += row.Mass;
      overridden += row.OverriddenMass;
      const double rounding = 2.0 * UnitRoundoff * std::abs(mass);
      bound += row.MassBound + rounding;
      uncertainty[0] += rounding;
      uncertainty[3] += rounding;
      AddUncertainty(row, uncertainty);
      // What solids have of the mass of a product depends on the gaps, their sum does not.
      spreadOfMass += row.ShareOfProduct > 0.0 ? 0.0 : row.WeightedSpread.Volume;
      SetWeight(row, FindShare(bodies[b], options), GetFactor(row.Density, analysis.Unit), part, spread);
      weighted.push_back(part);
      weightedSpreads.push_back(spread);
    }
  }
  analysis.Weighable = static_cast<int>(parts.size());
  analysis.Weighed = static_cast<int>(weighted.size());
  total.KnownMass = weighted.empty() ? vtkMath::Nan() : mass;
  total.KnownMassBound = weighted.empty() ? vtkMath::Nan() : bound;
  if (options.Frame.IsGiven)
  {
    total.InFrame = ComputeInFrame(sum, options.Frame);
  }
  if (options.Materials.empty() && (options.Density > 0.0 || bodies.size() == 1))
  {
    SetMass(total, ChooseMaterial(bodies.front(), options), nullptr, analysis.Unit);
  }
  else if (!weighted.empty() && weighted.size() == parts.size())
  {
    // Densities may differ from part to part, and then the inertia is not density times VolumeInertia.
    total.Mass = mass;
    total.MassBound = bound;
    SetWeighted(total, Moments::Sum(weighted), options);
    total.WeightedSpread = ComputeSpread(weightedSpreads, mass, total.Weighted.Center);
    total.WeightedSpread.Volume = options.Shares.empty() ? total.WeightedSpread.Volume : spreadOfMass;
    const MassRow& first = *std::find_if(analysis.Rows.begin(), analysis.Rows.end(),
      [](const MassRow& row) { return std::isfinite(row.Properties.Volume); });
    const bool isUniform = std::all_of(analysis.Rows.begin(), analysis.Rows.end(),
      [&first](const MassRow& row)
      { return !std::isfinite(row.Properties.Volume) || row.Density == first.Density; });
    total.Density = isUniform ? first.Density : vtkMath::Nan();
  }
  else if (!weighted.empty())
  {
    analysis.Messages.push_back("no density for " + std::to_string(parts.size() - weighted.size()) + " of " +
      std::to_string(parts.size()) + " solids: " + NameBodiesWithoutDensity(bodies, analysis.Rows) +
      "; the mass of the others is known, that of all is not");
  }
  if (std::isfinite(total.Mass))
  {
    total.MassUncertainty = uncertainty;
    total.OverriddenMass = overridden;
  }
}

void NoteUnknownUnits(
  const std::vector<BodyIntegrals>& bodies, const MassAnalysisOptions& options, MassAnalysis& analysis)
{
  std::set<std::string> units;
  for (const BodyIntegrals& body : bodies)
  {
    const std::string unit = body.Model->GetLengthUnit();
    if (ChooseMaterial(body, options).Density > 0.0 && !(GetMetres(unit) > 0.0))
    {
      units.insert(unit);
    }
  }
  for (const std::string& unit : units)
  {
    analysis.Messages.push_back("there is no mass in the length unit \"" + unit + "\", which is not known");
  }
}

void NoteUnusedRules(
  const std::vector<BodyIntegrals>& bodies, const MassAnalysisOptions& options, MassAnalysis& analysis)
{
  for (const MaterialRule& rule : options.Materials)
  {
    if (!rule.IsLeftOut && !rule.IsOfProduct && rule.Counting == Counting::Every &&
      std::none_of(bodies.begin(), bodies.end(),
        [&](const BodyIntegrals& body) { return FindRule(options.Materials, body.Name) == &rule; }))
    {
      analysis.Messages.push_back("no solid gets its material from the pattern " + rule.Pattern);
    }
  }
}

namespace
{
/// Says which of the masses that override others have no tolerance; empty if all have one.
std::string DescribeExact(const CountedTexts& exact, std::size_t all)
{
  const std::size_t count = exact.GetTotal();
  return count == 0 ? std::string()
    : count == all  ? "; no tolerance is stated, so they count as exact"
                    : "; " + std::to_string(count) + " of them " +
      (count == 1 ? "has no tolerance and counts as exact: " : "have no tolerance and count as exact: ") +
      exact.List();
}
}

void NoteStatedMasses(
  const std::vector<BodyIntegrals>& bodies, const MassAnalysisOptions& options, MassAnalysis& analysis)
{
  CountedTexts used;
  CountedTexts exact;
  CountedTexts unused;
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    const Material material = ChooseMaterial(bodies[b], options);
    if (FindShare(bodies[b], options))
    {
      continue;
    }
    if (material.Mass > 0.0 && analysis.Rows[b].OverriddenMass > 0.0)
    {
      if (material.Tolerance == 0.0)
      {
        exact.Add(bodies[b].GetLabel());
      }
      used.Add(bodies[b].GetLabel() + " " + FormatDigits(material.Mass, 10) + " kg");
    }
    else if (material.Mass > 0.0)
    {
      unused.Add(bodies[b].GetLabel());
    }
  }
  if (used.GetTotal() > 0)
  {
    analysis.Messages.push_back("the materials override the mass of " +
      FormatCount(used.GetTotal(), "solid", "solids") + ": " + used.List() +
      DescribeExact(exact, used.GetTotal()));
  }
  if (unused.GetTotal() > 0)
  {
    analysis.Messages.push_back("the materials state a mass for " +
      FormatCount(unused.GetTotal(), "body", "bodies") +
      " without a volume, which has no inertia and does not count: " + unused.List());
  }
}
}
