#include "smLeafMesh.h"

#include "smBodyMesh.h"
#include "smDisplayMesh.h"
#include "smWholeSphere.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNURBSDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Grey value of a face without a colour in a body where others have one.
constexpr double DefaultColor = 0.8;

/// A coarse mesh is within this part of the diagonal of all bodies together: a pixel where they fill a
/// window. At its angle a round hole has six sides.
constexpr double CoarsePart = 1e-3;
constexpr double CoarseAngle = 1.2;

double GetDiagonal(vtkTrimmedNURBSModel* model)
{
  const double* b = model->GetLocalBounds();
  return std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
}

/// Estimates the number of triangles of a display mesh, which for curved faces is inverse to the deflection.
double EstimateTriangles(vtkTrimmedNURBSModel* model, double deflection)
{
  // Some triangles of a whole sphere for each radius over the deflection, as counted on balls.
  constexpr double trianglesOfSphere = 33.0;
  vtkPolyData* mesh = model->GetScaleMesh();
  const std::vector<WholeSphere> spheres = FindWholeSpheres(model->GetFaces());
  auto others = static_cast<double>(mesh->GetNumberOfCells());
  double count = 0.0;
  if (!spheres.empty())
  {
    vtkDataArray* faceOfCell = mesh->GetCellData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName());
    for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
    {
      others -= spheres[static_cast<std::size_t>(faceOfCell->GetComponent(i, 0))] ? 1.0 : 0.0;
    }
    for (const WholeSphere& sphere : spheres)
    {
      count += trianglesOfSphere * sphere.Radius / deflection;
    }
  }
  return count + others * std::max(1.0, GetScaleLimits(GetDiagonal(model)).Deflection / deflection);
}

void AddPlacedBox(const LeafSource& source, vtkBoundingBox& box)
{
  const double* bounds = source.Model->GetLocalBounds();
  const double* origin = source.Model->GetOrigin();
  const std::array<double, 16>& m = source.Placement;
  for (int corner = 0; corner < 8; ++corner)
  {
    double p[3];
    double q[3];
    for (int d = 0; d < 3; ++d)
    {
      p[d] = origin[d] + bounds[2 * d + ((corner >> d) & 1)];
    }
    for (int r = 0; r < 3; ++r)
    {
      q[r] = m[4 * r] * p[0] + m[4 * r + 1] * p[1] + m[4 * r + 2] * p[2] + m[4 * r + 3];
    }
    box.AddPoint(q);
  }
}

vtkSmartPointer<vtkCellArray> Mirror(vtkCellArray* triangles)
{
  auto result = vtkSmartPointer<vtkCellArray>::New();
  const vtkIdType count = triangles->GetNumberOfCells();
  result->AllocateExact(count, 3 * count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    vtkIdType size;
    const vtkIdType* ids;
    triangles->GetCellAtId(i, size, ids);
    const vtkIdType reversed[3] = { ids[0], ids[2], ids[1] };
    result->InsertNextCell(3, reversed);
  }
  return result;
}

/// Null where neither faces nor bodies have a colour.
vtkSmartPointer<vtkUnsignedCharArray> MakeColors(const LeafSource& source, vtkPolyData* mesh)
{
  const std::vector<FacePointer>& faces = source.Model->GetFaces();
  if (source.Color[0] < 0.0 && source.BodyColor[0] < 0.0 &&
    std::none_of(faces.begin(), faces.end(), [](const FacePointer& face) { return face->Color[0] >= 0.0; }))
  {
    return nullptr;
  }
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName("Color");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(mesh->GetNumberOfCells());
  vtkDataArray* faceOfCell = mesh->GetCellData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName());
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    Vector3 rgb = faces[static_cast<std::size_t>(faceOfCell->GetComponent(i, 0))]->Color;
    rgb = rgb[0] >= 0.0 ? rgb : source.BodyColor;
    rgb = source.Color[0] >= 0.0 ? source.Color : rgb;
    for (int c = 0; c < 3; ++c)
    {
      const double value = rgb[0] >= 0.0 ? rgb[c] : DefaultColor;
      colors->SetTypedComponent(i, c, static_cast<unsigned char>(std::lround(255.0 * value)));
    }
  }
  return colors;
}

/// Points and normals of a mesh, placed.
void PlacePoints(vtkPolyData* mesh, const std::array<double, 16>& m, vtkPolyData* leaf)
{
  const vtkIdType count = mesh->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  vtkDataArray* own = mesh->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3];
    double n[3];
    double q[3];
    double placed[3];
    mesh->GetPoint(i, p);
    own->GetTuple(i, n);
    for (int r = 0; r < 3; ++r)
    {
      const double* row = m.data() + 4 * r;
      q[r] = row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
      placed[r] = row[0] * n[0] + row[1] * n[1] + row[2] * n[2];
    }
    points->SetPoint(i, q);
    normals->SetTuple(i, placed);
  }
  leaf->SetPoints(points);
  leaf->GetPointData()->SetNormals(normals);
}
}

vtkSmartPointer<vtkNURBSDataSet> MakeBareLeaf(const LeafSource& source)
{
  auto leaf = vtkSmartPointer<vtkNURBSDataSet>::New();
  vtkNew<vtkMatrix4x4> placement;
  placement->DeepCopy(source.Placement.data());
  leaf->SetPlacement(placement);
  leaf->SetModel(source.Model);
  return leaf;
}

