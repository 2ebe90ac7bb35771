// Macros by which a chunk of mathematics compiles as GLSL and, through GLM, as C++ (smPortableCxx.h defines
// the same names there). In C++ a chunk is included in the body of a class whose members are what it needs.
#define SM_OUT(type) out type
#define SM_INOUT(type) inout type
#define SM_CONSTANT const
// Both values are evaluated where several items are evaluated side by side, so they must have no side
// effects.
#define SM_SELECT(condition, yes, no) ((condition) ? (yes) : (no))
#define SM_ANY(condition) (condition)

// Arrays of doubles and of dvec4 of one invocation. NVIDIA's compiler keeps an array of doubles as floats
// where an index is not a constant (Documentation/Drivers.md), so that the bits of a double are stored as two
// uints. ShaderSource refuses other arrays.
#define SM_DOUBLES(name, size) uvec2 name[size]
#define SM_OUT_DOUBLES(name, size) out uvec2 name[size]
#define SM_DOUBLE(name, at) packDouble2x32(name[at])
#define SM_SET_DOUBLE(name, at, value) name[at] = smStoreDouble(value)
#define SM_VECTORS(name, size) smStoredVector name[size]
#define SM_IN_VECTORS(name, size) smStoredVector name[size]
#define SM_OUT_VECTORS(name, size) out smStoredVector name[size]
#define SM_VECTOR(name, at) smLoadVector(name[at])
#define SM_SET_VECTOR(name, at, value) name[at] = smStoreVector(value)

struct smStoredVector
{
  uvec4 xy;
  uvec4 zw;
};

uvec2 smStoreDouble(double value)
{
#ifdef SM_FLOAT_ARRAYS
  // Mesa 26 takes double(float(value)) for value.
  uvec2 bits = unpackDouble2x32(value);
  return uvec2(bits.x & 0xe0000000u, bits.y);
#else
  return unpackDouble2x32(value);
#endif
}

// A NaN by its bits: the comparison of a value with itself, and with it isnan(), is lost in the optimization
// of some compilers.
bool smIsNaN(double value)
{
  uvec2 bits = unpackDouble2x32(value);
  uint high = bits.y & 0x7fffffffu;
  return high > 0x7ff00000u || (high == 0x7ff00000u && bits.x != 0u);
}

smStoredVector smStoreVector(dvec4 v)
{
  return smStoredVector(
    uvec4(smStoreDouble(v.x), smStoreDouble(v.y)), uvec4(smStoreDouble(v.z), smStoreDouble(v.w)));
}

dvec4 smLoadVector(smStoredVector stored)
{
  return dvec4(packDouble2x32(stored.xy.xy), packDouble2x32(stored.xy.zw), packDouble2x32(stored.zw.xy),
    packDouble2x32(stored.zw.zw));
}
