#include "smHiddenBodies.h"

#include "smCountedTexts.h"
#include "smFormat.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <utility>

namespace sm
{
namespace
{
/// Gives the instances of a node their new indices, and removes those without one (negative), and the
/// products that had instances and have none now. Returns whether the node had instances, and has some.
std::pair<bool, bool> RenumberInstances(const std::vector<int>& indices, ProductNode& node)
{
  bool had = !node.Instances.empty();
  std::vector<int> kept;
  for (const int instance : node.Instances)
  {
    if (indices[static_cast<std::size_t>(instance)] >= 0)
    {
      kept.push_back(indices[static_cast<std::size_t>(instance)]);
    }
  }
  node.Instances = std::move(kept);
  std::vector<ProductNode> children;
  bool has = !node.Instances.empty();
  for (ProductNode& child : node.Children)
  {
    const auto [childHad, childHas] = RenumberInstances(indices, child);
    had = had || childHad;
    has = has || childHas;
    if (childHas || !childHad)
    {
      children.push_back(std::move(child));
    }
  }
  node.Children = std::move(children);
  return { had, has };
}

using EntityIds = std::set<std::int64_t>;

/// Adds the entity numbers of a body, its shells and its faces.
void CollectIds(const PartBody& body, EntityIds& ids)
{
  ids.insert(body.FileId);
  for (const ShellUse& shell : body.Shape.Shells)
  {
    ids.insert(shell.Shell->Data.FileId);
  }
  body.Shape.VisitFaces([&ids](const FaceUse& use) { ids.insert(use.Face->Data.FileId); });
}

/// Returns the first of the entity numbers of a text, all of which must be among `ids` or of no body; 0 if
/// there is none.
std::int64_t FindId(const std::string& text, const EntityIds& ids, const EntityIds& others)
{
  std::int64_t found = 0;
  for (std::size_t at = text.find('#'); at != std::string::npos; at = text.find('#', at + 1))
  {
    const std::int64_t id = std::strtoll(text.c_str() + at + 1, nullptr, 10);
    if (others.count(id) > 0)
    {
      return 0;
    }
    found = found == 0 && ids.count(id) > 0 ? id : found;
  }
  return found;
}

/// Adds to messages and defects of bodies that are left out that they are. The file stays in doubt.
void NoteDefects(const std::vector<PartBody>& removed, Document& document)
{
  EntityIds ids;
  EntityIds kept;
  for (const PartBody& body : removed)
  {
    CollectIds(body, ids);
  }
  for (const PartBody& body : document.Bodies)
  {
    CollectIds(body, kept);
  }
  // 0 stands for an entity without a number.
  for (const std::int64_t id : kept)
  {
    ids.erase(id);
  }
  ids.erase(0);
  kept.erase(0);
  for (std::vector<std::string>* texts : { &document.Defects, &document.Messages })
  {
    for (std::string& text : *texts)
    {
      const std::int64_t id = FindId(text, ids, kept);
      text += id == 0 ? std::string()
                      : " #" + std::to_string(id) +
          " belongs to a body that is left out; the results of other bodies do not depend on it.";
    }
  }
}

/// Removes the bodies without an instance.
void RemoveUnusedBodies(Document& document)
{
  std::vector<int> indices(document.Bodies.size(), -1);
  std::vector<PartBody> bodies;
  for (BodyInstance& instance : document.Instances)
  {
    int& index = indices[static_cast<std::size_t>(instance.Body)];
    if (index < 0)
    {
      index = static_cast<int>(bodies.size());
      bodies.push_back(std::move(document.Bodies[static_cast<std::size_t>(instance.Body)]));
    }
    instance.Body = index;
  }
  std::vector<PartBody> removed;
  for (std::size_t i = 0; i < indices.size(); ++i)
  {
    if (indices[i] < 0)
    {
      removed.push_back(std::move(document.Bodies[i]));
    }
  }
  document.Bodies = std::move(bodies);
  NoteDefects(removed, document);
}
}

void LeaveOutHidden(HiddenMode mode, Document& document)
{
  if (mode == HiddenMode::Count || document.Instances.empty())
  {
    return;
  }
  const bool onlyHidden = mode == HiddenMode::Only;
  std::vector<int> indices;
  std::vector<BodyInstance> kept;
  CountedTexts leftOut;
  for (BodyInstance& instance : document.Instances)
  {
    const bool isKept = instance.IsHidden == onlyHidden;
    indices.push_back(isKept ? static_cast<int>(kept.size()) : -1);
    if (isKept)
    {
      kept.push_back(std::move(instance));
    }
    else
    {
      const std::string& name = document.Bodies[static_cast<std::size_t>(instance.Body)].Name;
      leftOut.Add(name.empty() ? "without a name" : name);
    }
  }
  const std::size_t count = document.Instances.size() - kept.size();
  document.Instances = std::move(kept);
  RenumberInstances(indices, document.Root);
  RemoveUnusedBodies(document);
  if (count > 0)
  {
    document.Messages.push_back(FormatCount(count, "body", "bodies") +
      (onlyHidden ? " that the file shows" : " that the file hides (INVISIBILITY)") +
      (count == 1 ? " is" : " are") + " left out: " + leftOut.List() + ".");
  }
  if (document.Instances.empty())
  {
    document.Status = ReadStatus::Empty;
    document.Problem = onlyHidden
      ? "it hides none of its bodies (INVISIBILITY), and only hidden ones are read; set hidden to skip or "
        "count"
      : "it hides all of its bodies (INVISIBILITY), and hidden ones are skipped; set hidden to count or only";
  }
}
}
