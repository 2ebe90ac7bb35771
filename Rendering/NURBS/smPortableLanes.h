/**
 * @file smPortableLanes.h
 * @brief Compiles the chunks of mathematics in glsl/ as C++ that evaluates several items side by side; not
 * installed
 *
 * Like smPortableCxx.h, but the type that the chunks call double is the parameter Number of a class template:
 * sm::Lanes, or double itself. Every lane does the operations of one double in the same order, so that its
 * bits do not depend on the number of lanes. Numbers of loops and conditions of if must be the same for all
 * lanes; where a condition compares Numbers the chunk uses SM_SELECT, or SM_ANY, which holds for all lanes if
 * it does for one. In a class template, put between `#define double Number` and `#undef double`:
 *
 *     using dvec2 = sm::LaneVector2<Number>; (and so dvec3, dvec4), using uvec4 = sm::LaneIndices;
 *     #include "glsl/sm....glsl"
 *
 * A source file that is compiled for a special instruction set must not use inline functions that other files
 * use, too, because the linker keeps one copy of each. Therefore this header has only templates of Number and
 * does not include GLM.
 */
#ifndef smPortableLanes_h
#define smPortableLanes_h

using uint = unsigned int;

// GLSL's suffix of double literals.
#pragma GCC diagnostic ignored "-Wliteral-suffix"
static constexpr double operator"" LF(long double value)
{
  return static_cast<double>(value);
}

// A C++ compiler does not reorder operations without -ffast-math, so GLSL's `precise` has no counterpart.
#define precise

#define SM_OUT(type) type&
#define SM_INOUT(type) type&
#define SM_DOUBLES(name, size) double name[size]
#define SM_OUT_DOUBLES(name, size) double* name
#define SM_DOUBLE(name, at) name[at]
#define SM_SET_DOUBLE(name, at, value) name[at] = value
#define SM_VECTORS(name, size) dvec4 name[size]
#define SM_IN_VECTORS(name, size) const dvec4* name
#define SM_OUT_VECTORS(name, size) dvec4* name
#define SM_VECTOR(name, at) name[at]
#define SM_SET_VECTOR(name, at, value) name[at] = value
#define SM_CONSTANT static constexpr
#define SM_SELECT(condition, yes, no) SelectLanes((condition), Number(yes), Number(no))
#define SM_ANY(condition) IsAnyLane(condition)

#ifdef __FMA__
#define SM_FUSED(a, b, c) MultiplyAdd(a, b, c)
#endif

#define SM_ALWAYS_INLINE inline __attribute__((always_inline))

namespace sm
{
/// An array of Count doubles with elementwise operations.
template <int Count>
struct Lanes
{
  // A typedef is used because an alias would lose the attribute where it depends on Count.
  typedef double Vector __attribute__((vector_size(8 * Count)));
  typedef long long Mask __attribute__((vector_size(8 * Count)));
  Vector All;

  Lanes() = default;
  SM_ALWAYS_INLINE constexpr Lanes(double value)
    : All(value - Vector{})
  {
  }
  explicit SM_ALWAYS_INLINE constexpr Lanes(int value)
    : Lanes(static_cast<double>(value))
  {
  }
  explicit SM_ALWAYS_INLINE constexpr Lanes(uint value)
    : Lanes(static_cast<double>(value))
  {
  }
  explicit SM_ALWAYS_INLINE Lanes(const Vector& all)
    : All(all)
  {
  }

