/**
 * @file smBernsteinNet.h
 * @brief A homogeneous Bernstein net: derivatives, parts, points; not installed
 */
#ifndef smBernsteinNet_h
#define smBernsteinNet_h

#include "smFiltersBezierModule.h"
#include "smPolynomialCurve.h"
#include "smVector.h"

#include <algorithm>
#include <array>
#include <vector>

namespace sm
{
using Homogeneous = std::array<double, 4>;

/// The coefficients of a net; few of them, as most nets have, without an allocation.
class NetPoints
{
public:
  NetPoints() = default;
  NetPoints(const NetPoints& other) { *this = other; }
  NetPoints& operator=(const NetPoints& other)
  {
    if (this != &other)
    {
      this->Count = other.Count;
      this->Many = other.Many;
      std::copy(other.Few, other.Few + (other.Many.empty() ? other.Count : 0), this->Few);
    }
    return *this;
  }
  /// So many zeros.
  void Assign(std::size_t count)
  {
    this->Count = count;
    this->Many.assign(count > Capacity ? count : 0, Homogeneous{});
    std::fill_n(this->Few, std::min(count, Capacity), Homogeneous{});
  }
  std::size_t size() const { return this->Count; }
  Homogeneous* data() { return this->Many.empty() ? this->Few : this->Many.data(); }
  const Homogeneous* data() const { return this->Many.empty() ? this->Few : this->Many.data(); }
  Homogeneous* begin() { return this->data(); }
  Homogeneous* end() { return this->data() + this->Count; }
  const Homogeneous* begin() const { return this->data(); }
  const Homogeneous* end() const { return this->data() + this->Count; }
  Homogeneous& operator[](std::size_t i) { return this->data()[i]; }
  const Homogeneous& operator[](std::size_t i) const { return this->data()[i]; }

private:
  static constexpr std::size_t Capacity = 16;
  std::size_t Count = 0;
  Homogeneous Few[Capacity];
  std::vector<Homogeneous> Many;
};

/// Coefficients of a polynomial on [0,1]^2, u index fastest.
struct BernsteinNet
{
  int P = 0;
  int Q = 0;
  NetPoints B;

  const Homogeneous& At(int i, int j) const
  {
    return this->B[i + static_cast<std::size_t>(j) * (this->P + 1)];
  }
  Homogeneous& At(int i, int j) { return this->B[i + static_cast<std::size_t>(j) * (this->P + 1)]; }
  void Resize(int p, int q)
  {
    this->P = p;
    this->Q = q;
    this->B.Assign(static_cast<std::size_t>(p + 1) * (q + 1));
  }
};

/// The derivative in one direction; a constant 0 for degree 0.
SMFILTERSBEZIER_EXPORT BernsteinNet Derive(const BernsteinNet& from, int direction);

/// `net` becomes its first half in a direction, `rest` the second.
SMFILTERSBEZIER_EXPORT void SplitInMiddle(BernsteinNet& net, int direction, BernsteinNet& rest);

/// The part on [s0,s1] x [r0,r1] as a net of its own.
SMFILTERSBEZIER_EXPORT BernsteinNet Restrict(
  const BernsteinNet& net, double s0, double s1, double r0, double r1);

inline Vector3 Project(const Homogeneous& h)
{
  return { h[0] / h[3], h[1] / h[3], h[2] / h[3] };
}

/// Position and first derivatives in the middle, by the net's own parameters.
struct NetMiddle
{
  Vector3 Position;
  Vector3 First[2];
};
SMFILTERSBEZIER_EXPORT NetMiddle EvaluateMiddle(const BernsteinNet& net);

/// (H' - S w') / w: the derivative of the quotient.
inline Vector3 ProjectDerivative(const Homogeneous& h, const Vector3& s, double w)
{
  return { (h[0] - s[0] * h[3]) / w, (h[1] - s[1] * h[3]) / w, (h[2] - s[2] * h[3]) / w };
}
}

#endif
