/**
 * @file smPatchNet.h
 * @brief A homogeneous Bernstein net: derivatives, parts, points
 */
#ifndef smPatchNet_h
#define smPatchNet_h

#include "smPolynomialCurve.h"
#include "smVector.h"

#include <array>
#include <vector>

namespace sm
{
using Homogeneous = std::array<double, 4>;

/// Coefficients of a polynomial on [0,1]^2, u index fastest.
struct PatchNet
{
  int P = 0;
  int Q = 0;
  std::vector<Homogeneous> B;

  const Homogeneous& At(int i, int j) const
  {
    return this->B[i + static_cast<std::size_t>(j) * (this->P + 1)];
  }
  Homogeneous& At(int i, int j) { return this->B[i + static_cast<std::size_t>(j) * (this->P + 1)]; }
  void Resize(int p, int q)
  {
    this->P = p;
    this->Q = q;
    this->B.assign(static_cast<std::size_t>(p + 1) * (q + 1), Homogeneous{});
  }
};

/// The derivative in one direction; a constant 0 for degree 0.
PatchNet Derive(const PatchNet& from, int direction);

/// The same polynomial with one degree more in u until it has degree p, and so in v.
void Elevate(PatchNet& net, int p, int q);

Homogeneous Evaluate(const PatchNet& net, double s, double r);

/// The part on [s0,s1] x [r0,r1] as a net of its own.
PatchNet Restrict(const PatchNet& net, double s0, double s1, double r0, double r1);

inline Vector3 Project(const Homogeneous& h)
{
  return { h[0] / h[3], h[1] / h[3], h[2] / h[3] };
}

/// (H' - S w') / w: the derivative of the quotient.
inline Vector3 ProjectDerivative(const Homogeneous& h, const Vector3& s, double w)
{
  return { (h[0] - s[0] * h[3]) / w, (h[1] - s[1] * h[3]) / w, (h[2] - s[2] * h[3]) / w };
}
}

#endif
