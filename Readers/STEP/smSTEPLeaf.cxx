#include "smSTEPLeaf.h"

#include "Shapes/smShapeBounds.h"
#include "smBodyMesh.h"
#include "smCatchFailure.h"
#include "smDisplayMesh.h"
#include "smEqualBodies.h"
#include "smSTEPFaceChecks.h"

#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTimerLog.h"
#include "vtkTrimmedNURBSModel.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Fraction of a body's progress for its conversion; the triangles take the rest.
constexpr double ConversionShare = 0.8;

/// The deflection is divided by this for a second mesh of a solid whose walls are as thin as the first one's.
constexpr double ThinRefinement = 16.0;

/// Largest relative change of a volume, and of the root of the area of a shell, by the places of copies.
constexpr double CopyShare = 1e-11;

/// Roundings of a coordinate by the conversion of its unit to mm: the factor is a product of up to three
/// rounded numbers (0.0254, 0.001,
/// ...).
constexpr int UnitRoundings = 6;

/// Returns the row-major 4x4 matrix of a rigid or mirrored placement, with the translation in output units.
std::array<double, 16> GetPlacement(const Placement& place, double unit)
{
  std::array<double, 16> matrix{};
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      matrix[4 * i + j] = place.Linear[i][j];
    }
    matrix[4 * i + 3] = unit * place.Translation[i];
  }
  matrix[15] = 1.0;
  return matrix;
}

/// Returns true if a conversion without problems may stand for those of bodies that equal it: their places,
/// which move the faces by up to `moved`, hardly change the bounds of volume and area.
bool CanBeCopied(const PartBody& part, const Vector3& moved, const BodySize& size, const ConvertedBody& body)
{
  const double distance = Norm(moved);
  const bool isNegligible = part.Solid ? distance * size.Area <= CopyShare * size.Volume
                                       : distance <= CopyShare * std::sqrt(size.Area);
  return size.IsKnown && isNegligible && !body.Aborted && body.Messages.empty() && body.MissingFaces == 0 &&
    body.Defects == 0;
}

/// Returns a mesh that shares all but the points of another one, which it is moved by `shift`.
vtkSmartPointer<vtkPolyData> MoveMesh(vtkPolyData* mesh, const Vector3& shift)
{
  vtkPoints* from = mesh->GetPoints();
  const vtkIdType count = mesh->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    Vector3 p;
    from->GetPoint(i, p.data());
    points->SetPoint(i, Sum(p, shift).data());
  }
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->ShallowCopy(mesh);
  moved->SetPoints(points);
  return moved;
}
}

int LeafOptions::GetRoundings() const
{
  return this->FileUnitName.empty() || this->FileUnitName == "mm" ? 0 : UnitRoundings;
}

LeafMaker::LeafMaker(const PartBody& part, const FaceStatements& statements, const LeafOptions& options,
  const EqualPart& equal, const LeafMaker* first, const ProgressCallback& progress)
  : Options(options)
  , Color(part.Color)
  , Model(vtkSmartPointer<vtkTrimmedNURBSModel>::New())
{
  const double start = vtkTimerLog::GetUniversalTime();
  BodySize size;
  ConvertedBody body;
  const bool isCopy = first && first->ForCopies &&
    CatchFailure([&]() { this->Copy(part, equal.Shift, *first, size, body); }).empty();
  if (!isCopy)
  {
    const Vector3 moved = Multiply(options.Unit, equal.Moved);
    this->ConvertGuarded(part, moved, progress, size, body);
    if (equal.HasCopies && CanBeCopied(part, moved, size, body))
    {
      this->ForCopies.reset(new Conversion{ &part, body, size });
    }
    else if (equal.HasCopies && !this->Aborted)
    {
      this->ConvertGuarded(part, Vector3{}, progress, size, body);
    }
  }
  CheckFaces(statements,
    { this->GetStatementPlace(part), part.Solid, size.SignedVolume, std::move(size.FaceAreas) }, body);
  body.MissingFaces = std::max(body.MissingFaces, part.LostFaces);
  body.Messages.insert(body.Messages.end(), part.Messages.begin(), part.Messages.end());
  this->MakeModel(part, size, body);
  if (isCopy)
  {
    this->Model->SetEqualFaces(first->Model->GetFaces());
  }
  this->Summarise(part, body.Messages);
  this->ConversionSeconds = vtkTimerLog::GetUniversalTime() - start - this->MeshSeconds;
}

void LeafMaker::ConvertGuarded(const PartBody& part, const Vector3& moved, const ProgressCallback& progress,
  BodySize& size, ConvertedBody& body)
{
  size = BodySize();
  body = ConvertedBody();
  this->Mesh = nullptr;
  const std::string failure = CatchFailure([&]() { this->Convert(part, moved, progress, size, body); });
  if (!failure.empty())
  {
    body.Messages.push_back("The body could not be carried over: " + failure + ".");
    ++body.MissingFaces;
  }
}

