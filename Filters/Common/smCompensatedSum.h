/**
 * @file smCompensatedSum.h
 * @brief A sum whose rounding errors are added up separately
 */
#ifndef smCompensatedSum_h
#define smCompensatedSum_h

#include <cmath>

namespace sm
{
/// Neumaier's compensated sum. Its error is one rounding of the result, plus a second-order term of the sum
/// of absolute values, so that terms of both signs may cancel. An infinite or NaN term makes the result NaN.
struct CompensatedSum
{
  double Sum = 0.0;
  double Carry = 0.0;
  void Add(double x)
  {
    const double t = this->Sum + x;
    this->Carry += std::abs(this->Sum) >= std::abs(x) ? (this->Sum - t) + x : (x - t) + this->Sum;
    this->Sum = t;
  }
  double Get() const { return this->Sum + this->Carry; }
};
}

#endif
