#include "vtkSolidTableView.h"

#include "smMassPropertyNames.h"
#include "smStabilityNames.h"

#include "vtkAbstractArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <tuple>
#include <vector>

vtkStandardNewMacro(vtkSolidTableView);

namespace
{
namespace names = sm::names;

/// The row's number.
constexpr const char* RowNumber = "vtkOriginalIndices";

/// Before the names that a user gave to integrals: what the row is of, and what is looked for first.
constexpr const char* Leading[] = { RowNumber, names::Solid, names::FaceId, names::EdgeId, names::Name,
  names::Id, names::Status, names::Stability, names::Support, names::DecidedBy, names::SideFrom,
  names::SideTo, names::StabilityMargin, names::TipAngle, names::CenterOfMassRise, names::TipEnergy,
  names::Volume, names::Mass, names::SurfaceArea, names::CenterOfMass };

/// Behind them: units, tensors, how a body stands, and what the model itself leaves in doubt.
constexpr const char* Trailing[] = { names::LengthUnit, names::PrincipalMoments, names::RadiiOfGyration,
  names::PrincipalAxes, names::PrincipalAxesDegenerate, names::VolumeInertia, names::MassInertia,
  names::VolumeInertiaAtOrigin, names::FirstMoments, names::SecondMoments, names::CenterHeight,
  names::Clearance, names::RollingRadius, names::RollingMargin, names::ProjectedCenterOfMass,
  names::ContactFaces, names::ContactEdges, names::Uses, names::Open, names::MaxGap, names::GapArea,
  names::GapSquared, names::ClosureCorrection, names::ClosureResidual, names::Faces, names::OpenEdges,
  names::FlippedShells, names::BoundsEstimated };

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
    (has(names::Solid) && (has(names::FaceId) || has(names::EdgeId) || has(names::StabilityMargin)));
}

bool StartsWith(const std::string& text, const std::string& start)
{
  return text.compare(0, start.size(), start) == 0;
}

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Whether a column is a quantity or a component of it, <name>_<i>: 0; its bound: 1; neither: -1.
int Match(const std::string& column, const std::string& quantity)
{
  const bool value = column == quantity || StartsWith(column, quantity + "_");
  return value ? 0 : column == quantity + names::BoundSuffix ? 1 : -1;
}

/// What columns are sorted by.
std::tuple<std::size_t, int, std::string> GetPlace(const std::string& column)
{
  std::size_t place = 0;
  std::size_t unknown = 0;
  for (const auto& list : { std::vector<const char*>(std::begin(Leading), std::end(Leading)),
         std::vector<const char*>(std::begin(Trailing), std::end(Trailing)) })
  {
    for (const char* quantity : list)
    {
      const int match = Match(column, quantity);
      if (match >= 0)
      {
        return { place, match, column };
      }
      ++place;
    }
    unknown = unknown ? unknown : place++;
  }
  return { unknown, 0, column };
}
}

struct vtkSolidTableView::Order
{
  /// The columns as the superclass sorted them and as they are shown, of the last table of ours.
  std::vector<std::string> Sorted;
  std::vector<std::string> Shown;
  struct Block
  {
    vtkSmartPointer<vtkTable> Sorted;
    vtkSmartPointer<vtkTable> Shown;
  };
  std::map<vtkIdType, Block> Blocks;

  void Arrange(const std::vector<std::string>& sorted)
  {
    std::vector<std::tuple<std::size_t, int, std::string>> places;
    places.reserve(sorted.size());
    for (const std::string& column : sorted)
    {
      places.push_back(GetPlace(column));
    }
    std::sort(places.begin(), places.end());
    this->Sorted = sorted;
    this->Shown.clear();
    for (const auto& place : places)
    {
      this->Shown.push_back(std::get<2>(place));
    }
  }
};

vtkSolidTableView::vtkSolidTableView()
  : Columns(new Order)
{
}

vtkSolidTableView::~vtkSolidTableView() = default;

void vtkSolidTableView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Columns in their own order: " << this->Columns->Shown.size() << "\n";
}

vtkTable* vtkSolidTableView::FetchBlock(vtkIdType blockindex)
{
  vtkTable* sorted = this->Superclass::FetchBlock(blockindex);
  const std::vector<std::string> columns = GetNames(sorted);
  if (!sorted || !HasSolids(columns))
  {
    return sorted;
  }
  Order& order = *this->Columns;
  const auto known = order.Blocks.find(blockindex);
  if (known == order.Blocks.end() || known->second.Sorted != sorted)
  {
    const bool other = order.Sorted != columns;
    if (other)
    {
      order.Arrange(columns);
    }
    // As many as the superclass keeps.
    if (other || order.Blocks.size() >= 10)
    {
      order.Blocks.clear();
    }
    vtkNew<vtkTable> shown;
    shown->GetFieldData()->ShallowCopy(sorted->GetFieldData());
    for (const std::string& name : order.Shown)
    {
      shown->AddColumn(sorted->GetColumnByName(name.c_str()));
    }
    order.Blocks[blockindex] = { sorted, shown };
  }
  return order.Blocks[blockindex].Shown;
}

const char* vtkSolidTableView::GetColumnName(vtkIdType index)
{
  const char* sorted = this->Superclass::GetColumnName(index);
  const Order& order = *this->Columns;
  const auto place = static_cast<std::size_t>(index);
  // Else the table is none of ours, or it was exchanged and no block of the new one was asked for yet.
  const bool ours = sorted && order.Sorted.size() == static_cast<std::size_t>(this->GetNumberOfColumns()) &&
    order.Sorted[place] == sorted;
  return ours ? order.Shown[place].c_str() : sorted;
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
  // Of a quantity of ours, and not the name of somebody's integrand.
  const std::vector<std::string>& shown = this->Columns->Shown;
  const auto has = [&shown](const std::string& column)
  { return std::find(shown.begin(), shown.end(), column) != shown.end(); };
  return has(name) && has(name.substr(0, name.size() - end.size()) + "_0");
}