void LeafMaker::Copy(
  const PartBody& part, const Vector3& shift, const LeafMaker& first, BodySize& size, ConvertedBody& body)
{
  const Conversion& from = *first.ForCopies;
  body = CopyConversion(from.Body, from.Part->Shape, part.Shape);
  size = from.Size;
  const Vector3 moved = Multiply(this->Options.Unit, shift);
  double origin[3];
  for (int d = 0; d < 3; ++d)
  {
    origin[d] = first.Model->GetOrigin()[d] + moved[d];
  }
  this->Model->SetOrigin(origin);
  if (vtkPolyData* mesh = first.Model->GetScaleMesh())
  {
    this->Mesh = MoveMesh(mesh, moved);
  }
}

void LeafMaker::Convert(const PartBody& part, const Vector3& moved, const ProgressCallback& progress,
  BodySize& size, ConvertedBody& body)
{
  double bounds[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
  int unbounded = 0;
  if (!GetShapeBounds(part.Shape, bounds, &unbounded))
  {
    std::fill(bounds, bounds + 6, 0.0);
  }
  const double toOutput = part.Scale.GetScale() * this->Options.Unit;
  // The origin is rounded to single precision, so that its subtraction from coordinates near it is exact.
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
  body = ConvertBody(
    part.Shape, part.Scale, this->Options.Unit, origin, report, this->Options.GetRoundings(), moved);
  this->Aborted = body.Aborted;
  if (unbounded > 0)
  {
    body.Messages.insert(body.Messages.begin(),
      std::to_string(unbounded) +
        " faces have no finite bounding box; the size of the body is taken from the others.");
  }
  const double start = vtkTimerLog::GetUniversalTime();
  this->Triangulate(part, box, progress, size, body);
  this->MeshSeconds = vtkTimerLog::GetUniversalTime() - start;
}

StatementPlace LeafMaker::GetStatementPlace(const PartBody& part) const
{
  StatementPlace place;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      place.Linear[i][j] = this->Options.Unit * part.Scale.Linear[i][j];
    }
    place.Shift[i] = this->Options.Unit * part.Scale.Translation[i] - this->Model->GetOrigin()[i];
  }
  return place;
}

void LeafMaker::Triangulate(const PartBody& part, const double box[6], const ProgressCallback& progress,
  BodySize& size, ConvertedBody& body)
{
  std::vector<FacePointer> faces;
  for (const ConvertedFace& face : body.Faces)
  {
    faces.push_back(face.Result);
  }
  const auto report = [&](double x)
  {
    this->Aborted = this->Aborted || !progress(ConversionShare + (1.0 - ConversionShare) * x);
    return !this->Aborted;
  };
  const MeshLimits limits = GetScaleLimits(std::hypot(box[1] - box[0], box[3] - box[2], box[5] - box[4]));
  std::vector<FaceMesh> meshes;
  if (limits.Deflection > 0.0 && std::isfinite(limits.Deflection))
  {
    meshes = MeshForScales(faces, limits, report);
  }
  size = MeasureBody(meshes);
  // A wall may be thinner than the deviation of the triangles on its sides.
  if (part.Solid && size.VolumeError > 0.0 && std::abs(size.SignedVolume) <= size.VolumeError &&
    !this->Aborted)
  {
    const auto again = [&](double) { return report(1.0); };
    const MeshLimits finer{ limits.Deflection / ThinRefinement, limits.Angle };
    const BodySize better = MeasureBody(MeshForScales(faces, finer, again));
    const bool isCertain = std::abs(better.SignedVolume) > better.VolumeError;
    size.Volume = isCertain ? better.Volume : size.Volume;
    size.SignedVolume = isCertain ? better.SignedVolume : 0.0;
  }
  if (!size.IsKnown)
  {
    std::copy(box, box + 6, size.Bounds.begin());
    return;
  }
  if (!this->Aborted)
  {
    const double deflection = GetReachedDeflection(meshes, limits.Deflection);
    this->Mesh = JoinMeshes(faces, std::move(meshes), this->Model->GetOrigin(), deflection, body.Messages);
  }
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
  model->SetScaleMesh(this->Mesh);
  // Released here: VTK's garbage collector needs memory when one of several owners releases a dataset, which
  // must not fail at the end of a run.
  this->Mesh = nullptr;
  model->SetShells(body.Shells);
  model->SetMessages(body.Messages);
  model->SetNumberOfMissingFaces(body.MissingFaces);
  model->SetNumberOfDefects(body.Defects);
}

LeafSource LeafMaker::MakeSource(const BodyInstance& instance) const
{
  return { this->Model, GetPlacement(instance.Place, this->Options.Unit), this->Color, instance.Color };
}
}
