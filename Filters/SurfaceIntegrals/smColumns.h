/**
 * @file smColumns.h
 * @brief Functions that write field data and table columns
 */
#ifndef smColumns_h
#define smColumns_h

#include "smBodyIntegrals.h"
#include "smFiltersSurfaceIntegralsModule.h"

#include "vtkAbstractArray.h"
#include "vtkSmartPointer.h"
#include "vtkStdString.h"
#include "vtkType.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkFieldData;
class vtkTable;

namespace sm
{
namespace columns
{
/**
 * The arrays of a filter's tables. A run asks for the same arrays in the same order as the run before it, and
 * gets those again to which nothing else refers: for an edit of one face, making, naming and freeing them
 * takes longer than computing what they hold.
 */
class KeptArrays
{
public:
  /// Called before the first array of a run. Arrays that the run before did not ask for are released.
  void Restart()
  {
    this->Arrays.resize(this->Next);
    this->Next = 0;
  }
  void Clear()
  {
    this->Arrays.clear();
    this->Next = 0;
  }

  /// Returns an array with a name and a size, without values.
  template <typename Array>
  Array* Get(const std::string& name, int components, vtkIdType rows)
  {
    if (this->Next == this->Arrays.size())
    {
      this->Arrays.emplace_back();
    }
    vtkSmartPointer<vtkAbstractArray>& kept = this->Arrays[this->Next++];
    auto* array = dynamic_cast<Array*>(kept.Get());
    // What somebody added to the array of the run before does not stay.
    if (array && array->GetReferenceCount() == 1 && !array->HasInformation() && !array->HasAComponentName() &&
      name == array->GetName() && array->GetNumberOfComponents() == components &&
      array->GetNumberOfTuples() == rows)
    {
      // What VTK keeps for look-ups of values is discarded.
      array->DataChanged();
      array->Modified();
      return array;
    }
    array = Array::New();
    kept.TakeReference(array);
    array->SetName(name.c_str());
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(rows);
    return array;
  }

private:
  std::vector<vtkSmartPointer<vtkAbstractArray>> Arrays;
  std::size_t Next = 0;
};

/// Adds columns of `rows` rows, about `columns` of them, to field data or to a table's row data.
class SMFILTERSSURFACEINTEGRALS_EXPORT Writer
{
public:
  Writer(KeptArrays& arrays, vtkFieldData* data, std::size_t rows = 1, int columns = 8);

  /// Returns the values of a new column, `components` for every row, which the caller sets.
  template <typename Array>
  auto* Add(const std::string& name, int components = 1)
  {
    auto* array = this->Arrays.Get<Array>(name, components, this->Rows);
    this->AddArray(array);
    return array->GetPointer(0);
  }
  double* AddDoubles(const std::string& name, int components = 1);
  int* AddIntegers(const std::string& name);
  vtkTypeInt64* AddEntityNumbers(const std::string& name);
  vtkStdString* AddStrings(const std::string& name);

  /// Add columns of one row.
  void SetDouble(const std::string& name, double value) { *this->AddDoubles(name) = value; }
  void SetInteger(const std::string& name, vtkTypeInt64 value);
  void SetString(const std::string& name, const std::string& value);

private:
  void AddArray(vtkAbstractArray* array);

  KeptArrays& Arrays;
  vtkFieldData* Data;
  vtkIdType Rows;
};

/// Adds the columns Name, Path, Id and Status with a row for every body.
SMFILTERSSURFACEINTEGRALS_EXPORT void AddBodyLabels(
  KeptArrays& arrays, const std::vector<BodyIntegrals>& bodies, vtkTable* solids);

/// Adds the columns LengthUnit, OpenEdges, FlippedShells, BoundsEstimated and Faces with a row for every
/// body.
SMFILTERSSURFACEINTEGRALS_EXPORT void AddBodyCounts(
  KeptArrays& arrays, const std::vector<BodyIntegrals>& bodies, vtkTable* solids);

/// Adds a row with the values of `totals` that have the name of a column, and an empty Id. Values without a
/// total are NaN, empty or 0.
SMFILTERSSURFACEINTEGRALS_EXPORT void AppendTotalRow(
  vtkFieldData* totals, const std::string& name, vtkTable* solids);

/// Returns true for a row that AppendTotalRow() added to a table with the columns of AddBodyLabels().
SMFILTERSSURFACEINTEGRALS_EXPORT bool IsTotalRow(vtkTable* solids, vtkIdType row);

/// Adds a row per face and instance: Solid, Name and Id of the solid, FaceIndex, FaceId, the integrands with
/// indices `wanted` over face, ribbons and caps, their bounds, MaxGap and LengthUnit. Fluxes of a shell or
/// body that is inside out are reversed.
SMFILTERSSURFACEINTEGRALS_EXPORT void AddFaceRows(KeptArrays& arrays,
  const std::vector<BodyIntegrals>& bodies, const std::vector<Integrand>& integrands, vtkTable* faces,
  const std::vector<int>& wanted);

/// Adds a row per edge and instance, the widest gap first: Solid and its Id, EdgeIndex, EdgeId, Name, Uses,
/// Open, MaxGap, GapArea, GapSquared, ClosureSpread, LengthUnit.
SMFILTERSSURFACEINTEGRALS_EXPORT void AddEdgeRows(
  KeptArrays& arrays, const std::vector<BodyIntegrals>& bodies, vtkTable* edges);
}
}

#endif
