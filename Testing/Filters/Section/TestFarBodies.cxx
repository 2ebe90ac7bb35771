// Bodies that are far from the origin of their model compared with their size, and a plane, or a placement,
// that brings them back: heights above the plane and placed coordinates are small differences of large
// numbers, whose rounding is not a part of a small result's.
#include "smTestArrays.h"
#include "smTesting.h"

#include <vtkBuoyancy.h>
#include <vtkDoubleArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNURBSDataSet.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkSolidSection.h>
#include <vtkSurfaceIntegralGPU.h>
#include <vtkTrimmedNURBSModel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <random>
#include <string>
#include <utility>

namespace
{
using namespace smtest;
using Real = long double;

/// Four corners, which are whole numbers of units, about a middle that is one, too.
struct Tetrahedron
{
  std::array<std::array<int, 3>, 4> Corners{};
  std::array<double, 3> Middle{};
  double Unit = 1.0;
  /// Distance, in units, by which the ends of edges miss the corners, in a direction of each edge.
  double Miss = 0.0;

  int GetDeterminant() const
  {
    int d[3][3];
    for (int i = 0; i < 3; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        d[i][c] = this->Corners[i + 1][c] - this->Corners[0][c];
      }
    }
    return d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
      d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) + d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
  }

  Real GetVolume() const
  {
    return std::abs(this->GetDeterminant()) / 6.0L * std::pow<Real>(this->Unit, 3.0L);
  }

  /// The part below x, in units about the middle: a spline of the corners' coordinates, which all differ.
  Real GetVolumeBelow(Real x) const
  {
    Real part = 0;
    for (int i = 0; i < 4; ++i)
    {
      Real term = std::pow(std::max(x - this->Corners[i][0], Real(0)), 3.0L);
      for (int j = 0; j < 4; ++j)
      {
        term /= j == i ? 1 : this->Corners[j][0] - this->Corners[i][0];
      }
      part += term;
    }
    return part * this->GetVolume();
  }

  std::array<double, 3> GetCorner(int i) const
  {
    std::array<double, 3> corner;
    for (int c = 0; c < 3; ++c)
    {
      corner[c] = this->Middle[c] + this->Unit * this->Corners[i][c];
    }
    return corner;
  }
};

vtkSmartPointer<vtkNURBSDataSet> MakeBody(const Tetrahedron& solid)
{
  vtkNew<vtkTrimmedNURBSModel> model;
  std::map<std::pair<int, int>, int> edges;
  const auto unit = MakeArray(1, { 0, 1 });
  const auto knots = MakeArray(1, { 0, 0, 1, 1 });
  const double uv[3][2] = { { 0, 0 }, { 1, 0 }, { 0, 1 } };
  for (std::array<int, 3> f : { std::array<int, 3>{ 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } })
  {
    if (solid.GetDeterminant() < 0)
    {
      std::swap(f[1], f[2]);
    }
    const std::array<double, 3> a = solid.GetCorner(f[0]);
    const std::array<double, 3> b = solid.GetCorner(f[1]);
    const std::array<double, 3> c = solid.GetCorner(f[2]);
    const auto net = MakeArray(3,
      { a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2], b[0] + (c[0] - a[0]), b[1] + (c[1] - a[1]),
        b[2] + (c[2] - a[2]) });
    const int face = model->AddFace(1, knots, 1, knots, net);
    for (int i = 0; i < 3; ++i)
    {
      const int from = f[i];
      const int to = f[(i + 1) % 3];
      const auto [entry, isNew] = edges.emplace(std::minmax(from, to), 0);
      if (isNew)
      {
        std::array<double, 3> start = solid.GetCorner(std::min(from, to));
        std::array<double, 3> end = solid.GetCorner(std::max(from, to));
        start[edges.size() % 3] += solid.Miss * solid.Unit;
        end[(edges.size() + 1) % 3] -= solid.Miss * solid.Unit;
        entry->second =
          model->AddEdge(unit, MakeArray(3, { start[0], start[1], start[2], end[0], end[1], end[2] }));
      }
      const double* start = uv[from < to ? i : (i + 1) % 3];
      const double* end = uv[from < to ? (i + 1) % 3 : i];
      model->AddCoedge(
        face, 0, entry->second, from > to, unit, MakeArray(2, { start[0], start[1], end[0], end[1] }));
    }
  }
  auto body = vtkSmartPointer<vtkNURBSDataSet>::New();
  body->SetModel(model);
  return body;
}

