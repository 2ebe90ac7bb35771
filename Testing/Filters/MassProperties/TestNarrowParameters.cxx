// Solids whose parameters, knots or vertices differ by no more than the doubles that hold them: the bounds
// count what that is in space.
#include "smTesting.h"

#include <vtkDoubleArray.h>
#include <vtkMassPropertiesGPU.h>
#include <vtkNURBSDataSet.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkTrimmedNURBSModel.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace
{
using namespace smtest;
using Point = std::array<double, 3>;
using Parameters = std::array<double, 2>;

vtkSmartPointer<vtkDoubleArray> MakeArray(int components, const double* values, std::size_t count)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetNumberOfComponents(components);
  for (std::size_t i = 0; i < count; ++i)
  {
    array->InsertNextValue(values[i]);
  }
  return array;
}

vtkSmartPointer<vtkDoubleArray> MakeArray(const std::vector<double>& values)
{
  return MakeArray(1, values.data(), values.size());
}

template <std::size_t N>
vtkSmartPointer<vtkDoubleArray> MakeArray(const std::vector<std::array<double, N>>& values)
{
  return MakeArray(static_cast<int>(N), values.front().data(), N * values.size());
}

/// A prism of width 1 in x over a polygon in y and z, whose faces but those of x = 0 and x = 1 are one
/// surface of degree 1 around it.
struct Prism
{
  /// Corners, counter-clockwise as seen from x > 0, and the knot of each; the knot after the last is that of
  /// the first again.
  std::vector<Parameters> Corners;
  std::vector<double> Knots;
  /// Parameters of x = 0 and x = 1.
  double Start = 0.0;
  double End = 1.0;
  /// By how many units in the last place the trim curve of x = 1 begins later, in both parameters of the
  /// surface around.
  int Late = 0;
  Point Shift{};
  /// Distance by which the ends of edges miss each other.
  double Miss = 0.0;

  Point GetPoint(double x, std::size_t i) const
  {
    const Parameters& yz = this->Corners[i % this->Corners.size()];
    return { this->Shift[0] + x, this->Shift[1] + yz[0], this->Shift[2] + yz[1] };
  }

  vtkSmartPointer<vtkNURBSDataSet> Make() const
  {
    const std::size_t count = this->Corners.size();
    vtkNew<vtkTrimmedNURBSModel> model;
    std::vector<Point> net;
    std::vector<Point> rings[2];
    std::vector<double> knots = { this->Knots.front() };
    for (std::size_t i = 0; i <= count; ++i)
    {
      for (int side = 0; side < 2; ++side)
      {
        net.push_back(this->GetPoint(side, i));
        rings[side].push_back(this->GetPoint(side, i));
      }
      knots.push_back(this->Knots[i]);
    }
    knots.push_back(this->Knots.back());
    const auto breaks = MakeArray(this->Knots);
    const auto unit = MakeArray(std::vector<double>{ 0, 1 });
    const double u[2] = { this->Start, this->End };
    const double v[2] = { this->Knots.front(), this->Knots.back() };
    const int around = model->AddFace(
      1, MakeArray(std::vector<double>{ u[0], u[0], u[1], u[1] }), 1, MakeArray(knots), MakeArray(net), true);
    int ring[2];
    for (int side = 0; side < 2; ++side)
    {
      rings[side].front()[1] += this->Miss;
      rings[side].back()[0] += this->Miss;
      ring[side] = model->AddEdge(breaks, MakeArray(rings[side]));
    }
    Point seam[2] = { this->GetPoint(0, 0), this->GetPoint(1, 0) };
    seam[0][2] += this->Miss;
    const int straight = model->AddEdge(unit, MakeArray(std::vector<Point>{ seam[0], seam[1] }));
    double late = v[0];
    for (int i = 0; i < this->Late; ++i)
    {
      late = std::nextafter(late, v[1]);
    }
    std::vector<Parameters> lines[2];
    for (int side = 0; side < 2; ++side)
    {
      for (std::size_t i = 0; i <= count; ++i)
      {
        lines[side].push_back({ u[side], i == 0 && side == 1 ? late : this->Knots[i] });
      }
    }
    model->AddCoedge(
      around, 0, straight, false, unit, MakeArray(std::vector<Parameters>{ { u[0], v[0] }, { u[1], v[0] } }));
    model->AddCoedge(around, 0, ring[1], false, breaks, MakeArray(lines[1]));
    model->AddCoedge(
      around, 0, straight, true, unit, MakeArray(std::vector<Parameters>{ { u[0], v[1] }, { u[1], v[1] } }));
    model->AddCoedge(around, 0, ring[0], true, breaks, MakeArray(lines[0]));
    for (int side = 0; side < 2; ++side)
    {
      std::vector<Point> plane;
      std::vector<Parameters> border;
      for (int k = 0; k < 4; ++k)
      {
        plane.push_back({ this->Shift[0] + side, this->Shift[1] + (k % 2 == 0 ? -4.0 : 4.0),
          this->Shift[2] + (k < 2 ? -4.0 : 4.0) });
      }
      for (std::size_t i = 0; i <= count; ++i)
      {
        border.push_back(this->Corners[i % count]);
      }
      const auto wide = MakeArray(std::vector<double>{ -4, -4, 4, 4 });
      const int face = model->AddFace(1, wide, 1, wide, MakeArray(plane), side == 0);
      model->AddCoedge(face, 0, ring[side], false, breaks, MakeArray(border));
    }
    auto body = vtkSmartPointer<vtkNURBSDataSet>::New();
    body->SetModel(model);
    return body;
  }
};

