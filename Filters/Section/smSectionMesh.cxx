#include "smSectionMesh.h"

#include "smSectionNames.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkClipPolyData.h"
#include "vtkContourTriangulator.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace sm
{
namespace
{
using Point = std::array<double, 3>;

constexpr const char* ColorName = "Color";
constexpr unsigned char CapColor[3] = { 224, 122, 60 };
constexpr unsigned char PlainColor[3] = { 190, 190, 195 };

/// The segments in which polygons cross a plane. Points on the plane count as above it. Polygons that share an edge get the same
/// point on it to the bit, because its ends are taken in one order, so that the segments of a closed mesh are closed loops.
class SegmentFinder
{
public:
  explicit SegmentFinder(vtkPlane* plane)
    : Plane(plane)
  {
    this->Points->SetDataTypeToDouble();
  }

  void AddPolygon(vtkPoints* points, const vtkIdType* ids, vtkIdType count)
  {
    std::vector<vtkIdType> crossings;
    for (vtkIdType i = 0; i < count; ++i)
    {
      Point a;
      Point b;
      points->GetPoint(ids[i], a.data());
      points->GetPoint(ids[(i + 1) % count], b.data());
      const bool falls = this->IsBelow(b);
      if (this->IsBelow(a) != falls)
      {
        crossings.push_back(this->GetCrossing(std::min(a, b), std::max(a, b)));
        // A segment runs from where its polygon rises through the plane to where it falls.
        if (crossings.size() == 1 && falls)
        {
          this->StartsFalling = true;
        }
      }
    }
    for (std::size_t i = 1; i < crossings.size(); i += 2)
    {
      vtkIdType ends[2] = { crossings[i - 1], crossings[i] };
      if (this->StartsFalling)
      {
        std::swap(ends[0], ends[1]);
      }
      if (ends[0] != ends[1])
      {
        this->Lines->InsertNextCell(2, ends);
      }
    }
    this->StartsFalling = false;
  }

  vtkSmartPointer<vtkPolyData> GetSegments() const
  {
    auto segments = vtkSmartPointer<vtkPolyData>::New();
    segments->SetPoints(this->Points);
    segments->SetLines(this->Lines);
    return segments;
  }

private:
  bool IsBelow(const Point& p) const { return this->Plane->EvaluateFunction(p[0], p[1], p[2]) < 0.0; }

  vtkIdType GetCrossing(const Point& a, const Point& b)
  {
    const double atA = this->Plane->EvaluateFunction(a[0], a[1], a[2]);
    const double atB = this->Plane->EvaluateFunction(b[0], b[1], b[2]);
    const double share = atA / (atA - atB);
    Point p;
    for (int c = 0; c < 3; ++c)
    {
      p[c] = atB == 0.0 ? b[c] : a[c] + share * (b[c] - a[c]);
    }
    const auto [entry, isNew] = this->Places.emplace(p, this->Points->GetNumberOfPoints());
    if (isNew)
    {
      this->Points->InsertNextPoint(p.data());
    }
    return entry->second;
  }

  vtkPlane* Plane;
  bool StartsFalling = false;
  std::map<Point, vtkIdType> Places;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
};

/// Sets the cell arrays of a part of the output.
void SetCellArrays(vtkPolyData* part, int solid, bool isCap, vtkDataArray* colors)
{
  const vtkIdType cells = part->GetNumberOfCells();
  vtkNew<vtkIntArray> solids;
  solids->SetName(names::SectionSolid);
  solids->SetNumberOfValues(cells);
  solids->FillValue(solid);
  vtkNew<vtkIntArray> caps;
  caps->SetName(names::SectionCap);
  caps->SetNumberOfValues(cells);
  caps->FillValue(isCap ? 1 : 0);
  vtkNew<vtkUnsignedCharArray> shown;
  shown->SetName(ColorName);
  shown->SetNumberOfComponents(3);
  shown->SetNumberOfTuples(cells);
  const unsigned char* plain = isCap ? CapColor : PlainColor;
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    for (int c = 0; c < 3; ++c)
    {
      shown->SetComponent(cell, c, colors ? colors->GetComponent(cell, c) : plain[c]);
    }
  }
  part->GetCellData()->Initialize();
  part->GetCellData()->AddArray(solids);
  part->GetCellData()->AddArray(caps);
  part->GetCellData()->AddArray(shown);
}

/// Returns the part of the mesh below the plane, with normals and without other arrays of its points.
vtkSmartPointer<vtkPolyData> Clip(vtkPolyData* mesh, vtkPlane* plane, int solid)
{
  vtkNew<vtkPolyData> faces;
  faces->SetPoints(mesh->GetPoints());
  faces->SetPolys(mesh->GetPolys());
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  if (normals)
  {
    faces->GetPointData()->SetNormals(normals);
  }
  vtkDataArray* colors = mesh->GetCellData()->GetArray(ColorName);
  const bool hasColors = colors && colors->GetNumberOfComponents() >= 3 &&
    colors->GetNumberOfTuples() == faces->GetNumberOfCells();
  if (hasColors)
  {
    faces->GetCellData()->AddArray(colors);
  }
  vtkNew<vtkClipPolyData> clip;
  clip->SetInputData(faces);
  clip->SetClipFunction(plane);
  clip->InsideOutOn();
  clip->Update();
  auto below = vtkSmartPointer<vtkPolyData>::New();
  below->ShallowCopy(clip->GetOutput());
  const vtkSmartPointer<vtkDataArray> clipped =
    hasColors ? below->GetCellData()->GetArray(ColorName) : nullptr;
  SetCellArrays(below, solid, false, clipped);
  return below;
}
}

vtkSmartPointer<vtkPolyData> MakeSectionMesh(vtkPolyData* mesh, vtkPlane* plane, int solid, bool& hasCap)
{
  hasCap = true;
  auto result = vtkSmartPointer<vtkPolyData>::New();
  if (!mesh || mesh->GetNumberOfPolys() == 0)
  {
    return result;
  }
  vtkNew<vtkAppendPolyData> append;
  const vtkSmartPointer<vtkPolyData> below = Clip(mesh, plane, solid);
  append->AddInputData(below);
  SegmentFinder finder(plane);
  const auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    finder.AddPolygon(mesh->GetPoints(), ids, count);
  }
  const vtkSmartPointer<vtkPolyData> segments = finder.GetSegments();
  if (segments->GetNumberOfLines() > 0)
  {
    vtkNew<vtkContourTriangulator> triangulator;
    triangulator->TriangulationErrorDisplayOff();
    triangulator->SetInputData(segments);
    triangulator->Update();
    hasCap = triangulator->GetTriangulationError() == 0 && triangulator->GetOutput()->GetNumberOfPolys() > 0;
    if (hasCap)
    {
      vtkNew<vtkPolyData> cap;
      cap->SetPoints(triangulator->GetOutput()->GetPoints());
      cap->SetPolys(triangulator->GetOutput()->GetPolys());
      vtkNew<vtkFloatArray> normals;
      normals->SetName("Normals");
      normals->SetNumberOfComponents(3);
      normals->SetNumberOfTuples(cap->GetNumberOfPoints());
      double normal[3];
      plane->GetNormal(normal);
      for (vtkIdType i = 0; i < cap->GetNumberOfPoints(); ++i)
      {
        normals->SetTuple(i, normal);
      }
      cap->GetPointData()->SetNormals(normals);
      SetCellArrays(cap, solid, true, nullptr);
      append->AddInputData(cap);
    }
  }
  append->Update();
  result->ShallowCopy(append->GetOutput());
  return result;
}
}
