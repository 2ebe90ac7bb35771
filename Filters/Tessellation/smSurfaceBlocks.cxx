#include "smSurfaceBlocks.h"

#include "smBernsteinNet.h"
#include "smPatchCurvature.h"
#include "smPatchJump.h"
#include "smUnitRoundoff.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Spans of polynomials of low degree are one block, others two per direction. Where weights differ by more
/// than EvenWeights, parameters run unevenly towards the ends of a span, up to the ratio of the weights: its
/// parts are halved towards its ends as often, if MaxParts in a direction of the face allow. Strips stay
/// wider than ThinShare; weights that differ by more than MaxHalves allow have bounds that no mesh keeps, so
/// that parts do not help.
constexpr double EvenWeights = 4.0;
constexpr int MaxHalves = 13;
constexpr std::size_t MaxParts = 64;

/// Normals are not looked for where S_u and S_v are nearer to parallel, and turns not where the speed is this
/// part of the block's.
constexpr double MinSine = 1e-6;
constexpr double MinSpeed = 1e-2;
/// A block that seems to turn more, in radians, is not a guide to steps.
constexpr double MaxTurn = 3.2;

/// Normals of a block within this sine of its own make it a graph.
constexpr double MaxSine = 0.5;

/// A strip between knots, relative to the face, that is a crease: the first derivative changes across it by
/// its second times its width.
constexpr double ThinShare = 1e-4;

/// Errors below this part of the deflection are nothing.
constexpr double FlatShare = 1e-9;

/// Part of the deflection that a bound may leave to the error of a regular triangle without being made
/// sharper.
constexpr double EnoughShare = 0.4;

/// Jump of a derivative, relative to it, that is rounding.
constexpr double SmoothJump = 1e-8;

/// Largest weight over the smallest one; 1 without weights.
double GetWeightRatio(const NURBSSurface& surface)
{
  double lightest = HUGE_VAL;
  double heaviest = 0.0;
  for (const Homogeneous& h : surface.ControlPoints)
  {
    lightest = std::min(lightest, h[3]);
    heaviest = std::max(heaviest, h[3]);
  }
  return surface.Rational && lightest > 0.0 ? heaviest / lightest : 1.0;
}

/// Derivatives at a corner of the net, by its own parameters.
struct CornerDerivatives
{
  Vector3 First[2];
  double Speed[2];
  /// S_uu, S_uv, S_vv along the normal; 0 where that vanishes.
  double Normal[3];
};

CornerDerivatives EvaluateCorner(const BernsteinNet& net, int si, int sj)
{
  const int i = si > 0 ? 0 : net.P;
  const int j = sj > 0 ? 0 : net.Q;
  const Homogeneous& b = net.At(i, j);
  const Homogeneous& bu = net.At(i + si, j);
  const Homogeneous& bv = net.At(i, j + sj);
  const Homogeneous& buv = net.At(i + si, j + sj);
  const Homogeneous& buu = net.P > 1 ? net.At(i + 2 * si, j) : b;
  const Homogeneous& bvv = net.Q > 1 ? net.At(i, j + 2 * sj) : b;
  Homogeneous first[2];
  Homogeneous second[3];
  for (int c = 0; c < 4; ++c)
  {
    first[0][c] = si * net.P * (bu[c] - b[c]);
    first[1][c] = sj * net.Q * (bv[c] - b[c]);
    second[0][c] = net.P * (net.P - 1.0) * (buu[c] - 2.0 * bu[c] + b[c]);
    second[1][c] = si * sj * net.P * net.Q * (buv[c] - bu[c] - bv[c] + b[c]);
    second[2][c] = net.Q * (net.Q - 1.0) * (bvv[c] - 2.0 * bv[c] + b[c]);
  }
  const Vector3 s = Project(b);
  CornerDerivatives result{};
  for (int d = 0; d < 2; ++d)
  {
    result.First[d] = ProjectDerivative(first[d], s, b[3]);
    result.Speed[d] = Norm(result.First[d]);
  }
  const Vector3 cross = Cross(result.First[0], result.First[1]);
  const double area = Norm(cross);
  for (int k = 0; k < 3 && area > MinSine * result.Speed[0] * result.Speed[1]; ++k)
  {
    // The other parts of S_uu and S_uv lie in the tangent plane.
    result.Normal[k] = Dot(ProjectDerivative(second[k], s, b[3]), cross) / area;
  }
  return result;
}

