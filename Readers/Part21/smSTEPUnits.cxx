// Reads the units and accuracies that the contexts of a census state.
#include "smSTEPUnits.h"

#include "smSTEPCensusTaker.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
constexpr STEPAttribute ContextOfItems = { "REPRESENTATION", 2, 2, "context" };
constexpr STEPAttribute UncertaintiesOfContext = { "GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT", 0, 2,
  "uncertainties" };

/// Largest number of conversions from unit to unit; inch to millimetre is one.
constexpr int MaxConversion = 8;
/// The record of a complex unit, the unit of SI, what it is in the unit of the result, the smallest and
/// largest that is not damage, and the relative accuracy with which factors are written: 0.01745 for a degree
/// is off by 1.9e-4, 0.4536 for a pound by 2e-5; of lengths, which are exact, the foot of American surveyors
/// by 2e-6.
struct SIKind
{
  std::string_view Record;
  std::string_view Name;
  double Factor;
  double Smallest;
  double Largest;
  double Accuracy;
};
const SIKind SIKinds[] = { { "LENGTH_UNIT", "METRE", 1e3, 1e-6, 1e6, 3e-6 },
  { "PLANE_ANGLE_UNIT", "RADIAN", 1.0, 1e-6, 6.4, 2e-4 }, { "MASS_UNIT", "GRAM", 1e-3, 1e-15, 1e6, 1e-3 } };

struct NamedFactor
{
  std::string_view Name;
  double Factor;
};
const NamedFactor Prefixes[] = { { "EXA", 1e18 }, { "PETA", 1e15 }, { "TERA", 1e12 }, { "GIGA", 1e9 },
  { "MEGA", 1e6 }, { "KILO", 1e3 }, { "HECTO", 1e2 }, { "DECA", 1e1 }, { "DECI", 1e-1 }, { "CENTI", 1e-2 },
  { "MILLI", 1e-3 }, { "MICRO", 1e-6 }, { "NANO", 1e-9 }, { "PICO", 1e-12 }, { "FEMTO", 1e-15 },
  { "ATTO", 1e-18 } };
/// In millimetres, radians and kilograms, by the names of ISO 10303-41 and those that are common.
const NamedFactor Conversions[] = { { "INCH", 25.4 }, { "INCHES", 25.4 }, { "IN", 25.4 }, { "FOOT", 304.8 },
  { "FEET", 304.8 }, { "FT", 304.8 }, { "YARD", 914.4 }, { "MILE", 1609344.0 }, { "MIL", 0.0254 },
  { "MICROINCH", 25.4e-6 }, { "MICRON", 1e-3 }, { "MICROMETRE", 1e-3 }, { "MILLIMETRE", 1.0 },
  { "MILLIMETER", 1.0 }, { "MM", 1.0 }, { "CENTIMETRE", 10.0 }, { "CENTIMETER", 10.0 }, { "CM", 10.0 },
  { "METRE", 1e3 }, { "METER", 1e3 }, { "M", 1e3 }, { "KILOMETRE", 1e6 }, { "RADIAN", 1.0 },
  { "DEGREE", 0.017453292519943295 }, { "DEGREES", 0.017453292519943295 }, { "DEG", 0.017453292519943295 },
  { "GRAD", 0.015707963267948967 }, { "GON", 0.015707963267948967 }, { "POUND", 0.45359237 },
  { "POUNDS", 0.45359237 }, { "LB", 0.45359237 }, { "LBM", 0.45359237 }, { "OUNCE", 0.028349523125 },
  { "OZ", 0.028349523125 }, { "SLUG", 14.593902937 }, { "GRAM", 1e-3 }, { "KILOGRAM", 1.0 }, { "KG", 1.0 },
  { "TONNE", 1e3 }, { "METRIC TON", 1e3 } };

