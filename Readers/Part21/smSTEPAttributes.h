/**
 * @file smSTEPAttributes.h
 * @brief Reads attributes of entities by name, from simple and from complex instances
 */
#ifndef smSTEPAttributes_h
#define smSTEPAttributes_h

#include "smPart21File.h"
#include "smSTEPSchema.h"

#include <string_view>
#include <vector>

namespace sm
{
/// An attribute of an entity type: its position among the parameters of a simple instance, and in the record
/// of a complex one.
struct STEPAttribute
{
  /// Name of the record in a complex instance that has the attribute.
  const char* Record;
  std::size_t Own;
  std::size_t Simple;
  /// Name of the attribute, for messages.
  const char* Name;
};

class SMREADERSPART21_EXPORT STEPAttributes
{
public:
  using Index = Part21File::Index;
  static constexpr Index None = Part21File::None;

  explicit STEPAttributes(const Part21File& file);

  /// Returns the description of the type of a record (smSTEPSchema.h); null for a type that the table does
  /// not have.
  const STEPEntityType* GetType(Index i, std::size_t record = 0) const
  {
    return this->Types[this->File.GetType(i, record)];
  }
  /// Returns the roles of all records of an instance.
  std::uint64_t GetRoles(Index i) const { return this->Roles[i]; }
  bool Has(Index i, std::uint64_t roles) const { return i != None && (this->Roles[i] & roles) != 0; }
  /// Returns true if the type of the entity is known to the census.
  bool IsKnown(Index i) const { return i != None && this->Roles[i] != 0; }

  /// Returns true for a NEXT_ASSEMBLY_USAGE_OCCURRENCE that is written as a complex instance of its own
  /// types.
  bool IsOccurrenceInParts(Index i) const;

  /// Gets the parameters of the record with this name, or of a simple instance of this type. Returns false if
  /// there is none, or for None.
  bool FindRecord(Index i, std::string_view record, std::string_view& parameters) const;
  /// Returns the value of an attribute; Malformed if there is none, or for None.
  Part21Value Get(Index i, const STEPAttribute& attribute) const;
  /// Returns the entity that a reference names; None for other values and for undefined references.
  Index Follow(const Part21Value& value) const
  {
    return value.IsReference() ? this->File.Find(value.Id) : None;
  }

  const Part21File& File;

private:
  std::vector<const STEPEntityType*> Types;
  std::vector<std::uint64_t> Roles;
};
}

#endif
