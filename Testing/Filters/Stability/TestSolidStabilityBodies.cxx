// TestSolidStabilityBodies FOLDER SOLIDS MODE: several bodies together and each alone, stopped runs, open
// bodies, and errors.
#include "smDecimalCommas.h"
#include "smStabilityTesting.h"
#include "smStandingSolids.h"

#include "smBoxBodies.h"
#include "smTestManifest.h"

#include "smStepFile.h"

#include <vtkCallbackCommand.h>
#include <vtkDataAssembly.h>
#include <vtkDataSetAttributes.h>
#include <vtkMassPropertiesGPU.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkTable.h>
#include <vtkTrimmedNURBSModel.h>

#include <cmath>
#include <new>

namespace
{
using namespace smtest;
namespace names = sm::names;
const double NaN = std::nan("");

void TestBodies(const Manifest& manifest)
{
  // A cube of 10 and a plate at its side, up to x = 40, that only the cube holds.
  vtkNew<vtkPartitionedDataSetCollection> assembly;
  vtkSmartPointer<vtkNURBSDataSet> leaves[2];
  const BoxShell shells[2] = { { { 0, 0, 0 }, { 10, 10, 10 } }, { { 10, 0, 8 }, { 40, 10, 10 } } };
  for (unsigned int i = 0; i < 2; ++i)
  {
    BoxBody body;
    body.Add(shells[i]);
    leaves[i] = body.Make();
    assembly->SetPartition(i, 0, leaves[i]);
  }
  vtkNew<vtkSolidStability> filter;
  filter->SetInputDataObject(assembly);
  filter->Update();
  CheckVerdict("cube and plate", filter, "unstable", "area", "margin");
  // (1000 x 5 + 600 x 25) / 1600 = 12.5
  CheckBounded(filter, names::StabilityMargin, -2.5, 1e-9);
  CheckEqual("one row", 1, vtkTable::SafeDownCast(filter->GetOutputDataObject(1))->GetNumberOfRows());
  filter->SetBodies(vtkSolidStability::EACH);
  filter->Update();
  CheckVerdict("each alone", filter, "stable", "area", "margin");
  vtkTable* rows = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  if (CheckEqual("two rows", 2, rows->GetNumberOfRows()))
  {
    Check("margin of the cube", 5.0, rows->GetValueByName(0, names::StabilityMargin).ToDouble(), 1e-9);
    Check("margin of the plate", 5.0, rows->GetValueByName(1, names::StabilityMargin).ToDouble(), 1e-9);
  }
  // Stopped when the first stands: what is not known of the second is not known of the worst.
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      auto* running = vtkAlgorithm::SafeDownCast(caller);
      running->SetAbortExecute(running->GetProgress() > 0.85 ? 1 : 0);
    });
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, stop);
  const MessageTrap stopped(filter);
  filter->Modified();
  filter->Update();
  CheckEqual("a warning that it was stopped", 1, stopped.NumberOfWarnings);
  CheckEqual("stopped", names::VerdictUnknown, filter->GetStability());
  rows = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  CheckEqual("the one that stood", "stable", rows->GetValueByName(0, names::Stability).ToString());
  CheckEqual(
    "the one that did not", names::VerdictUnknown, rows->GetValueByName(1, names::Stability).ToString());
  filter->RemoveObserver(tag);
  filter->Modified();
  filter->Update();
  CheckEqual("not stopped", "stable", filter->GetStability());
  // One density says nothing of the other.
  leaves[0]->GetModel()->SetDensity(8000.0);
  filter->SetBodies(vtkSolidStability::TOGETHER);
  filter->Update();
  CheckBounded(filter, names::StabilityMargin, -2.5, 1e-9);
  CheckTrue("a message",
    filter->GetNumberOfMessages() > 0 &&
      filter->GetMessage(filter->GetNumberOfMessages() - 1).find("by volume") != std::string::npos);
  CheckTrue("no joules", std::isnan(Get(filter, names::TipEnergy)));
  // A heavy cube holds the plate: (8e6 x 5 + 6e5 x 25) / 8.6e6.
  leaves[1]->GetModel()->SetDensity(1000.0);
  filter->Modified();
  filter->Update();
  CheckVerdict("heavy cube and plate", filter, "stable", "area", "margin");
  CheckBounded(filter, names::StabilityMargin, 10.0 - 5.5e7 / 8.6e6, 1e-9);

  // An edit of the input is seen: the second box goes, and the cube stands alone.
  assembly->SetNumberOfPartitionedDataSets(1);
  filter->Update();
  CheckBounded(filter, names::StabilityMargin, 5.0, 1e-9);

  Case open(manifest.GetSpecial("open_solid").Path);
  MessageTrap trap(open.Filter->GetMassProperties());
  open.Filter->Update();
  CheckEqual("status of an open solid", names::StatusOpen, open.Filter->GetStatus());
  CheckEqual("its field", names::StatusOpen, GetText(open.Filter, names::Status));
  CheckTrue("messages", open.Filter->GetNumberOfMessages() > 0);
  Case shell(manifest.GetSpecial("open_shell").Path);
  MessageTrap other(shell.Filter->GetMassProperties());
  shell.Filter->Update();
  CheckEqual("a surface has no centre", names::VerdictUnknown, shell.Filter->GetStability());
  CheckTrue("and no margin", std::isnan(shell.Filter->GetStabilityMargin()));
}

