// Computes the curvature samples of ContactSearch, and the directions in which the body continues around a
// contact.
#include "Detail/smContactSearchInternals.h"

#include "smUnitRoundoff.h"

namespace sm
{
Point2 GetContactDirection(int k)
{
  const double angle = 6.283185307179586 * k / ContactDirections;
  return { std::cos(angle), std::sin(angle) };
}

/// Returns the directions (a bit for each) in which the face continues at a point where it is tangent to the
/// ground: those in which neighbouring points are inside the loops, or on a border.
std::uint32_t ContactSearch::Internals::FindDirections(
  const FaceContact& face, int patch, const std::array<double, 2>& sr, const GroundPatch::Shape& shape)
{
  const auto& [a, b] = shape.Tangents;
  const double determinant = a[0] * b[1] - a[1] * b[0];
  const Patch& source = face.Cut->Panels.Patches[patch];
  const NURBSSurface& surface = face.Cut->Source->Surface;
  std::uint32_t directions = ~0u;
  for (int k = 0; k < ContactDirections; ++k)
  {
    const Point2 e = GetContactDirection(k);
    std::array<double, 2> step = { (e[0] * b[1] - e[1] * b[0]) / determinant,
      (a[0] * e[1] - a[1] * e[0]) / determinant };
    const double largest = std::max(std::abs(step[0]), std::abs(step[1]));
    TrimSide side = TrimSide::Undecided;
    for (double length = 1e-4; length < 0.05 && side == TrimSide::Undecided; length *= 10.0)
    {
      double at[2];
      bool leaves = false;
      for (int d = 0; d < 2; ++d)
      {
        // Rounding does not rotate a step along a border.
        at[d] = sr[d] + (std::abs(step[d]) < 1e-9 * largest ? 0.0 : length * step[d] / largest);
        const int direction = source.Exchanged ? 1 - d : d;
        const double x = source.Start[d] + source.Width[d] * at[d];
        leaves = leaves || x < surface.GetDomainStart(direction) || x > surface.GetDomainEnd(direction);
      }
      side = leaves ? TrimSide::Outside : face.Classify(patch, at, at);
    }
    directions &= side == TrimSide::Outside ? ~(1u << k) : ~0u;
  }
  return directions;
}

/// Returns the same directions at a pole, where the border sr[across] = 0 or 1 of the patch is one point:
/// lines of constant parameter leave it in the directions of their tangents. Returns 0 if the border is not a
/// pole.
std::uint32_t ContactSearch::Internals::FindPoleDirections(
  const FaceContact& face, int patch, std::array<double, 2> sr)
{
  // The sample is the middle of a small box.
  const GroundPatch& root = face.Patches[patch];
  for (double& x : sr)
  {
    x = std::abs(x - std::round(x)) < 1e-4 ? std::round(x) : x;
  }
  const GroundPatch::Shape shape = root.GetShape(sr[0], sr[1]);
  const double lengths[2] = { std::hypot(shape.Tangents[0][0], shape.Tangents[0][1]),
    std::hypot(shape.Tangents[1][0], shape.Tangents[1][1]) };
  const int across = lengths[0] >= lengths[1] ? 0 : 1;
  if (lengths[1 - across] > 1e-6 * lengths[across] || (sr[across] != 0.0 && sr[across] != 1.0))
  {
    return 0;
  }
  const double inward = sr[across] == 0.0 ? 1.0 : -1.0;
  const int lines = 64;
  std::uint32_t directions = 0;
  Point2 before{};
  bool leftBefore = true;
  for (int i = 0; i <= lines; ++i)
  {
    std::array<double, 2> at = sr;
    at[1 - across] = static_cast<double>(i) / lines;
    const std::array<double, 2> tangent = root.GetShape(at[0], at[1]).Tangents[across];
    const Point2 now = { inward * tangent[0], inward * tangent[1] };
    TrimSide side = TrimSide::Undecided;
    for (double length = 1e-4; length < 0.05 && side == TrimSide::Undecided; length *= 10.0)
    {
      at[across] = sr[across] + inward * length;
      side = face.Classify(patch, at.data(), at.data());
    }
    const bool left = side == TrimSide::Outside;
    for (int k = 0; k < ContactDirections && i > 0 && !(left && leftBefore); ++k)
    {
      // Between the two tangents, which include an angle below pi; the tolerance allows for rounding.
      const Point2 e = GetContactDirection(k);
      const auto cross = [](const Point2& a, const Point2& b) { return a[0] * b[1] - a[1] * b[0]; };
      const double sense = cross(before, now) < 0.0 ? -1.0 : 1.0;
      const double slack = 1e-9 * lengths[across];
      const bool between = sense * cross(before, e) >= -slack && sense * cross(e, now) >= -slack &&
        (before[0] + now[0]) * e[0] + (before[1] + now[1]) * e[1] > 0.0;
      directions |= between ? 1u << k : 0u;
    }
    before = now;
    leftBefore = left;
  }
  return directions;
}

/// Adds the curvature at a point. Where the surface has no normal (at a pole), it is evaluated at points
/// nearby.
void ContactSearch::Internals::AddSample(
  const FaceContact& face, int patch, std::array<double, 2> sr, const Point2& position)
{
  const std::size_t enough = 512;
  if (this->Found.Samples.size() >= enough)
  {
    return;
  }
  const GroundPatch& root = face.Patches[patch];
  const auto clamp = [](double x) { return std::clamp(x, 0.0, 1.0); };
  GroundPatch::Shape shape = root.GetShape(clamp(sr[0]), clamp(sr[1]));
  // Near a pole the curvature is a quotient of numbers as small as the square of the shorter tangent.
  const auto getError = [this](const GroundPatch::Shape& at)
  {
    const double lengths[2] = { std::hypot(at.Tangents[0][0], at.Tangents[0][1]),
      std::hypot(at.Tangents[1][0], at.Tangents[1][1]) };
    const double ratio = std::max(lengths[0], lengths[1]) / std::min(lengths[0], lengths[1]);
    return (1e-9 + 1024.0 * UnitRoundoff * ratio * ratio) * this->Size;
  };
  ContactSample sample{ position, 0.0, 0.0, 0.0 };
  if (std::isnan(shape.Curvature))
  {
    const auto look = [&](double share)
    {
      return root.GetShape(
        clamp(sr[0]) + share * (0.5 - clamp(sr[0])), clamp(sr[1]) + share * (0.5 - clamp(sr[1])));
    };
    const GroundPatch::Shape near = look(1e-3);
    const GroundPatch::Shape far = look(2e-3);
    // The normal rotates by an angle of about the parameter distance.
    if (near.Normal >= 1.0 - 1e-4 && far.Normal <= near.Normal + 1e-9)
    {
      sample.Radius = near.Curvature > 0.0 ? 1.0 / near.Curvature : Infinity;
      sample.RadiusError =
        std::abs(sample.Radius - (far.Curvature > 0.0 ? 1.0 / far.Curvature : Infinity)) + getError(near);
      sample.Widest = near.MinimumCurvature * this->Size > 1e-9 ? 1.0 / near.MinimumCurvature : Infinity;
      const std::uint32_t directions = FindPoleDirections(face, patch, { clamp(sr[0]), clamp(sr[1]) });
      sample.RadiusError = directions == 0 ? Infinity : sample.RadiusError;
      sample.GoesOn = directions == 0 ? ~0u : directions;
    }
  }
  else if (shape.Normal >= TangentCosine)
  {
    sample.Radius = shape.Curvature * this->Size > 1e-9 ? 1.0 / shape.Curvature : Infinity;
    sample.RadiusError = getError(shape);
    sample.Widest = shape.MinimumCurvature * this->Size > 1e-9 ? 1.0 / shape.MinimumCurvature : Infinity;
    sample.GoesOn = FindDirections(face, patch, { clamp(sr[0]), clamp(sr[1]) }, shape);
  }
  this->Found.Samples.push_back(sample);
}
}
