#include "smTrimClassifier.h"

#include "smTrimPolygons.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
// Largest distance of chords from their curves, relative to the domain. Boxes closer than that to a curve
// remain undecided.
constexpr double ChordTolerance = 1e-6;

/// Returns false if no point of the chord is in the box.
bool MayCross(const std::array<double, 2>& from, const std::array<double, 2>& to,
  const std::array<double, 2>& low, const std::array<double, 2>& high)
{
  for (int d = 0; d < 2; ++d)
  {
    if (std::max(from[d], to[d]) < low[d] || std::min(from[d], to[d]) > high[d])
    {
      return false;
    }
  }
  // Corners of the box on both sides of the chord's line, or on it.
  double minimum = HUGE_VAL;
  double maximum = -HUGE_VAL;
  for (const double u : { low[0], high[0] })
  {
    for (const double v : { low[1], high[1] })
    {
      const double side = (to[0] - from[0]) * (v - from[1]) - (to[1] - from[1]) * (u - from[0]);
      minimum = std::min(minimum, side);
      maximum = std::max(maximum, side);
    }
  }
  return minimum <= 0.0 && maximum >= 0.0;
}
}

TrimClassifier::TrimClassifier(const Face& face)
  : Everything(face.Loops.empty())
{
  if (this->Everything)
  {
    return;
  }
  std::array<double, 2> tolerance{};
  for (int d = 0; d < 2; ++d)
  {
    tolerance[d] = ChordTolerance * (face.Surface.GetDomainEnd(d) - face.Surface.GetDomainStart(d));
  }
  for (const Loop& loop : face.Loops)
  {
    this->AddLoop(loop, tolerance);
  }
  if (this->Chords.empty())
  {
    return;
  }
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (const Chord& chord : this->Chords)
  {
    low = std::min({ low, chord.From[1], chord.To[1] });
    high = std::max({ high, chord.From[1], chord.To[1] });
  }
  for (const std::array<double, 2>& deviation : this->Deviations)
  {
    this->Largest = std::max(this->Largest, deviation[1]);
  }
  this->RowStart = low;
  this->Rows.resize(std::clamp<std::size_t>(this->Chords.size() / 4, 1, 4096));
  this->RowHeight = std::max((high - low) / static_cast<double>(this->Rows.size()), 1e-300);
  for (std::size_t i = 0; i < this->Chords.size(); ++i)
  {
    const Chord& chord = this->Chords[i];
    const double reach = this->Deviations[chord.Curve][1];
    const int first = this->GetRow(std::min(chord.From[1], chord.To[1]) - reach);
    const int last = this->GetRow(std::max(chord.From[1], chord.To[1]) + reach);
    for (int row = first; row <= last; ++row)
    {
      this->Rows[row].push_back(static_cast<int>(i));
    }
  }
}

/// Adds a loop curve by curve, so that straight curves keep their deviation of 0.
void TrimClassifier::AddLoop(const Loop& loop, const std::array<double, 2>& tolerance)
{
  std::vector<std::array<double, 2>> corners;
  for (const Coedge& coedge : loop.Coedges)
  {
    if (coedge.Curve.GetNumberOfPieces() == 0)
    {
      continue;
    }
    Face single;
    single.Loops = { Loop{ { coedge } } };
    const TrimPolygons polygon = FlattenLoops(single, tolerance);
    std::vector<std::array<double, 2>> points = polygon.Loops[0];
    // The last point is left out where it is the first.
    points.push_back(coedge.Reversed ? coedge.Curve.GetStartPoint() : coedge.Curve.GetEndPoint());
    double largest = 0.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      largest = std::max({ largest, std::abs(points[i][0]), std::abs(points[i][1]) });
      this->Chords.push_back({ points[i], points[i + 1], static_cast<int>(this->Deviations.size()) });
    }
    // Points of the polygons are rounded, too, unless they are ends of a straight piece.
    std::array<double, 2> deviation = polygon.Deviation;
    for (double& d : deviation)
    {
      d += d > 0.0 ? 4e-16 * largest : 0.0;
    }
    this->Deviations.push_back(deviation);
    corners.push_back(points.front());
    corners.push_back(points.back());
  }
  for (std::size_t i = 1; i < corners.size(); i += 2)
  {
    const std::array<double, 2>& next = corners[(i + 1) % corners.size()];
    if (corners[i] != next)
    {
      this->Chords.push_back({ corners[i], next, static_cast<int>(this->Deviations.size()) });
    }
  }
  this->Deviations.push_back({});
}

int TrimClassifier::GetRow(double v) const
{
  const double row = std::floor((v - this->RowStart) / this->RowHeight);
  return static_cast<int>(std::clamp(row, 0.0, static_cast<double>(this->Rows.size()) - 1.0));
}

int TrimClassifier::GetWinding(const std::array<double, 2>& point) const
{
  int winding = 0;
  for (const int index : this->Rows[this->GetRow(point[1])])
  {
    const Chord& chord = this->Chords[index];
    // Crossings of the ray to larger u.
    if ((chord.From[1] <= point[1]) == (chord.To[1] <= point[1]))
    {
      continue;
    }
    const double u = chord.From[0] +
      (chord.To[0] - chord.From[0]) * ((point[1] - chord.From[1]) / (chord.To[1] - chord.From[1]));
    if (u > point[0])
    {
      winding += chord.To[1] > chord.From[1] ? 1 : -1;
    }
  }
  return winding;
}

TrimSide TrimClassifier::Classify(
  const std::array<double, 2>& low, const std::array<double, 2>& high, bool* hopeless) const
{
  if (hopeless)
  {
    *hopeless = false;
  }
  if (this->Everything)
  {
    return TrimSide::Inside;
  }
  if (this->Chords.empty())
  {
    return TrimSide::Outside;
  }
  bool crossed = false;
  for (int row = this->GetRow(low[1] - this->Largest); row <= this->GetRow(high[1] + this->Largest); ++row)
  {
    for (const int index : this->Rows[row])
    {
      const Chord& chord = this->Chords[index];
      const std::array<double, 2>& reach = this->Deviations[chord.Curve];
      if (!MayCross(chord.From, chord.To, { low[0] - reach[0], low[1] - reach[1] },
            { high[0] + reach[0], high[1] + reach[1] }))
      {
        continue;
      }
      crossed = true;
      if (hopeless && high[0] - low[0] <= reach[0] && high[1] - low[1] <= reach[1])
      {
        *hopeless = true;
      }
    }
  }
  return crossed                                                                    ? TrimSide::Undecided
    : this->GetWinding({ 0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]) }) != 0 ? TrimSide::Inside
                                                                                    : TrimSide::Outside;
}
}
