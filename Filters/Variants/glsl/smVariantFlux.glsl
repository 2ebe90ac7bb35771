// Sums of the moments of a variant. Needs: smVariantStorage, smErrorFree.

// [moment, then the carries of all moments][variant]
layout(std430, binding = 3) buffer smSumBuffer
{
  double smSums[];
};

// Sums of at most 64 samples, which go to compensated ones. All bounds count so many roundings.
double smVolume;
dvec3 smFirstMoments;
dvec3 smSquares;
dvec3 smProducts;
uint smSampleCount;

void smBeginSums()
{
  smVolume = 0.0LF;
  smFirstMoments = dvec3(0.0LF);
  smSquares = dvec3(0.0LF);
  smProducts = dvec3(0.0LF);
  smSampleCount = 0u;
}

void smAddMoment(uint moment, double value)
{
  uint at = moment * smVariantCount + smVariant;
  dvec2 sum = smTwoSum(smSums[at], value);
  smSums[at] = sum.x;
  smSums[at + 10u * smVariantCount] += sum.y;
}

void smFlushSums()
{
  smAddMoment(0u, smVolume);
  smAddMoment(1u, smFirstMoments.x);
  smAddMoment(2u, smFirstMoments.y);
  smAddMoment(3u, smFirstMoments.z);
  smAddMoment(4u, smSquares.x);
  smAddMoment(5u, smSquares.y);
  smAddMoment(6u, smSquares.z);
  smAddMoment(7u, smProducts.x);
  smAddMoment(8u, smProducts.y);
  smAddMoment(9u, smProducts.z);
  smBeginSums();
}

// The flux of x g(x) for g = 1, x_i, x_i x_j. The divisors 3, 4 and 5 are the host's.
void smAddSample(double weight, dvec3 position, dvec3 first, dvec3 second)
{
  double flux = weight * dot(position, cross(first, second));
  dvec3 moments = flux * position;
  smVolume += flux;
  smFirstMoments += moments;
  smSquares += moments * position;
  smProducts += moments * position.yzx;
  ++smSampleCount;
  if (smSampleCount == 64u)
  {
    smFlushSums();
  }
}
