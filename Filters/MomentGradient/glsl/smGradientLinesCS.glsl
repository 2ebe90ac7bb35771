// Integrates along lines of constant r, times one polynomial in s. One invocation has a line and a
// polynomial.
layout(local_size_x = 32) in;
//SM::Define
//SM::Include smInvocation
//SM::Include smPortable
//SM::Include smGradientStorage
//SM::Include smGradientSample

// [row][point, its derivative in s, in r]
layout(std430, binding = 3) readonly buffer smRowBuffer
{
  dvec4 smRows[];
};
// [row][fours]
layout(std430, binding = 4) writeonly buffer smLineSumBuffer
{
  dvec4 smLineSums[];
};

smGradientPatch smLoadPatch(uint patchIndex)
{
  uint at = smPatchWord(patchIndex, 3u);
  smGradientPatch net;
  net.origin = dvec3(smNumbers[at], smNumbers[at + 1u], smNumbers[at + 2u]);
  net.radius = smNumbers[at + 3u];
  net.stretch = dvec2(smNumbers[at + 4u], smNumbers[at + 5u]);
  net.off = smNumbers[at + 6u];
  net.offSlope = dvec2(smNumbers[at + 7u], smNumbers[at + 8u]);
  net.roundings = smNumbers[at + 9u];
  net.additions = smNumbers[at + 10u];
  net.degrees = dvec2(double(smPatchWord(patchIndex, 0u)), double(smPatchWord(patchIndex, 1u)));
  return net;
}

double smPower(double x, uint exponent)
{
  double power = 1.0LF;
  for (uint i = 0u; i < exponent; ++i)
  {
    power *= x;
  }
  return power;
}

// Bernstein polynomial i of a degree; 0 if there is none.
double smBernstein(double s, uint degree, uint i)
{
  if (i > degree)
  {
    return 0.0LF;
  }
  uint binomial = 1u;
  for (uint k = 1u; k <= i; ++k)
  {
    binomial = binomial * (degree - k + 1u) / k;
  }
  return double(binomial) * smPower(s, i) * smPower(1.0LF - s, degree - i);
}

// The curve of a degree, of which number `which` of each row is a point, by powers of s and products with
// 1 - s: at most 3 roundings a degree and 2.
dvec4 smCurve(uint row, uint which, uint degree, double s)
{
  double t = 1.0LF - s;
  dvec4 sum = smRows[3u * row + which];
  double power = 1.0LF;
  uint binomial = 1u;
  for (uint k = 1u; k <= degree; ++k)
  {
    power *= s;
    binomial = binomial * (degree - k + 1u) / k;
    sum = sum * t + (double(binomial) * power) * smRows[3u * (row + k) + which];
  }
  return sum;
}

void main()
{
  uint row = smInvocationIndex();
  if (row >= smCount)
  {
    return;
  }
  uint line = smWords[smFirstEntry + row];
  uint first = smLineWord(line, 4u);
  uint i = row - first;
  uint patchIndex = smLineWord(line, 0u);
  uint p = smPatchWord(patchIndex, 0u);
  smGradientPatch net = smLoadPatch(patchIndex);
  uint at = smLineWord(line, 1u);
  smGradientLine own;
  own.coverage = smNumbers[at];
  own.side = smNumbers[at + 1u];
  own.edge = smNumbers[at + 2u];
  own.growth = smNumbers[at + 3u];
  own.trimRounding = smNumbers[at + 4u];
  double weight = smNumbers[at + 5u];
  double start = smNumbers[at + 6u];
  double width = smNumbers[at + 7u];
  uint rule = smLineWord(line, 2u);
  uint across = smLineWord(line, 3u);

  // Of the moments 1, x, y, z, xx, yy, zz, xy, yz, xz.
  dvec4 sum0 = dvec4(0.0LF);
  dvec4 sum1 = dvec4(0.0LF);
  dvec4 sum2 = dvec4(0.0LF);
  dvec4 sum3 = dvec4(0.0LF);
  dvec4 sum4 = dvec4(0.0LF);
  dvec4 sum5 = dvec4(0.0LF);
  dvec4 sum6 = dvec4(0.0LF);
  dvec4 sum7 = dvec4(0.0LF);
  dvec4 sum8 = dvec4(0.0LF);
  dvec4 sum9 = dvec4(0.0LF);
  dvec4 area = dvec4(0.0LF);
  dvec4 noise = dvec4(0.0LF);
  dvec4 slopes = dvec4(0.0LF);
  dvec2 areaNoise = dvec2(0.0LF);
  for (uint b = 0u; b < across; ++b)
  {
    double s = (start + width * smNumbers[rule + 2u * b]) * own.edge;
    smGradientSample sampled = smMakeGradientSample(net, own, weight * smNumbers[rule + 2u * b + 1u],
      smCurve(first, 0u, p, s), smCurve(first, 1u, p - 1u, s), smCurve(first, 2u, p, s));
    double value = smBernstein(s, p, i);
    double slope = -smBernstein(s, p - 1u, i);
    if (i > 0u)
    {
      slope += smBernstein(s, p - 1u, i - 1u);
    }
    slope *= double(p);
    dvec3 x = sampled.position;
    double weighted = value * sampled.weight;
    sum0 += weighted * sampled.flux;
    sum1 += (weighted * x.x) * sampled.flux;
    sum2 += (weighted * x.y) * sampled.flux;
    sum3 += (weighted * x.z) * sampled.flux;
    sum4 += (weighted * (x.x * x.x)) * sampled.flux;
    sum5 += (weighted * (x.y * x.y)) * sampled.flux;
    sum6 += (weighted * (x.z * x.z)) * sampled.flux;
    sum7 += (weighted * (x.x * x.y)) * sampled.flux;
    sum8 += (weighted * (x.y * x.z)) * sampled.flux;
    sum9 += (weighted * (x.x * x.z)) * sampled.flux;
    area += value * sampled.area + slope * sampled.alongS;
    noise += abs(value) * sampled.noise;
    slopes += value * sampled.alongR;
    areaNoise += sampled.areaNoise;
  }
  uint to = smRowFours * row;
  smLineSums[to] = smStored(sum0);
  smLineSums[to + 1u] = sum1;
  smLineSums[to + 2u] = sum2;
  smLineSums[to + 3u] = sum3;
  smLineSums[to + 4u] = sum4;
  smLineSums[to + 5u] = sum5;
  smLineSums[to + 6u] = sum6;
  smLineSums[to + 7u] = sum7;
  smLineSums[to + 8u] = sum8;
  smLineSums[to + 9u] = sum9;
  smLineSums[to + 10u] = area;
  smLineSums[to + 11u] = noise;
  smLineSums[to + 12u] = slopes;
  smLineSums[to + 13u] = dvec4(areaNoise, 0.0LF, 0.0LF);
}
