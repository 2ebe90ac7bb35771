#include "Detail/smLoopCrossings.h"

#include "smTrimPolygons.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace sm
{
namespace
{
/// Largest distance of a chord from its curve, relative to the extent of the loops in u and v.
constexpr double Flatness = 5e-4;
/// Overlaps that are excused, relative to the longer side of the face: at least, and at most by the tolerance
/// of its edges.
constexpr double MinExcuse = 1e-4;
constexpr double MaxExcuse = 1e-3;
/// The largest part of the face's extent in u and in v that a gap at a corner may have.
constexpr double MaxCorner = 0.1;
/// Largest number of crossings that are examined; a sound face has none but where loops touch.
constexpr int MaxCrossings = 4096;
/// Number of chords of a loop next to which its place is examined, and the maximum number of rows into which
/// chords are sorted.
constexpr std::size_t MaxPlaces = 4;
constexpr std::size_t MaxRows = 128;

double Cross2(const Point2& a, const Point2& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

Point2 Subtract2(const Point2& a, const Point2& b)
{
  return { a[0] - b[0], a[1] - b[1] };
}

struct Chord
{
  Point2 From, To;
  /// Number of this chord, and of the next one of its loop.
  std::size_t Index = 0;
  std::size_t Next = 0;
  double GetLow(int d) const { return std::min(this->From[d], this->To[d]); }
  double GetHigh(int d) const { return std::max(this->From[d], this->To[d]); }
};

/// The loops as chords, in coordinates in which their bounding box is the unit square.
class FlatLoops
{
public:
  explicit FlatLoops(const Face& face);
  bool HasCrossing();
  /// Returns true if the loops wind more than once, or the wrong way, next to one that crosses none.
  bool HasMisplacedLoop();
  /// The point is in the coordinates of the surface.
  bool IsFarFromLoops(const Point2& uv);

private:
  /// Returns true if the loops overlap near the place where two chords cross, at the fraction x of the
  /// first one.
  bool IsOverlap(const Chord& a, const Chord& b, double x);
  void WidenSlack();
  void SortIntoRows();
  const std::vector<std::size_t>& GetRow(double v) const;
  /// Looks on one side of a chord; returns 1 for a point there that is wound wrongly, 0 for a right one, -1
  /// if none is far from all loops.
  int ExamineBeside(const Chord& chord, double side) const;
  /// How far the ends of a coedge are apart if it closes a gap between its neighbours.
  Point2 GetFilledGap(const Coedge& coedge) const;
  int GetWindingNumber(const Point2& p) const;
  bool IsFarFrom(const Point2& p) const;

  const Face& Source;
  Point2 Low{ std::numeric_limits<double>::max(), std::numeric_limits<double>::max() };
  Point2 Size{};
  std::vector<Chord> Chords;
  /// The first chord of each loop that has one.
  std::vector<std::size_t> FirstChords;
  /// The chords that come within the slack of each of equal strips of v.
  std::vector<std::vector<std::size_t>> Rows;
  /// Within this distance of a chord, in u and in v, the winding number of a point proves no overlap.
  Point2 Slack{};
  bool HasTolerances = false;
};

FlatLoops::FlatLoops(const Face& face)
  : Source(face)
{
  Point2 high{ -this->Low[0], -this->Low[1] };
  Point2 gap{};
  std::vector<Point2> corners;
  for (const Loop& loop : face.Loops)
  {
    for (std::size_t i = 0; i < loop.Coedges.size(); ++i)
    {
      const Coedge& coedge = loop.Coedges[i];
      const Coedge& next = loop.Coedges[(i + 1) % loop.Coedges.size()];
      const Point2 end = coedge.Reversed ? coedge.Curve.GetStartPoint() : coedge.Curve.GetEndPoint();
      const Point2 start = next.Reversed ? next.Curve.GetEndPoint() : next.Curve.GetStartPoint();
      corners.push_back({ std::abs(end[0] - start[0]), std::abs(end[1] - start[1]) });
      if (coedge.Use->Degenerate)
      {
        corners.push_back(this->GetFilledGap(coedge));
      }
      for (int d = 0; d < 2; ++d)
      {
        for (const Point2& c : coedge.Curve.Coefficients)
        {
          this->Low[d] = std::min(this->Low[d], c[d]);
          high[d] = std::max(high[d], c[d]);
        }
      }
    }
  }
  this->Size = Subtract2(high, this->Low);
  if (!(this->Size[0] > 0.0 && this->Size[1] > 0.0))
  {
    return;
  }
  // A wider gap is not a lack of accuracy: it runs along a pole, or is reported elsewhere.
  for (const Point2& corner : corners)
  {
    if (corner[0] <= MaxCorner * this->Size[0] && corner[1] <= MaxCorner * this->Size[1])
    {
      gap = { std::max(gap[0], corner[0]), std::max(gap[1], corner[1]) };
    }
  }
  const TrimPolygons polygons = FlattenLoops(face, { Flatness * this->Size[0], Flatness * this->Size[1] });
  for (int d = 0; d < 2; ++d)
  {
    this->Slack[d] = std::max(2.0 * Flatness, (polygons.Deviation[d] + gap[d]) / this->Size[d]);
  }
  for (const std::vector<Point2>& loop : polygons.Loops)
  {
    const std::size_t first = this->Chords.size();
    if (!loop.empty())
    {
      this->FirstChords.push_back(first);
    }
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      Chord chord{ loop[i], loop[(i + 1) % loop.size()] };
      chord.Index = first + i;
      chord.Next = first + (i + 1) % loop.size();
      for (Point2* p : { &chord.From, &chord.To })
      {
        *p = { ((*p)[0] - this->Low[0]) / this->Size[0], ((*p)[1] - this->Low[1]) / this->Size[1] };
      }
      this->Chords.push_back(chord);
    }
  }
}

Point2 FlatLoops::GetFilledGap(const Coedge& coedge) const
{
  const Point2 ends[2] = { coedge.Curve.GetStartPoint(), coedge.Curve.GetEndPoint() };
  const Point2 along = { std::abs(ends[1][0] - ends[0][0]), std::abs(ends[1][1] - ends[0][1]) };
  Vector3 position[2];
  double step = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    Vector3 derivative[2];
    this->Source.Surface.Evaluate(
      ends[i][0], ends[i][1], position[i].data(), derivative[0].data(), derivative[1].data());
    step = std::max(step, Norm(derivative[0]) * along[0] + Norm(derivative[1]) * along[1]);
  }
  // At a pole nothing moves: its edge is not a gap, however long it is in (u,v).
  const bool isPole = Norm(Subtract(position[1], position[0])) < 0.25 * step ||
    !(step > coedge.Use->Tolerance) || !(step > 0.0);
  return isPole ? Point2{ 0.0, 0.0 } : along;
}

int FlatLoops::GetWindingNumber(const Point2& p) const
{
  int winding = 0;
  for (const std::size_t index : this->GetRow(p[1]))
  {
    const Chord& chord = this->Chords[index];
    const bool isUp = chord.From[1] <= p[1] && chord.To[1] > p[1];
    const bool isDown = chord.To[1] <= p[1] && chord.From[1] > p[1];
    if (isUp || isDown)
    {
      const double side = Cross2(Subtract2(chord.To, chord.From), Subtract2(p, chord.From));
      winding += isUp && side > 0.0 ? 1 : isDown && side < 0.0 ? -1 : 0;
    }
  }
  return winding;
}

bool FlatLoops::IsFarFrom(const Point2& p) const
{
  // A chord meets the box of half widths Slack about p if it does so in u, in v, and across its own
  // direction.
  const std::vector<std::size_t>& row = this->GetRow(p[1]);
  return std::none_of(row.begin(), row.end(),
    [this, &p](std::size_t index)
    {
      const Chord& chord = this->Chords[index];
      const Point2 along = Subtract2(chord.To, chord.From);
      const double reach = this->Slack[0] * std::abs(along[1]) + this->Slack[1] * std::abs(along[0]);
      return chord.GetLow(0) <= p[0] + this->Slack[0] && chord.GetHigh(0) >= p[0] - this->Slack[0] &&
        chord.GetLow(1) <= p[1] + this->Slack[1] && chord.GetHigh(1) >= p[1] - this->Slack[1] &&
        std::abs(Cross2(along, Subtract2(p, chord.From))) <= reach;
    });
}

bool FlatLoops::IsFarFromLoops(const Point2& uv)
{
  this->WidenSlack();
  Point2 p;
  for (int d = 0; d < 2; ++d)
  {
    p[d] = (uv[d] - this->Low[d]) / this->Size[d];
  }
  return this->Size[0] > 0.0 && this->Size[1] > 0.0 && this->IsFarFrom(p);
}

void FlatLoops::WidenSlack()
{
  if (this->HasTolerances)
  {
    return;
  }
  this->HasTolerances = true;
  double tolerance = 0.0;
  for (const Loop& loop : this->Source.Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      tolerance = std::max(tolerance, coedge.Use->Tolerance);
    }
  }
  Vector3 position;
  Vector3 derivative[2];
  this->Source.Surface.Evaluate(this->Low[0] + 0.5 * this->Size[0], this->Low[1] + 0.5 * this->Size[1],
    position.data(), derivative[0].data(), derivative[1].data());
  const Point2 width{ Norm(derivative[0]) * this->Size[0], Norm(derivative[1]) * this->Size[1] };
  const double widest = std::max(width[0], width[1]);
  // OpenCASCADE widens the tolerance of edges that cross until it excuses the crossing.
  const double excuse = std::clamp(tolerance, MinExcuse * widest, MaxExcuse * widest);
  for (int d = 0; d < 2; ++d)
  {
    this->Slack[d] += width[d] > 0.0 ? excuse / width[d] : std::numeric_limits<double>::infinity();
  }
  this->SortIntoRows();
}

