/**
 * @file smHostileCuts.h
 * @brief Random curves that split the unit square, and edge curves of any quality
 */
#ifndef smHostileCuts_h
#define smHostileCuts_h

#include "smHostileRandom.h"
#include "smHostileShape.h"

#include "smPolynomialCurve.h"

#include <functional>
#include <string>
#include <vector>

namespace smhostile
{
using Point2 = std::array<double, 2>;

/// How a sheet is split. Curves are in the sheet's own parameters, (0,0) to (1,1).
struct Split
{
  enum class Kind
  {
    None,
    /// Curves from the bottom to the top, from left to right; they may touch, and do not cross.
    Columns,
    /// One curve from (a,0) to (0,b).
    LowCorner,
    /// One curve from (a,1) to (1,b).
    HighCorner,
    /// Closed curves, counter-clockwise, each a list of pieces; they may touch in a corner.
    Holes
  };
  Kind How = Kind::None;
  std::string Name = "whole";
  std::vector<sm::TrimCurve> Curves;
  std::vector<std::vector<sm::TrimCurve>> Loops;
};

/// `lines`: the sheet's interior knots in its own parameters, to run along and to graze.
Split MakeSplit(Random& random, const std::vector<double> lines[2]);

/// How well an edge's curve follows the boundary.
struct EdgeQuality
{
  /// Degree and number of pieces of the interpolant.
  int Degree = 9;
  int Pieces = 4;
  /// Random offset of its control points, a length.
  double Offset = 0.0;
  /// How far the curve runs ahead of the boundary in the middle, a part of its parameter range.
  double Lag = 0.0;
};

/// Interpolates `position` over [start, end] piece by piece.
sm::EdgeCurve MakeEdgeCurve(const std::function<Point3(double)>& position, double start, double end,
  const EdgeQuality& quality, Random& random);

/// The pieces of a loop as one closed curve: an edge that starts and ends in one vertex.
sm::TrimCurve JoinLoop(const std::vector<sm::TrimCurve>& pieces);

/// A parameter on a rail: few enough bits that moving the domain is exact.
double QuantizeParameter(double t);
}

#endif
