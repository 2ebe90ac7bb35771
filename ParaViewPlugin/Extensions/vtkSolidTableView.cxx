#include "vtkSolidTableView.h"

#include "smColumnUnits.h"
#include "smMassPropertyNames.h"
#if VTK_MODULE_ENABLE_SolidMoments_FiltersBuoyancy
#include "smBuoyancyNames.h"
#endif
#if VTK_MODULE_ENABLE_SolidMoments_FiltersSection
#include "smSectionNames.h"
#endif
#if VTK_MODULE_ENABLE_SolidMoments_FiltersStability
#include "smStabilityNames.h"
#endif

#include "vtkAbstractArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNURBSDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <iterator>
#include <string>
#include <tuple>
#include <vector>

vtkStandardNewMacro(vtkSolidTableView);

namespace
{
namespace names = sm::names;

/// The name that the view gives to the row's number.
constexpr const char* RowNumber = "vtkOriginalIndices";

/// Columns before the integrals that the user named: identity and status of the row, then the main results.
const char* const Leading[] = { RowNumber, names::Solid, vtkNURBSDataSet::FaceIndexArrayName(), names::FaceId,
  names::EdgeIndex, names::EdgeId, names::Name, names::Path, names::Id, names::Status, names::Kind,
  names::Count, names::CountInAll,
#if VTK_MODULE_ENABLE_SolidMoments_FiltersStability
  names::Stability, names::Support, names::DecidedBy, names::SideFrom, names::SideTo, names::StabilityMargin,
  names::TipAngle, names::CenterOfMassRise, names::TipEnergy,
#endif
#if VTK_MODULE_ENABLE_SolidMoments_FiltersBuoyancy
  names::DisplacedVolume, names::CenterOfBuoyancy, names::DisplacedFirstMoments,
#endif
#if VTK_MODULE_ENABLE_SolidMoments_FiltersSection
  names::SectionArea, names::SectionCentroid, names::SectionPrincipalMoments, names::VolumeBelow,
  names::CenterBelow, names::MassBelow, names::VolumeAbove, names::CenterAbove, names::MassAbove,
#endif
  names::Volume, names::Mass, names::MassInAll, names::Density, names::Material, names::SurfaceArea,
  names::CenterOfMass };

/// Columns after them: units, tensors, details of the support, and defects of the model.
constexpr const char* Trailing[] = { names::LengthUnit, names::PrincipalMoments, names::RadiiOfGyration,
  names::PrincipalAxes, names::PrincipalAxesDegenerate, names::VolumeInertia, names::MassInertia,
  names::VolumeInertiaAtOrigin, names::FirstMoments, names::SecondMoments,
#if VTK_MODULE_ENABLE_SolidMoments_FiltersSection
  names::SectionSecondMoments, names::SectionPrincipalDirections,
#endif
#if VTK_MODULE_ENABLE_SolidMoments_FiltersStability
  names::CenterHeight, names::Clearance, names::RollingRadius, names::RollingMargin,
  names::ProjectedCenterOfMass, names::ContactFaces, names::ContactEdges,
#endif
  names::Uses, names::Open, names::MaxGap, names::GapArea, names::GapSquared, names::ClosureSpread,
  names::ClosureCorrection, names::ClosureResidual, names::Faces, names::OpenEdges, names::FlippedShells,
  names::BoundsEstimated, names::BoundsMeasured };

/// In addition to Solid, a column that marks a table with several rows per solid.
constexpr const char* PartsOfSolids[] = {
  names::FaceId,
  names::EdgeId,
#if VTK_MODULE_ENABLE_SolidMoments_FiltersStability
  names::StabilityMargin,
#endif
};

std::vector<std::string> GetNames(vtkTable* table)
{
  std::vector<std::string> result;
  for (vtkIdType i = 0; table && i < table->GetNumberOfColumns(); ++i)
  {
    const char* name = table->GetColumn(i)->GetName();
    result.emplace_back(name ? name : "");
  }
  return result;
}

bool HasSolids(const std::vector<std::string>& columns)
{
  const auto has = [&columns](const char* name)
  { return std::find(columns.begin(), columns.end(), name) != columns.end(); };
  return (has(names::Name) && has(names::Id) && has(names::Status)) ||
    (has(names::Name) && has(names::Level) && has(names::CountInAll)) ||
    (has(names::Solid) && std::any_of(std::begin(PartsOfSolids), std::end(PartsOfSolids), has));
}

bool StartsWith(const std::string& text, const std::string& start)
{
  return text.compare(0, start.size(), start) == 0;
}

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Returns 0 if the column is the quantity or a component of it, <name>_<i>; 1 if it is its bound; -1
/// otherwise.
int Match(const std::string& column, const std::string& quantity)
{
  const bool value = column == quantity || StartsWith(column, quantity + "_");
  return value ? 0 : column == quantity + names::BoundSuffix ? 1 : -1;
}

/// Returns a column of numbers as texts that read back as the same doubles, because ParaView shows and
/// exports six digits of a number; returns other columns unchanged.
vtkSmartPointer<vtkAbstractArray> FormatColumn(vtkAbstractArray* column)
{
  auto* numbers = vtkDoubleArray::SafeDownCast(column);
  if (!numbers || numbers->GetNumberOfComponents() != 1)
  {
    return column;
  }
  vtkNew<vtkStringArray> texts;
  texts->SetName(numbers->GetName());
  for (vtkIdType row = 0; row < numbers->GetNumberOfTuples(); ++row)
  {
    char text[32];
    texts->InsertNextValue(
      std::string(text, std::to_chars(text, text + sizeof(text), numbers->GetValue(row)).ptr));
  }
  return texts;
}

/// Returns the key by which columns are sorted.
std::tuple<std::size_t, int, std::string> GetSortKey(const std::string& column)
{
  std::size_t position = 0;
  std::size_t unknown = 0;
  for (const auto& list : { std::vector<const char*>(std::begin(Leading), std::end(Leading)),
         std::vector<const char*>(std::begin(Trailing), std::end(Trailing)) })
  {
    for (const char* quantity : list)
    {
      const int match = Match(column, quantity);
      if (match >= 0)
      {
        return { position, match, column };
      }
      ++position;
    }
    unknown = unknown ? unknown : position++;
  }
  return { unknown, 0, column };
}
}

