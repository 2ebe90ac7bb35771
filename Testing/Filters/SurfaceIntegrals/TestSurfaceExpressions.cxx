// TestSurfaceExpressions FOLDER MODE: integrands of one's own against closed forms: functions, constants and
// names of a sample (functions), curvatures (curvatures), fluxes (flux), divisions by 0 and their like
// (undefined), chosen faces (faces), mistakes (mistakes), numbers where the user's locale writes them with a
// comma (commas; of LOCPATH, de_DE.UTF-8).
#include "smTestManifest.h"
#include "smTestPipeline.h"

#include <vtkDataSetAttributes.h>
#include <vtkMath.h>
#include <vtkSurfaceIntegralGPU.h>
#include <vtkTable.h>

#include <clocale>
#include <map>

namespace
{
using namespace smtest;

/// A solid of the catalogue with a filter for its integrals.
struct Body
{
  Expected Part;
  vtkNew<vtkSTEPReader> Reader;
  vtkNew<vtkSurfaceIntegralGPU> Filter;

  Body(const char* folder, const std::string& solid, const std::string& variant = "plain")
    : Part(Manifest(folder).GetSolid(solid, variant)[0])
  {
    this->Reader->SetFileName(this->Part.Path.c_str());
    UseCoarseMesh(this->Reader);
    this->Filter->SetInputConnection(this->Reader->GetOutputPort());
  }

