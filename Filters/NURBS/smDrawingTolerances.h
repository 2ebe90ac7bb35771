/**
 * @file smDrawingTolerances.h
 * @brief Tolerances of the drawing that a file states; they travel with the reader's output as field data
 */
#ifndef smDrawingTolerances_h
#define smDrawingTolerances_h

#include "smFiltersNURBSModule.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkDataObject;

namespace sm
{
struct DrawingTolerance
{
  /// Number of the entity.
  std::int64_t Id = -1;
  /// "surface profile", "diameter", "thickness", or the name of the entity in small letters.
  std::string Kind;
  /// Numbers of the faces that the file links to it; none with IsForAll, if it links the shape of the
  /// product.
  std::vector<std::int64_t> Faces;
  bool IsForAll = false;
  /// Range of offsets of these faces along their outward normals, in the length unit of the data; NaN with a
  /// Problem.
  double Lower = 0.0;
  double Upper = 0.0;
  /// The reason why the range is not known, or does not say where the face is; empty otherwise.
  std::string Problem;
};

/// Names of the arrays, with a value for each tolerance: the number (64-bit integer), the kind (string), the
/// faces as "#12 #13", or "all" (string), both limits (double, L), and the problem (string).
constexpr const char* DrawingToleranceIdName = "DrawingToleranceId";
constexpr const char* DrawingToleranceKindName = "DrawingToleranceKind";
constexpr const char* DrawingToleranceFacesName = "DrawingToleranceFaces";
constexpr const char* DrawingToleranceLowerName = "DrawingToleranceLower";
constexpr const char* DrawingToleranceUpperName = "DrawingToleranceUpper";
constexpr const char* DrawingToleranceProblemName = "DrawingToleranceProblem";

/// Sets the arrays; removes them if there are no tolerances.
SMFILTERSNURBS_EXPORT void SetDrawingTolerances(
  vtkDataObject* data, const std::vector<DrawingTolerance>& tolerances);
/// Returns the tolerances; none if an array is missing or too short.
SMFILTERSNURBS_EXPORT std::vector<DrawingTolerance> GetDrawingTolerances(vtkDataObject* data);
SMFILTERSNURBS_EXPORT void RemoveDrawingTolerances(vtkDataObject* data);
}

#endif
