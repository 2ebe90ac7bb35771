#include "smSectionAnalysis.h"

#include "smColumns.h"
#include "smOptionValues.h"
#include "smOptions.h"
#include "smReportRows.h"
#include "smTableText.h"

namespace sm
{
namespace
{
std::string CheckPlane(const std::string& text)
{
  std::array<double, 6> plane;
  return ParsePlane(text, plane)
    ? ""
    : text + " is not a plane; write a point and a normal that is not 0, six numbers such as 0,0,5,0,0,1";
}

void VisitSection(Fields& fields, SectionEntry& section)
{
  fields.Note("L", "of the plane").Numbers("point", section.Plane.data(), 1, 3);
  fields.Note("", "of the plane").Numbers("normal", section.Plane.data() + 3, 1, 3);
  fields.Note("1", "of the principal moments")
    .Numbers("principal_directions", section.PrincipalDirections.Value.data(), 2, 3);
  fields.Note("L^2", "").Number("area", section.Area);
  fields.Note("L", "").Point("centroid", section.Centroid.Value);
  fields.Note("L^4", "about the centroid").Matrix("second_moments", section.SecondMoments.Value);
  fields.Note("L^4", "ascending").Numbers("principal_moments", section.PrincipalMoments.Value.data(), 1, 2);
  fields.Note("L^3", "against the normal").Number("volume_below", section.VolumeBelow);
  fields.Note("L", "").Point("center_below", section.CenterBelow.Value);
  fields.Note("kg", "with one density for all solids").Number("mass_below", section.MassBelow);
  fields.Note("L^3", "").Number("volume_above", section.VolumeAbove);
  fields.Note("L", "").Point("center_above", section.CenterAbove.Value);
  fields.Note("kg", "").Number("mass_above", section.MassAbove);
}

/// Adds the columns of what lies on one side, each with its bound.
void AddSide(const std::string& stem, const std::string& side, const ScalarQuantity& volume,
  const VectorQuantity& center, const ScalarQuantity& mass, Columns& columns)
{
  columns.Add(stem + "_volume_" + side, volume.Get());
  columns.Add(stem + "_volume_" + side + "_bound", volume.Bound);
  columns.AddPoint(stem + "_center_" + side, center.Value);
  columns.Add(stem + "_center_" + side + "_bound", center.Bound);
  columns.Add(stem + "_mass_" + side, mass.Get());
  columns.Add(stem + "_mass_" + side + "_bound", mass.Bound);
}

template <std::size_t N>
std::string KnownRow(const char* label, const Quantity<N>& quantity, const std::string& unit)
{
  std::string text;
  for (const double number : quantity.Value)
  {
    text += (text.empty() ? "" : "  ") + FormatValue(number, quantity.Bound);
  }
  return quantity.IsKnown() ? BoundedRow(label, text, unit, quantity.Bound) : std::string();
}
}

void SectionResult::Visit(Fields& fields, const char* key)
{
  fields.Note("", "with `--section`")
    .List(key, this->Sections,
      [&](SectionEntry& section)
      {
        VisitSection(fields, section);
        fields.Note("", "of the quantities with the same names").Begin("bounds");
        fields.Number("area", section.Area.Bound);
        fields.Number("centroid", section.Centroid.Bound);
        fields.Number("second_moments", section.SecondMoments.Bound);
        fields.Number("principal_moments", section.PrincipalMoments.Bound);
        fields.Number("volume_below", section.VolumeBelow.Bound);
        fields.Number("center_below", section.CenterBelow.Bound);
        fields.Number("volume_above", section.VolumeAbove.Bound);
        fields.Number("center_above", section.CenterAbove.Bound);
        fields.Number("mass_below", section.MassBelow.Bound);
        fields.Number("mass_above", section.MassAbove.Bound);
        fields.End();
      });
}

void SectionResult::AddColumns(Columns& columns) const
{
  for (std::size_t i = 0; i < this->Sections.size(); ++i)
  {
    const SectionEntry& section = this->Sections[i];
    const std::string stem = "section" + std::to_string(i + 1);
    columns.Note("of the first section, `section2_point_x` and so on of the next");
    columns.Add(stem + "_point", section.Plane.data(), { "x", "y", "z" });
    columns.Add(stem + "_normal", section.Plane.data() + 3, { "x", "y", "z" });
    columns.Add(stem + "_area", section.Area.Get());
    columns.Add(stem + "_area_bound", section.Area.Bound);
    columns.AddPoint(stem + "_centroid", section.Centroid.Value);
    columns.Add(stem + "_centroid_bound", section.Centroid.Bound);
    columns.AddMatrix(stem + "_second_moments", section.SecondMoments.Value);
    columns.Add(stem + "_second_moments_bound", section.SecondMoments.Bound);
    columns.Add(stem + "_principal_moments", section.PrincipalMoments.Value.data(), { "1", "2" });
    columns.Add(stem + "_principal_moments_bound", section.PrincipalMoments.Bound);
    AddSide(stem, "below", section.VolumeBelow, section.CenterBelow, section.MassBelow, columns);
    AddSide(stem, "above", section.VolumeAbove, section.CenterAbove, section.MassAbove, columns);
  }
}

std::string SectionResult::FormatRows(const std::string& unit) const
{
  std::string text;
  for (const SectionEntry& section : this->Sections)
  {
    text += Row("section at",
      FormatVector(section.Plane.data(), 1e-9) + "  normal  " + FormatVector(section.Plane.data() + 3, 1e-9),
      "");
    text += MeasuredRow("  its area", section.Area, RaiseUnit(unit, 2));
    text += KnownRow("  its centroid", section.Centroid, unit);
    text += KnownRow("  second moments", section.PrincipalMoments, RaiseUnit(unit, 4));
    text += KnownRow("  volume below", section.VolumeBelow, RaiseUnit(unit, 3));
    text += KnownRow("  centre below", section.CenterBelow, unit);
    text += KnownRow("  mass below", section.MassBelow, "kg");
    text += KnownRow("  volume above", section.VolumeAbove, RaiseUnit(unit, 3));
    text += KnownRow("  centre above", section.CenterAbove, unit);
    text += KnownRow("  mass above", section.MassAbove, "kg");
  }
  return text;
}

void SectionAnalysis::Declare(CLI::App& app)
{
  app.option_defaults()->group("Sections");
  AddRepeatedOption(app, "--section",
    "Section with the plane through the point X,Y,Z, in the unit of the\n"
    "results, with the normal NX,NY,NZ: its area, centroid and second moments,\n"
    "and volume, centre and mass on either side; may be given several times",
    [this](const std::string& text) { ParsePlane(text, this->Planes.emplace_back()); })
    ->type_name("X,Y,Z,NX,NY,NZ")
    ->check(CheckPlane);
}

std::unique_ptr<AnalysisResult> SectionAnalysis::MakeResult() const
{
  auto result = std::make_unique<SectionResult>();
  for (const std::array<double, 6>& plane : this->Planes)
  {
    result->Sections.emplace_back();
    result->Sections.back().Plane = plane;
  }
  return result;
}
}
