// Data of variants in buffers: one invocation has one variant. Needs: smInvocation, smErrorFree, smPortable.

// Descriptions of the items.
layout(std430, binding = 0) readonly buffer smWordBuffer
{
  uint smWords[];
};
// Frozen numbers of the items. The first nine are the rule of three points across ribbons and caps: 1 - l, l,
// weight.
layout(std430, binding = 1) readonly buffer smNumberBuffer
{
  double smNumbers[];
};
// [direction][variant]
layout(std430, binding = 2) readonly buffer smVariableBuffer
{
  double smVariables[];
};

uniform uint smVariantCount; // also the distance of the rows of buffers
uniform uint smFirstItem;    // of this dispatch
uniform uint smItemCount;

uint smVariant;

// Variable a of an item, whose list of directions begins at a word; a > 0, as variable 0 is 1.
double smVariable(uint list, uint a)
{
  return smVariables[smWords[list + a - 1u] * smVariantCount + smVariant];
}

dvec3 smVectorAt(uint at)
{
  return dvec3(smNumbers[at], smNumbers[at + 1u], smNumbers[at + 2u]);
}
