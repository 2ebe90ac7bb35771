// TestMassPropertiesRuns FOLDER: what a filter says after runs that end early, go wrong, or follow an edit:
// never the numbers of the run before, never `ok` for what is not.
#include "smTestPipeline.h"

#include <smRunReport.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNURBSDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSTEPWriter.h>
#include <vtkSphereSource.h>
#include <vtkSurfaceIntegralGPU.h>
#include <vtkTable.h>
#include <vtkTrimmedNURBSModel.h>
#include <vtkVariant.h>

#include <type_traits>

namespace
{
using namespace smtest;
namespace names = sm::names;

/// True if a filter has the setters of integrands, which the general filter has and mass properties have not.
template <class Filter, class = void>
struct TakesIntegrands : std::false_type
{
};
template <class Filter>
struct TakesIntegrands<Filter, std::void_t<decltype(&Filter::AddIntegrand)>> : std::true_type
{
};
template <class Filter, class = void>
struct TakesMomentDegree : std::false_type
{
};
template <class Filter>
struct TakesMomentDegree<Filter, std::void_t<decltype(&Filter::SetMomentDegree)>> : std::true_type
{
};
template <class Filter, class = void>
struct RemovesIntegrands : std::false_type
{
};
template <class Filter>
struct RemovesIntegrands<Filter, std::void_t<decltype(&Filter::RemoveAllIntegrands)>> : std::true_type
{
};
template <class Filter, class = void>
struct TakesFaceIds : std::false_type
{
};
template <class Filter>
struct TakesFaceIds<Filter, std::void_t<decltype(&Filter::AddFaceId)>> : std::true_type
{
};
static_assert(TakesFaceIds<vtkSurfaceIntegralGPU>::value && !TakesFaceIds<vtkMassPropertiesGPU>::value);
static_assert(TakesIntegrands<vtkSurfaceIntegralGPU>::value && !TakesIntegrands<vtkMassPropertiesGPU>::value);
static_assert(
  TakesMomentDegree<vtkSurfaceIntegralGPU>::value && !TakesMomentDegree<vtkMassPropertiesGPU>::value);
static_assert(
  RemovesIntegrands<vtkSurfaceIntegralGPU>::value && !RemovesIntegrands<vtkMassPropertiesGPU>::value);

vtkNURBSDataSet* GetLeaf(vtkSTEPReader* reader)
{
  reader->Update();
  auto* output = vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(0));
  return output ? vtkNURBSDataSet::SafeDownCast(output->GetPartition(0, 0)) : nullptr;
}

void CheckStaleValues(const std::string& box)
{
  std::printf("--- nothing of the run before\n");
  vtkNew<vtkMassPropertiesGPU> mass;
  CheckTrue("before any run",
    std::isnan(mass->GetVolume()) && std::isnan(mass->GetSurfaceArea()) && std::isnan(mass->GetMass()) &&
      mass->GetBackendName() == "none");
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(box.c_str());
  mass->SetInputConnection(reader->GetOutputPort());
  mass->SetDensity(1000.0);
  mass->Update();
  Check("volume", 6000.0, mass->GetVolume(), 6e-6, "1e-9 relative");
  Check("mass of 6 cm^3 of water", 0.006, mass->GetMass(), 6e-12, "1e-9 relative");

  MessageTrap trap(mass);
  MessageTrap executive(mass->GetExecutive());
  mass->SetDensity(std::numeric_limits<double>::infinity());
  mass->SetRelativeTolerance(std::numeric_limits<double>::quiet_NaN());
  CheckEqual("nonsense is refused", 2, trap.NumberOfErrors);
  CheckTrue("and changes nothing", mass->GetDensity() == 1000.0 && mass->GetRelativeTolerance() == 1e-9);

  vtkNew<vtkSphereSource> mesh;
  mass->SetInputConnection(mesh->GetOutputPort());
  mass->Update();
  CheckEqual("a mesh is an error", 3, trap.NumberOfErrors);
  CheckTrue("the old volume is gone", std::isnan(mass->GetVolume()) && std::isnan(mass->GetMass()));
}

