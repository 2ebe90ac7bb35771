#include "smWindingTree.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace sm
{
double EstimateDeviation(const std::array<Vector3, 3>& corners, const std::array<Vector3, 3>& normals)
{
  // A surface that is inclined by the angle a against a chord of length h at the chord's ends deviates from
  // it by about h a / 4 at most; twice this distance is assumed.
  const Vector3 own = Cross(Subtract(corners[1], corners[0]), Subtract(corners[2], corners[0]));
  const double area = Norm(own);
  double longest = 0.0;
  double sine = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    longest = std::max(longest, Norm(Subtract(corners[(i + 1) % 3], corners[i])));
    sine = std::max(sine, area > 0.0 ? Norm(Cross(own, normals[i])) / area : 1.0);
  }
  return 0.5 * longest * std::min(sine, 1.0);
}

bool IsClosed(const std::vector<MeshTriangle>& triangles)
{
  // The sum of a hash of every side, negative in one of both directions, modulo 2^64.
  const auto mix = [](std::uint64_t x)
  {
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
  };
  const auto getHash = [&mix](const Vector3& p)
  {
    std::uint64_t hash = 0;
    for (const double x : p)
    {
      // -0 and 0 are one number.
      const double value = x + 0.0;
      std::uint64_t bits;
      std::memcpy(&bits, &value, sizeof(bits));
      hash = mix(hash + bits + 0x9E3779B97F4A7C15u);
    }
    return hash;
  };
  std::uint64_t sum = 0;
  for (const MeshTriangle& triangle : triangles)
  {
    std::uint64_t hashes[3];
    for (int k = 0; k < 3; ++k)
    {
      hashes[k] = getHash(triangle.Corners[k]);
    }
    for (int k = 0; k < 3; ++k)
    {
      const std::uint64_t from = hashes[k];
      const std::uint64_t to = hashes[(k + 1) % 3];
      const std::uint64_t side = mix(std::min(from, to) ^ mix(std::max(from, to)));
      sum += from < to ? side : from > to ? std::uint64_t{ 0 } - side : 0;
    }
  }
  return sum == 0;
}
}
