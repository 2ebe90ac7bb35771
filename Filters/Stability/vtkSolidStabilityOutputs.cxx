#include "smFormat.h"
#include "vtkSolidStabilityInternals.h"

#include "smBodyScales.h"
#include "smColumns.h"
#include "smMassPropertyNames.h"
#include "smMassTable.h"
#include "smStabilityNames.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace
{
namespace names = sm::names;

const char* GetDecider(const sm::StabilityResult& result)
{
  const bool decided = result.Decision == sm::Verdict::Stable || result.Decision == sm::Verdict::Unstable ||
    result.Decision == sm::Verdict::TooClose;
  return !decided ? "none" : result.ByRolling ? "rolling" : "margin";
}

double GetNumber(vtkFieldData* data, vtkIdType row, const std::string& name, int component = 0)
{
  vtkDataArray* array = data->GetArray(name.c_str());
  return array && row < array->GetNumberOfTuples() ? array->GetComponent(row, component) : vtkMath::Nan();
}

void SetCenter(sm::SupportedBody& body, vtkFieldData* data, vtkIdType row)
{
  for (int i = 0; i < 3; ++i)
  {
    body.Center[i] = GetNumber(data, row, names::CenterOfMass, i);
  }
  body.CenterBound = GetNumber(data, row, std::string(names::CenterOfMass) + names::BoundSuffix);
  body.Mass = GetNumber(data, row, names::Mass);
}

/// Solids of different density have their common centre where their masses balance: c = sum m_i c_i / sum
/// m_i. With bounds e_i of m_i and d_i of c_i, c is off by at most
/// (sum m_i d_i + e_i (|c_i - c| + d_i)) / (sum m_i - e_i).
void SetCommonCenter(sm::SupportedBody& body, vtkFieldData* rows, vtkIdType count)
{
  std::array<long double, 3> sum{};
  double mass = 0.0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    mass += GetNumber(rows, i, names::Mass);
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += static_cast<long double>(GetNumber(rows, i, names::Mass)) *
        GetNumber(rows, i, names::CenterOfMass, c);
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    body.Center[c] = static_cast<double>(sum[c] / mass);
  }
  double error = 0.0;
  double minimum = mass;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double m = GetNumber(rows, i, names::Mass);
    const double e = GetNumber(rows, i, std::string(names::Mass) + names::BoundSuffix);
    const double d = GetNumber(rows, i, std::string(names::CenterOfMass) + names::BoundSuffix);
    double squared = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      const double x = GetNumber(rows, i, names::CenterOfMass, c) - body.Center[c];
      squared += x * x;
    }
    error += m * d + e * (std::sqrt(squared) + d);
    minimum -= e;
  }
  const double size = std::abs(body.Center[0]) + std::abs(body.Center[1]) + std::abs(body.Center[2]);
  body.CenterBound = minimum > 0.0 ? error / minimum + 8e-16 * size : vtkMath::Nan();
  body.Mass = mass;
}

/// Returns true if every solid has a mass and their densities are not all equal.
bool HasDensities(vtkFieldData* rows, vtkIdType count)
{
  bool differ = false;
  double first = 0.0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double density = GetNumber(rows, i, names::Mass) / GetNumber(rows, i, names::Volume);
    if (!(density > 0.0))
    {
      return false;
    }
    first = i == 0 ? density : first;
    differ = differ || std::abs(density - first) > 1e-9 * first;
  }
  return differ;
}
}

namespace sm
{
const char* GetName(Verdict verdict)
{
  switch (verdict)
  {
    case Verdict::Stable:
      return names::VerdictStable;
    case Verdict::Unstable:
      return names::VerdictUnstable;
    case Verdict::TooClose:
      return names::VerdictTooClose;
    case Verdict::NoContact:
      return names::VerdictNoContact;
    case Verdict::BelowGround:
      return names::VerdictBelowGround;
    case Verdict::Unknown:
      break;
  }
  return names::VerdictUnknown;
}

const char* GetName(SupportKind support)
{
  return support == SupportKind::Area ? "area"
    : support == SupportKind::Line    ? "line"
    : support == SupportKind::Point   ? "point"
                                      : "none";
}
}

