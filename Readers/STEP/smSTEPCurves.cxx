#include "smSTEPCurves.h"

#include "smPolynomialCurve.h"
#include "smSTEPFrames.h"
#include "smSTEPPropertyAttributes.h"
#include "smSTEPTopologyAttributes.h"

#include <cmath>

namespace sm
{
namespace
{
constexpr STEPAttribute PlaceOfConic = { "CONIC", 0, 1, "position" };
constexpr STEPAttribute PointsOfPolyline = { "POLYLINE", 0, 1, "points" };
constexpr STEPAttribute BasisOfTrimmed = { "TRIMMED_CURVE", 0, 1, "basis curve" };
constexpr STEPAttribute SenseOfTrimmed = { "TRIMMED_CURVE", 3, 4, "sense agreement" };
constexpr STEPAttribute DegreeOfSpline = { "B_SPLINE_CURVE", 0, 1, "degree" };
constexpr STEPAttribute PointsOfSpline = { "B_SPLINE_CURVE", 1, 2, "control points" };
constexpr STEPAttribute MultiplicitiesOfSpline = { "B_SPLINE_CURVE_WITH_KNOTS", 0, 6, "multiplicities" };
constexpr STEPAttribute KnotsOfSpline = { "B_SPLINE_CURVE_WITH_KNOTS", 1, 7, "knots" };

/// Longest chain of curves on surfaces and trimmed curves that refer to one another.
constexpr int MaxCurveChain = 8;

class CurveReader
{
public:
  using Index = Part21File::Index;

  CurveReader(const STEPAttributes& entities, SpaceCurve& curve)
    : Entities(entities)
    , Curve(curve)
  {
  }

  bool Read(Index entity)
  {
    if (this->ReadConic(entity))
    {
      return true;
    }
    std::string_view record;
    if (this->Entities.FindRecord(entity, "LINE", record))
    {
      this->Curve.Kind = SpaceCurve::Type::Line;
      return true;
    }
    this->Curve.Kind = SpaceCurve::Type::Spline;
    if (this->Entities.FindRecord(entity, PointsOfPolyline.Record, record))
    {
      this->Curve.Degree = 1;
      this->MakeKnots(this->ReadPoints(this->Entities.Get(entity, PointsOfPolyline)), true);
    }
    else if (this->Entities.Has(entity, STEPRole::SplineCurve))
    {
      this->ReadSpline(entity);
    }
    return this->Curve.IsConsistent();
  }

private:
  bool ReadConic(Index entity)
  {
    static constexpr struct
    {
      const char* Name;
      SpaceCurve::Type Kind;
      int Radii;
    } conics[] = { { "CIRCLE", SpaceCurve::Type::Ellipse, 1 }, { "ELLIPSE", SpaceCurve::Type::Ellipse, 2 },
      { "PARABOLA", SpaceCurve::Type::Parabola, 1 }, { "HYPERBOLA", SpaceCurve::Type::Hyperbola, 2 } };
    for (const auto& conic : conics)
    {
      std::string_view record;
      if (!this->Entities.FindRecord(entity, conic.Name, record))
      {
        continue;
      }
      bool isRead = true;
      for (std::size_t k = 0; k < 2; ++k)
      {
        const std::size_t own = std::min<std::size_t>(k, conic.Radii - 1);
        isRead = isRead &&
          this->Entities.Get(entity, { conic.Name, own, own + 2, "" }).GetNumber(this->Curve.Radii[k]) &&
          std::abs(this->Curve.Radii[k]) > 0.0;
      }
      STEPFrame frame;
      if (!isRead ||
        !ReadSTEPFrame(
          this->Entities, this->Entities.Follow(this->Entities.Get(entity, PlaceOfConic)), frame))
      {
        return false;
      }
      this->Curve.Kind = conic.Kind;
      this->Curve.Origin = frame.Origin;
      this->Curve.Axes[0] = frame.Axes[0];
      this->Curve.Axes[1] = frame.Axes[1];
      return true;
    }
    return false;
  }

  bool ReadPoints(const Part21Value& list)
  {
    Part21Values values(list.Text);
    for (Part21Value value; values.Next(value);)
    {
      Vector3 point;
      if (!ReadSTEPPoint(this->Entities, this->Entities.Follow(value), point))
      {
        this->Curve.Points.clear();
        return false;
      }
      this->Curve.Points.push_back(point);
    }
    return true;
  }