/// Turn of the normal and speed at the four corners, per unit of the net's own parameters.
void MeasureCorners(const BernsteinNet& net, SurfaceBlocks::Block& block)
{
  CornerDerivatives corners[4];
  double fastest[2] = { 0.0, 0.0 };
  for (int k = 0; k < 4; ++k)
  {
    corners[k] = EvaluateCorner(net, k % 2 == 0 ? 1 : -1, k / 2 == 0 ? 1 : -1);
    for (int d = 0; d < 2; ++d)
    {
      fastest[d] = std::max(fastest[d], corners[k].Speed[d]);
      block.Speed[d] += 0.25 * corners[k].Speed[d];
    }
  }
  for (const CornerDerivatives& corner : corners)
  {
    // A pole has no turn.
    if (corner.Speed[0] > MinSpeed * fastest[0] && corner.Speed[1] > MinSpeed * fastest[1])
    {
      for (int d = 0; d < 2; ++d)
      {
        const double turn =
          std::hypot(corner.Normal[2 * d] / corner.Speed[d], corner.Normal[1] / corner.Speed[1 - d]);
        block.Turn[d] = std::max(block.Turn[d], std::min(turn, MaxTurn));
      }
    }
  }
}
}

namespace
{
/// Sets the bounds of a block, for parameters of the net's own.
void BoundBlock(
  const BernsteinNet& net, bool rational, const EnoughBound& enough, SurfaceBlocks::Block& block)
{
  // Circular arcs are even enough to do without a normal.
  const bool isArc = rational && net.P <= 2 && net.Q <= 2;
  const NetMiddle middle = isArc ? NetMiddle{} : EvaluateMiddle(net);
  const Vector3 cross = Cross(middle.First[0], middle.First[1]);
  const double area = Norm(cross);
  const Vector3 normal = area > 0.0 ? Normalized(cross) : Vector3{ 0.0, 0.0, 0.0 };
  const CurvatureBounds bounds = BoundSecondDerivatives(net, rational, normal, enough);
  block.Full = bounds.Full;
  block.Along = bounds.Full;
  // |S_u - du| and |S_v - dv| on the net; their cross product turns by no more than this.
  const double u = 0.5 * (block.Full[0] + block.Full[1]);
  const double v = 0.5 * (block.Full[1] + block.Full[2]);
  const double sine = (u * Norm(middle.First[1]) + v * Norm(middle.First[0]) + u * v) / area;
  if (!(sine < MaxSine))
  {
    return;
  }
  block.Normal = normal;
  block.Tilt = std::asin(sine);
  block.Along = bounds.Along;
}

/// Rounding of the derivative in direction d: some operations for each degree, on coordinates and weights.
double BoundRounding(const BernsteinNet& net, int d)
{
  double farthest = 0.0;
  double heaviest = 0.0;
  double lightest = HUGE_VAL;
  for (const Homogeneous& h : net.B)
  {
    farthest = std::max(farthest, Norm(Project(h)));
    heaviest = std::max(heaviest, h[3]);
    lightest = std::min(lightest, h[3]);
  }
  return 64.0 * UnitRoundoff * (d == 0 ? net.P : net.Q) * farthest * heaviest / lightest;
}
}

void SurfaceBlocks::Block::Choose(double tilt)
{
  const double slope = std::sin(std::min(tilt, 1.5)) < MaxSine ? std::tan(tilt) : HUGE_VAL;
  double* const chosen[3] = { &this->Uu, &this->Uv, &this->Vv };
  double sum[2] = { 0.0, 0.0 };
  for (int k = 0; k < 3; ++k)
  {
    sum[0] += this->Full[k];
    sum[1] += this->Full[k] > 0.0 ? this->Along[k] + slope * this->Full[k] : 0.0;
  }
  for (int k = 0; k < 3; ++k)
  {
    *chosen[k] = sum[0] <= sum[1] ? this->Full[k] : this->Along[k] + slope * this->Full[k];
  }
  this->JumpFactor = sum[0] <= sum[1] ? 1.0 : std::hypot(1.0, slope);
}

