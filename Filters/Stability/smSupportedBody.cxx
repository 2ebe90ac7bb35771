#include "Detail/smSupportedBody.h"

#include "smBodyScales.h"
#include "smSphereMesh.h"
#include "smStabilityNames.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace sm
{
namespace
{
/// Returns the position of a world point in the ground's frame. The point is given in extended precision.
Vector3 ToFrame(
  const GroundDirections& ground, const Vector3& origin, const std::array<long double, 3>& world)
{
  Vector3 result;
  const Vector3* rows[3] = { &ground.A, &ground.B, &ground.Normal };
  for (int i = 0; i < 3; ++i)
  {
    long double sum = 0.0L;
    for (int j = 0; j < 3; ++j)
    {
      sum += (*rows[i])[j] * (world[j] - origin[j]);
    }
    result[i] = static_cast<double>(sum);
  }
  return result;
}
}

GroundFrame MakeGroundFrame(const GroundDirections& ground, const Vector3& origin, const BodyIntegrals& part)
{
  GroundFrame frame;
  const std::array<double, 16>& m = part.Placement;
  const double* partOrigin = part.Model->GetOrigin();
  const Vector3* rows[3] = { &ground.A, &ground.B, &ground.Normal };
  std::array<long double, 3> world{};
  for (int i = 0; i < 3; ++i)
  {
    world[i] = m[4 * i + 3];
    for (int j = 0; j < 3; ++j)
    {
      world[i] += static_cast<long double>(m[4 * i + j]) * partOrigin[j];
    }
    for (int j = 0; j < 3; ++j)
    {
      long double sum = 0.0L;
      for (int k = 0; k < 3; ++k)
      {
        sum += static_cast<long double>((*rows[i])[k]) * m[4 * k + j];
      }
      frame.Rows[i][j] = static_cast<double>(sum);
    }
  }
  frame.Shift = ToFrame(ground, origin, world);
  return frame;
}

bool GroundDirections::Make(const double gravity[3], const double normal[3], GroundDirections& directions)
{
  directions.Up = Normalized({ -gravity[0], -gravity[1], -gravity[2] });
  const bool level = normal[0] == 0.0 && normal[1] == 0.0 && normal[2] == 0.0;
  Vector3 n = level ? directions.Up : Normalized({ normal[0], normal[1], normal[2] });
  const double cosine = Dot(n, directions.Up);
  if (!(std::abs(cosine) >= 1e-6))
  {
    return false;
  }
  if (cosine < 0.0)
  {
    n = { -n[0], -n[1], -n[2] };
  }
  directions.Normal = n;
  // The world axis with the smallest angle to the ground's plane.
  int axis = 0;
  for (int i = 1; i < 3; ++i)
  {
    axis = std::abs(n[i]) < std::abs(n[axis]) ? i : axis;
  }
  Vector3 a{};
  a[axis] = 1.0;
  for (int i = 0; i < 3; ++i)
  {
    a[i] -= n[axis] * n[i];
  }
  directions.A = Normalized(a);
  directions.B = Cross(n, directions.A);
  return true;
}

SupportedBody::SupportedBody()
  : Mass(vtkMath::Nan())
  , Metres(vtkMath::Nan())
{
}

Vector3 SupportedBody::ToWorld(const GroundDirections& ground, const Point2& ab, double h) const
{
  Vector3 world;
  for (int i = 0; i < 3; ++i)
  {
    world[i] = this->Origin[i] + ab[0] * ground.A[i] + ab[1] * ground.B[i] + h * ground.Normal[i];
  }
  return world;
}

void EvaluateStability(SupportedBody& body, const GroundDirections& ground, const double* groundOrigin,
  double tolerance, FacePanelsCache& cache)
{
  vtkBoundingBox box;
  for (const BodyIntegrals* part : body.Parts)
  {
    AddPlacedBox(*part, box);
  }
  if (!box.IsValid())
  {
    return;
  }
  body.Size = box.GetDiagonalLength();
  box.GetCenter(body.Origin.data());
  ContactSearch search;
  std::vector<CutFacePointer> held;
  for (const BodyIntegrals* part : body.Parts)
  {
    std::vector<CutFacePointer> cut;
    cache.Acquire(part->Model->GetFaces(), cut, {});
    const GroundFrame frame = MakeGroundFrame(ground, body.Origin, *part);
    for (const CutFacePointer& face : cut)
    {
      search.AddFace(face, frame);
    }
  }
  const HeightRange lowest = search.FindLowest();
  if (std::isnan(lowest.Low))
  {
    return;
  }

  StabilityCase stabilityCase;
  const Vector3 center = ToFrame(ground, body.Origin, { body.Center[0], body.Center[1], body.Center[2] });
  stabilityCase.Center = center;
  // The bound of the body is that of each component.
  stabilityCase.CenterBound = std::sqrt(3.0) * body.CenterBound;
  stabilityCase.Up = { Dot(ground.Up, ground.A), Dot(ground.Up, ground.B), Dot(ground.Up, ground.Normal) };
  if (ground.Up == ground.Normal)
  {
    stabilityCase.Up = { 0.0, 0.0, 1.0 };
  }
  stabilityCase.Size = search.GetSize();
  stabilityCase.Rounding = search.GetRounding();
  stabilityCase.Resolution = search.GetResolution();
  stabilityCase.Tolerance = tolerance * body.Size;
  stabilityCase.Ground = lowest;
  if (groundOrigin)
  {
    const double h = ToFrame(ground, body.Origin, { groundOrigin[0], groundOrigin[1], groundOrigin[2] })[2];
    // The point of the given plane is rounded, too.
    const double rounding = stabilityCase.Rounding + 4e-16 * std::abs(h);
    stabilityCase.Ground = { h - rounding, h + rounding };
    body.Clearance = { lowest.Low - stabilityCase.Ground.High, lowest.High - stabilityCase.Ground.Low };
  }
  body.GroundHeight = 0.5 * (stabilityCase.Ground.Low + stabilityCase.Ground.High);
  if (groundOrigin && body.Clearance.High < -stabilityCase.Tolerance)
  {
    body.Result = ComputeStability(stabilityCase, {});
    body.Result.Decision = Verdict::BelowGround;
    return;
  }
  GroundContacts contacts = search.FindContacts(stabilityCase.Ground.High + stabilityCase.Tolerance);
  body.ContactFaces = static_cast<int>(contacts.FaceIds.size());
  body.ContactEdges = static_cast<int>(contacts.EdgeIds.size());
  body.Coarse = contacts.Coarse;
  body.Result = ComputeStability(stabilityCase, std::move(contacts));
}

namespace
{
const unsigned char* GetColor(Verdict verdict)
{
  static const unsigned char green[3] = { 38, 166, 65 };
  static const unsigned char red[3] = { 214, 40, 40 };
  static const unsigned char amber[3] = { 255, 176, 0 };
  static const unsigned char grey[3] = { 140, 140, 140 };
  return verdict == Verdict::Stable   ? green
    : verdict == Verdict::Unstable    ? red
    : verdict == Verdict::TooClose    ? amber
    : verdict == Verdict::BelowGround ? red
                                      : grey;
}

/// Collects coloured lines and polygons; in the cell data of a polydata lines come before polygons.
class Pen
{
public:
  Pen()
  {
    this->Points->SetDataTypeToDouble();
    for (vtkUnsignedCharArray* colors : { this->LineColors.Get(), this->PolyColors.Get() })
    {
      colors->SetNumberOfComponents(3);
    }
  }

  vtkIdType AddPoint(const Vector3& p) { return this->Points->InsertNextPoint(p.data()); }

  void AddLine(const std::vector<Vector3>& points, bool closed, const unsigned char* color)
  {
    this->Lines->InsertNextCell(static_cast<int>(points.size()) + (closed ? 1 : 0));
    const vtkIdType first = this->Points->GetNumberOfPoints();
    for (const Vector3& p : points)
    {
      this->Lines->InsertCellPoint(this->AddPoint(p));
    }
    if (closed)
    {
      this->Lines->InsertCellPoint(first);
    }
    this->LineColors->InsertNextTypedTuple(color);
  }

  void AddPolygon(const std::vector<Vector3>& points, const unsigned char* color)
  {
    this->Polys->InsertNextCell(static_cast<int>(points.size()));
    for (const Vector3& p : points)
    {
      this->Polys->InsertCellPoint(this->AddPoint(p));
    }
    this->PolyColors->InsertNextTypedTuple(color);
  }

  void AddSphere(const Vector3& center, double radius, const unsigned char* color)
  {
    const vtkSmartPointer<vtkPolyData> mesh = MakeSphereMesh(center.data(), radius, 24, 16);
    for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
    {
      vtkNew<vtkIdList> ids;
      mesh->GetCellPoints(i, ids);
      std::vector<Vector3> points(ids->GetNumberOfIds());
      for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
      {
        mesh->GetPoint(ids->GetId(k), points[k].data());
      }
      this->AddPolygon(points, color);
    }
  }

  void Finish(vtkPolyData* drawing)
  {
    drawing->SetPoints(this->Points);
    drawing->SetLines(this->Lines);
    drawing->SetPolys(this->Polys);
    this->LineColors->SetName(names::StabilityColor);
    for (vtkIdType i = 0; i < this->PolyColors->GetNumberOfTuples(); ++i)
    {
      this->LineColors->InsertNextTuple(i, this->PolyColors);
    }
    drawing->GetCellData()->SetScalars(this->LineColors);
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkCellArray> Polys;
  vtkNew<vtkUnsignedCharArray> LineColors;
  vtkNew<vtkUnsignedCharArray> PolyColors;
};

void DrawBody(const SupportedBody& body, const GroundDirections& ground, Pen& pen)
{
  const StabilityResult& result = body.Result;
  if (!std::isfinite(result.Height))
  {
    return;
  }
  const unsigned char* color = GetColor(result.Decision);
  // A little below the ground, so that the faces that touch it do not hide the polygon.
  const double ground0 = body.GroundHeight;
  const double below = ground0 - 2e-3 * body.Size;
  const double footHeight = ground0 - 1e-3 * body.Size;
  const double dot = 0.015 * body.Size;
  const auto disc = [&](const Point2& at, double radius, double h)
  {
    std::vector<Vector3> points;
    const int count = 32;
    for (int i = 0; i < count; ++i)
    {
      const double angle = 2.0 * vtkMath::Pi() * i / count;
      points.push_back(
        body.ToWorld(ground, { at[0] + radius * std::cos(angle), at[1] + radius * std::sin(angle) }, h));
    }
    return points;
  };
  std::vector<Vector3> corners;
  for (const Point2& p : result.Polygon)
  {
    corners.push_back(body.ToWorld(ground, p, below));
  }
  if (corners.size() > 2)
  {
    pen.AddPolygon(corners, color);
  }
  if (corners.size() > 1)
  {
    pen.AddLine(corners, corners.size() > 2, color);
  }
  if (corners.size() < 3)
  {
    for (const Point2& p : result.Polygon)
    {
      pen.AddLine(disc(p, 2.0 * dot, below), true, color);
    }
  }
  static const unsigned char ink[3] = { 30, 36, 44 };
  const Vector3 foot = body.ToWorld(ground, result.ProjectedCenter, footHeight);
  pen.AddLine({ body.Center, foot }, false, ink);
  pen.AddPolygon(disc(result.ProjectedCenter, dot, footHeight), ink);
  pen.AddLine(disc(result.ProjectedCenter, 2.0 * dot, footHeight), true, ink);
  pen.AddSphere(body.Center, 1.5 * dot, color);
}
}

void DrawSupportedBodies(
  const std::vector<SupportedBody>& bodies, const GroundDirections& ground, vtkPolyData* drawing)
{
  Pen pen;
  for (const SupportedBody& body : bodies)
  {
    DrawBody(body, ground, pen);
  }
  pen.Finish(drawing);
}
}
