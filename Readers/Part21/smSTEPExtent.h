/**
 * @file smSTEPExtent.h
 * @brief The box of what an entity of a STEP file depends on, as the numbers of the file state it
 */
#ifndef smSTEPExtent_h
#define smSTEPExtent_h

#include "smSTEPAttributes.h"

#include <array>

namespace sm
{
/// A box of points and placements, in the unit and frame of the file. Curves and surfaces with radii are at
/// most Reach outside of it.
struct STEPExtent
{
  std::array<double, 3> Low{ 1e300, 1e300, 1e300 };
  std::array<double, 3> High{ -1e300, -1e300, -1e300 };
  double Reach = 0.0;
  /// True if there is a surface of revolution: of its points the box has those of the profile only.
  bool IsRevolved = false;

  bool IsEmpty() const { return !(this->Low[0] <= this->High[0]); }
  double GetDiagonal() const;
};

/// Extends the box by all entities that `start` depends on, points of triangles included.
void AddExtent(const STEPAttributes& entities, Part21File::Index start, STEPExtent& extent);
}

#endif
