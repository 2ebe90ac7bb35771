// Rounding at reading of a closed solid: control points moved at random, and all outwards, change its
// integrals by no more than ReadingError says, and by not much less.
#include "smReferencePanels.h"
#include "smTesting.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

namespace
{
using namespace smtest;

constexpr int Degree = 2;
constexpr int Points = Degree + 1;
std::array<double, 3> Rounding{ 1e-6, 2e-6, 5e-7 };
using Random = std::mt19937_64;

/// Homogeneous control points of a block of degree 2 in all three directions; its faces are those of the
/// lattice.
struct Block
{
  std::array<double, 4> Lattice[Points][Points][Points];

  std::array<double, 4>& Get(const std::array<int, 3>& i) { return this->Lattice[i[0]][i[1]][i[2]]; }

  template <class Visit>
  void ForEach(const Visit& visit)
  {
    for (int k = 0; k < Points * Points * Points; ++k)
    {
      const std::array<int, 3> index{ k % Points, k / Points % Points, k / (Points * Points) };
      visit(index, this->Get(index));
    }
  }

  sm::Face MakeFace(int direction, int side)
  {
    sm::Face face;
    face.Reversed = side == 0;
    sm::NURBSSurface& surface = face.Surface;
    for (int d = 0; d < 2; ++d)
    {
      surface.Degree[d] = Degree;
      surface.NumberOfControlPoints[d] = Points;
      surface.Knots[d] = { 0, 0, 0, 1, 1, 1 };
    }
    surface.Rational = true;
    surface.Rounding = Rounding;
    for (int k = 0; k < Points * Points; ++k)
    {
      std::array<int, 3> index{};
      index[direction] = side * Degree;
      index[(direction + 1) % 3] = k % Points;
      index[(direction + 2) % 3] = k / Points;
      surface.ControlPoints.push_back(this->Get(index));
    }
    return face;
  }
};

double Draw(Random& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

Block MakeBlock(Random& random, double bend, double weights)
{
  Block block;
  block.ForEach(
    [&](const std::array<int, 3>& i, std::array<double, 4>& h)
    {
      h[3] = std::pow(weights, Draw(random, 0.0, 1.0));
      for (int c = 0; c < 3; ++c)
      {
        h[c] = h[3] * (i[c] + 1 + bend * Draw(random, -0.5, 0.5));
      }
    });
  return block;
}

struct Result
{
  Values Sum{};
  Values Bound{};
};

Result Integrate(Block& block)
{
  Result result;
  sm::PlanRequest request;
  request.Classes = Classes;
  request.Tolerances.assign(Count, 1e-12);
  for (int f = 0; f < 6; ++f)
  {
    const sm::Face face = block.MakeFace(f / 2, f % 2);
    const sm::FacePanels panels = sm::BuildFacePanels(face);
    const sm::FacePlan plan = sm::PlanFace(face, panels, request);
    const ReferencePanels reference(panels);
    Values values{};
    for (const sm::PlannedItem& item : plan.Items)
    {
      const Values part = reference.IntegrateFinely(item);
      std::transform(part.begin(), part.end(), values.begin(), values.begin(), std::plus<>());
    }
    for (int k = 0; k < Count; ++k)
    {
      // The reference does not know which side is outside.
      const bool negative = face.Reversed && Classes[k].Kind != sm::BoundClass::AreaMoment;
      result.Sum[k] += negative ? -values[k] : values[k];
      result.Bound[k] += plan.Reading.GetBound(Classes[k], static_cast<double>(values[Count - 1]), 0.0);
    }
  }
  return result;
}

void CheckBlocks(double bend, double weights, bool outwards, double minimum)
{
  const std::string label = "bend " + std::to_string(bend) + ", weights to " + std::to_string(weights) +
    (outwards ? ", outwards" : ", at random");
  Values largest{};
  for (unsigned int seed = 1; seed <= 10; ++seed)
  {
    Random random(seed);
    Block block = MakeBlock(random, bend, weights);
    const Result before = Integrate(block);
    block.ForEach(
      [&](const std::array<int, 3>& i, std::array<double, 4>& h)
      {
        for (int c = 0; c < 3; ++c)
        {
          h[c] += h[3] * Rounding[c] * (outwards ? i[c] - 1 : Draw(random, -1.0, 1.0));
        }
      });
    const Result after = Integrate(block);
    for (int k = 0; k < Count; ++k)
    {
      largest[k] = std::max(largest[k], std::abs(after.Sum[k] - before.Sum[k]) / before.Bound[k]);
    }
  }
  for (const int k : { 0, 1, 2, 4 })
  {
    std::printf(
      "%s, class %d: largest change/bound %.3g\n", label.c_str(), k, static_cast<double>(largest[k]));
    // Squares of the displacement: 1e-6 of it.
    CheckRange(label + ", class " + std::to_string(k), minimum, static_cast<double>(largest[k]), 1.0 + 1e-5);
  }
}
}

int TestReadingError(int, char*[])
{
  CheckBlocks(0.0, 1.0, true, 0.02);
  CheckBlocks(0.4, 1.0, true, 0.02);
  CheckBlocks(0.4, 4.0, true, 0.01);
  CheckBlocks(0.4, 1.0, false, 1e-3);
  CheckBlocks(0.4, 4.0, false, 1e-3);
  // The squares count, too.
  Rounding = { 10.0, 10.0, 10.0 };
  CheckBlocks(0.0, 1.0, true, 1e-4);
  std::printf("--- nothing was rounded\n");
  const sm::ReadingError none;
  for (const sm::BoundClass& c : Classes)
  {
    CheckEqual("no error", 0.0, none.GetBound(c, 1.0, 1.0));
  }
  return Finish();
}
