/**
 * @file smSTEPAppearance.h
 * @brief Colours that a STEP file gives its bodies and faces, and materials of its products
 */
#ifndef smSTEPAppearance_h
#define smSTEPAppearance_h

#include "smSTEPAttributes.h"
#include "smVector.h"

#include <cstdint>
#include <string>
#include <unordered_map>
#include <unordered_set>

namespace sm
{
/// Colours, sRGB in [0,1], by the numbers of the entities that have them.
struct STEPColors
{
  /// Of bodies, shells and faces.
  std::unordered_map<std::uint64_t, Vector3> Items;
  /// Of occurrences (NEXT_ASSEMBLY_USAGE_OCCURRENCE).
  std::unordered_map<std::uint64_t, Vector3> Occurrences;
};

/**
 * Reads colours of surfaces: a STYLED_ITEM of a body, shell or face, its SURFACE_STYLE_USAGE, and the fill
 * area of that, with a COLOUR_RGB or one of the eight predefined colours (ISO 10303-46). A style whose
 * context is the shape of an occurrence is that of the occurrence (recommended practice of CAx-IF).
 */
class STEPAppearance
{
public:
  explicit STEPAppearance(const STEPAttributes& entities)
    : Entities(entities)
  {
  }

  STEPColors ReadColors() const;
  /// Returns the numbers of the items, and of the occurrences of products, that an INVISIBILITY hides: by a
  /// STYLED_ITEM, a layer, or a representation with all of its items (ISO 10303-46, invisibility).
  std::unordered_set<std::uint64_t> ReadHiddenItems() const;

private:
  using Index = Part21File::Index;

  std::unordered_map<Index, std::uint64_t> FindOccurrences() const;
  /// Returns the occurrence that the styles of a styled item are for; 0 for none.
  std::uint64_t FindOccurrence(
    const Part21Value& styles, const std::unordered_map<Index, std::uint64_t>& occurrences) const;
  /// Adds the item, or the occurrence, that a styled item is for. Returns false for any other entity.
  bool HideStyled(Index styled, const std::unordered_map<Index, std::uint64_t>& occurrences,
    std::unordered_set<std::uint64_t>& hidden) const;
  bool ReadColor(Index colour, Vector3& color) const;
  bool FindColor(const Part21Value& styles, int depth, Vector3& color) const;

  const STEPAttributes& Entities;
};

/// Returns the names of layers by the numbers of the bodies and representations that are assigned to them.
std::unordered_map<std::uint64_t, std::string> ReadSTEPLayers(const STEPAttributes& entities);

/// Returns the names of materials by the numbers of the PRODUCT_DEFINITIONs that have them: the name of the
/// item of a "material property" with the description "material name" (recommended practice of CAx-IF).
std::unordered_map<std::uint64_t, std::string> ReadSTEPMaterials(const STEPAttributes& entities);
}

#endif