/// Returns true if some solids have a mass and some have none.
static bool LacksDensities(vtkFieldData* rows, vtkIdType count)
{
  vtkIdType known = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    known += GetNumber(rows, i, names::Mass) > 0.0 ? 1 : 0;
  }
  return known > 0 && known < count;
}

void vtkSolidStability::Internals::KeepChosen(std::vector<sm::BodyIntegrals>& bodies) const
{
  vtkTable* rows = vtkTable::SafeDownCast(this->Mass->GetOutputDataObject(1));
  auto* ids = vtkStringArray::SafeDownCast(rows->GetRowData()->GetAbstractArray(names::Id));
  std::set<std::string> chosen;
  for (vtkIdType i = 0; ids && i < ids->GetNumberOfValues(); ++i)
  {
    chosen.insert(ids->GetValue(i));
  }
  bodies.erase(std::remove_if(bodies.begin(), bodies.end(),
                 [&](const sm::BodyIntegrals& body) { return ids && chosen.count(body.Id) == 0; }),
    bodies.end());
}

/// Returns the rigid bodies to evaluate, each with its centre of mass.
std::vector<sm::SupportedBody> vtkSolidStability::Internals::Collect(
  const std::vector<sm::BodyIntegrals>& bodies, bool together)
{
  std::vector<sm::SupportedBody> supported;
  vtkFieldData* rows = vtkTable::SafeDownCast(this->Mass->GetOutputDataObject(1))->GetRowData();
  auto* status = vtkStringArray::SafeDownCast(rows->GetAbstractArray(names::Status));
  const auto count = static_cast<vtkIdType>(bodies.size());
  const auto setMetres = [](sm::SupportedBody& body)
  {
    const double metres = sm::GetMetres(body.Parts.front()->Model->GetLengthUnit());
    body.Metres = metres > 0.0 ? metres : vtkMath::Nan();
  };
  if (together && count > 0)
  {
    sm::SupportedBody all;
    all.Name = count == 1 ? bodies[0].Name : "all solids";
    all.Id = count == 1 ? bodies[0].Id : "";
    all.Status = this->Mass->GetStatus();
    for (const sm::BodyIntegrals& body : bodies)
    {
      all.Parts.push_back(&body);
    }
    if (count > 1 && HasDensities(rows, count) && sm::HaveOneUnit(bodies))
    {
      SetCommonCenter(all, rows, count);
    }
    else
    {
      SetCenter(all, this->Mass->GetOutput()->GetFieldData(), 0);
      if (LacksDensities(rows, count))
      {
        all.Mass = vtkMath::Nan();
        this->Messages.push_back("not every solid has a density: the common centre is weighted by volume");
      }
    }
    setMetres(all);
    supported.push_back(all);
  }
  for (vtkIdType i = 0; i < count && !together; ++i)
  {
    sm::SupportedBody body;
    body.Name = bodies[i].Name;
    body.Id = bodies[i].Id;
    body.Status = status && i < status->GetNumberOfValues() ? std::string(status->GetValue(i)) : "";
    body.Parts.push_back(&bodies[i]);
    SetCenter(body, rows, i);
    setMetres(body);
    supported.push_back(body);
  }
  return supported;
}

double vtkSolidStability::Internals::GetEnergy(const sm::SupportedBody& body, double rise, double strength)
{
  return body.Mass * strength * rise * body.Metres;
}

