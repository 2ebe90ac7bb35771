#include "Detail/smSectionMesh.h"

#include "smSectionNames.h"
#include "smVector.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkContourTriangulator.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNURBSDataSet.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <map>
#include <vector>

namespace sm
{
namespace
{
constexpr const char* ColorName = "Color";
constexpr unsigned char CapColor[3] = { 224, 122, 60 };
constexpr unsigned char PlainColor[3] = { 190, 190, 195 };

/// Clips polygons at a plane, and collects the segments in which they cross it. Points on the plane count as
/// above it. Points of different polygons are not merged, because their normals differ. Polygons that share
/// an edge get bitwise the same point on it, because its ends are always taken in the same order, so that the
/// segments of a closed mesh form closed loops.
class PlaneClipper
{
public:
  PlaneClipper(vtkPolyData* mesh, vtkPlane* plane)
    : Mesh(mesh)
    , Plane(plane)
    , Normals(mesh->GetPointData()->GetNormals())
    , Kept(static_cast<std::size_t>(mesh->GetNumberOfPoints()), -1)
  {
    this->Points->SetDataTypeToDouble();
    this->CutPoints->SetDataTypeToDouble();
    this->CutNormals->SetNumberOfComponents(3);
    this->CutNormals->SetName("Normals");
  }

  void AddPolygon(vtkIdType cell, const vtkIdType* ids, vtkIdType count)
  {
    std::vector<vtkIdType> below;
    std::vector<vtkIdType> crossings;
    bool startsFalling = false;
    for (vtkIdType i = 0; i < count; ++i)
    {
      const vtkIdType ends[2] = { ids[i], ids[(i + 1) % count] };
      Point3 a;
      Point3 b;
      this->Mesh->GetPoint(ends[0], a.data());
      this->Mesh->GetPoint(ends[1], b.data());
      const bool falls = this->IsBelow(b);
      if (this->IsBelow(a))
      {
        below.push_back(this->Keep(ends[0], a));
      }
      if (this->IsBelow(a) != falls)
      {
        startsFalling = crossings.empty() ? falls : startsFalling;
        crossings.push_back(this->GetCrossing(std::min(a, b), std::max(a, b)));
        below.push_back(this->AddCutPoint(crossings.back(), ends));
      }
    }
    if (below.size() > 2)
    {
      this->Polygons->InsertNextCell(static_cast<vtkIdType>(below.size()), below.data());
      this->Cells.push_back(cell);
    }
    for (std::size_t i = 1; i < crossings.size(); i += 2)
    {
      // The segment runs from the crossing at which the polygon descends through the plane to the one at
      // which it ascends: the section is on its left, seen from above.
      const vtkIdType ends[2] = { crossings[startsFalling ? i - 1 : i],
        crossings[startsFalling ? i : i - 1] };
      if (ends[0] != ends[1])
      {
        this->Lines->InsertNextCell(2, ends);
      }
    }
  }

  vtkSmartPointer<vtkPolyData> GetSegments() const
  {
    auto segments = vtkSmartPointer<vtkPolyData>::New();
    segments->SetPoints(this->Points);
    segments->SetLines(this->Lines);
    return segments;
  }

  /// Returns the polygons below the plane; `cells` are those of the mesh that they are parts of.
  vtkSmartPointer<vtkPolyData> GetBelow(std::vector<vtkIdType>& cells) const
  {
    auto below = vtkSmartPointer<vtkPolyData>::New();
    below->SetPoints(this->CutPoints);
    below->SetPolys(this->Polygons);
    if (this->Normals)
    {
      below->GetPointData()->SetNormals(this->CutNormals);
    }
    cells = this->Cells;
    return below;
  }

private:
  bool IsBelow(const Point3& p) const { return this->Plane->EvaluateFunction(p[0], p[1], p[2]) < 0.0; }

  vtkIdType Insert(const Point3& p, const double normal[3])
  {
    this->CutNormals->InsertNextTuple(normal);
    return this->CutPoints->InsertNextPoint(p.data());
  }

  vtkIdType Keep(vtkIdType id, const Point3& p)
  {
    vtkIdType& kept = this->Kept[static_cast<std::size_t>(id)];
    if (kept < 0)
    {
      double normal[3] = { 0.0, 0.0, 0.0 };
      if (this->Normals)
      {
        this->Normals->GetTuple(id, normal);
      }
      kept = this->Insert(p, normal);
    }
    return kept;
  }

  /// Returns a point of the polygon's own at the crossing, with the mean of the normals at the edge's ends.
  vtkIdType AddCutPoint(vtkIdType crossing, const vtkIdType ends[2])
  {
    Point3 p;
    this->Points->GetPoint(crossing, p.data());
    double normal[3] = { 0.0, 0.0, 0.0 };
    for (int end = 0; this->Normals && end < 2; ++end)
    {
      for (int c = 0; c < 3; ++c)
      {
        normal[c] += this->Normals->GetComponent(ends[end], c);
      }
    }
    vtkMath::Normalize(normal);
    return this->Insert(p, normal);
  }