template <std::size_t N>
const NamedFactor* FindFactor(const NamedFactor (&table)[N], std::string_view name)
{
  const std::size_t first = name.find_first_not_of(' ');
  std::string capitals(name.substr(std::min(first, name.size()), name.find_last_not_of(' ') - first + 1));
  for (char& c : capitals)
  {
    c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  for (const NamedFactor& entry : table)
  {
    if (entry.Name == capitals)
    {
      return &entry;
    }
  }
  return nullptr;
}

/// Records of units and contexts in complex instances, and simple measures, by the number of their
/// parameters.
struct UnitRecord
{
  std::string_view Type;
  int Parameters;
};
const UnitRecord UnitRecords[] = { { "NAMED_UNIT", 1 }, { "SI_UNIT", 2 }, { "CONVERSION_BASED_UNIT", 2 },
  { "LENGTH_UNIT", 0 }, { "PLANE_ANGLE_UNIT", 0 }, { "MASS_UNIT", 0 }, { "MEASURE_WITH_UNIT", 2 },
  { "LENGTH_MEASURE_WITH_UNIT", 2 }, { "PLANE_ANGLE_MEASURE_WITH_UNIT", 2 }, { "MASS_MEASURE_WITH_UNIT", 2 },
  { "GEOMETRIC_REPRESENTATION_CONTEXT", 1 }, { "REPRESENTATION_CONTEXT", 2 },
  { "GLOBAL_UNIT_ASSIGNED_CONTEXT", 1 }, { "GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT", 1 },
  { "PARAMETRIC_REPRESENTATION_CONTEXT", 0 } };

/// OpenCASCADE ignores a unit or context that has a parameter too many, or too few, and takes other units.
bool HasWrongCount(const Part21File& file, Part21File::Index unit)
{
  for (std::size_t r = 0; r < file.GetNumberOfRecords(unit); ++r)
  {
    const std::string& type = file.GetTypeNames()[file.GetType(unit, r)];
    for (const UnitRecord& record : UnitRecords)
    {
      if (record.Type != type)
      {
        continue;
      }
      // A simple unit has its dimensions, too.
      const bool isSimpleUnit =
        !file.IsComplex(unit) && (type == SIName.Record || type == ConversionFactor.Record);
      int count = 0;
      Part21Values values(file.GetParameters(unit, r));
      for (Part21Value value; values.Next(value);)
      {
        ++count;
      }
      if (count != record.Parameters + (isSimpleUnit ? 1 : 0))
      {
        return true;
      }
    }
  }
  return false;
}

/// OpenCASCADE knows a complex unit by its three records, and takes another for one that has others.
bool HasWrongRecords(const STEPAttributes& entities, Part21File::Index unit, const SIKind& kind)
{
  std::string_view record;
  return entities.File.IsComplex(unit) &&
    (entities.File.GetNumberOfRecords(unit) != 3 || !entities.FindRecord(unit, "NAMED_UNIT", record) ||
      !entities.FindRecord(unit, kind.Record, record));
}

/// Returns true for a context with other records than these, or with a wrong number of parameters, likewise.
bool HasWrongContextRecords(const STEPAttributes& entities, Part21File::Index context)
{
  static constexpr std::string_view known[] = { "GEOMETRIC_REPRESENTATION_CONTEXT", "REPRESENTATION_CONTEXT",
    "GLOBAL_UNIT_ASSIGNED_CONTEXT", "GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT",
    "PARAMETRIC_REPRESENTATION_CONTEXT" };
  std::size_t found = 0;
  std::string_view record;
  for (const std::string_view& name : known)
  {
    found += entities.FindRecord(context, name, record) ? 1 : 0;
  }
  return entities.File.IsComplex(context) && !entities.File.IsDamaged(context) &&
    (found != entities.File.GetNumberOfRecords(context) || !entities.FindRecord(context, known[0], record) ||
      !entities.FindRecord(context, known[1], record) || HasWrongCount(entities.File, context));
}

/// Returns true for a unit of any kind whose records can be read.
bool IsSomeUnit(const STEPAttributes& entities, Part21File::Index unit)
{
  const Part21File& file = entities.File;
  std::string_view parameters;
  bool isSome = entities.FindRecord(unit, "LENGTH_UNIT", parameters) ||
    entities.FindRecord(unit, "PLANE_ANGLE_UNIT", parameters);
  for (std::size_t r = 0; !file.IsDamaged(unit) && r < file.GetNumberOfRecords(unit); ++r)
  {
    // The names of all types of units end in _UNIT, also those of derived ones such as AREA_UNIT.
    const std::string_view type = file.GetTypeNames()[file.GetType(unit, r)];
    constexpr std::string_view ending = "_UNIT";
    isSome = isSome || (type.size() > ending.size() && type.substr(type.size() - ending.size()) == ending);
  }
  return isSome;
}

/// Returns true for a unit of the kind: by its record or, without one, by the unit of SI that it is or
/// converts to.
bool IsOfKind(const STEPAttributes& entities, Part21File::Index unit, STEPUnitKind kind)
{
  const SIKind& si = SIKinds[static_cast<int>(kind)];
  for (int k = 0; k < MaxConversion && unit != Part21File::None; ++k)
  {
    std::string_view record;
    if (entities.FindRecord(unit, si.Record, record))
    {
      return true;
    }
    if (entities.FindRecord(unit, SIName.Record, record))
    {
      return entities.Get(unit, SIName).Text == si.Name;
    }
    if (!entities.FindRecord(unit, ConversionFactor.Record, record))
    {
      return false;
    }
    const Part21File::Index measure = entities.Follow(entities.Get(unit, ConversionFactor));
    double value = 0.0;
    unit = Part21File::None;
    if (measure == Part21File::None || !ReadSTEPMeasure(entities, measure, value, unit))
    {
      return false;
    }
  }
  return false;
}

bool IsSame(double a, double b, double accuracy)
{
  return std::fabs(a - b) <= accuracy * std::fabs(b);
}
}