/// Selectors of the mass filter choose the solids that stand: a plate on a post, and the plate alone.
void TestChoice()
{
  vtkNew<vtkPartitionedDataSetCollection> parts;
  const BoxShell shells[2] = { { { 0, 0, 0 }, { 4, 4, 10 } }, { { 0, 0, 10 }, { 20, 4, 12 } } };
  vtkNew<vtkDataAssembly> assembly;
  assembly->SetRootNodeName("Product");
  for (unsigned int i = 0; i < 2; ++i)
  {
    BoxBody body;
    body.Add(shells[i]);
    parts->SetPartition(i, 0, body.Make());
    assembly->AddDataSetIndex(assembly->AddNode(i == 0 ? "Post" : "Plate"), i);
  }
  parts->SetDataAssembly(assembly);
  vtkNew<vtkSolidStability> filter;
  filter->SetInputDataObject(parts);
  filter->Update();
  // (160 x 2 + 160 x 10) / 320 = 6
  CheckVerdict("plate on a post", filter, "unstable", "area", "margin");
  CheckBounded(filter, names::StabilityMargin, -2.0, 1e-9);
  filter->GetMassProperties()->AddSelector("//Plate");
  filter->GetMassProperties()->TotalRowOn();
  for (const int bodies : { vtkSolidStability::TOGETHER, vtkSolidStability::EACH })
  {
    filter->SetBodies(bodies);
    filter->Update();
    CheckVerdict("the plate", filter, "stable", "area", "margin");
    CheckBounded(filter, names::StabilityMargin, 2.0, 1e-9);
    Check("height of its ground", 10.0, Get(filter, names::ProjectedCenterOfMass, 2), 1e-9);
    CheckEqual("its row", 1, vtkTable::SafeDownCast(filter->GetOutputDataObject(1))->GetNumberOfRows());
  }
  const MessageTrap trap(filter->GetMassProperties());
  filter->GetMassProperties()->ClearSelectors();
  filter->GetMassProperties()->AddSelector("//Wheel");
  filter->Update();
  CheckEqual("what is not there", names::VerdictUnknown, filter->GetStability());
  CheckEqual("its status", names::StatusEmpty, filter->GetStatus());
  CheckEqual("no row", 0, vtkTable::SafeDownCast(filter->GetOutputDataObject(1))->GetNumberOfRows());
  // Solids in two units have no common centre, whatever their masses are.
  filter->GetMassProperties()->ClearSelectors();
  for (unsigned int i = 0; i < 2; ++i)
  {
    auto* model = vtkNURBSDataSet::SafeDownCast(parts->GetPartition(i, 0))->GetModel();
    model->SetDensity(1000.0 + i);
    model->SetLengthUnit(i == 0 ? "mm" : "inch");
  }
  filter->SetBodies(vtkSolidStability::TOGETHER);
  filter->Update();
  CheckEqual("two units", names::VerdictUnknown, filter->GetStability());
  CheckTrue("two units, no margin", std::isnan(filter->GetStabilityMargin()));
}

