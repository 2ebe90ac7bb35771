// Patches, lines and results of gradients in buffers. Needs: smInvocation.
//
// Words: of a patch the degrees in s and r, its first control point, its first number, its first line, the
// number of lines, and its first control point among all patches of the dispatch; of a line its patch, its
// first number, the first number of its rule, the nodes across, and its first row.

layout(std430, binding = 0) readonly buffer smWordBuffer
{
  uint smWords[];
};
// Homogeneous control points relative to the patches' centres, s fastest.
layout(std430, binding = 1) readonly buffer smNetBuffer
{
  dvec4 smNets[];
};
// Of a patch those of smGradientPatch without the degrees; of a line those of smGradientLine, weight, and
// start and width of the range of xi, then the polynomials in r, those of one degree less, and derivatives;
// rules.
layout(std430, binding = 2) readonly buffer smNumberBuffer
{
  double smNumbers[];
};

uniform uint smFirstPatch; // words before the patches, the lines, and the lists of this dispatch
uniform uint smFirstLine;
uniform uint smFirstEntry;
uniform uint smCount; // of invocations

const uint smPatchSize = 7u;
const uint smLineSize = 5u;
const uint smLineNumbers = 8u;
// Fours of the integrals of a control point, and those of a row, which are followed by what meets the
// derivatives in r and by the noise of the area.
const uint smFours = 12u;
const uint smRowFours = 14u;

uint smPatchWord(uint patchIndex, uint word)
{
  return smWords[smFirstPatch + patchIndex * smPatchSize + word];
}

uint smLineWord(uint line, uint word)
{
  return smWords[smFirstLine + line * smLineSize + word];
}

// What a shader stores; tests of what guards against wrong drivers store floats (smShaderFault.h).
dvec4 smStored(dvec4 value)
{
#ifdef SM_FLOAT_ARRAYS
  return dvec4(vec4(value));
#else
  return value;
#endif
}
