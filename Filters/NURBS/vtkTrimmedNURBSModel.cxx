#include "vtkTrimmedNURBSModel.h"

#include "vtkObjectFactory.h"

#include <limits>
#include <unordered_set>
#include <utility>

vtkStandardNewMacro(vtkTrimmedNURBSModel);

vtkTrimmedNURBSModel::vtkTrimmedNURBSModel()
  : FileVolume(std::numeric_limits<double>::quiet_NaN())
  , FileArea(std::numeric_limits<double>::quiet_NaN())
{
}

vtkTrimmedNURBSModel::~vtkTrimmedNURBSModel() = default;

void vtkTrimmedNURBSModel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Name: " << this->Name << "\n"
     << indent << "Body: " << (this->Body == SOLID ? "solid" : "shell") << "\n"
     << indent << "FileId: " << this->FileId << "\n"
     << indent << "LengthUnit: " << this->LengthUnit << "\n"
     << indent << "Faces: " << this->Faces.size() << "\n"
     << indent << "Shells: " << this->Shells.size() << "\n"
     << indent << "NumberOfMissingFaces: " << this->NumberOfMissingFaces << "\n"
     << indent << "NumberOfDefects: " << this->NumberOfDefects << "\n";
}

vtkIdType vtkTrimmedNURBSModel::GetNumberOfEdges() const
{
  std::unordered_set<const sm::Edge*> edges;
  for (const sm::FacePointer& face : this->Faces)
  {
    for (const sm::Loop& loop : face->Loops)
    {
      for (const sm::Coedge& coedge : loop.Coedges)
      {
        edges.insert(coedge.Use.get());
      }
    }
  }
  return static_cast<vtkIdType>(edges.size());
}

void vtkTrimmedNURBSModel::SetFaces(std::vector<sm::FacePointer> faces)
{
  this->Faces = std::move(faces);
  this->Modified();
}

void vtkTrimmedNURBSModel::SetFace(vtkIdType index, sm::FacePointer face)
{
  if (index < 0 || index >= this->GetNumberOfFaces() || !face)
  {
    vtkErrorMacro("SetFace: face " << index << " of " << this->GetNumberOfFaces()
                                   << " does not exist, or the new face is null.");
    return;
  }
  this->Faces[index] = std::move(face);
  this->Modified();
}

void vtkTrimmedNURBSModel::SetShells(std::vector<std::vector<int>> shells)
{
  this->Shells = std::move(shells);
  this->Modified();
}

void vtkTrimmedNURBSModel::SetMessages(std::vector<std::string> messages)
{
  this->Messages = std::move(messages);
  this->Modified();
}

void vtkTrimmedNURBSModel::ShallowCopy(vtkTrimmedNURBSModel* source)
{
  if (!source || source == this)
  {
    return;
  }
  this->Body = source->Body;
  this->Name = source->Name;
  this->FileId = source->FileId;
  this->LengthUnit = source->LengthUnit;
  this->FileUnit = source->FileUnit;
  this->Material = source->Material;
  this->Density = source->Density;
  this->FileVolume = source->FileVolume;
  this->FileArea = source->FileArea;
  this->NumberOfMissingFaces = source->NumberOfMissingFaces;
  this->NumberOfDefects = source->NumberOfDefects;
  for (int i = 0; i < 3; ++i)
  {
    this->Origin[i] = source->Origin[i];
  }
  for (int i = 0; i < 6; ++i)
  {
    this->LocalBounds[i] = source->LocalBounds[i];
  }
  this->VolumeScale = source->VolumeScale;
  this->AreaScale = source->AreaScale;
  this->Faces = source->Faces;
  this->Shells = source->Shells;
  this->Messages = source->Messages;
  this->Modified();
}

unsigned long vtkTrimmedNURBSModel::GetActualMemorySize() const
{
  std::size_t bytes = sizeof(*this);
  std::unordered_set<const sm::Edge*> edges;
  for (const sm::FacePointer& face : this->Faces)
  {
    bytes += sm::GetMemorySize(*face);
    for (const sm::Loop& loop : face->Loops)
    {
      for (const sm::Coedge& coedge : loop.Coedges)
      {
        if (edges.insert(coedge.Use.get()).second)
        {
          bytes += sizeof(sm::Edge) + coedge.Use->Curve.Coefficients.size() * sizeof(sm::EdgeCurve::Point);
        }
      }
    }
  }
  return static_cast<unsigned long>(bytes / 1024 + 1);
}
