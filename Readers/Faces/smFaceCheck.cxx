#include "smFaceCheck.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Differences below this, relative to the perimeter's power, are roundings and errors of the quadrature.
constexpr double Negligible = 1e-6;

/// A bilinear surface whose corners are so close to a parallelogram, relative to its sides, is a plane.
constexpr double NoTwist = 1e-12;

/// Tolerance of the integrals of faces that seem to differ, relative to the perimeter's power, for each piece
/// of a trim curve.
constexpr double FineTolerance = 1e-9;

/// Parts of such a piece between which crossings with knot lines are found.
constexpr int FineParts = 8;

/// Distances between edge and boundary along the surface count up to this, relative to the perimeter.
constexpr double MaxSlip = 1e-3;

/// The limit is this, relative to the perimeter's power, for gaps of any width.
constexpr double MaxLimit = 3e-3;

/// Limit of the moments relative to that of the vector area times the perimeter: points of a loop are no
/// farther from its centre.
constexpr double Lever = 0.25;

/// Factor of the area between boundary and edges.
constexpr double Safety = 2.0;

/// Samples of a coedge for its gap, steps towards the closest point of the surface, and of a grid on which it
/// is sought.
constexpr int GapSamples = 16;
constexpr int FineGapSamples = 64;
constexpr int FootSteps = 8;
constexpr int GridSteps = 16;

/// Steps by which crossings with knot lines are found.
constexpr int BisectionSteps = 30;

class LoopIntegrator
{
public:
  LoopIntegrator(const Face& face, const Vector3& center, double size)
    : Center(center)
    , IsFine(size > 0.0)
    , Size(size)
    , Walker(face.Surface)
  {
    this->FindAffine(face.Surface);
    for (int d = 0; d < 2 && this->IsFine; ++d)
    {
      this->Knots[d] = face.Surface.GetSpanBreaks(d);
    }
  }

  void AddPiece(const BernsteinPiece<2>& piece, bool isReversed)
  {
    std::vector<double>& breaks = this->Breaks;
    breaks = { 0.0, 1.0 };
    for (int k = 1; this->IsFine && k < FineParts; ++k)
    {
      breaks.insert(breaks.end() - 1, static_cast<double>(k) / FineParts);
    }
    if (this->Knots[0].size() > 2 || this->Knots[1].size() > 2)
    {
      this->AddCrossings(piece, breaks);
    }
    LineIntegrals sum;
    const auto evaluate = [&](double t, Vector3& x, Vector3& slope)
    {
      TrimCurve::Point step;
      const TrimCurve::Point uv = piece.Evaluate(t, &step);
      Vector3 du = this->Affine[1];
      Vector3 dv = this->Affine[2];
      if (!this->IsAffine)
      {
        this->Walker.Evaluate(uv[0], uv[1], x.data(), du.data(), dv.data());
      }
      for (int c = 0; c < 3; ++c)
      {
        x[c] = (this->IsAffine ? this->Affine[0][c] + uv[0] * du[c] + uv[1] * dv[c] : x[c]) - this->Center[c];
        slope[c] = step[0] * du[c] + step[1] * dv[c];
      }
    };
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
    {
      sum.AddPart(evaluate, breaks[k], breaks[k + 1], this->IsFine ? FineTolerance : 0.0, this->Size);
    }
    this->Sum.Add(sum, { 0.0, 0.0, 0.0 }, isReversed ? -1.0 : 1.0);
  }

  void AddLine(const TrimCurve::Point& from, const TrimCurve::Point& to)
  {
    const TrimCurve::Point ends[2] = { from, to };
    if (from != to)
    {
      this->AddPiece({ ends, 1 }, false);
    }
  }

