#include "smMassTable.h"

#include "smFormat.h"
#include "smMassPropertyNames.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
/// Smallest plausible density of a solid in kg/m^3. A smaller number was probably given in g/cm^3.
constexpr double MinDensity = 25.0;
/// Largest number of characters of a line of a summary; longer lines are broken, because narrow views would
/// cut them off.
constexpr std::size_t MaxLine = 66;
/// Relative uncertainty of a mass from which the summary states it.
constexpr double NotableDoubt = 1e-6;

struct Quantity
{
  const char* Name;
  int Components;
  bool HasBound;
  const double* (*Values)(const MassRow&);
  const double* (*Bound)(const MassRow&);
  /// Null if the quantity has no spread.
  const double* (*Spread)(const MassRow&) = nullptr;
};

using Row = const MassRow&;

const Quantity Quantities[] = {
  { names::Volume, 1, true, [](Row r) { return &r.Properties.Volume; },
    [](Row r) { return &r.Properties.VolumeBound; }, [](Row r) { return &r.Spread.Volume; } },
  { names::SurfaceArea, 1, true, [](Row r) { return &r.Area; }, [](Row r) { return &r.AreaBound; },
    [](Row r) { return &r.AreaSpread; } },
  { names::CenterOfMass, 3, true, [](Row r) { return r.Properties.Center.data(); },
    [](Row r) { return &r.Properties.CenterBound; }, [](Row r) { return &r.Spread.Center; } },
  { names::FirstMoments, 3, true, [](Row r) { return r.Properties.First.data(); },
    [](Row r) { return &r.Properties.FirstBound; } },
  { names::SecondMoments, 6, true, [](Row r) { return r.Properties.Second.data(); },
    [](Row r) { return &r.Properties.SecondBound; } },
  { names::VolumeInertia, 9, true, [](Row r) { return r.Properties.Inertia.data(); },
    [](Row r) { return &r.Properties.InertiaBound; }, [](Row r) { return &r.Spread.Inertia; } },
  { names::VolumeInertiaAtOrigin, 9, true, [](Row r) { return r.Properties.InertiaAtOrigin.data(); },
    [](Row r) { return &r.Properties.InertiaAtOriginBound; } },
  { names::PrincipalMoments, 3, true, [](Row r) { return r.Properties.Principal.data(); },
    [](Row r) { return &r.Properties.PrincipalBound; }, [](Row r) { return &r.Spread.Principal; } },
  { names::PrincipalAxes, 9, true, [](Row r) { return r.Properties.Axes.data(); },
    [](Row r) { return &r.Properties.AxesBound; } },
  { names::RadiiOfGyration, 3, true, [](Row r) { return r.Properties.Gyration.data(); },
    [](Row r) { return &r.Properties.GyrationBound; } },
  { names::BoundsMeasured, 4, false, [](Row r) { return r.MeasuredBounds.data(); }, nullptr },
  { names::ClosureCorrection, 1, false, [](Row r) { return &r.ClosureCorrection; }, nullptr },
  { names::GapSquared, 1, false, [](Row r) { return &r.GapSquared; }, nullptr },
  { names::MaxGap, 1, false, [](Row r) { return &r.MaxGap; }, nullptr },
  { names::GapArea, 1, false, [](Row r) { return &r.GapArea; }, nullptr },
  { names::ClosureResidual, 1, false, [](Row r) { return &r.ClosureResidual; }, nullptr },
};

const Quantity MassQuantities[] = {
  { names::Mass, 1, true, [](Row r) { return &r.Mass; }, [](Row r) { return &r.MassBound; },
    [](Row r) { return &r.WeightedSpread.Volume; } },
  { names::MassInertia, 9, true, [](Row r) { return r.MassInertia.data(); },
    [](Row r) { return &r.MassInertiaBound; }, [](Row r) { return &r.WeightedSpread.Inertia; } },
  { names::MassCenter, 3, true, [](Row r) { return r.Weighted.Center.data(); },
    [](Row r) { return &r.Weighted.CenterBound; }, [](Row r) { return &r.WeightedSpread.Center; } },
  { names::MassPrincipalMoments, 3, true, [](Row r) { return r.Weighted.Principal.data(); },
    [](Row r) { return &r.Weighted.PrincipalBound; }, [](Row r) { return &r.WeightedSpread.Principal; } },
  { names::MassPrincipalAxes, 9, true, [](Row r) { return r.Weighted.Axes.data(); },
    [](Row r) { return &r.Weighted.AxesBound; } },
  { names::MassRadiiOfGyration, 3, true, [](Row r) { return r.Weighted.Gyration.data(); },
    [](Row r) { return &r.Weighted.GyrationBound; } },
  { names::Density, 1, false, [](Row r) { return &r.Density; }, nullptr },
  { names::MassUncertainty, 5, false, [](Row r) { return r.MassUncertainty.data(); }, nullptr },
  { names::OverriddenMass, 1, false, [](Row r) { return &r.OverriddenMass; }, nullptr },
};

