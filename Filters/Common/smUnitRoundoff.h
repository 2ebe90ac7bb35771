/**
 * @file smUnitRoundoff.h
 * @brief The unit roundoffs of double and of extended precision, which rounding bounds are multiples of
 */
#ifndef smUnitRoundoff_h
#define smUnitRoundoff_h

#include <limits>

namespace sm
{
/// u = 2^-53: one operation, rounded to nearest, errs by at most u times its result.
constexpr double UnitRoundoff = 1.1102230246251565e-16;
/// The same of long double, which may be no wider than double.
constexpr auto WideRoundoff = static_cast<double>(0.5L * std::numeric_limits<long double>::epsilon());
}

#endif
