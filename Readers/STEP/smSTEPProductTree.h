/**
 * @file smSTEPProductTree.h
 * @brief The products of a STEP file with their bodies and placements, from its entities alone
 */
#ifndef smSTEPProductTree_h
#define smSTEPProductTree_h

#include "smDocument.h"
#include "smSTEPAttributes.h"
#include "smSTEPCensus.h"

#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <unordered_set>

namespace sm
{
/// What was read of a body.
struct STEPBody
{
  ShapeGroup Shapes;
  /// Accuracy of coordinates in mm that the file states for a solid; 0: none.
  double Uncertainty = 0.0;
  /// Number of the faces that it has in the file and not here; Messages names them.
  int LostFaces = 0;
  std::vector<std::string> Messages;
};

/// By the index of the body in the census.
using STEPBodies = std::map<std::uint32_t, STEPBody>;

/**
 * Adds the products to the root of a document, with materials and stated volumes, and the instances of their
 * bodies: those of occurrences (NEXT_ASSEMBLY_USAGE_OCCURRENCE) and of mapped items, in the order of the
 * file. A placement moves a representation so that its first frame lands on the second one (ISO 10303-43).
 * Operators may scale uniformly and reflect. The tree follows every arc by which the census counts instances
 * (smSTEPCensus.h); where one is not followed, that is a defect: a placement that is not read, or a problem
 * of the census. `colors` are those of occurrences.
 * `hidden` has the numbers of hidden bodies, representations, mapped items and occurrences: instances of
 * these, and below these, are marked. A solid that is in one place twice is a defect if `mode` counts both.
 * Faces of surface models are counted where there are solids.
 */
void AddSTEPProducts(const STEPAttributes& entities, const STEPCensus& census, CensusBodyKind kind,
  const STEPBodies& bodies, const std::unordered_map<std::uint64_t, Vector3>& colors,
  const std::unordered_set<std::uint64_t>& hidden, HiddenMode mode, Document& document);
}

#endif
