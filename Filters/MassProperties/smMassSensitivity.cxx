#include "Detail/smMassSensitivity.h"

#include "Detail/smOffsetGeometry.h"
#include "smBodyIntegrals.h"
#include "smBodyScales.h"
#include "smMassIntegrands.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace sm
{
namespace
{
constexpr int FirstAreaMoment = NumberOfMassIntegrands;
/// Index of (i,j) in XX YY ZZ XY YZ XZ.
constexpr int PairIndex[3][3] = { { 0, 3, 5 }, { 3, 1, 4 }, { 5, 4, 2 } };
/// Relative error of a value that follows from a few operations.
constexpr double FewRoundings = 32.0 * UnitRoundoff;
/// Principal moments coincide within their bounds, or within this of the largest, the rounding of the file's
/// coordinates.
constexpr double CoincidentMoments = 1e-9;

using Matrix = std::array<std::array<double, 3>, 3>;

/// Returns whether a principal moment is apart from both others.
bool IsSingle(const MassProperties& properties, int k)
{
  const double limit =
    std::max(2.0 * properties.PrincipalBound, CoincidentMoments * std::abs(properties.Principal[2]));
  for (int j = 0; j < 3; ++j)
  {
    if (j != k && !(std::abs(properties.Principal[j] - properties.Principal[k]) > limit))
    {
      return false;
    }
  }
  return true;
}
}

void AreaMoments::Move(const Vector3& way)
{
  const Vector3 first = this->First;
  double size = 0.0;
  double distance = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    this->First[i] -= way[i] * this->Area;
    size = std::max(size, std::abs(first[i]));
    distance = std::max(distance, std::abs(way[i]));
    for (int j = 0; j < 3; ++j)
    {
      this->Second[i][j] += way[i] * way[j] * this->Area - way[i] * first[j] - way[j] * first[i];
    }
  }
  this->SecondBound += 2.0 * distance * this->FirstBound + distance * distance * this->AreaBound +
    FewRoundings * distance * (distance * this->Area + 2.0 * size);
  this->FirstBound += distance * this->AreaBound + FewRoundings * (distance * this->Area + size);
}

bool HasAreaMoments(const BodyIntegrals& body, const MassRow& row, std::size_t face)
{
  const FaceIntegrals* integrals = body.Faces ? &(*body.Faces)[face] : nullptr;
  return integrals && integrals->Error.empty() && !integrals->Skipped &&
    std::isfinite(row.Properties.Center[0]) && row.Properties.VolumeBound < std::abs(row.Properties.Volume);
}

AreaMoments GetAreaMoments(const BodyIntegrals& body, const MassRow& row, std::size_t index)
{
  const FaceIntegrals& face = (*body.Faces)[index];
  AreaMoments moments;
  moments.Area = face.Face[MassArea];
  moments.AreaBound = face.GetBound(MassArea);
  Vector3 center;
  for (int i = 0; i < 3; ++i)
  {
    center[i] = body.Value[MassFirst + i] / body.Value[MassVolume];
  }
  // The centre is off by no more than its bound, which moves all moments.
  const double shift = row.Properties.CenterBound;
  const double area = moments.Area + moments.AreaBound;
  Vector3 first;
  Matrix second;
  double firstSize = 0.0;
  double secondSize = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double raw = face.Face[FirstAreaMoment + i];
    first[i] = raw - center[i] * moments.Area;
    firstSize = std::max(firstSize, std::abs(first[i]));
    moments.FirstBound = std::max(moments.FirstBound,
      face.GetBound(FirstAreaMoment + i) + std::abs(center[i]) * moments.AreaBound +
        FewRoundings * (std::abs(raw) + std::abs(center[i]) * moments.Area));
  }
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      const int k = FirstAreaMoment + 3 + PairIndex[i][j];
      const double a = face.Face[FirstAreaMoment + i];
      const double b = face.Face[FirstAreaMoment + j];
      const double raw = face.Face[k];
      second[i][j] = raw - center[i] * b - center[j] * a + center[i] * center[j] * moments.Area;
      secondSize = std::max(secondSize, std::abs(second[i][j]));
      moments.SecondBound = std::max(moments.SecondBound,
        face.GetBound(k) + std::abs(center[i]) * face.GetBound(FirstAreaMoment + j) +
          std::abs(center[j]) * face.GetBound(FirstAreaMoment + i) +
          std::abs(center[i] * center[j]) * moments.AreaBound +
          FewRoundings *
            (std::abs(raw) + std::abs(center[i] * b) + std::abs(center[j] * a) +
              std::abs(center[i] * center[j]) * moments.Area));
    }
  }
  moments.SecondBound += 2.0 * shift * (firstSize + moments.FirstBound) + area * shift * shift;
  moments.FirstBound += area * shift;
  // A rotation or mirror makes no sum of three, or nine, products larger than these factors.
  const auto rotation = [&body](int i, int j) { return body.Placement[4 * i + j]; };
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      moments.First[i] += rotation(i, k) * first[k];
      for (int j = 0; j < 3; ++j)
      {
        for (int l = 0; l < 3; ++l)
        {
          moments.Second[i][j] += rotation(i, k) * rotation(j, l) * second[k][l];
        }
      }
    }
  }
  moments.FirstBound = std::sqrt(3.0) * (moments.FirstBound + FewRoundings * firstSize);
  moments.SecondBound = 3.0 * (moments.SecondBound + FewRoundings * secondSize);
  return moments;
}

