#include "smRationalBlock.h"

#include "smGaussRule.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace smtest
{
namespace
{
/// Values and slopes of the Bernstein polynomials of one degree at one parameter.
struct Basis
{
  std::vector<Real> Value;
  std::vector<Real> Slope;
};

Basis EvaluateBasis(int degree, Real x)
{
  std::vector<Real> lower{ 1 };
  std::vector<Real> value{ 1 };
  for (int n = 1; n <= degree; ++n)
  {
    lower = value;
    value.assign(n + 1, 0);
    for (int i = 0; i < n; ++i)
    {
      value[i] += (1 - x) * lower[i];
      value[i + 1] += x * lower[i];
    }
  }
  Basis basis{ value, std::vector<Real>(degree + 1, 0) };
  for (int i = 0; i < degree; ++i)
  {
    basis.Slope[i] -= degree * lower[i];
    basis.Slope[i + 1] += degree * lower[i];
  }
  return basis;
}

struct Sample
{
  Vector Position;
  /// By u, v and w.
  Matrix Derivative;
};

Sample Evaluate(const RationalBlock& block, const Basis& u, const Basis& v, const Basis& w)
{
  Real h[4][4] = {};
  for (int k = 0; k <= block.Degree[2]; ++k)
  {
    for (int j = 0; j <= block.Degree[1]; ++j)
    {
      for (int i = 0; i <= block.Degree[0]; ++i)
      {
        const std::size_t index = block.GetIndex(i, j, k);
        const Real weight = block.IsRational() ? block.Weights[index] : 1;
        const Real factor[4] = { u.Value[i] * v.Value[j] * w.Value[k], u.Slope[i] * v.Value[j] * w.Value[k],
          u.Value[i] * v.Slope[j] * w.Value[k], u.Value[i] * v.Value[j] * w.Slope[k] };
        for (int d = 0; d < 4; ++d)
        {
          for (int c = 0; c < 3; ++c)
          {
            h[d][c] += factor[d] * weight * block.Poles[index][c];
          }
          h[d][3] += factor[d] * weight;
        }
      }
    }
  }
  Sample sample;
  for (int c = 0; c < 3; ++c)
  {
    sample.Position[c] = h[0][c] / h[0][3];
    for (int d = 0; d < 3; ++d)
    {
      sample.Derivative[d][c] = (h[d + 1][c] - sample.Position[c] * h[d + 1][3]) / h[0][3];
    }
  }
  return sample;
}

Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

Real Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Real GetJacobian(const Sample& s)
{
  return Dot(s.Derivative[0], Cross(s.Derivative[1], s.Derivative[2]));
}

std::vector<Basis> EvaluateAt(int degree, const std::vector<Real>& nodes)
{
  std::vector<Basis> basis;
  for (const Real x : nodes)
  {
    basis.push_back(EvaluateBasis(degree, x));
  }
  return basis;
}

/// Directions in which the weights change: there the integrands are rational.
std::array<bool, 3> FindRationalDirections(const RationalBlock& block)
{
  std::array<bool, 3> rational{};
  for (int k = 0; k <= block.Degree[2] && block.IsRational(); ++k)
  {
    for (int j = 0; j <= block.Degree[1]; ++j)
    {
      for (int i = 0; i <= block.Degree[0]; ++i)
      {
        const double weight = block.Weights[block.GetIndex(i, j, k)];
        rational[0] = rational[0] || weight != block.Weights[block.GetIndex(0, j, k)];
        rational[1] = rational[1] || weight != block.Weights[block.GetIndex(i, 0, k)];
        rational[2] = rational[2] || weight != block.Weights[block.GetIndex(i, j, 0)];
      }
    }
  }
  return rational;
}

/// `extra` raises the order in the rational directions.
ExactMoments IntegrateVolume(const RationalBlock& block, int extra)
{
  const std::array<bool, 3> rational = FindRationalDirections(block);
  GaussRule rule[3];
  std::vector<Basis> basis[3];
  for (int d = 0; d < 3; ++d)
  {
    // x_i x_j times the Jacobian is a polynomial of degree 5 p - 1 in each parameter.
    rule[d] = MakeGaussRule(rational[d] ? 56 + extra : (5 * block.Degree[d] + 1) / 2);
    basis[d] = EvaluateAt(block.Degree[d], rule[d].Nodes);
  }
  const int sign = GetHandedness(block);
  Real volume = 0;
  Vector first{};
  Matrix second{};
  for (std::size_t k = 0; k < basis[2].size(); ++k)
  {
    for (std::size_t j = 0; j < basis[1].size(); ++j)
    {
      for (std::size_t i = 0; i < basis[0].size(); ++i)
      {
        const Sample s = Evaluate(block, basis[0][i], basis[1][j], basis[2][k]);
        const Real jacobian = sign * GetJacobian(s);
        if (!(jacobian > 0))
        {
          throw std::runtime_error("a rational block folds over itself");
        }
        const Real f = jacobian * rule[0].Weights[i] * rule[1].Weights[j] * rule[2].Weights[k];
        volume += f;
        for (int a = 0; a < 3; ++a)
        {
          first[a] += f * s.Position[a];
          for (int b = 0; b < 3; ++b)
          {
            second[a][b] += f * s.Position[a] * s.Position[b];
          }
        }
      }
    }
  }
  return FromOrigin(volume, 0, first, second);
}

/// Area of the face `axis` = side, cut into pieces x pieces.
Real IntegrateFace(const RationalBlock& block, int axis, int side, int pieces)
{
  static const GaussRule rule = MakeGaussRule(30);
  const int a = (axis + 1) % 3;
  const int b = (axis + 2) % 3;
  std::vector<Real> nodes;
  for (int piece = 0; piece < pieces; ++piece)
  {
    for (const Real x : rule.Nodes)
    {
      nodes.push_back((piece + x) / pieces);
    }
  }
  const std::vector<Basis> alongA = EvaluateAt(block.Degree[a], nodes);
  const std::vector<Basis> alongB = EvaluateAt(block.Degree[b], nodes);
  const Basis fixed = EvaluateBasis(block.Degree[axis], side);
  Real area = 0;
  for (std::size_t j = 0; j < nodes.size(); ++j)
  {
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      const Basis* basis[3];
      basis[axis] = &fixed;
      basis[a] = &alongA[i];
      basis[b] = &alongB[j];
      const Sample s = Evaluate(block, *basis[0], *basis[1], *basis[2]);
      const Vector n = Cross(s.Derivative[a], s.Derivative[b]);
      const std::size_t count = rule.Nodes.size();
      area += rule.Weights[i % count] * rule.Weights[j % count] * std::sqrt(Dot(n, n));
    }
  }
  return area / (static_cast<Real>(pieces) * pieces);
}

Real IntegrateFaceToConvergence(const RationalBlock& block, int axis, int side)
{
  Real coarse = IntegrateFace(block, axis, side, 1);
  for (int pieces = 2; pieces <= 16; pieces *= 2)
  {
    const Real fine = IntegrateFace(block, axis, side, pieces);
    if (std::fabs(fine - coarse) <= 1e-16L * fine)
    {
      return fine;
    }
    coarse = fine;
  }
  throw std::runtime_error("the area of a block's face does not converge");
}
}

