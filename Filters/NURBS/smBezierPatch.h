/**
 * @file smBezierPatch.h
 * @brief One rational Bezier patch of a surface: its extraction, and its value at a point
 */
#ifndef smBezierPatch_h
#define smBezierPatch_h

#include "smFiltersNURBSModule.h"

#include "smNURBSSurface.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sm
{
struct Patch
{
  /// Control points are relative to this point (in model coordinates).
  double Center[3];
  /// Largest distance of a control point from Center.
  double Radius;
  /// Local parameters: s = (u - Start[0]) / Width[0], r = (v - Start[1]) / Width[1].
  double Start[2];
  double Width[2];
  /// Index of the first of (Degree[0]+1) x (Degree[1]+1) points in FacePanels::Points, s fastest.
  std::uint32_t FirstPoint;
  int Degree[2];
  /// No less than |dS/ds| and |dS/dr| anywhere: the largest step of the control net, see StretchOf() in the
  /// source.
  double Stretch[2];
  /// Bounds, in x, y and z, of the distance by which extraction and centring may have moved a control point,
  /// lengths; and no less than the components of |Ss x Sr| anywhere.
  double Displacement[3];
  double Normal[3];
  /// Largest ratio of the weights of neighbours.
  double WeightRatio;
  /// (s, r) run along (v, u) of the face: its u and v are exchanged here.
  bool Exchanged = false;
};

/// Largest |x|, |y| and |z| of points, not homogeneous.
SMFILTERSNURBS_EXPORT std::array<double, 3> GetReach(const std::array<double, 4>* points, int count);

/// Sets Radius, Stretch, Normal and WeightRatio of a patch from its control points, (Degree[0]+1) x
/// (Degree[1]+1) of them relative to its centre. Weights are positive.
SMFILTERSNURBS_EXPORT void MeasurePatch(const std::array<double, 4>* points, Patch& patch);

/// The patch on [u0,u1] x [v0,v1], which lies in one span of each direction, Exchanged aside; appends its
/// control points.
SMFILTERSNURBS_EXPORT Patch MakePatch(const NURBSSurface& surface, double u0, double u1, double v0, double v1,
  std::vector<std::array<double, 4>>& points);

/// Position relative to the patch's centre, and derivatives in s and r: formulas and rounding of
/// Rendering/NURBS/glsl/smPatch.glsl. `points` are the patch's own.
SMFILTERSNURBS_EXPORT void EvaluatePatch(const Patch& patch, const std::array<double, 4>* points, double s,
  double r, double position[3], double ds[3], double dr[3]);
}

#endif
