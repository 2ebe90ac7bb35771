// Bodies that no reader makes, but a program may: several length units in one input, placements that are not finite or project, and bodies
// without faces. No filter may give them a total that has no meaning, or the status ok.
#include "smBoxBodies.h"
#include "smMessageTrap.h"
#include "smTesting.h"

#include <vtkBuoyancy.h>
#include <vtkMassPropertiesGPU.h>
#include <vtkMatrix4x4.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSolidSection.h>
#include <vtkSurfaceIntegralGPU.h>
#include <vtkTable.h>

#include <functional>
#include <limits>
#include <string>

namespace
{
using namespace smtest;

/// The filters over one input, each with the total that is checked.
struct Filters
{
  vtkNew<vtkMassPropertiesGPU> Mass;
  vtkNew<vtkSurfaceIntegralGPU> Integral;
  vtkNew<vtkBuoyancy> Buoyancy;
  vtkNew<vtkSolidSection> Section;

  explicit Filters(vtkDataObject* input)
  {
    this->Integral->AddVolumeMoment("volume", 0, 0, 0);
    this->Buoyancy->SetPoint(0, 0, 1);
    this->Section->SetPoint(0, 0, 1);
    this->Visit(
      [input](const std::string&, vtkSurfaceIntegralBase* filter, double)
      {
        const MessageTrap trap(filter);
        filter->SetBackend(vtkSurfaceIntegralBase::CPU);
        filter->SetInputDataObject(input);
        filter->Update();
      });
  }

  /// Calls visit(name, filter, total) for each.
  void Visit(const std::function<void(const std::string&, vtkSurfaceIntegralBase*, double)>& visit)
  {
    visit("mass", this->Mass, this->Mass->GetVolume());
    visit("integral", this->Integral, this->Integral->GetIntegral("volume"));
    visit("buoyancy", this->Buoyancy, this->Buoyancy->GetDisplacedVolume());
    visit("section", this->Section, this->Section->GetSectionArea());
  }
};

vtkSmartPointer<vtkNURBSDataSet> MakeBox(double x)
{
  BoxBody body;
  body.Add({ { x, 0, 0 }, { x + 1, 2, 3 } });
  return body.Make();
}

bool HasMessage(vtkSurfaceIntegralBase* filter, const std::string& part)
{
  for (int i = 0; i < filter->GetNumberOfMessages(); ++i)
  {
    if (filter->GetMessage(i).find(part) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

/// One part in mm and one in inches: each has its row, and there is no sum.
void CheckUnits()
{
  vtkNew<vtkPartitionedDataSetCollection> parts;
  const auto inches = MakeBox(5.0);
  inches->GetModel()->SetLengthUnit("inch");
  parts->SetPartition(0, 0, MakeBox(0.0));
  parts->SetPartition(1, 0, inches);
  Filters filters(parts);
  filters.Visit(
    [](const std::string& name, vtkSurfaceIntegralBase* filter, double total)
    {
      CheckTrue("two units, " + name + ": no total", std::isnan(total));
      CheckTrue("two units, " + name + ": said", HasMessage(filter, "different length units"));
      CheckEqual("two units, " + name + ": rows", 2,
        vtkTable::SafeDownCast(filter->GetOutputDataObject(1))->GetNumberOfRows());
    });
  // The same in one unit.
  inches->GetModel()->SetLengthUnit("mm");
  Filters equal(parts);
  Check("one unit, mass", 12.0, equal.Mass->GetVolume(), equal.Mass->GetVolumeBound());
  Check("one unit, integral", 12.0, equal.Integral->GetIntegral("volume"),
    equal.Integral->GetIntegralBound("volume"));
  Check("one unit, buoyancy", 4.0, equal.Buoyancy->GetDisplacedVolume(),
    equal.Buoyancy->GetDisplacedVolumeBound());
  Check("one unit, section", 4.0, equal.Section->GetSectionArea(), equal.Section->GetSectionAreaBound());
}

/// `status`: of mass properties, which are integrated in the part's own coordinates; `elsewhere`: of the other filters.
void CheckPlacement(const std::string& what, int row, int column, double value, const std::string& status,
  const std::string& elsewhere)
{
  const auto box = MakeBox(0.0);
  vtkNew<vtkMatrix4x4> placement;
  placement->SetElement(row, column, value);
  box->SetPlacement(placement);
  Filters filters(box);
  filters.Visit([&](const std::string& name, vtkSurfaceIntegralBase* filter, double)
    { CheckEqual(what + ", " + name, name == "mass" ? status : elsewhere, filter->GetStatus()); });
}

/// A length unit that has no metres leaves a solid without a mass, which is said.
void CheckUnknownUnit()
{
  const auto box = MakeBox(0.0);
  box->GetModel()->SetLengthUnit("parsec");
  Filters without(box);
  CheckTrue("no density, nothing said", !HasMessage(without.Mass, "parsec"));
  box->GetModel()->SetDensity(1000.0);
  Filters filters(box);
  Check("unknown unit, volume", 6.0, filters.Mass->GetVolume(), filters.Mass->GetVolumeBound());
  CheckTrue("unknown unit, no mass", std::isnan(filters.Mass->GetMass()));
  CheckTrue("unknown unit, said", HasMessage(filters.Mass, "\"parsec\""));
}

/// A solid without faces, alone and beside a box: what is not there has no section.
void CheckEmptyBody()
{
  vtkNew<vtkPartitionedDataSetCollection> parts;
  const auto empty = vtkSmartPointer<vtkNURBSDataSet>::New();
  vtkNew<vtkTrimmedNURBSModel> none;
  empty->SetModel(none);
  parts->SetPartition(0, 0, empty);
  for (const std::string what : { "no faces", "no faces, and a box" })
  {
    Filters filters(parts);
    filters.Visit([&](const std::string& name, vtkSurfaceIntegralBase* filter, double)
      { CheckTrue(what + ", " + name + ": flagged", filter->GetStatus() != "ok", filter->GetStatus()); });
    CheckTrue(what + ": no section", std::isnan(filters.Section->GetSectionArea()));
    CheckEqual(what + ", section", "suspect", filters.Section->GetStatus());
    parts->SetPartition(1, 0, MakeBox(0.0));
  }
}
}

int TestUnusualBodies(int, char*[])
{
  CheckUnits();
  const double infinity = std::numeric_limits<double>::infinity();
  CheckPlacement("the identity", 0, 0, 1.0, "ok", "ok");
  for (int row = 0; row < 3; ++row)
  {
    CheckPlacement("infinitely far", row, 3, infinity, "suspect", "not-computed");
    CheckPlacement("nowhere", row, 3, std::nan(""), "suspect", "not-computed");
  }
  CheckPlacement("scaled by the last entry", 3, 3, 2.0, "suspect", "suspect");
  CheckPlacement("a projection", 3, 0, 0.1, "suspect", "suspect");
  CheckPlacement("stretched", 0, 0, 1.5, "suspect", "suspect");
  // The centre is known to 1e285: its distance from the origin must not hide that.
  const auto far = MakeBox(0.0);
  vtkNew<vtkMatrix4x4> placement;
  placement->SetElement(0, 3, 1e300);
  far->SetPlacement(placement);
  CheckEqual("1e300 away", "tolerance-not-met", Filters(far).Mass->GetStatus());
  CheckUnknownUnit();
  CheckEmptyBody();
  return Finish();
}