vtkSolidTableView::vtkSolidTableView() = default;
vtkSolidTableView::~vtkSolidTableView() = default;

void vtkSolidTableView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Columns in their own order: " << this->ShownColumns.size() << "\n";
}

void vtkSolidTableView::Arrange(const std::vector<std::string>& sorted)
{
  std::vector<std::tuple<std::size_t, int, std::string>> keys;
  keys.reserve(sorted.size());
  for (const std::string& column : sorted)
  {
    keys.push_back(GetSortKey(column));
  }
  std::sort(keys.begin(), keys.end());
  this->SortedColumns = sorted;
  this->ShownColumns.clear();
  for (const auto& key : keys)
  {
    this->ShownColumns.push_back(std::get<2>(key));
  }
}

vtkIdType vtkSolidTableView::GetNumberOfColumns()
{
  const vtkIdType count = this->Superclass::GetNumberOfColumns();
  bool isKnown = !this->IsFetching || count == static_cast<vtkIdType>(this->KnownColumns.size());
  for (vtkIdType i = 0; this->IsFetching && isKnown && i < count; ++i)
  {
    const char* name = this->Superclass::GetColumnName(i);
    isKnown = name && this->KnownColumns[static_cast<std::size_t>(i)] == name;
  }
  return isKnown ? count : 0;
}

vtkTable* vtkSolidTableView::FetchBlock(vtkIdType blockindex)
{
  const bool wasFetching = this->IsFetching;
  this->IsFetching = true;
  vtkTable* sorted = this->Superclass::FetchBlock(blockindex);
  this->IsFetching = wasFetching;
  const std::vector<std::string> columns = GetNames(sorted);
  this->KnownColumns = columns;
  if (!sorted || !HasSolids(columns))
  {
    return sorted;
  }
  const auto known = this->Blocks.find(blockindex);
  if (known != this->Blocks.end() && known->second.Sorted == sorted)
  {
    return known->second.Shown;
  }
  const bool other = this->SortedColumns != columns;
  if (other)
  {
    this->Arrange(columns);
  }
  // The superclass also keeps 10 blocks.
  if (other || this->Blocks.size() >= 10)
  {
    this->Blocks.clear();
  }
  vtkNew<vtkTable> shown;
  shown->GetFieldData()->ShallowCopy(sorted->GetFieldData());
  for (const std::string& name : this->ShownColumns)
  {
    shown->AddColumn(FormatColumn(sorted->GetColumnByName(name.c_str())));
  }
  this->Blocks[blockindex] = { sorted, shown };
  return this->Blocks[blockindex].Shown;
}

const char* vtkSolidTableView::GetColumnName(vtkIdType index)
{
  const char* sorted = this->Superclass::GetColumnName(index);
  const auto column = static_cast<std::size_t>(index);
  // False for a table that is not of this project, and for a new table until one of its blocks is fetched.
  const bool arranged = sorted &&
    this->SortedColumns.size() == static_cast<std::size_t>(this->GetNumberOfColumns()) &&
    this->SortedColumns[column] == sorted;
  return arranged ? this->ShownColumns[column].c_str() : sorted;
}

std::string vtkSolidTableView::GetColumnLabel(const char* columnName)
{
  const std::string label = this->Superclass::GetColumnLabel(columnName);
  const bool isShown = columnName &&
    this->ShownColumns.size() == static_cast<std::size_t>(this->GetNumberOfColumns()) &&
    std::find(this->ShownColumns.begin(), this->ShownColumns.end(), columnName) != this->ShownColumns.end();
  if (!isShown)
  {
    return label;
  }
  const auto* units = this->Blocks.empty()
    ? nullptr
    : vtkStringArray::SafeDownCast(this->Blocks.begin()->second.Shown->GetColumnByName(names::LengthUnit));
  // The header has no unit if the rows have different ones.
  bool isCommon = units && units->GetNumberOfValues() > 0;
  for (vtkIdType row = 1; isCommon && row < units->GetNumberOfValues(); ++row)
  {
    isCommon = units->GetValue(row) == units->GetValue(0);
  }
  const std::string unit = isCommon ? sm::GetColumnUnit(columnName, units->GetValue(0)) : std::string();
  return unit.empty() ? label : label + " (" + unit + ")";
}

bool vtkSolidTableView::IsColumnInternal(vtkIdType index)
{
  return this->IsColumnInternal(this->GetColumnName(index));
}

bool vtkSolidTableView::IsColumnInternal(const char* columnName)
{
  if (this->Superclass::IsColumnInternal(columnName))
  {
    return true;
  }
  const std::string name = columnName;
  const std::string end = "_Magnitude";
  if (!EndsWith(name, end))
  {
    return false;
  }
  // Excludes magnitudes that the view added, but no integrand of such a name.
  const std::vector<std::string>& shown = this->ShownColumns;
  const auto has = [&shown](const std::string& column)
  { return std::find(shown.begin(), shown.end(), column) != shown.end(); };
  return has(name) && has(name.substr(0, name.size() - end.size()) + "_0");
}
