/**
 * @file smQuantities.h
 * @brief The outputs of vtkMassPropertiesGPU as JSON
 *
 * `data` is the field data of port 0 (row 0) or the columns of a table. A value that is missing or not finite is null.
 */
#ifndef smQuantities_h
#define smQuantities_h

#include "smJson.h"

#include "vtkType.h"

#include <string>

class vtkFieldData;

namespace sm
{
Json GetNumber(vtkFieldData* data, vtkIdType row, const std::string& name);
/// Returns three numbers; null unless all are finite.
Json GetPoint(vtkFieldData* data, vtkIdType row, const std::string& name);
/// Returns a whole number.
Json GetCount(vtkFieldData* data, vtkIdType row, const std::string& name);
/// Returns a text; empty if the array is missing.
std::string GetText(vtkFieldData* data, vtkIdType row, const char* name);

/// Returns the quantities of all solids together (field data of port 0) or of one solid (a row of port 1): volume, area, center_of_mass,
/// inertia, principal_moments, principal_axes, principal_axes_degenerate, mass; bounds of volume, area, center_of_mass, inertia and
/// mass; closure_correction, gap_squared, max_gap, gap_area, open_edges, closure_residual and flipped_shells; the error estimates of the
/// paper's schemes; stability, null here; bounds_estimated; density, material, mass_center, mass_inertia, mass_principal_moments,
/// mass_principal_axes, mass_radii_of_gyration, radii_of_gyration, inertia_at_origin and about, with bounds.
Json GetQuantities(vtkFieldData* data, vtkIdType row);

/// Sets the keys "file" and "file_bytes" of `entry`. "file" is the name; Dump() replaces its bytes that are not UTF-8. When there are such
/// bytes, "file_bytes" is the percent-encoded name, which gives them back; otherwise it is null.
void SetFileName(Json& entry, const std::string& name);
}

#endif
