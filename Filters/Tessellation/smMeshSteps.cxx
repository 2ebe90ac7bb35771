#include "Detail/smMeshSteps.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
using Parameters = MeshSteps::Parameters;

/// Part of the deflection that a regular triangle may take; others are larger.
constexpr double RegularShare = 0.8;
/// Largest ratio of the sides of triangles that are to be well shaped, where the surface is straight one way.
constexpr double MaxShape = 10.0;
/// Points that rows may have in all. Faces that want a thousand times as many have bounds that no mesh keeps:
/// they get none.
constexpr double MaxRowPoints = 2e6;
constexpr double HopelessRatio = 1e3;
constexpr double MaxRows = 1e4;

/// Distances between points in u and v that the deflection, the angle and the size of the face allow.
Parameters GetSteps(const SurfaceBlocks::Block& b, const Parameters& size, const MeshLimits& limits)
{
  double h[2];
  for (int d = 0; d < 2; ++d)
  {
    h[d] = b.Turn[d] * size[d] > limits.Angle ? limits.Angle / b.Turn[d] : size[d];
  }
  const double budget = 8.0 * RegularShare * limits.Deflection;
  const auto sum = [&]() { return b.Uu * h[0] * h[0] + 2.0 * b.Uv * h[0] * h[1] + b.Vv * h[1] * h[1]; };
  if (sum() > budget)
  {
    const double m[2] = { b.Uu, b.Vv };
    double other[2];
    for (int d = 0; d < 2; ++d)
    {
      other[d] = m[1 - d] * h[1 - d] * h[1 - d];
    }
    for (int d = 0; d < 2; ++d)
    {
      // Half of it, or what the other direction leaves.
      const double share = std::max(0.5 * budget, budget - other[d]);
      if (m[d] * h[d] * h[d] > share)
      {
        h[d] = std::sqrt(share / m[d]);
      }
    }
    const double rest = sum();
    if (rest > budget)
    {
      const double scale = std::sqrt(budget / rest);
      h[0] *= scale;
      h[1] *= scale;
    }
  }
  return { h[0], h[1] };
}

/// A density of points along a line, constant on strips.
class Density
{
public:
  Density(const std::vector<double>& breaks, const std::vector<double>& values, double low, double high)
  {
    this->At.push_back(low);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const double from = std::max(breaks[i], low);
      const double to = i + 1 == values.size() ? high : std::min(breaks[i + 1], high);
      if (to > from)
      {
        this->At.push_back(to);
        this->Sum.push_back(this->Sum.back() + (to - from) * values[i]);
      }
    }
  }
  double GetTotal() const { return this->Sum.back(); }
  int GetSteps() const
  {
    return std::max(static_cast<int>(std::ceil(std::min(this->GetTotal(), MaxRows) - 1e-3)), 1);
  }
  /// Point k of n equal steps.
  double GetPoint(int k, int n)
  {
    const double target = this->GetTotal() * k / n;
    this->Place = k <= 1 ? 1 : this->Place;
    while (this->Place + 1 < this->At.size() && this->Sum[this->Place] < target)
    {
      ++this->Place;
    }
    const std::size_t i = this->Place;
    const double share = (target - this->Sum[i - 1]) / (this->Sum[i] - this->Sum[i - 1]);
    return this->At[i - 1] + share * (this->At[i] - this->At[i - 1]);
  }
  /// Points per unit at the last point.
  double GetValue() const
  {
    const std::size_t i = this->Place;
    return (this->Sum[i] - this->Sum[i - 1]) / (this->At[i] - this->At[i - 1]);
  }

private:
  std::vector<double> At;
  std::vector<double> Sum{ 0.0 };
  std::size_t Place = 1;
};
}

MeshSteps::MeshSteps(const SurfaceBlocks& blocks, const ParameterBox& box, const MeshLimits& limits)
  : Blocks(blocks)
  , Box(box)
  , Size{ box.High[0] - box.Low[0], box.High[1] - box.Low[1] }
{
  for (std::size_t j = 0; j + 1 < blocks.GetBreaks(1).size(); ++j)
  {
    for (std::size_t i = 0; i + 1 < blocks.GetBreaks(0).size(); ++i)
    {
      const SurfaceBlocks::Block& b = blocks.GetBlock(i, j);
      this->Steps.push_back(GetSteps(b, this->Size, limits));
      for (int d = 0; d < 2; ++d)
      {
        this->Speed[d] = std::max(this->Speed[d], b.Speed[d]);
      }
    }
  }
}

