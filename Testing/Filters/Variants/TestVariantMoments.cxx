// The class for scripts: offsets of faces along their normals, nets as arrays, moved models, and what is
// refused.
#include "smTesting.h"
#include "smVariantSolids.h"
#include "vtkComputeContext.h"
#include "vtkVariantMoments.h"

#include <vtkCallbackCommand.h>
#include <vtkDoubleArray.h>

#include <cmath>
#include <vector>

namespace
{
using namespace smtest;

vtkSmartPointer<vtkDoubleArray> MakeArray(int components, const std::vector<double>& numbers)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(numbers.size()) / components);
  std::copy(numbers.begin(), numbers.end(), array->GetPointer(0));
  return array;
}

/// A face with its ribbons sweeps a prism: the volume is linear, and so is the first moment of the area's
/// middle.
void CheckOffsetsOfBox()
{
  BoxBody body;
  body.Add({ { 0.0, 0.0, 0.0 }, { 2.0, 3.0, 5.0 } });
  const vtkSmartPointer<vtkNURBSDataSet> leaf = body.Make();
  const double areas[6] = { 15.0, 15.0, 10.0, 10.0, 6.0, 6.0 };
  const double c[6] = { 0.1, -0.05, 0.2, 0.3, -0.1, 0.25 };
  for (const int method : { vtkVariantMoments::POINTS, vtkVariantMoments::POLYNOMIAL })
  {
    vtkNew<vtkVariantMoments> moments;
    moments->SetBase(leaf->GetModel());
    moments->SetMethod(method);
    double volume = 30.0;
    for (int f = 0; f < 6; ++f)
    {
      CheckEqual("index of a direction", f, moments->AddNormalOffset(f, 0.3));
      volume += c[f] * areas[f];
    }
    CheckTrue("a box is built", moments->Build(), moments->GetMessage());
    CheckEqual("method", method, moments->GetUsedMethod());
    vtkNew<vtkDoubleArray> values;
    vtkNew<vtkDoubleArray> bounds;
    const auto numbers = MakeArray(6, std::vector<double>(c, c + 6));
    CheckTrue("a variant", moments->Evaluate(numbers, values, bounds), moments->GetMessage());
    Check("volume of a box with offset faces", volume, values->GetValue(0), bounds->GetValue(0), "the bound");
    CheckRange("its bound", 0.0, bounds->GetValue(0), 1e-10 * volume, "some ten thousand roundings");
    Check("the way from a moved face to its edges", 1.0, moments->GetGap(2), 1e-12, "the offset by 1");
    vtkNew<vtkDoubleArray> gradients;
    const bool hasGradients = moments->EvaluateGradients(numbers, values, bounds, gradients);
    CheckEqual("gradients", method == vtkVariantMoments::POLYNOMIAL, hasGradients);
    for (int f = 0; f < 6 && hasGradients; ++f)
    {
      Check("derivative of the volume by an offset", areas[f], gradients->GetComponent(0, f), 1e-12,
        "the face's area, 1e4 roundings");
    }
  }
}

/// A ball and a torus whose only face moves outwards: the radius grows, exactly.
void CheckOffsetsOfRoundFaces()
{
  const double t = 0.25;
  for (const bool isTorus : { false, true })
  {
    const auto model = isTorus
      ? MakeModel({ MakeTorus({ 0.0, 0.0, 0.0 }, 3.0, 1.0) }, { -4, 4, -4, 4, -1, 1 })
      : MakeModel({ MakeBall({ 1.0, 2.0, 3.0 }, 2.0) }, { -1, 3, 0, 4, 1, 5 });
    vtkNew<vtkVariantMoments> moments;
    moments->SetBase(model);
    CheckEqual("direction of a round face", 0, moments->AddNormalOffset(0, 0.5));
    CheckTrue("it is built", moments->Build(), moments->GetMessage());
    vtkNew<vtkDoubleArray> values;
    vtkNew<vtkDoubleArray> bounds;
    moments->Evaluate(MakeArray(1, { t }), values, bounds);
    const double pi = static_cast<double>(Pi);
    const double volume =
      isTorus ? 2.0 * pi * pi * 3.0 * (1.0 + t) * (1.0 + t) : 4.0 / 3.0 * pi * std::pow(2.0 + t, 3);
    Check(isTorus ? "torus, offset" : "ball, offset", volume, values->GetValue(0), 1e-11 * volume,
      "a system of 81 equations at most, 1e5 roundings");
  }
}