  /// Within the bound that the filter gives, which must not exceed `limit`.
  void CheckIntegral(const std::string& name, double exact, double limit)
  {
    const double bound = this->Filter->GetIntegralBound(name);
    const std::string what = this->Part.Solid + " " + name;
    Check(what, exact, this->Filter->GetIntegral(name), bound + 4e-16 * std::fabs(exact), "the bound");
    CheckRange(what + " bound", 0.0, bound, limit);
  }
};

void CheckFunctions(const char* folder)
{
  // The box [0,30] x [0,20] x [0,10]. The flux of f(x) e_x is what f gains across times the area there.
  Body box(folder, "box");
  vtkSurfaceIntegralGPU* filter = box.Filter;
  filter->AddFlux("sin", "sin(position.x)", "0", "0");
  filter->AddFlux("cos", "0", "cos(k * position.y)", "0");
  filter->AddFlux("tan", "0", "0", "tan(0.1 * position.z)");
  filter->AddFlux("exp", "0", "exp(-0.1 * position.y)", "0");
  filter->AddFlux("log", "log(1 + position.x)", "0", "0");
  filter->AddFlux("pow", "0", "0", "pow(1 + position.z, 1.5)");
  filter->AddIntegrand("third", "1 / 3 * dA");
  filter->AddIntegrand("top", "abs(unitNormal[2]) * dA");
  filter->AddConstant("k", 2.5);
  filter->AddProjectedArea("shadow", 1, 2, 3);
  filter->Update();
  const double area = 2 * (30 * 20 + 20 * 10 + 10 * 30);
  const double limit = 1e-9 * area;
  box.CheckIntegral("sin", 200 * std::sin(30.0), limit);
  box.CheckIntegral("cos", 300 * (std::cos(50.0) - 1), limit);
  box.CheckIntegral("tan", 600 * std::tan(1.0), limit);
  box.CheckIntegral("exp", 300 * (std::exp(-2.0) - 1), limit);
  box.CheckIntegral("log", 200 * std::log(31.0), limit);
  box.CheckIntegral("pow", 600 * (std::pow(11.0, 1.5) - 1), limit);
  box.CheckIntegral("third", area / 3, limit);
  box.CheckIntegral("top", 1200, limit);
  box.CheckIntegral("shadow", (1 * 200 + 2 * 300 + 3 * 600) / std::sqrt(14.0), limit);

  CheckTrue("kinks are reported",
    Says(box.Filter, "shadow may have kinks") && Says(box.Filter, "top may have kinks"));
  CheckTrue("where there are none nothing is reported",
    !Says(box.Filter, "sin may have") && !Says(box.Filter, "third may have"));

  filter->AddConstant("k", 0.5);
  filter->Update();
  box.CheckIntegral("cos", 300 * (std::cos(10.0) - 1), limit);

  // The cylinder's side, of degree 2 in u and 1 in v, is evaluated with its parameters exchanged.
  Body cylinder(folder, "cylinder");
  filter = cylinder.Filter;
  const std::string side = "(1 - unitNormal.z * unitNormal.z) * dA * ";
  filter->AddIntegrand("v is z", side + "(position.z - v) * (position.z - v)");
  filter->AddIntegrand("dv is e_z", side + "dot(dv - dvec3(0, 0, 1), dv - dvec3(0, 0, 1))");
  filter->AddIntegrand("u and v are orthogonal", side + "abs(dot(du, dv))");
  filter->AddIntegrand("dvv is 0", side + "length(dvv)");
  filter->AddIntegrand("duv is 0", side + "length(duv)");
  // Area over |du x dv| is area in the (u, v) plane: four quarters times the height.
  filter->AddIntegrand("parameters", side + "1 / length(cross(du, dv))");
  filter->AddIntegrand("u", side + "u / length(cross(du, dv))");
  // On a circle with any parametrisation, n.duu = -|du|^2 / r.
  filter->AddIntegrand("duu", side + "(dot(duu, unitNormal) + dot(du, du) / 8)");
  filter->Update();
  for (const char* zero : { "v is z", "dv is e_z", "u and v are orthogonal", "dvv is 0", "duv is 0", "duu" })
  {
    Check(std::string("cylinder ") + zero, 0.0, filter->GetIntegral(zero), 1e-10);
  }
  cylinder.CheckIntegral("parameters", 4 * 25, 1e-6);
  cylinder.CheckIntegral("u", 8 * 25, 1e-6);
}

void CheckCurvatures(const char* folder)
{
  // sphere: 1/R = 0.1. ellipsoid: Gauss and Bonnet. cylinder: radius 8, height 25. torus: 20 and 6, Willmore.
  const auto addAll = [](vtkSurfaceIntegralGPU* filter)
  {
    filter->AddIntegrand("mean", "meanCurvature * dA");
    filter->AddIntegrand("gauss", "gaussianCurvature * dA");
    filter->AddIntegrand("willmore", "meanCurvature * meanCurvature * dA");
    filter->AddBendingEnergy("bending");
    filter->Update();
  };
  for (const char* variant : { "plain", "mirrored", "moved" })
  {
    Body sphere(folder, "sphere", variant);
    const double r = sphere.Part.Size / std::sqrt(12.0);
    addAll(sphere.Filter);
    sphere.CheckIntegral("mean", 4 * vtkMath::Pi() * r, 1e-5);
    sphere.CheckIntegral("gauss", 4 * vtkMath::Pi(), 1e-5);
    sphere.CheckIntegral("willmore", 4 * vtkMath::Pi(), 1e-5);
    sphere.CheckIntegral("bending", 8 * vtkMath::Pi(), 1e-5);
  }
  Body ellipsoid(folder, "ellipsoid");
  ellipsoid.Filter->AddIntegrand("gauss", "gaussianCurvature * dA");
  ellipsoid.Filter->Update();
  ellipsoid.CheckIntegral("gauss", 4 * vtkMath::Pi(), 1e-5);
  Body cylinder(folder, "cylinder");
  addAll(cylinder.Filter);
  cylinder.CheckIntegral("mean", vtkMath::Pi() * 25, 1e-5);
  cylinder.CheckIntegral("gauss", 0.0, 1e-5);
  cylinder.CheckIntegral("bending", 2 * vtkMath::Pi() * 25 / 8, 1e-5);
  Body torus(folder, "torus");
  addAll(torus.Filter);
  const double willmore = vtkMath::Pi() * vtkMath::Pi() * 400 / (6 * std::sqrt(400.0 - 36.0));
  torus.CheckIntegral("mean", 2 * vtkMath::Pi() * vtkMath::Pi() * 20, 1e-5);
  torus.CheckIntegral("gauss", 0.0, 1e-5);
  torus.CheckIntegral("willmore", willmore, 1e-5);
  torus.CheckIntegral("bending", 4 * willmore, 1e-5);
}

void CheckFluxes(const char* folder)
{
  for (const char* solid : { "torus", "slanted_hole", "bicylinder" })
  {
    Body body(folder, solid);
    vtkSurfaceIntegralGPU* filter = body.Filter;
    filter->AddFlux("linear", "2 * position.x + position.y", "3 * position.y", "-position.z");
    filter->AddFlux(
      "quadratic", "position.x * position.x", "position.x * position.y", "position.z * position.z");
    filter->AddFlux("curl", "position.y", "-position.x", "1");
    filter->Update();
    // Divergences 4, 3 x + 2 z and 0.
    const double volume = body.Part.Volume;
    const double moment = (3 * body.Part.Center[0] + 2 * body.Part.Center[2]) * volume;
    const double limit = 1e-9 * body.Part.Area;
    body.CheckIntegral("linear", 4 * volume, limit);
    body.CheckIntegral("quadratic", moment, limit);
    body.CheckIntegral("curl", 0.0, limit);
  }
}

void CheckFaces(const char* folder)
{
  Body box(folder, "box");
  vtkSurfaceIntegralGPU* filter = box.Filter;
  filter->AddIntegrand("area", "dA");
  filter->AddAreaMoment("moment", 1, 1, 0);
  filter->Update();
  const auto getRow = [filter](vtkIdType row, const char* name)
  {
    vtkTable* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(3));
    return vtkDataArray::SafeDownCast(table->GetRowData()->GetAbstractArray(name))->GetComponent(row, 0);
  };
  CheckEqual("the total says that bounds are estimated", 1,
    static_cast<int>(
      filter->GetOutput()->GetFieldData()->GetArray(sm::names::BoundsEstimated)->GetComponent(0, 0)));
  const double areas[2] = { getRow(1, "area"), getRow(4, "area") };
  const double moment = getRow(1, "moment") + getRow(4, "moment");
  const vtkTypeInt64 evaluations = filter->GetEvaluations();
  filter->AddFaceId(static_cast<int>(getRow(1, sm::names::FaceId)));
  filter->AddFaceId(static_cast<int>(getRow(4, sm::names::FaceId)));
  filter->AddFaceId(999999);
  CheckEqual("chosen faces", 3, filter->GetNumberOfFaceIds());
  filter->Update();
  CheckTrue("chosen faces have areas", areas[0] > 100 && areas[1] > 100);
  Check("area of chosen faces", areas[0] + areas[1], filter->GetIntegral("area"), 0.0, "the same bits");
  Check("moment of chosen faces", moment, filter->GetIntegral("moment"), 1e-12 * std::fabs(moment));
  Check("a face that was not chosen", 0.0, getRow(0, "area"), 0.0);
  CheckTrue("its evaluations are not made", filter->GetEvaluations() * 2 < evaluations);
  CheckTrue("a face that is not there is reported", Says(box.Filter, "#999999"));
  filter->RemoveAllFaceIds();
  filter->Update();
  Check("all faces again", box.Part.Area, filter->GetIntegral("area"), 1e-9 * box.Part.Area);
}