  vtkIdType GetCrossing(const Point3& a, const Point3& b)
  {
    const double atA = this->Plane->EvaluateFunction(a[0], a[1], a[2]);
    const double atB = this->Plane->EvaluateFunction(b[0], b[1], b[2]);
    const double share = atA / (atA - atB);
    Point3 p;
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

  vtkPolyData* Mesh;
  vtkPlane* Plane;
  vtkDataArray* Normals;
  std::vector<vtkIdType> Kept;
  vtkNew<vtkPoints> CutPoints;
  vtkNew<vtkFloatArray> CutNormals;
  vtkNew<vtkCellArray> Polygons;
  std::vector<vtkIdType> Cells;
  std::map<Point3, vtkIdType> Places;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
};

/// Returns the colours of the mesh's cells, or null.
vtkDataArray* FindColors(vtkPolyData* mesh)
{
  vtkDataArray* colors = mesh->GetCellData()->GetArray(ColorName);
  return colors && colors->GetNumberOfComponents() >= 3 ? colors : nullptr;
}

/// Sets the cell arrays of a part of the output; `sources` are the cells of `mesh` whose colours and faces
/// the part's cells get. The section has none.
void SetCellArrays(
  vtkPolyData* part, int solid, bool isCap, vtkPolyData* mesh, const std::vector<vtkIdType>& sources)
{
  vtkDataArray* const colors = isCap ? nullptr : FindColors(mesh);
  vtkDataArray* const indices =
    isCap ? nullptr : mesh->GetCellData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName());
  const vtkIdType cells = part->GetNumberOfCells();
  vtkNew<vtkIntArray> solids;
  solids->SetName(names::SectionSolid);
  solids->SetNumberOfValues(cells);
  solids->FillValue(solid);
  vtkNew<vtkIntArray> caps;
  caps->SetName(names::SectionCap);
  caps->SetNumberOfValues(cells);
  caps->FillValue(isCap ? 1 : 0);
  vtkNew<vtkIntArray> faces;
  faces->SetName(vtkNURBSDataSet::FaceIndexArrayName());
  faces->SetNumberOfValues(cells);
  vtkNew<vtkUnsignedCharArray> shown;
  shown->SetName(ColorName);
  shown->SetNumberOfComponents(3);
  shown->SetNumberOfTuples(cells);
  const unsigned char* plain = isCap ? CapColor : PlainColor;
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    faces->SetValue(cell,
      indices ? static_cast<int>(indices->GetComponent(sources[static_cast<std::size_t>(cell)], 0)) : -1);
    for (int c = 0; c < 3; ++c)
    {
      shown->SetComponent(
        cell, c, colors ? colors->GetComponent(sources[static_cast<std::size_t>(cell)], c) : plain[c]);
    }
  }
  part->GetCellData()->Initialize();
  part->GetCellData()->AddArray(solids);
  part->GetCellData()->AddArray(caps);
  part->GetCellData()->AddArray(faces);
  part->GetCellData()->AddArray(shown);
}

/// Returns the section as polygons; null if the segments do not bound any.
vtkSmartPointer<vtkPolyData> MakeCap(vtkPolyData* segments, vtkPlane* plane)
{
  vtkNew<vtkContourTriangulator> triangulator;
  triangulator->TriangulationErrorDisplayOff();
  triangulator->SetInputData(segments);
  triangulator->Update();
  vtkPolyData* polygons = triangulator->GetOutput();
  if (triangulator->GetTriangulationError() != 0 || polygons->GetNumberOfPolys() == 0)
  {
    return nullptr;
  }
  auto cap = vtkSmartPointer<vtkPolyData>::New();
  cap->SetPoints(polygons->GetPoints());
  cap->SetPolys(polygons->GetPolys());
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
  return cap;
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
  PlaneClipper clipper(mesh, plane);
  // Cells are numbered vertices and lines first.
  const vtkIdType first = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  const auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    clipper.AddPolygon(first + cells->GetCurrentCellId(), ids, count);
  }
  std::vector<vtkIdType> sources;
  const vtkSmartPointer<vtkPolyData> below = clipper.GetBelow(sources);
  SetCellArrays(below, solid, false, mesh, sources);
  vtkNew<vtkAppendPolyData> append;
  append->AddInputData(below);
  const vtkSmartPointer<vtkPolyData> segments = clipper.GetSegments();
  if (segments->GetNumberOfLines() > 0)
  {
    const vtkSmartPointer<vtkPolyData> cap = MakeCap(segments, plane);
    hasCap = cap != nullptr;
    if (hasCap)
    {
      SetCellArrays(cap, solid, true, mesh, {});
      append->AddInputData(cap);
    }
  }
  append->Update();
  result->ShallowCopy(append->GetOutput());
  return result;
}
}
