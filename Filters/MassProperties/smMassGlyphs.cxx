#include "smMassGlyphs.h"

#include "smBodyScales.h"
#include "smMassPropertyNames.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sm
{
namespace
{
/// A sphere or axes, and the result whose colour they have.
struct Glyph
{
  vtkSmartPointer<vtkPolyData> Shape;
  Status Result;
};

/// The lines or the polygons of all glyphs; a single glyph's are shared if its points are the first ones.
vtkSmartPointer<vtkCellArray> JoinCells(
  const std::vector<Glyph>& glyphs, vtkCellArray* (vtkPolyData::*getCells)())
{
  vtkSmartPointer<vtkCellArray> cells;
  vtkIdType offset = 0;
  bool isShared = false;
  for (const Glyph& glyph : glyphs)
  {
    vtkCellArray* own = (glyph.Shape->*getCells)();
    if (own->GetNumberOfCells() > 0)
    {
      if (!cells && offset == 0)
      {
        cells = own;
        isShared = true;
      }
      else
      {
        auto joined = vtkSmartPointer<vtkCellArray>::New();
        if (isShared)
        {
          joined->DeepCopy(cells);
        }
        cells = isShared || !cells ? joined : cells;
        isShared = false;
        cells->Append(own, offset);
      }
    }
    offset += glyph.Shape->GetNumberOfPoints();
  }
  return cells;
}

vtkSmartPointer<vtkPoints> JoinPoints(const std::vector<Glyph>& glyphs)
{
  if (glyphs.size() == 1)
  {
    return glyphs[0].Shape->GetPoints();
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (const Glyph& glyph : glyphs)
  {
    points->InsertPoints(
      points->GetNumberOfPoints(), glyph.Shape->GetNumberOfPoints(), 0, glyph.Shape->GetPoints());
  }
  return points;
}

/// Normals, if all glyphs have them: axes have none.
vtkSmartPointer<vtkDataArray> JoinNormals(const std::vector<Glyph>& glyphs)
{
  vtkSmartPointer<vtkDataArray> normals;
  for (const Glyph& glyph : glyphs)
  {
    vtkDataArray* own = glyph.Shape->GetPointData()->GetNormals();
    if (!own || glyphs.size() == 1)
    {
      return own;
    }
    if (!normals)
    {
      normals.TakeReference(own->NewInstance());
      normals->SetName(own->GetName());
      normals->SetNumberOfComponents(3);
    }
    normals->InsertTuples(normals->GetNumberOfTuples(), own->GetNumberOfTuples(), 0, own);
  }
  return normals;
}

/// Colours of lines, then of polygons, as polydata numbers its cells.
vtkSmartPointer<vtkUnsignedCharArray> MakeColors(const std::vector<Glyph>& glyphs)
{
  const unsigned char green[3] = { 26, 179, 51 };
  const unsigned char red[3] = { 217, 26, 26 };
  vtkIdType cells = 0;
  for (const Glyph& glyph : glyphs)
  {
    cells += glyph.Shape->GetNumberOfCells();
  }
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName(names::Color);
  colors->SetNumberOfComponents(3);
  unsigned char* next = colors->WritePointer(0, 3 * cells);
  const auto fill = [&](const Glyph& glyph, vtkIdType count)
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      next = std::copy_n(glyph.Result == Status::Ok ? green : red, 3, next);
    }
  };
  for (const Glyph& glyph : glyphs)
  {
    fill(glyph, glyph.Shape->GetNumberOfLines());
  }
  for (const Glyph& glyph : glyphs)
  {
    fill(glyph, glyph.Shape->GetNumberOfPolys());
  }
  return colors;
}

/// Sets points and cells. vtkAppendPolyData, a pipeline of its own for every update, takes several times as long.
void Join(const std::vector<Glyph>& glyphs, vtkPolyData* output)
{
  output->SetPoints(JoinPoints(glyphs));
  output->SetLines(JoinCells(glyphs, &vtkPolyData::GetLines));
  output->SetPolys(JoinCells(glyphs, &vtkPolyData::GetPolys));
  if (const vtkSmartPointer<vtkDataArray> normals = JoinNormals(glyphs))
  {
    output->GetPointData()->SetNormals(normals);
  }
  output->GetCellData()->SetScalars(MakeColors(glyphs));
}

vtkSmartPointer<vtkPolyData> MakeUnitSphere()
{
  vtkNew<vtkSphereSource> source;
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->SetRadius(1.0);
  source->SetThetaResolution(32);
  source->SetPhiResolution(24);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakeSphere(vtkPolyData* unit, const std::array<double, 3>& center, double radius)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(unit->GetNumberOfPoints());
  for (vtkIdType i = 0; i < unit->GetNumberOfPoints(); ++i)
  {
    double p[3];
    unit->GetPoint(i, p);
    points->SetPoint(i, center[0] + radius * p[0], center[1] + radius * p[1], center[2] + radius * p[2]);
  }
  auto sphere = vtkSmartPointer<vtkPolyData>::New();
  sphere->ShallowCopy(unit);
  sphere->SetPoints(points);
  return sphere;
}

vtkSmartPointer<vtkPolyData> MakeAxes(const MassProperties& properties, double length)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkIdType ends[2];
    for (int side = 0; side < 2; ++side)
    {
      double p[3];
      for (int i = 0; i < 3; ++i)
      {
        p[i] = properties.Center[i] + (side ? length : -length) * properties.Axes[3 * axis + i];
      }
      ends[side] = points->InsertNextPoint(p);
    }
    lines->InsertNextCell(2, ends);
  }
  auto axes = vtkSmartPointer<vtkPolyData>::New();
  axes->SetPoints(points);
  axes->SetLines(lines);
  return axes;
}
}

void MassGlyphs::Make(const std::vector<BodyIntegrals>& bodies, const MassAnalysis& analysis, Status status,
  const MassGlyphOptions& options, vtkPolyData* output)
{
  std::vector<Glyph> glyphs;
  const auto add = [&](const MassProperties& properties, double diagonal, Status result)
  {
    if (!std::isfinite(properties.Center[0]) || !(diagonal > 0.0))
    {
      return;
    }
    if (options.Scale > 0.0)
    {
      this->UnitSphere = this->UnitSphere ? this->UnitSphere : MakeUnitSphere();
      glyphs.push_back({ MakeSphere(this->UnitSphere, properties.Center, options.Scale * diagonal), result });
    }
    if (options.ShowPrincipalAxes && !properties.AxesDegenerate)
    {
      glyphs.push_back({ MakeAxes(properties, 0.3 * diagonal), result });
    }
  };
  vtkBoundingBox all;
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    AddPlacedBox(bodies[i], all);
    if (options.PerSolid && bodies.size() > 1)
    {
      add(analysis.Rows[i].Properties, 2.0 * GetRadius(*bodies[i].Model), bodies[i].Status);
    }
  }
  add(analysis.Total.Properties, all.IsValid() ? all.GetDiagonalLength() : 0.0, status);
  if (!glyphs.empty())
  {
    Join(glyphs, output);
  }
}
}