void CheckMistakes(const char* folder)
{
  struct Mistake
  {
    const char* Text;
    /// Text that the message must contain.
    const char* Place;
    const char* Word;
  };
  const Mistake mistakes[] = { { "position.x + there_is_none(normal)", "column 14", "there_is_none" },
    { "dA * sine", "column 6", "sine" }, { "sin(position.x) * dA + cos(normal)", "column 24", "cos" },
    { "dA + normal", "column 1", "" }, { "dA * (1 + 2", "column 6", "not closed" },
    { "dA) * (2", "column 3", "not opened" }, { "dA; smValues[0] = 1", "column 3", ";" },
    { "dA = 1", "column 4", "=" }, { "dA // comment", "column 4", "/" },
    { "dA +\n  1 *\n  nothing", "line 3, column 3", "nothing" }, { "smValues[0]", "column 1", "reserved" },
    { "position.x", "no area element", "dA" }, { "unitNormal.x * duu.x", "no area element", "normal" },
    { "3x * dA", "column 1", "number" }, { "position.q * dA", "column 1", "q" },
    { "dA *", "column 5", "unexpected" } };
  Body box(folder, "box");
  vtkSurfaceIntegralGPU* filter = box.Filter;
  filter->AddIntegrand("area", "dA");
  int count = 0;
  for (const Mistake& mistake : mistakes)
  {
    filter->AddIntegrand("mistake " + std::to_string(count++), mistake.Text);
  }
  filter->AddIntegrand("chain", "u * dA", vtkSurfaceIntegralGPU::CLOSED_CHAIN);
  filter->AddVolumeMoment("volume", 0, 0, 0);
  filter->Update();
  Check("area next to mistakes", box.Part.Area, filter->GetIntegral("area"), 1e-9 * box.Part.Area);
  Check("volume next to mistakes", box.Part.Volume, filter->GetIntegral("volume"), 1e-9 * box.Part.Volume);
  for (int i = 0; i < count; ++i)
  {
    const std::string name = "mistake " + std::to_string(i);
    std::string message;
    for (int m = 0; m < filter->GetNumberOfMessages(); ++m)
    {
      message =
        filter->GetMessage(m).compare(0, name.size() + 1, name + " ") == 0 ? filter->GetMessage(m) : message;
    }
    CheckTrue(name + " is reported at its place",
      message.find(std::string(mistakes[i].Place)) != std::string::npos &&
        message.find(mistakes[i].Word) != std::string::npos,
      message);
    CheckTrue(name + " is not a number", std::isnan(filter->GetIntegral(name)));
  }
  CheckTrue("parameters on the chain are reported",
    Says(box.Filter, "chain was not computed") && std::isnan(filter->GetIntegral("chain")));

  MessageTrap trap(filter);
  for (const char* name : { "", "2a", "position", "sin", "meanCurvature", "smValue", "a b" })
  {
    filter->AddConstant(name, 1.0);
  }
  filter->AddConstant("k", std::numeric_limits<double>::quiet_NaN());
  filter->AddProjectedArea("none", 0, 0, 0);
  CheckEqual("errors of wrong constants and directions", 9, trap.NumberOfErrors);

  filter->SetBackend(vtkSurfaceIntegralGPU::CPU);
  filter->Update();
  CheckTrue("on the CPU an expression is reported to need OpenGL",
    Says(box.Filter, "area was not computed: the expression"));
  Check("and moments are computed", box.Part.Volume, filter->GetIntegral("volume"), 1e-9 * box.Part.Volume);
}

