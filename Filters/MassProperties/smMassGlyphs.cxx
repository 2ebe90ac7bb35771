#include "smMassGlyphs.h"

#include "smBodyScales.h"
#include "smMassPropertyNames.h"

#include "vtkAppendPolyData.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace sm
{
namespace
{
/// Appends a glyph and gives its cells the colour of its result.
void Append(vtkAppendPolyData* glyphs, vtkPolyData* glyph, Status status)
{
  const unsigned char green[3] = { 26, 179, 51 };
  const unsigned char red[3] = { 217, 26, 26 };
  const unsigned char* color = status == Status::Ok ? green : red;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName(names::Color);
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(glyph->GetNumberOfCells());
  for (int i = 0; i < 3; ++i)
  {
    colors->FillComponent(i, color[i]);
  }
  vtkNew<vtkPolyData> colored;
  colored->ShallowCopy(glyph);
  colored->GetCellData()->SetScalars(colors);
  glyphs->AddInputData(colored);
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
  vtkNew<vtkAppendPolyData> glyphs;
  const auto add = [&](const MassProperties& properties, double diagonal, Status result)
  {
    if (!std::isfinite(properties.Center[0]) || !(diagonal > 0.0))
    {
      return;
    }
    if (options.Scale > 0.0)
    {
      this->UnitSphere = this->UnitSphere ? this->UnitSphere : MakeUnitSphere();
      Append(glyphs, MakeSphere(this->UnitSphere, properties.Center, options.Scale * diagonal), result);
    }
    if (options.ShowPrincipalAxes && !properties.AxesDegenerate)
    {
      Append(glyphs, MakeAxes(properties, 0.3 * diagonal), result);
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
  if (glyphs->GetNumberOfInputConnections(0) > 0)
  {
    glyphs->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    glyphs->Update();
    output->SetPoints(glyphs->GetOutput()->GetPoints());
    output->SetVerts(glyphs->GetOutput()->GetVerts());
    output->SetLines(glyphs->GetOutput()->GetLines());
    output->SetPolys(glyphs->GetOutput()->GetPolys());
    output->GetPointData()->ShallowCopy(glyphs->GetOutput()->GetPointData());
    output->GetCellData()->ShallowCopy(glyphs->GetOutput()->GetCellData());
  }
}
}
