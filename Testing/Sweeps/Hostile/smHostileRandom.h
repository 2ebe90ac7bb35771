/**
 * @file smHostileRandom.h
 * @brief Random numbers that are the same on every platform: a seed reproduces its solid
 */
#ifndef smHostileRandom_h
#define smHostileRandom_h

#include <cmath>
#include <cstdint>
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
  /// In [0,1), a multiple of 2^-53. The standard's distributions differ between libraries; this does not.
  double Uniform() { return std::ldexp(static_cast<double>(this->Engine() >> 11), -53); }
  double Uniform(double low, double high) { return low + (high - low) * this->Uniform(); }
  double LogUniform(double low, double high)
  {
    return std::exp(this->Uniform(std::log(low), std::log(high)));
  }
  /// Both ends included.
  int Integer(int low, int high) { return low + static_cast<int>(this->Uniform() * (high - low + 1)); }
  bool Chance(double probability) { return this->Uniform() < probability; }
  double Sign() { return this->Chance(0.5) ? 1.0 : -1.0; }

private:
  std::mt19937_64 Engine;
};
}

#endif