void CheckNets()
{
  BoxBody body;
  body.Add({ { 0.0, 0.0, 0.0 }, { 2.0, 3.0, 5.0 } });
  const vtkSmartPointer<vtkNURBSDataSet> leaf = body.Make();
  vtkNew<vtkVariantMoments> moments;
  moments->SetBase(leaf->GetModel());
  const int direction = moments->AddEmptyDirection(1.0);
  const auto shift = MakeArray(3, { 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1 });
  for (int f = 0; f < 6; ++f)
  {
    CheckTrue("a net", moments->AddDisplacement(direction, f, shift), moments->GetMessage());
  }
  CheckTrue("nets are built", moments->Build(), moments->GetMessage());
  vtkNew<vtkDoubleArray> values;
  vtkNew<vtkDoubleArray> bounds;
  moments->Evaluate(MakeArray(1, { 0.5 }), values, bounds);
  Check(
    "volume of a box whose faces move alike", 30.0, values->GetValue(0), bounds->GetValue(0), "the bound");
  double reference[3];
  moments->GetReference(reference);
  Check("its centre", 3.0, reference[2] + values->GetValue(3) / values->GetValue(0), 1e-11, "1e4 roundings");
}

void CheckBackendAndProgress()
{
  BoxBody body;
  body.Add({ { 0.0, 0.0, 0.0 }, { 2.0, 3.0, 5.0 } });
  const vtkSmartPointer<vtkNURBSDataSet> leaf = body.Make();
  vtkNew<vtkComputeContext> none;
  none->SetSource(vtkComputeContext::WINDOW);
  vtkNew<vtkVariantMoments> moments;
  moments->SetComputeContext(none);
  moments->SetBase(leaf->GetModel());
  moments->SetMethod(vtkVariantMoments::POINTS);
  moments->SetBackend(vtkVariantMoments::OPENGL);
  moments->AddNormalOffset(0, 1.0);
  std::vector<double> seen;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&seen);
  observer->SetCallback([](vtkObject*, unsigned long, void* to, void* fraction)
    { static_cast<std::vector<double>*>(to)->push_back(*static_cast<double*>(fraction)); });
  const unsigned long tag = moments->AddObserver(vtkCommand::ProgressEvent, observer);
  CheckTrue("built without a context", moments->Build(), moments->GetMessage());
  CheckEqual(
    "the CPU without a context", static_cast<int>(vtkVariantMoments::CPU), moments->GetUsedBackend());
  CheckTrue("the reason", moments->GetReason().find("no OpenGL") != std::string::npos, moments->GetReason());
  CheckTrue("progress", !seen.empty());
  moments->RemoveObserver(tag);
  observer->SetClientData(moments);
  observer->SetCallback(
    [](vtkObject*, unsigned long, void* to, void*) { static_cast<vtkVariantMoments*>(to)->StopBuild(); });
  moments->AddObserver(vtkCommand::ProgressEvent, observer);
  CheckTrue("stopped", !moments->Build(), moments->GetMessage());
  CheckTrue("stopped: the reason", moments->GetMessage().find("stopped") != std::string::npos);
  vtkNew<vtkDoubleArray> values;
  CheckTrue("nothing is evaluated", !moments->Evaluate(MakeArray(1, { 0.0 }), values, nullptr));
}

void CheckRefusals()
{
  vtkNew<vtkVariantMoments> moments;
  vtkNew<vtkDoubleArray> values;
  CheckTrue("no base", !moments->Build(), moments->GetMessage());
  CheckTrue("not built", !moments->Evaluate(MakeArray(1, { 0.0 }), values, nullptr), moments->GetMessage());
  BoxBody body;
  body.Add({ { 0.0, 0.0, 0.0 }, { 2.0, 3.0, 5.0 } });
  const vtkSmartPointer<vtkNURBSDataSet> leaf = body.Make();
  moments->SetBase(leaf->GetModel());
  CheckEqual("a face that does not exist", -1, moments->AddNormalOffset(6, 1.0));
  CheckTrue("has a reason", !moments->GetMessage().empty(), moments->GetMessage());
  CheckTrue("a direction that does not exist", !moments->AddDisplacement(0, 0, MakeArray(3, { 0, 0, 0 })),
    moments->GetMessage());
  moments->AddEmptyDirection(1.0);
  CheckTrue("too few displacements", !moments->AddDisplacement(0, 0, MakeArray(3, { 0, 0, 0 })),
    moments->GetMessage());
  CheckTrue("a base without a move", moments->Build(), moments->GetMessage());
  CheckTrue("too many components", !moments->Evaluate(MakeArray(2, { 0.0, 0.0 }), values, nullptr),
    moments->GetMessage());
}
}

int TestVariantMoments(int, char*[])
{
  CheckOffsetsOfBox();
  CheckOffsetsOfRoundFaces();
  CheckNets();
  CheckBackendAndProgress();
  CheckRefusals();
  return Finish();
}