int SurfaceBlocks::ListBreaks(const NURBSSurface& surface, int d, std::vector<double>& spans)
{
  const std::vector<double> breaks = surface.GetSpanBreaks(d);
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
  {
    // The first and the last span answer for what lies beyond the domain; a point on a knot has the span
    // after it.
    if ((k + 2 == breaks.size() || breaks[k + 1] > this->Covered.Low[d]) &&
      (k == 0 || breaks[k] < this->Covered.High[d] || spans.empty()))
    {
      if (spans.empty())
      {
        spans.push_back(breaks[k]);
      }
      spans.push_back(breaks[k + 1]);
    }
  }
  const int degree = surface.Degree[d];
  std::vector<double> shares = { 0.0 };
  const double ratio = GetWeightRatio(surface);
  if (degree > 1 && (degree > 3 || surface.Rational))
  {
    const bool isUneven = ratio > EvenWeights && ratio <= std::ldexp(1.0, MaxHalves);
    const int wanted = isUneven ? static_cast<int>(std::ceil(std::log2(ratio))) : 1;
    const std::size_t allowed = std::max<std::size_t>(MaxParts / (2 * (spans.size() - 1)), 1);
    const int halves = std::min(wanted, static_cast<int>(allowed));
    for (int i = halves; i > 1; --i)
    {
      shares.push_back(std::ldexp(1.0, -i));
    }
    for (int i = 1; i <= halves; ++i)
    {
      shares.push_back(1.0 - std::ldexp(1.0, -i));
    }
  }
  for (std::size_t k = 0; k + 1 < spans.size(); ++k)
  {
    for (const double share : shares)
    {
      this->Breaks[d].push_back((1.0 - share) * spans[k] + share * spans[k + 1]);
    }
  }
  this->Breaks[d].push_back(spans.back());
  this->Breaks[d].front() = std::min(this->Breaks[d].front(), this->Covered.Low[d]);
  this->Breaks[d].back() = std::max(this->Breaks[d].back(), this->Covered.High[d]);
  return static_cast<int>(shares.size());
}

void SurfaceBlocks::MeasureBlock(const BernsteinNet& net, const std::array<double, 2>& low,
  const std::array<double, 2>& width, const std::array<std::size_t, 2>& at, bool rational,
  const MeshLimits& limits)
{
  double from[2];
  double to[2];
  double size[2];
  for (int d = 0; d < 2; ++d)
  {
    const std::vector<double>& breaks = this->Breaks[d];
    from[d] = (breaks[at[d]] - low[d]) / width[d];
    to[d] = (breaks[at[d] + 1] - low[d]) / width[d];
    size[d] = breaks[at[d] + 1] - breaks[at[d]];
  }
  const BernsteinNet piece = Restrict(net, from[0], to[0], from[1], to[1]);
  Block& block = this->Blocks[at[0] + at[1] * (this->Breaks[0].size() - 1)];
  MeasureCorners(piece, block);
  // Rows are nowhere farther from each other than the angle and the face allow.
  EnoughBound enough;
  enough.Sum = 8.0 * EnoughShare * limits.Deflection;
  for (int d = 0; d < 2; ++d)
  {
    const double all = (this->Covered.High[d] - this->Covered.Low[d]) / size[d];
    enough.Step[d] = block.Turn[d] * all > limits.Angle ? limits.Angle / block.Turn[d] : all;
  }
  BoundBlock(piece, rational, enough, block);
  const double unit[3] = { size[0] * size[0], size[0] * size[1], size[1] * size[1] };
  for (int k = 0; k < 3; ++k)
  {
    block.Full[k] /= unit[k];
    block.Along[k] /= unit[k];
  }
  for (int d = 0; d < 2; ++d)
  {
    block.Rounding[d] = BoundRounding(piece, d) / size[d];
    block.Turn[d] /= size[d];
    block.Speed[d] /= size[d];
  }
}

SurfaceBlocks::SurfaceBlocks(
  const NURBSSurface& surface, const ParameterBox& covered, const MeshLimits& limits)
  : Covered(covered)
{
  std::vector<double> spans[2];
  int parts[2];
  for (int d = 0; d < 2; ++d)
  {
    parts[d] = this->ListBreaks(surface, d, spans[d]);
  }
  this->Blocks.resize((this->Breaks[0].size() - 1) * (this->Breaks[1].size() - 1));
  // The net before the current one in u, and those of the row before.
  BernsteinNet net;
  net.Resize(surface.Degree[0], surface.Degree[1]);
  BernsteinNet left;
  std::vector<BernsteinNet> below(spans[0].size() - 1);
  for (std::size_t b = 0; b + 1 < spans[1].size(); ++b)
  {
    for (std::size_t a = 0; a + 1 < spans[0].size(); ++a)
    {
      const std::array<double, 2> low = { spans[0][a], spans[1][b] };
      const std::array<double, 2> width = { spans[0][a + 1] - low[0], spans[1][b + 1] - low[1] };
      surface.ExtractBezier(low[0], spans[0][a + 1], low[1], spans[1][b + 1], net.B.data());
      const BernsteinNet* const neighbors[2] = { a > 0 ? &left : nullptr, b > 0 ? &below[a] : nullptr };
      for (int d = 0; d < 2; ++d)
      {
        const std::vector<double>& knots = surface.Knots[d];
        if (neighbors[d] && std::count(knots.begin(), knots.end(), low[d]) >= surface.Degree[d])
        {
          const double widths[2] = { low[d] - spans[d][(d == 0 ? a : b) - 1], width[d] };
          double scale = 0.0;
          const double jump = BoundJump(*neighbors[d], net, d, widths, scale);
          if (jump > 0.0)
          {
            AddCrease(low[d], jump, jump > SmoothJump * scale ? this->Creases[d] : this->SmallJumps[d]);
          }
        }
      }
      left = below[a] = net;
      for (int part = 0; part < parts[0] * parts[1]; ++part)
      {
        this->MeasureBlock(net, low, width,
          { a * parts[0] + part % parts[0], b * parts[1] + part / parts[0] }, surface.Rational, limits);
      }
    }
  }
  for (int d = 0; d < 2; ++d)
  {
    this->CountThinStrips(d);
  }
  for (Block& block : this->Blocks)
  {
    block.Choose(block.Tilt);
  }
}