  const LineIntegrals& Get() const { return this->Sum; }

private:
  /// Finds the map of a surface whose position is linear in u and v, as that of a plane.
  void FindAffine(const NURBSSurface& surface)
  {
    if (surface.Degree[0] != 1 || surface.Degree[1] != 1 || surface.Rational ||
      surface.ControlPoints.size() != 4)
    {
      return;
    }
    const auto& p = surface.ControlPoints;
    const double low[2] = { surface.GetDomainStart(0), surface.GetDomainStart(1) };
    const double width[2] = { surface.GetDomainEnd(0) - low[0], surface.GetDomainEnd(1) - low[1] };
    double size = 0.0;
    double twist = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      this->Affine[1][c] = (p[1][c] - p[0][c]) / (p[0][3] * width[0]);
      this->Affine[2][c] = (p[2][c] - p[0][c]) / (p[0][3] * width[1]);
      this->Affine[0][c] = p[0][c] / p[0][3] - low[0] * this->Affine[1][c] - low[1] * this->Affine[2][c];
      size = std::max({ size, std::abs(p[1][c] - p[0][c]), std::abs(p[2][c] - p[0][c]) });
      twist = std::max(twist, std::abs(p[3][c] - p[2][c] - p[1][c] + p[0][c]));
    }
    this->IsAffine = twist <= NoTwist * size;
  }

  /// Adds the parameters at which the piece crosses a knot line, where the surface is not smooth.
  void AddCrossings(const BernsteinPiece<2>& piece, std::vector<double>& breaks) const
  {
    const std::size_t count = breaks.size();
    for (int d = 0; d < 2; ++d)
    {
      for (std::size_t k = 0; k + 1 < count && this->Knots[d].size() > 2; ++k)
      {
        const double ends[2] = { piece.Evaluate(breaks[k])[d], piece.Evaluate(breaks[k + 1])[d] };
        const auto begin =
          std::upper_bound(this->Knots[d].begin(), this->Knots[d].end(), std::min(ends[0], ends[1]));
        for (auto knot = begin; knot != this->Knots[d].end() && *knot < std::max(ends[0], ends[1]); ++knot)
        {
          double range[2] = { breaks[k], breaks[k + 1] };
          for (int i = 0; i < BisectionSteps; ++i)
          {
            const double middle = 0.5 * (range[0] + range[1]);
            range[(piece.Evaluate(middle)[d] < *knot) == (ends[0] < *knot) ? 0 : 1] = middle;
          }
          breaks.push_back(0.5 * (range[0] + range[1]));
        }
      }
    }
    std::sort(breaks.begin(), breaks.end());
  }

  Vector3 Center;
  bool IsAffine = false;
  Vector3 Affine[3]{};
  bool IsFine;
  double Size;
  std::vector<double> Knots[2];
  std::vector<double> Breaks;
  NURBSSurface::Walker Walker;
  LineIntegrals Sum;
};

/// Finds the closest point of a surface.
class FootFinder
{
public:
  explicit FootFinder(const NURBSSurface& surface)
    : Surface(surface)
  {
    for (int d = 0; d < 2; ++d)
    {
      this->Low[d] = surface.GetDomainStart(d);
      this->High[d] = surface.GetDomainEnd(d);
    }
  }

  /// Returns the distance of a point from the surface. Newton's method begins at (u,v), then where the foot
  /// of the point before was, and at last at the closest point of a grid; it ends at a distance below
  /// `enough`.
  double GetDistance(const TrimCurve::Point& uv, const Vector3& point, double enough)
  {
    double minimum = this->Follow(uv, point);
    if (!(minimum <= enough) && this->HasLast)
    {
      minimum = std::min(minimum, this->Follow(this->Last, point));
    }
    if (!(minimum <= enough))
    {
      minimum = std::min(minimum, this->Follow(this->FindOnGrid(point), point));
    }
    return minimum;
  }

private:
  double Follow(TrimCurve::Point uv, const Vector3& point)
  {
    double minimum = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= FootSteps; ++i)
    {
      Vector3 x;
      Vector3 d[2];
      this->Surface.Evaluate(uv[0], uv[1], x.data(), d[0].data(), d[1].data());
      const Vector3 away = Subtract(point, x);
      const double distance = Norm(away);
      if (distance < minimum)
      {
        minimum = distance;
        this->Last = uv;
        this->HasLast = true;
      }
      const double a = Dot(d[0], d[0]);
      const double b = Dot(d[0], d[1]);
      const double c = Dot(d[1], d[1]);
      const double determinant = a * c - b * b;
      if (!(determinant > 1e-14 * a * c))
      {
        break;
      }
      const double f = Dot(d[0], away);
      const double g = Dot(d[1], away);
      uv[0] = std::clamp(uv[0] + (c * f - b * g) / determinant, this->Low[0], this->High[0]);
      uv[1] = std::clamp(uv[1] + (a * g - b * f) / determinant, this->Low[1], this->High[1]);
    }
    return minimum;
  }

  TrimCurve::Point FindOnGrid(const Vector3& point) const
  {
    TrimCurve::Point best{ this->Low[0], this->Low[1] };
    double minimum = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= GridSteps; ++i)
    {
      for (int j = 0; j <= GridSteps; ++j)
      {
        const TrimCurve::Point uv{ this->Low[0] + (this->High[0] - this->Low[0]) * i / GridSteps,
          this->Low[1] + (this->High[1] - this->Low[1]) * j / GridSteps };
        Vector3 x;
        this->Surface.Evaluate(uv[0], uv[1], x.data());
        const double distance = Norm(Subtract(point, x));
        if (distance < minimum)
        {
          minimum = distance;
          best = uv;
        }
      }
    }
    return best;
  }

  const NURBSSurface& Surface;
  double Low[2];
  double High[2];
  TrimCurve::Point Last{};
  bool HasLast = false;
};

