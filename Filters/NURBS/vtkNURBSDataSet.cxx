#include "vtkNURBSDataSet.h"

#include "smWholeSphere.h"

#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkTrimmedNURBSModel.h"

#include <algorithm>

namespace
{
/// A hash of a point's coordinates, bit by bit, and of its index.
template <typename Bits>
std::uint64_t HashPoint(const void* coordinates, vtkIdType point)
{
  const Bits* bits = static_cast<const Bits*>(coordinates) + 3 * point;
  std::uint64_t hash = static_cast<std::uint64_t>(point);
  for (int c = 0; c < 3; ++c)
  {
    hash = (hash ^ bits[c]) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 32;
  }
  return hash;
}

/// Calls `use` with the hash of points by their indices.
template <typename Use>
void UseHash(vtkPoints* points, const Use& use)
{
  const void* coordinates = points->GetVoidPointer(0);
  const auto visit = [&](auto zero)
  { use([coordinates](vtkIdType point) { return HashPoint<decltype(zero)>(coordinates, point); }); };
  switch (points->GetData()->GetDataTypeSize())
  {
    case 8:
      return visit(std::uint64_t{});
    case 4:
      return visit(std::uint32_t{});
    case 2:
      return visit(std::uint16_t{});
    default:
      return visit(std::uint8_t{});
  }
}

/// The sum of the hashes of all points, so that the change by a few of them can be added.
std::uint64_t HashPoints(vtkPoints* points)
{
  std::uint64_t sum = 0;
  UseHash(points,
    [&](const auto& hash)
    {
      for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
      {
        sum += hash(i);
      }
    });
  return sum;
}

std::uint64_t HashPoints(vtkPoints* points, const std::vector<vtkIdType>& chosen)
{
  std::uint64_t sum = 0;
  UseHash(points,
    [&](const auto& hash)
    {
      for (const vtkIdType i : chosen)
      {
        sum += hash(i);
      }
    });
  return sum;
}
}

vtkStandardNewMacro(vtkNURBSDataSet);
vtkStandardExtendedNewMacro(vtkNURBSDataSet);
vtkInformationKeyMacro(vtkNURBSDataSet, EXACT_MARK, Integer);
vtkInformationKeyMacro(vtkNURBSDataSet, MESH_OUTPUT, Integer);
vtkInformationKeyMacro(vtkNURBSDataSet, MESH_REQUESTED, Integer);

vtkNURBSDataSet::vtkNURBSDataSet()
{
  vtkMatrix4x4::Identity(this->Placement);
}

vtkNURBSDataSet::~vtkNURBSDataSet() = default;

void vtkNURBSDataSet::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Model: " << (this->Model ? this->Model->GetName() : "(none)")
     << (this->IsModelWithheld() ? " (withheld: the points changed)" : "") << "\n"
     << indent << "PartName: " << this->PartName << "\n"
     << indent << "PartPath: " << this->PartPath << "\n";
}

void vtkNURBSDataSet::SetModel(vtkTrimmedNURBSModel* model)
{
  this->Model = model;
  this->ModelPoints = model ? this->GetPoints() : nullptr;
  this->ModelPointsTime = this->ModelPoints ? this->ModelPoints->GetMTime() : 0;
  this->ModelPointsHash = this->ModelPoints ? HashPoints(this->ModelPoints) : 0;
  this->Modified();
}

void vtkNURBSDataSet::SetModelAndPoints(
  vtkTrimmedNURBSModel* model, vtkPoints* points, const std::vector<vtkIdType>& moved)
{
  const std::uint64_t hash =
    this->ModelPointsHash - HashPoints(this->ModelPoints, moved) + HashPoints(points, moved);
  this->SetPoints(points);
  this->Model = model;
  this->ModelPoints = points;
  this->ModelPointsTime = points->GetMTime();
  this->ModelPointsHash = hash;
  this->Modified();
}

bool vtkNURBSDataSet::ArePointsOriginal()
{
  vtkPoints* points = this->GetPoints();
  if (!points || points != this->ModelPoints || points->GetMTime() <= this->ModelPointsTime)
  {
    return points == this->ModelPoints;
  }
  // Filters such as vtkTableBasedClipDataSet call Modified() on points of their input that they only read.
  const vtkMTimeType time = points->GetMTime();
  const bool areEqual = HashPoints(points) == this->ModelPointsHash;
  this->ModelPointsTime = areEqual ? time : this->ModelPointsTime;
  return areEqual;
}

vtkTrimmedNURBSModel* vtkNURBSDataSet::GetModel()
{
  return this->Model && this->ArePointsOriginal() ? this->Model.Get() : nullptr;
}

bool vtkNURBSDataSet::IsModelWithheld()
{
  return this->Model && !this->ArePointsOriginal();
}

void vtkNURBSDataSet::SetPlacement(vtkMatrix4x4* placement)
{
  std::copy_n(placement->GetData(), 16, this->Placement);
  this->Modified();
}

void vtkNURBSDataSet::GetPlacement(vtkMatrix4x4* placement)
{
  placement->DeepCopy(this->Placement);
}

