/**
 * @file smColumns.h
 * @brief Functions that write field data and table columns
 */
#ifndef smColumns_h
#define smColumns_h

#include "smBodyIntegrals.h"
#include "smFiltersSurfaceIntegralsModule.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkFieldData;
class vtkTable;

namespace sm
{
namespace columns
{
/// A column of doubles that grows row by row.
class SMFILTERSSURFACEINTEGRALS_EXPORT Column
{
public:
  Column(const std::string& name, int components);
  void Append(const double* values) { this->Array->InsertNextTuple(values); }
  void AddTo(vtkFieldData* data) const;

private:
  vtkNew<vtkDoubleArray> Array;
};

/// Add arrays of one row.
SMFILTERSSURFACEINTEGRALS_EXPORT void SetDoubles(
  vtkFieldData* data, const std::string& name, const double* values, int components);
SMFILTERSSURFACEINTEGRALS_EXPORT void SetInteger(
  vtkFieldData* data, const std::string& name, vtkTypeInt64 value);
SMFILTERSSURFACEINTEGRALS_EXPORT void SetString(
  vtkFieldData* data, const std::string& name, const std::string& value);

/// Adds the columns Name, Id, Status, LengthUnit, OpenEdges, FlippedShells and Faces with a row for every body.
SMFILTERSSURFACEINTEGRALS_EXPORT void AddBodyColumns(
  const std::vector<BodyIntegrals>& bodies, vtkTable* solids);

/// Adds a row with the values of `totals` that have the name of a column, and an empty Id. Values without a total are NaN, empty or 0.
SMFILTERSSURFACEINTEGRALS_EXPORT void AppendTotalRow(
  vtkFieldData* totals, const std::string& name, vtkTable* solids);

/// True for a row that AppendTotalRow() added to a table with the columns of AddBodyColumns().
SMFILTERSSURFACEINTEGRALS_EXPORT bool IsTotalRow(vtkTable* solids, vtkIdType row);

/// Adds a row per face and instance: Solid, FaceIndex, FaceId, the integrands with indices `wanted` over face, ribbons and caps, their
/// bounds, and MaxGap. Fluxes of a shell or body that is inside out are reversed.
SMFILTERSSURFACEINTEGRALS_EXPORT void AddFaceRows(const std::vector<BodyIntegrals>& bodies,
  const std::vector<Integrand>& integrands, vtkTable* faces, const std::vector<int>& wanted);

/// Adds a row per edge and instance, the widest gap first: Solid, EdgeIndex, EdgeId, Name, Uses, Open, MaxGap,
/// GapArea, GapSquared.
SMFILTERSSURFACEINTEGRALS_EXPORT void AddEdgeRows(const std::vector<BodyIntegrals>& bodies, vtkTable* edges);
}
}

#endif
