/**
 * @file smHostileRandom.h
 * @brief Random numbers that are the same on every platform: a seed reproduces its solid
 */
#ifndef smHostileRandom_h
#define smHostileRandom_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <random>

namespace smhostile
{
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : Engine(seed * 0x9e3779b97f4a7c15ULL + 0x2545f4914f6cdd1dULL)
  {
  }
  /// A random number in [0,1), a multiple of 2^-53. The standard's distributions differ between libraries;
  /// this does not.
  double Uniform() { return std::ldexp(static_cast<double>(this->Engine() >> 11), -53); }
  double Uniform(double low, double high) { return low + (high - low) * this->Uniform(); }
  double LogUniform(double low, double high)
  {
    return std::exp(this->Uniform(std::log(low), std::log(high)));
  }
  /// A random integer from `low` to `high`, both included.
  int Integer(int low, int high) { return low + static_cast<int>(this->Uniform() * (high - low + 1)); }
  bool Chance(double probability) { return this->Uniform() < probability; }
  double Sign() { return this->Chance(0.5) ? 1.0 : -1.0; }

private:
  std::mt19937_64 Engine;
};

/// A random rotation, by a quaternion; the rows of its matrix.
inline std::array<double, 9> MakeRotation(Random& random)
{
  double q[4];
  double norm = 0.0;
  for (double& x : q)
  {
    x = random.Uniform(-1.0, 1.0);
    norm += x * x;
  }
  norm = std::sqrt(norm);
  std::for_each(std::begin(q), std::end(q), [norm](double& x) { x /= norm; });
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  return { 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), 2 * (x * y + w * z),
    1 - 2 * (x * x + z * z), 2 * (y * z - w * x), 2 * (x * z - w * y), 2 * (y * z + w * x),
    1 - 2 * (x * x + y * y) };
}
}

#endif
