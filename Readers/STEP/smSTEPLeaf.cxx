#include "smSTEPLeaf.h"

#include "smBodyMesh.h"
#include "smOCCTBounds.h"
#include "smOCCTFailure.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNURBSDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTimerLog.h"
#include "vtkTrimmedNURBSModel.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Grey value of a face without a colour in a body where others have one.
constexpr double DefaultColor = 0.8;

/// Share of a body's progress that its conversion takes; its triangles take the rest.
constexpr double ConversionShare = 0.8;

/// Limits of the mesh that a body's scales are taken from, whatever is shown: a part of its box's diagonal, and radians. At the reader's
/// default settings it is shown, too, because OpenCASCADE's box is seldom a tenth larger than the body.
constexpr double UsualDeflection = 0.9e-3;
constexpr double UsualAngle = 0.35;
/// It is fine enough, and not too fine, where up to so many times its deflection is asked for.
constexpr double MostDeflectionRatio = 1.5;

/// A unit in mm is a product of up to three numbers that are no doubles (0.0254, 0.001, ...), times the coordinate.
constexpr int UnitRoundings = 6;

vtkSmartPointer<vtkIntArray> MakeIndexArray(const std::vector<int>& values)
{
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName(vtkNURBSDataSet::FaceIndexArrayName());
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

/// Row-major 4x4 of a rigid or mirrored placement, its translation in output units.
void FillPlacement(const gp_Trsf& trsf, double unit, vtkMatrix4x4* matrix)
{
  matrix->Identity();
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      matrix->SetElement(i, j, trsf.Value(i + 1, j + 1));
    }
    matrix->SetElement(i, 3, unit * trsf.Value(i + 1, 4));
  }
}
}

LeafMaker::LeafMaker(
  const PartBody& part, const ShapeTable& table, const LeafOptions& options, const ProgressCallback& progress)
  : Options(options)
  , Color(part.Color)
  , Model(vtkSmartPointer<vtkTrimmedNURBSModel>::New())
{
  const double start = vtkTimerLog::GetUniversalTime();
  BodySize size;
  ConvertedBody body;
  const std::string failure = CatchFailure([&]() { this->Convert(part, table, progress, size, body); });
  if (!failure.empty())
  {
    body.Messages.push_back("The body could not be carried over: " + failure + ".");
    ++body.MissingFaces;
  }
  body.MissingFaces = std::max(body.MissingFaces, part.LostFaces);
  body.Messages.insert(body.Messages.end(), part.Messages.begin(), part.Messages.end());
  if (part.Misplaced)
  {
    ++body.Defects;
    body.Messages.push_back("An instance of it lost its scale or its mirror.");
  }
  this->MakeModel(part, size, body);
  this->MakeSharedArrays();
  this->Summarise(part, body.Messages);
  this->ConversionSeconds = vtkTimerLog::GetUniversalTime() - start - this->MeshSeconds;
}

