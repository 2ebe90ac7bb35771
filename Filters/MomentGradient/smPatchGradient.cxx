#include "Detail/smPatchGradient.h"

#include "smGaussLegendre.h"
#include "smPortableCxx.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
#include "glsl/smGradientSample.glsl"

smGradientPatch MakeNet(const PatchTask& task)
{
  const PatchConstants from = MakePatchConstants(task);
  const int* degrees = task.GetPatch().Degree;
  smGradientPatch net;
  net.origin = dvec3(from.Origin[0], from.Origin[1], from.Origin[2]);
  net.radius = from.Radius;
  net.stretch = dvec2(from.Stretch[0], from.Stretch[1]);
  net.off = from.Off;
  net.offSlope = dvec2(from.OffSlope[0], from.OffSlope[1]);
  net.roundings = from.Roundings;
  net.additions = from.Additions;
  net.degrees = dvec2(degrees[0], degrees[1]);
  return net;
}

/// Adds `factor` times `count` numbers.
inline void AddMultiple(double factor, const double* from, int count, double* to)
{
  for (int k = 0; k < count; ++k)
  {
    to[k] += factor * from[k];
  }
}

/// The integrals of a line, before they meet the polynomials in r.
class LineIntegrals
{
public:
  explicit LineIntegrals(const PatchTask& task)
    : Points(task.GetPoints())
    , Constants(MakeNet(task))
    , Degree{ task.GetPatch().Degree[0], task.GetPatch().Degree[1] }
    , Row(this->Degree[0] + 1)
    , RowS(this->Row)
    , RowR(this->Row)
    , Sums(channel::Count * this->Row.size())
    , Slopes(4 * this->Row.size())
  {
  }

  void Add(const PatchLine& line, PatchSums& to);

  /// PatchSums::AreaNoise of the lines so far.
  dvec2 AreaNoise{ 0.0, 0.0 };

private:
  void MakeRow(const DerivedBasis& inR);
  void AddPoint(const smGradientLine& line, double s, double weight);

  const std::array<double, 4>* Points;
  smGradientPatch Constants;
  int Degree[2];
  // The net reduced to a curve in s, and its derivatives.
  std::vector<dvec4> Row, RowS, RowR;
  // For each polynomial in s; the slopes meet the derivatives of the polynomials in r.
  std::vector<double> Sums, Slopes;
};

void LineIntegrals::MakeRow(const DerivedBasis& inR)
{
  const int p = this->Degree[0];
  const int q = this->Degree[1];
  const auto get = [this, p](int i, int j)
  {
    const std::array<double, 4>& point = this->Points[i + static_cast<std::ptrdiff_t>(j) * (p + 1)];
    return dvec4(point[0], point[1], point[2], point[3]);
  };
  for (int i = 0; i <= p; ++i)
  {
    this->Row[i] = this->RowS[i] = this->RowR[i] = dvec4(0.0);
    for (int j = 0; j <= q; ++j)
    {
      const dvec4 point = get(i, j);
      this->Row[i] += inR.Values[j] * point;
      // Differences come first: the rounding of a derivative is relative to them.
      this->RowR[i] += j < q ? static_cast<double>(q) * (inR.Lower[j] * (get(i, j + 1) - point)) : dvec4(0.0);
      this->RowS[i] +=
        i < p ? static_cast<double>(p) * (inR.Values[j] * (get(i + 1, j) - point)) : dvec4(0.0);
    }
  }
}