void vtkNURBSDataSet::SetPartName(const std::string& name)
{
  this->PartName = name;
  this->Modified();
}

void vtkNURBSDataSet::SetPartPath(const std::string& path)
{
  this->PartPath = path;
  this->Modified();
}

void vtkNURBSDataSet::DropModel()
{
  this->PartName.clear();
  this->PartPath.clear();
  this->Model = nullptr;
  this->ModelPoints = nullptr;
  this->ModelPointsTime = 0;
  this->ModelPointsHash = 0;
  vtkMatrix4x4::Identity(this->Placement);
}

void vtkNURBSDataSet::CopyModel(vtkNURBSDataSet* source)
{
  if (!source || !source->GetModel())
  {
    this->DropModel();
    return;
  }
  std::copy_n(source->Placement, 16, this->Placement);
  this->PartName = source->PartName;
  this->PartPath = source->PartPath;
  if (this->GetPoints() != source->ModelPoints)
  {
    this->SetModel(source->Model);
    return;
  }
  // The points are shared and were just compared with their hash.
  this->Model = source->Model;
  this->ModelPoints = source->ModelPoints;
  this->ModelPointsTime = source->ModelPointsTime;
  this->ModelPointsHash = source->ModelPointsHash;
  this->Modified();
}

void vtkNURBSDataSet::Initialize()
{
  this->Superclass::Initialize();
  this->DropModel();
}

void vtkNURBSDataSet::ShallowCopy(vtkDataObject* source)
{
  if (source == this)
  {
    return;
  }
  this->Superclass::ShallowCopy(source);
  this->CopyModel(vtkNURBSDataSet::SafeDownCast(source));
}

void vtkNURBSDataSet::DeepCopy(vtkDataObject* source)
{
  if (source == this)
  {
    return;
  }
  this->Superclass::DeepCopy(source);
  this->CopyModel(vtkNURBSDataSet::SafeDownCast(source));
}

void vtkNURBSDataSet::CopyStructure(vtkDataSet* source)
{
  this->Superclass::CopyStructure(source);
  this->DropModel();
}

unsigned long vtkNURBSDataSet::GetActualMemorySize()
{
  return this->Superclass::GetActualMemorySize() + (this->Model ? this->Model->GetActualMemorySize() : 0);
}

bool vtkNURBSDataSet::GetBodyBounds(double bounds[6])
{
  vtkTrimmedNURBSModel* model = this->GetModel();
  vtkPolyData* mesh = model ? model->GetScaleMesh() : nullptr;
  if (!mesh || mesh->GetNumberOfPoints() == 0)
  {
    if (this->GetNumberOfPoints() > 0)
    {
      this->Superclass::ComputeBounds();
      std::copy_n(this->Bounds, 6, bounds);
    }
    return this->GetNumberOfPoints() > 0;
  }
  vtkBoundingBox box;
  const double* m = this->Placement;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    mesh->GetPoint(i, p);
    for (int r = 0; r < 3; ++r)
    {
      q[r] = m[4 * r] * p[0] + m[4 * r + 1] * p[1] + m[4 * r + 2] * p[2] + m[4 * r + 3];
    }
    box.AddPoint(q);
  }
  // Whole spheres have few triangles.
  const double* origin = model->GetOrigin();
  for (const sm::WholeSphere& sphere : sm::FindWholeSpheres(model->GetFaces()))
  {
    for (int r = 0; r < 3 && sphere; ++r)
    {
      double middle = m[4 * r + 3];
      for (int c = 0; c < 3; ++c)
      {
        middle += m[4 * r + c] * (origin[c] + sphere.Center[c]);
      }
      // A placement is rigid or mirrors: its rows are unit vectors.
      double ends[6];
      box.GetBounds(ends);
      ends[2 * r] = std::min(ends[2 * r], middle - sphere.Radius);
      ends[2 * r + 1] = std::max(ends[2 * r + 1], middle + sphere.Radius);
      box.SetBounds(ends);
    }
  }
  box.GetBounds(bounds);
  return true;
}

void vtkNURBSDataSet::ComputeBounds()
{
  if (this->GetNumberOfPoints() > 0 || !this->GetModel())
  {
    this->Superclass::ComputeBounds();
  }
  else if (this->GetMTime() > this->ComputeTime)
  {
    vtkMath::UninitializeBounds(this->Bounds);
    this->GetBodyBounds(this->Bounds);
    this->ComputeTime.Modified();
  }
}

vtkMTimeType vtkNURBSDataSet::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Model ? std::max(time, this->Model->GetMTime()) : time;
}

vtkNURBSDataSet* vtkNURBSDataSet::GetData(vtkInformation* info)
{
  return info ? vtkNURBSDataSet::SafeDownCast(info->Get(vtkDataObject::DATA_OBJECT())) : nullptr;
}

vtkNURBSDataSet* vtkNURBSDataSet::GetData(vtkInformationVector* vector, int index)
{
  return vtkNURBSDataSet::GetData(vector->GetInformationObject(index));
}
