#include "smControlNet.h"

#include "smBodyScene.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace sm
{
namespace
{
const float PointSize = 11.0f; // pixels
const double SamePixels = 1.5; // closer points cover each other
const double LineColor[3] = { 0.45, 0.20, 0.10 };
const double PointColor[3] = { 160, 60, 25 };
const double HighlightColor[3] = { 255, 235, 130 };
const double SelectionColor[3] = { 255, 150, 20 };
}

ControlNet::ControlNet(vtkRenderer* renderer)
  : Renderer(renderer)
{
  this->Colors->SetNumberOfComponents(3);
  this->Points->GetPointData()->SetScalars(this->Colors);
  this->LineActor = AddActor(renderer, this->Lines, LineColor, 1.0);
  this->LineActor->GetProperty()->LightingOff();
  this->LineActor->GetProperty()->SetLineWidth(1.6f);
  this->PointActor = AddActor(renderer, this->Points, nullptr, 1.0);
  this->PointActor->GetProperty()->SetPointSize(PointSize);
  this->PointActor->GetProperty()->SetRenderPointsAsSpheres(true);
  for (const vtkSmartPointer<vtkActor>& actor : { this->LineActor, this->PointActor })
  {
    actor->PickableOff();
    actor->VisibilityOff();
  }
}

ControlNet::~ControlNet()
{
  this->Renderer->RemoveActor(this->LineActor);
  this->Renderer->RemoveActor(this->PointActor);
}

void ControlNet::Show(const EditedPart& part, int body, int face)
{
  this->Body = body;
  this->Face = body < 0 ? -1 : face;
  this->Highlight = this->Selection = -1;
  for (const vtkSmartPointer<vtkActor>& actor : { this->LineActor, this->PointActor })
  {
    actor->SetVisibility(this->IsShown());
  }
  if (this->IsShown())
  {
    this->Rebuild(part);
  }
}

void ControlNet::Follow(const EditedPart& part)
{
  if (this->IsShown())
  {
    this->Rebuild(part);
  }
}

void ControlNet::Rebuild(const EditedPart& part)
{
  const NURBSSurface& surface = part.GetFace(this->Body, this->Face)->Surface;
  this->Columns = surface.NumberOfControlPoints[0];
  this->Rows = surface.NumberOfControlPoints[1];
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> lines;
  for (int j = 0; j < this->Rows; ++j)
  {
    for (int i = 0; i < this->Columns; ++i)
    {
      const vtkIdType id = points->InsertNextPoint(ToWorld(part.GetBody(this->Body),
        surface.ControlPoints[static_cast<std::size_t>(i) + static_cast<std::size_t>(j) * this->Columns])
                                                     .data());
      vertices->InsertNextCell(1, &id);
      const vtkIdType left[2] = { id - 1, id };
      const vtkIdType below[2] = { id - this->Columns, id };
      if (i > 0)
      {
        lines->InsertNextCell(2, left);
      }
      if (j > 0)
      {
        lines->InsertNextCell(2, below);
      }
    }
  }
  this->Points->SetPoints(points);
  this->Points->SetVerts(vertices);
  this->Lines->SetPoints(points);
  this->Lines->SetLines(lines);
  this->Paint();
}

void ControlNet::Paint()
{
  const int count = this->Columns * this->Rows;
  this->Colors->SetNumberOfTuples(count);
  for (int i = 0; i < count; ++i)
  {
    this->Colors->SetTuple(i,
      i == this->Highlight     ? HighlightColor
        : i == this->Selection ? SelectionColor
                               : PointColor);
  }
  this->Colors->Modified();
  this->Points->Modified();
}

bool ControlNet::SetHighlight(int point)
{
  if (point == this->Highlight)
  {
    return false;
  }
  this->Highlight = point;
  this->Paint();
  return true;
}

bool ControlNet::SetSelection(int point)
{
  if (point == this->Selection)
  {
    return false;
  }
  this->Selection = point;
  this->Paint();
  return true;
}

int ControlNet::FindNear(double x, double y, double radius) const
{
  struct Candidate
  {
    int Point;
    double Distance;
    double Depth;
  };
  std::vector<Candidate> candidates;
  double minimum = radius;
  for (int i = 0; this->IsShown() && i < this->Columns * this->Rows; ++i)
  {
    double world[4] = { 0.0, 0.0, 0.0, 1.0 };
    this->Points->GetPoint(i, world);
    this->Renderer->SetWorldPoint(world);
    this->Renderer->WorldToDisplay();
    double display[3];
    this->Renderer->GetDisplayPoint(display);
    const double distance = std::hypot(display[0] - x, display[1] - y);
    if (distance <= radius && display[2] < 1.0)
    {
      candidates.push_back({ i, distance, display[2] });
      minimum = std::min(minimum, distance);
    }
  }
  int nearest = -1;
  double front = 1.0;
  for (const Candidate& candidate : candidates)
  {
    if (candidate.Distance <= minimum + SamePixels && candidate.Depth < front)
    {
      nearest = candidate.Point;
      front = candidate.Depth;
    }
  }
  return nearest;
}

Grip ControlNet::GetGrip(int point) const
{
  return { this->Body, this->Face, { point % this->Columns, point / this->Columns } };
}
}