void SurfaceBlocks::CountThinStrips(int direction)
{
  const std::vector<double>& breaks = this->Breaks[direction];
  const std::size_t columns = this->Breaks[0].size() - 1;
  const double minimum = ThinShare * (this->Covered.High[direction] - this->Covered.Low[direction]);
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
  {
    const double width = breaks[i + 1] - breaks[i];
    if (width >= minimum)
    {
      continue;
    }
    double largest = 0.0;
    for (std::size_t k = 0; k + 1 < this->Breaks[1 - direction].size(); ++k)
    {
      Block& b = this->Blocks[direction == 0 ? i + k * columns : k + i * columns];
      double& second = b.Full[2 * direction];
      largest = std::max(largest, second);
      second = b.Along[2 * direction] = 0.0;
      b.Turn[direction] = 0.0;
    }
    this->Creases[direction].push_back({ 0.5 * (breaks[i] + breaks[i + 1]), largest * width, 0.5 * width });
  }
}

void SurfaceBlocks::AddCrease(double at, double jump, std::vector<Crease>& creases)
{
  for (Crease& crease : creases)
  {
    if (crease.At == at)
    {
      crease.Jump = std::max(crease.Jump, jump);
      return;
    }
  }
  creases.push_back({ at, jump, 0.0 });
}

void SurfaceBlocks::GetRange(const ParameterBox& box, int d, std::size_t& first, std::size_t& last) const
{
  const std::vector<double>& breaks = this->Breaks[d];
  const std::size_t count = breaks.size() - 1;
  if (count == 1)
  {
    first = last = 0;
    return;
  }
  const auto find = [&](double x)
  {
    const auto after = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, x);
    return static_cast<std::size_t>(after - breaks.begin()) - 1;
  };
  first = find(box.Low[d]);
  last = first;
  while (last + 1 < count && breaks[last + 1] < box.High[d])
  {
    ++last;
  }
}

const SurfaceBlocks::Block* SurfaceBlocks::FindSingle(const ParameterBox& box) const
{
  std::size_t first[2];
  std::size_t last[2];
  for (int d = 0; d < 2; ++d)
  {
    this->GetRange(box, d, first[d], last[d]);
    if (first[d] != last[d])
    {
      return nullptr;
    }
  }
  return &this->GetBlock(first[0], first[1]);
}

SurfaceBlocks::Block SurfaceBlocks::GetLargest(const ParameterBox& box) const
{
  if (const Block* single = this->FindSingle(box))
  {
    return *single;
  }
  std::size_t first[2];
  std::size_t last[2];
  this->GetRange(box, 0, first[0], last[0]);
  this->GetRange(box, 1, first[1], last[1]);
  // One normal for all, that of the block in the middle: what a derivative has along it is at most what it
  // has along its block's, plus its length times the distance of the two unit vectors.
  Block largest;
  largest.Normal = this->GetBlock((first[0] + last[0]) / 2, (first[1] + last[1]) / 2).Normal;
  largest.Tilt = 0.0;
  for (std::size_t j = first[1]; j <= last[1]; ++j)
  {
    for (std::size_t i = first[0]; i <= last[0]; ++i)
    {
      const Block& b = this->GetBlock(i, j);
      const double distance = Norm(Subtract(b.Normal, largest.Normal));
      largest.Tilt = std::max(largest.Tilt, b.Tilt + 2.0 * std::asin(std::min(0.5 * distance, 1.0)));
      for (int k = 0; k < 3; ++k)
      {
        largest.Full[k] = std::max(largest.Full[k], b.Full[k]);
        largest.Along[k] = std::max(largest.Along[k], std::min(b.Full[k], b.Along[k] + distance * b.Full[k]));
      }
      for (int d = 0; d < 2; ++d)
      {
        largest.Rounding[d] = std::max(largest.Rounding[d], b.Rounding[d]);
        largest.Turn[d] = std::max(largest.Turn[d], b.Turn[d]);
        largest.Speed[d] = std::max(largest.Speed[d], b.Speed[d]);
      }
    }
  }
  largest.Choose(largest.Tilt);
  return largest;
}

