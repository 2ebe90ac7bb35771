#include "smSTEPLeaf.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
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

#include <Standard_Failure.hxx>

#include <cmath>

namespace sm
{
namespace
{
/// What a face without a colour gets where others have one.
constexpr double DefaultColor = 0.8;

/// Share of a body's progress that its triangles take.
constexpr double MeshShare = 0.6;

/// Seconds the kernel's mesher gets for one body: an ordinary one takes one or two at most, and there are planes
/// from which it does not come back.
constexpr double MeshLimit = 5.0;

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
  double bounds[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
  ConvertedBody body;
  double deflection = 0.0;
  double meshed = start;
  try
  {
    const double scale = std::abs(part.Scale.ScaleFactor());
    int unbounded = 0;
    if (GetShapeBounds(part.Shape, bounds, &unbounded))
    {
      if (unbounded > 0)
      {
        body.Messages.push_back(std::to_string(unbounded) +
          " faces have no finite bounding box; the size of the body is taken from the others.");
      }
      const double diagonal = std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
      deflection = options.RelativeDeflection ? options.LinearDeflection * diagonal
                                              : options.LinearDeflection / (options.Unit * scale);
      deflection = LimitDeflection(deflection, diagonal);
      const auto reportMesh = [this, &progress](double x)
      {
        this->Aborted = this->Aborted || !progress(MeshShare * x);
        return !this->Aborted;
      };
      const std::string problem =
        TriangulateShape(part.Shape, deflection, options.AngularDeflection, reportMesh, MeshLimit);
      if (!problem.empty())
      {
        body.Messages.push_back(problem);
      }
      GetShapeBounds(part.Shape, bounds);
    }
    meshed = vtkTimerLog::GetUniversalTime();
    // A centre in single precision: subtracting it costs no digits of coordinates that are near it.
    double origin[3];
    for (int d = 0; d < 3; ++d)
    {
      origin[d] = static_cast<float>(0.5 * (bounds[2 * d] + bounds[2 * d + 1]) * scale * options.Unit);
    }
    this->Model->SetOrigin(origin);
    const auto reportFaces = [&progress](double x) { return progress(MeshShare + (1.0 - MeshShare) * x); };
    ConvertedBody converted = this->Aborted
      ? ConvertedBody()
      : ConvertBody(part.Shape, part.Scale, options.Unit, origin, table, reportFaces);
    this->Aborted = this->Aborted || converted.Aborted;
    converted.Messages.insert(converted.Messages.begin(), body.Messages.begin(), body.Messages.end());
    body = std::move(converted);
    this->Mesh = BuildMesh(body, part.Scale, options.Unit, origin);
    for (double& b : bounds)
    {
      b *= scale * options.Unit;
    }
    deflection *= scale * options.Unit;
  }
  catch (const Standard_Failure& failure)
  {
    body.Messages.push_back(std::string("The body could not be carried over: OpenCASCADE raised ") +
      failure.DynamicType()->Name() + ".");
    ++body.MissingFaces;
  }
  catch (const std::exception& failure)
  {
    ++body.MissingFaces;
    body.Messages.push_back(std::string("The body could not be carried over: ") + failure.what() + ".");
  }
  if (part.Misplaced)
  {
    ++body.Defects;
    body.Messages.push_back("An instance of it lost its scale or its mirror.");
  }
  this->MakeModel(part, bounds, deflection, body);
  this->MakeSharedArrays();
  if (!body.Messages.empty())
  {
    std::string message = "Body \"" + part.Name + "\"" +
      (part.FileId > 0 ? " (#" + std::to_string(part.FileId) + ")" : std::string()) + ": " +
      body.Messages.front();
    if (body.Messages.size() > 1)
    {
      message += " (and " + std::to_string(body.Messages.size() - 1) + " more, see its model)";
    }
    this->Messages.push_back(message);
  }
  this->MeshSeconds = meshed - start;
  this->ConversionSeconds = vtkTimerLog::GetUniversalTime() - meshed;
}

void LeafMaker::MakeModel(
  const PartBody& part, const double bounds[6], double deflection, ConvertedBody& body)
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
  const double* origin = model->GetOrigin();
  double local[6];
  for (int d = 0; d < 3; ++d)
  {
    // The triangles lie inside a convex body by up to the deflection.
    local[2 * d] = bounds[2 * d] - deflection - origin[d];
    local[2 * d + 1] = bounds[2 * d + 1] + deflection - origin[d];
  }
  model->SetLocalBounds(local);
  model->SetVolumeScale(this->Mesh.Volume);
  model->SetAreaScale(this->Mesh.Area);
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
  if (const auto colors = this->MakeColors(instance))
  {
    leaf->GetCellData()->AddArray(colors);
  }
  leaf->SetPlacement(placement);
  leaf->SetModel(this->Model);
  return leaf;
}
}