  friend SM_ALWAYS_INLINE Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(a.All + b.All); }
  friend SM_ALWAYS_INLINE Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(a.All - b.All); }
  friend SM_ALWAYS_INLINE Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(a.All * b.All); }
  friend SM_ALWAYS_INLINE Lanes operator/(const Lanes& a, const Lanes& b) { return Lanes(a.All / b.All); }
  SM_ALWAYS_INLINE Lanes operator-() const { return Lanes(-this->All); }
  SM_ALWAYS_INLINE Lanes& operator+=(const Lanes& other) { return *this = *this + other; }
  SM_ALWAYS_INLINE Lanes& operator-=(const Lanes& other) { return *this = *this - other; }
  SM_ALWAYS_INLINE Lanes& operator*=(const Lanes& other) { return *this = *this * other; }

  friend SM_ALWAYS_INLINE Mask operator<(const Lanes& a, const Lanes& b) { return a.All < b.All; }
  friend SM_ALWAYS_INLINE Mask operator>(const Lanes& a, const Lanes& b) { return a.All > b.All; }

  // NaN and the sign of zero are treated as in GLM.
  friend SM_ALWAYS_INLINE Lanes min(const Lanes& a, const Lanes& b)
  {
    return Lanes(b.All < a.All ? b.All : a.All);
  }
  friend SM_ALWAYS_INLINE Lanes max(const Lanes& a, const Lanes& b)
  {
    return Lanes(a.All < b.All ? b.All : a.All);
  }
  friend SM_ALWAYS_INLINE Lanes abs(const Lanes& a) { return Lanes(a.All >= Vector{} ? a.All : -a.All); }
  friend SM_ALWAYS_INLINE Lanes sqrt(const Lanes& a)
  {
    // The compiler makes one instruction of it.
    double each[Count];
    __builtin_memcpy(each, &a.All, sizeof(each));
    for (int i = 0; i < Count; ++i)
    {
      each[i] = __builtin_sqrt(each[i]);
    }
    Lanes root;
    __builtin_memcpy(&root.All, each, sizeof(each));
    return root;
  }
  /// a b + c, rounded once.
  friend SM_ALWAYS_INLINE Lanes MultiplyAdd(const Lanes& a, const Lanes& b, const Lanes& c)
  {
    double each[3][Count];
    __builtin_memcpy(each[0], &a.All, sizeof(each[0]));
    __builtin_memcpy(each[1], &b.All, sizeof(each[1]));
    __builtin_memcpy(each[2], &c.All, sizeof(each[2]));
    for (int i = 0; i < Count; ++i)
    {
      each[0][i] = __builtin_fma(each[0][i], each[1][i], each[2][i]);
    }
    Lanes result;
    __builtin_memcpy(&result.All, each[0], sizeof(each[0]));
    return result;
  }
  friend SM_ALWAYS_INLINE Lanes clamp(const Lanes& a, const Lanes& low, const Lanes& high)
  {
    return min(max(a, low), high);
  }
  friend SM_ALWAYS_INLINE Lanes SelectLanes(const Mask& mask, const Lanes& yes, const Lanes& no)
  {
    return Lanes(mask ? yes.All : no.All);
  }
};

/// True if a comparison holds for a lane.
template <class Mask>
SM_ALWAYS_INLINE bool IsAnyLane(const Mask& mask)
{
  long long each[sizeof(mask) / sizeof(long long)];
  __builtin_memcpy(each, &mask, sizeof(mask));
  long long any = 0;
  for (const long long lane : each)
  {
    any |= lane;
  }
  return any != 0;
}

///@{
/// The same for a single lane.
static SM_ALWAYS_INLINE bool IsAnyLane(bool comparison)
{
  return comparison;
}
static SM_ALWAYS_INLINE double min(double a, double b)
{
  return b < a ? b : a;
}
static SM_ALWAYS_INLINE double max(double a, double b)
{
  return a < b ? b : a;
}
static SM_ALWAYS_INLINE double abs(double a)
{
  return a >= 0.0 ? a : -a;
}
static SM_ALWAYS_INLINE double sqrt(double a)
{
  return __builtin_sqrt(a);
}
static SM_ALWAYS_INLINE double clamp(double a, double low, double high)
{
  return min(max(a, low), high);
}
static SM_ALWAYS_INLINE double SelectLanes(bool condition, double yes, double no)
{
  return condition ? yes : no;
}
///@}

/// GLSL's vectors of two to four Numbers, with the functions that the chunks need of them.
template <class Number>
struct LaneVector2
{
  Number x, y;

