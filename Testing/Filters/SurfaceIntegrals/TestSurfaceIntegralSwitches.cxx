// TestSurfaceIntegralSwitches FOLDER: integrands as a user interface sets them, as text and by switches.
#include "smTestManifest.h"
#include "smTestPipeline.h"

#include <vtkCellData.h>
#include <vtkMath.h>
#include <vtkNURBSDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSurfaceIntegralGPU.h>

namespace
{
using namespace smtest;
/// A name that another column has, or its bound would have, is an error and shifts no value.
void CheckNames(vtkSTEPReader* reader, const Expected& ball)
{
  vtkNew<vtkSurfaceIntegralGPU> integral;
  integral->SetInputConnection(reader->GetOutputPort());
  MessageTrap trap(integral);
  integral->AddAreaMoment("Displaced", 0, 0, 0);
  integral->SetIntegrandText("DisplacedBound = 2 * dA\nvolume = position.x ; position.y ; position.z");
  CheckEqual("a name that is another's bound is an error", 1, trap.NumberOfErrors);
  integral->AddVolumeMoment("last", 0, 0, 0);
  integral->AddIntegrand("tooBound", "3 * dA");
  integral->AddAreaMoment("too", 0, 0, 0);
  CheckEqual("so is one whose bound is another's name", 2, trap.NumberOfErrors);
  int errors = 2;
  std::vector<std::string> taken(
    std::begin(sm::names::ReservedColumnNames), std::end(sm::names::ReservedColumnNames));
  taken.push_back(vtkNURBSDataSet::FaceIndexArrayName());
  for (const std::string& name : taken)
  {
    integral->AddIntegrand(name, "5 * dA");
    CheckEqual("an integrand called " + name + " is an error", ++errors, trap.NumberOfErrors);
  }
  CheckEqual("integrands that are left", 4, integral->GetNumberOfIntegrands());
  integral->Update(5);
  CheckEqual("status", sm::names::StatusOk, integral->GetStatus());
  vtkFieldData* fields = integral->GetOutput()->GetFieldData();
  const std::pair<const char*, double> expected[] = { { "Displaced", ball.Area },
    { "volume", 3.0 * ball.Volume }, { "last", ball.Volume }, { "tooBound", 3.0 * ball.Area } };
  for (const auto& [name, value] : expected)
  {
    Check(name, value, integral->GetIntegral(name), 1e-8 * value);
    Check(std::string(name) + " in the field data", integral->GetIntegral(name), GetField(fields, name), 0.0);
  }
  Check("the bound of Displaced", integral->GetIntegralBound("Displaced"), GetFieldBound(fields, "Displaced"),
    0.0);
  auto* meshes = vtkPartitionedDataSetCollection::SafeDownCast(integral->GetOutputDataObject(5));
  auto* mesh = vtkPolyData::SafeDownCast(meshes->GetPartition(0, 0));
  // Arrays of integrands are floats.
  vtkDataArray* indices = mesh->GetCellData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName());
  CheckTrue("the mesh has its face indices", indices && indices->GetDataType() != VTK_FLOAT);
}
}