void LineIntegrals::AddPoint(const smGradientLine& line, double s, double weight)
{
  const int p = this->Degree[0];
  const DerivedBasis inS(p, s);
  dvec4 h(0.0);
  dvec4 hs(0.0);
  dvec4 hr(0.0);
  for (int i = 0; i <= p; ++i)
  {
    h += inS.Values[i] * this->Row[i];
    hr += inS.Values[i] * this->RowR[i];
    hs += inS.Lower[i] * this->RowS[i];
  }
  const smGradientSample at = smMakeGradientSample(this->Constants, line, weight, h, hs, hr);
  const dvec3& x = at.position;
  const double g[NumberOfMoments] = { 1.0, x.x, x.y, x.z, x.x * x.x, x.y * x.y, x.z * x.z, x.x * x.y,
    x.y * x.z, x.x * x.z };
  double values[channel::Count];
  for (int k = 0; k < NumberOfMoments; ++k)
  {
    const double factor = at.weight * g[k];
    for (int c = 0; c < 4; ++c)
    {
      values[4 * k + c] = factor * at.flux[c];
    }
  }
  for (int c = 0; c < 4; ++c)
  {
    values[channel::Area + c] = at.area[c];
    values[channel::Noise + c] = at.noise[c];
  }
  for (int i = 0; i <= p; ++i)
  {
    double* sums = this->Sums.data() + channel::Count * static_cast<std::size_t>(i);
    AddMultiple(inS.Values[i], values, channel::Noise, sums);
    AddMultiple(std::abs(inS.Values[i]), values + channel::Noise, channel::Count - channel::Noise,
      sums + channel::Noise);
    AddMultiple(inS.Slopes[i], &at.alongS.x, 4, sums + channel::Area);
    AddMultiple(inS.Values[i], &at.alongR.x, 4, this->Slopes.data() + 4 * static_cast<std::size_t>(i));
  }
  this->AreaNoise += at.areaNoise;
}

void LineIntegrals::Add(const PatchLine& line, PatchSums& to)
{
  const DerivedBasis inR(this->Degree[1], line.R);
  this->MakeRow(inR);
  std::fill(this->Sums.begin(), this->Sums.end(), 0.0);
  std::fill(this->Slopes.begin(), this->Slopes.end(), 0.0);
  const smGradientLine own{ line.Coverage, line.Side, line.EdgeS, line.Growth, line.TrimRounding };
  const double* rule = GetRuleTable().data() + line.Across * (line.Across - 1);
  for (int b = 0; b < line.Across; ++b)
  {
    this->AddPoint(
      own, (line.XiStart + line.XiWidth * rule[2 * b]) * line.EdgeS, line.Weight * rule[2 * b + 1]);
  }
  for (int j = 0; j <= this->Degree[1]; ++j)
  {
    for (std::size_t i = 0; i < this->Row.size(); ++i)
    {
      double* sums = to.Sums.data() + channel::Count * (i + this->Row.size() * static_cast<std::size_t>(j));
      const double* from = this->Sums.data() + channel::Count * i;
      AddMultiple(inR.Values[j], from, channel::Noise, sums);
      AddMultiple(std::abs(inR.Values[j]), from + channel::Noise, channel::Count - channel::Noise,
        sums + channel::Noise);
      AddMultiple(inR.Slopes[j], this->Slopes.data() + 4 * i, 4, sums + channel::Area);
    }
  }
}
}

PatchSums MakePatchSums(const PatchTask& task, const std::vector<PatchLine>& lines)
{
  PatchSums sums;
  std::copy_n(task.GetPatch().Degree, 2, sums.Degree);
  sums.Sums.assign(channel::Count * static_cast<std::size_t>(sums.Degree[0] + 1) * (sums.Degree[1] + 1), 0.0);
  for (const PatchLine& line : lines)
  {
    sums.Growth = std::max(sums.Growth, line.Growth);
    sums.Evaluations += line.Across;
  }
  return sums;
}

PatchSums ComputePatchSums(const PatchTask& task)
{
  const std::vector<PatchLine> lines = MakePatchLines(task);
  PatchSums sums = MakePatchSums(task, lines);
  LineIntegrals integrals(task);
  for (const PatchLine& line : lines)
  {
    integrals.Add(line, sums);
  }
  sums.AreaNoise[0] = integrals.AreaNoise.x;
  sums.AreaNoise[1] = integrals.AreaNoise.y;
  return sums;
}
}