/// An expression that is undefined or infinite at some point, whatever its rest makes of it, or whose value
/// depends on the parameters because the area element is not a factor, is NaN and not ok.
void CheckUndefined(const char* folder)
{
  const char* undefined[] = { "dA / (u - u)", "dA / 0", "dA / (0 * u)", "dA / (1 / (u - u))",
    "dot(normal / dvec3(1, 1, v - v), normal)", "dA * mod(u, u - u)", "dA * double(int(u) / int(0.5))",
    "dA * double(int(u) % int(0.5))", "max(sqrt(-1 - u * u), 0) * dA", "dA * log(u - u)",
    "clamp(log(-1 - u * u), 0, 1) * dA", "dA * pow(-1 - u * u, 0.5)", "min(dA * pow(u - u, -1), 1)",
    "dA * inversesqrt(u - u)", "dA * normalize(dvec3(u - u)).x", "min(tan(2e6 + u), 0) * dA", "dA * exp(1e5)",
    "isinf(dA / (v - v)) ? dA : 2 * dA", "dA / (position.x - 15)", "dA * dA", "sqrt(dA) + u", "normal.x + 1",
    "meanCurvature * meanCurvature * dA + dA * dA", "normal.x * normal.x" };
  Body box(folder, "box");
  vtkSurfaceIntegralGPU* filter = box.Filter;
  for (const char* text : undefined)
  {
    filter->AddIntegrand(text, text);
  }
  filter->Update();
  CheckEqual("status of what is undefined", "suspect", filter->GetStatus());
  for (const char* text : undefined)
  {
    CheckTrue(std::string("no number: ") + text,
      std::isnan(filter->GetIntegral(text)) && std::isnan(filter->GetIntegralBound(text)),
      std::to_string(filter->GetIntegral(text)));
    CheckTrue(
      "it is said", Says(filter, std::string(text) + " is undefined or infinite somewhere on the faces"));
  }
  // Poles between the points: an order that agrees with the next by symmetry is distinguished by one with a
  // point in the middle.
  for (const char* text : { "dA / (position.x - 14.3)", "dA / (position.x - 15.0000001)",
         "dA / (position.x - 7.5)", "dA / pow(position.y - 10.1, 2)", "dA * tan(0.1 * position.x)" })
  {
    filter->RemoveAllIntegrands();
    filter->AddIntegrand("f", text);
    filter->Update();
    CheckTrue(std::string("not ok: ") + text, std::string(filter->GetStatus()) != "ok", filter->GetStatus());
  }
  filter->RemoveAllIntegrands();
  filter->AddIntegrand("guarded", "(u == u ? 1 : 1 / (u - u)) * dA");
  filter->AddIntegrand("divided", "dA / 2 / -(1 + 3) / (2 + u - u)");
  filter->AddIntegrand(
    "removable", "dA * pow(u - u, 0) * sqrt(u - u + 1) * normalize(normal)[0] * unitNormal.x");
  filter->Update();
  CheckEqual("status of what is defined", "ok", filter->GetStatus());
  box.CheckIntegral("guarded", 2200, 1e-6);
  box.CheckIntegral("divided", -2200 / 16.0, 1e-6);
  box.CheckIntegral("removable", 400, 1e-6);
  filter->SetBackend(vtkSurfaceIntegralGPU::CPU);
  filter->AddIntegrand("f", "dA / (u - u)");
  filter->Update();
  CheckEqual("status without OpenGL", "not-computed", filter->GetStatus());
  CheckTrue("no number without OpenGL",
    std::isnan(filter->GetIntegral("f")) && std::isnan(filter->GetIntegralBound("f")));
}