LeafMesher::LeafMesher(const std::vector<LeafSource>& sources, const ShownMesh& shown)
  : Wanted(shown)
{
  if (shown.CoarseAbove > 0)
  {
    this->ChooseCoarseness(sources);
  }
}

void LeafMesher::ChooseCoarseness(const std::vector<LeafSource>& sources)
{
  vtkBoundingBox box;
  double triangles = 0.0;
  for (const LeafSource& source : sources)
  {
    vtkPolyData* mesh = source.Model->GetScaleMesh();
    if (!mesh || mesh->GetNumberOfPoints() == 0)
    {
      continue;
    }
    AddPlacedBox(source, box);
    triangles += EstimateTriangles(source.Model, this->GetLimits(source.Model).Deflection);
  }
  if (triangles > static_cast<double>(this->Wanted.CoarseAbove) && box.IsValid())
  {
    this->CoarseDeflection = CoarsePart * box.GetDiagonalLength();
  }
}

MeshLimits LeafMesher::GetLimits(vtkTrimmedNURBSModel* model) const
{
  const double diagonal = GetDiagonal(model);
  MeshLimits limits{ LimitDeflection(this->Wanted.GetDeflection(diagonal), diagonal),
    this->Wanted.AngularDeflection };
  if (this->IsCoarse())
  {
    limits.Deflection = std::max(limits.Deflection, this->CoarseDeflection);
    limits.Angle = std::max(limits.Angle, CoarseAngle);
  }
  return limits;
}

vtkSmartPointer<vtkPolyData> LeafMesher::MakeMesh(
  vtkTrimmedNURBSModel* model, const ProgressCallback& progress)
{
  const MeshLimits limits = this->GetLimits(model);
  if (!this->IsCoarse() && limits.Deflection > this->Wanted.GetDeflection(GetDiagonal(model)))
  {
    this->SmallestDeflection = std::max(this->SmallestDeflection, limits.Deflection);
  }
  vtkPolyData* scales = model->GetScaleMesh();
  if (!scales || scales->GetNumberOfPoints() == 0 || DoesSuit(scales, limits))
  {
    return scales;
  }
  bool isStopped = false;
  const auto report = [&](double x)
  {
    isStopped = isStopped || (progress && !progress(x));
    return !isStopped;
  };
  std::vector<FaceMesh> meshes = MeshFaces(model->GetFaces(), limits, report);
  if (isStopped)
  {
    return nullptr;
  }
  std::vector<std::string> messages;
  auto mesh =
    JoinMeshes(model->GetFaces(), std::move(meshes), model->GetOrigin(), limits.Deflection, messages);
  const std::vector<std::string>& known = model->GetMessages();
  for (const std::string& message : messages)
  {
    if (std::find(known.begin(), known.end(), message) == known.end())
    {
      this->Messages.push_back("Body \"" + model->GetName() + "\": " + message);
    }
  }
  return mesh;
}

vtkSmartPointer<vtkNURBSDataSet> LeafMesher::MakeLeaf(
  const LeafSource& source, const ProgressCallback& progress)
{
  vtkTrimmedNURBSModel* model = source.Model;
  Shared& shared = this->Meshes[model];
  if (!shared.Mesh)
  {
    shared.Mesh = this->MakeMesh(model, progress);
    if (!shared.Mesh && model->GetScaleMesh())
    {
      return nullptr; // stopped
    }
  }
  vtkSmartPointer<vtkNURBSDataSet> leaf = MakeBareLeaf(source);
  if (!shared.Mesh)
  {
    return leaf; // no face has a triangle
  }
  vtkPolyData* mesh = shared.Mesh;
  PlacePoints(mesh, source.Placement, leaf);
  if (vtkMatrix4x4::Determinant(source.Placement.data()) < 0.0 && !shared.MirroredTriangles)
  {
    shared.MirroredTriangles = Mirror(mesh->GetPolys());
  }
  leaf->SetPolys(vtkMatrix4x4::Determinant(source.Placement.data()) < 0.0 ? shared.MirroredTriangles.Get()
                                                                          : mesh->GetPolys());
  for (const char* name : { vtkNURBSDataSet::FaceIndexArrayName(), vtkNURBSDataSet::ParametersArrayName() })
  {
    leaf->GetPointData()->AddArray(mesh->GetPointData()->GetArray(name));
  }
  leaf->GetCellData()->AddArray(mesh->GetCellData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName()));
  for (const char* name :
    { vtkNURBSDataSet::MeshDeviationArrayName(), vtkNURBSDataSet::MeshAngleArrayName() })
  {
    leaf->GetFieldData()->AddArray(mesh->GetFieldData()->GetArray(name));
  }
  const auto [colors, isNew] = shared.Colors.emplace(
    std::array<Vector3, 2>{ source.BodyColor, source.Color }, vtkSmartPointer<vtkUnsignedCharArray>());
  if (isNew)
  {
    colors->second = MakeColors(source, mesh);
  }
  if (colors->second)
  {
    leaf->GetCellData()->AddArray(colors->second);
  }
  // The model belongs to the points that are there when it is set.
  leaf->SetModel(model);
  return leaf;
}
}