CensusUnit ReadSTEPUnit(const STEPAttributes& entities, Part21File::Index unit, STEPUnitKind kind,
  std::vector<Part21File::Index>& used)
{
  using Index = Part21File::Index;
  const SIKind& si = SIKinds[static_cast<int>(kind)];
  CensusUnit result;
  result.Status = CensusUnit::State::Wrong;
  result.Id = entities.File.GetId(unit);
  double factor = 1.0;
  for (int k = 0; k < MaxConversion; ++k)
  {
    std::string_view record;
    if (entities.File.IsDamaged(unit) || HasWrongCount(entities.File, unit) ||
      HasWrongRecords(entities, unit, si))
    {
      return result;
    }
    used.push_back(unit);
    if (entities.FindRecord(unit, ConversionFactor.Record, record))
    {
      const Part21Value name = entities.Get(unit, ConversionName);
      result.Name += (k > 0 ? " of " : "") + std::string(name.Text);
      double value = 0.0;
      const Index measure = entities.Follow(entities.Get(unit, ConversionFactor));
      if (measure == Part21File::None || HasWrongCount(entities.File, measure) ||
        !ReadSTEPMeasure(entities, measure, value, unit))
      {
        return result;
      }
      used.push_back(measure);
      factor *= value;
      continue;
    }
    const Part21Value prefix = entities.Get(unit, Prefix);
    const Part21Value name = entities.Get(unit, SIName);
    const NamedFactor* power =
      prefix.Kind == Part21Kind::Enumeration ? FindFactor(Prefixes, prefix.Text) : nullptr;
    if (name.Text != si.Name || (!power && prefix.Kind != Part21Kind::Omitted))
    {
      return result;
    }
    result.Name += (k > 0 ? " of " : "") + (power ? std::string(power->Name) + " " : std::string());
    result.Name += name.Text;
    result.Factor = factor * (power ? power->Factor : 1.0) * si.Factor;
    break;
  }
  const NamedFactor* known =
    FindFactor(Conversions, std::string_view(result.Name).substr(0, result.Name.find(" of ")));
  if (!(result.Factor > 0.0) || !std::isfinite(result.Factor) ||
    (known && !IsSame(result.Factor, known->Factor, si.Accuracy)))
  {
    return result;
  }
  const bool absurd = result.Factor < si.Smallest * (1 - 1e-9) || result.Factor > si.Largest * (1 + 1e-9);
  result.Status = absurd ? CensusUnit::State::Absurd : CensusUnit::State::Stated;
  return result;
}

bool ReadSTEPMeasure(
  const STEPAttributes& entities, Part21File::Index measure, double& value, Part21File::Index& unit)
{
  if (!entities.Has(measure, STEPRole::Measure) || entities.File.IsDamaged(measure))
  {
    return false;
  }
  Part21Value number = entities.Get(measure, MeasureValue);
  if (number.Kind == Part21Kind::Typed)
  {
    number = GetPart21Value(number.Text, 0);
  }
  unit = entities.Follow(entities.Get(measure, MeasureUnit));
  return unit != Part21File::None && number.GetNumber(value);
}

int STEPCensusTaker::AddContext(Index representation)
{
  const Index context = this->Entities.Follow(this->Entities.Get(representation, ContextOfItems));
  if (!this->Entities.Has(context, STEPRole::Context))
  {
    return -1;
  }
  const auto [found, added] =
    this->ContextIndices.emplace(context, static_cast<int>(this->Census.Contexts.size()));
  if (added)
  {
    this->Census.Contexts.emplace_back();
    this->Census.Contexts.back().Id = this->File.GetId(context);
    this->ReadUnits(context, this->Census.Contexts.back());
    this->ReadUncertainty(context, this->Census.Contexts.back());
  }
  return found->second;
}

