#include "smLineIntegrals.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
constexpr int Pairs[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 0, 2 }, { 1, 2 } };
constexpr int PairOf[3][3] = { { 0, 3, 4 }, { 3, 1, 5 }, { 4, 5, 2 } };
}

void LineIntegrals::AddSegment(const Vector3& from, const Vector3& to)
{
  // The integrands are quadratic, and two points of Gauss's rule are exact.
  constexpr double node = 0.211324865405187118;
  Vector3 step = Subtract(to, from);
  Vector3 near;
  Vector3 far;
  for (int c = 0; c < 3; ++c)
  {
    near[c] = from[c] + node * step[c];
    far[c] = to[c] - node * step[c];
    step[c] *= 0.5;
  }
  this->AddSample(near, step);
  this->AddSample(far, step);
}

void LineIntegrals::Add(const LineIntegrals& other, const Vector3& place, double sign)
{
  this->Length += other.Length;
  for (int k = 0; k < 3; ++k)
  {
    const double step = sign * other.Step[k];
    this->Step[k] += step;
    for (int i = 0; i < 3; ++i)
    {
      this->First[i][k] += sign * other.First[i][k] + place[i] * step;
    }
    for (int n = 0; n < 6; ++n)
    {
      const int i = Pairs[n][0];
      const int j = Pairs[n][1];
      this->Second[n][k] +=
        sign * (other.Second[n][k] + place[i] * other.First[j][k] + place[j] * other.First[i][k]) +
        place[i] * place[j] * step;
    }
  }
}

double LineIntegrals::GetDifference(const LineIntegrals& other, double size) const
{
  double largest = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    largest = std::max(largest, std::abs(this->Step[k] - other.Step[k]) / size);
    for (int i = 0; i < 3; ++i)
    {
      largest = std::max(largest, std::abs(this->First[i][k] - other.First[i][k]) / (size * size));
    }
    for (int n = 0; n < 6; ++n)
    {
      largest = std::max(largest, std::abs(this->Second[n][k] - other.Second[n][k]) / (size * size * size));
    }
  }
  return largest;
}

LineIntegrals LineIntegrals::Map(const Matrix3& map) const
{
  LineIntegrals result;
  for (int k = 0; k < 3; ++k)
  {
    for (int c = 0; c < 3; ++c)
    {
      result.Step[k] += map[k][c] * this->Step[c];
      for (int i = 0; i < 3; ++i)
      {
        for (int a = 0; a < 3; ++a)
        {
          result.First[i][k] += map[i][a] * map[k][c] * this->First[a][c];
        }
      }
      for (int n = 0; n < 6; ++n)
      {
        for (int a = 0; a < 3; ++a)
        {
          for (int b = 0; b < 3; ++b)
          {
            result.Second[n][k] +=
              map[Pairs[n][0]][a] * map[Pairs[n][1]][b] * map[k][c] * this->Second[PairOf[a][b]][c];
          }
        }
      }
    }
  }
  const double scale = std::cbrt(std::abs(Dot(map[0], Cross(map[1], map[2]))));
  result.Length = scale * this->Length;
  return result;
}

Vector3 LineIntegrals::GetVectorArea() const
{
  const Matrix3& f = this->First;
  return { 0.5 * (f[1][2] - f[2][1]), 0.5 * (f[2][0] - f[0][2]), 0.5 * (f[0][1] - f[1][0]) };
}

Matrix3 LineIntegrals::GetMoments() const
{
  Matrix3 result;
  for (int i = 0; i < 3; ++i)
  {
    const int k = (i + 1) % 3;
    const int l = (i + 2) % 3;
    for (int j = 0; j < 3; ++j)
    {
      result[i][j] = (this->Second[PairOf[j][k]][l] - this->Second[PairOf[j][l]][k]) / 3.0;
    }
  }
  return result;
}
}
