/**
 * @file smOCCTFootCurve.h
 * @brief The curve of an edge in the parameters of a surface that it lies on, where the file gives none
 */
#ifndef smOCCTFootCurve_h
#define smOCCTFootCurve_h

#include "smOCCTFootPoint.h"

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <gp_Trsf.hxx>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace sm
{
/**
 * The foot points of an edge's curve on a surface, in the curve's own parameter: closed forms on cylinders, cones, spheres and tori,
 * Newton's method to rounding elsewhere. A coordinate that is constant, or runs as the parameter does, but for 1e-7 mm (1e-6 of what
 * is small, 1e-9 of what is large) is that exactly: so circles and rulings become straight lines. On periodic surfaces the curve is
 * continuous and may leave the base period; at a pole the coordinate that is undetermined there is continued. Const methods may be
 * called by several threads.
 */
class SMREADERSSTEP_EXPORT FootCurve
{
public:
  /**
   * `placement` takes the curve to the surface. Null when the surface is of a kind without an inverse, or when the curve's feet
   * could not be followed. The surface must not be trimmed (GetBasisSurface).
   */
  static std::shared_ptr<const FootCurve> Make(const std::shared_ptr<const FootPointFinder>& finder,
    const Handle(Geom_Curve) & curve, const gp_Trsf& placement, double first, double last);

  std::array<double, 2> Evaluate(double t) const;
  /// First, last and the knots of the curve between.
  const std::vector<double>& GetBreaks() const { return this->Breaks; }
  /// The same as a line when one coordinate is constant and the other runs as the parameter does; else null.
  Handle(Geom2d_Curve) GetLine() const;
  /// Largest distance of a foot from the border of the surface's domain, beyond which its polynomials go on; 0 inside.
  double GetOverhang() const;
  /// OpenCASCADE's approximation of the same curve, good to 1e-7 mm at best; null when it has none.
  Handle(Geom2d_Curve) Approximate() const;
  /// Calls visit(u, v) for points that are no less extreme than the curve's, but for what two more parabolas would find.
  void VisitExtremes(const std::function<void(double, double)>& visit) const;
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
  bool FindFoot(const gp_Pnt& point, const Sample* neighbour, Sample& sample);
  void Refine();
  bool IsFar(const Sample& a, const Sample& b) const;
  bool IsEven() const;
  bool IsBesidePole(const Sample& sample) const;
  void Straighten();
  void AddKnotCrossings();
  /// At a pole the coordinate that is undetermined there becomes that of the neighbour.
  void ContinueAtPole(
    const std::array<double, 2>& neighbour, const double speed[2], std::array<double, 2>& uv) const;

  std::shared_ptr<const FootPointFinder> Finder;
  Handle(Geom_Curve) Curve;
  std::vector<double> Breaks;
  std::vector<Sample> Samples;
  double Distance = 0.0;
  double Size = 0.0;
  /// Lengths that do not count.
  double Slack = 0.0;
  /// Slope of a coordinate that is Offset + Slope t; NaN: it is none.
  double Slope[2] = { 0.0, 0.0 };
  double Offset[2] = { 0.0, 0.0 };
};
}

#endif
