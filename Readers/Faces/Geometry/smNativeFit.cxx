#include "smNativeFit.h"

#include "smVector.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
using Wide = long double;
using WideVector = std::array<Wide, 3>;

constexpr int Iterations = 6;
// Steps of the differences for derivatives, relative to the size, and the weight of a step's own square,
// which keeps what the points do not determine.
constexpr Wide Difference = 1e-6L;
constexpr Wide Damping = 1e-13L;

WideVector Widen(const Vector3& v)
{
  return { v[0], v[1], v[2] };
}

/// A surface of revolution with parameters in extended precision.
struct WideSurface
{
  ElementarySurface::Type Kind;
  WideVector Origin;
  std::array<WideVector, 3> Axes;
  Wide Radii[2];
  Wide Angle;
  Wide Widths[2];
  int Counts[2];
  Wide Start[2];
  Wide Slopes[2];
  /// Of the second parameter.
  Wide Domain[2];
  Wide Size;

  explicit WideSurface(const NURBSSurface& surface, const NativeSurface& native)
    : Kind(native.Surface.Kind)
    , Origin(Widen(native.Surface.Frame.Origin))
    , Axes{ Widen(native.Surface.Frame.Axes[0]), Widen(native.Surface.Frame.Axes[1]),
      Widen(native.Surface.Frame.Axes[2]) }
    , Radii{ native.Surface.Radii[0], native.Surface.Radii[1] }
    , Angle(native.Surface.Angle)
    , Widths{ native.Parameters[0].Width, native.Parameters[1].Width }
    , Counts{ native.Parameters[0].Count, native.Parameters[1].Count }
    , Start{ native.Start[0], native.Start[1] }
    , Slopes{ native.Linear[0][0], native.Linear[1][1] }
    , Domain{ surface.GetDomainStart(1), surface.GetDomainEnd(1) }
    , Size(std::max(native.Surface.Radii[0], native.Surface.Radii[1]))
  {
  }

  static constexpr int MaxParameters = 12;
  int GetNumberOfParameters() const { return this->Kind == ElementarySurface::Type::Torus ? 12 : 11; }

  /// Adds a step: of the origin, of the axes as a rotation, of the angle of an arc and of the first radius;
  /// then of start and slope, or angle of an arc, of the profile, and of the angle of a cone or the second
  /// radius of a torus.
  void Move(const Wide* step)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Origin[c] += this->Size * step[c];
    }
    const std::array<WideVector, 3> before = this->Axes;
    for (int a = 0; a < 2; ++a)
    {
      WideVector& axis = this->Axes[2 - 2 * a];
      const WideVector& from = before[2 - 2 * a];
      for (int c = 0; c < 3; ++c)
      {
        axis[c] += step[3 + (c + 1) % 3] * from[(c + 2) % 3] - step[3 + (c + 2) % 3] * from[(c + 1) % 3];
      }
    }
    this->Orthonormalize();
    this->Widths[0] += step[6];
    this->Radii[0] += this->Size * step[7];
    if (this->Counts[1] > 0)
    {
      this->Start[1] += step[8];
      this->Widths[1] += step[9];
      this->Radii[1] += this->Kind == ElementarySurface::Type::Torus ? this->Size * step[11] : 0;
    }
    else
    {
      this->Start[1] += this->Size * step[8];
      this->Slopes[1] += this->Size / (this->Domain[1] - this->Domain[0]) * step[9];
      this->Angle += this->Kind == ElementarySurface::Type::Cone ? step[10] : 0;
    }
  }

  /// The coordinates of all control points of the arcs, homogeneous.
  void AppendPoles(std::vector<Wide>& poles) const
  {
    const int rows = this->Counts[1] > 0 ? 2 * this->Counts[1] + 1 : 2;
    for (int j = 0; j < rows; ++j)
    {
      Wide radius = this->Radii[0];
      Wide height = 0;
      Wide weight = 1;
      if (this->Counts[1] > 0)
      {
        const bool isTorus = this->Kind == ElementarySurface::Type::Torus;
        const Wide at = this->Start[1] + this->Slopes[1] * this->Widths[1] * j / 2;
        weight = j % 2 ? std::cos(this->Widths[1] / 2) : Wide(1);
        const Wide minor = isTorus ? this->Radii[1] : this->Radii[0];
        radius = (isTorus ? weight * this->Radii[0] : 0) + minor * std::cos(at);
        height = minor * std::sin(at);
      }
      else
      {
        const Wide along = this->Start[1] + this->Slopes[1] * this->Domain[j];
        radius += along * std::sin(this->Angle);
        height = along * std::cos(this->Angle);
      }
      for (int i = 0; i <= 2 * this->Counts[0]; ++i)
      {
        const Wide angle = this->Start[0] + this->Slopes[0] * this->Widths[0] * i / 2;
        const Wide inU = i % 2 ? std::cos(this->Widths[0] / 2) : Wide(1);
        for (int c = 0; c < 3; ++c)
        {
          poles.push_back(inU * (weight * this->Origin[c] + height * this->Axes[2][c]) +
            radius * (std::cos(angle) * this->Axes[0][c] + std::sin(angle) * this->Axes[1][c]));
        }
      }
    }
  }

private:
  void Orthonormalize()
  {
    WideVector& z = this->Axes[2];
    WideVector& x = this->Axes[0];
    const auto normalize = [](WideVector& v)
    {
      const Wide length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
      for (Wide& c : v)
      {
        c /= length;
      }
    };
    normalize(z);
    const Wide along = x[0] * z[0] + x[1] * z[1] + x[2] * z[2];
    for (int c = 0; c < 3; ++c)
    {
      x[c] -= along * z[c];
    }
    normalize(x);
    for (int c = 0; c < 3; ++c)
    {
      this->Axes[1][c] = z[(c + 1) % 3] * x[(c + 2) % 3] - z[(c + 2) % 3] * x[(c + 1) % 3];
    }
  }
};