/// Returns the area between the boundary of a face and its edges, in the unit of the model. `slip`: the
/// largest distance that counts beyond the distance of edge and surface.
double GetGapArea(const Face& face, double slip, double perimeter, int samples)
{
  double area = 0.0;
  FootFinder feet(face.Surface);
  for (const Loop& loop : face.Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      if (coedge.Use->Degenerate)
      {
        continue;
      }
      const EdgeCurve& curve = coedge.Use->Curve;
      Vector3 last = curve.GetStartPoint();
      for (int i = 0; i <= samples; ++i)
      {
        const double t = curve.GetStart() + (curve.GetEnd() - curve.GetStart()) * i / samples;
        const TrimCurve::Point uv = coedge.Curve.Evaluate(t);
        Vector3 direction;
        const Vector3 edge = curve.Evaluate(t, &direction);
        Vector3 gap;
        face.Surface.Evaluate(uv[0], uv[1], gap.data());
        gap = Subtract(gap, edge);
        // Only the part across the edge makes an area.
        const double square = Dot(direction, direction);
        const double along = square > 0.0 ? Dot(gap, direction) / square : 0.0;
        for (int c = 0; c < 3; ++c)
        {
          gap[c] -= along * direction[c];
        }
        double distance = Norm(gap);
        distance = distance > slip ? std::min(distance, slip + feet.GetDistance(uv, edge, slip)) : distance;
        area += distance * Norm(Subtract(edge, last));
        last = edge;
      }
      // The file's edges begin and end at their vertices.
      area += perimeter *
        std::max(Norm(Subtract(coedge.Use->StartVertex, curve.GetStartPoint())),
          Norm(Subtract(coedge.Use->EndVertex, curve.GetEndPoint())));
    }
  }
  return area;
}

Matrix3 Invert(const Matrix3& m)
{
  const Vector3 columns[3] = { Cross(m[1], m[2]), Cross(m[2], m[0]), Cross(m[0], m[1]) };
  const double determinant = Dot(m[0], columns[0]);
  Matrix3 inverse;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      inverse[i][j] = columns[j][i] / determinant;
    }
  }
  return inverse;
}

/// Compares one face of a file.
class FaceComparison
{
public:
  FaceComparison(
    const std::vector<const Face*>& parts, const FaceStatement& statement, const StatementPlace& place)
    : Parts(parts)
    , Statement(statement)
    , Center(place.Shift)
    , Inverse(Invert(place.Linear))
    , Volume(Dot(this->Inverse[0], Cross(this->Inverse[1], this->Inverse[2])))
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Center[i] += Dot(place.Linear[i], statement.Center);
    }
  }

  FaceFinding Run()
  {
    FaceFinding finding;
    this->Compare(0.0, finding);
    const double perimeter = this->GetPerimeter();
    if (!this->Judge(Negligible * perimeter * perimeter, finding))
    {
      // Most faces that differ have gaps, which are measured faster than the integrals.
      if (!this->Judge(this->GetLimit(GapSamples), finding))
      {
        this->Compare(perimeter / std::cbrt(std::abs(this->Volume)), finding);
        this->Judge(this->GetLimit(FineGapSamples), finding);
      }
    }
    return finding;
  }

