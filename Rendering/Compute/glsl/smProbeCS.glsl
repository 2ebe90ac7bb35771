// What the shaders rely on, one construct for each result, with operands from buffers, so that nothing is
// computed by the compiler. See smProbe.cxx, which has the names and the right values in the same order.
layout(local_size_x = 32) in;
//SM::Include smPortable
//SM::Include smErrorFree

// Eight operands for each invocation.
layout(std430, binding = 0) readonly buffer smOperandBuffer
{
  double smOperands[];
};
// A subnormal number, a power of two below and one above 1, infinity, a NaN, 3.
layout(std430, binding = 1) readonly buffer smSpecialBuffer
{
  double smSpecial[];
};
layout(std430, binding = 2) writeonly buffer smValueBuffer
{
  double smValues[];
};
shared double smShared[32 * 8];
uniform int smCount;       // 8
uniform uint smValueCount; // results of an invocation

uint smAt;

void smStore(double value)
{
  smValues[smAt++] = value;
}

double smOperand(int index)
{
  return smOperands[8u * gl_LocalInvocationID.x + uint(index)];
}

dvec4 smOperandVector(int index)
{
  return dvec4(smOperand(index), smOperand(index + 1), smOperand(index + 2), smOperand(index + 3));
}

// The operands times 1, 2, 3, ... in an array, added up backwards.
double smSumOfArray()
{
  SM_DOUBLES(products, 26);
  for (int i = 0; i < smCount; ++i)
  {
    SM_SET_DOUBLE(products, i, smOperand(i) * double(i + 1));
  }
  double sum = 0.0LF;
  for (int i = smCount - 1; i >= 0; --i)
  {
    sum += SM_DOUBLE(products, i);
  }
  return sum;
}

void smFillVectors(int count, SM_OUT_VECTORS(rows, 26))
{
  for (int i = 0; i < count; ++i)
  {
    SM_SET_VECTOR(rows, i, smOperandVector(i) * double(i + 1));
  }
}

double smSumOfVectors()
{
  SM_VECTORS(rows, 26);
  smFillVectors(smCount - 3, rows);
  dvec4 sum = dvec4(0.0LF);
  for (int i = smCount - 4; i >= 0; --i)
  {
    sum += SM_VECTOR(rows, i);
  }
  return (sum.x + sum.y) + (sum.z + sum.w);
}

double smSumOfShared()
{
  uint first = 8u * gl_LocalInvocationID.x;
  for (int i = 0; i < smCount; ++i)
  {
    smShared[first + uint(i)] = smOperand(i) * double(i + 1);
  }
  double sum = 0.0LF;
  for (int i = smCount - 1; i >= 0; --i)
  {
    sum += smShared[first + uint(i)];
  }
  return sum;
}

// The largest of infinity, the NaN and 3, where a NaN remains.
double smMaxSpecial()
{
  double largest = smOperand(0);
  for (int i = smCount - 3; i >= smCount - 5; --i)
  {
    largest = smSpecial[i] > largest || smIsNaN(smSpecial[i]) ? smSpecial[i] : largest;
  }
  return largest;
}

void main()
{
  smAt = smValueCount * gl_LocalInvocationID.x;
  double a = smOperand(0);
  double b = smOperand(1);
  double c = smOperand(2);
  smStore(a / b);
  smStore(sqrt(b));
  smStore(length(dvec3(a, b, c)));
  smStore(smTwoSum(a, b).y);
  precise double product = a * b;
  smStore(smProductError(a, b, product));
  smStore(a * 0.1LF);
  smStore(double(smCount) + double(uintBitsToFloat(0x3fc00000u + uint(smCount))));
  smStore(packDouble2x32(unpackDouble2x32(a)));
  smStore(smSumOfArray());
  smStore(smSumOfVectors());
  smStore(smSumOfShared());
  smStore(smSpecial[0] * smSpecial[2]);
  smStore(smSpecial[1] * smSpecial[1] * b);
  dvec3 row = dvec3(smOperand(3), smOperand(4), smOperand(5));
  smStore(dot(row, dvec3(a, b, c)) + smOperand(6));
  dvec3 normal = cross(row, dvec3(a, -b, c));
  smStore(normal.x);
  double maximum = 1.7976931348623157e308LF;
  int passed = (abs(smSpecial[3]) <= maximum ? 0 : 1) + (abs(smSpecial[4]) <= maximum ? 0 : 2) +
    (abs(smSpecial[5]) <= maximum ? 4 : 0) + (smIsNaN(smSpecial[4]) && !smIsNaN(smSpecial[3]) ? 8 : 0);
  smStore(double(passed));
  smStore(smIsNaN(smMaxSpecial()) ? 1.0LF : 0.0LF);
}