/// Results of the CPU backend.
struct Results
{
  vtkNew<vtkMassPropertiesGPU> Filter;

  explicit Results(const Prism& prism)
  {
    this->Filter->SetBackend(vtkSurfaceIntegralBase::CPU);
    this->Filter->SetInputDataObject(prism.Make());
    this->Filter->Update();
  }
};

void CheckPrism(const std::string& what, const Prism& prism, double volume, double area)
{
  const Results results(prism);
  CheckEqual(what + ", status", "ok", results.Filter->GetStatus());
  Check(
    what + ", volume", volume, results.Filter->GetVolume(), results.Filter->GetVolumeBound(), "the bound");
  CheckRange(what + ", bound", 0.0, results.Filter->GetVolumeBound(), 1e-11);
  Check(what + ", area", area, results.Filter->GetSurfaceArea(), results.Filter->GetSurfaceAreaBound(),
    "the bound");
}

/// A surface far along its parameters: a corner that is off by a unit in the last place may be a wide strip.
void CheckLateCorners()
{
  for (const double width : { 1.0, 1e-3, 1e-6, 1e-9 })
  {
    for (const int late : { 0, 1, 2 })
    {
      Prism prism;
      prism.Corners = { { 0, 0 }, { 1, 0 }, { 1, 2 }, { 0, 2 } };
      for (int i = 0; i <= 4; ++i)
      {
        prism.Knots.push_back(1048576.0 + i * width);
      }
      prism.Start = 1048576.0;
      prism.End = 1048576.0 + width;
      prism.Late = late;
      CheckPrism(
        "corner late by " + std::to_string(late) + ", width " + std::to_string(width), prism, 2.0, 10.0);
    }
  }
}

/// Knots that are neighbouring doubles, with a wall between them. A groove's walls leave the surface closed
/// if both are lost.
void CheckNeighbouringKnots()
{
  for (const double knot : { 0.25, 0.3, 0.30000000000000004, 0.7 })
  {
    for (const int ulps : { 1, 2, 3, 5 })
    {
      Prism prism;
      prism.Corners = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1.5, 1 }, { 1.5, 0.5 }, { 0.5, 0.5 }, { 0.5, 1 },
        { 0, 1 } };
      double next[2] = { knot, knot + 0.2 };
      prism.Knots = { 0, 0.0625, 0.125, knot };
      for (int i = 0; i < 2 * ulps; ++i)
      {
        next[i % 2] = std::nextafter(next[i % 2], 1.0);
      }
      prism.Knots.insert(prism.Knots.end(), { next[0], knot + 0.2, next[1], 0.9375, 1.0 });
      CheckPrism(
        "knots " + std::to_string(knot) + " and " + std::to_string(ulps) + " after", prism, 1.5, 10.0);
    }
  }
}

/// Edges that do not meet leave a hole in the boundary: the volume depends on the origin, by no more than the
/// bounds.
void CheckOpenCorners()
{
  for (const double miss : { 1e-6, 1e-5, 1e-4 })
  {
    double volume = 0.0;
    double bound = 0.0;
    for (const double distance : { 0.0, 100.0 })
    {
      Prism prism;
      prism.Corners = { { 0, 0 }, { 1, 0 }, { 1, 2 }, { 0, 2 } };
      prism.Knots = { 0, 1, 2, 3, 4 };
      prism.Miss = miss;
      prism.Shift = { distance, 3.0 * distance, -2.0 * distance };
      const Results results(prism);
      const std::string what =
        "edges that miss by " + std::to_string(miss) + " at " + std::to_string(distance);
      if (distance > 0.0)
      {
        Check(what + ", volume", volume, results.Filter->GetVolume(),
          bound + results.Filter->GetVolumeBound(), "both bounds");
        CheckRange(
          what + ", bound", 0.0, results.Filter->GetVolumeBound(), 100.0 * miss * miss * distance + 1e-10);
      }
      volume = results.Filter->GetVolume();
      bound = results.Filter->GetVolumeBound();
    }
  }
}
}

int TestNarrowParameters(int, char*[])
{
  CheckLateCorners();
  CheckNeighbouringKnots();
  CheckOpenCorners();
  return Finish();
}
