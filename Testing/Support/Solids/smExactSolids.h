/**
 * @file smExactSolids.h
 * @brief The catalogue of exact solids: an OCCT shape and its closed-form moments, side by side
 */
#ifndef smExactSolids_h
#define smExactSolids_h

#include "smExactMoments.h"

#include <TopoDS_Shape.hxx>

#include <functional>
#include <string>
#include <vector>

namespace smtest
{
struct ExactSolid
{
  std::string Name;
  TopoDS_Shape Shape;
  ExactMoments Moments;
  /// Diagonal of its bounding box.
  double Size = 0;
  /// True when BRepBuilderAPI_NurbsConvert gives the same solid and changes a surface.
  bool ConvertsExactly = false;
  /// False where both of OCCT's quadrature rules are off by percents.
  bool Comparable = true;
  /// False where they are so for the volume but not for the area.
  bool VolumeComparable = true;
};

/// Makes a solid, with the size that the shape's bounding box has.
ExactSolid MakeExactSolid(const TopoDS_Shape& shape, const ExactMoments& moments, bool convertsExactly);

struct NamedSolid
{
  std::string Name;
  std::function<ExactSolid()> Make;
};

/// Elementary, bored, extruded and revolved solids, in the order of the tests.
const std::vector<NamedSolid>& GetExactSolids();

/// One way to write a solid to a file.
struct Variant
{
  std::string Name;
  Placement Move;
  bool WithPcurves = true;
  bool AsNurbs = false;
  /// Normals point inwards: the reader or the filter turns it.
  bool Reversed = false;
  /// Numbers with 17 digits; else as OCCT writes them by default.
  bool AllDigits = true;
  const char* Unit = "MM";
};

/// plain, nopcurves, moved, `turned`, digits12 (OCCT's own number format), scaled, large, tiny (1e-3 mm),
/// huge (1e5 mm), mirrored, reversed, far (1e5 mm), distant (1e5 sizes), inch, and nurbs where it is exact.
std::vector<Variant> GetVariants(const ExactSolid& solid);

/// The shape moved, scaled or mirrored, with its geometry changed (no location).
TopoDS_Shape MovedShape(const TopoDS_Shape& shape, const Placement& placement);
}

#endif
