// TestSurfaceIntegral FOLDER: integrands of one's own over the faces and over the closed chain, and how wrong
// ones fail.
#include "smTestManifest.h"
#include "smTestPipeline.h"

#include <vtkSurfaceIntegralGPU.h>
#include <vtkTable.h>

namespace
{
using namespace smtest;

void CheckIntegrands(const Expected& part)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(part.Path.c_str());
  vtkNew<vtkSurfaceIntegralGPU> integral;
  integral->SetInputConnection(reader->GetOutputPort());
  integral->AddAreaMoment("A", 0, 0, 0);
  integral->AddAreaMoment("Ax", 1, 0, 0);
  integral->AddAreaMoment("Azz", 0, 0, 2);
  integral->AddVolumeMoment("V", 0, 0, 0);
  integral->AddVolumeMoment("Vxyz", 1, 1, 1);
  integral->AddIntegrand("flux", "dot(position, normal) / 3.0LF", vtkSurfaceIntegralGPU::CLOSED_CHAIN);
  integral->AddIntegrand("area", "length(normal)");
  integral->AddIntegrand("normal", "normal.y", vtkSurfaceIntegralGPU::CLOSED_CHAIN);
  CheckEqual("integrands", 8, integral->GetNumberOfIntegrands());
  CheckEqual("name", "flux", integral->GetIntegrandName(5));
  integral->Update();
  CheckEqual(
    "a point that carries the field data to another process", 1, integral->GetOutput()->GetNumberOfPoints());
  CheckEqual("status", "ok", integral->GetStatus());

  // A box a x b x c in a corner at t: the part is box-far's sibling, so every integral is a polynomial.
  const double a = 30.0;
  const double b = 20.0;
  const double c = 10.0;
  const double area = 2 * (a * b + b * c + c * a);
  // Tolerance 1e-9 of each integral's own scale: size^degree times area or volume.
  const double scale = 1e-9 * part.Size * part.Size * part.Size;
  Check("area moment 0", area, integral->GetIntegral("A"), 1e-9 * area);
  Check("area of the expression", area, integral->GetIntegral("area"), 1e-9 * area);
  // By symmetry about the plane x = a/2.
  Check("area moment x", area * a / 2, integral->GetIntegral("Ax"), scale * area / part.Size / part.Size);
  const double zz = 2 * a * b * c * c / 2 + 2 * (a + b) * c * c * c / 3;
  Check("area moment zz", zz, integral->GetIntegral("Azz"), scale * area / part.Size);
  Check("volume", a * b * c, integral->GetIntegral("V"), 1e-9 * a * b * c);
  Check("volume of the flux", a * b * c, integral->GetIntegral("flux"), 1e-9 * a * b * c);
  Check("moment xyz", a * a * b * b * c * c / 8, integral->GetIntegral("Vxyz"), scale * a * b * c);
  Check("normal of a closed surface", 0.0, integral->GetIntegral("normal"), 1e-9 * area);
  for (const char* name : { "A", "Ax", "Azz", "V", "Vxyz", "flux", "area", "normal" })
  {
    vtkFieldData* fields = integral->GetOutput()->GetFieldData();
    Check(std::string(name) + " in the field data", integral->GetIntegral(name), GetField(fields, name), 0.0);
    CheckTrue(std::string(name) + " has a bound", integral->GetIntegralBound(name) > 0.0);
    Check(std::string(name) + " bound in the field data", integral->GetIntegralBound(name),
      GetFieldBound(fields, name), 0.0);
  }
  CheckTrue("an unknown name is NaN", std::isnan(integral->GetIntegral("there is none")));
}

void CheckMistakes(const Expected& part)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(part.Path.c_str());
  vtkNew<vtkSurfaceIntegralGPU> integral;
  integral->SetInputConnection(reader->GetOutputPort());
  MessageTrap messages(integral);
  MessageTrap executive(integral->GetExecutive());
  integral->AddIntegrand("", "1.0LF");
  CheckEqual("errors of an empty name", 1, messages.NumberOfErrors);
  integral->AddIntegrand("a", "");
  CheckEqual("errors of an empty expression", 2, messages.NumberOfErrors);
  integral->AddIntegrand("a", "dA");
  integral->AddIntegrand("a", "2 * dA");
  CheckEqual("errors of a name used twice", 3, messages.NumberOfErrors);
  for (const char* name : { "Faces", "Name", "aBound" })
  {
    integral->AddIntegrand(name, "dA");
  }
  CheckEqual("errors of other columns' names", 6, messages.NumberOfErrors);
  integral->AddVolumeMoment("b", -1, 0, 0);
  CheckEqual("errors of a negative power", 7, messages.NumberOfErrors);
  integral->AddVolumeMoment("b", 20, 20, 21);
  integral->AddAreaMoment("b", 61, 0, 0);
  CheckEqual("errors of powers that no rule integrates", 9, messages.NumberOfErrors);
  CheckEqual("integrands", 1, integral->GetNumberOfIntegrands());

  integral->AddIntegrand("broken", "position.x + there_is_no_such_function(normal)");
  integral->Update();
  CheckTrue("an expression that does not compile is reported with the compiler's words",
    (messages.Errors + messages.Warnings + executive.Errors).find("there_is_no_such_function") !=
        std::string::npos ||
      (integral->GetNumberOfMessages() > 0 &&
        integral->GetMessage(0).find("there_is_no_such_function") != std::string::npos));
  CheckTrue("and gives no number, the other one does",
    std::isfinite(integral->GetIntegral("a")) && std::isnan(integral->GetIntegral("broken")));

  integral->RemoveAllIntegrands();
  integral->AddIntegrand("area", "length(normal)");
  integral->Update();
  Check("a good expression after it", part.Area, integral->GetIntegral("area"), 1e-9 * part.Area);
}
}

int TestSurfaceIntegral(int argc, char* argv[])
{
  RequireUsage(argc == 2, "TestSurfaceIntegral FOLDER");
  const Expected box = Manifest(argv[1]).GetSolid("box", "plain")[0];
  CheckIntegrands(box);
  CheckMistakes(box);
  return Finish();
}