  /// Makes a uniform knot vector; `isClamped`: the curve ends at its first and last control points.
  void MakeKnots(bool hasPoints, bool isClamped)
  {
    const int p = this->Curve.Degree;
    const int last = hasPoints ? static_cast<int>(this->Curve.Points.size()) - p : 0;
    for (int k = -p; k <= last + p && p <= MaximumDegree; ++k)
    {
      this->Curve.Knots.push_back(isClamped ? std::min(std::max(k, 0), last) : k);
    }
  }

  void ReadSpline(Index entity)
  {
    std::int64_t degree = 0;
    if (!this->Entities.Get(entity, DegreeOfSpline).GetInteger(degree) || degree < 1 ||
      degree > MaximumDegree || !this->ReadPoints(this->Entities.Get(entity, PointsOfSpline)))
    {
      return;
    }
    this->Curve.Degree = static_cast<int>(degree);
    std::string_view record;
    if (this->Entities.FindRecord(entity, KnotsOfSpline.Record, record))
    {
      this->ReadKnots(entity);
    }
    else if (this->Entities.FindRecord(entity, "BEZIER_CURVE", record))
    {
      const int pieces = (static_cast<int>(this->Curve.Points.size()) - 1) / this->Curve.Degree;
      for (int k = 0; k <= pieces; ++k)
      {
        const int count = this->Curve.Degree + (k == 0 || k == pieces ? 1 : 0);
        this->Curve.Knots.insert(this->Curve.Knots.end(), count, k);
      }
    }
    else
    {
      this->MakeKnots(true, !this->Entities.FindRecord(entity, "UNIFORM_CURVE", record));
    }
    if (this->Entities.FindRecord(entity, "RATIONAL_B_SPLINE_CURVE", record))
    {
      Part21Values weights(GetPart21Value(record, 0).Text);
      for (Part21Value value; weights.Next(value);)
      {
        double weight = 0.0;
        value.GetNumber(weight);
        this->Curve.Weights.push_back(weight);
      }
    }
  }

  void ReadKnots(Index entity)
  {
    Part21Values knots(this->Entities.Get(entity, KnotsOfSpline).Text);
    Part21Values counts(this->Entities.Get(entity, MultiplicitiesOfSpline).Text);
    Part21Value knot;
    Part21Value count;
    while (knots.Next(knot) && counts.Next(count))
    {
      double value = 0.0;
      std::int64_t multiplicity = 0;
      if (!knot.GetNumber(value) || !count.GetInteger(multiplicity) || multiplicity < 1 ||
        multiplicity > MaximumDegree + 1)
      {
        this->Curve.Knots.clear();
        return;
      }
      this->Curve.Knots.insert(this->Curve.Knots.end(), static_cast<std::size_t>(multiplicity), value);
    }
  }

  const STEPAttributes& Entities;
  SpaceCurve& Curve;
};
}

bool ReadSTEPPoint(const STEPAttributes& entities, Part21File::Index point, Vector3& position)
{
  std::string_view record;
  if (!entities.FindRecord(point, CoordinatesOfPoint.Record, record))
  {
    return false;
  }
  Part21Values values(entities.Get(point, CoordinatesOfPoint).Text);
  Part21Value value;
  for (double& number : position)
  {
    if (!values.Next(value) || !value.GetNumber(number))
    {
      return false;
    }
  }
  return true;
}

bool ReadSTEPCurve(
  const STEPAttributes& entities, Part21File::Index entity, SpaceCurve& curve, bool& isReversed)
{
  isReversed = false;
  for (int k = 0; k < MaxCurveChain; ++k)
  {
    std::string_view record;
    if (entities.FindRecord(entity, BasisOfTrimmed.Record, record))
    {
      isReversed = isReversed != (entities.Get(entity, SenseOfTrimmed).Text == "F");
      entity = entities.Follow(entities.Get(entity, BasisOfTrimmed));
    }
    else if (entities.FindRecord(entity, "SURFACE_CURVE", record) ||
      entities.FindRecord(entity, "SEAM_CURVE", record) ||
      entities.FindRecord(entity, "INTERSECTION_CURVE", record))
    {
      entity = entities.Follow(entities.Get(entity, CurveInSpace));
    }
    else
    {
      return CurveReader(entities, curve).Read(entity);
    }
  }
  return false;
}
}
