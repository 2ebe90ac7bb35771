#include "smSTEPAttributes.h"

namespace sm
{
STEPAttributes::STEPAttributes(const Part21File& file)
  : File(file)
{
  for (const std::string& name : file.GetTypeNames())
  {
    this->Types.push_back(FindSTEPEntityType(name));
  }
  this->Roles.resize(file.GetNumberOfInstances());
  for (Index i = 0; i < file.GetNumberOfInstances(); ++i)
  {
    for (std::size_t k = 0; k < file.GetNumberOfRecords(i); ++k)
    {
      const STEPEntityType* type = this->GetType(i, k);
      this->Roles[i] |= type ? type->Roles : 0;
    }
    // The types that an occurrence has above its own make it no other usage.
    this->Roles[i] &= this->IsOccurrenceInParts(i) ? ~STEPRole::OtherUsage : ~std::uint64_t{ 0 };
  }
}

bool STEPAttributes::IsOccurrenceInParts(Index i) const
{
  std::string_view parameters;
  return this->Has(i, STEPRole::Occurrence) && this->File.GetNumberOfRecords(i) == 4 &&
    this->FindRecord(i, "ASSEMBLY_COMPONENT_USAGE", parameters) &&
    this->FindRecord(i, "PRODUCT_DEFINITION_RELATIONSHIP", parameters) &&
    this->FindRecord(i, "PRODUCT_DEFINITION_USAGE", parameters);
}

bool STEPAttributes::FindRecord(Index i, std::string_view record, std::string_view& parameters) const
{
  for (std::size_t k = 0; i != None && k < this->File.GetNumberOfRecords(i); ++k)
  {
    if (this->File.GetTypeNames()[this->File.GetType(i, k)] == record)
    {
      parameters = this->File.GetParameters(i, k);
      return true;
    }
  }
  return false;
}

Part21Value STEPAttributes::Get(Index i, const STEPAttribute& attribute) const
{
  if (i == None)
  {
    return Part21Value();
  }
  if (!this->File.IsComplex(i))
  {
    return GetPart21Value(this->File.GetParameters(i), attribute.Simple);
  }
  std::string_view parameters;
  return this->FindRecord(i, attribute.Record, parameters) ? GetPart21Value(parameters, attribute.Own)
                                                           : Part21Value();
}
}
