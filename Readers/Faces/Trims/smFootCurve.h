/**
 * @file smFootCurve.h
 * @brief Computes the trim curve of an edge on a surface where the file has none
 */
#ifndef smFootCurve_h
#define smFootCurve_h

#include "Geometry/smPlacement.h"
#include "smFootPoint.h"

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace sm
{
/**
 * The foot points of an edge's curve on a surface, in the curve's own parameter: closed forms on cylinders,
 * cones, spheres and tori, Newton's method to rounding elsewhere. A coordinate that is constant, or the
 * parameter plus a constant, within 1e-10 of the size (near poles 1e-7 mm, 1e-6 of the size of small
 * curves, 1e-9 of large ones) is made so exactly, see GetResidual(): circles and rulings become straight
 * lines. On periodic surfaces the curve is continuous and may leave the base period; at a pole the
 * undetermined coordinate is continued from its neighbours. Const methods may be called by several threads.
 */
class SMREADERSFACES_EXPORT FootCurve
{
public:
  /**
   * `placement` transforms the curve to the coordinates of the surface. Returns null if FootPointFinder does
   * not support the surface, or if foot points could not be found along the whole curve.
   */
  static std::shared_ptr<const FootCurve> Make(const std::shared_ptr<const FootPointFinder>& finder,
    const CurvePointer<3>& curve, const Placement& placement, double first, double last);

  std::array<double, 2> Evaluate(double t) const;
  /// First, last and the knots of the curve between.
  const std::vector<double>& GetBreaks() const { return this->Breaks; }
  /// Returns the same curve as a line if one coordinate is constant and the other one is the parameter plus a
  /// constant; else null.
  CurvePointer<2> GetLine() const;
  /// Returns the largest distance of a foot point beyond the border of the surface's domain, where its
  /// polynomials are continued; 0 if all are inside.
  double GetOverhang() const;
  /// Returns a cubic spline through some of the foot points, with the same parameter, within the surface's
  /// domain.
  CurvePointer<2> Approximate() const;
  /// Calls visit(u, v) for points that are no less extreme than the curve's, except for what two more
  /// parabolas would find.
  void VisitExtremes(const std::function<void(double, double)>& visit) const;
  /// Largest distance of a coordinate from the foot points' that it was made constant or linear from; 0 if it
  /// was not.
  double GetResidual(int direction) const { return this->Residual[direction]; }
  /// Returns true if the curve passes a pole so closely that its foot points are not smooth, or not within
  /// rounding of a straight line.
  bool IsDisturbedByPole() const { return this->Disturbed; }
  /// Largest distance of a sample from its foot, in the surface's coordinates.
  double GetDistance() const { return this->Distance; }

private:
  struct Sample
  {
    double T;
    std::array<double, 2> UV;
    /// Lengths of the derivatives of the surface.
    double Speed[2];
  };
  bool Follow();
  void FindCloserFeet(const std::vector<double>& parameters, std::vector<std::array<double, 2>>& feet) const;
  bool FindFoot(const Vector3& point, const Sample* neighbour, Sample& sample);
  void Refine();
  bool IsFar(const Sample& a, const Sample& b) const;
  bool IsEven() const;
  static bool IsNear(const FootPointFinder::Pole& pole, const Sample& sample, double distance);
  bool PassesPole(bool onlyUneven) const;
  bool IsBesidePole(const Sample& sample) const;
  void Straighten();
  double GetLineValue(int d, double t) const;
  void SetLine(int d, std::size_t first, std::size_t last);
  void AddKnotCrossings();
  double FindCrossing(int direction, double value, const Sample& from, const Sample& to) const;
  /// Sets the undetermined coordinate at a pole to that of the neighbouring sample.
  void ContinueAtPole(
    const std::array<double, 2>& neighbour, const double speed[2], std::array<double, 2>& uv) const;

  std::shared_ptr<const FootPointFinder> Finder;
  CurvePointer<3> Curve;
  std::vector<double> Breaks;
  std::vector<Sample> Samples;
  double Distance = 0.0;
  double Size = 0.0;
  /// Length below which distances are ignored.
  double Slack = 0.0;
  /// Length that the rounding of coordinates may be.
  double Rounding = 0.0;
  /// Slope of a coordinate that is Offset + Slope t; NaN if it is not linear.
  double Slope[2] = { 0.0, 0.0 };
  double Offset[2] = { 0.0, 0.0 };
  double Residual[2] = { 0.0, 0.0 };
  bool Disturbed = false;
};
}

#endif
