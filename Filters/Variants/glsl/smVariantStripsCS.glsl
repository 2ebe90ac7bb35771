// Samples of ribbons (SM_CAPS 0) or caps (1), for one variant each. What they are made of is linear in the
// variables: vectors that the host has for each.
layout(local_size_x = 32) in;
//SM::Define
//SM::Include smInvocation
//SM::Include smPortable
//SM::Include smErrorFree
//SM::Include smVariantStorage
//SM::Include smVariantFlux

// Words of an item: its first number, number of variables, list of directions, number of nodes.
const uint smItemSize = 4u;

#if SM_CAPS
// A triangle: apex, from, to.
const uint smVectorCount = 3u;

void smAddNode(uint at, uint variables, uint list)
{
  double sign = smNumbers[at];
  ++at;
  dvec3 apex = smVectorAt(at);
  dvec3 from = smVectorAt(at + 3u);
  dvec3 to = smVectorAt(at + 6u);
  for (uint a = 1u; a < variables; ++a)
  {
    at += 3u * smVectorCount;
    double c = smVariable(list, a);
    apex += c * smVectorAt(at);
    from += c * smVectorAt(at + 3u);
    to += c * smVectorAt(at + 6u);
  }
  for (uint i = 0u; i < 3u; ++i)
  {
    dvec3 t = smVectorAt(3u * i);
    dvec3 end = t.x * from + t.y * to;
    for (uint k = 0u; k < 3u; ++k)
    {
      dvec3 l = smVectorAt(3u * k);
      smAddSample(sign * t.z * l.z * l.y, l.x * apex + l.y * end, from - apex, to - apex);
    }
  }
}
#else
// Both curves of a ribbon at a node: centre, face and edge relative to it, and both tangents.
const uint smVectorCount = 5u;

void smAddNode(uint at, uint variables, uint list)
{
  double weight = smNumbers[at];
  ++at;
  dvec3 center = smVectorAt(at);
  dvec3 face = smVectorAt(at + 3u);
  dvec3 edge = smVectorAt(at + 6u);
  dvec3 faceTangent = smVectorAt(at + 9u);
  dvec3 edgeTangent = smVectorAt(at + 12u);
  for (uint a = 1u; a < variables; ++a)
  {
    at += 3u * smVectorCount;
    double c = smVariable(list, a);
    center += c * smVectorAt(at);
    face += c * smVectorAt(at + 3u);
    edge += c * smVectorAt(at + 6u);
    faceTangent += c * smVectorAt(at + 9u);
    edgeTangent += c * smVectorAt(at + 12u);
  }
  for (uint k = 0u; k < 3u; ++k)
  {
    dvec3 l = smVectorAt(3u * k);
    smAddSample(weight * l.z, center + (l.x * face + l.y * edge), edge - face,
      l.x * faceTangent + l.y * edgeTangent);
  }
}
#endif

void main()
{
  smVariant = smInvocationIndex();
  if (smVariant >= smVariantCount)
  {
    return;
  }
  for (uint k = 0u; k < smItemCount; ++k)
  {
    uint item = smFirstItem + k * smItemSize;
    uint variables = smWords[item + 1u];
    smBeginSums();
    for (uint node = 0u; node < smWords[item + 3u]; ++node)
    {
      smAddNode(
        smWords[item] + node * (1u + 3u * smVectorCount * variables), variables, smWords[item + 2u]);
    }
    smFlushSums();
  }
}