void vtkSolidStability::Internals::AddColumns(sm::columns::KeptArrays& arrays,
  const std::vector<sm::SupportedBody>& bodies, const sm::GroundDirections& ground, double strength,
  vtkFieldData* data)
{
  sm::columns::Writer writer(arrays, data, bodies.size());
  const auto texts = [&](const char* name, const auto& get)
  { std::transform(bodies.begin(), bodies.end(), writer.AddStrings(name), get); };
  const auto numbers = [&](const std::string& name, const auto& get)
  { std::transform(bodies.begin(), bodies.end(), writer.AddDoubles(name), get); };
  const auto counts = [&](const char* name, const auto& get)
  { std::transform(bodies.begin(), bodies.end(), writer.AddIntegers(name), get); };
  using Body = sm::SupportedBody;
  const std::string bound = names::BoundSuffix;
  texts(names::Name, [](const Body& b) { return b.Name; });
  texts(names::Id, [](const Body& b) { return b.Id; });
  texts(names::Stability, [](const Body& b) { return sm::GetName(b.Result.Decision); });
  texts(names::Support, [](const Body& b) { return sm::GetName(b.Result.Support); });
  texts(names::DecidedBy, [](const Body& b) { return GetDecider(b.Result); });
  numbers(names::StabilityMargin, [](const Body& b) { return b.Result.StabilityMargin; });
  numbers(names::StabilityMargin + bound, [](const Body& b) { return b.Result.StabilityMarginBound; });
  numbers(names::TipAngle, [](const Body& b) { return b.Result.TipAngle * sm::DegreesPerRadian; });
  numbers(
    names::TipAngle + bound, [](const Body& b) { return b.Result.TipAngleBound * sm::DegreesPerRadian; });
  numbers(names::CenterOfMassRise, [](const Body& b) { return b.Result.CenterOfMassRise; });
  numbers(names::CenterOfMassRise + bound, [](const Body& b) { return b.Result.CenterOfMassRiseBound; });
  numbers(names::TipEnergy,
    [strength](const Body& b) { return GetEnergy(b, b.Result.CenterOfMassRise, strength); });
  numbers(names::CenterHeight, [](const Body& b) { return b.Result.Height; });
  numbers(names::CenterHeight + bound, [](const Body& b) { return b.Result.HeightBound; });
  numbers(names::Clearance, [](const Body& b) { return 0.5 * (b.Clearance.Low + b.Clearance.High); });
  numbers(names::Clearance + bound, [](const Body& b) { return 0.5 * (b.Clearance.High - b.Clearance.Low); });
  numbers(names::RollingRadius, [](const Body& b) { return b.Result.RollingRadius; });
  numbers(names::RollingMargin, [](const Body& b) { return b.Result.RollingMargin; });
  numbers(names::RollingMargin + bound, [](const Body& b) { return b.Result.RollingMarginBound; });
  double* projected = writer.AddDoubles(names::ProjectedCenterOfMass, 3);
  double* center = writer.AddDoubles(names::CenterOfMass, 3);
  for (const Body& body : bodies)
  {
    projected =
      std::copy_n(body.ToWorld(ground, body.Result.ProjectedCenter, body.GroundHeight).data(), 3, projected);
    center = std::copy_n(body.Center.data(), 3, center);
  }
  numbers(names::CenterOfMass + bound, [](const Body& b) { return b.CenterBound; });
  counts(names::ContactFaces, [](const Body& b) { return b.ContactFaces; });
  counts(names::ContactEdges, [](const Body& b) { return b.ContactEdges; });
  texts(names::LengthUnit, [](const Body& b) { return b.Parts.front()->Model->GetLengthUnit(); });
  texts(names::Status, [](const Body& b) { return b.Status; });
}

