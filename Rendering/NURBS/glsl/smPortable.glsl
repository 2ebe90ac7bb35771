// Macros by which a chunk of mathematics compiles as GLSL and, through GLM, as C++ (smPortableCxx.h defines the same
// names there). In C++ a chunk is included in the body of a class whose members are what it needs.
#define SM_OUT(type) out type
#define SM_INOUT(type) inout type
#define SM_OUT_ARRAY(type, name, size) out type name[size]
#define SM_ARRAY(type, name, size) type name[size]
#define SM_CONSTANT const
// Both values are evaluated where several items are evaluated side by side, so they must have no side effects.
#define SM_SELECT(condition, yes, no) ((condition) ? (yes) : (no))
#define SM_ANY(condition) (condition)