const std::vector<std::size_t>& FlatLoops::GetRow(double v) const
{
  const double row = v * static_cast<double>(this->Rows.size());
  const std::size_t last = this->Rows.size() - 1;
  // Not a number is in the first row.
  return this->Rows[!(row > 0.0)        ? 0
      : row < static_cast<double>(last) ? static_cast<std::size_t>(row)
                                        : last];
}

void FlatLoops::SortIntoRows()
{
  this->Rows.resize(std::clamp<std::size_t>(this->Chords.size() / 16, 1, MaxRows));
  for (std::size_t i = 0; i < this->Chords.size(); ++i)
  {
    const auto end = &this->GetRow(this->Chords[i].GetHigh(1) + this->Slack[1]) - this->Rows.data() + 1;
    for (auto r = &this->GetRow(this->Chords[i].GetLow(1) - this->Slack[1]) - this->Rows.data(); r < end; ++r)
    {
      this->Rows[r].push_back(i);
    }
  }
}

/// Returns true if two chords cross, at the fraction x of the first one. A chord that begins or ends on the
/// other one crosses it, or the chord next to it does.
bool DoCross(const Chord& a, const Chord& b, double& x)
{
  const Point2 alongA = Subtract2(a.To, a.From);
  const Point2 alongB = Subtract2(b.To, b.From);
  const double from = Cross2(alongB, Subtract2(a.From, b.From));
  const double to = Cross2(alongB, Subtract2(a.To, b.From));
  x = from / (from - to);
  return (from >= 0.0) != (to >= 0.0) &&
    (Cross2(alongA, Subtract2(b.From, a.From)) >= 0.0) != (Cross2(alongA, Subtract2(b.To, a.From)) >= 0.0);
}