private:
  double GetPerimeter() const
  {
    return this->Statement.Boundary.Length > 0.0 ? this->Statement.Boundary.Length : this->Read.Length;
  }

  void Compare(double size, FaceFinding& finding)
  {
    LineIntegrals sum;
    for (const Face* face : this->Parts)
    {
      sum.Add(IntegrateLoops(*face, this->Center, size), { 0.0, 0.0, 0.0 }, 1.0);
    }
    // A reflection leaves loops on the same side in the parameters.
    const double side = this->Statement.IsForward ? 1.0 : -1.0;
    this->Read = sum.Map(this->Inverse);
    finding.Stated = this->Statement.Boundary.GetVectorArea();
    finding.Read = this->Read.GetVectorArea();
    const Matrix3 stated = this->Statement.Boundary.GetMoments();
    const Matrix3 read = this->Read.GetMoments();
    for (int s = 0; s < 2; ++s)
    {
      const double sign = s == 0 ? side : -side;
      double area = 0.0;
      double moment = 0.0;
      for (int i = 0; i < 3; ++i)
      {
        area += std::pow(sign * finding.Read[i] - finding.Stated[i], 2);
        for (int j = 0; j < 3; ++j)
        {
          moment += std::pow(sign * read[i][j] - stated[i][j], 2);
        }
      }
      this->Areas[s] = std::sqrt(area);
      this->Moments[s] = std::sqrt(moment);
    }
    for (double& component : finding.Read)
    {
      component *= side;
    }
  }

  double GetLimit(int samples) const
  {
    const double scale = std::cbrt(std::abs(this->Volume));
    const double perimeter = this->GetPerimeter();
    double gaps = 0.0;
    for (const Face* face : this->Parts)
    {
      gaps += scale * scale * GetGapArea(*face, MaxSlip * perimeter / scale, perimeter / scale, samples);
    }
    return perimeter * perimeter * Negligible + std::min(Safety * gaps, MaxLimit * perimeter * perimeter);
  }

  /// Returns true if the face agrees.
  bool Judge(double limit, FaceFinding& finding) const
  {
    // The conditions are written so that a NaN differs.
    const double lever = Lever * this->GetPerimeter();
    const bool isSame = this->Areas[0] <= limit && this->Moments[0] <= limit * lever;
    const bool isReversed = this->Areas[1] <= limit && this->Moments[1] <= limit * lever;
    finding.Verdict = isSame ? FaceVerdict::Agrees
      : isReversed           ? FaceVerdict::Reversed
                             : FaceVerdict::Differs;
    finding.AreaDifference = this->Areas[0];
    finding.MomentDifference = this->Moments[0];
    return isSame;
  }

  const std::vector<const Face*>& Parts;
  const FaceStatement& Statement;
  Vector3 Center;
  Matrix3 Inverse;
  double Volume;
  LineIntegrals Read;
  /// Differences if the face has the side that the file states, and if it has the other one.
  double Areas[2] = { 0.0, 0.0 };
  double Moments[2] = { 0.0, 0.0 };
};
}

LineIntegrals IntegrateLoops(const Face& face, const Vector3& center, double size)
{
  LoopIntegrator integrator(face, center, size);
  if (face.Loops.empty())
  {
    const double low[2] = { face.Surface.GetDomainStart(0), face.Surface.GetDomainStart(1) };
    const double high[2] = { face.Surface.GetDomainEnd(0), face.Surface.GetDomainEnd(1) };
    const TrimCurve::Point corners[4] = { { low[0], low[1] }, { high[0], low[1] }, { high[0], high[1] },
      { low[0], high[1] } };
    for (int i = 0; i < 4; ++i)
    {
      integrator.AddLine(corners[i], corners[(i + 1) % 4]);
    }
  }
  for (const Loop& loop : face.Loops)
  {
    for (std::size_t i = 0; i < loop.Coedges.size(); ++i)
    {
      const Coedge& coedge = loop.Coedges[i];
      const Coedge& next = loop.Coedges[(i + 1) % loop.Coedges.size()];
      for (int k = 0; k < coedge.Curve.GetNumberOfPieces(); ++k)
      {
        integrator.AddPiece(coedge.Curve.GetPiece(k), coedge.Reversed);
      }
      integrator.AddLine(coedge.Reversed ? coedge.Curve.GetStartPoint() : coedge.Curve.GetEndPoint(),
        next.Reversed ? next.Curve.GetEndPoint() : next.Curve.GetStartPoint());
    }
  }
  return integrator.Get();
}

FaceFinding CheckFace(
  const std::vector<const Face*>& parts, const FaceStatement& statement, const StatementPlace& place)
{
  return statement.IsKnown && !parts.empty() ? FaceComparison(parts, statement, place).Run() : FaceFinding();
}
}
