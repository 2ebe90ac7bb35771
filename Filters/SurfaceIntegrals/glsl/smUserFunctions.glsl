// Functions and divisors of a user's expression that are not defined for every argument. What GLSL leaves
// undefined may be any number: llvmpipe's compiler makes 0 of a division by a constant 0, and max() drops a
// NaN. So the argument decides, and the whole expression is NaN at that point. Needs: chunk smPortable.

//SM::Include smElementary

// False after an operation of the expression was undefined; set to true before every evaluation.
bool smIsDefined = true;

void smRequire(bool condition)
{
  smIsDefined = smIsDefined && condition;
}

#define SM_SCALAR_DIVISOR(type) \
  type smDivisor(type x) \
  { \
    smRequire(x != type(0)); \
    return x; \
  }
#define SM_VECTOR_DIVISOR(type) \
  type smDivisor(type x) \
  { \
    smRequire(!any(equal(x, type(0)))); \
    return x; \
  }
SM_SCALAR_DIVISOR(double)
SM_SCALAR_DIVISOR(int)
SM_SCALAR_DIVISOR(uint)
SM_VECTOR_DIVISOR(dvec2)
SM_VECTOR_DIVISOR(dvec3)
SM_VECTOR_DIVISOR(dvec4)
SM_VECTOR_DIVISOR(ivec2)
SM_VECTOR_DIVISOR(ivec3)
SM_VECTOR_DIVISOR(ivec4)
SM_VECTOR_DIVISOR(uvec2)
SM_VECTOR_DIVISOR(uvec3)
SM_VECTOR_DIVISOR(uvec4)

double smUserSqrt(double x)
{
  smRequire(x >= 0.0LF);
  return sqrt(x);
}

double smUserInverseSqrt(double x)
{
  smRequire(x > 0.0LF);
  return inversesqrt(x);
}

double smUserMod(double x, double y)
{
  return mod(x, smDivisor(y));
}

#define SM_VECTOR_FUNCTIONS(type) \
  type smUserSqrt(type x) \
  { \
    smRequire(all(greaterThanEqual(x, type(0)))); \
    return sqrt(x); \
  } \
  type smUserInverseSqrt(type x) \
  { \
    smRequire(all(greaterThan(x, type(0)))); \
    return inversesqrt(x); \
  } \
  type smUserMod(type x, type y) \
  { \
    return mod(x, smDivisor(y)); \
  } \
  type smUserMod(type x, double y) \
  { \
    return mod(x, smDivisor(y)); \
  } \
  type smUserNormalize(type x) \
  { \
    smRequire(dot(x, x) > double(0)); \
    return normalize(x); \
  }
SM_VECTOR_FUNCTIONS(dvec2)
SM_VECTOR_FUNCTIONS(dvec3)
SM_VECTOR_FUNCTIONS(dvec4)

double smUserNormalize(double x)
{
  smRequire(x != 0.0LF);
  return normalize(x);
}

double smUserSin(double x)
{
  smRequire(abs(x) <= 1048576.0LF);
  return smSin(x);
}

double smUserCos(double x)
{
  smRequire(abs(x) <= 1048576.0LF);
  return smCos(x);
}

double smUserTan(double x)
{
  smRequire(abs(x) <= 1048576.0LF);
  return smTan(x);
}

double smUserLog(double x)
{
  smRequire(x > 0.0LF);
  return smLog(x);
}

double smUserPow(double x, double y)
{
  smRequire(x > 0.0LF || (x == 0.0LF ? y >= 0.0LF : x < 0.0LF && floor(y) == y));
  return smPow(x, y);
}
