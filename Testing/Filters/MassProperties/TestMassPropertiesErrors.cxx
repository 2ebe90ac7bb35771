// TestMassPropertiesErrors FOLDER: files that hold no solid, or not a whole one, end in a named status and
// one clear message, never in a number.
#include "smTestManifest.h"
#include "smTestPipeline.h"

#include <vtkErrorCode.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

#include <cstdio>

namespace
{
using namespace smtest;
namespace names = sm::names;

void CheckNoNumbers(vtkMassPropertiesGPU* mass)
{
  CheckTrue("volume is NaN", std::isnan(mass->GetVolume()));
  CheckTrue("volume bound is NaN", std::isnan(mass->GetVolumeBound()));
  double center[3];
  mass->GetCenterOfMass(center);
  CheckTrue("centre is NaN", std::isnan(center[0]) && std::isnan(center[1]) && std::isnan(center[2]));
}

/// A file that the reader must refuse with `status` and one message that names the file.
void CheckRefused(const std::string& path, const std::string& status)
{
  std::printf("--- %s\n", path.c_str());
  Pipeline pipeline(path);
  MessageTrap messages(pipeline.Reader);
  MessageTrap executive(pipeline.Reader->GetExecutive());
  pipeline.Reader->Update();
  CheckEqual("status of the reader", status, pipeline.Reader->GetStatusAsString());
  CheckEqual("errors raised", 1, messages.NumberOfErrors);
  const std::string name = path.substr(path.find_last_of('/') + 1);
  CheckTrue("the error names the file", messages.Errors.find(name) != std::string::npos, messages.Errors);
  const int count = pipeline.Reader->GetNumberOfMessages();
  CheckTrue("the last message is kept",
    count > 0 && pipeline.Reader->GetMessage(count - 1).find(name) != std::string::npos);
  auto* output = vtkPartitionedDataSetCollection::SafeDownCast(pipeline.Reader->GetOutputDataObject(0));
  CheckTrue("the output is empty", !output || output->GetNumberOfPartitionedDataSets() == 0);
  CheckEqual("instances", 0, pipeline.Reader->GetNumberOfInstances());

  MessageTrap filterMessages(pipeline.Mass);
  MessageTrap filterExecutive(pipeline.Mass->GetExecutive());
  pipeline.Mass->Update();
  CheckNoNumbers(pipeline.Mass);
  CheckEqual("status of the filter", status, pipeline.Mass->GetStatus());
  CheckTrue("which names the file", Says(pipeline.Mass, name), GetMessages(pipeline.Mass));
}

void CheckOpen(const Expected& file)
{
  std::printf("--- %s\n", file.Path.c_str());
  Pipeline pipeline(file.Path);
  MessageTrap readerMessages(pipeline.Reader);
  MessageTrap filterMessages(pipeline.Mass);
  pipeline.Mass->Update();
  vtkFieldData* fields = pipeline.Mass->GetOutput()->GetFieldData();
  CheckEqual("status", names::StatusOpen, GetFieldText(fields, names::Status));
  // A box 30 x 20 x 10 less its face of 20 x 10.
  Check("area", 2000.0, GetField(fields, names::SurfaceArea), 1e-9 * 2000.0);
  CheckEqual("open edges", 4, static_cast<long long>(GetField(fields, names::OpenEdges)));
  CheckEqual("errors", "", readerMessages.Errors + filterMessages.Errors);
}

void CheckJunkHeader(const Expected& file)
{
  std::printf("--- %s\n", file.Path.c_str());
  Pipeline pipeline(file.Path);
  MessageTrap messages(pipeline.Reader);
  pipeline.Mass->Update();
  Check("volume", file.Volume, pipeline.Mass->GetVolume(), 1e-9 * file.Volume);
  CheckTrue("a message reports the junk", pipeline.Reader->GetNumberOfMessages() > 0);
  CheckEqual("errors", "", messages.Errors);
}

/// Data without exact geometry is wrong input: an error, which says so once, and no numbers.
void CheckWrongInput(vtkDataObject* plain)
{
  std::printf("--- %s\n", plain->GetClassName());
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetInputData(plain);
  MessageTrap messages(mass);
  MessageTrap executive(mass->GetExecutive());
  mass->Update();
  CheckTrue("an error is raised", messages.NumberOfErrors == 1, messages.Errors);
  CheckTrue("it has the remedy",
    messages.Errors.find("Take the output of STEP Reader or BREP Reader") != std::string::npos,
    messages.Errors);
  // The executive says that the filter failed, once.
  CheckTrue("nothing else",
    executive.NumberOfErrors <= 1 && executive.Errors.find("is required") == std::string::npos,
    executive.Errors);
  CheckNoNumbers(mass);
}

/// A pipeline that met a bad file works again with a good one. (Between the two the filter does not run: the
/// executive stops at the reader's error, and getters are those of the last run.)
void CheckRecovers(const std::string& good, const std::string& bad)
{
  std::printf("--- a good file, then a bad one, then a good one\n");
  Pipeline pipeline(good);
  MessageTrap readerMessages(pipeline.Reader);
  MessageTrap readerExecutive(pipeline.Reader->GetExecutive());
  MessageTrap filterExecutive(pipeline.Mass->GetExecutive());
  pipeline.Mass->Update();
  const double volume = pipeline.Mass->GetVolume();
  CheckTrue("volume of the good file", volume > 0.0);
  pipeline.Reader->SetFileName(bad.c_str());
  pipeline.Mass->Update();
  CheckEqual("status of the reader", names::StatusUnreadable, pipeline.Reader->GetStatusAsString());
  CheckEqual("errors of the reader", 1, readerMessages.NumberOfErrors);
  CheckTrue("its error code", pipeline.Reader->GetErrorCode() != vtkErrorCode::NoError);
  // The numbers of the file before would look like those of this one.
  CheckEqual("status of the filter", names::StatusUnreadable, pipeline.Mass->GetStatus());
  CheckNoNumbers(pipeline.Mass);
  CheckTrue("no row of a solid",
    vtkTable::SafeDownCast(pipeline.Mass->GetOutputDataObject(1))->GetNumberOfRows() == 0);
  pipeline.Reader->SetFileName(good.c_str());
  pipeline.Mass->Update();
  CheckEqual("status of the reader", names::StatusOk, pipeline.Reader->GetStatusAsString());
  CheckTrue("no error code", pipeline.Reader->GetErrorCode() == vtkErrorCode::NoError);
  CheckEqual("status of the filter", names::StatusOk, pipeline.Mass->GetStatus());
  Check("volume again", volume, pipeline.Mass->GetVolume(), 0.0, "(the same bits)");
}
}