bool FlatLoops::IsOverlap(const Chord& a, const Chord& b, double x)
{
  this->WidenSlack();
  const Point2 alongA = Subtract2(a.To, a.From);
  const Point2 alongB = Subtract2(b.To, b.From);
  const double lengthA = std::hypot(alongA[0], alongA[1]);
  const double lengthB = std::hypot(alongB[0], alongB[1]);
  // The bisector of the sector that lies left of both.
  Point2 left{ -alongA[1] / lengthA - alongB[1] / lengthB, alongA[0] / lengthA + alongB[0] / lengthB };
  const double length = std::hypot(left[0], left[1]);
  for (double step = 2.0 * std::max(this->Slack[0], this->Slack[1]); length > 0.0 && step < 0.5; step *= 1.5)
  {
    for (const double side : { step, -step })
    {
      const Point2 p{ a.From[0] + x * alongA[0] + side * left[0] / length,
        a.From[1] + x * alongA[1] + side * left[1] / length };
      const int winding = this->GetWindingNumber(p);
      if ((winding < 0 || winding > 1) && this->IsFarFrom(p))
      {
        return true;
      }
    }
  }
  return false;
}

bool FlatLoops::HasCrossing()
{
  std::vector<Chord> sorted = this->Chords;
  std::sort(
    sorted.begin(), sorted.end(), [](const Chord& a, const Chord& b) { return a.GetLow(0) < b.GetLow(0); });
  int crossings = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    const Chord& a = sorted[i];
    for (std::size_t j = i + 1; j < sorted.size() && sorted[j].GetLow(0) <= a.GetHigh(0); ++j)
    {
      const Chord& b = sorted[j];
      // A loop does not cross itself at a corner between two chords; but it may where it comes back to that
      // corner.
      const bool areNeighbours = a.Next == b.Index || b.Next == a.Index;
      double x = 0.0;
      if (areNeighbours || b.GetLow(1) > a.GetHigh(1) || b.GetHigh(1) < a.GetLow(1) || !DoCross(a, b, x))
      {
        continue;
      }
      if (this->IsOverlap(a, b, x))
      {
        return true;
      }
      if (++crossings == MaxCrossings)
      {
        return false;
      }
    }
  }
  return false;
}