/// Solves a linear least squares problem by Householder's reflections. `matrix`: columns of `rows` numbers;
/// changed, as `right` is.
void SolveLeastSquares(std::vector<std::vector<Wide>>& matrix, std::vector<Wide>& right, Wide* solution)
{
  const int columns = static_cast<int>(matrix.size());
  const std::size_t rows = right.size();
  for (int k = 0; k < columns; ++k)
  {
    std::vector<Wide>& v = matrix[k];
    Wide square = 0;
    for (std::size_t r = k; r < rows; ++r)
    {
      square += v[r] * v[r];
    }
    const Wide diagonal = v[k] > 0 ? -std::sqrt(square) : std::sqrt(square);
    const Wide factor = square - diagonal * v[k];
    v[k] -= diagonal;
    const auto reflect = [&](std::vector<Wide>& w)
    {
      Wide product = 0;
      for (std::size_t r = k; r < rows; ++r)
      {
        product += v[r] * w[r];
      }
      for (std::size_t r = k; factor > 0 && r < rows; ++r)
      {
        w[r] -= product / factor * v[r];
      }
    };
    for (int other = k + 1; other < columns; ++other)
    {
      reflect(matrix[other]);
    }
    reflect(right);
    // The reflection is not needed any more.
    v[k] = diagonal;
  }
  for (int k = columns - 1; k >= 0; --k)
  {
    Wide sum = right[k];
    for (int other = k + 1; other < columns; ++other)
    {
      sum -= matrix[other][k] * solution[other];
    }
    solution[k] = sum / matrix[k][k];
  }
}
}

void FitNative(const NURBSSurface& surface, NativeSurface& native)
{
  WideSurface fitted(surface, native);
  const int columns = fitted.GetNumberOfParameters();
  std::vector<Wide> wanted;
  for (const std::array<double, 4>& h : surface.ControlPoints)
  {
    wanted.insert(wanted.end(), h.begin(), h.begin() + 3);
  }
  std::vector<Wide> poles;
  fitted.AppendPoles(poles);
  if (poles.size() != wanted.size())
  {
    return;
  }
  for (int iteration = 0; iteration < Iterations; ++iteration)
  {
    std::vector<Wide> right(wanted.size() + columns, 0);
    std::vector<std::vector<Wide>> matrix(columns, right);
    poles.clear();
    fitted.AppendPoles(poles);
    for (std::size_t r = 0; r < wanted.size(); ++r)
    {
      right[r] = (wanted[r] - poles[r]) / fitted.Size;
    }
    for (int k = 0; k < columns; ++k)
    {
      std::vector<Wide> sides[2];
      for (int side = 0; side < 2; ++side)
      {
        Wide step[WideSurface::MaxParameters] = {};
        step[k] = side == 0 ? -Difference : Difference;
        WideSurface moved = fitted;
        moved.Move(step);
        moved.AppendPoles(sides[side]);
      }
      for (std::size_t r = 0; r < wanted.size(); ++r)
      {
        matrix[k][r] = (sides[1][r] - sides[0][r]) / (2 * Difference * fitted.Size);
      }
      matrix[k][wanted.size() + k] = Damping;
    }
    Wide step[WideSurface::MaxParameters] = {};
    SolveLeastSquares(matrix, right, step);
    fitted.Move(step);
  }
  for (int c = 0; c < 3; ++c)
  {
    native.Surface.Frame.Origin[c] = static_cast<double>(fitted.Origin[c]);
    for (int a = 0; a < 3; ++a)
    {
      native.Surface.Frame.Axes[a][c] = static_cast<double>(fitted.Axes[a][c]);
    }
  }
  for (int d = 0; d < 2; ++d)
  {
    native.Surface.Radii[d] = static_cast<double>(fitted.Radii[d]);
    native.Parameters[d].Width = static_cast<double>(fitted.Widths[d]);
    native.Start[d] = static_cast<double>(fitted.Start[d]);
    native.Linear[d][d] = static_cast<double>(fitted.Slopes[d]);
  }
  native.Surface.Angle = static_cast<double>(fitted.Angle);
}

std::vector<ProfilePole> MakeProfile(const NativeSurface& native, const std::array<double, 2>& domain)
{
  const ElementarySurface& surface = native.Surface;
  const NativeParameter& arcs = native.Parameters[1];
  std::vector<ProfilePole> profile;
  if (!arcs.IsCircular)
  {
    for (const double v : domain)
    {
      const double along = native.Start[1] + native.Linear[1][1] * v;
      profile.push_back(
        { surface.Radii[0] + along * std::sin(surface.Angle), along * std::cos(surface.Angle), 1.0 });
    }
    return profile;
  }
  const bool isTorus = surface.Kind == ElementarySurface::Type::Torus;
  const double radius = surface.Radii[isTorus ? 1 : 0];
  for (int j = 0; j <= 2 * arcs.Count; ++j)
  {
    const double angle = native.Start[1] + native.Linear[1][1] * 0.5 * arcs.Width * j;
    const double weight = j % 2 ? std::cos(0.5 * arcs.Width) : 1.0;
    profile.push_back({ (isTorus ? weight * surface.Radii[0] : 0.0) + radius * std::cos(angle),
      radius * std::sin(angle), weight });
  }
  return profile;
}
}
