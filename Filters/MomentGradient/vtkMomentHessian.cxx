#include "vtkMomentHessian.h"

#include "smMomentHessian.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <vector>

vtkStandardNewMacro(vtkMomentHessian);

struct vtkMomentHessian::Internals
{
  std::vector<sm::NetDirection> Direction;
  sm::MomentHessianResult Result;
  std::vector<std::array<vtkSmartPointer<vtkDoubleArray>, 2>> Arrays;

  const sm::FaceHessianProduct* Find(int index) const
  {
    return index >= 0 && index < static_cast<int>(this->Result.Faces.size()) ? &this->Result.Faces[index]
                                                                             : nullptr;
  }
};

vtkMomentHessian::vtkMomentHessian()
  : Implementation(new Internals)
{
}

vtkMomentHessian::~vtkMomentHessian() = default;

void vtkMomentHessian::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tied: " << this->Tied << "\n"
     << indent << "RelativeTolerance: " << this->RelativeTolerance << "\n"
     << indent << "Faces that move: " << this->Implementation->Direction.size() << "\n"
     << indent << "Status: " << this->Implementation->Result.Status << "\n";
}

bool vtkMomentHessian::AddDisplacements(int solid, int face, vtkDoubleArray* displacements)
{
  if (!displacements || displacements->GetNumberOfComponents() != 3)
  {
    return false;
  }
  sm::NetDirection net;
  net.Solid = solid;
  net.Face = face;
  for (vtkIdType i = 0; i < displacements->GetNumberOfTuples(); ++i)
  {
    std::array<double, 3> by;
    displacements->GetTypedTuple(i, by.data());
    net.Displacements.push_back(by);
  }
  this->Implementation->Direction.push_back(std::move(net));
  this->Modified();
  return true;
}

void vtkMomentHessian::ClearDisplacements()
{
  this->Implementation->Direction.clear();
  this->Modified();
}

bool vtkMomentHessian::Compute(vtkDataObject* model)
{
  sm::MomentHessianOptions options;
  options.Tied = this->Tied;
  options.RelativeTolerance = this->RelativeTolerance;
  Internals& internals = *this->Implementation;
  internals.Result = sm::ComputeMomentHessianProduct(model, internals.Direction, options);
  internals.Arrays.clear();
  for (const sm::FaceHessianProduct& face : internals.Result.Faces)
  {
    std::array<vtkSmartPointer<vtkDoubleArray>, 2> arrays;
    for (int which = 0; which < 2; ++which)
    {
      const std::vector<double>& from = which == 0 ? face.Values : face.Bounds;
      arrays[which] = vtkSmartPointer<vtkDoubleArray>::New();
      arrays[which]->SetNumberOfComponents(3 * sm::NumberOfHessianQuantities);
      arrays[which]->SetNumberOfTuples(
        static_cast<vtkIdType>(from.size()) / arrays[which]->GetNumberOfComponents());
      std::copy(from.begin(), from.end(), arrays[which]->GetPointer(0));
    }
    internals.Arrays.push_back(arrays);
  }
  return !internals.Result.Faces.empty();
}

std::string vtkMomentHessian::GetStatus() const
{
  return this->Implementation->Result.Status;
}

std::string vtkMomentHessian::GetReason() const
{
  return this->Implementation->Result.Reason;
}

int vtkMomentHessian::GetNumberOfMessages() const
{
  return static_cast<int>(this->Implementation->Result.Messages.size());
}

std::string vtkMomentHessian::GetMessage(int index) const
{
  return index >= 0 && index < this->GetNumberOfMessages() ? this->Implementation->Result.Messages[index]
                                                           : "";
}

std::string vtkMomentHessian::GetLengthUnit() const
{
  return this->Implementation->Result.LengthUnit;
}

int vtkMomentHessian::GetNumberOfFaces() const
{
  return static_cast<int>(this->Implementation->Result.Faces.size());
}

vtkDoubleArray* vtkMomentHessian::GetValues(int index) const
{
  return this->Implementation->Find(index) ? this->Implementation->Arrays[index][0].Get() : nullptr;
}

vtkDoubleArray* vtkMomentHessian::GetBounds(int index) const
{
  return this->Implementation->Find(index) ? this->Implementation->Arrays[index][1].Get() : nullptr;
}

int vtkMomentHessian::GetCountU(int index) const
{
  const sm::FaceHessianProduct* face = this->Implementation->Find(index);
  return face ? face->Count[0] : 0;
}

int vtkMomentHessian::GetCountV(int index) const
{
  const sm::FaceHessianProduct* face = this->Implementation->Find(index);
  return face ? face->Count[1] : 0;
}

int vtkMomentHessian::GetSolid(int index) const
{
  const sm::FaceHessianProduct* face = this->Implementation->Find(index);
  return face ? face->Solid : -1;
}

int vtkMomentHessian::GetFace(int index) const
{
  const sm::FaceHessianProduct* face = this->Implementation->Find(index);
  return face ? face->Face : -1;
}

bool vtkMomentHessian::HasTiedBorder(int index) const
{
  const sm::FaceHessianProduct* face = this->Implementation->Find(index);
  return face && face->HasTiedBorder;
}