void CheckBudgetAndAbort(const std::string& ring, const std::string& output)
{
  std::printf("--- budget and abort\n");
  Pipeline exact(ring);
  exact.Mass->Update();
  CheckEqual("status", names::StatusOk, exact.Mass->GetStatus());

  Pipeline pipeline(ring);
  MessageTrap trap(pipeline.Mass);
  pipeline.Mass->SetMaximumEvaluations(1);
  pipeline.Mass->Update();
  CheckEqual("a spent budget", names::StatusToleranceNotMet, pipeline.Mass->GetStatus());
  const double error = std::fabs(pipeline.Mass->GetVolume() - exact.Mass->GetVolume());
  CheckRange("its error over its bound", 0.0, error / pipeline.Mass->GetVolumeBound(), 1.0);
  CheckTrue("spends less", pipeline.Mass->GetEvaluations() < exact.Mass->GetEvaluations());

  vtkNew<vtkCallbackCommand> stop;
  // Also in the executive's report after the run.
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  pipeline.Mass->SetMaximumEvaluations(1000000000);
  const unsigned long tag = pipeline.Mass->AddObserver(vtkCommand::ProgressEvent, stop);
  pipeline.Mass->Update();
  CheckTrue("an aborted run has no volume", std::isnan(pipeline.Mass->GetVolume()));
  pipeline.Mass->RemoveObserver(tag);
  pipeline.Mass->Modified();
  pipeline.Mass->Update();
  Check("the next run has the same bits", exact.Mass->GetVolume(), pipeline.Mass->GetVolume(), 0.0);

  const unsigned long readerTag = pipeline.Reader->AddObserver(vtkCommand::ProgressEvent, stop);
  pipeline.Reader->Modified();
  pipeline.Reader->Update();
  CheckEqual("a reader that is stopped", "aborted", pipeline.Reader->GetStatusAsString());
  pipeline.Mass->Update();
  CheckTrue("the filter says so",
    std::isnan(pipeline.Mass->GetVolume()) && Says(pipeline.Mass, "was stopped"), GetMessages(pipeline.Mass));
  pipeline.Reader->RemoveObserver(readerTag);
  pipeline.Reader->Modified();
  pipeline.Reader->Update();
  CheckEqual("reads the next time", "ok", pipeline.Reader->GetStatusAsString());

  vtkNew<vtkSTEPWriter> writer;
  MessageTrap writerTrap(writer);
  writer->SetInputConnection(pipeline.Reader->GetOutputPort());
  writer->SetFileName((output + "/aborted.step").c_str());
  const unsigned long writerTag = writer->AddObserver(vtkCommand::ProgressEvent, stop);
  CheckEqual("a writer that is stopped", 0, writer->Write());
  writer->RemoveObserver(writerTag);
  CheckEqual("writes the next time", 1, writer->Write());
}

void CheckEdit(const std::string& box)
{
  std::printf("--- edit\n");
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(box.c_str());
  vtkNURBSDataSet* read = GetLeaf(reader);
  vtkNew<vtkTrimmedNURBSModel> model;
  model->ShallowCopy(read->GetModel());
  vtkNew<vtkNURBSDataSet> leaf;
  leaf->ShallowCopy(read);
  leaf->SetModel(model);
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetInputData(leaf);
  mass->Update();
  const double before = mass->GetVolume();
  Check("volume", 6000.0, before, 6e-6, "1e-9 relative");

  // One face moved outwards by 1: the chain opens, and the run must see it.
  const sm::FacePointer old = model->GetFaces()[0];
  auto moved = std::make_shared<sm::Face>(*old);
  double position[3];
  double du[3];
  double dv[3];
  const sm::NURBSSurface& surface = old->Surface;
  surface.Evaluate(surface.GetDomainStart(0), surface.GetDomainStart(1), position, du, dv);
  double normal[3] = { du[1] * dv[2] - du[2] * dv[1], du[2] * dv[0] - du[0] * dv[2],
    du[0] * dv[1] - du[1] * dv[0] };
  const double length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  for (auto& point : moved->Surface.ControlPoints)
  {
    for (int d = 0; d < 3; ++d)
    {
      point[d] += (old->Reversed ? -1.0 : 1.0) * normal[d] / length * point[3];
    }
  }
  MessageTrap trap(mass);
  model->SetFace(0, moved);
  mass->Update();
  CheckTrue("an id used twice is refused",
    std::isnan(mass->GetVolume()) && mass->GetNumberOfMessages() > 0 &&
      mass->GetMessage(0).find("NewId") != std::string::npos);
  moved = std::make_shared<sm::Face>(*moved);
  moved->Id = sm::NewId();
  model->SetFace(0, moved);
  mass->Update();
  CheckTrue("the moved face is seen without Modified()", mass->GetVolume() > before + 100.0);
  CheckRange(
    "the ribbons closed a gap of 1", 0.99, GetField(mass->GetOutput()->GetFieldData(), names::MaxGap), 1.01);
  model->SetFace(0, old);
  mass->Update();
  Check("set back, the same bits", before, mass->GetVolume(), 0.0);
}

