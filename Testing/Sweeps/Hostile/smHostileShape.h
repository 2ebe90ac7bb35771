/**
 * @file smHostileShape.h
 * @brief Random solids before trimming: patches that close exactly, the curves they share, and their truth
 *
 * A **sheet** is one untrimmed surface, a **rail** the curve along which sheets meet. Two sheets that meet
 * hold the same control points along their rail, bit for bit, and run in step along it. So the sheets close
 * exactly, and the truth is defined by the very doubles that the library is given.
 */
#ifndef smHostileShape_h
#define smHostileShape_h

#include "smHostileRandom.h"
#include "smReferenceIntegral.h"

#include "smNURBSSurface.h"

#include <string>
#include <vector>

namespace smhostile
{
using Point3 = std::array<double, 3>;

/// A boundary curve over t in [0,1]: rational Bézier pieces of equal width.
struct Rail
{
  std::vector<std::vector<RealPoint>> Pieces;
  int StartVertex = 0;
  int EndVertex = 0;
  /// All its points are one: a pole.
  bool Degenerate = false;

  Point3 Evaluate(Real t) const;
};

/// The sides of a sheet, in the order of its border: v low (u rising), u high (v rising), v high (u rising),
/// u low.
enum Side
{
  BOTTOM = 0,
  RIGHT = 1,
  TOP = 2,
  LEFT = 3
};

struct Sheet
{
  sm::NURBSSurface Surface;
  /// The outward normal is -(Su x Sv).
  bool Reversed = false;
  /// Rail of each side; a rail's t runs as the side's u or v: u = Low + Width t, exactly (Width is a power of
  /// two).
  int Sides[4] = { 0, 0, 0, 0 };
  double Low[2] = { 0.0, 0.0 };
  double Width[2] = { 1.0, 1.0 };
};

struct Shape
{
  std::string Family;
  std::vector<Sheet> Sheets;
  std::vector<Rail> Rails;
  std::vector<Point3> Vertices;
  std::vector<ReferencePatch> Patches;
  /// The map of the cube that the truth can be checked with; empty degrees: there is none.
  ReferenceBlock Block;
  /// Volume by a closed formula, NaN when there is none.
  Real FormulaVolume = 0;
  /// Half the largest extent.
  double Size = 1.0;
};

/// A random solid; the same random numbers give the same solid.
Shape MakeShape(Random& random);

/// Exchanges u and v: the same point set, the other orientation of parameters.
Sheet Transpose(const Sheet& sheet);
}

#endif
