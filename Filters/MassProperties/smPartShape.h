/**
 * @file smPartShape.h
 * @brief The shape of a part as moments of the area of each of its faces, which do not depend on their
 * parametrisation
 */
#ifndef smPartShape_h
#define smPartShape_h

#include "smFiltersMassPropertiesModule.h"

#include <array>
#include <string>
#include <vector>

class vtkTrimmedNURBSModel;

namespace sm
{
/// Integrals over a face, about a point of the part: area; x, y, z; xx, yy, zz, xy, yz, xz; the components of
/// the outward normal.
struct SMFILTERSMASSPROPERTIES_EXPORT FaceAreaMoments
{
  double Area = 0.0;
  std::array<double, 3> First{};
  std::array<double, 6> Second{};
  std::array<double, 3> VectorArea{};
  /// Bounds of the area, of first and second moments, and of the normal's integral; each is the largest of
  /// its components.
  double AreaBound = 0.0;
  double FirstBound = 0.0;
  double SecondBound = 0.0;
  double VectorAreaBound = 0.0;

  /// Index in Second of the integral of x_i x_j.
  static constexpr int Pair[3][3] = { { 0, 3, 5 }, { 3, 1, 4 }, { 5, 4, 2 } };
  double GetTrace() const { return this->Second[0] + this->Second[1] + this->Second[2]; }
  /// Applies a row-major rotation or reflection about the point. The bounds are not changed: they are those
  /// of the components before the rotation.
  void Rotate(const std::array<double, 9>& matrix);
};

/// A part, in its own coordinates or placed.
struct SMFILTERSMASSPROPERTIES_EXPORT PartShape
{
  /// The point that the faces refer to; after Center() that of the area's centre.
  std::array<double, 3> Reference{};
  std::vector<FaceAreaMoments> Faces;
  /// False for a free shell.
  bool IsSolid = true;
  /// The reason why the shape is not known; empty if it is. An unknown shape is equal to no other.
  std::string Problem;

  double GetArea() const;
  /// About half the size of the part, the same for every placement.
  double GetRadius() const;
  /// Changes the reference to the centre of the area.
  void Center();
  /// Applies the first three rows of a 4x4 placement (rotation or reflection, translation).
  void Place(const double placement[12]);
};

/// Returns the shapes of models, integrated on the CPU. `relativeTolerance`: of the integrals, relative to
/// the part; the bounds are mostly far smaller. `maximumSeconds`: 0 for no limit. A part that is not
/// integrated by then has a Problem, and so has one with a face whose bounds exceed 1e-6 of its integrals.
SMFILTERSMASSPROPERTIES_EXPORT std::vector<PartShape> MeasureShapes(
  const std::vector<vtkTrimmedNURBSModel*>& models, double relativeTolerance, double maximumSeconds = 0.0);
}

#endif