void ReadSTEPUnits(const STEPAttributes& entities, Part21File::Index context, CensusContext& result,
  std::vector<Part21File::Index>& used)
{
  using Index = Part21File::Index;
  if (HasWrongContextRecords(entities, context))
  {
    result.Length.Status = result.Angle.Status = CensusUnit::State::Wrong;
    result.Length.Id = result.Angle.Id = result.Id;
    return;
  }
  Part21Values units(entities.Get(context, UnitsOfContext).Text);
  // A damaged member whose kind of unit cannot be read. It may have been the unit of length or of angle.
  std::uint64_t unknown = 0;
  bool isUnknown = false;
  for (Part21Value value; units.Next(value);)
  {
    const Index unit = entities.Follow(value);
    if (unit == Part21File::None || !IsSomeUnit(entities, unit))
    {
      isUnknown = true;
      unknown = unit == Part21File::None ? result.Id : entities.File.GetId(unit);
      continue;
    }
    const bool length = IsOfKind(entities, unit, STEPUnitKind::Length);
    if (length || IsOfKind(entities, unit, STEPUnitKind::Angle))
    {
      CensusUnit& known = length ? result.Length : result.Angle;
      const CensusUnit next =
        ReadSTEPUnit(entities, unit, length ? STEPUnitKind::Length : STEPUnitKind::Angle, used);
      // Several units of one kind must be equal, because it is not certain which one OpenCASCADE uses.
      const bool isFirst = known.Status == CensusUnit::State::Missing;
      if (isFirst || (known.Status == CensusUnit::State::Stated && next.Status != known.Status))
      {
        known = next;
      }
      else if (next.Factor != known.Factor)
      {
        known.Status = CensusUnit::State::Wrong;
      }
    }
  }
  for (CensusUnit* kind : { &result.Length, &result.Angle })
  {
    if (isUnknown && kind->Status == CensusUnit::State::Missing)
    {
      kind->Status = CensusUnit::State::Wrong;
      kind->Id = unknown;
    }
  }
}

void STEPCensusTaker::ReadUnits(Index context, CensusContext& result)
{
  std::vector<Index> used;
  ReadSTEPUnits(this->Entities, context, result, used);
  for (const Index i : used)
  {
    this->Use(i, CensusUse::Units);
  }
}

CensusUnit STEPCensusTaker::ReadLengthUnit(Index unit)
{
  std::vector<Index> used;
  const CensusUnit result = ReadSTEPUnit(this->Entities, unit, STEPUnitKind::Length, used);
  for (const Index i : used)
  {
    this->Use(i, CensusUse::Units);
  }
  return result;
}

void STEPCensusTaker::ReadUncertainty(Index context, CensusContext& result)
{
  Part21Values values(this->Entities.Get(context, UncertaintiesOfContext).Text);
  for (Part21Value value; values.Next(value);)
  {
    const Index measure = this->Entities.Follow(value);
    double number = 0.0;
    Index unit = None;
    std::string_view record;
    if (measure == None || !ReadSTEPMeasure(this->Entities, measure, number, unit) ||
      !this->Entities.FindRecord(unit, "LENGTH_UNIT", record))
    {
      continue;
    }
    this->Use(measure, CensusUse::Units);
    number *= this->ReadLengthUnit(unit).Factor;
    if (!(number <= result.Uncertainty))
    {
      result.Uncertainty = number;
      result.UncertaintyId = this->File.GetId(measure);
    }
  }
}

void STEPCensusTaker::ReportUnits()
{
  for (std::size_t k = 0; k < this->Census.Bodies.size(); ++k)
  {
    const CensusBody& body = this->Census.Bodies[k];
    if (body.Instances == 0 ||
      (body.Kind != CensusBodyKind::Solid && body.Kind != CensusBodyKind::SurfaceModel))
    {
      continue;
    }
    if (body.Context < 0)
    {
      // A context that is not in the file may have stated any unit: the file is not whole.
      const auto lost = this->WithoutContext.find(static_cast<std::uint32_t>(k));
      const Part21Value value =
        lost == this->WithoutContext.end() ? Part21Value() : this->Entities.Get(lost->second, ContextOfItems);
      const bool isLost = value.IsReference() && this->Entities.Follow(value) == None;
      this->Add(isLost ? CensusDefect::UndefinedReference : CensusDefect::MissingUnit,
        isLost ? lost->second : this->BodyEntities[k], isLost ? value.Id : 0, "context");
    }
    else
    {
      this->Census.Contexts[body.Context].Used = true;
    }
  }
  for (const CensusContext& context : this->Census.Contexts)
  {
    const std::pair<const CensusUnit*, const char*> units[] = { { &context.Length, "length unit" },
      { &context.Angle, "angle unit" } };
    for (const auto& [unit, place] : units)
    {
      const Index entity = this->File.Find(context.Id);
      if (!context.Used || unit->Status == CensusUnit::State::Stated)
      {
        continue;
      }
      const CensusDefect defect = unit->Status == CensusUnit::State::Missing ? CensusDefect::MissingUnit
        : unit->Status == CensusUnit::State::Wrong                           ? CensusDefect::WrongUnit
                                                                             : CensusDefect::AbsurdUnit;
      this->Add(defect, entity, unit->Id, place);
    }
  }
  for (const auto& [entity, index] : this->ContextIndices)
  {
    if (this->Census.Contexts[index].Used)
    {
      this->Use(entity, CensusUse::Units);
      if (this->File.IsDamaged(entity))
      {
        this->Add(CensusDefect::DamagedEntity, entity, 0, "context");
      }
    }
  }
}
}
