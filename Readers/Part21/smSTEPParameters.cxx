// Checks the parameters of the entities that bodies depend on: their number, types and values, and the
// consistency of splines.
#include "smSTEPCensusTaker.h"
#include "smSTEPFrames.h"
#include "smSTEPPropertyAttributes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
constexpr STEPAttribute CurveDegree = { "B_SPLINE_CURVE", 0, 1, "degree" };
constexpr STEPAttribute CurvePoles = { "B_SPLINE_CURVE", 1, 2, "control points" };
constexpr STEPAttribute CurveMultiplicities = { "B_SPLINE_CURVE_WITH_KNOTS", 0, 6, "multiplicities" };
constexpr STEPAttribute CurveKnots = { "B_SPLINE_CURVE_WITH_KNOTS", 1, 7, "knots" };
constexpr STEPAttribute SurfaceDegrees[] = { { "B_SPLINE_SURFACE", 0, 1, "degree in u" },
  { "B_SPLINE_SURFACE", 1, 2, "degree in v" } };
constexpr STEPAttribute SurfacePoles = { "B_SPLINE_SURFACE", 2, 3, "control points" };
constexpr STEPAttribute SurfaceMultiplicities[] = { { "B_SPLINE_SURFACE_WITH_KNOTS", 0, 8,
                                                      "multiplicities in u" },
  { "B_SPLINE_SURFACE_WITH_KNOTS", 1, 9, "multiplicities in v" } };
constexpr STEPAttribute SurfaceKnots[] = { { "B_SPLINE_SURFACE_WITH_KNOTS", 2, 10, "knots in u" },
  { "B_SPLINE_SURFACE_WITH_KNOTS", 3, 11, "knots in v" } };

constexpr const char* TooFew = "too few parameters";
constexpr const char* TooClose = "knots too close to each other";

/// Numbers above this are refused, because algorithms of OpenCASCADE that step along a curve do not terminate
/// for curves of this size.
constexpr double MaxNumber = 1e100;

std::int64_t CountValues(std::string_view list)
{
  std::int64_t count = 0;
  Part21Values values(list);
  for (Part21Value value; values.Next(value);)
  {
    ++count;
  }
  return count;
}

/// Returns true for a short number with at most two digits of exponent, which is finite for certain and need
/// not be converted.
bool IsPlainNumber(std::string_view text)
{
  const std::size_t exponent = text.find_first_of("Ee");
  if (exponent == std::string_view::npos)
  {
    return text.size() < 64;
  }
  const std::string_view power = text.substr(exponent + 1);
  return text.size() < 64 &&
    (power.size() < 3 || (power.size() == 3 && (power[0] == '+' || power[0] == '-')));
}

bool IsZero(std::string_view number)
{
  return number.substr(0, number.find_first_of("Ee")).find_first_of("123456789") == std::string_view::npos;
}

/// Spans between knots below this part of the whole are refused: OpenCASCADE divides by powers of them.
constexpr double MinSpan = 1e-30;

/// Returns the reason why knots, multiplicities, degree and number of poles of one direction are
/// inconsistent; null if they are consistent.
const char* FindMismatch(
  std::int64_t degree, std::int64_t poles, std::string_view multiplicities, std::string_view knots)
{
  if (degree < 1 || poles < 2)
  {
    return "degree";
  }
  Part21Values counts(multiplicities);
  Part21Values positions(knots);
  Part21Value count;
  Part21Value position;
  std::int64_t sum = 0;
  double first = 0.0;
  double last = -std::numeric_limits<double>::infinity();
  double minimumSpan = std::numeric_limits<double>::infinity();
  while (counts.Next(count))
  {
    std::int64_t multiplicity = 0;
    double knot = 0.0;
    if (!positions.Next(position) || !position.GetNumber(knot) || !(knot > last))
    {
      return "knots";
    }
    // Multiplicities above the degree plus one are refused, so the sum cannot overflow.
    if (!count.GetInteger(multiplicity) || multiplicity < 1 || multiplicity > degree + 1)
    {
      return "multiplicities";
    }
    first = sum == 0 ? knot : first;
    sum += multiplicity;
    minimumSpan = std::min(minimumSpan, knot - last);
    last = knot;
  }
  if (positions.Next(position))
  {
    return "knots";
  }
  if (minimumSpan < MinSpan * (last - first))
  {
    return TooClose;
  }
  return sum == poles + degree + 1 ? nullptr : "multiplicities";
}

