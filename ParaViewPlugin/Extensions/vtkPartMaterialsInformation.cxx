#include "vtkPartMaterialsInformation.h"

#include "smColumns.h"
#include "smInstanceNames.h"
#include "smMassPropertyNames.h"
#include "smOutputData.h"
#include "smTableCells.h"

#include "vtkClientServerStream.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiProcessStream.h"
#include "vtkNURBSDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkTable.h"
#include "vtkTrimmedNURBSModel.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <unordered_map>

vtkStandardNewMacro(vtkPartMaterialsInformation);

namespace
{
/// Collects solids with the same name as one part.
class PartCollector
{
public:
  explicit PartCollector(std::vector<sm::PartMaterial>& parts)
    : Parts(parts)
  {
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      this->Rows[parts[i].Name] = i;
    }
  }

  void Add(const sm::PartMaterial& part)
  {
    const auto [row, isNew] = this->Rows.emplace(part.Name, this->Parts.size());
    if (isNew)
    {
      this->Parts.push_back(part);
      return;
    }
    sm::PartMaterial& known = this->Parts[row->second];
    known.HasSeveral =
      known.HasSeveral || part.HasSeveral || known.Density != part.Density || known.Material != part.Material;
    known.Solids += part.Solids;
    known.Weighed += part.Weighed;
    known.Mass += part.Mass;
  }

private:
  std::vector<sm::PartMaterial>& Parts;
  std::unordered_map<std::string, std::size_t> Rows;
};

void AddModels(vtkDataObject* data, const std::string& name, PartCollector& parts)
{
  const auto getName = [&name](vtkInformation* info)
  {
    const char* own = info ? info->Get(vtkCompositeDataSet::NAME()) : nullptr;
    return own && *own ? std::string(own) : name;
  };
  if (auto* leaf = vtkNURBSDataSet::SafeDownCast(data))
  {
    if (vtkTrimmedNURBSModel* model = leaf->GetModel())
    {
      sm::PartMaterial part;
      part.Name = sm::GetPartName(*leaf, name);
      part.Material = model->GetMaterial();
      part.Density = model->GetDensity();
      parts.Add(part);
    }
  }
  else if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
    {
      AddModels(collection->GetPartitionedDataSet(i),
        getName(collection->HasMetaData(i) ? collection->GetMetaData(i) : nullptr), parts);
    }
  }
  else if (auto* pieces = vtkPartitionedDataSet::SafeDownCast(data))
  {
    for (unsigned int i = 0; i < pieces->GetNumberOfPartitions(); ++i)
    {
      AddModels(pieces->GetPartitionAsDataObject(i), name, parts);
    }
  }
}

void AddRows(vtkTable* table, PartCollector& parts)
{
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    if (sm::columns::IsTotalRow(table, row))
    {
      continue;
    }
    sm::PartMaterial part;
    part.Name = sm::GetText(table, sm::names::Name, row);
    part.Solids = std::isfinite(sm::GetNumber(table, sm::names::Volume, row)) ? 1 : 0;
    const double mass = sm::GetNumber(table, sm::names::Mass, row);
    part.Weighed = std::isfinite(mass) ? 1 : 0;
    part.Mass = part.Weighed ? mass : 0.0;
    parts.Add(part);
  }
}
}

vtkPartMaterialsInformation::vtkPartMaterialsInformation() = default;
vtkPartMaterialsInformation::~vtkPartMaterialsInformation() = default;

void vtkPartMaterialsInformation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PortNumber: " << this->PortNumber << "\n"
     << indent << "Parts: " << this->Parts.size() << "\n";
}

void vtkPartMaterialsInformation::CopyFromObject(vtkObject* object)
{
  this->Parts.clear();
  PartCollector parts(this->Parts);
  vtkDataObject* data = sm::GetOutputData(object, this->PortNumber);
  if (auto* table = vtkTable::SafeDownCast(data))
  {
    AddRows(table, parts);
  }
  else
  {
    AddModels(data, {}, parts);
  }
}

void vtkPartMaterialsInformation::AddInformation(vtkPVInformation* other)
{
  if (auto* same = vtkPartMaterialsInformation::SafeDownCast(other))
  {
    PartCollector parts(this->Parts);
    for (const sm::PartMaterial& part : same->Parts)
    {
      parts.Add(part);
    }
  }
}

void vtkPartMaterialsInformation::CopyToStream(vtkClientServerStream* stream)
{
  stream->Reset();
  *stream << vtkClientServerStream::Reply << static_cast<int>(this->Parts.size());
  for (const sm::PartMaterial& part : this->Parts)
  {
    *stream << part.Name.c_str() << part.Solids << part.Material.c_str() << part.Density
            << static_cast<int>(part.HasSeveral) << part.Weighed << part.Mass;
  }
  *stream << vtkClientServerStream::End;
}

void vtkPartMaterialsInformation::CopyFromStream(const vtkClientServerStream* stream)
{
  int count = 0;
  int argument = 0;
  const auto take = [stream, &argument](auto* value)
  { return stream->GetArgument(0, argument++, value) != 0; };
  bool isRead = take(&count);
  this->Parts.clear();
  for (int i = 0; isRead && i < count; ++i)
  {
    sm::PartMaterial part;
    int hasSeveral = 0;
    isRead = take(&part.Name) && take(&part.Solids) && take(&part.Material) && take(&part.Density) &&
      take(&hasSeveral) && take(&part.Weighed) && take(&part.Mass);
    part.HasSeveral = hasSeveral != 0;
    this->Parts.push_back(part);
  }
  if (!isRead)
  {
    this->Parts.clear();
    vtkErrorMacro("The server sent no information about the materials of parts.");
  }
}

void vtkPartMaterialsInformation::CopyParametersToStream(vtkMultiProcessStream& stream)
{
  stream << this->PortNumber;
}

void vtkPartMaterialsInformation::CopyParametersFromStream(vtkMultiProcessStream& stream)
{
  stream >> this->PortNumber;
}