int TestMassPropertiesErrors(int argc, char* argv[])
{
  RequireUsage(argc == 2, "TestMassPropertiesErrors FOLDER");
  const std::string folder = argv[1];
  const Manifest manifest(folder);
  CheckRefused(folder + "/there_is_no_such_file.step", names::StatusUnreadable);
  CheckRefused(folder, names::StatusUnreadable);
  CheckRefused(manifest.GetSpecial("empty").Path, names::StatusUnreadable);
  CheckRefused(manifest.GetSpecial("not_step").Path, names::StatusUnreadable);
  CheckRefused(manifest.GetSpecial("no_geometry").Path, names::StatusEmpty);
  CheckRefused(manifest.GetSpecial("points_only").Path, names::StatusEmpty);
  CheckOpen(manifest.GetSpecial("open_shell"));
  CheckOpen(manifest.GetSpecial("open_solid"));
  CheckJunkHeader(manifest.GetSpecial("junk_header"));
  // MergeBlocks and IntegrateVariables of ParaView give unstructured grids.
  CheckWrongInput(vtkNew<vtkPolyData>());
  CheckWrongInput(vtkNew<vtkUnstructuredGrid>());
  CheckWrongInput(vtkNew<vtkTable>());
  CheckRecovers(manifest.GetSolid("box", "plain")[0].Path, manifest.GetSpecial("empty").Path);
  return Finish();
}
