#include "smPartsFields.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
Status FindStatus(const std::string& text)
{
  for (int i = 0; i <= static_cast<int>(Status::Unreadable); ++i)
  {
    if (text == GetText(static_cast<Status>(i)))
    {
      return static_cast<Status>(i);
    }
  }
  return Status::None;
}

void Visit(Fields& fields, PartsSums& sums)
{
  const bool isWhole = sums.HasWholeMass();
  double volume = sums.Volume.GetValue(), volumeBound = sums.Volume.GetBound();
  double area = sums.Area.GetValue(), areaBound = sums.Area.GetBound();
  double known = sums.Mass.GetValue(), knownBound = sums.Mass.GetBound();
  double mass = isWhole ? known : Unknown, massBound = isWhole ? knownBound : Unknown;
  long long withMass = sums.Mass.Terms, withVolume = sums.Volume.Terms;
  fields.Note("L^3", "").Number("volume", volume);
  fields.Note("L^2", "").Number("area", area);
  fields.Note("kg", "if all solids have a density").Number("mass", mass);
  fields.Note("kg", "of the solids that have a density").Number("known_mass", known);
  fields.Count("solids_with_mass", withMass);
  fields.Count("solids_with_volume", withVolume);
  fields.Note("", "of the quantities with the same names").Begin("bounds");
  fields.Number("volume", volumeBound);
  fields.Number("area", areaBound);
  fields.Number("mass", massBound);
  fields.Number("known_mass", knownBound);
  fields.End();
  sums.Volume = { volume, volumeBound, static_cast<int>(withVolume) };
  sums.Area = { area, areaBound, std::isnan(area) ? 0 : std::max(sums.Area.Terms, 1) };
  sums.Mass = { known, knownBound, static_cast<int>(withMass) };
}

void VisitNumber(Fields& fields, const char* key, int& number)
{
  long long count = number;
  fields.Count(key, count);
  number = static_cast<int>(count);
}
}

void VisitPart(Fields& fields, PartsListEntry& part)
{
  std::string kind = part.IsAssembly ? "assembly" : "part";
  std::string status = GetText(part.Status);
  fields.Text("name", part.Name);
  fields.Note("", "`part` or `assembly`").Text("kind", kind);
  VisitNumber(fields, "count", part.Count);
  VisitNumber(fields, "count_in_all", part.CountInAll);
  VisitNumber(fields, "solids", part.Solids);
  fields.Note("", "the worst of its solids").Text("status", status);
  fields.Note("", "of the first product").Name("layer", part.Layer);
  fields.Note("", "as `density`").Name("material", part.Material);
  fields.Note("kg/m^3", "if all solids have the same").Number("density", part.Density);
  fields.Note("", "sums of one product").Begin("each");
  Visit(fields, part.Each);
  fields.End();
  fields.Note("", "sums of all these products").Begin("in_all");
  Visit(fields, part.InAll);
  fields.End();
  fields.Note("", "the products that it consists of, with the same keys")
    .List("children", part.Children, [&](PartsListEntry& child) { VisitPart(fields, child); });
  part.IsAssembly = kind == "assembly";
  part.Status = FindStatus(status);
}
}
