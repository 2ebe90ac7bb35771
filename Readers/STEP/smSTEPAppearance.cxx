#include "smSTEPAppearance.h"

#include "smSTEPPropertyAttributes.h"
#include "smTextEncoding.h"

#include <algorithm>
#include <iterator>

namespace sm
{
namespace
{
constexpr STEPAttribute ContextOfStyle = { "PRESENTATION_STYLE_BY_CONTEXT", 0, 1, "context" };
constexpr STEPAttribute RedOfColour = { "COLOUR_RGB", 0, 1, "red" };
constexpr STEPAttribute GreenOfColour = { "COLOUR_RGB", 1, 2, "green" };
constexpr STEPAttribute BlueOfColour = { "COLOUR_RGB", 2, 3, "blue" };

/// Entities between a styled item and its colour, and the parameter that leads on.
constexpr struct
{
  const char* Record;
  std::size_t Parameter;
} Steps[] = { { "PRESENTATION_STYLE_ASSIGNMENT", 0 }, { "PRESENTATION_STYLE_BY_CONTEXT", 0 },
  { "SURFACE_STYLE_USAGE", 1 }, { "SURFACE_SIDE_STYLE", 1 }, { "SURFACE_STYLE_FILL_AREA", 0 },
  { "FILL_AREA_STYLE", 1 }, { "FILL_AREA_STYLE_COLOUR", 1 }, { "SURFACE_STYLE_RENDERING", 1 },
  { "SURFACE_STYLE_RENDERING_WITH_PROPERTIES", 1 } };
constexpr int MaxChain = 8;

/// Types of styled items, and the parameters that they share.
constexpr const char* StyledTypes[] = { "STYLED_ITEM", "OVER_RIDING_STYLED_ITEM",
  "CONTEXT_DEPENDENT_OVER_RIDING_STYLED_ITEM" };
constexpr std::size_t StylesOfStyled = 1;
constexpr std::size_t ItemOfStyled = 2;

constexpr struct
{
  const char* Name;
  double Color[3];
} Predefined[] = { { "red", { 1, 0, 0 } }, { "green", { 0, 1, 0 } }, { "blue", { 0, 0, 1 } },
  { "yellow", { 1, 1, 0 } }, { "magenta", { 1, 0, 1 } }, { "cyan", { 0, 1, 1 } }, { "black", { 0, 0, 0 } },
  { "white", { 1, 1, 1 } } };
}

bool STEPAppearance::ReadColor(Index colour, Vector3& color) const
{
  std::string_view record;
  if (this->Entities.FindRecord(colour, RedOfColour.Record, record))
  {
    return this->Entities.Get(colour, RedOfColour).GetNumber(color[0]) &&
      this->Entities.Get(colour, GreenOfColour).GetNumber(color[1]) &&
      this->Entities.Get(colour, BlueOfColour).GetNumber(color[2]);
  }
  if (this->Entities.FindRecord(colour, "DRAUGHTING_PRE_DEFINED_COLOUR", record))
  {
    const std::string_view name = GetPart21Value(record, 0).Text;
    for (const auto& known : Predefined)
    {
      if (name == known.Name)
      {
        color = { known.Color[0], known.Color[1], known.Color[2] };
        return true;
      }
    }
  }
  return false;
}

/// Finds the first colour behind a style, or a list of styles.
bool STEPAppearance::FindColor(const Part21Value& styles, int depth, Vector3& color) const
{
  if (styles.IsList())
  {
    Part21Values values(styles.Text);
    for (Part21Value value; values.Next(value);)
    {
      if (this->FindColor(value, depth, color))
      {
        return true;
      }
    }
    return false;
  }
  const Index entity = this->Entities.Follow(styles);
  if (entity == Part21File::None || depth > MaxChain)
  {
    return false;
  }
  for (const auto& step : Steps)
  {
    std::string_view record;
    if (this->Entities.FindRecord(entity, step.Record, record))
    {
      return this->FindColor(GetPart21Value(record, step.Parameter), depth + 1, color);
    }
  }
  return this->ReadColor(entity, color);
}

/// Finds the occurrences whose shapes are representations of their own: the contexts of their colours.
std::unordered_map<Part21File::Index, std::uint64_t> STEPAppearance::FindOccurrences() const
{
  std::unordered_map<Index, std::uint64_t> occurrences;
  const Part21File& file = this->Entities.File;
  for (Index i = 0; i < file.GetNumberOfInstances(); ++i)
  {
    std::string_view record;
    if (!this->Entities.Has(i, STEPRole::ShapeDefinition))
    {
      continue;
    }
    const Index shape = this->Entities.Follow(this->Entities.Get(i, RepresentedProperty));
    const Index used = this->Entities.Follow(this->Entities.Get(shape, DefinitionOfProperty));
    const Index representation = this->Entities.Follow(this->Entities.Get(i, UsedRepresentation));
    if (this->Entities.Has(used, STEPRole::Occurrence) && representation != Part21File::None)
    {
      occurrences.emplace(representation, file.GetId(used));
    }
  }
  return occurrences;
}

std::uint64_t STEPAppearance::FindOccurrence(
  const Part21Value& styles, const std::unordered_map<Index, std::uint64_t>& occurrences) const
{
  const Index style = this->Entities.Follow(GetPart21Value(styles.Text, 0));
  const auto found = occurrences.find(this->Entities.Follow(this->Entities.Get(style, ContextOfStyle)));
  return found == occurrences.end() ? 0 : found->second;
}

STEPColors STEPAppearance::ReadColors() const
{
  STEPColors colors;
  const std::unordered_map<Index, std::uint64_t> occurrences = this->FindOccurrences();
  const Part21File& file = this->Entities.File;
  for (Index i = 0; i < file.GetNumberOfInstances(); ++i)
  {
    for (const char* type : StyledTypes)
    {
      std::string_view record;
      if (file.IsDamaged(i) || file.IsComplex(i) || !this->Entities.FindRecord(i, type, record))
      {
        continue;
      }
      const Index item = this->Entities.Follow(GetPart21Value(record, ItemOfStyled));
      const Part21Value styles = GetPart21Value(record, StylesOfStyled);
      Vector3 color{};
      if (item == Part21File::None || !this->FindColor(styles, 0, color))
      {
        continue;
      }
      const std::uint64_t occurrence = this->FindOccurrence(styles, occurrences);
      if (occurrence > 0)
      {
        colors.Occurrences.emplace(occurrence, color);
      }
      else
      {
        colors.Items.emplace(file.GetId(item), color);
      }
    }
  }
  return colors;
}

bool STEPAppearance::HideStyled(Index styled, const std::unordered_map<Index, std::uint64_t>& occurrences,
  std::unordered_set<std::uint64_t>& hidden) const
{
  std::string_view record;
  const bool isStyled = std::any_of(std::begin(StyledTypes), std::end(StyledTypes),
    [&](const char* type) { return this->Entities.FindRecord(styled, type, record); });
  if (!isStyled)
  {
    return false;
  }
  const std::uint64_t occurrence = this->FindOccurrence(GetPart21Value(record, StylesOfStyled), occurrences);
  const Index item = this->Entities.Follow(GetPart21Value(record, ItemOfStyled));
  hidden.insert(occurrence > 0 || item == Part21File::None ? occurrence : this->Entities.File.GetId(item));
  return true;
}

std::unordered_set<std::uint64_t> STEPAppearance::ReadHiddenItems() const
{
  std::unordered_set<std::uint64_t> hidden;
  const std::unordered_map<Index, std::uint64_t> occurrences = this->FindOccurrences();
  const Part21File& file = this->Entities.File;
  std::string_view record;
  for (Index i = 0; i < file.GetNumberOfInstances(); ++i)
  {
    if (file.IsDamaged(i) || !this->Entities.FindRecord(i, "INVISIBILITY", record))
    {
      continue;
    }
    for (const Index item : file.GetReferences(i))
    {
      if (item != Part21File::None && !this->HideStyled(item, occurrences, hidden))
      {
        hidden.insert(file.GetId(item));
        // A layer or a representation refers to what is in it.
        for (const Index inside : file.GetReferences(item))
        {
          if (inside != Part21File::None && !this->HideStyled(inside, occurrences, hidden))
          {
            hidden.insert(file.GetId(inside));
          }
        }
      }
    }
  }
  return hidden;
}

std::unordered_map<std::uint64_t, std::string> ReadSTEPLayers(const STEPAttributes& entities)
{
  std::unordered_map<std::uint64_t, std::string> layers;
  const Part21File& file = entities.File;
  for (Part21File::Index i = 0; i < file.GetNumberOfInstances(); ++i)
  {
    std::string_view record;
    if (file.IsDamaged(i) || !entities.FindRecord(i, "PRESENTATION_LAYER_ASSIGNMENT", record))
    {
      continue;
    }
    for (const Part21File::Index item : file.GetReferences(i))
    {
      if (item != Part21File::None)
      {
        layers.emplace(file.GetId(item), DecodePart21Text(GetPart21Value(record, 0).Text));
      }
    }
  }
  return layers;
}

std::unordered_map<std::uint64_t, std::string> ReadSTEPMaterials(const STEPAttributes& entities)
{
  std::unordered_map<std::uint64_t, std::string> materials;
  const Part21File& file = entities.File;
  for (Part21File::Index i = 0; i < file.GetNumberOfInstances(); ++i)
  {
    std::string_view record;
    if (file.IsDamaged(i) || !entities.FindRecord(i, RepresentedProperty.Record, record))
    {
      continue;
    }
    const Part21File::Index property = entities.Follow(entities.Get(i, RepresentedProperty));
    const Part21File::Index shown = entities.Follow(entities.Get(i, UsedRepresentation));
    const Part21File::Index product = entities.Follow(entities.Get(property, DefinitionOfProperty));
    if (!entities.Has(product, STEPRole::ProductDefinition) ||
      entities.Get(property, NameOfProperty).Text != "material property" ||
      entities.Get(shown, NameOfRepresentation).Text != "material name")
    {
      continue;
    }
    Part21Values items(entities.Get(shown, ItemsOfRepresentation).Text);
    for (Part21Value value; items.Next(value);)
    {
      const std::string name = DecodePart21Text(entities.Get(entities.Follow(value), NameOfItem).Text);
      if (!name.empty())
      {
        materials.emplace(file.GetId(product), name);
      }
    }
  }
  return materials;
}
}
