// sin, cos, tan, exp, log and pow in double precision, which GLSL does not have. They use series and no
// tables; results are within 2 units in the last place (tan: 3), see TestElementary. Sine, cosine and tangent
// require |x| <= 2^20 and return NaN for larger angles; the others accept all arguments, with infinities,
// zeros and NaN as in C. Needs: chunk smPortable; as C++ smErrorFree.

//SM::Include smErrorFree

double smInfinity()
{
  return packDouble2x32(uvec2(0u, 0x7ff00000u));
}

double smNotANumber()
{
  return packDouble2x32(uvec2(0u, 0x7ff80000u));
}

// Parts of constants, given by their bits: NVIDIA's compiler may be one unit in the last place off in reading
// decimal digits. The products of the first parts with small integers are exact.
double smLogTwoHigh() // 6.93147180369123816490e-01
{
  return packDouble2x32(uvec2(0xfee00000u, 0x3fe62e42u));
}

double smLogTwoLow() // 1.90821492927058770002e-10
{
  return packDouble2x32(uvec2(0x35793c76u, 0x3dea39efu));
}

double smTwoThirdsHigh() // 0.66666666666666662966
{
  return packDouble2x32(uvec2(0x55555555u, 0x3fe55555u));
}

double smTwoThirdsLow() // 3.7007434154171882626e-17
{
  return packDouble2x32(uvec2(0x55555555u, 0x3c855555u));
}

// Parts of pi/2 with 33 bits each, and the rest (Cody and Waite).
dvec4 smHalfPi()
{
  return dvec4(packDouble2x32(uvec2(0x54400000u, 0x3ff921fbu)), // 1.57079632673412561417e+00
    packDouble2x32(uvec2(0x1a600000u, 0x3dd0b461u)), // 6.07710050630396597660e-11
    packDouble2x32(uvec2(0x2e000000u, 0x3ba3198au)), // 2.02226624871116645580e-21
    packDouble2x32(uvec2(0x252049c1u, 0x397b839au))); // 8.47842766036889956997e-32
}

// Returns 2^k for -1022 <= k <= 1023.
double smPowerOfTwo(int k)
{
  return packDouble2x32(uvec2(0u, uint(k + 1023) << 20));
}

// Returns exp(x + low) for |low| below 1e-10.
double smExpOfSum(double x, double low)
{
  if (!(x <= 709.8LF))
  {
    return x > 0.0LF ? smInfinity() : x;
  }
  if (x < -745.2LF)
  {
    return 0.0LF;
  }
  // x = n ln 2 + r, |r| <= ln(2)/2; ln 2 is split so that n times its first part is exact.
  double n = floor(x * 1.4426950408889634074LF + 0.5LF);
  precise double high = x - n * smLogTwoHigh();
  precise double less = n * smLogTwoLow() - low;
  precise double r = high - less;
  precise double rLow = (high - r) - less;
  double tail = 1.0LF / 6227020800.0LF;
  tail = 1.0LF / 479001600.0LF + r * tail;
  tail = 1.0LF / 39916800.0LF + r * tail;
  tail = 1.0LF / 3628800.0LF + r * tail;
  tail = 1.0LF / 362880.0LF + r * tail;
  tail = 1.0LF / 40320.0LF + r * tail;
  tail = 1.0LF / 5040.0LF + r * tail;
  tail = 1.0LF / 720.0LF + r * tail;
  tail = 1.0LF / 120.0LF + r * tail;
  tail = 1.0LF / 24.0LF + r * tail;
  tail = 1.0LF / 6.0LF + r * tail;
  tail = 0.5LF + r * tail;
  precise double sum = 1.0LF + (r + (r * r * tail + (rLow + rLow * r)));
  // The power is applied in two factors, as 2^n may overflow or underflow although the result does not.
  int power = int(n);
  int first = power / 2;
  return (sum * smPowerOfTwo(first)) * smPowerOfTwo(power - first);
}

double smExp(double x)
{
  return smExpOfSum(x, 0.0LF);
}

// Returns log x and the rounding error of it, about 100 bits together, for finite x > 0.
dvec2 smLogParts(double x)
{
  int k = -1023;
  if (x < 2.2250738585072014e-308LF)
  {
    x *= 18014398509481984.0LF;
    k -= 54;
  }
  uvec2 bits = unpackDouble2x32(x);
  k += int(bits.y >> 20);
  double m = packDouble2x32(uvec2(bits.x, (bits.y & 0xfffffu) | 0x3ff00000u));
  if (m > 1.4142135623730951LF)
  {
    m *= 0.5LF;
    ++k;
  }
  // log m = 2 (s + s^3/3 + ...), s = (m - 1) / (m + 1), |s| < 0.172; the first two terms include their
  // rounding errors.
  precise double f = m - 1.0LF;
  precise double g = m + 1.0LF;
  precise double gLow = f - (g - 2.0LF);
  precise double s = f / g;
  precise double back = s * g;
  precise double sLow = (((f - back) - smProductError(s, g, back)) - s * gLow) / g;
  precise double z = s * s;
  precise double zLow = smProductError(s, s, z) + 2.0LF * s * sLow;
  precise double cube = z * s;
  precise double cubeLow = smProductError(z, s, cube) + (z * sLow + zLow * s);
  double twoThirds = smTwoThirdsHigh();
  precise double second = cube * twoThirds;
  precise double secondLow =
    smProductError(cube, twoThirds, second) + (cubeLow * twoThirds + cube * smTwoThirdsLow());
  double tail = 1.0LF / 25.0LF;
  for (int i = 23; i >= 5; i -= 2)
  {
    tail = 1.0LF / double(i) + z * tail;
  }
  tail *= 2.0LF * cube * z;

  precise double whole = double(k) * smLogTwoHigh();
  precise double first = whole + 2.0LF * s;
  precise double firstLow = smSumError(whole, 2.0LF * s, first);
  precise double high = first + second;
  precise double highLow = smSumError(first, second, high);
  precise double low =
    firstLow + highLow + (2.0LF * sLow + secondLow + tail + double(k) * smLogTwoLow());
  precise double result = high + low;
  precise double resultLow = (high - result) + low;
  return dvec2(result, resultLow);
}