int FlatLoops::ExamineBeside(const Chord& chord, double side) const
{
  const Point2 along = Subtract2(chord.To, chord.From);
  const double length = std::hypot(along[0], along[1]);
  for (double step = 2.0 * std::max(this->Slack[0], this->Slack[1]); length > 0.0 && step < 0.5; step *= 1.5)
  {
    const Point2 p{ 0.5 * (chord.From[0] + chord.To[0]) - side * step * along[1] / length,
      0.5 * (chord.From[1] + chord.To[1]) + side * step * along[0] / length };
    if (this->IsFarFrom(p))
    {
      const int winding = this->GetWindingNumber(p);
      return winding < 0 || winding > 1 ? 1 : 0;
    }
  }
  return -1;
}

bool FlatLoops::HasMisplacedLoop()
{
  if (this->FirstChords.empty())
  {
    return false;
  }
  this->WidenSlack();
  for (std::size_t k = 0; k < this->FirstChords.size(); ++k)
  {
    const std::size_t first = this->FirstChords[k];
    const std::size_t count =
      (k + 1 < this->FirstChords.size() ? this->FirstChords[k + 1] : this->Chords.size()) - first;
    for (const double side : { 1.0, -1.0 })
    {
      const std::size_t places = std::min(count, MaxPlaces);
      int found = -1;
      for (std::size_t i = 0; i < places && found < 0; ++i)
      {
        found = this->ExamineBeside(this->Chords[first + i * count / places], side);
      }
      if (found == 1)
      {
        return true;
      }
    }
  }
  return false;
}
}

bool HasWrongLoops(const Face& face)
{
  if (face.Loops.empty())
  {
    return false;
  }
  FlatLoops loops(face);
  return loops.HasCrossing() || loops.HasMisplacedLoop();
}

std::vector<bool> AreFarFromLoops(const Face& face, const std::vector<Point2>& points)
{
  FlatLoops loops(face);
  std::vector<bool> are;
  for (const Point2& point : points)
  {
    are.push_back(loops.IsFarFromLoops(point));
  }
  return are;
}
}
