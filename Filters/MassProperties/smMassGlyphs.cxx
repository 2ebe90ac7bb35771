#include "Detail/smMassGlyphs.h"

#include "smBodyScales.h"
#include "smMassPropertyNames.h"
#include "smSphereMesh.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sm
{
namespace
{
/// A sphere about a centre of mass, or the principal axes there.
struct Glyph
{
  const MassProperties* Properties;
  bool IsSphere;
  /// Radius of the sphere, or length of an axis on either side.
  double Size;
  /// The result whose colour it has.
  Status Result;
  /// Index of the first of its points, which are those of the unit sphere or the ends of the axes.
  vtkIdType FirstPoint;
};

constexpr vtkIdType AxisEnds = 6;

vtkSmartPointer<vtkPolyData> MakeUnitSphere()
{
  const double origin[3] = { 0.0, 0.0, 0.0 };
  return MakeSphereMesh(origin, 1.0, 32, 24);
}

vtkSmartPointer<vtkPoints> MakePoints(
  const std::vector<Glyph>& glyphs, vtkPolyData* sphere, vtkIdType count, columns::KeptArrays& arrays)
{
  auto* values = arrays.Get<vtkDoubleArray>("Points", 3, count);
  double* next = values->GetPointer(0);
  for (const Glyph& glyph : glyphs)
  {
    const std::array<double, 3>& center = glyph.Properties->Center;
    if (glyph.IsSphere)
    {
      const double* unit = vtkDoubleArray::FastDownCast(sphere->GetPoints()->GetData())->GetPointer(0);
      for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i, unit += 3)
      {
        for (int c = 0; c < 3; ++c)
        {
          *next++ = center[c] + glyph.Size * unit[c];
        }
      }
      continue;
    }
    for (int end = 0; end < AxisEnds; ++end)
    {
      const double length = end % 2 == 0 ? -glyph.Size : glyph.Size;
      for (int i = 0; i < 3; ++i)
      {
        *next++ = center[i] + length * glyph.Properties->Axes[3 * (end / 2) + i];
      }
    }
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(values);
  return points;
}

vtkSmartPointer<vtkCellArray> MakeLines(const std::vector<Glyph>& glyphs)
{
  auto lines = vtkSmartPointer<vtkCellArray>::New();
  for (const Glyph& glyph : glyphs)
  {
    for (vtkIdType end = 0; end < AxisEnds && !glyph.IsSphere; end += 2)
    {
      const vtkIdType ends[2] = { glyph.FirstPoint + end, glyph.FirstPoint + end + 1 };
      lines->InsertNextCell(2, ends);
    }
  }
  return lines;
}

/// The polygons of all spheres; those of a single one, which is the first glyph, are shared.
vtkSmartPointer<vtkCellArray> MakePolygons(
  const std::vector<Glyph>& glyphs, vtkPolyData* sphere, vtkIdType spheres)
{
  if (spheres == 1)
  {
    return sphere->GetPolys();
  }
  auto polygons = vtkSmartPointer<vtkCellArray>::New();
  for (const Glyph& glyph : glyphs)
  {
    if (glyph.IsSphere)
    {
      polygons->Append(sphere->GetPolys(), glyph.FirstPoint);
    }
  }
  return polygons;
}

vtkSmartPointer<vtkDataArray> MakeNormals(vtkPolyData* sphere, vtkIdType spheres)
{
  vtkDataArray* own = sphere->GetPointData()->GetNormals();
  if (spheres == 1)
  {
    return own;
  }
  vtkSmartPointer<vtkDataArray> normals;
  normals.TakeReference(own->NewInstance());
  normals->SetName(own->GetName());
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < spheres; ++i)
  {
    normals->InsertTuples(normals->GetNumberOfTuples(), own->GetNumberOfTuples(), 0, own);
  }
  return normals;
}

/// Colours of lines, then of polygons, as polydata numbers its cells.
vtkUnsignedCharArray* MakeColors(
  const std::vector<Glyph>& glyphs, vtkIdType lines, vtkIdType polygons, columns::KeptArrays& arrays)
{
  const unsigned char green[3] = { 26, 179, 51 };
  const unsigned char red[3] = { 217, 26, 26 };
  auto* colors = arrays.Get<vtkUnsignedCharArray>(names::Color, 3, lines + polygons);
  const auto spheres =
    std::count_if(glyphs.begin(), glyphs.end(), [](const Glyph& glyph) { return glyph.IsSphere; });
  unsigned char* next = colors->GetPointer(0);
  for (const bool isSphere : { false, true })
  {
    for (const Glyph& glyph : glyphs)
    {
      const vtkIdType cells = glyph.IsSphere != isSphere ? 0 : isSphere ? polygons / spheres : AxisEnds / 2;
      for (vtkIdType cell = 0; cell < cells; ++cell)
      {
        next = std::copy_n(glyph.Result == Status::Ok ? green : red, 3, next);
      }
    }
  }
  return colors;
}

/// Sets points and cells. vtkAppendPolyData, a pipeline of its own for every update, takes several times as
/// long.
void Join(
  const std::vector<Glyph>& glyphs, vtkPolyData* sphere, columns::KeptArrays& arrays, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(glyphs.size());
  const vtkIdType spheres =
    std::count_if(glyphs.begin(), glyphs.end(), [](const Glyph& glyph) { return glyph.IsSphere; });
  const Glyph& last = glyphs.back();
  const vtkIdType points = last.FirstPoint + (last.IsSphere ? sphere->GetNumberOfPoints() : AxisEnds);
  output->SetPoints(MakePoints(glyphs, sphere, points, arrays));
  if (spheres < count)
  {
    output->SetLines(MakeLines(glyphs));
  }
  if (spheres > 0)
  {
    output->SetPolys(MakePolygons(glyphs, sphere, spheres));
  }
  // Axes have no normals.
  if (spheres == count)
  {
    output->GetPointData()->SetNormals(MakeNormals(sphere, spheres));
  }
  output->GetCellData()->SetScalars(
    MakeColors(glyphs, output->GetNumberOfLines(), output->GetNumberOfPolys(), arrays));
}
}

void MassGlyphs::Make(const std::vector<BodyIntegrals>& bodies, const MassAnalysis& analysis, Status status,
  const MassGlyphOptions& options, columns::KeptArrays& arrays, vtkPolyData* output)
{
  std::vector<Glyph> glyphs;
  vtkIdType points = 0;
  const auto add = [&](const MassProperties& properties, double diagonal, Status result)
  {
    if (!std::isfinite(properties.Center[0]) || !(diagonal > 0.0))
    {
      return;
    }
    if (options.Scale > 0.0)
    {
      if (!this->UnitSphere)
      {
        this->UnitSphere = MakeUnitSphere();
      }
      glyphs.push_back({ &properties, true, options.Scale * diagonal, result, points });
      points += this->UnitSphere->GetNumberOfPoints();
    }
    if (options.ShowPrincipalAxes && !properties.AxesDegenerate)
    {
      glyphs.push_back({ &properties, false, 0.3 * diagonal, result, points });
      points += AxisEnds;
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
    Join(glyphs, this->UnitSphere, arrays, output);
  }
}
}