const Quantity FrameQuantities[] = {
  { names::CenterOfMassInFrame, 3, true, [](Row r) { return r.InFrame.Center.data(); },
    [](Row r) { return &r.InFrame.CenterBound; } },
  { names::VolumeInertiaInFrame, 9, true, [](Row r) { return r.InFrame.Inertia.data(); },
    [](Row r) { return &r.InFrame.InertiaBound; } },
  { names::CentralInertiaInFrame, 9, true, [](Row r) { return r.InFrame.CentralInertia.data(); },
    [](Row r) { return &r.InFrame.CentralInertiaBound; } },
};

const Quantity MassFrameQuantities[] = {
  { names::MassCenterInFrame, 3, true, [](Row r) { return r.WeightedInFrame.Center.data(); },
    [](Row r) { return &r.WeightedInFrame.CenterBound; } },
  { names::MassInertiaInFrame, 9, true, [](Row r) { return r.WeightedInFrame.Inertia.data(); },
    [](Row r) { return &r.WeightedInFrame.InertiaBound; } },
  { names::MassCentralInertiaInFrame, 9, true, [](Row r) { return r.WeightedInFrame.CentralInertia.data(); },
    [](Row r) { return &r.WeightedInFrame.CentralInertiaBound; } },
};

/// Calls `use` for each quantity, in the order of the columns.
template <typename Use>
void ForEachQuantity(bool withMass, bool withFrame, const Use& use)
{
  std::for_each(std::begin(Quantities), std::end(Quantities), use);
  if (withMass)
  {
    std::for_each(std::begin(MassQuantities), std::end(MassQuantities), use);
  }
  if (withFrame)
  {
    std::for_each(std::begin(FrameQuantities), std::end(FrameQuantities), use);
  }
  if (withMass && withFrame)
  {
    std::for_each(std::begin(MassFrameQuantities), std::end(MassFrameQuantities), use);
  }
}
}

MassRow::MassRow()
{
  this->Area = this->AreaBound = this->Mass = this->MassBound = this->OverriddenMass =
    this->MassInertiaBound = this->Density = this->KnownMass = this->KnownMassBound = this->AreaSpread =
      this->ClosureCorrection = this->GapSquared = this->MaxGap = this->GapArea = this->ClosureResidual =
        std::numeric_limits<double>::quiet_NaN();
  this->MassInertia.fill(this->Mass);
  this->MassUncertainty.fill(this->Mass);
  this->MeasuredBounds.fill(this->Mass);
}

double MassRow::GetAddedDensity() const
{
  return this->OverriddenMass > 0.0 && !(this->ShareOfProduct > 0.0)
    ? 0.0
    : (1.0 - this->ShareOfProduct) * this->Mass / this->Properties.Volume;
}

void MassRow::RemoveBounds()
{
  MassProperties& p = this->Properties;
  MassProperties& w = this->Weighted;
  double& numerical = this->MassUncertainty[3];
  for (double* bound : { &p.VolumeBound, &p.CenterBound, &p.FirstBound, &p.SecondBound, &p.InertiaBound,
         &p.InertiaAtOriginBound, &p.PrincipalBound, &p.AxesBound, &p.GyrationBound, &this->AreaBound,
         &this->MassBound, &numerical, &this->MassUncertainty[0], &this->MassInertiaBound,
         &this->KnownMassBound, &w.VolumeBound, &w.CenterBound, &w.InertiaBound, &w.PrincipalBound,
         &w.AxesBound, &w.GyrationBound, &this->InFrame.CenterBound, &this->InFrame.InertiaBound,
         &this->WeightedInFrame.CenterBound, &this->WeightedInFrame.InertiaBound,
         &this->InFrame.CentralInertiaBound, &this->WeightedInFrame.CentralInertiaBound })
  {
    *bound = std::numeric_limits<double>::quiet_NaN();
  }
  this->MeasuredBounds.fill(std::numeric_limits<double>::quiet_NaN());
}

