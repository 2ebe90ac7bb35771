/**
 * @file smTrimRegion.h
 * @brief A region of a parameter box as a signed sum of the areas left of pieces of its boundary, which can
 * be cut and transposed
 *
 * The representation is that of panels (smFacePanels.h): a part with Sign m contributes m times {(x, y) :
 * left <= x <= x(t), y = y(t)}, where `left` is the left border of the current box. A cut at a line x = m
 * leaves the right side its parts and gives the left side, for each of these parts, the adjacent segment of
 * the line. These segments are added by signed events, as in smCoverage.h, which cancel exactly because
 * neighbours share their end points. Transposed, the same region is a sum of the areas below its boundary:
 * the parts themselves with the opposite sign, and the horizontal lines from the left border to the ends of
 * the parts where these do not cancel.
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

/// A part of the boundary of a region.
struct RegionPart
{
  PiecePointer Piece;
  double Start = 0.0;
  double End = 1.0;
  /// The points at Start and End, bitwise equal to those of the neighbouring parts.
  std::array<double, 2> From{};
  std::array<double, 2> To{};
  int Sign = 1;
  /// True if the part is a straight line inside the face, not a trim curve.
  bool Covered = false;

  int GetDegree() const { return static_cast<int>(this->Piece->size()) - 1; }
  std::array<double, 2> Evaluate(double t) const;
};
using Region = std::vector<RegionPart>;

/// Sum of signed intervals of one coordinate. Equal end points with opposite signs cancel.
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

/// Makes the line from `start` to `end` in coordinate 1, at x in coordinate 0.
RegionPart MakeLine(double x, double start, double end, int sign);

/// Makes the part of `of` between two parameters, with the given points there.
RegionPart MakePart(const RegionPart& of, double start, double end, const std::array<double, 2>& from,
  const std::array<double, 2>& to);

/// Splits a part into the parts where coordinate `direction` is below and above `value`.
void CutPart(const RegionPart& part, int direction, double value, Region& below, Region& above);

/// Splits a region at a line: `below` is the left (lower) half, which ends at the line, and `above` the half
/// that begins there.
void CutRegion(const Region& region, int direction, double value, Region& below, Region& above);

/// Returns the region with its coordinates exchanged. `left` and `bottom` are the borders of its box.
Region ExchangeRegion(const Region& region, double left, double bottom);

/// Returns the interval of coordinate `direction` of a part, or a slightly larger one, extended to contain
/// [low, high].
std::array<double, 2> GetExtent(const RegionPart& part, int direction, double low, double high);
}

#endif