void CheckCommas(const char* folder)
{
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8"))
  {
    std::exit(77);
  }
  CheckEqual("the locale's decimal point", ",", std::localeconv()->decimal_point);
  Body box(folder, "box");
  vtkSurfaceIntegralGPU* filter = box.Filter;
  filter->AddConstant("k", 2.5);
  filter->AddIntegrand("constant", "k * dA");
  filter->AddProjectedArea("shadow", 1, 2, 3);
  filter->AddVolumeMoment("moment", 1, 0, 0);
  filter->Update();
  CheckEqual("status", "ok", filter->GetStatus());
  box.CheckIntegral("constant", 2.5 * 2200, 1e-5);
  box.CheckIntegral("shadow", (1 * 200 + 2 * 300 + 3 * 600) / std::sqrt(14.0), 1e-5);
  box.CheckIntegral("moment", 6000 * 15, 1e-3);
}
}

int TestSurfaceExpressions(int argc, char* argv[])
{
  const std::map<std::string, void (*)(const char*)> modes = { { "functions", CheckFunctions },
    { "curvatures", CheckCurvatures }, { "flux", CheckFluxes }, { "faces", CheckFaces },
    { "mistakes", CheckMistakes }, { "undefined", CheckUndefined }, { "commas", CheckCommas } };
  const auto mode = argc == 3 ? modes.find(argv[2]) : modes.end();
  RequireUsage(mode != modes.end(), "TestSurfaceExpressions FOLDER MODE");
  mode->second(argv[1]);
  return Finish();
}