void CheckUnits(const std::string& box)
{
  std::printf("--- units\n");
  vtkNew<vtkSTEPReader> millimetres;
  vtkNew<vtkSTEPReader> inches;
  millimetres->SetFileName(box.c_str());
  inches->SetFileName(box.c_str());
  inches->SetOutputUnit("inch");
  vtkNew<vtkMultiBlockDataSet> both;
  both->SetBlock(0, GetLeaf(millimetres));
  both->SetBlock(1, GetLeaf(inches));
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetInputData(both);
  mass->SetDensity(1000.0);
  mass->Update();
  CheckTrue("no total of unlike units", std::isnan(mass->GetVolume()) && mass->GetNumberOfMessages() > 0);
  auto* table = vtkTable::SafeDownCast(mass->GetOutputDataObject(1));
  for (vtkIdType row = 0; row < 2; ++row)
  {
    Check(
      "mass of either", 0.006, table->GetValueByName(row, names::Mass).ToDouble(), 6e-12, "1e-9 relative");
  }
}

void CheckIntegrands(const std::string& box)
{
  std::printf("--- integrands that are not numbers, or too much to ask\n");
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(box.c_str());
  vtkNew<vtkSurfaceIntegralGPU> integral;
  MessageTrap trap(integral);
  integral->SetInputConnection(reader->GetOutputPort());
  integral->AddIntegrand("root", "sqrt(position.x - 1000.0LF) * length(normal)");
  integral->Update();
  CheckEqual("a root of negative numbers", names::StatusSuspect, integral->GetStatus());
  CheckTrue("is not a number", std::isnan(integral->GetIntegral("root")));
  CheckRange("and not tried for ever", 1.0, static_cast<double>(integral->GetEvaluations()), 1e5);
  integral->RemoveAllIntegrands();
  integral->AddVolumeMoment("xx", 2, 0, 0);
  integral->SetRelativeTolerance(1e-15);
  integral->Update();
  CheckEqual("a tolerance below rounding", names::StatusToleranceNotMet, integral->GetStatus());
}

/// The first and the last lines of a summary.
void CheckStatusLines()
{
  std::printf("--- status lines\n");
  const std::string unit = "mm is assumed";
  CheckEqual("ok", "Status: ok\n", sm::FormatStatus("ok", ""));
  CheckEqual(
    "a reason", "Status: tolerance-not-met\nsecond\n", sm::FormatStatus("tolerance-not-met", "second"));
  CheckEqual("no note", "", sm::FormatNotes("", {}));
  CheckEqual("notes", "Note: mm is assumed\nNote: second\n", sm::FormatNotes("", { unit, "second", unit }));
  CheckEqual(
    "not the reason again", "Note: mm is assumed\n", sm::FormatNotes("a: second", { unit, "second" }));
  CheckEqual("the number of the others", "Note: 1\nNote: 2\nNote: 3\nNote: 4\nNote: 5\nand 2 more notes\n",
    sm::FormatNotes("", { "1", "2", "3", "4", "5", "6", "7" }));
  const std::string gap = "the widest gap between a face and its edge is ";
  CheckEqual("one note of gaps", "Note: nut: " + gap + "2 mm\nNote: last\nand 1 more note\n",
    sm::FormatNotes("", { "nut: " + gap + "2 mm", "rod: " + gap + "3 mm", "last" }));
}
}

int TestMassPropertiesRuns(int argc, char* argv[])
{
  RequireUsage(argc >= 3, "TestMassPropertiesRuns FOLDER OUTPUT");
  const std::string folder = argv[1];
  CheckStaleValues(folder + "/box-plain.step");
  CheckBudgetAndAbort(folder + "/spline_ring-plain.step", argv[2]);
  CheckEdit(folder + "/box-plain.step");
  CheckUnits(folder + "/box-plain.step");
  CheckIntegrands(folder + "/box-plain.step");
  CheckStatusLines();
  return Finish();
}
