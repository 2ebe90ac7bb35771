// What vtkMassPropertiesGPU draws: the glyph at the centre of mass, and the arrays to colour the bodies by.
#include "vtkMassPropertiesGPU.h"

#include "smBodyMeshes.h"
#include "smMassPropertyNames.h"
#include "smMassTolerance.h"
#include "vtkMassPropertiesGPUInternals.h"

#include "vtkAppendPolyData.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace
{
/// Appends a glyph whose cells have the colour of its result.
void Append(vtkAppendPolyData* glyphs, vtkPolyData* glyph, const std::string& status)
{
  const unsigned char green[3] = { 26, 179, 51 };
  const unsigned char red[3] = { 217, 26, 26 };
  const unsigned char* color = status == sm::names::StatusOk ? green : red;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName(sm::names::Color);
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

void AppendAxes(
  vtkAppendPolyData* glyphs, const sm::MassProperties& properties, double length, const std::string& status)
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
  vtkNew<vtkPolyData> axes;
  axes->SetPoints(points);
  axes->SetLines(lines);
  Append(glyphs, axes, status);
}
}

std::vector<sm::MeshArray> vtkMassPropertiesGPU::GetMeshArrays(const std::vector<sm::BodyIntegrals>& bodies)
{
  const std::vector<double>& volumes = this->Last->Volumes;
  const auto getFace = [&bodies](std::size_t body, std::size_t face)
  {
    const sm::FaceIntegrals* result = bodies[body].Faces ? &(*bodies[body].Faces)[face] : nullptr;
    return result && result->Error.empty() ? result : nullptr;
  };
  const auto getShare = [&bodies, &volumes, getFace](std::size_t body, std::size_t face)
  {
    const sm::FaceIntegrals* result = getFace(body, face);
    const double side = (bodies[body].InsideOut ? -1.0 : 1.0) * bodies[body].GetSide(face);
    return result ? side * (result->Face[sm::MassVolume] + result->Closing[sm::MassVolume]) / volumes[body]
                  : vtkMath::Nan();
  };
  // The paper's schemes measure no gap and have no bound.
  const bool scheme = this->HasScheme();
  const auto getGap = [scheme, getFace](std::size_t body, std::size_t face)
  {
    const sm::FaceIntegrals* result = scheme ? nullptr : getFace(body, face);
    return result ? result->MaxGap : vtkMath::Nan();
  };
  const auto getBound = [scheme, getFace](std::size_t body, std::size_t face)
  {
    const sm::FaceIntegrals* result = scheme ? nullptr : getFace(body, face);
    return result ? result->GetBound(sm::MassVolume) : vtkMath::Nan();
  };
  return { { sm::names::Volume, [&volumes](std::size_t body, std::size_t) { return volumes[body]; } },
    { sm::names::FaceShare, getShare }, { sm::names::FaceGap, getGap }, { sm::names::FaceBound, getBound } };
}

void vtkMassPropertiesGPU::MakeGlyphs(const std::vector<sm::BodyIntegrals>& bodies,
  const std::vector<sm::MassRow>& rows, const std::string& status, vtkPolyData* output)
{
  vtkNew<vtkAppendPolyData> glyphs;
  const auto add = [&](const sm::MassProperties& properties, double diagonal, const std::string& result)
  {
    if (!std::isfinite(properties.Center[0]) || !(diagonal > 0.0))
    {
      return;
    }
    if (this->GlyphScale > 0.0)
    {
      if (!this->Last->Sphere)
      {
        this->Last->Sphere = MakeUnitSphere();
      }
      Append(glyphs, MakeSphere(this->Last->Sphere, properties.Center, this->GlyphScale * diagonal), result);
    }
    if (this->ShowPrincipalAxes && !properties.AxesDegenerate)
    {
      AppendAxes(glyphs, properties, 0.3 * diagonal, result);
    }
  };
  vtkBoundingBox all;
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    sm::AddPlacedBox(bodies[i], all);
    if (this->GlyphPerSolid && bodies.size() > 1)
    {
      add(rows[i].Properties, 2.0 * sm::GetRadius(*bodies[i].Model), bodies[i].Status);
    }
  }
  add(this->Last->Row.Properties, all.IsValid() ? all.GetDiagonalLength() : 0.0, status);
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
