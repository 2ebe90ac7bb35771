#include "vtkExactGeometryInformation.h"

#include "smOutputData.h"

#include "vtkClientServerStream.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkMultiProcessStream.h"
#include "vtkNURBSDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkTrimmedNURBSModel.h"

vtkStandardNewMacro(vtkExactGeometryInformation);

namespace
{
vtkTrimmedNURBSModel* GetModel(vtkDataObject* data)
{
  auto* leaf = vtkNURBSDataSet::SafeDownCast(data);
  return leaf ? leaf->GetModel() : nullptr;
}
}

vtkExactGeometryInformation::vtkExactGeometryInformation() = default;
vtkExactGeometryInformation::~vtkExactGeometryInformation() = default;

void vtkExactGeometryInformation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PortNumber: " << this->PortNumber << "\n"
     << indent << "HasExactGeometry: " << this->HasExactGeometry << "\n"
     << indent << "LengthUnit: " << this->LengthUnit << "\n";
}

void vtkExactGeometryInformation::CopyFromObject(vtkObject* object)
{
  vtkDataObject* data = sm::GetOutputData(object, this->PortNumber);
  vtkTrimmedNURBSModel* model = GetModel(data);
  bool isCommon = true;
  if (auto* tree = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(tree->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      vtkTrimmedNURBSModel* next = GetModel(iterator->GetCurrentDataObject());
      isCommon = isCommon && (!model || !next || next->GetLengthUnit() == model->GetLengthUnit());
      model = model ? model : next;
    }
  }
  this->HasExactGeometry = model != nullptr;
  this->LengthUnit = model && isCommon ? model->GetLengthUnit() : std::string();
}

void vtkExactGeometryInformation::AddInformation(vtkPVInformation* other)
{
  auto* same = vtkExactGeometryInformation::SafeDownCast(other);
  this->HasExactGeometry = this->HasExactGeometry || (same && same->HasExactGeometry);
  if (same && this->LengthUnit.empty())
  {
    this->LengthUnit = same->LengthUnit;
  }
}

void vtkExactGeometryInformation::CopyToStream(vtkClientServerStream* stream)
{
  stream->Reset();
  *stream << vtkClientServerStream::Reply << static_cast<int>(this->HasExactGeometry)
          << this->LengthUnit.c_str() << vtkClientServerStream::End;
}

void vtkExactGeometryInformation::CopyFromStream(const vtkClientServerStream* stream)
{
  int found = 0;
  if (!stream->GetArgument(0, 0, &found) || !stream->GetArgument(0, 1, &this->LengthUnit))
  {
    vtkErrorMacro("The server sent no information about exact geometry.");
  }
  this->HasExactGeometry = found != 0;
}

void vtkExactGeometryInformation::CopyParametersToStream(vtkMultiProcessStream& stream)
{
  stream << this->PortNumber;
}

void vtkExactGeometryInformation::CopyParametersFromStream(vtkMultiProcessStream& stream)
{
  stream >> this->PortNumber;
}
