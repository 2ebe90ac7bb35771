// What lets a chunk of mathematics compile as GLSL and, through GLM, as C++ (smPortableCxx.h defines the same
// names there).
#define SM_OUT(type) out type
#define SM_OUT_ARRAY(type, name, size) out type name[size]
#define SM_ARRAY(type, name, size) type name[size]
