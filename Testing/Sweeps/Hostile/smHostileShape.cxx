#include "smHostileBlock.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace smhostile
{
Point3 Rail::Evaluate(Real t) const
{
  const int count = static_cast<int>(this->Pieces.size());
  const int piece = std::clamp(static_cast<int>(std::floor(t * count)), 0, count - 1);
  const std::vector<RealPoint>& points = this->Pieces[piece];
  std::vector<Real> values, derivatives;
  EvaluateBernstein(static_cast<int>(points.size()) - 1, t * count - piece, values, derivatives);
  RealPoint h{};
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (int c = 0; c < 4; ++c)
    {
      h[c] += values[i] * points[i][c];
    }
  }
  return { static_cast<double>(h[0] / h[3]), static_cast<double>(h[1] / h[3]),
    static_cast<double>(h[2] / h[3]) };
}

double Quantize(double x, double size, int bits)
{
  const double quantum = std::ldexp(1.0, std::ilogb(size) + 1 - bits);
  return quantum * std::nearbyint(x / quantum);
}

Sheet Transpose(const Sheet& sheet)
{
  Sheet other = sheet;
  other.Surface = sheet.Surface.Transposed();
  other.Reversed = !sheet.Reversed;
  other.Sides[BOTTOM] = sheet.Sides[LEFT];
  other.Sides[LEFT] = sheet.Sides[BOTTOM];
  other.Sides[TOP] = sheet.Sides[RIGHT];
  other.Sides[RIGHT] = sheet.Sides[TOP];
  std::swap(other.Low[0], other.Low[1]);
  std::swap(other.Width[0], other.Width[1]);
  return other;
}

Shape MakeShape(Random& random)
{
  Shape shape;
  shape.FormulaVolume = std::numeric_limits<Real>::quiet_NaN();
  shape.Size = random.LogUniform(1e-3, 1e5);
  const double family = random.Uniform();
  if (family < 0.5)
  {
    MakePolynomialBlock(random, shape);
  }
  else if (family < 0.7)
  {
    MakeRationalBlock(random, shape);
  }
  else if (family < 0.78)
  {
    MakeBallOctant(random, shape);
  }
  else
  {
    MakeRevolved(random, shape);
  }
  for (Sheet& sheet : shape.Sheets)
  {
    for (int d = 0; d < 2; ++d)
    {
      if (random.Chance(0.4))
      {
        InsertKnots(sheet, d, random);
      }
    }
    MoveDomain(sheet, random);
    if (random.Chance(0.5))
    {
      sheet = Transpose(sheet);
    }
  }
  return shape;
}
}
