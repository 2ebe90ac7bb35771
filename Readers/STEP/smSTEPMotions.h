/**
 * @file smSTEPMotions.h
 * @brief Motions by which a STEP file places parts: mapped items, occurrences and relationships
 */
#ifndef smSTEPMotions_h
#define smSTEPMotions_h

#include "Geometry/smPlacement.h"
#include "smSTEPAttributes.h"
#include "smSTEPCensus.h"
#include "smSTEPGeometryReading.h"

#include <cstdint>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace sm
{
/// Lengths are in mm. What is not read is a defect, reported once.
class STEPMotions
{
public:
  STEPMotions(const STEPAttributes& entities, std::vector<std::string>& defects);

  using Index = Part21File::Index;

  /// Gets the motion of a mapped item: from its origin to its target (ISO 10303-43). `parent` and `child` are
  /// the representations. Returns false, with a defect, if it has none.
  bool GetMapping(Index map, Index item, std::uint64_t parent, std::uint64_t child, Placement& motion);

  /// Gets the motion that brings the frame of the part onto that of the assembly; none, with a defect,
  /// if the file states no placement. Returns false, with a defect, if it is not read.
  bool GetPlacement(const CensusOccurrence& occurrence, Placement& motion);

  /// Gets the motion by which a relationship places the first of its representations in the second one.
  /// Returns false, with a defect, if it is not read.
  bool GetRelation(std::uint64_t id, Placement& motion);

private:
  void ReportOperator(std::uint64_t id);
  template <class Work>
  bool Try(const char* kind, std::uint64_t id, const Work& work);
  double GetUnit(std::uint64_t representation);
  GeometricFrame ReadFrame(const Part21Value& value, double unit) const;
  bool HasItem(std::uint64_t representation, const Part21Value& item) const;
  Placement ReadMotion(Index transformation, std::uint64_t child, std::uint64_t parent, bool isReversed);

  const STEPAttributes& Entities;
  std::vector<std::string>& Defects;
  std::unordered_map<Index, double> Units;
  /// Mapped items, occurrences and operators that were reported.
  std::unordered_set<std::uint64_t> Unplaced;
};
}

#endif