void LeafMaker::Convert(const PartBody& part, const ShapeTable& table, const ProgressCallback& progress,
  BodySize& size, ConvertedBody& body)
{
  double bounds[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
  int unbounded = 0;
  if (!IsAsInFile(part.Shape, table) || !GetEdgeBounds(part.Shape, bounds))
  {
    GetShapeBounds(part.Shape, bounds, &unbounded);
  }
  const double toOutput = std::abs(part.Scale.ScaleFactor()) * this->Options.Unit;
  // A centre in single precision: its subtraction from coordinates near it is exact.
  double origin[3];
  double box[6];
  for (int d = 0; d < 3; ++d)
  {
    origin[d] = static_cast<float>(0.5 * (bounds[2 * d] + bounds[2 * d + 1]) * toOutput);
    box[2 * d] = bounds[2 * d] * toOutput - origin[d];
    box[2 * d + 1] = bounds[2 * d + 1] * toOutput - origin[d];
  }
  this->Model->SetOrigin(origin);
  const auto report = [&progress](double x) { return progress(ConversionShare * x); };
  body = ConvertBody(part.Shape, part.Scale, this->Options.Unit, origin, table, report,
    this->Options.FileUnitName.empty() || this->Options.FileUnitName == "mm" ? 0 : UnitRoundings);
  this->Aborted = body.Aborted;
  if (unbounded > 0)
  {
    body.Messages.insert(body.Messages.begin(),
      std::to_string(unbounded) +
        " faces have no finite bounding box; the size of the body is taken from the others.");
  }
  const double start = vtkTimerLog::GetUniversalTime();
  this->Triangulate(box, progress, size, body);
  this->MeshSeconds = vtkTimerLog::GetUniversalTime() - start;
}

void LeafMaker::Triangulate(
  const double box[6], const ProgressCallback& progress, BodySize& size, ConvertedBody& body)
{
  std::vector<FacePointer> faces;
  for (const ConvertedFace& face : body.Faces)
  {
    faces.push_back(face.Result);
  }
  // Each of two meshes takes half of the remaining progress.
  double done = ConversionShare;
  const double share = 0.5 * (1.0 - ConversionShare);
  const auto report = [&](double x)
  {
    this->Aborted = this->Aborted || !progress(done + share * x);
    return !this->Aborted;
  };
  const auto getDiagonal = [](const double* b) { return std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]); };
  const MeshLimits usual{ UsualDeflection * getDiagonal(box), UsualAngle };
  std::vector<FaceMesh> meshes;
  if (usual.Deflection > 0.0 && std::isfinite(usual.Deflection))
  {
    meshes = MeshFaces(faces, usual, report);
  }
  size = MeasureBody(meshes);
  if (!size.IsKnown)
  {
    std::copy(box, box + 6, size.Bounds.begin());
    return;
  }
  const double diagonal = getDiagonal(size.Bounds.data());
  const double wanted = this->Options.LinearDeflection * (this->Options.RelativeDeflection ? diagonal : 1.0);
  const MeshLimits shown{ LimitDeflection(wanted, diagonal), this->Options.AngularDeflection };
  if (this->Aborted)
  {
    return;
  }
  if (shown.Angle != usual.Angle || shown.Deflection < usual.Deflection ||
    shown.Deflection > MostDeflectionRatio * usual.Deflection)
  {
    done += share;
    meshes = MeshFaces(faces, shown, report);
  }
  this->Mesh = JoinMeshes(faces, std::move(meshes), this->Model->GetOrigin(), body.Messages);
}

void LeafMaker::Summarise(const PartBody& part, const std::vector<std::string>& messages)
{
  if (messages.empty())
  {
    return;
  }
  const std::string id = part.FileId > 0 ? " (#" + std::to_string(part.FileId) + ")" : std::string();
  const std::string more = messages.size() > 1
    ? " (and " + std::to_string(messages.size() - 1) + " more, see its model)"
    : std::string();
  this->Messages.push_back("Body \"" + part.Name + "\"" + id + ": " + messages.front() + more);
}

void LeafMaker::MakeModel(const PartBody& part, const BodySize& size, ConvertedBody& body)
{
  const double unit = this->Options.Unit;
  vtkTrimmedNURBSModel* model = this->Model;
  model->SetBody(part.Solid ? vtkTrimmedNURBSModel::SOLID : vtkTrimmedNURBSModel::SHELL);
  model->SetName(part.Name);
  model->SetFileId(part.FileId);
  model->SetLengthUnit(this->Options.UnitName);
  model->SetFileUnit(this->Options.FileUnitName);
  model->SetMaterial(part.Material);
  model->SetDensity(part.Density);
  model->SetFileVolume(part.FileVolume * unit * unit * unit);
  model->SetFileArea(part.FileArea * unit * unit);
  model->SetFileUncertainty(part.Uncertainty * unit);
  model->SetNumberOfOuterShells(part.Solid ? 1 : 0);
  model->SetLocalBounds(size.Bounds.data());
  model->SetVolumeScale(size.Volume);
  model->SetAreaScale(size.Area);
  std::vector<FacePointer> faces;
  for (const ConvertedFace& face : body.Faces)
  {
    faces.push_back(face.Result);
  }
  model->SetFaces(std::move(faces));
  model->SetShells(body.Shells);
  model->SetMessages(body.Messages);
  model->SetNumberOfMissingFaces(body.MissingFaces);
  model->SetNumberOfDefects(body.Defects);
}