MeshSteps::Parameters MeshSteps::GetMetric() const
{
  Parameters density{ 0.0, 0.0 };
  Parameters speed{ 0.0, 0.0 };
  const auto count = static_cast<double>(this->Steps.size());
  std::size_t block = 0;
  for (std::size_t j = 0; j + 1 < this->Blocks.GetBreaks(1).size(); ++j)
  {
    for (std::size_t i = 0; i + 1 < this->Blocks.GetBreaks(0).size(); ++i, ++block)
    {
      for (int d = 0; d < 2; ++d)
      {
        density[d] += 1.0 / this->Steps[block][d];
        speed[d] += this->Blocks.GetBlock(i, j).Speed[d];
      }
    }
  }
  bool curved = false;
  for (int d = 0; d < 2; ++d)
  {
    density[d] /= count;
    speed[d] = std::max(speed[d] / count, 1e-300);
    curved = curved || density[d] * this->Size[d] > 1.0 + 1e-9;
  }
  const double longest = curved ? MaxShape : 1.0;
  Parameters metric;
  for (int d = 0; d < 2; ++d)
  {
    metric[d] = std::max(density[d], density[1 - d] * speed[d] / speed[1 - d] / longest);
  }
  return metric;
}

const MeshSteps::Parameters& MeshSteps::GetStep(std::size_t i, std::size_t j) const
{
  return this->Steps[i + j * (this->Blocks.GetBreaks(0).size() - 1)];
}

double MeshSteps::GetDensity(int d, std::size_t i, std::size_t first, std::size_t last) const
{
  double largest = 0.0;
  for (std::size_t j = first; j <= last; ++j)
  {
    largest = std::max(largest, 1.0 / (d == 0 ? this->GetStep(i, j) : this->GetStep(j, i))[d]);
  }
  return largest;
}

double MeshSteps::CountWanted() const
{
  double wanted = 0.0;
  for (std::size_t j = 0; j + 1 < this->Blocks.GetBreaks(1).size(); ++j)
  {
    for (std::size_t i = 0; i + 1 < this->Blocks.GetBreaks(0).size(); ++i)
    {
      double count = 1.0;
      for (int d = 0; d < 2; ++d)
      {
        const double* const ends = this->Blocks.GetBreaks(d).data() + (d == 0 ? i : j);
        const double width = std::min(ends[1], this->Box.High[d]) - std::max(ends[0], this->Box.Low[d]);
        count = width > 0.0 ? count * width / this->GetStep(i, j)[d] : 0.0;
      }
      wanted += count;
    }
  }
  return wanted;
}

int MeshSteps::ChooseRows() const
{
  double spread[2];
  for (int d = 0; d < 2; ++d)
  {
    const std::size_t here = this->Blocks.GetBreaks(d).size() - 1;
    const std::size_t other = this->Blocks.GetBreaks(1 - d).size() - 1;
    double maximum = 0.0;
    double minimum = 1e300;
    for (std::size_t i = 0; i < here; ++i)
    {
      const double x = this->GetDensity(1 - d, 0, i, i);
      double along = x;
      for (std::size_t k = 1; k < other; ++k)
      {
        along = std::max(along, this->GetDensity(1 - d, k, i, i));
      }
      maximum = std::max(maximum, along);
      minimum = std::min(minimum, along);
    }
    spread[d] = maximum / minimum;
  }
  return spread[0] > spread[1] ? 0 : 1;
}

void MeshSteps::LayRows(const std::function<void(const Parameters& at, const Parameters& scale)>& add) const
{
  const double ratio = this->CountWanted() / MaxRowPoints;
  if (!(ratio < HopelessRatio))
  {
    return;
  }
  const double thinning = ratio > 1.0 ? 1.0 / std::sqrt(ratio) : 1.0;
  const int d = this->ChooseRows();
  const std::vector<double>& breaks = this->Blocks.GetBreaks(d);
  const std::vector<double>& across = this->Blocks.GetBreaks(1 - d);
  std::vector<double> values;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
  {
    values.push_back(thinning * this->GetDensity(d, i, 0, across.size() - 2));
  }
  Density rows(breaks, values, this->Box.Low[d], this->Box.High[d]);
  const int count = rows.GetSteps();
  double total = 0.0;
  for (int k = 1; k < count && total < MaxRowPoints; ++k)
  {
    const double here = rows.GetPoint(k, count);
    const double step = 1.0 / rows.GetValue();
    std::size_t first = 0;
    std::size_t last = 0;
    while (first + 2 < breaks.size() && breaks[first + 1] <= here - step)
    {
      ++first;
    }
    last = first;
    while (last + 2 < breaks.size() && breaks[last + 1] < here + step)
    {
      ++last;
    }
    std::vector<double> along;
    for (std::size_t i = 0; i + 1 < across.size(); ++i)
    {
      along.push_back(thinning * this->GetDensity(1 - d, i, first, last));
    }
    Density points(across, along, this->Box.Low[1 - d], this->Box.High[1 - d]);
    const int steps = points.GetSteps();
    total += steps;
    std::vector<std::array<double, 2>> row;
    for (int i = 1; i < steps; ++i)
    {
      const double x = points.GetPoint(i, steps);
      row.push_back({ x, points.GetValue() });
    }
    // Back and forth, so that each point is found near the one before.
    if (k % 2 == 0)
    {
      std::reverse(row.begin(), row.end());
    }
    for (const auto& [x, density] : row)
    {
      Parameters at;
      Parameters scale;
      at[d] = here;
      at[1 - d] = x;
      scale[d] = 1.0 / step;
      scale[1 - d] = density;
      add(at, scale);
    }
  }
}
}
