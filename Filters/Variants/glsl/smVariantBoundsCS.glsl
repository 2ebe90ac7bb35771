// Bounds of the items' errors for the |c| of one variant each: forms of bounds of position and tangents, and
// of their errors, evaluated, then the bound of the flux, see GetFluxBounds() in smVariantMonomials.h. All
// terms are positive.
layout(local_size_x = 32) in;
//SM::Define
//SM::Include smInvocation
//SM::Include smPortable
//SM::Include smErrorFree
//SM::Include smVariantStorage

// [moment][variant]
layout(std430, binding = 3) buffer smSumBuffer
{
  double smSums[];
};

// Words of an item: its first number, number of variables, list of directions.
const uint smItemSize = 3u;

double smVolume;
dvec3 smFirstMoments;
dvec3 smSquares;
dvec3 smProducts;

// The numbers: the factors of the flux's value and error, and for each variable the values of position and
// both tangents, then their errors.
void smAddTerm(uint at, uint variables, uint list)
{
  double valueFactor = smNumbers[at];
  double errorFactor = smNumbers[at + 1u];
  at += 2u;
  dvec3 x = dvec3(0.0LF), first = dvec3(0.0LF), second = dvec3(0.0LF);
  dvec3 xError = dvec3(0.0LF), firstError = dvec3(0.0LF), secondError = dvec3(0.0LF);
  for (uint a = 0u; a < variables; ++a)
  {
    double size = a == 0u ? 1.0LF : abs(smVariable(list, a));
    x += size * smVectorAt(at);
    first += size * smVectorAt(at + 3u);
    second += size * smVectorAt(at + 6u);
    xError += size * smVectorAt(at + 9u);
    firstError += size * smVectorAt(at + 12u);
    secondError += size * smVectorAt(at + 15u);
    at += 18u;
  }
  dvec3 normal = first.yzx * second.zxy + first.zxy * second.yzx;
  dvec3 normalError = (first.yzx * secondError.zxy + firstError.yzx * (second.zxy + secondError.zxy)) +
    (first.zxy * secondError.yzx + firstError.zxy * (second.yzx + secondError.yzx));
  double flux = dot(x, normal);
  double fluxError = dot(x, normalError) + dot(xError, normal + normalError);
  dvec3 farther = x + xError;
  dvec3 moments = flux * x;
  dvec3 momentErrors = flux * xError + fluxError * farther;
  smVolume += valueFactor * flux + errorFactor * fluxError;
  smFirstMoments += valueFactor * moments + errorFactor * momentErrors;
  smSquares += valueFactor * (moments * x) + errorFactor * (moments * xError + momentErrors * farther);
  smProducts += valueFactor * (moments * x.yzx) +
    errorFactor * (moments * xError.yzx + momentErrors * farther.yzx);
}

void smAddMoment(uint moment, double value)
{
  smSums[moment * smVariantCount + smVariant] += value;
}

void main()
{
  smVariant = smInvocationIndex();
  if (smVariant >= smVariantCount)
  {
    return;
  }
  smVolume = 0.0LF;
  smFirstMoments = dvec3(0.0LF);
  smSquares = dvec3(0.0LF);
  smProducts = dvec3(0.0LF);
  for (uint k = 0u; k < smItemCount; ++k)
  {
    uint item = smFirstItem + k * smItemSize;
    smAddTerm(smWords[item], smWords[item + 1u], smWords[item + 2u]);
  }
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
}
