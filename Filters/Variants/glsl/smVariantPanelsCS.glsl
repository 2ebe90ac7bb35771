// Samples of the panels of patches, for one variant each. The net of a patch is made from the variables. At a
// node along a panel it is reduced to a curve in s and to that of its derivative in r, as all nodes across it
// have the same r; these are multiplied with the basis in s.
layout(local_size_x = 32) in;
//SM::Define
// Loops to constants are unrolled, so that nets of few points are in registers.
#pragma optionNV(unroll all)
//SM::Include smInvocation
//SM::Include smPortable
//SM::Include smErrorFree
//SM::Include smVariantStorage
//SM::Include smVariantFlux

// Words of an item: its matrix, number of variables, list of directions, panels, number of panels.
const uint smItemSize = 5u;
// Words of a panel: its first number, nodes along and across.
const uint smPanelSize = 3u;

#ifdef SM_NET_IN_BUFFER
// [number][variant]
layout(std430, binding = 4) buffer smNetBuffer
{
  double smNet[];
};
uniform int smDegreeS;
uniform int smDegreeR;
#define SM_DEGREE_S smDegreeS
#define SM_DEGREE_R smDegreeR
#define SM_NET(at) smNet[uint(at) * smVariantCount + smVariant]
#define SM_SET_NET(at, value) smNet[uint(at) * smVariantCount + smVariant] = value
#else
SM_DOUBLES(smNet, 3 * (SM_DEGREE_S + 1) * (SM_DEGREE_R + 1));
#define SM_NET(at) SM_DOUBLE(smNet, at)
#define SM_SET_NET(at, value) SM_SET_DOUBLE(smNet, at, value)
#endif
#define SM_NET_SIZE (3 * (SM_DEGREE_S + 1) * (SM_DEGREE_R + 1))

dvec3 smCenter;
// Of each point of the curve: x y z of its position, and of its derivative in r.
SM_DOUBLES(smCurve, 6 * SM_ROW_SIZE);

// Sum of a matrix times (1, c), [variable][number]: the centre, then x y z of each point, s fastest.
void smMakeNet(uint matrix, uint variables, uint list)
{
  smCenter = smVectorAt(matrix);
  for (int i = 0; i < SM_NET_SIZE; ++i)
  {
    SM_SET_NET(i, smNumbers[matrix + 3u + uint(i)]);
  }
  for (uint a = 1u; a < variables; ++a)
  {
    matrix += uint(3 + SM_NET_SIZE);
    double c = smVariable(list, a);
    smCenter += c * smVectorAt(matrix);
    for (int i = 0; i < SM_NET_SIZE; ++i)
    {
      SM_SET_NET(i, SM_NET(i) + c * smNumbers[matrix + 3u + uint(i)]);
    }
  }
}

// The curve at a node along the panel, whose numbers are the basis in r and its derivatives.
void smMakeCurve(uint at)
{
  for (int i = 0; i <= SM_DEGREE_S; ++i)
  {
    dvec3 position = dvec3(0.0LF);
    dvec3 slope = dvec3(0.0LF);
    for (int j = 0; j <= SM_DEGREE_R; ++j)
    {
      int point = 3 * (i + (SM_DEGREE_S + 1) * j);
      dvec3 value = dvec3(SM_NET(point), SM_NET(point + 1), SM_NET(point + 2));
      position += smNumbers[at + uint(j)] * value;
      slope += smNumbers[at + uint(SM_DEGREE_R + 1 + j)] * value;
    }
    SM_SET_DOUBLE(smCurve, 6 * i, position.x);
    SM_SET_DOUBLE(smCurve, 6 * i + 1, position.y);
    SM_SET_DOUBLE(smCurve, 6 * i + 2, position.z);
    SM_SET_DOUBLE(smCurve, 6 * i + 3, slope.x);
    SM_SET_DOUBLE(smCurve, 6 * i + 4, slope.y);
    SM_SET_DOUBLE(smCurve, 6 * i + 5, slope.z);
  }
}

// A node: weight, what the derivatives in s and r add times the position, the basis in s and its derivatives.
void smAddNode(uint at)
{
  dvec3 position = dvec3(0.0LF);
  dvec3 first = dvec3(0.0LF);
  dvec3 second = dvec3(0.0LF);
  for (int i = 0; i <= SM_DEGREE_S; ++i)
  {
    double basis = smNumbers[at + 3u + uint(i)];
    double derivative = smNumbers[at + uint(4 + SM_DEGREE_S + i)];
    dvec3 point =
      dvec3(SM_DOUBLE(smCurve, 6 * i), SM_DOUBLE(smCurve, 6 * i + 1), SM_DOUBLE(smCurve, 6 * i + 2));
    position += basis * point;
    first += derivative * point;
    second += basis *
      dvec3(SM_DOUBLE(smCurve, 6 * i + 3), SM_DOUBLE(smCurve, 6 * i + 4), SM_DOUBLE(smCurve, 6 * i + 5));
  }
  first += smNumbers[at + 1u] * position;
  second += smNumbers[at + 2u] * position;
  smAddSample(smNumbers[at], smCenter + position, first, second);
}

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
    smMakeNet(smWords[item], smWords[item + 1u], smWords[item + 2u]);
    smBeginSums();
    for (uint p = 0u; p < smWords[item + 4u]; ++p)
    {
      uint panel = smWords[item + 3u] + p * smPanelSize;
      uint at = smWords[panel];
      for (uint along = 0u; along < smWords[panel + 1u]; ++along)
      {
        smMakeCurve(at);
        at += uint(2 * (SM_DEGREE_R + 1));
        for (uint across = 0u; across < smWords[panel + 2u]; ++across)
        {
          smAddNode(at);
          at += uint(3 + 2 * (SM_DEGREE_S + 1));
        }
      }
    }
    smFlushSums();
  }
}
