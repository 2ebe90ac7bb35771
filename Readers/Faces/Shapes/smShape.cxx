#include "smShape.h"

#include <cmath>
#include <limits>

namespace sm
{
namespace
{
/// Number of points at which a border is compared with one point, or with the opposite border.
constexpr int BorderSamples = 16;

/// The rectangle of a surface's parameters as a wire: its sides in the order bottom, right, top, left, of
/// which the last two run against their edges.
class NaturalWire
{
public:
  explicit NaturalWire(FaceShape& face)
    : Face(face)
    , Domain{ face.GetDomain(0), face.GetDomain(1) }
  {
  }

  bool Add()
  {
    for (const ParameterRange& domain : this->Domain)
    {
      if (!std::isfinite(domain.Low) || !std::isfinite(domain.High))
      {
        return false;
      }
    }
    const bool isClosed[2] = { this->IsClosed(0), this->IsClosed(1) };
    WireShape wire;
    for (const bool isHigh : { false, true })
    {
      wire.Coedges.push_back(this->MakeSide(1, isHigh, isClosed[1]));
      wire.Coedges.push_back(this->MakeSide(0, !isHigh, isClosed[0]));
    }
    this->Face.Wires.push_back(std::move(wire));
    return true;
  }

private:
  double GetEnd(int direction, bool isHigh) const
  {
    return isHigh ? this->Domain[direction].High : this->Domain[direction].Low;
  }

  Vector3 Evaluate(int constant, double value, double t) const
  {
    return constant == 0 ? this->Face.Surface->Evaluate(value, t) : this->Face.Surface->Evaluate(t, value);
  }

  /// Returns the points of the side on which parameter `constant` is at an end of its domain.
  std::vector<Vector3> Sample(int constant, bool isHigh) const
  {
    std::vector<Vector3> points;
    const ParameterRange& along = this->Domain[1 - constant];
    for (int i = 0; i <= BorderSamples; ++i)
    {
      const double x = static_cast<double>(i) / BorderSamples;
      points.push_back(
        this->Evaluate(constant, this->GetEnd(constant, isHigh), (1.0 - x) * along.Low + x * along.High));
    }
    return points;
  }

  bool IsClosed(int constant) const
  {
    const std::vector<Vector3> low = this->Sample(constant, false);
    const std::vector<Vector3> high = this->Sample(constant, true);
    double widest = 0.0;
    for (std::size_t i = 0; i < low.size(); ++i)
    {
      widest = std::max(widest, Norm(Subtract(low[i], high[i])));
    }
    return widest <= DefaultTolerance;
  }

  bool IsPole(int constant, bool isHigh) const
  {
    const std::vector<Vector3> points = this->Sample(constant, isHigh);
    double widest = 0.0;
    for (const Vector3& p : points)
    {
      widest = std::max(widest, Norm(Subtract(p, points[0])));
    }
    return widest <= DefaultTolerance;
  }

  /// Returns the curve of a side, in the parameter that runs along it.
  CurvePointer<3> MakeCurve(int constant, double value) const
  {
    const auto* elementary = this->Face.Surface->GetIf<ElementarySurface>();
    const auto* revolved = this->Face.Surface->GetIf<RevolvedSurface>();
    std::string problem;
    if (revolved && constant == 0 && value == 0.0)
    {
      return revolved->Profile;
    }
    if (elementary && (constant == 0 || elementary->Kind == ElementarySurface::Type::Torus))
    {
      // The sides of a sphere and of a torus are circles.
      const bool isTorus = elementary->Kind == ElementarySurface::Type::Torus;
      const std::array<Vector3, 3>& axes = elementary->Frame.Axes;
      ConicCurve<3> circle;
      const Vector3 outwards = Sum(Multiply(std::cos(value), axes[0]), Multiply(std::sin(value), axes[1]));
      const double major = isTorus ? elementary->Radii[0] : 0.0;
      const double minor = isTorus ? elementary->Radii[1] : elementary->Radii[0];
      circle.X = constant == 0 ? outwards : axes[0];
      circle.Y = constant == 0 ? axes[2] : axes[1];
      circle.Center = constant == 0
        ? Sum(elementary->Frame.Origin, Multiply(major, outwards))
        : Sum(elementary->Frame.Origin, Multiply(minor * std::sin(value), axes[2]));
      circle.Radii[0] = circle.Radii[1] = constant == 0 ? minor : major + minor * std::cos(value);
      return GeometricCurve<3>::Make(circle, problem);
    }
    return GeometricCurve<3>::Make(
      CurveOnSurface{ this->Face.Surface, this->MakeLine(constant, value) }, problem);
  }

  CurvePointer<2> MakeLine(int constant, double value) const
  {
    std::string problem;
    LineCurve<2> line;
    line.Origin[constant] = value;
    line.Direction[1 - constant] = 1.0;
    return GeometricCurve<2>::Make(line, problem);
  }

  VertexPointer GetCorner(bool isHighU, bool isHighV)
  {
    const Vector3 point = this->Face.Surface->Evaluate(this->GetEnd(0, isHighU), this->GetEnd(1, isHighV));
    const Vector3 placed = this->Face.Location.MapPoint(point);
    for (const VertexPointer& known : this->Corners)
    {
      if (Norm(Subtract(known->Point, placed)) <= DefaultTolerance)
      {
        return known;
      }
    }
    this->Corners.push_back(std::make_shared<VertexShape>());
    this->Corners.back()->Point = placed;
    return this->Corners.back();
  }

  CoedgeShape MakeSide(int constant, bool isHigh, bool isClosed)
  {
    const ParameterRange& along = this->Domain[1 - constant];
    EdgePointer& first = this->First[constant];
    CoedgeShape side;
    side.Reversed = isHigh == (constant == 1);
    side.Trim = this->MakeLine(constant, this->GetEnd(constant, isHigh));
    side.First = along.Low;
    side.Last = along.High;
    if (first && isClosed)
    {
      side.Edge = first;
      return side;
    }
    side.Edge = std::make_shared<EdgeShape>();
    EdgeShape& edge = *side.Edge;
    edge.Degenerate = this->IsPole(constant, isHigh);
    // On a closed surface both sides have the curve of the low one.
    edge.Curve =
      edge.Degenerate ? nullptr : this->MakeCurve(constant, this->GetEnd(constant, isHigh && !isClosed));
    edge.Location = this->Face.Location;
    edge.First = along.Low;
    edge.Last = along.High;
    edge.Start = constant == 0 ? this->GetCorner(isHigh, false) : this->GetCorner(false, isHigh);
    edge.End = constant == 0 ? this->GetCorner(isHigh, true) : this->GetCorner(true, isHigh);
    first = side.Edge;
    return side;
  }

  FaceShape& Face;
  ParameterRange Domain[2];
  EdgePointer First[2];
  std::vector<VertexPointer> Corners;
};
}

BodyShape MakeBody(const SolidUse& solid)
{
  BodyShape body;
  body.IsSolid = true;
  for (const ShellUse& shell : solid.Solid->Shells)
  {
    body.Shells.push_back({ shell.Shell, shell.Reversed != solid.Reversed, {} });
  }
  return body;
}

BodyShape MakeBody(const ShellUse& shell)
{
  BodyShape body;
  body.Shells.push_back({ shell.Shell, shell.Reversed, {} });
  return body;
}

bool AddNaturalWires(FaceShape& face)
{
  return NaturalWire(face).Add();
}
}
