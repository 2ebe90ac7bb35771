/**
 * @file smOffsetGeometry.h
 * @brief Curvatures of faces, angles at edges and corners: the second and third order of offsets of faces
 *
 * Faces of a body move by t_i along their outward normals, and neighbours are continued or cut to meet. Then
 * the volume changes by
 *
 *     sum over faces  t A + t^2/2 integral of 2H dA + t^3/3 integral of K dA
 *     + sum over edges  integral of (2 t1 t2 - (t1^2 + t2^2) cos) / (2 sin) ds
 *     + sum over corners of faces  t/6 ((P . b)(P . e) - (P . b')(P . e')),
 *
 * with the mean and Gaussian curvatures H and K, positive and both of one sign where the body is convex, and
 * the angle between outward normals, whose sine is negative at concave edges; P is the way of the vertex, e
 * the direction of the loop along the edge before and b the outward conormal there, e' and b' behind the
 * vertex. This is exact for polyhedra, and for smooth surfaces below their curvature radii.
 * Filters/Quadrature/Bounds.md, "Tolerances of faces", has the proof, and bounds what is lacking otherwise.
 */
#ifndef smOffsetGeometry_h
#define smOffsetGeometry_h

#include "smFace.h"
#include "smFiltersMassPropertiesModule.h"
#include "smVector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

class vtkTrimmedNURBSModel;

namespace sm
{
/// Curvatures of a face, positive where it is convex; lengths in model units. Integrals come from Gauss rules
/// of 12 by 12 points on each panel; ten times the difference from those of 8 counts as their error, and what
/// creases add.
struct OffsetFace
{
  /// Integrals of the sum of the principal curvatures, of their product, and of the absolute values of both.
  double Mean = 0.0;
  double Gauss = 0.0;
  double AbsoluteMean = 0.0;
  double AbsoluteGauss = 0.0;
  double MeanError = 0.0;
  double GaussError = 0.0;
  /// Derivative of the area of all faces by an offset of this one, whose neighbours are continued or cut to
  /// meet it: Mean, plus the integral of the tangent of half the angle along its edges; and its error.
  double AreaSlope = 0.0;
  double AreaSlopeError = 0.0;
  /// Smallest and largest principal curvature at the points of the rules.
  double Smallest = 0.0;
  double Largest = 0.0;
  /// False if the face could not be cut or evaluated.
  bool IsKnown = true;
  bool IsFlat = true;
  /// True if it has a crease, or a border, that is not an edge of the model, or if an edge of it has a
  /// corner.
  bool IsCreased = false;
  /// A box that contains the face, in coordinates of the model.
  Vector3 Low{};
  Vector3 High{};
};

/// Faces are continued to meet at an edge if the edge moves across them by no more than so many offsets. A
/// sharper edge is cut off there.
constexpr double MaxOffsetWay = 10.0;
/// Faces are tangent if the sine of the angle between their normals is no larger; if their offsets differ
/// there is a step between them.
constexpr double TangentSine = 1e-3;

/// A point of an edge between two faces.
struct OffsetEdgeSample
{
  /// Length of the part of the edge that the point stands for.
  double Length = 0.0;
  /// Cosine and sine of the angle between the outward normals; the sine is negative at concave edges.
  double Cosine = 1.0;
  double Sine = 0.0;
  /// Curvature of the edge, and of both faces across it, without signs.
  double Bend = 0.0;
  std::array<double, 2> Across{};

  /// Tangent of half the angle: the way of the edge across both faces by an offset of 1.
  double GetHalfTangent() const { return this->Sine / (1.0 + this->Cosine); }
  double GetWay() const { return std::min(std::max(this->GetHalfTangent(), -MaxOffsetWay), MaxOffsetWay); }
};

struct OffsetEdge
{
  std::array<std::size_t, 2> Faces{};
  std::vector<OffsetEdgeSample> Samples;
  /// Integral of the tangent of half the angle, and ten times the difference of two rules.
  double HalfTangent = 0.0;
  double HalfTangentError = 0.0;
  /// The same difference for GetWay().
  double WayError = 0.0;
  double Length = 0.0;
  /// Sum of the angles of small corners between pieces of the edge.
  double Turn = 0.0;
};

/// The corner of a face at a vertex: the outward normal, unit vectors along the loop before and behind the
/// vertex, and the outward conormals there.
struct OffsetCorner
{
  std::size_t Face = 0;
  /// Indices of the edges before and behind the vertex.
  std::array<std::size_t, 2> Edges{};
  Vector3 Normal{};
  Vector3 Before{};
  Vector3 BeforeOut{};
  Vector3 Behind{};
  Vector3 BehindOut{};
};

struct OffsetVertex
{
  std::vector<OffsetCorner> Corners;
  /// True if all edges are straight and all faces flat.
  bool IsPolyhedral = true;
  /// Where normals turn around a point, as at the apex of a cone: the smallest product of a normal with their
  /// mean direction; else 1.
  double Apex = 1.0;
};

struct SMFILTERSMASSPROPERTIES_EXPORT OffsetGeometry
{
  std::vector<OffsetFace> Faces;
  std::vector<OffsetEdge> Edges;
  std::vector<OffsetVertex> Vertices;
  /// False if an edge is not used twice, a face is creased, or something could not be evaluated.
  bool IsKnown = true;
};

/// Measures the faces of a model, in parallel. `sides` has the factor 1 or -1 of each face's outward normal;
/// empty: all are 1. When `shouldContinue`, which is called in the calling thread, returns false nothing is
/// known.
SMFILTERSMASSPROPERTIES_EXPORT OffsetGeometry MeasureOffsets(const vtkTrimmedNURBSModel& model,
  const std::vector<signed char>& sides, const std::function<bool()>& shouldContinue = nullptr);

/// What offsets of the faces change; NaN where it is not known.
struct SMFILTERSMASSPROPERTIES_EXPORT OffsetChange
{
  /// Change of the volume by the formula above.
  double Volume = 0.0;
  /// Bound of what the formula lacks: third order in the offsets, zero for polyhedra.
  double Remainder = 0.0;
  /// No less than the volume that the second and third order of the formula sweep, without signs, and what it
  /// lacks.
  double Second = 0.0;
  /// No less than the farthest way of a point.
  double Reach = 0.0;
  /// Faces whose curvature radius is not well above their offset, and faces that are narrower than the
  /// offsets or have an edge that is shorter than it moves.
  std::vector<std::size_t> TightFaces;
  std::vector<std::size_t> NarrowFaces;
  /// Neighbours, not all flat, with different offsets at so small an angle that nothing says where they meet;
  /// if there are any the change is not known.
  std::vector<std::size_t> UnmetFaces;

  bool IsKnown() const { return std::isfinite(this->Volume + this->Remainder + this->Second + this->Reach); }
};

/// Evaluates offsets of all faces, one for each, which have all one sign. `areas` are those of the faces.
SMFILTERSMASSPROPERTIES_EXPORT OffsetChange EvaluateOffsets(
  const OffsetGeometry& geometry, const std::vector<double>& areas, const std::vector<double>& offsets);
}

#endif
