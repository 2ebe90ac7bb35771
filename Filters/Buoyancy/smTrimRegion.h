/**
 * @file smTrimRegion.h
 * @brief A region of a parameter box as a signed sum of what lies left of pieces of its boundary, cut and turned
 *
 * As panels are (smFacePanels.h): a part with Sign m adds m times {(x, y) : left <= x <= x(t), y = y(t)}, `left` being the
 * left border of the box in hand. Cutting at a line x = m leaves the right side its parts, and gives the left side,
 * for each of them, the part of the line beside it; lines add up by signed events, as in smCoverage.h, which cancel
 * exactly because neighbours share their end points. Turned, the same region is a sum of what lies below its boundary: the parts
 * themselves, with the other sign, and the horizontal lines from the left border to their ends, where these do not cancel.
 */
#ifndef smTrimRegion_h
#define smTrimRegion_h

#include <array>
#include <map>
#include <memory>
#include <vector>

namespace sm
{
/// A polynomial piece in Bernstein form.
using PiecePointer = std::shared_ptr<const std::vector<std::array<double, 2>>>;

struct RegionPart
{
  PiecePointer Piece;
  double Start = 0.0;
  double End = 1.0;
  /// The points at Start and End: the same doubles as the neighbours'.
  std::array<double, 2> From{};
  std::array<double, 2> To{};
  int Sign = 1;
  /// A straight line inside of the face, and no trim curve.
  bool Covered = false;

  int GetDegree() const { return static_cast<int>(this->Piece->size()) - 1; }
  std::array<double, 2> Evaluate(double t) const;
};
using Region = std::vector<RegionPart>;

/// Signed intervals of one coordinate; equal ends cancel.
class SignedIntervals
{
public:
  void Add(double start, double end, int sign);
  struct Interval
  {
    double Start, End;
    int Multiplicity;
  };
  std::vector<Interval> Get() const;

private:
  std::map<double, int> Events;
};

/// The line from `start` to `end` in coordinate 1 at x in coordinate 0.
RegionPart MakeLine(double x, double start, double end, int sign);

/// The part between two parameters, whose points are given.
RegionPart MakePart(const RegionPart& of, double start, double end, const std::array<double, 2>& from,
  const std::array<double, 2>& to);

/// Parts where coordinate `direction` is below `value` and above it.
void CutPart(const RegionPart& part, int direction, double value, Region& below, Region& above);

/// Halves of a region: the left (lower) one, which ends at the line, and the other, which begins there.
void CutRegion(const Region& region, int direction, double value, Region& below, Region& above);

/// The region with its coordinates exchanged, where it is bordered by `left` and `bottom`.
Region ExchangeRegion(const Region& region, double left, double bottom);

/// The interval in which coordinate `direction` of a part lies, or a slightly larger one that has [low, high] in it.
std::array<double, 2> GetExtent(const RegionPart& part, int direction, double low, double high);
}

#endif