double SurfaceBlocks::GetSmallJumps() const
{
  double error = 0.0;
  for (int d = 0; d < 2; ++d)
  {
    for (const Crease& crease : this->SmallJumps[d])
    {
      error += 0.25 * crease.Jump * (this->Covered.High[d] - this->Covered.Low[d]);
    }
  }
  const bool isGraph = std::any_of(this->Blocks.begin(), this->Blocks.end(),
    [](const Block& b) { return std::sin(std::min(b.Tilt, 1.5)) < MaxSine; });
  return isGraph ? error / std::sqrt(1.0 - MaxSine * MaxSine) : error;
}

bool SurfaceBlocks::IsFlat(double deflection, double angle) const
{
  if (!this->Creases[0].empty() || !this->Creases[1].empty())
  {
    return false;
  }
  const double w[2] = { this->Covered.High[0] - this->Covered.Low[0],
    this->Covered.High[1] - this->Covered.Low[1] };
  const double square = std::max(w[0] * w[0], w[1] * w[1]);
  return std::all_of(this->Blocks.begin(), this->Blocks.end(),
    [&](const Block& b)
    {
      return square * (b.Full[0] + b.Full[1] + b.Full[2]) <= FlatShare * deflection &&
        std::hypot(b.Turn[0] * w[0], b.Turn[1] * w[1]) <= FlatShare * angle;
    });
}

SurfaceBlocks::DerivativeChanges SurfaceBlocks::GetDerivativeChanges(
  const ParameterBox& box, double share, const Vector3& normal) const
{
  const Block* const single = this->FindSingle(box);
  const Block several = single ? Block() : this->GetLargest(box);
  const Block& m = single ? *single : several;
  const double distance = Norm(Subtract(normal, m.Normal));
  const double w[2] = { share * (box.High[0] - box.Low[0]), share * (box.High[1] - box.Low[1]) };
  DerivativeChanges changes{ m.Rounding, m.Rounding };
  for (int d = 0; d < 2; ++d)
  {
    for (int e = 0; e < 2; ++e)
    {
      changes.Full[d] += m.Full[d + e] * w[e];
      changes.Along[d] += std::min(m.Full[d + e], m.Along[d + e] + distance * m.Full[d + e]) * w[e];
    }
    for (const std::vector<Crease>* const creases : { &this->Creases[d], &this->SmallJumps[d] })
    {
      for (const Crease& crease : *creases)
      {
        if (crease.At + crease.Half >= box.Low[d] && crease.At - crease.Half <= box.High[d])
        {
          changes.Full[d] += crease.Jump;
          changes.Along[d] += crease.Jump;
        }
      }
    }
  }
  return changes;
}

double SurfaceBlocks::GetError(const ParameterBox& box) const
{
  const Block* const single = this->FindSingle(box);
  const Block several = single ? Block() : this->GetLargest(box);
  const Block& m = single ? *single : several;
  const double w[2] = { box.High[0] - box.Low[0], box.High[1] - box.Low[1] };
  const auto sum = [&w](double uu, double uv, double vv)
  { return 0.125 * (uu * w[0] * w[0] + 2.0 * uv * w[0] * w[1] + vv * w[1] * w[1]); };
  const double error = sum(m.Uu, m.Uv, m.Vv);
  double jumps = 0.0;
  for (int d = 0; d < 2; ++d)
  {
    for (const Crease& crease : this->Creases[d])
    {
      // A hinge leaves its chord by the jump times the distance from the nearer border at most, and by a
      // quarter of the width.
      const double inside =
        std::min(crease.At + crease.Half - box.Low[d], box.High[d] - crease.At + crease.Half);
      const double slack = 1e-12 * std::max(std::abs(crease.At), w[d]);
      jumps += inside > 0.0 ? crease.Jump * (inside > slack ? 0.25 * w[d] : inside) : 0.0;
    }
  }
  return jumps > 0.0 ? std::min(error + m.JumpFactor * jumps, sum(m.Full[0], m.Full[1], m.Full[2]) + jumps)
                     : error;
}
}