/// Returns true for a list that begins with three numbers.
bool HasThreeNumbers(const Part21Value& list)
{
  Part21Values values(list.Text);
  Part21Value value;
  double number = 0.0;
  int count = 0;
  while (count < 3 && values.Next(value) && value.GetNumber(number))
  {
    ++count;
  }
  return list.IsList() && count == 3;
}
}

void STEPCensusTaker::CheckRecord(Index i, std::string_view parameters, const char* signature, bool flat)
{
  const char* rest = this->CheckList(i, parameters, signature, flat);
  // OpenCASCADE follows the null pointers of axes that are missing, and of a trim curve.
  if (rest &&
    ((rest == TooFew && this->Entities.Has(i, STEPRole::Placement)) ||
      this->Entities.Has(i, STEPRole::DefinitionalRepresentation)))
  {
    this->AddPeril(CensusDefect::WrongParameter, i, 0, rest);
  }
  else if (rest)
  {
    this->Add(CensusDefect::WrongParameter, i, 0, rest);
  }
}

/// Returns the reason why the parameters do not match the signature; null if they do, or if CheckValue() has
/// added a problem.
const char* STEPCensusTaker::CheckList(Index i, std::string_view text, const char* signature, bool flat)
{
  Part21Values values(text);
  Part21Value value;
  for (const char* at = signature; *at != '\0'; ++at)
  {
    const bool optional = *at == '?';
    at += optional ? 1 : 0;
    if (!values.Next(value))
    {
      return TooFew;
    }
    if (*at == '(')
    {
      // The letter of one element; lists of lists have two brackets.
      const int depth = at[1] == '(' ? 2 : 1;
      const char kind = at[depth];
      at += 2 * depth;
      Part21Value first;
      if (!value.IsList() || !Part21Values(value.Text).Next(first))
      {
        return "a list with members is expected";
      }
      Part21Values rows(depth == 2 ? std::string_view(value.Text) : std::string_view());
      Part21Value row = value;
      while (depth == 1 || rows.Next(row))
      {
        Part21Values elements(row.Text);
        for (Part21Value element; elements.Next(element);)
        {
          if (!this->CheckValue(i, element, kind))
          {
            return nullptr;
          }
        }
        if (depth == 1)
        {
          break;
        }
      }
    }
    else if (*at == 'c')
    {
      this->CheckCoordinates(i, value, flat);
    }
    else if (!(optional && value.Kind == Part21Kind::Omitted) && !this->CheckValue(i, value, *at))
    {
      return nullptr;
    }
  }
  return values.Next(value) ? "too many parameters" : nullptr;
}

/// Adds a problem and returns false if a value is not of the kind of its letter.
bool STEPCensusTaker::CheckValue(Index i, const Part21Value& value, char kind)
{
  CensusDefect defect = CensusDefect::WrongParameter;
  const char* place = "a number is expected";
  bool valid = true;
  bool huge = false;
  double number = 0.0;
  std::int64_t integer = 0;
  switch (kind)
  {
    case '.':
      break;
    case 'b':
      valid = value.Kind == Part21Kind::Enumeration && (value.Text == "T" || value.Text == "F");
      place = ".T. or .F. is expected";
      break;
    case 'i':
      valid = value.GetInteger(integer);
      break;
    case 'n':
    case 'p':
    case 'z':
      valid = value.GetNumber(number);
      huge = value.IsNumber() && (!valid || std::abs(number) > MaxNumber);
      valid = valid && !huge;
      if (value.IsNumber() && (!valid || number < 0.0 || number == 0.0))
      {
        valid = valid && (kind == 'n' || (kind == 'z' && number == 0.0));
        defect = CensusDefect::ValueOutOfRange;
        place = huge ? "too large a number" : kind == 'p' ? "not above 0" : "below 0";
      }
      break;
    default:
    {
      const Index to = this->Entities.Follow(value);
      if (value.IsReference() && to == None)
      {
        // The damage of the instance itself has been reported. OpenCASCADE would dereference the null pointer
        // of an undefined trim curve.
        if (this->Entities.Has(i, STEPRole::DefinitionalRepresentation))
        {
          this->Census.Perils.push_back(
            { CensusDefect::UndefinedReference, this->File.GetId(i), value.Id, "" });
        }
        return false;
      }
      valid = this->Entities.Has(to, GetRoleOfLetter(kind));
      defect = value.IsReference() ? CensusDefect::WrongType : CensusDefect::WrongParameter;
      place = value.IsReference() ? "" : "a reference is expected";
    }
  }
  const bool isCurveInPlane = this->Entities.Has(i, STEPRole::DefinitionalRepresentation);
  // OpenCASCADE's repair looks for feet on an ellipse without width for minutes.
  const bool isFlat = kind == 'p' && value.IsNumber() && number == 0.0;
  if (!valid && (huge || isFlat || (defect == CensusDefect::WrongType && isCurveInPlane)))
  {
    this->AddPeril(defect, i, value.Id, place);
  }
  else if (!valid)
  {
    this->Add(defect, i, value.Id, place);
  }
  return valid;
}