void WriteMassRows(
  const MassRow* rows, std::size_t count, bool withMass, bool withFrame, columns::Writer& writer)
{
  ForEachQuantity(withMass, withFrame,
    [&](const Quantity& quantity)
    {
      double* values = writer.AddDoubles(quantity.Name, quantity.Components);
      for (std::size_t i = 0; i < count; ++i)
      {
        values = std::copy_n(quantity.Values(rows[i]), quantity.Components, values);
      }
      double* bounds =
        quantity.HasBound ? writer.AddDoubles(std::string(quantity.Name) + names::BoundSuffix) : nullptr;
      for (std::size_t i = 0; i < count && bounds; ++i)
      {
        bounds[i] = *quantity.Bound(rows[i]);
      }
      double* spreads =
        quantity.Spread ? writer.AddDoubles(std::string(quantity.Name) + names::SpreadSuffix) : nullptr;
      for (std::size_t i = 0; i < count && spreads; ++i)
      {
        spreads[i] = *quantity.Spread(rows[i]);
      }
    });
  double* degenerate = writer.AddDoubles(names::PrincipalAxesDegenerate);
  for (std::size_t i = 0; i < count; ++i)
  {
    const MassProperties& properties = rows[i].Properties;
    const double principal = properties.Principal[0];
    degenerate[i] = std::isnan(principal) ? principal : properties.AxesDegenerate ? 1.0 : 0.0;
  }
}

std::string FormatSummary(
  const MassRow& total, const std::string& unit, int solids, int weighed, int weighable)
{
  const MassProperties& p = total.Properties;
  const auto triple = [](const std::string& label, const std::array<double, 3>& values, double bound,
                        const std::string& inUnit, double spread)
  {
    const bool known = std::isfinite(values[0] + values[1] + values[2]);
    const std::string line = known ? FormatNumber(values[0], bound) + "  " + FormatNumber(values[1], bound) +
        "  " + FormatNumber(values[2], bound) + " " + inUnit + FormatBoundNote(bound, spread, "spread")
                                   : std::string("not known");
    return label + (label.size() + line.size() < MaxLine ? " " : "\n  ") + line + "\n";
  };
  std::string text;
  if (solids > 1)
  {
    text += "Solids: " + std::to_string(solids) + "\n";
  }
  text +=
    "Volume: " + FormatWithBound(p.Volume, p.VolumeBound, unit + "^3", total.Spread.Volume, "spread") + "\n";
  text +=
    "Area: " + FormatWithBound(total.Area, total.AreaBound, unit + "^2", total.AreaSpread, "spread") + "\n";
  // Where densities differ, or are not all known, the centre of the volume is not that of the mass.
  const bool isMixed = std::isfinite(total.KnownMass) && !std::isfinite(total.Density);
  if (std::isfinite(p.Center[0]))
  {
    const char* label = isMixed ? "Centre of volume:" : "Centre of mass:";
    text += triple(label, p.Center, p.CenterBound, unit, total.Spread.Center);
  }
  if (std::isfinite(total.Mass))
  {
    text +=
      "Mass: " + FormatWithBound(total.Mass, total.MassBound, "kg", total.WeightedSpread.Volume, "spread") +
      "\n";
    text += total.OverriddenMass > 0.0
      ? "Mass that the materials state: " + FormatDigits(total.OverriddenMass, 10) + " kg\n"
      : "";
    text += total.Density < MinDensity && !(total.OverriddenMass > 0.0)
      ? "A density of " + FormatDigits(total.Density, 6) + " kg/m^3 is that of foam: steel has 7850\n"
      : "";
    // The share of gaps is not known for open solids.
    const bool isWhole = !std::isnan(total.MassUncertainty[0]);
    const double doubt =
      isWhole ? total.MassUncertainty[0] : total.MassUncertainty[1] + total.MassUncertainty[4];
    text += doubt > std::max(2.0 * total.MassBound, NotableDoubt * std::abs(total.Mass))
      ? "Mass in doubt by " + FormatBound(doubt) + " kg, for its density" +
        (total.OverriddenMass > 0.0 ? ", stated masses" : "") +
        (isWhole ? " and gaps\n" : " alone: open edges may change it more\n")
      : "";
    const MassProperties& w = total.Weighted;
    const MassSpread& s = total.WeightedSpread;
    text += isMixed ? triple("Centre of mass:", w.Center, w.CenterBound, unit, s.Center) : std::string();
    text += triple("Principal moments:", w.Principal, w.PrincipalBound, "kg " + unit + "^2", s.Principal);
  }
  else
  {
    text += std::isfinite(p.Center[0])
      ? triple("Principal moments:", p.Principal, p.PrincipalBound, unit + "^5", total.Spread.Principal)
      : std::string();
    text += std::isfinite(total.KnownMass)
      ? "Mass of " + std::to_string(weighed) + " of " + std::to_string(weighable) +
        " solids: " + FormatWithBound(total.KnownMass, total.KnownMassBound, "kg") + "\n"
      : weighable > 0 ? "Mass: not known, for there is no density\n"
                      : "";
  }
  return text;
}
}
