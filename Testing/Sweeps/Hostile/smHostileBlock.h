/**
 * @file smHostileBlock.h
 * @brief Solids that are maps of the cube, and B-spline forms of Bézier patches without rounding
 */
#ifndef smHostileBlock_h
#define smHostileBlock_h

#include "smHostileShape.h"

namespace smhostile
{
/// Control points of a map of the cube, first index fastest: Cartesian points and weights. The faces'
/// homogeneous points are the products, the truth is that of `Truth`, which may be another form of the same
/// map.
struct BlockPoints
{
  int Degree[3] = { 1, 1, 1 };
  std::vector<std::array<double, 4>> Homogeneous;
  ReferenceBlock Truth;
  /// Faces that have collapsed to a curve or a point, by 2 * direction + side.
  bool Omitted[6] = { false, false, false, false, false, false };
};

/// The six sheets (less the omitted ones), twelve rails and eight vertices. Coinciding rails become one.
void BuildBlock(const BlockPoints& points, Random& random, Shape& shape);

/**
 * Puts a Bézier sheet on other knots, by its blossom: random simple and multiple interior knots at dyadic
 * values, also unclamped ends, and another domain. Only where every new control point is a double exactly and
 * every weight is positive; otherwise the direction is left as it was.
 */
void InsertKnots(Sheet& sheet, int direction, Random& random);
void MoveDomain(Sheet& sheet, Random& random);

/// Families.
void MakePolynomialBlock(Random& random, Shape& shape);
void MakeRationalBlock(Random& random, Shape& shape);
void MakeBallOctant(Random& random, Shape& shape);
/// Full revolutions of closed profiles and of profiles from axis to axis.
void MakeRevolved(Random& random, Shape& shape);

/// Returns x rounded to a multiple of 2^-bits times the power of two at or above `size`: products of a few
/// such numbers are exact doubles.
double Quantize(double x, double size, int bits);
}

#endif
