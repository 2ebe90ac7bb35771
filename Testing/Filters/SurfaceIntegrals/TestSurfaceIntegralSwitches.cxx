// TestSurfaceIntegralSwitches FOLDER: integrands as a user interface sets them, as text and by switches.
#include "smTestManifest.h"
#include "smTestPipeline.h"

#include <vtkCellData.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSurfaceIntegralGPU.h>

#include <cstdio>

namespace
{
using namespace smtest;
constexpr double Pi = 3.14159265358979323846;
}

int TestSurfaceIntegralSwitches(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::fprintf(stderr, "usage: TestSurfaceIntegralSwitches FOLDER\n");
    return 1;
  }
  const Manifest manifest(argv[1]);
  const Expected ball = manifest.GetSolid("sphere", "plain").front();
  const double radius = std::cbrt(ball.Volume * 0.75 / Pi);
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
  integral->Update();
  CheckEqual("status", sm::names::StatusOk, integral->GetStatus());
  const double area = 4.0 * Pi * radius * radius;
  const auto check = [&](const std::string& name, double expected)
  { Check(name, expected, integral->GetIntegral(name), 1e-8 * std::fabs(expected)); };
  check("byHand", area);
  check("area", area);
  check("flux", 3.0 * ball.Volume);
  check("moment_0_0_0", ball.Volume);
  check("BendingEnergy", 8.0 * Pi);
  check("ProjectedArea", Pi * radius * radius);
  auto* bodies = vtkPartitionedDataSetCollection::SafeDownCast(integral->GetOutputDataObject(5));
  auto* mesh = vtkPolyData::SafeDownCast(bodies->GetPartition(0, 0));
  CheckTrue("the mesh has the integrands to colour by",
    mesh->GetCellData()->HasArray("area") && mesh->GetCellData()->HasArray("BendingEnergy"));

  integral->AddBuoyancy("mine", 0.0, 0.0, 1e6, 0.0, 0.0, 1.0);
  integral->SetWaterlinePoint(0.0, -0.5 * radius, 0.0);
  integral->SetWaterlineNormal(0.0, 2.0, 0.0);
  CheckEqual("no waterline yet", 19, integral->GetNumberOfIntegrands());
  integral->SetWaterline(true);
  integral->SetWaterlinePoint(0.0, 0.5 * radius, 0.0);
  CheckEqual("a waterline has four", 23, integral->GetNumberOfIntegrands());
  integral->Update();
  check("mine", ball.Volume);
  check("Displaced", ball.Volume * 27.0 / 32.0); // a cap of height 3 r / 2
  integral->SetWaterlineNormal(0.0, -1.0, 0.0);
  integral->Update();
  check("Displaced", ball.Volume * 5.0 / 32.0);
  integral->SetWaterline(false);
  integral->Update();
  check("mine", ball.Volume);
  CheckEqual("the waterline is gone", 19, integral->GetNumberOfIntegrands());

  integral->SetIntegrandText("twice = 2 * dA");
  CheckEqual("another text replaces its own", 18, integral->GetNumberOfIntegrands());
  integral->SetMomentDegree(-1);
  integral->SetBendingEnergy(false);
  integral->SetProjectedAreaDirection(0.0, 0.0, 0.0);
  CheckEqual("what is switched off is gone", 6, integral->GetNumberOfIntegrands());
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
  CheckEqual("and the good ones are kept: by hand, area, 35 moments", 41, integral->GetNumberOfIntegrands());
  integral->SetProjectedAreaDirection(std::nan(""), 0.0, 0.0);
  CheckEqual("no direction is an error", 5, trap.NumberOfErrors);
  CheckEqual("and changes nothing", 41, integral->GetNumberOfIntegrands());
  integral->SetMomentDegree(1000);
  CheckEqual("degrees are clamped", 8, integral->GetMomentDegree());
  integral->RemoveAllIntegrands();
  CheckEqual("nothing is left", 0, integral->GetNumberOfIntegrands());
  CheckEqual("and the switches know", -1, integral->GetMomentDegree());
  CheckEqual("as does the text", "", integral->GetIntegrandText());
  return Finish();
}
