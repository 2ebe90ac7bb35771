/**
 * @file smSTEPParameterCurves.h
 * @brief Parameter curves of a STEP file that contradict the curves of their edges
 */
#ifndef smSTEPParameterCurves_h
#define smSTEPParameterCurves_h

#include "Trims/smFootPoint.h"
#include "smSTEPGeometry.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace sm
{
/// A parameter curve of an edge, with some points of the edge's curve between its ends: they may lie at a
/// pole.
struct STEPParameterCurve
{
  static constexpr std::array<double, 4> Fractions = { 0.13, 0.37, 0.61, 0.86 };

  /// Numbers of the EDGE_CURVE, of the PCURVE, and of the curve in space.
  std::uint64_t Edge = 0;
  std::uint64_t Id = 0;
  std::uint64_t SpaceCurve = 0;
  /// In the natural parameters of the surface.
  STEPCurve<2> Curve;
  SurfacePointer Surface;
  std::shared_ptr<const FootPointFinder> Finder;
  /// Points in millimetres, and the natural parameters of the curve at which they are expected.
  std::array<Vector3, Fractions.size()> Points{};
  std::array<double, Fractions.size()> Parameters{};
  /// True if the file prefers it to the curve in space.
  bool IsPreferred = false;
  /// The file's unit of angles in radians.
  double Angle = 1.0;

  /// Returns the largest distance of the points from those at the same parameters.
  double GetDistance() const;
};

/**
 * Reports parameter curves that lie elsewhere on their surface than the curve in space of the same edge, by
 * more than 1e-3 of the size of what the file's edges enclose. The curve in space is what the reader takes.
 * It is a defect where the file prefers the parameter curve (master_representation) and the distance exceeds
 * 1e-2 of the size, else a message. Parameter curves may be moved by whole periods, and may have radians
 * where the file has degrees, as some systems write them. Examined are curves on elementary and on spline
 * surfaces.
 */
void ReportParameterCurves(const std::vector<STEPParameterCurve>& curves, double size,
  std::vector<std::string>& messages, std::vector<std::string>& defects);
}

#endif
