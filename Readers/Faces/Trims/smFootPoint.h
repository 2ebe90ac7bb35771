/**
 * @file smFootPoint.h
 * @brief The foot of a point on a surface
 */
#ifndef smFootPoint_h
#define smFootPoint_h

#include "Geometry/smGeometricSurface.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace sm
{
/// Finds the foot points of points on a surface. Every face has one finder, which computes the data that it
/// needs of the surface once.
class SMREADERSFACES_EXPORT FootPointFinder
{
public:
  /// Makes a finder for a surface; null for a kind of surface that is not supported, and for a closed one
  /// that is not periodic: a point on its seam has two feet. With `allowSeams` that is made, too, and finds
  /// one.
  static std::shared_ptr<const FootPointFinder> Make(const SurfacePointer& surface, bool allowSeams = false);
  virtual ~FootPointFinder() = default;

  /// Finds the parameters of the foot point; if there is a `guess`, in the period nearest to it. Returns
  /// false if it was not found.
  virtual bool Find(const Vector3& point, const double* guess, double uv[2]) const = 0;
  const SurfacePointer& GetSurface() const { return this->Surface; }
  /// Period of a direction; 0: not periodic.
  double GetPeriod(int direction) const { return this->Period[direction]; }

  /// A line of constant parameter that is one point of the surface.
  struct Pole
  {
    /// The constant coordinate (0: u, 1: v), and its value.
    int Direction;
    double Value;
  };
  const std::vector<Pole>& GetPoles() const { return this->Poles; }
  /// Interior knots of a spline surface.
  const std::vector<double>& GetKnots(int direction) const { return this->Knots[direction]; }
  /// Returns the distance of a parameter beyond the domain; 0 inside, and in a periodic direction.
  double GetExcess(int direction, double value) const
  {
    return std::max({ 0.0, this->Low[direction] - value, value - this->High[direction] });
  }
  /// Returns the parameter, or the end of the domain if it lies beyond.
  double ClampToDomain(int direction, double value) const
  {
    return std::clamp(value, this->Low[direction], this->High[direction]);
  }
  /// Returns the border of the domain, or the pole, if it is within `slack` of the parameter; else the
  /// parameter.
  double SnapToBorder(int direction, double value, double slack) const;

protected:
  explicit FootPointFinder(const SurfacePointer& surface);
  /// Moves uv by whole periods to be nearest to `guess`.
  void Unroll(const double* guess, double uv[2]) const;

  SurfacePointer Surface;
  double Period[2] = { 0.0, 0.0 };
  /// Ends of the domain where it is not periodic, else infinite.
  double Low[2];
  double High[2];
  std::vector<double> Knots[2];
  std::vector<Pole> Poles;
};
}

#endif
