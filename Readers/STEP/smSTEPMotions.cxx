#include "smSTEPMotions.h"

#include "Geometry/smGeometryTransform.h"
#include "smSTEPPropertyAttributes.h"
#include "smSTEPStructureAttributes.h"
#include "smSTEPUnits.h"

#include <algorithm>
#include <utility>

namespace sm
{
namespace
{
constexpr STEPAttribute FirstOfTransformation = { "ITEM_DEFINED_TRANSFORMATION", 2, 2, "first item" };
constexpr STEPAttribute SecondOfTransformation = { "ITEM_DEFINED_TRANSFORMATION", 3, 3, "second item" };

bool IsAtOrigin(const GeometricFrame& frame)
{
  const GeometricFrame world;
  return frame.Origin == world.Origin && frame.Axes == world.Axes;
}

/// Returns the motion of one frame to another one.
Placement Place(const GeometricFrame& from, const GeometricFrame& to)
{
  return IsAtOrigin(from) ? MakeMotion(to) : Compose(MakeMotion(to), Invert(MakeMotion(from)));
}

Placement ReadOperator(const AffineTransform<3>& t)
{
  RequireGeometry(t.GetScale() > 0.0 ? "" : "its operator is not a similarity");
  Placement motion;
  for (int i = 0; i < 3; ++i)
  {
    std::copy(t.Linear[i].begin(), t.Linear[i].end(), motion.Linear[i]);
  }
  motion.Translation = t.Translation;
  return motion;
}
}

STEPMotions::STEPMotions(const STEPAttributes& entities, std::vector<std::string>& defects)
  : Entities(entities)
  , Defects(defects)
{
}

bool STEPMotions::GetMapping(
  Index map, Index item, std::uint64_t parent, std::uint64_t child, Placement& motion)
{
  const Part21Value target = this->Entities.Get(item, MappingTarget);
  return this->Try("Mapped item", this->Entities.File.GetId(item),
    [&]
    {
      const GeometricFrame from =
        this->ReadFrame(this->Entities.Get(map, MappingOrigin), this->GetUnit(child));
      if (this->Entities.Has(this->Entities.Follow(target), STEPRole::Transformation))
      {
        motion = ReadOperator(
          ReadGeometryOperator<3>(this->Entities, this->Entities.Follow(target), this->GetUnit(parent)));
        if (!IsAtOrigin(from))
        {
          motion = Compose(motion, Invert(MakeMotion(from)));
          this->ReportOperator(target.Id);
        }
      }
      else
      {
        motion = Place(from, this->ReadFrame(target, this->GetUnit(parent)));
      }
    });
}

void STEPMotions::ReportOperator(std::uint64_t id)
{
  if (this->Unplaced.insert(id).second)
  {
    this->Defects.push_back("Entity #" + std::to_string(id) +
      " of the file: the operator is the target of a mapped item whose origin is not that of its "
      "representation: it is taken to move this origin. Export the file again.");
  }
}

/// Calls work(); returns false, with a defect, if that throws a STEPGeometryFailure.
template <class Work>
bool STEPMotions::Try(const char* kind, std::uint64_t id, const Work& work)
{
  try
  {
    work();
    return true;
  }
  catch (const STEPGeometryFailure& failure)
  {
    if (this->Unplaced.insert(id).second)
    {
      this->Defects.push_back(std::string(kind) + " #" + std::to_string(id) +
        " of the file is left out: its placement is not read, " + failure.Reason +
        ". Export the file again.");
    }
    return false;
  }
}

/// Returns the size in millimetres of the length unit of a representation.
double STEPMotions::GetUnit(std::uint64_t representation)
{
  const Index context = this->Entities.Follow(
    this->Entities.Get(this->Entities.File.Find(representation), ContextOfRepresentation));
  const auto [found, isNew] = this->Units.try_emplace(context, 1.0);
  if (isNew && context != Part21File::None)
  {
    CensusContext units;
    units.Id = this->Entities.File.GetId(context);
    std::vector<Index> used;
    ReadSTEPUnits(this->Entities, context, units, used);
    found->second = units.Length.Factor > 0.0 ? units.Length.Factor : 1.0;
  }
  return found->second;
}

GeometricFrame STEPMotions::ReadFrame(const Part21Value& value, double unit) const
{
  return ReadGeometryFrame(this->Entities, this->Entities.Follow(value), unit);
}

bool STEPMotions::HasItem(std::uint64_t representation, const Part21Value& item) const
{
  Part21Values items(
    this->Entities.Get(this->Entities.File.Find(representation), ItemsOfRepresentation).Text);
  for (Part21Value value; items.Next(value);)
  {
    if (value.IsReference() && value.Id == item.Id)
    {
      return true;
    }
  }
  return false;
}

bool STEPMotions::GetPlacement(const CensusOccurrence& occurrence, Placement& motion)
{
  if (occurrence.Transformation == 0 || occurrence.ChildShape == 0)
  {
    if (occurrence.HasSolids && this->Unplaced.insert(occurrence.Id).second)
    {
      this->Defects.push_back("Occurrence #" + std::to_string(occurrence.Id) +
        " of the file has no placement: it is taken at the origin of its assembly. Export the file again.");
    }
    return true;
  }
  return this->Try("Occurrence", occurrence.Id,
    [&]
    {
      motion = this->ReadMotion(this->Entities.File.Find(occurrence.Transformation), occurrence.ChildShape,
        occurrence.ParentShape, occurrence.IsReversed);
    });
}

bool STEPMotions::GetRelation(std::uint64_t id, Placement& motion)
{
  const Index relation = this->Entities.File.Find(id);
  const auto follow = [&](const STEPAttribute& attribute)
  { return this->Entities.Follow(this->Entities.Get(relation, attribute)); };
  return this->Try("Relationship", id,
    [&]
    {
      motion = this->ReadMotion(follow(OperatorOfRelationship),
        this->Entities.File.GetId(follow(FirstRepresentation)),
        this->Entities.File.GetId(follow(SecondRepresentation)), false);
    });
}

/// Returns the motion of an ITEM_DEFINED_TRANSFORMATION from the frame of a part to that of an assembly.
Placement STEPMotions::ReadMotion(
  Index transformation, std::uint64_t child, std::uint64_t parent, bool isReversed)
{
  Part21Value frames[2] = { this->Entities.Get(transformation, FirstOfTransformation),
    this->Entities.Get(transformation, SecondOfTransformation) };
  if (isReversed)
  {
    std::swap(frames[0], frames[1]);
  }
  // Some files name the frame of the assembly first: what a representation lists is its own.
  if (this->HasItem(parent, frames[0]) && !this->HasItem(child, frames[0]))
  {
    std::swap(frames[0], frames[1]);
  }
  return Place(
    this->ReadFrame(frames[0], this->GetUnit(child)), this->ReadFrame(frames[1], this->GetUnit(parent)));
}
}
