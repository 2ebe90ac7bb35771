/**
 * @file smSTEPAttributes.h
 * @brief Attributes of entities, wherever a simple or a complex instance has them
 */
#ifndef smSTEPAttributes_h
#define smSTEPAttributes_h

#include "smPart21File.h"
#include "smSTEPSchema.h"

#include <string_view>
#include <vector>

namespace sm
{
/// An attribute of an entity type: its place in a simple instance and in the record of a complex one.
struct STEPAttribute
{
  /// The record of a complex instance.
  const char* Record;
  std::size_t Own;
  std::size_t Simple;
  /// For messages.
  const char* Name;
};

class STEPAttributes
{
public:
  using Index = Part21File::Index;
  static constexpr Index None = Part21File::None;

  explicit STEPAttributes(const Part21File& file);

  /// Null for a type that the table does not have.
  const STEPEntityType* GetType(Index i, std::size_t record = 0) const
  {
    return this->Types[this->File.GetType(i, record)];
  }
  /// The roles of all records together.
  std::uint64_t GetRoles(Index i) const { return this->Roles[i]; }
  bool Has(Index i, std::uint64_t roles) const { return i != None && (this->Roles[i] & roles) != 0; }
  /// The type of the entity is one of those that the census knows.
  bool IsKnown(Index i) const { return i != None && this->Roles[i] != 0; }

  /// The parameters of the record with this name, or of a simple instance; false without one, or for None.
  bool FindRecord(Index i, std::string_view record, std::string_view& parameters) const;
  /// Malformed when there is none, or for None.
  Part21Value Get(Index i, const STEPAttribute& attribute) const;
  /// The entity that a reference names, None for other values and undefined ones.
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