std::array<double, 3> GetPrincipalSlopes(
  const MassProperties& properties, const AreaMoments& area, double& bound)
{
  // a . (tr(Q) 1 - Q) a with the axis a and the area's second moments Q.
  std::array<double, 3> slopes;
  slopes.fill(std::numeric_limits<double>::quiet_NaN());
  bound = slopes[0];
  const Matrix& q = area.Second;
  const double trace = q[0][0] + q[1][1] + q[2][2];
  double largest = 0.0;
  for (const std::array<double, 3>& row : q)
  {
    for (const double entry : row)
    {
      largest = std::max(largest, std::abs(entry));
    }
  }
  // No entry of a sum over unit vectors is larger than the norm of the change of the inertia.
  const double norm = 2.0 * trace + 3.0 * largest;
  double gap = std::numeric_limits<double>::infinity();
  bool hasSome = false;
  for (int k = 0; k < 3; ++k)
  {
    if (!IsSingle(properties, k))
    {
      continue;
    }
    hasSome = true;
    for (int j = 0; j < 3; ++j)
    {
      const double distance = std::abs(properties.Principal[j] - properties.Principal[k]);
      gap = j == k ? gap : std::min(gap, distance);
    }
    const double* a = properties.Axes.data() + 3 * k;
    double along = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        along += a[i] * q[i][j] * a[j];
      }
    }
    slopes[k] = trace - along;
  }
  if (hasSome)
  {
    // The axis turns by at most the angle of MassProperties::AxesBound, here for the single moments alone.
    const double e = properties.PrincipalBound;
    const double angle = e < gap ? std::asin(std::min(1.0, e / (gap - e))) : 1.0;
    bound = 6.0 * area.SecondBound + norm * (2.0 * angle + angle * angle) + FewRoundings * norm;
  }
  return slopes;
}

BodyOffsets::BodyOffsets(
  const std::vector<BodyIntegrals>& bodies, const std::function<bool()>& shouldContinue)
{
  std::map<vtkTrimmedNURBSModel*, std::shared_ptr<const OffsetGeometry>> known;
  for (const BodyIntegrals& body : bodies)
  {
    std::shared_ptr<const OffsetGeometry>& geometry = known[body.Model];
    if (!geometry && body.HasVolume() && body.Faces)
    {
      std::vector<signed char> sides(body.Model->GetFaces().size());
      for (std::size_t f = 0; f < sides.size(); ++f)
      {
        sides[f] = (body.InsideOut ? -1.0 : 1.0) * body.GetSide(f) > 0.0 ? 1 : -1;
      }
      geometry = std::make_shared<OffsetGeometry>(MeasureOffsets(*body.Model, sides, shouldContinue));
    }
    else if (!geometry)
    {
      auto unknown = std::make_shared<OffsetGeometry>();
      unknown->IsKnown = false;
      geometry = unknown;
    }
    this->Geometries.push_back(geometry);
  }
}

FaceSensitivity::FaceSensitivity()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  this->Volume = this->VolumeBound = this->Mass = this->MassBound = this->Area = this->AreaBound =
    this->CenterBound = this->PrincipalBound = nan;
  this->Center.fill(nan);
  this->Principal.fill(nan);
}

const std::vector<Integrand>& GetSensitivityIntegrands()
{
  static const std::vector<Integrand> integrands = []()
  {
    std::vector<Integrand> all = GetMassIntegrands();
    for (int k = MassFirst; k < MassVectorArea; ++k)
    {
      const Integrand& volume = GetMassIntegrands()[k];
      const std::array<int, 3>& p = volume.Powers;
      all.push_back(Integrand::AreaMoment("Area" + volume.Name, p[0], p[1], p[2]));
    }
    return all;
  }();
  return integrands;
}

std::vector<double> AddAreaTolerances(std::vector<double> tolerances, vtkTrimmedNURBSModel& model)
{
  const double area = tolerances[MassArea];
  const double radius = GetRadius(model);
  for (int k = MassFirst; k < MassVectorArea; ++k)
  {
    tolerances.push_back(area * (k < MassSecond ? radius : radius * radius));
  }
  return tolerances;
}

FaceSensitivity ComputeSensitivity(
  const BodyIntegrals& body, const MassRow& row, const OffsetGeometry& geometry, std::size_t face)
{
  FaceSensitivity result;
  const MassProperties& p = row.Properties;
  if (!HasAreaMoments(body, row, face))
  {
    return result;
  }
  const AreaMoments area = GetAreaMoments(body, row, face);
  if (geometry.IsKnown)
  {
    result.Area = geometry.Faces[face].AreaSlope;
    result.AreaBound = geometry.Faces[face].AreaSlopeError;
  }
  result.Volume = area.Area;
  result.VolumeBound = area.AreaBound;
  const double density = row.GetAddedDensity();
  result.Mass = density * area.Area;
  result.MassBound = std::abs(density) * area.AreaBound +
    area.Area *
      ((density != 0.0 ? row.MassBound : 0.0) * (1.0 + 2.0 * row.ShareOfProduct) +
        std::abs(density) * p.VolumeBound) /
      (p.Volume - p.VolumeBound) +
    FewRoundings * std::abs(result.Mass);
  double largest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    result.Center[i] = area.First[i] / p.Volume;
    largest = std::max(largest, std::abs(result.Center[i]));
  }
  result.CenterBound =
    (area.FirstBound + largest * p.VolumeBound) / (p.Volume - p.VolumeBound) + FewRoundings * largest;
  result.Principal = GetPrincipalSlopes(p, area, result.PrincipalBound);
  return result;
}
}