void LeafMaker::MakeSharedArrays()
{
  this->PointFace = MakeIndexArray(this->Mesh.PointFace);
  this->CellFace = MakeIndexArray(this->Mesh.TriangleFace);
  auto parameters = vtkSmartPointer<vtkDoubleArray>::New();
  parameters->SetName(vtkNURBSDataSet::ParametersArrayName());
  parameters->SetNumberOfComponents(2);
  parameters->SetNumberOfTuples(static_cast<vtkIdType>(this->Mesh.Parameters.size()));
  for (std::size_t i = 0; i < this->Mesh.Parameters.size(); ++i)
  {
    parameters->SetTypedTuple(static_cast<vtkIdType>(i), this->Mesh.Parameters[i].data());
  }
  this->Parameters = parameters;
  this->Deviations = vtkSmartPointer<vtkDoubleArray>::New();
  this->Deviations->SetName(vtkNURBSDataSet::MeshDeviationArrayName());
  this->Deviations->SetNumberOfTuples(static_cast<vtkIdType>(this->Mesh.Deviations.size()));
  std::copy(this->Mesh.Deviations.begin(), this->Mesh.Deviations.end(), this->Deviations->Begin());
}

vtkSmartPointer<vtkCellArray> LeafMaker::GetTriangles(bool mirrored)
{
  vtkSmartPointer<vtkCellArray>& cells = this->Triangles[mirrored ? 1 : 0];
  if (!cells)
  {
    cells = vtkSmartPointer<vtkCellArray>::New();
    cells->AllocateExact(static_cast<vtkIdType>(this->Mesh.Triangles.size()),
      3 * static_cast<vtkIdType>(this->Mesh.Triangles.size()));
    for (const std::array<int, 3>& t : this->Mesh.Triangles)
    {
      const vtkIdType ids[3] = { t[0], mirrored ? t[2] : t[1], mirrored ? t[1] : t[2] };
      cells->InsertNextCell(3, ids);
    }
  }
  return cells;
}

vtkSmartPointer<vtkDataArray> LeafMaker::MakeColors(const BodyInstance& instance) const
{
  const std::vector<FacePointer>& faces = this->Model->GetFaces();
  bool any = instance.Color[0] >= 0.0 || this->Color[0] >= 0.0;
  for (std::size_t i = 0; i < faces.size() && !any; ++i)
  {
    any = faces[i]->Color[0] >= 0.0;
  }
  if (!any)
  {
    return nullptr;
  }
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName("Color");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(static_cast<vtkIdType>(this->Mesh.Triangles.size()));
  for (std::size_t i = 0; i < this->Mesh.Triangles.size(); ++i)
  {
    Vector3 rgb = faces[this->Mesh.TriangleFace[i]]->Color;
    rgb = rgb[0] >= 0.0 ? rgb : this->Color;
    rgb = instance.Color[0] >= 0.0 ? instance.Color : rgb;
    for (int c = 0; c < 3; ++c)
    {
      const double value = rgb[0] >= 0.0 ? rgb[c] : DefaultColor;
      colors->SetTypedComponent(
        static_cast<vtkIdType>(i), c, static_cast<unsigned char>(std::lround(255.0 * value)));
    }
  }
  return colors;
}

vtkSmartPointer<vtkNURBSDataSet> LeafMaker::MakeLeaf(const BodyInstance& instance)
{
  vtkNew<vtkMatrix4x4> placement;
  FillPlacement(instance.Placement, this->Options.Unit, placement);
  const auto count = static_cast<vtkIdType>(this->Mesh.Points.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Vector3& p = this->Mesh.Points[i];
    const Vector3& n = this->Mesh.Normals[i];
    double q[3];
    float m[3];
    for (int r = 0; r < 3; ++r)
    {
      const double* row = placement->GetData() + 4 * r;
      q[r] = row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
      m[r] = static_cast<float>(row[0] * n[0] + row[1] * n[1] + row[2] * n[2]);
    }
    points->SetPoint(i, q);
    normals->SetTypedTuple(i, m);
  }
  auto leaf = vtkSmartPointer<vtkNURBSDataSet>::New();
  leaf->SetPoints(points);
  leaf->SetPolys(this->GetTriangles(placement->Determinant() < 0.0));
  leaf->GetPointData()->SetNormals(normals);
  leaf->GetPointData()->AddArray(this->PointFace);
  leaf->GetPointData()->AddArray(this->Parameters);
  leaf->GetCellData()->AddArray(this->CellFace);
  leaf->GetFieldData()->AddArray(this->Deviations);
  if (const auto colors = this->MakeColors(instance))
  {
    leaf->GetCellData()->AddArray(colors);
  }
  leaf->SetPlacement(placement);
  leaf->SetModel(this->Model);
  return leaf;
}
}