void STEPCensusTaker::CheckCoordinates(Index i, const Part21Value& value, bool flat)
{
  int count = 0;
  bool zero = true;
  Part21Values numbers(value.Text);
  for (Part21Value element; numbers.Next(element); ++count)
  {
    const bool plain = element.IsNumber() && IsPlainNumber(element.Text);
    if (!plain && !this->CheckValue(i, element, 'n'))
    {
      return;
    }
    zero = zero && IsZero(element.Text);
  }
  const char* place = count != (flat ? 2 : 3)            ? "number of coordinates"
    : zero && this->Entities.Has(i, STEPRole::Direction) ? "a direction without length"
                                                         : nullptr;
  if (place)
  {
    this->Add(CensusDefect::ValueOutOfRange, i, 0, place);
  }
}

/// OpenCASCADE would dereference the null pointer of a location that it cannot make.
void STEPCensusTaker::CheckLocation(Index placement)
{
  const Part21Value reference = this->Entities.Get(placement, LocationOfPlacement);
  const Index location = this->Entities.Follow(reference);
  if (this->Entities.Has(location, STEPRole::Point) && !this->File.IsDamaged(location) &&
    !HasThreeNumbers(this->Entities.Get(location, CoordinatesOfPoint)))
  {
    this->AddPeril(
      CensusDefect::ValueOutOfRange, placement, reference.Id, "location without three coordinates");
  }
}

void STEPCensusTaker::CheckSplineCurve(Index i)
{
  std::string_view record;
  if (!this->Entities.FindRecord(i, CurveKnots.Record, record))
  {
    return;
  }
  std::int64_t degree = 0;
  this->Entities.Get(i, CurveDegree).GetInteger(degree);
  const std::int64_t poles = CountValues(this->Entities.Get(i, CurvePoles).Text);
  const char* place = FindMismatch(
    degree, poles, this->Entities.Get(i, CurveMultiplicities).Text, this->Entities.Get(i, CurveKnots).Text);
  if (!place && this->Entities.FindRecord(i, "RATIONAL_B_SPLINE_CURVE", record) &&
    CountValues(GetPart21Value(record, 0).Text) != poles)
  {
    place = "weights";
  }
  if (place == TooClose)
  {
    this->AddPeril(CensusDefect::InconsistentSpline, i, 0, place);
  }
  else if (place)
  {
    this->Add(CensusDefect::InconsistentSpline, i, 0, place);
  }
}

void STEPCensusTaker::CheckSplineSurface(Index i)
{
  std::string_view record;
  if (!this->Entities.FindRecord(i, SurfaceKnots[0].Record, record))
  {
    return;
  }
  const std::string_view rows = this->Entities.Get(i, SurfacePoles).Text;
  std::int64_t counts[2] = { 0, 0 };
  const char* place = nullptr;
  const auto countRows = [&place](std::string_view list, std::int64_t size[2], const char* name)
  {
    Part21Values values(list);
    for (Part21Value row; values.Next(row); ++size[0])
    {
      const std::int64_t columns = CountValues(row.Text);
      place = size[0] > 0 && columns != size[1] ? name : place;
      size[1] = columns;
    }
  };
  countRows(rows, counts, SurfacePoles.Name);
  for (int d = 0; d < 2 && !place; ++d)
  {
    std::int64_t degree = 0;
    this->Entities.Get(i, SurfaceDegrees[d]).GetInteger(degree);
    place = FindMismatch(degree, counts[d], this->Entities.Get(i, SurfaceMultiplicities[d]).Text,
      this->Entities.Get(i, SurfaceKnots[d]).Text);
  }
  if (!place && this->Entities.FindRecord(i, "RATIONAL_B_SPLINE_SURFACE", record))
  {
    std::int64_t weights[2] = { 0, 0 };
    countRows(GetPart21Value(record, 0).Text, weights, "weights");
    place = weights[0] != counts[0] || weights[1] != counts[1] ? "weights" : place;
  }
  if (place == TooClose)
  {
    this->AddPeril(CensusDefect::InconsistentSpline, i, 0, place);
  }
  else if (place)
  {
    this->Add(CensusDefect::InconsistentSpline, i, 0, place);
  }
}
}
