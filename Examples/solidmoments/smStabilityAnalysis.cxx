#include "smStabilityAnalysis.h"

#include "smBoxAnalysis.h"
#include "smOptionValues.h"
#include "smOptions.h"
#include "smReportRows.h"
#include "smTableText.h"

namespace sm
{
void StabilityResult::Visit(Fields& fields, const char* key)
{
  fields.Note("", "with `--stability`").Begin(key);
  fields.Note("", "`stable`, `unstable`, `too-close`, `no-contact`, `below-ground` or `unknown`")
    .Text("verdict", this->Verdict);
  fields.Note("", "`area`, `line`, `point` or `none`").Text("support", this->Support);
  fields.Note("", "`margin`, `rolling` or `none`").Text("decided_by", this->DecidedBy);
  fields.Note("L", "signed distance of the projected centre of mass to the nearest side")
    .Number("stability_margin", this->Margin);
  fields.Note("degrees", "smallest").Number("tip_angle", this->TipAngle);
  fields.Note("L", "before tipping").Number("center_of_mass_rise", this->Rise);
  fields.Note("L", "of the centre of mass above the ground").Number("center_height", this->CenterHeight);
  fields.Note("L", "where curvature decides").Number("rolling_margin", this->RollingMargin);
  fields.Note("", "of the quantities with the same names").Begin("bounds");
  fields.Number("stability_margin", this->Margin.Bound);
  fields.Number("tip_angle", this->TipAngle.Bound);
  fields.Number("center_of_mass_rise", this->Rise.Bound);
  fields.Number("center_height", this->CenterHeight.Bound);
  fields.Number("rolling_margin", this->RollingMargin.Bound);
  fields.End();
  fields.Note("J", "with a mass").Number("tip_energy", this->TipEnergy);
  fields.Note("L", "").Number("rolling_radius", this->RollingRadius);
  fields.Note("L", "on the ground").Point("projected_center_of_mass", this->ProjectedCenter.Value);
  fields.Note("", "that touch the ground").Count("contact_faces", this->ContactFaces);
  fields.Note("", "that touch the ground").Count("contact_edges", this->ContactEdges);
  fields.Note("", "of the support polygon")
    .List("sides", this->Sides,
      [&fields](StabilitySide& side)
      {
        fields.Point("from", side.From);
        fields.Point("to", side.To);
        fields.Number("stability_margin", side.Margin);
        fields.Number("tip_angle", side.TipAngle);
        fields.Number("center_of_mass_rise", side.Rise);
      });
  fields.End();
}

std::string StabilityResult::FormatRows(const std::string& unit) const
{
  const bool rolls = this->DecidedBy == "rolling";
  std::string text = Row("stability",
    this->Verdict +
      (this->Support == "none"
          ? ""
          : ", rests on " + (this->Support == "area" ? "an area" : "a " + this->Support)) +
      (rolls ? ", decided by its curvature" : ""),
    "");
  text += MeasuredRow("stability margin", this->Margin, unit);
  if (rolls)
  {
    return text + MeasuredRow("rolling margin", this->RollingMargin, unit);
  }
  text += MeasuredRow("smallest tip angle", this->TipAngle, "degrees");
  text += MeasuredRow("rise before tipping", this->Rise, unit);
  return std::isnan(this->TipEnergy)
    ? text
    : text + Row("energy to tip", FormatValue(this->TipEnergy, Unknown, 9), "J");
}

void StabilityAnalysis::Declare(CLI::App& app)
{
  app.option_defaults()->group("Static stability");
  app
    .add_option("--stability", this->Direction,
      "Static stability of the part, resting on its lowest points, under gravity\n"
      "along DIR, x, y, z, +x .. -z or three numbers: the stability margin\n"
      "(signed distance from the projected centre of mass to the nearest edge\n"
      "of the support polygon), tip angle and rise of the centre of mass before\n"
      "tipping, with bounds; for all solids as one body, and for each alone:\n"
      "--stability -z")
    ->type_name("DIR")
    ->check(CheckDirection)
    ->expected(1);
}

void BoxAnalysis::Declare(CLI::App& app)
{
  app.option_defaults()->group("Materials and frame");
  app.add_flag("--box", this->Wanted,
    "Bounding boxes of the trimmed surfaces, with a bound; takes time for large parts");
}
}
