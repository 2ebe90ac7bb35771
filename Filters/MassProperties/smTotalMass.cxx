#include "Detail/smTotalMass.h"

#include "smUnitRoundoff.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace sm
{
namespace
{
/// Largest number of names that a message lists.
constexpr std::size_t NamedSolids = 5;

/// Bound of the relative rounding error of a product of a density, the third power of a unit in metres, which
/// is itself rounded, and a value: seven roundings.
constexpr double FactorRounding = 8.0 * UnitRoundoff;

/// Returns kg of a volume 1; NaN without a density.
double GetFactor(double density, const std::string& unit)
{
  const double metres = GetMetres(unit);
  return density > 0.0 && metres > 0.0 ? density * metres * metres * metres : vtkMath::Nan();
}

/// Multiplies values and their bound by a factor with a relative error of up to FactorRounding.
template <std::size_t N>
void Scale(std::array<double, N>& values, double& bound, double factor)
{
  double largest = 0.0;
  for (double& value : values)
  {
    value *= factor;
    largest = std::max(largest, std::abs(value));
  }
  bound = factor * bound + FactorRounding * largest;
}

void ScaleMoments(Moments& moments, double factor)
{
  const auto scale = [factor](double& value, double& bound)
  {
    value *= factor;
    bound = factor * bound + FactorRounding * std::abs(value);
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

/// Returns the uncertainty of a mass: sum, by the density, by gaps, by the numerical bound. The shares of
/// gaps and bound are those at the largest density; a factor of 1 + 1e-6 includes the rounding of the shares.
std::array<double, 4> GetMassUncertainty(const MassRow& row, double tolerance, double factor)
{
  const double density = tolerance * std::abs(row.Mass);
  const double gaps = (1.0 + tolerance) * factor * row.Spread.Volume;
  const double numerical = (1.0 + tolerance) * row.MassBound;
  return { (1.0 + 1e-6) * (density + gaps + numerical), density, gaps, numerical };
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

/// "bolt (3 times), nut, ..." of all bodies that have a volume and no density.
std::string NameBodiesWithoutDensity(
  const std::vector<BodyIntegrals>& bodies, const std::vector<MassRow>& rows)
{
  std::vector<std::string> order;
  std::map<std::string, int> counts;
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    if (std::isfinite(rows[b].Properties.Volume) && !(rows[b].Density > 0.0))
    {
      const std::string name = bodies[b].Name.empty() ? "solid " + bodies[b].Id : bodies[b].Name;
      if (counts[name]++ == 0)
      {
        order.push_back(name);
      }
    }
  }
  std::string text;
  for (std::size_t i = 0; i < std::min(order.size(), NamedSolids); ++i)
  {
    const int count = counts[order[i]];
    text += (i > 0 ? ", " : "") + order[i] + (count > 1 ? " (" + std::to_string(count) + " times)" : "");
  }
  return order.size() > NamedSolids ? text + " and " + std::to_string(order.size() - NamedSolids) + " more"
                                    : text;
}
}

Material ChooseMaterial(const BodyIntegrals& body, const MassAnalysisOptions& options)
{
  Material material;
  if (const MaterialRule* rule = FindRule(options.Materials, body.Name))
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
  }
  material.Tolerance = material.Tolerance >= 0.0 ? material.Tolerance : options.DensityTolerance;
  return material;
}

void SetMass(MassRow& row, const Material& material, const std::string& unit)
{
  const double factor = GetFactor(material.Density, unit);
  row.Material = material.Name;
  row.Density = material.Density > 0.0 ? material.Density : vtkMath::Nan();
  MassProperties& weighted = row.Weighted;
  weighted = row.Properties;
  std::array<double, 1> mass = { weighted.Volume };
  Scale(mass, weighted.VolumeBound, factor);
  weighted.Volume = mass[0];
  Scale(weighted.First, weighted.FirstBound, factor);
  Scale(weighted.Second, weighted.SecondBound, factor);
  Scale(weighted.Inertia, weighted.InertiaBound, factor);
  Scale(weighted.InertiaAtOrigin, weighted.InertiaAtOriginBound, factor);
  Scale(weighted.Principal, weighted.PrincipalBound, factor);
  if (!(factor > 0.0))
  {
    weighted = MassProperties();
  }
  row.Mass = weighted.Volume;
  row.MassBound = weighted.VolumeBound;
  row.WeightedSpread = row.Spread.GetWeighted(factor);
  row.MassUncertainty = GetMassUncertainty(row, material.Tolerance, factor);
  row.MassInertia = weighted.Inertia;
  row.MassInertiaBound = weighted.InertiaBound;
  if (factor > 0.0)
  {
    row.WeightedInFrame = row.InFrame;
    Scale(row.WeightedInFrame.Inertia, row.WeightedInFrame.InertiaBound, factor);
    Scale(row.WeightedInFrame.CentralInertia, row.WeightedInFrame.CentralInertiaBound, factor);
  }
}

void SetTotalMass(const std::vector<BodyIntegrals>& bodies, const std::vector<Moments>& parts,
  const Moments& sum, const std::vector<Moments>& spreads, const MassAnalysisOptions& options,
  MassAnalysis& analysis)
{
  MassRow& total = analysis.Total;
  double mass = 0.0;
  double bound = 0.0;
  std::array<double, 4> uncertainty{};
  std::vector<Moments> weighted;
  std::vector<Moments> weightedSpreads;
  std::size_t next = 0;
  for (const MassRow& row : analysis.Rows)
  {
    if (!std::isfinite(row.Properties.Volume))
    {
      continue;
    }
    Moments spread = spreads[next];
    Moments part = parts[next++];
    if (row.Density > 0.0)
    {
      mass += row.Mass;
      const double rounding = 2.0 * UnitRoundoff * std::abs(mass);
      bound += row.MassBound + rounding;
      uncertainty[0] += rounding;
      uncertainty[3] += rounding;
      for (int k = 0; k < 4; ++k)
      {
        uncertainty[k] += row.MassUncertainty[k];
      }
      ScaleMoments(part, GetFactor(row.Density, analysis.Unit));
      weighted.push_back(part);
      ScaleMoments(spread, GetFactor(row.Density, analysis.Unit));
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
    SetMass(total, ChooseMaterial(bodies.front(), options), analysis.Unit);
  }
  else if (!weighted.empty() && weighted.size() == parts.size())
  {
    // Densities may differ from part to part, and then the inertia is not density times VolumeInertia.
    total.Mass = mass;
    total.MassBound = bound;
    SetWeighted(total, Moments::Sum(weighted), options);
    total.WeightedSpread = ComputeSpread(weightedSpreads, mass, total.Weighted.Center);
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
    if (std::none_of(bodies.begin(), bodies.end(),
          [&](const BodyIntegrals& body) { return FindRule(options.Materials, body.Name) == &rule; }))
    {
      analysis.Messages.push_back("no solid gets its material from the pattern " + rule.Pattern);
    }
  }
}
}
