#include "Detail/smVariantSums.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
constexpr int MaxSamplesOfSum = 64;
}

VariantTotals::VariantTotals(const VariantMonomials& monomials)
{
  for (int m = 0; m < NumberOfMoments; ++m)
  {
    this->Sums[m].assign(monomials.GetCount(GetMomentDegree(m)), 0.0);
    this->Carries[m] = this->Sums[m];
  }
}

VariantMap::VariantMap(
  const VariantMonomials& face, const std::vector<int>& directions, const VariantMonomials& body)
{
  for (int degree = 3; degree <= MaximumFormDegree; ++degree)
  {
    std::vector<std::size_t>& indices = this->Indices[degree - 3];
    for (std::size_t m = 0; m < face.GetCount(degree); ++m)
    {
      const std::array<int, MaximumFormDegree> factors = face.GetFactors(degree, m);
      std::size_t index = 0;
      for (int i = 0; i < degree; ++i)
      {
        const int variable = factors[i] == 0 ? 0 : directions[factors[i] - 1] + 1;
        index += body.GetCount(i + 1, variable);
      }
      indices.push_back(index);
    }
  }
}

VariantSums::VariantSums(const VariantMonomials& monomials, const VariantMap& map, VariantTotals& totals)
  : Monomials(monomials)
  , Map(map)
  , Totals(totals)
{
  const std::size_t quartics = monomials.GetCount(4);
  this->Normal.fill(std::vector<double>(monomials.GetCount(2)));
  this->Cubic.resize(monomials.GetCount(3));
  this->Quartic.fill(std::vector<double>(quartics));
  this->Volume.assign(monomials.GetCount(3), 0.0);
  this->First.fill(std::vector<double>(quartics, 0.0));
  this->Second.fill(std::vector<double>(quartics * monomials.GetVariables(), 0.0));
}

void VariantSums::Add(const VariantSample& sample)
{
  const int variables = this->Monomials.GetVariables();
  const auto multiply = [&](
                          const std::vector<double>& form, int degree, const double* linear, double* product)
  {
    const double* from = form.data();
    for (std::size_t m = 0; m < form.size(); ++m)
    {
      const double factor = from[m];
      for (int a = 0; a < variables; ++a)
      {
        product[this->Monomials.Multiply(degree, m, a)] += factor * linear[a];
      }
    }
  };
  std::fill(this->Cubic.begin(), this->Cubic.end(), 0.0);
  for (int i = 0; i < 3; ++i)
  {
    const double* s[2] = { sample.First.data() + (i + 1) % 3 * variables,
      sample.First.data() + (i + 2) % 3 * variables };
    const double* r[2] = { sample.Second.data() + (i + 1) % 3 * variables,
      sample.Second.data() + (i + 2) % 3 * variables };
    std::vector<double>& normal = this->Normal[i];
    std::fill(normal.begin(), normal.end(), 0.0);
    for (int a = 0; a < variables; ++a)
    {
      for (int b = 0; b < variables; ++b)
      {
        normal[this->Monomials.Multiply(1, a, b)] += s[0][a] * r[1][b] - s[1][a] * r[0][b];
      }
    }
    multiply(
      normal, 2, sample.Position.data() + static_cast<std::ptrdiff_t>(i) * variables, this->Cubic.data());
  }
  for (double& value : this->Cubic)
  {
    value *= sample.Weight;
  }
  for (std::size_t m = 0; m < this->Cubic.size(); ++m)
  {
    this->Volume[m] += this->Cubic[m];
  }
  const std::size_t quartics = this->Monomials.GetCount(4);
  for (int i = 0; i < 3; ++i)
  {
    std::fill(this->Quartic[i].begin(), this->Quartic[i].end(), 0.0);
    multiply(this->Cubic, 3, sample.Position.data() + static_cast<std::ptrdiff_t>(i) * variables,
      this->Quartic[i].data());
    for (std::size_t m = 0; m < quartics; ++m)
    {
      this->First[i][m] += this->Quartic[i][m];
    }
  }
  for (int s = 0; s < 6; ++s)
  {
    const double* quartic = this->Quartic[SecondMomentAxes[s][0]].data();
    const double* position =
      sample.Position.data() + static_cast<std::ptrdiff_t>(SecondMomentAxes[s][1]) * variables;
    for (int a = 0; a < variables; ++a)
    {
      double* to = this->Second[s].data() + a * quartics;
      const double x = position[a];
      for (std::size_t m = 0; m < quartics; ++m)
      {
        to[m] += quartic[m] * x;
      }
    }
  }
  if (++this->Count == MaxSamplesOfSum)
  {
    this->Flush();
  }
}

void VariantSums::Flush()
{
  this->Count = 0;
  const int variables = this->Monomials.GetVariables();
  for (std::size_t m = 0; m < this->Volume.size(); ++m)
  {
    this->Totals.Add(0, this->Map.Get(3, m), this->Volume[m] / 3.0);
    this->Volume[m] = 0.0;
  }
  const std::size_t quartics = this->Monomials.GetCount(4);
  for (int i = 0; i < 3; ++i)
  {
    for (std::size_t m = 0; m < quartics; ++m)
    {
      this->Totals.Add(1 + i, this->Map.Get(4, m), 0.25 * this->First[i][m]);
      this->First[i][m] = 0.0;
    }
  }
  for (int s = 0; s < 6; ++s)
  {
    for (int a = 0; a < variables; ++a)
    {
      double* from = this->Second[s].data() + a * quartics;
      for (std::size_t m = 0; m < quartics; ++m)
      {
        this->Totals.Add(4 + s, this->Map.Get(5, this->Monomials.Multiply(4, m, a)), 0.2 * from[m]);
        from[m] = 0.0;
      }
    }
  }
}
}
