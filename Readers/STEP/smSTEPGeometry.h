/**
 * @file smSTEPGeometry.h
 * @brief Curves and surfaces of a STEP file as native values, from their entities alone
 */
#ifndef smSTEPGeometry_h
#define smSTEPGeometry_h

#include "Geometry/smGeometricSurface.h"
#include "Geometry/smGeometryTransform.h"
#include "smReadersSTEPModule.h"
#include "smSTEPAttributes.h"
#include "smSTEPFrames.h"
#include "smSTEPLedger.h"

#include <memory>
#include <string>
#include <unordered_map>

namespace sm
{
/// Sizes of the units of a representation, in millimetres and radians.
struct STEPUnitSizes
{
  double Length = 1.0;
  double Angle = 1.0;
};

/**
 * A curve of a file. Its entity is the value over `Range`; the parameter of the entity is an affine function
 * of the value's. `Parameter.Scale` is negative for a curve that runs against its value.
 */
template <int Dimension>
struct STEPCurve
{
  CurvePointer<Dimension> Value;
  /// Natural parameters: the domain of the value, or what a TRIMMED_CURVE leaves of it.
  ParameterRange Range;
  /// Natural parameter for the parameter of the entity (ISO 10303-42), in the file's units.
  ParameterScale Parameter;
};

/// A surface of a file, likewise. Its normal, and with it that of its faces, is against the value's if
/// IsReversed().
struct STEPSurface
{
  SurfacePointer Value;
  ParameterRange Range[2];
  ParameterScale Parameters[2];

  bool IsReversed() const { return this->Parameters[0].Scale * this->Parameters[1].Scale < 0.0; }
};

/**
 * Converts geometry of a file, each entity once, when it is asked for. An entity that is not converted gets a
 * row in the ledger, together with each one that depends on it.
 *
 * Curves: LINE, CIRCLE, ELLIPSE, PARABOLA, HYPERBOLA, POLYLINE, B_SPLINE_CURVE of all kinds, TRIMMED_CURVE,
 * COMPOSITE_CURVE of all kinds, OFFSET_CURVE_3D and _2D, CURVE_REPLICA, SURFACE_CURVE of all kinds (the curve
 * in space), PCURVE. Surfaces: PLANE, CYLINDRICAL_, CONICAL_, SPHERICAL_, TOROIDAL_ and
 * DEGENERATE_TOROIDAL_SURFACE, SURFACE_OF_LINEAR_EXTRUSION, SURFACE_OF_REVOLUTION, B_SPLINE_SURFACE of all
 * kinds, RECTANGULAR_TRIMMED_SURFACE, CURVE_BOUNDED_SURFACE (its basis: the loops of a face bound it),
 * OFFSET_SURFACE, SURFACE_REPLICA.
 *
 * Lengths are in millimetres, angles in radians. Not thread safe. Throws only std::bad_alloc.
 */
class SMREADERSSTEP_EXPORT STEPGeometry
{
public:
  using Index = Part21File::Index;

  /// Keeps references to `entities` and `ledger`.
  STEPGeometry(const STEPAttributes& entities, const STEPUnitSizes& units, STEPLedger& ledger);
  ~STEPGeometry();

  /// Returns a curve in space; null if it has a row in the ledger.
  const STEPCurve<3>* GetCurve(Index entity);
  const STEPSurface* GetSurface(Index entity);
  /// Returns a curve in the parameters of a surface, in the file's units.
  const STEPCurve<2>* GetPlaneCurve(Index entity);
  /// Takes over what the other one has made and this one has not.
  void Take(STEPGeometry& other);
  /// Returns a curve in the natural parameters of a surface, converted from the file's units; null Value if
  /// that fails.
  STEPCurve<2> MapToNatural(
    const STEPCurve<2>& curve, const STEPSurface& surface, std::string& problem) const;

private:
  template <int Dimension>
  friend class STEPCurveMaker;
  friend class STEPSurfaceMaker;

  template <class Value>
  struct Entry
  {
    std::unique_ptr<Value> Result;
    bool IsOpen = true;
  };
  template <class Value, class Make>
  const Value* Find(std::unordered_map<Index, Entry<Value>>& entries, Index entity, const char* consequence,
    const Make& make);

  const STEPAttributes& Entities;
  STEPUnitSizes Units;
  STEPLedger& Ledger;
  std::unordered_map<Index, Entry<STEPCurve<3>>> Curves;
  std::unordered_map<Index, Entry<STEPCurve<2>>> PlaneCurves;
  std::unordered_map<Index, Entry<STEPSurface>> Surfaces;
  int Depth = 0;
};
}

#endif
