#include "smDisplayMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNURBSDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <map>

namespace sm
{
namespace
{
/// Limits of the mesh of scales.
constexpr double UsualDeflection = 0.9e-3;
constexpr double UsualAngle = 0.35;
/// That mesh is not too fine where up to so many times its deflection is asked for.
constexpr double MaxDeflectionRatio = 1.5;

/// Field array of a scale mesh: the deflection that it was made for.
constexpr const char* DeflectionName = "Deflection";

/// "2 faces, the first of them #17"
std::string CountFaces(const std::vector<const Face*>& faces)
{
  const std::string id =
    faces.front()->FileId > 0 ? " #" + std::to_string(faces.front()->FileId) : std::string();
  return faces.size() == 1
    ? "face" + id
    : std::to_string(faces.size()) + " faces" + (id.empty() ? "" : ", the first of them" + id);
}

/// The problems of the meshes of faces, in a sentence for each kind.
class MeshNotes
{
public:
  void Add(const Face* face, const FaceMesh& mesh)
  {
    if (mesh.Triangles.empty())
    {
      this->Missing.push_back(face);
    }
    else if (mesh.InvertedTriangles > 0)
    {
      this->Turned[mesh.Reason].push_back(face);
    }
    else if (!mesh.Reason.empty())
    {
      this->Crossing.push_back(face);
    }
    if (mesh.IsUnproved)
    {
      this->Unproved.push_back(face);
    }
  }
  void AppendTo(std::vector<std::string>& messages) const
  {
    if (!this->Missing.empty())
    {
      messages.push_back(
        "The display mesh lacks " + CountFaces(this->Missing) + "; the exact geometry is there.");
    }
    for (const auto& [reason, of] : this->Turned)
    {
      messages.push_back("Display mesh of " + CountFaces(of) + ": " + reason);
    }
    if (!this->Crossing.empty())
    {
      messages.push_back(
        "Loops cross on " + CountFaces(this->Crossing) + "; the display mesh may be open there.");
    }
    if (!this->Unproved.empty())
    {
      messages.push_back("The display mesh of " + CountFaces(this->Unproved) +
        " is not proved to lie within the deflection: parameters run too unevenly there.");
    }
  }

private:
  std::vector<const Face*> Missing;
  std::vector<const Face*> Crossing;
  std::vector<const Face*> Unproved;
  std::map<std::string, std::vector<const Face*>> Turned;
};

vtkSmartPointer<vtkIntArray> MakeIndexArray(vtkIdType size)
{
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName(vtkNURBSDataSet::FaceIndexArrayName());
  array->SetNumberOfValues(size);
  return array;
}
}

double LimitDeflection(double deflection, double diagonal)
{
  const double wanted = deflection > 0.0 ? deflection : 1e-3 * diagonal;
  return std::max(wanted, 1e-5 * diagonal);
}

MeshLimits GetScaleLimits(double diagonal)
{
  return { UsualDeflection * diagonal, UsualAngle };
}

double GetReachedDeflection(const std::vector<FaceMesh>& meshes, double deflection)
{
  for (const FaceMesh& mesh : meshes)
  {
    deflection = mesh.Sphere ? std::max(deflection, mesh.Deviation) : deflection;
  }
  return deflection;
}

bool DoesSuit(vtkPolyData* scaleMesh, const MeshLimits& limits)
{
  vtkDataArray* array = scaleMesh ? scaleMesh->GetFieldData()->GetArray(DeflectionName) : nullptr;
  const double deflection = array ? array->GetComponent(0, 0) : 0.0;
  return deflection > 0.0 && limits.Angle == UsualAngle && limits.Deflection >= deflection &&
    limits.Deflection <= MaxDeflectionRatio * deflection;
}

vtkSmartPointer<vtkPolyData> JoinMeshes(const std::vector<FacePointer>& faces, std::vector<FaceMesh> meshes,
  const double origin[3], double deflection, std::vector<std::string>& messages)
{
  vtkIdType numberOfPoints = 0;
  vtkIdType numberOfTriangles = 0;
  for (const FaceMesh& mesh : meshes)
  {
    numberOfPoints += static_cast<vtkIdType>(mesh.Points.size());
    numberOfTriangles += static_cast<vtkIdType>(mesh.Triangles.size());
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(numberOfPoints);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(numberOfPoints);
  vtkNew<vtkDoubleArray> parameters;
  parameters->SetName(vtkNURBSDataSet::ParametersArrayName());
  parameters->SetNumberOfComponents(2);
  parameters->SetNumberOfTuples(numberOfPoints);
  const vtkSmartPointer<vtkIntArray> pointFace = MakeIndexArray(numberOfPoints);
  const vtkSmartPointer<vtkIntArray> cellFace = MakeIndexArray(numberOfTriangles);
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(numberOfTriangles, 3 * numberOfTriangles);
  vtkNew<vtkDoubleArray> deviations;
  deviations->SetName(vtkNURBSDataSet::MeshDeviationArrayName());
  vtkNew<vtkDoubleArray> angles;
  angles->SetName(vtkNURBSDataSet::MeshAngleArrayName());
  MeshNotes notes;
  vtkIdType first = 0;
  vtkIdType cell = 0;
  for (std::size_t f = 0; f < meshes.size(); ++f)
  {
    const FaceMesh& mesh = meshes[f];
    const int index = static_cast<int>(f);
    for (std::size_t i = 0; i < mesh.Points.size(); ++i)
    {
      const vtkIdType id = first + static_cast<vtkIdType>(i);
      const std::array<double, 3>& p = mesh.Points[i];
      const std::array<double, 3>& n = mesh.Normals[i];
      points->SetPoint(id, p[0] + origin[0], p[1] + origin[1], p[2] + origin[2]);
      normals->SetTuple3(id, n[0], n[1], n[2]);
      parameters->SetTypedTuple(id, mesh.Parameters[i].data());
      pointFace->SetValue(id, index);
    }
    for (const std::array<int, 3>& t : mesh.Triangles)
    {
      const vtkIdType ids[3] = { first + t[0], first + t[1], first + t[2] };
      cells->InsertNextCell(3, ids);
      cellFace->SetValue(cell++, index);
    }
    deviations->InsertNextValue(mesh.Deviation);
    angles->InsertNextValue(mesh.NormalTurn);
    notes.Add(faces[f].get(), mesh);
    first += static_cast<vtkIdType>(mesh.Points.size());
    // The memory of a large face is not needed twice.
    meshes[f] = FaceMesh();
  }
  notes.AppendTo(messages);
  vtkNew<vtkDoubleArray> limit;
  limit->SetName(DeflectionName);
  limit->InsertNextValue(deflection);
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(cells);
  result->GetPointData()->SetNormals(normals);
  result->GetPointData()->AddArray(pointFace);
  result->GetPointData()->AddArray(parameters);
  result->GetCellData()->AddArray(cellFace);
  result->GetFieldData()->AddArray(deviations);
  result->GetFieldData()->AddArray(angles);
  result->GetFieldData()->AddArray(limit);
  return result;
}
}
