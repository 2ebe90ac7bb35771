#include "smRationalBound.h"

#include <algorithm>
#include <cmath>

namespace sm
{
RationalBound::RationalBound(const BernsteinNet& net, const Vector3& normal)
  : Net(net)
  , Normal(normal)
  , Centered(net)
  , Middle(EvaluateMiddle(net))
  , Lightest(HUGE_VAL)
{
  const int p = net.P;
  const int q = net.Q;
  Homogeneous* const b = this->Centered.B.data();
  for (int j = 0; j <= q; ++j)
  {
    for (int i = 0; i <= p; ++i)
    {
      Homogeneous& h = b[i + j * (p + 1)];
      for (int x = 0; x < 3; ++x)
      {
        h[x] -= h[3] * this->Middle.Position[x];
      }
      this->Lightest = std::min(this->Lightest, std::max(h[3], MinWeight));
      if (i > 0)
      {
        this->Slope[0] = std::max(this->Slope[0], p * std::abs(h[3] - b[i - 1 + j * (p + 1)][3]));
      }
      if (j > 0)
      {
        this->Slope[1] = std::max(this->Slope[1], q * std::abs(h[3] - b[i + (j - 1) * (p + 1)][3]));
      }
    }
  }
  this->Slope[0] /= this->Lightest;
  this->Slope[1] /= this->Lightest;
}

void RationalBound::AddLines(int direction, Bracket& bracket) const
{
  const int p = this->Net.P;
  const int degree = direction == 0 ? p : this->Net.Q;
  const int lines = direction == 0 ? this->Net.Q : p;
  const int stride = direction == 0 ? 1 : p + 1;
  const double factor = degree * (degree - 1.0);
  // Second derivatives have one degree less than the bracket.
  const double share = degree > 1 ? 1.0 / (degree - 1.0) : 0.0;
  const Vector3& first = this->Middle.First[direction];
  for (int line = 0; line <= lines; ++line)
  {
    const Homogeneous* const b = this->Centered.B.data() + line * (direction == 0 ? p + 1 : 1);
    Homogeneous before{};
    for (int i = 0; i < degree; ++i)
    {
      const Homogeneous& b0 = b[i * stride];
      const Homogeneous& b1 = b[(i + 1) * stride];
      Homogeneous second{};
      if (i + 2 <= degree)
      {
        const Homogeneous& b2 = b[(i + 2) * stride];
        for (int c = 0; c < 4; ++c)
        {
          second[c] = factor * (b2[c] - 2.0 * b1[c] + b0[c]);
        }
        bracket.Weight = std::max(bracket.Weight, std::abs(second[3]));
      }
      const double slope = 2.0 * degree * (b1[3] - b0[3]);
      Vector3 value;
      for (int c = 0; c < 3; ++c)
      {
        value[c] = i * share * before[c] + (1.0 - i * share) * second[c] - slope * first[c];
      }
      bracket.Coefficients.Add(value);
      if ((i == 0 || i + 1 == degree) && (line == 0 || line == lines))
      {
        const double w = i == 0 ? b0[3] : b1[3];
        bracket.Corners.Add({ value[0] / w, value[1] / w, value[2] / w });
      }
      before = second;
    }
  }
}

void RationalBound::AddMixed(Bracket& bracket) const
{
  const int p = this->Net.P;
  const int q = this->Net.Q;
  const Homogeneous* const b = this->Centered.B.data();
  const double factor = static_cast<double>(p) * q;
  // Everything is raised to the degrees of the net: means of neighbours.
  Homogeneous row[2][MaximumDegree + 1];
  for (int j = 0; j <= q; ++j)
  {
    // row[j % 2][i]: S_uv of cells (i, j), raised in u.
    Homogeneous* const here = row[j % 2];
    const Homogeneous* const below = row[(j + 1) % 2];
    for (int i = 0; j < q && i <= p; ++i)
    {
      Homogeneous cells[2] = {};
      for (int side = 0; side < 2; ++side)
      {
        const int x = i - 1 + side;
        if (x < 0 || x >= p)
        {
          continue;
        }
        const Homogeneous* const low = b + x + j * (p + 1);
        const Homogeneous* const high = low + p + 1;
        for (int c = 0; c < 4; ++c)
        {
          cells[side][c] = factor * (high[1][c] - high[0][c] - low[1][c] + low[0][c]);
        }
        bracket.Weight = std::max(bracket.Weight, std::abs(cells[side][3]));
      }
      const double share = static_cast<double>(i) / p;
      for (int c = 0; c < 4; ++c)
      {
        here[i][c] = share * cells[0][c] + (1.0 - share) * cells[1][c];
      }
    }
    const double shareV = static_cast<double>(j) / q;
    for (int i = 0; i <= p; ++i)
    {
      const Homogeneous* const at = b + i + j * (p + 1);
      const double shareU = static_cast<double>(i) / p;
      const double slopeU = (i > 0 ? shareU * p * (at[0][3] - at[-1][3]) : 0.0) +
        (i < p ? (1.0 - shareU) * p * (at[1][3] - at[0][3]) : 0.0);
      const double slopeV = (j > 0 ? shareV * q * (at[0][3] - at[-(p + 1)][3]) : 0.0) +
        (j < q ? (1.0 - shareV) * q * (at[p + 1][3] - at[0][3]) : 0.0);
      Vector3 value;
      for (int c = 0; c < 3; ++c)
      {
        value[c] = (j > 0 ? shareV * below[i][c] : 0.0) + (j < q ? (1.0 - shareV) * here[i][c] : 0.0) -
          slopeU * this->Middle.First[1][c] - slopeV * this->Middle.First[0][c];
      }
      bracket.Coefficients.Add(value);
      if ((i == 0 || i == p) && (j == 0 || j == q))
      {
        const double w = at[0][3];
        bracket.Corners.Add({ value[0] / w, value[1] / w, value[2] / w });
      }
    }
  }
}

bool RationalBound::Solve(const std::array<double, 3>& g, const std::array<double, 3>& twice,
  const std::array<double, 2>& middle, std::array<double, 3>& bound) const
{
  const double far = 0.5 * (middle[0] + middle[1]);
  const double minimum = 1e-14 * (middle[0] + middle[1]) + 1e-300;
  const std::array<double, 2>& a = this->Slope;
  std::array<double, 3> m{};
  for (int step = 0; step < 60; ++step)
  {
    const double r = far + 0.125 * (m[0] + 2.0 * m[1] + m[2]);
    const double ends[2] = { 0.5 * (m[0] + m[1]), 0.5 * (m[1] + m[2]) };
    const std::array<double, 3> next{ g[0] + twice[0] * r + 2.0 * a[0] * ends[0] + minimum,
      g[1] + twice[1] * r + a[0] * ends[1] + a[1] * ends[0] + minimum,
      g[2] + twice[2] * r + 2.0 * a[1] * ends[1] + minimum };
    if (next[0] <= m[0] && next[1] <= m[1] && next[2] <= m[2])
    {
      bound = m;
      return true;
    }
    for (int k = 0; k < 3; ++k)
    {
      m[k] = 1.02 * next[k];
    }
  }
  return false;
}

bool RationalBound::Run(CurvatureBounds& bound, CurvatureBounds& reached)
{
  Bracket brackets[3] = { Bracket(this->Normal), Bracket(this->Normal), Bracket(this->Normal) };
  this->AddLines(0, brackets[0]);
  this->AddMixed(brackets[1]);
  this->AddLines(1, brackets[2]);
  CurvatureBounds g;
  std::array<double, 3> twice;
  for (int k = 0; k < 3; ++k)
  {
    g.Full[k] = brackets[k].Coefficients.GetLength() / this->Lightest;
    g.Along[k] = brackets[k].Coefficients.GetComponent() / this->Lightest;
    twice[k] = brackets[k].Weight / this->Lightest;
    reached.Full[k] = std::max(reached.Full[k], brackets[k].Corners.GetLength());
    reached.Along[k] = std::max(reached.Along[k], brackets[k].Corners.GetComponent());
  }
  const Vector3(&first)[2] = this->Middle.First;
  return this->Solve(g.Full, twice, { Norm(first[0]), Norm(first[1]) }, bound.Full) &&
    this->Solve(g.Along, twice,
      { std::abs(Dot(first[0], this->Normal)), std::abs(Dot(first[1], this->Normal)) }, bound.Along);
}
}
