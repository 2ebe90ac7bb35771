/**
 * @file smStrip.h
 * @brief The two curves of a ribbon over a common parameter, and bounds of their distance
 */
#ifndef smStrip_h
#define smStrip_h

#include "smFacePanels.h"
#include "smPolynomialCurve.h"

#include <array>
#include <vector>

namespace sm
{
/// A ribbon whose two curves are parametrised over [0,1].
class Strip
{
public:
  Strip(const FacePanels& panels, const Ribbon& ribbon);

  /// Returns the position of the face's curve in the parameters of the trim pieces, and that of the edge's
  /// curve.
  std::array<double, 2> EvaluateTrim(double t) const { return this->Trim.Evaluate(this->ToTrim(t)); }
  std::array<double, 3> EvaluateEdge(double t) const { return this->EdgePiece.Evaluate(this->ToEdge(t)); }

  /// Returns an upper bound of the distance between the curves at equal t in [start, end].
  double GetGap(double start, double end) const;

  int FaceDegree;
  int EdgeDegree;
  /// Upper bounds of the gap between the curves and of the sum of their lengths. The strip's area is at most
  /// their product.
  double Gap;
  double Length;
  /// Lowest weight of the patch.
  double MinWeight;
  /// Largest distance of the edge's control points from the model's origin.
  double EdgeReach = 0.0;

private:
  double ToTrim(double t) const { return this->Own.Start + (this->Own.End - this->Own.Start) * t; }
  double ToEdge(double t) const
  {
    return this->Own.EdgeStart + (this->Own.EdgeEnd - this->Own.EdgeStart) * t;
  }

  const FacePanels& Panels;
  const Patch& Source;
  const Ribbon& Own;
  std::vector<std::array<double, 2>> TrimPoints;
  std::vector<std::array<double, 3>> EdgePoints;
  BernsteinPiece<2> Trim;
  BernsteinPiece<3> EdgePiece;
};
}

#endif
