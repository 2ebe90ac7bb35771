// Areas of a flat square whose bilinear surface has weights of very different size: a peak of |n| that no
// point of a rule may hit. The square stays the square whatever the weights are. Without integrals over the
// volume nothing else asks for more points.
#include "smMessageTrap.h"
#include "smTesting.h"

#include <vtkNURBSDataSet.h>
#include <vtkNew.h>
#include <vtkSurfaceIntegralGPU.h>
#include <vtkTrimmedNURBSModel.h>

#include <array>
#include <cmath>
#include <memory>

namespace
{
using namespace smtest;

vtkSmartPointer<vtkNURBSDataSet> MakeSquare(const std::array<double, 4>& weights)
{
  auto face = std::make_shared<sm::Face>();
  face->Id = sm::NewId();
  face->Surface.Knots[0] = face->Surface.Knots[1] = { 0.0, 0.0, 1.0, 1.0 };
  face->Surface.NumberOfControlPoints[0] = face->Surface.NumberOfControlPoints[1] = 2;
  for (int i = 0; i < 4; ++i)
  {
    const double w = weights[i];
    face->Surface.ControlPoints.push_back({ w * (i % 2), w * (i / 2), 3.0 * w, w });
  }
  vtkNew<vtkTrimmedNURBSModel> model;
  model->SetBody(vtkTrimmedNURBSModel::SHELL);
  model->SetFaces({ face });
  model->SetLocalBounds(0.0, 1.0, 0.0, 1.0, 3.0, 3.0);
  auto leaf = vtkSmartPointer<vtkNURBSDataSet>::New();
  leaf->SetModel(model);
  return leaf;
}

void CheckWeights(double exponent, const std::array<int, 4>& pattern)
{
  std::array<double, 4> weights{};
  std::string name = "weights";
  for (int i = 0; i < 4; ++i)
  {
    weights[i] = std::pow(10.0, exponent * pattern[i]);
    name += " " + std::to_string(weights[i]);
  }
  vtkNew<vtkSurfaceIntegralGPU> integral;
  integral->SetBackend(vtkSurfaceIntegralGPU::CPU);
  integral->AddAreaMoment("area", 0, 0, 0);
  integral->AddAreaMoment("height", 0, 0, 1);
  integral->SetInputDataObject(MakeSquare(weights));
  const MessageTrap messages(integral);
  integral->Update();
  Check(
    name + ": area", 1.0, integral->GetIntegral("area"), integral->GetIntegralBound("area"), "(its bound)");
  Check(name + ": height times area", 3.0, integral->GetIntegral("height"),
    integral->GetIntegralBound("height"), "(its bound)");
  if (exponent <= 2.0)
  {
    CheckRange(name + ": bound", 0.0, integral->GetIntegralBound("area"), 1e-9, "(the tolerance)");
  }
}
}

int TestUnevenWeights(int, char*[])
{
  for (const double exponent : { 0.5, 2.0, 3.3, 3.6, 5.0, 6.0, 8.0, 12.0 })
  {
    for (const std::array<int, 4>& pattern :
      { std::array<int, 4>{ 0, 1, 0, -1 }, { 0, 0, 0, 1 }, { 0, 0, 0, -1 }, { 1, 0, 0, 1 } })
    {
      CheckWeights(exponent, pattern);
    }
  }
  return Finish();
}
