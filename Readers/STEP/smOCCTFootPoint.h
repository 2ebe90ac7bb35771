/**
 * @file smOCCTFootPoint.h
 * @brief The foot of a point on a surface
 */
#ifndef smOCCTFootPoint_h
#define smOCCTFootPoint_h

#include "smReadersSTEPModule.h"

#include <Geom_Surface.hxx>
#include <gp_Pnt.hxx>

#include <algorithm>
#include <memory>
#include <vector>

namespace sm
{
/// The foot of a point on a surface. One for each face: what it needs of a surface is computed once.
class SMREADERSSTEP_EXPORT FootPointFinder
{
public:
  /// Null for a surface of a kind that has no inverse here.
  static std::shared_ptr<const FootPointFinder> Make(const Handle(Geom_Surface) & surface);
  virtual ~FootPointFinder() = default;

  /// Parameters of the foot. Near `guess` where there is one: whole periods are chosen so. False when it was not found.
  virtual bool Find(const gp_Pnt& point, const double* guess, double uv[2]) const = 0;

  const Handle(Geom_Surface) & GetSurface() const { return this->Surface; }
  /// 0: not periodic.
  double GetPeriod(int direction) const { return this->Period[direction]; }

  /// A line of constant parameter that is one point of the surface.
  struct Pole
  {
    /// The coordinate that is constant, and its value.
    int Direction;
    double Value;
  };
  const std::vector<Pole>& GetPoles() const { return this->Poles; }
  /// Interior knots of a spline surface.
  const std::vector<double>& GetKnots(int direction) const { return this->Knots[direction]; }
  /// By how much the parameter lies beyond the domain; 0 inside and where it is periodic.
  double GetExcess(int direction, double value) const
  {
    return std::max({ 0.0, this->Low[direction] - value, value - this->High[direction] });
  }
  /// The border of the domain, or the pole, that is no farther from the parameter than `slack`; else the parameter.
  double SnapToBorder(int direction, double value, double slack) const;

protected:
  explicit FootPointFinder(const Handle(Geom_Surface) & surface);
  /// Moves uv by whole periods next to `guess`.
  void Unroll(const double* guess, double uv[2]) const;

  Handle(Geom_Surface) Surface;
  double Period[2] = { 0.0, 0.0 };
  /// Ends of the domain where it is not periodic, else infinite.
  double Low[2];
  double High[2];
  std::vector<double> Knots[2];
  std::vector<Pole> Poles;
};
}

#endif
