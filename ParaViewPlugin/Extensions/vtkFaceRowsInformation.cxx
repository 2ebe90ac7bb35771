#include "vtkFaceRowsInformation.h"

#include "smIntegralNames.h"
#include "smOutputData.h"

#include "vtkClientServerStream.h"
#include "vtkDataArray.h"
#include "vtkMultiProcessStream.h"
#include "vtkNURBSDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkFaceRowsInformation);

vtkFaceRowsInformation::vtkFaceRowsInformation() = default;
vtkFaceRowsInformation::~vtkFaceRowsInformation() = default;

void vtkFaceRowsInformation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PortNumber: " << this->PortNumber << "\n"
     << indent << "Rows: " << this->Rows.size() << "\n"
     << indent << "Solids with faces: " << this->Faces.size() << "\n";
}

void vtkFaceRowsInformation::CopyFromObject(vtkObject* object)
{
  this->Faces.clear();
  auto* table = vtkTable::SafeDownCast(sm::GetOutputData(object, this->PortNumber));
  auto* solids = table ? vtkDataArray::SafeDownCast(table->GetColumnByName(sm::names::Solid)) : nullptr;
  auto* faces = table
    ? vtkDataArray::SafeDownCast(table->GetColumnByName(vtkNURBSDataSet::FaceIndexArrayName()))
    : nullptr;
  for (const vtkIdType row : this->Rows)
  {
    if (solids && faces && row >= 0 && row < table->GetNumberOfRows())
    {
      this->Faces[static_cast<int>(solids->GetComponent(row, 0))].insert(
        static_cast<int>(faces->GetComponent(row, 0)));
    }
  }
}

void vtkFaceRowsInformation::AddInformation(vtkPVInformation* other)
{
  // One rank has the rows, the others have a table without any.
  auto* same = vtkFaceRowsInformation::SafeDownCast(other);
  if (same && this->Faces.empty())
  {
    this->Faces = same->Faces;
  }
}

void vtkFaceRowsInformation::CopyToStream(vtkClientServerStream* stream)
{
  int count = 0;
  for (const auto& solid : this->Faces)
  {
    count += static_cast<int>(solid.second.size());
  }
  stream->Reset();
  *stream << vtkClientServerStream::Reply << count;
  for (const auto& [solid, faces] : this->Faces)
  {
    for (const int face : faces)
    {
      *stream << solid << face;
    }
  }
  *stream << vtkClientServerStream::End;
}

void vtkFaceRowsInformation::CopyFromStream(const vtkClientServerStream* stream)
{
  this->Faces.clear();
  int count = 0;
  bool isRead = stream->GetArgument(0, 0, &count) != 0;
  for (int i = 0; isRead && i < count; ++i)
  {
    int solid = 0;
    int face = 0;
    isRead = stream->GetArgument(0, 2 * i + 1, &solid) != 0 && stream->GetArgument(0, 2 * i + 2, &face) != 0;
    this->Faces[solid].insert(face);
  }
  if (!isRead)
  {
    this->Faces.clear();
    vtkErrorMacro("The server sent no information about the rows of faces.");
  }
}

void vtkFaceRowsInformation::CopyParametersToStream(vtkMultiProcessStream& stream)
{
  stream << this->PortNumber << static_cast<int>(this->Rows.size());
  for (const vtkIdType row : this->Rows)
  {
    stream << static_cast<vtkTypeInt64>(row);
  }
}

void vtkFaceRowsInformation::CopyParametersFromStream(vtkMultiProcessStream& stream)
{
  int count = 0;
  stream >> this->PortNumber >> count;
  this->Rows.clear();
  for (int i = 0; i < count; ++i)
  {
    vtkTypeInt64 row = 0;
    stream >> row;
    this->Rows.push_back(static_cast<vtkIdType>(row));
  }
}