void vtkSolidStability::Internals::AddSides(sm::columns::KeptArrays& arrays,
  const std::vector<sm::SupportedBody>& bodies, const sm::GroundDirections& ground, double strength,
  vtkTable* sides)
{
  std::size_t rows = 0;
  for (const sm::SupportedBody& body : bodies)
  {
    rows += body.Result.Sides.size();
  }
  sm::columns::Writer writer(arrays, sides->GetRowData(), rows);
  int* solid = writer.AddIntegers(names::Solid);
  double* from = writer.AddDoubles(names::SideFrom, 3);
  double* to = writer.AddDoubles(names::SideTo, 3);
  const std::string bound = names::BoundSuffix;
  std::vector<double*> columns;
  for (const std::string& name : { std::string(names::StabilityMargin), names::StabilityMargin + bound,
         std::string(names::TipAngle), names::TipAngle + bound, std::string(names::CenterOfMassRise),
         names::CenterOfMassRise + bound, std::string(names::TipEnergy) })
  {
    columns.push_back(writer.AddDoubles(name));
  }
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    const sm::SupportedBody& body = bodies[i];
    for (const sm::StabilitySide& side : body.Result.Sides)
    {
      *solid++ = static_cast<int>(i);
      from = std::copy_n(body.ToWorld(ground, side.From, body.GroundHeight).data(), 3, from);
      to = std::copy_n(body.ToWorld(ground, side.To, body.GroundHeight).data(), 3, to);
      const double values[7] = { side.StabilityMargin, side.StabilityMarginBound,
        side.TipAngle * sm::DegreesPerRadian, side.TipAngleBound * sm::DegreesPerRadian,
        side.CenterOfMassRise, side.CenterOfMassRiseBound, GetEnergy(body, side.CenterOfMassRise, strength) };
      for (std::size_t k = 0; k < columns.size(); ++k)
      {
        *columns[k]++ = values[k];
      }
    }
  }
}

std::string vtkSolidStability::Internals::GetSummary(
  const std::vector<sm::SupportedBody>& bodies, double strength)
{
  std::string text;
  const std::size_t maximum = 20;
  for (std::size_t i = 0; i < std::min(bodies.size(), maximum); ++i)
  {
    const sm::SupportedBody& body = bodies[i];
    const sm::StabilityResult& r = body.Result;
    const std::string unit = body.Parts.front()->Model->GetLengthUnit();
    text += (bodies.size() > 1 ? body.Name + ": " : std::string()) + sm::GetName(r.Decision);
    if (r.Support == sm::SupportKind::None)
    {
      const double height = 0.5 * (body.Clearance.Low + body.Clearance.High);
      const std::string distance = sm::FormatDistance(std::abs(height)) + " " + unit;
      text +=
        (r.Decision == sm::Verdict::NoContact ? ": its lowest point is " + distance + " above the ground"
            : r.Decision == sm::Verdict::BelowGround ? ": it reaches " + distance + " below the ground"
                                                     : std::string()) +
        "\n";
      continue;
    }
    text += std::string(", rests on ") +
      (r.Support == sm::SupportKind::Area      ? "an area"
          : r.Support == sm::SupportKind::Line ? "a line"
                                               : "a point") +
      "\n";
    text += "margin " + sm::FormatWithBound(r.StabilityMargin, r.StabilityMarginBound, unit) + "\n";
    if (r.ByRolling)
    {
      text += "rolling margin " + sm::FormatWithBound(r.RollingMargin, r.RollingMarginBound, unit) + "\n";
    }
    else
    {
      text += "tip angle " +
        sm::FormatWithBound(
          r.TipAngle * sm::DegreesPerRadian, r.TipAngleBound * sm::DegreesPerRadian, "deg") +
        "\n";
      text += "to tip, the centre must rise by " +
        sm::FormatWithBound(r.CenterOfMassRise, r.CenterOfMassRiseBound, unit) + "\n";
    }
    const double energy = GetEnergy(body, r.CenterOfMassRise, strength);
    if (std::isfinite(energy) && !r.ByRolling)
    {
      text += "energy to tip " + sm::FormatNumber(energy, 1e-6 * energy) + " J\n";
    }
  }
  return bodies.size() > maximum ? text + "and " + std::to_string(bodies.size() - maximum) + " more\n" : text;
}
