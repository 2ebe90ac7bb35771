/**
 * @file smUnitRoundoff.h
 * @brief The unit roundoff of double precision, which every rounding bound is a multiple of
 */
#ifndef smUnitRoundoff_h
#define smUnitRoundoff_h

namespace sm
{
/// u = 2^-53: one operation, rounded to nearest, errs by at most u times its result.
constexpr double UnitRoundoff = 1.1102230246251565e-16;
}

#endif