  LaneVector2() = default;
  explicit SM_ALWAYS_INLINE LaneVector2(const Number& all)
    : x(all)
    , y(all)
  {
  }
  SM_ALWAYS_INLINE LaneVector2(const Number& first, const Number& second)
    : x(first)
    , y(second)
  {
  }
#define SM_OPERATOR(op)                                                                                      \
  friend SM_ALWAYS_INLINE LaneVector2 operator op(const LaneVector2& a, const LaneVector2& b)                \
  {                                                                                                          \
    return { a.x op b.x, a.y op b.y };                                                                       \
  }                                                                                                          \
  friend SM_ALWAYS_INLINE LaneVector2 operator op(const LaneVector2& a, const Number& b)                     \
  {                                                                                                          \
    return { a.x op b, a.y op b };                                                                           \
  }                                                                                                          \
  friend SM_ALWAYS_INLINE LaneVector2 operator op(const Number& a, const LaneVector2& b)                     \
  {                                                                                                          \
    return { a op b.x, a op b.y };                                                                           \
  }
  SM_OPERATOR(+)
  SM_OPERATOR(-)
  SM_OPERATOR(*)
  SM_OPERATOR(/)
#undef SM_OPERATOR
  SM_ALWAYS_INLINE LaneVector2 operator-() const
  {
    return { -this->x, -this->y };
  }
  SM_ALWAYS_INLINE LaneVector2& operator+=(const LaneVector2& other)
  {
    return *this = *this + other;
  }
  friend SM_ALWAYS_INLINE LaneVector2 abs(const LaneVector2& a)
  {
    return { abs(a.x), abs(a.y) };
  }
  friend SM_ALWAYS_INLINE LaneVector2 max(const LaneVector2& a, const LaneVector2& b)
  {
    return { max(a.x, b.x), max(a.y, b.y) };
  }
};

template <class Number>
struct LaneVector3
{
  Number x, y, z;

  LaneVector3() = default;
  explicit SM_ALWAYS_INLINE LaneVector3(const Number& all)
    : x(all)
    , y(all)
    , z(all)
  {
  }
  SM_ALWAYS_INLINE LaneVector3(const Number& first, const Number& second, const Number& third)
    : x(first)
    , y(second)
    , z(third)
  {
  }
  SM_ALWAYS_INLINE LaneVector3(const LaneVector2<Number>& two, const Number& third)
    : x(two.x)
    , y(two.y)
    , z(third)
  {
  }
  SM_ALWAYS_INLINE Number& operator[](int i) { return i == 0 ? this->x : i == 1 ? this->y : this->z; }
#define SM_OPERATOR(op)                                                                                      \
  friend SM_ALWAYS_INLINE LaneVector3 operator op(const LaneVector3& a, const LaneVector3& b)                \
  {                                                                                                          \
    return { a.x op b.x, a.y op b.y, a.z op b.z };                                                           \
  }
  SM_OPERATOR(+)
  SM_OPERATOR(-)
#undef SM_OPERATOR
  friend SM_ALWAYS_INLINE LaneVector3 operator*(const LaneVector3& a, const Number& b)
  {
    return { a.x * b, a.y * b, a.z * b };
  }
  friend SM_ALWAYS_INLINE LaneVector3 operator*(const Number& a, const LaneVector3& b)
  {
    return { a * b.x, a * b.y, a * b.z };
  }
  SM_ALWAYS_INLINE LaneVector3& operator*=(const Number& other)
  {
    return *this = *this * other;
  }
  friend SM_ALWAYS_INLINE Number dot(const LaneVector3& a, const LaneVector3& b)
  {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }
  friend SM_ALWAYS_INLINE Number length(const LaneVector3& a)
  {
    return sqrt(dot(a, a));
  }
  friend SM_ALWAYS_INLINE LaneVector3 cross(const LaneVector3& a, const LaneVector3& b)
  {
    return { a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y };
  }
};

template <class Number>
struct LaneVector4
{
  Number x, y, z, w;

  LaneVector4() = default;
  explicit SM_ALWAYS_INLINE LaneVector4(const Number& all)
    : x(all)
    , y(all)
    , z(all)
    , w(all)
  {
  }
  SM_ALWAYS_INLINE LaneVector4(
    const Number& first, const Number& second, const Number& third, const Number& fourth)
    : x(first)
    , y(second)
    , z(third)
    , w(fourth)
  {
  }
  friend SM_ALWAYS_INLINE LaneVector4 operator+(const LaneVector4& a, const LaneVector4& b)
  {
    return { a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w };
  }
  friend SM_ALWAYS_INLINE LaneVector4 operator-(const LaneVector4& a, const LaneVector4& b)
  {
    return { a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w };
  }
  friend SM_ALWAYS_INLINE LaneVector4 operator*(const Number& a, const LaneVector4& b)
  {
    return { a * b.x, a * b.y, a * b.z, a * b.w };
  }
  SM_ALWAYS_INLINE LaneVector4& operator+=(const LaneVector4& other) { return *this = *this + other; }
  SM_ALWAYS_INLINE LaneVector4& operator*=(const Number& other)
  {
    return *this = { this->x * other, this->y * other, this->z * other, this->w * other };
  }
};

/// GLSL's uvec4: indices, which all lanes have in common.
struct LaneIndices
{
  uint x, y, z, w;
};
}

#endif