/// An exception from within a run is an error of the filter with empty outputs; it does not leave Update().
void CheckOutOfMemory(const std::string& path)
{
  Case box(path);
  vtkNew<vtkCallbackCommand> fail;
  fail->SetCallback([](vtkObject*, unsigned long, void*, void*) { throw std::bad_alloc(); });
  const unsigned long tag = box.Filter->GetMassProperties()->AddObserver(vtkCommand::StartEvent, fail);
  MessageTrap trap(box.Filter);
  MessageTrap pipeline(box.Filter->GetExecutive());
  box.Filter->Update();
  CheckEqual("out of memory: errors", 1, trap.NumberOfErrors);
  CheckEqual("status", names::StatusNotComputed, box.Filter->GetStatus());
  CheckTrue("the reason",
    box.Filter->GetNumberOfMessages() > 0 &&
      box.Filter->GetMessage(box.Filter->GetNumberOfMessages() - 1).find("nothing was computed") == 0);
  CheckEqual("no verdict", names::VerdictUnknown, box.Filter->GetStability());
  CheckEqual("no row", 0, vtkTable::SafeDownCast(box.Filter->GetOutputDataObject(1))->GetNumberOfRows());
  box.Filter->GetMassProperties()->RemoveObserver(tag);
  box.Filter->Modified();
  box.Filter->Update();
  CheckEqual("with memory again", "stable", box.Filter->GetStability());
}

void TestErrors(const std::string& folder)
{
  const std::string path = WriteStanding(folder, "box_errors", MakeLeaningPrism(10, 20, 30, 0));
  CheckOutOfMemory(path);
  Case box(path);
  MessageTrap trap(box.Filter);
  box.Filter->SetGravityDirection(0, 0, 0);
  CheckEqual("no direction", 1, trap.NumberOfErrors);
  box.Filter->SetGravityDirection(0, NaN, -1);
  CheckEqual("not a number", 2, trap.NumberOfErrors);
  CheckTrue("the remedy", trap.Errors.find("0, 0, -1") != std::string::npos, trap.Errors);
  trap.Errors.clear();
  {
    const DecimalCommas commas;
    box.Filter->SetGroundNormal(0.25, NaN, 0);
  }
  CheckTrue("decimal points", trap.Errors.find("(0.25, nan, 0)") != std::string::npos, trap.Errors);
  box.Filter->SetGroundNormal(INFINITY, 0, 0);
  box.Filter->SetGroundOrigin(0, 0, NaN);
  box.Filter->SetContactTolerance(NaN);
  CheckEqual("six errors", 6, trap.NumberOfErrors);
  Check("gravity as it was", -1.0, box.Filter->GetGravityDirection()[2], 0.0);
  box.Filter->SetContactTolerance(7.0);
  Check("clamped", 0.1, box.Filter->GetContactTolerance(), 0.0);
  box.Filter->SetContactTolerance(1e-6);
  CheckEqual("before a run", names::VerdictUnknown, box.Filter->GetStability());
  box.Filter->SetGroundNormal(1, 0, 0);
  MessageTrap pipeline(box.Filter->GetExecutive());
  box.Filter->Update();
  CheckEqual("an upright ground", 7, trap.NumberOfErrors);
  CheckTrue("its remedy", trap.Errors.find("ground normal") != std::string::npos);
  box.Filter->SetGroundNormal(0, 0, 0);
  box.Filter->Update();
  CheckEqual("and level again", "stable", box.Filter->GetStability());

  vtkNew<vtkPolyData> plain;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  plain->SetPoints(points);
  box.Filter->SetInputDataObject(plain);
  box.Filter->Update();
  CheckEqual("a mesh", 8, trap.NumberOfErrors);
  CheckTrue("named", trap.Errors.find("exact geometry") != std::string::npos);
  CheckEqual("status of a mesh", names::StatusEmpty, box.Filter->GetStatus());
  CheckEqual("nothing is left of the last run", names::VerdictUnknown, box.Filter->GetStability());

  vtkNew<vtkPartitionedDataSetCollection> nothing;
  box.Filter->SetInputDataObject(nothing);
  box.Filter->Update();
  CheckEqual("no solid at all", names::VerdictUnknown, box.Filter->GetStability());
  CheckEqual("its status", names::StatusEmpty, box.Filter->GetStatus());
}
}

int TestSolidStabilityBodies(int argc, char* argv[])
{
  RequireUsage(argc == 4, "TestSolidStabilityBodies FOLDER SOLIDS MODE");
  QuietOcct();
  const std::string folder = argv[1];
  if (std::string(argv[3]) == "bodies")
  {
    TestBodies(Manifest(argv[2]));
    TestChoice();
  }
  else
  {
    TestErrors(folder);
  }
  return Finish();
}