double smLog(double x)
{
  if (!(x > 0.0LF))
  {
    return x == 0.0LF ? -smInfinity() : smNotANumber();
  }
  return x < smInfinity() ? smLogParts(x).x : x;
}

// Returns x^y. A negative base requires an integer or infinite exponent, else the result is NaN.
double smPow(double x, double y)
{
  if (y == 0.0LF || x == 1.0LF)
  {
    return 1.0LF;
  }
  if (!(x == x) || !(y == y))
  {
    return smNotANumber();
  }
  bool isWhole = floor(y) == y;
  bool isOdd = isWhole && abs(y) < 9007199254740992.0LF && 2.0LF * floor(0.5LF * y) != y;
  bool isInfinite = abs(y) == smInfinity();
  double sign = isOdd && (unpackDouble2x32(x).y >> 31) != 0u ? -1.0LF : 1.0LF;
  double base = abs(x);
  if (base == 0.0LF || base == smInfinity())
  {
    return sign * ((base == 0.0LF) == (y > 0.0LF) ? 0.0LF : smInfinity());
  }
  if (x < 0.0LF && !isWhole && !isInfinite)
  {
    return smNotANumber();
  }
  if (base == 1.0LF)
  {
    return sign;
  }
  // Larger exponents overflow or underflow just as well, since |log| is at least 2^-53.
  y = clamp(y, -36893488147419103232.0LF, 36893488147419103232.0LF);
  dvec2 logarithm = smLogParts(base);
  precise double product = y * logarithm.x;
  if (abs(product) > 800.0LF)
  {
    return sign * (product > 0.0LF ? smInfinity() : 0.0LF);
  }
  precise double low = smProductError(y, logarithm.x, product) + y * logarithm.y;
  return sign * smExpOfSum(product, low);
}

// Return sine and cosine of r + low, for |r| up to about pi/4.
double smSinNear(double r, double low)
{
  double z = r * r;
  double tail = 1.0LF / 355687428096000.0LF;
  tail = -1.0LF / 1307674368000.0LF + z * tail;
  tail = 1.0LF / 6227020800.0LF + z * tail;
  tail = -1.0LF / 39916800.0LF + z * tail;
  tail = 1.0LF / 362880.0LF + z * tail;
  tail = -1.0LF / 5040.0LF + z * tail;
  tail = 1.0LF / 120.0LF + z * tail;
  tail = -1.0LF / 6.0LF + z * tail;
  precise double sum = r + (z * r * tail + low * (1.0LF - 0.5LF * z));
  return sum;
}

double smCosNear(double r, double low)
{
  double z = r * r;
  double tail = -1.0LF / 6402373705728000.0LF;
  tail = 1.0LF / 20922789888000.0LF + z * tail;
  tail = -1.0LF / 87178291200.0LF + z * tail;
  tail = 1.0LF / 479001600.0LF + z * tail;
  tail = -1.0LF / 3628800.0LF + z * tail;
  tail = 1.0LF / 40320.0LF + z * tail;
  tail = -1.0LF / 720.0LF + z * tail;
  tail = 1.0LF / 24.0LF + z * tail;
  precise double less = 0.5LF * z;
  precise double high = 1.0LF - less;
  precise double sum = high + (((1.0LF - high) - less) + (z * z * tail - r * low));
  return sum;
}

// Reduces x = n pi/2 + r + low. Returns n modulo 4, or -1 if |x| is too large or x is NaN.
int smReduceAngle(double x, SM_OUT(double) r, SM_OUT(double) low)
{
  r = 0.0LF;
  low = 0.0LF;
  if (!(abs(x) <= 1048576.0LF))
  {
    return -1;
  }
  double n = floor(x * 0.63661977236758134308LF + 0.5LF);
  dvec4 halfPi = smHalfPi();
  precise double first = x - n * halfPi.x;
  precise double second = -n * halfPi.y;
  precise double third = -n * halfPi.z;
  precise double sum = first + second;
  precise double sumLow = smSumError(first, second, sum);
  precise double next = sum + third;
  precise double nextLow = smSumError(sum, third, next) + (sumLow - n * halfPi.w);
  precise double result = next + nextLow;
  precise double lack = (next - result) + nextLow;
  r = result;
  low = lack;
  return int(n) & 3;
}

// Returns sin(x + quarters pi/2).
double smSinShifted(double x, int quarters)
{
  double r;
  double low;
  int quarter = smReduceAngle(x, r, low);
  if (quarter < 0)
  {
    return smNotANumber();
  }
  quarter += quarters;
  double value = (quarter & 1) != 0 ? smCosNear(r, low) : smSinNear(r, low);
  return (quarter & 2) != 0 ? -value : value;
}

double smSin(double x)
{
  return smSinShifted(x, 0);
}

double smCos(double x)
{
  return smSinShifted(x, 1);
}

double smTan(double x)
{
  double r;
  double low;
  int quarter = smReduceAngle(x, r, low);
  if (quarter < 0)
  {
    return smNotANumber();
  }
  double sine = smSinNear(r, low);
  double cosine = smCosNear(r, low);
  return (quarter & 1) != 0 ? -cosine / sine : sine / cosine;
}