std::size_t RationalBlock::GetIndex(int i, int j, int k) const
{
  return i + (this->Degree[0] + 1) * (j + static_cast<std::size_t>(this->Degree[1] + 1) * k);
}

RationalBlock MakeBlock(const std::array<int, 3>& degree, const LatticeFunction& position)
{
  RationalBlock block;
  block.Degree = degree;
  for (int k = 0; k <= degree[2]; ++k)
  {
    for (int j = 0; j <= degree[1]; ++j)
    {
      for (int i = 0; i <= degree[0]; ++i)
      {
        block.Poles.push_back(position(static_cast<double>(i) / degree[0], static_cast<double>(j) / degree[1],
          static_cast<double>(k) / degree[2]));
      }
    }
  }
  return block;
}

RationalBlock Reparametrized(const RationalBlock& block, const std::array<double, 3>& factor)
{
  // u -> f u / (1 - u + f u) turns B_i(u) into f^i B_i(u) over a common denominator.
  RationalBlock result = block;
  result.Weights.assign(block.Poles.size(), 1.0);
  for (int k = 0; k <= block.Degree[2]; ++k)
  {
    for (int j = 0; j <= block.Degree[1]; ++j)
    {
      for (int i = 0; i <= block.Degree[0]; ++i)
      {
        const std::size_t index = block.GetIndex(i, j, k);
        result.Weights[index] = (block.IsRational() ? block.Weights[index] : 1.0) * std::pow(factor[0], i) *
          std::pow(factor[1], j) * std::pow(factor[2], k);
      }
    }
  }
  return result;
}

ExactMoments IntegrateBlock(const RationalBlock& block)
{
  ExactMoments moments = IntegrateVolume(block, 0);
  const ExactMoments finer = IntegrateVolume(block, 16);
  const Real trace = moments.Central[0][0] + moments.Central[1][1] + moments.Central[2][2];
  Real error = std::fabs(finer.Volume / moments.Volume - 1);
  for (int i = 0; i < 3; ++i)
  {
    error = std::max(error, std::fabs(finer.Central[i][i] - moments.Central[i][i]) / trace);
  }
  if (!(error <= 1e-16L))
  {
    throw std::runtime_error("the moments of a block do not converge");
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    moments.Area += IntegrateFaceToConvergence(block, axis, 0) + IntegrateFaceToConvergence(block, axis, 1);
  }
  return moments;
}

int GetHandedness(const RationalBlock& block)
{
  const Sample middle = Evaluate(block, EvaluateBasis(block.Degree[0], 0.5L),
    EvaluateBasis(block.Degree[1], 0.5L), EvaluateBasis(block.Degree[2], 0.5L));
  return GetJacobian(middle) > 0 ? 1 : -1;
}
}