int TestSurfaceIntegralSwitches(int argc, char* argv[])
{
  RequireUsage(argc >= 2, "TestSurfaceIntegralSwitches FOLDER");
  const Manifest manifest(argv[1]);
  const Expected ball = manifest.GetSolid("sphere", "plain").front();
  const double radius = std::cbrt(ball.Volume * 0.75 / vtkMath::Pi());
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(ball.Path.c_str());
  vtkNew<vtkSurfaceIntegralGPU> integral;
  integral->SetInputConnection(reader->GetOutputPort());
  MessageTrap trap(integral);

  integral->AddAreaMoment("byHand", 0, 0, 0);
  integral->SetIntegrandText("\n area = dA\r\nflux = position.x ; position.y ; position.z \n\n");
  CheckEqual("integrands of the text and one by hand", 3, integral->GetNumberOfIntegrands());
  integral->SetMomentDegree(2);
  CheckEqual("with all moments to degree 2", 13, integral->GetNumberOfIntegrands());
  integral->SetBendingEnergy(true);
  integral->SetProjectedAreaDirection(0.0, 3.0, 0.0);
  CheckEqual("with everything", 15, integral->GetNumberOfIntegrands());
  integral->Update(5);
  CheckEqual("status", sm::names::StatusOk, integral->GetStatus());
  const double area = 4.0 * vtkMath::Pi() * radius * radius;
  const auto check = [&](const std::string& name, double expected)
  { Check(name, expected, integral->GetIntegral(name), 1e-8 * std::fabs(expected)); };
  check("byHand", area);
  check("area", area);
  check("flux", 3.0 * ball.Volume);
  check("moment_0_0_0", ball.Volume);
  check("BendingEnergy", 8.0 * vtkMath::Pi());
  check("ProjectedArea", vtkMath::Pi() * radius * radius);
  auto* bodies = vtkPartitionedDataSetCollection::SafeDownCast(integral->GetOutputDataObject(5));
  auto* mesh = vtkPolyData::SafeDownCast(bodies->GetPartition(0, 0));
  CheckTrue("the mesh has the integrands to colour by",
    mesh->GetCellData()->HasArray("area") && mesh->GetCellData()->HasArray("BendingEnergy"));

  integral->SetIntegrandText("twice = 2 * dA");
  CheckEqual("another text replaces its own", 14, integral->GetNumberOfIntegrands());
  integral->SetMomentDegree(-1);
  integral->SetBendingEnergy(false);
  integral->SetProjectedAreaDirection(0.0, 0.0, 0.0);
  CheckEqual("what is switched off is gone", 2, integral->GetNumberOfIntegrands());
  integral->Update();
  check("byHand", area);
  check("twice", 2.0 * area);
  CheckTrue("the others have no value", std::isnan(integral->GetIntegral("area")));
  integral->SetMomentDegree(4);
  integral->Update();
  mesh = vtkPolyData::SafeDownCast(
    vtkPartitionedDataSetCollection::SafeDownCast(integral->GetOutputDataObject(5))->GetPartition(0, 0));
  CheckTrue("many integrands make no arrays", !mesh->GetCellData()->HasArray("twice"));

  CheckEqual("errors so far", 0, trap.NumberOfErrors);
  integral->SetIntegrandText("this is none\narea = dA\nhalf = ; ;\n= dA\npair = dA ; dA");
  CheckEqual("bad lines are errors", 4, trap.NumberOfErrors);
  CheckTrue("that name them", trap.Errors.find("'this is none'") != std::string::npos, trap.Errors);
  CheckEqual("and the good ones are kept: by hand, area, 35 moments", 37, integral->GetNumberOfIntegrands());
  integral->SetProjectedAreaDirection(std::nan(""), 0.0, 0.0);
  CheckEqual("no direction is an error", 5, trap.NumberOfErrors);
  CheckEqual("and changes nothing", 37, integral->GetNumberOfIntegrands());
  integral->SetMomentDegree(1000);
  CheckEqual("degrees are clamped", 8, integral->GetMomentDegree());
  integral->SetBendingEnergy(true);
  integral->SetProjectedAreaDirection(0.0, 0.0, 1.0);
  integral->RemoveAllIntegrands();
  CheckEqual("nothing is left", 0, integral->GetNumberOfIntegrands());
  CheckEqual("the degree is reset", -1, integral->GetMomentDegree());
  CheckEqual("the text is reset", "", integral->GetIntegrandText());
  const double* direction = integral->GetProjectedAreaDirection();
  CheckTrue("bending energy and direction are reset",
    !integral->GetBendingEnergy() && direction[0] == 0.0 && direction[1] == 0.0 && direction[2] == 0.0);
  integral->AddAreaMoment("alone", 0, 0, 0);
  integral->Update();
  CheckEqual("an integrand that is added then is alone", 1, integral->GetNumberOfIntegrands());
  check("alone", area);
  CheckNames(reader, ball);
  return Finish();
}