void CheckTetrahedron(const std::string& what, const Tetrahedron& solid, double height)
{
  const auto body = MakeBody(solid);
  const Real below = solid.GetVolumeBelow(height);
  const double at[3] = { solid.Middle[0] + solid.Unit * height, 0.0, 0.0 };
  vtkNew<vtkBuoyancy> buoyancy;
  vtkNew<vtkSolidSection> section;
  for (vtkPlaneCutBase* filter :
    { static_cast<vtkPlaneCutBase*>(buoyancy), static_cast<vtkPlaneCutBase*>(section) })
  {
    filter->SetBackend(vtkSurfaceIntegralBase::CPU);
    filter->SetInputDataObject(body);
    filter->SetPoint(at);
    filter->SetNormal(1.0, 0.0, 0.0);
    filter->Update();
  }
  // The doubles that are compared have half a unit in their last place.
  const auto rounding = static_cast<double>(1.2e-16L * solid.GetVolume());
  Check(what + ", displaced volume", static_cast<double>(below), buoyancy->GetDisplacedVolume(),
    buoyancy->GetDisplacedVolumeBound() + rounding, "the bound");
  Check(what + ", volume below a section", static_cast<double>(below), section->GetVolumeBelow(),
    section->GetVolumeBelowBound() + rounding, "the bound");
  Check(what + ", volume above a section", static_cast<double>(solid.GetVolume() - below),
    section->GetVolumeAbove(), section->GetVolumeAboveBound() + rounding, "the bound");

  vtkNew<vtkMatrix4x4> placement;
  for (int c = 0; c < 3; ++c)
  {
    placement->SetElement(c, 3, -solid.Middle[c]);
  }
  body->SetPlacement(placement);
  vtkNew<vtkSurfaceIntegralGPU> integral;
  integral->SetBackend(vtkSurfaceIntegralBase::CPU);
  integral->AddVolumeMoment("volume", 0, 0, 0);
  integral->SetInputDataObject(body);
  integral->Update();
  Check(what + ", volume of the placed", static_cast<double>(solid.GetVolume()),
    integral->GetIntegral("volume"), integral->GetIntegralBound("volume") + rounding, "the bound");
  // Rounding moves every point by 4 u of its distance for the section and 20 u for the integral.
  const double far = std::hypot(solid.Middle[0], solid.Middle[1], solid.Middle[2]);
  const double maximum = 1e3 * 1.2e-16 * (far + 1e2 * solid.Unit) * std::pow(1e2 * solid.Unit, 2.0) +
    1e3 * std::pow(solid.Miss * solid.Unit, 2.0) * (far + 1e2 * solid.Unit);
  CheckRange(what + ", bound of the displaced", 0.0, buoyancy->GetDisplacedVolumeBound(), maximum);
  CheckRange(what + ", bound of the placed", 0.0, integral->GetIntegralBound("volume"), maximum);
}
}

int TestFarBodies(int, char*[])
{
  std::mt19937 random(1);
  std::uniform_int_distribution<int> any(-9, 9);
  for (int i = 0; i < 240; ++i)
  {
    Tetrahedron solid;
    solid.Unit = std::exp2(-10 * (i % 3));
    const double distance = i % 2 == 0 ? 612616.0 : 867115.0;
    for (int c = 0; c < 3; ++c)
    {
      solid.Middle[c] = solid.Unit * std::floor(distance * (any(random) + 0.5));
    }
    bool isSound = false;
    while (!isSound)
    {
      for (std::array<int, 3>& corner : solid.Corners)
      {
        std::generate(corner.begin(), corner.end(), [&]() { return any(random); });
      }
      isSound = solid.GetDeterminant() != 0;
      for (int k = 0; k < 6; ++k)
      {
        const int pairs[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };
        isSound = isSound && solid.Corners[pairs[k][0]][0] != solid.Corners[pairs[k][1]][0];
      }
    }
    CheckTetrahedron("tetrahedron " + std::to_string(i), solid, 0.25);
    solid.Middle = {};
    solid.Miss = 1e-4;
    CheckTetrahedron("tetrahedron " + std::to_string(i) + " with open corners", solid, 0.25);
  }
  return Finish();
}
