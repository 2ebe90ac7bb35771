// Arrays that no shader uses, because a driver keeps them as floats: SM_FORM says which. Each adds up
// products of its operands; see smProbe.cxx.
//SM::Define
layout(local_size_x = 32) in;

// Eight operands for each invocation.
layout(std430, binding = 0) readonly buffer smOperandBuffer
{
  double smOperands[];
};
layout(std430, binding = 2) writeonly buffer smValueBuffer
{
  double smValues[];
};
uniform int smCount; // 8

double smOperand(int index)
{
  return smOperands[8u * gl_LocalInvocationID.x + uint(index)];
}

struct smMember
{
  double value;
};
double smGlobal[26];
const double smConstants[2] = double[2](0.7LF, 0.7LF);

void smFill(int count, out double products[26])
{
  for (int i = 0; i < count; ++i)
  {
    products[i] = smOperand(i) * double(i + 1);
  }
}

void main()
{
  double sum = 0.0LF;
#if SM_FORM == 0
  double products[26];
  for (int i = 0; i < smCount; ++i)
  {
    products[i] = smOperand(i) * double(i + 1);
  }
  for (int i = 0; i < smCount; ++i)
  {
    sum += products[i];
  }
#elif SM_FORM == 1
  dvec4 products[26];
  for (int i = 0; i < smCount; ++i)
  {
    products[i] = dvec4(smOperand(i) * double(i + 1), 0.0LF, 0.0LF, 0.0LF);
  }
  for (int i = 0; i < smCount; ++i)
  {
    sum += products[i].x + products[i].w;
  }
#elif SM_FORM == 2
  smMember products[26];
  for (int i = 0; i < smCount; ++i)
  {
    products[i].value = smOperand(i) * double(i + 1);
  }
  for (int i = 0; i < smCount; ++i)
  {
    sum += products[i].value;
  }
#elif SM_FORM == 3
  dmat4x2 products = dmat4x2(0.0LF);
  for (int i = 0; i < smCount; ++i)
  {
    products[i & 3] += dvec2(smOperand(i) * double(i + 1), 0.0LF);
  }
  for (int i = 0; i < smCount - 4; ++i)
  {
    sum += products[i].x;
  }
#elif SM_FORM == 4
  for (int i = 0; i < smCount; ++i)
  {
    smGlobal[i] = smOperand(i) * double(i + 1);
  }
  for (int i = 0; i < smCount; ++i)
  {
    sum += smGlobal[i];
  }
#elif SM_FORM == 5
  for (int i = 0; i < smCount; ++i)
  {
    sum += smOperand(i) * double(i + 1) * (smConstants[i & 1] / 0.7LF);
  }
#elif SM_FORM == 6
  double products[26];
  smFill(smCount, products);
  for (int i = 0; i < smCount; ++i)
  {
    sum += products[i];
  }
#elif SM_FORM == 7
  double products[26];
  for (int i = 0; i < smCount; ++i)
  {
    products[i] = smOperand(i) * double(i + 1);
  }
  double copy[26] = products;
  for (int i = 0; i < smCount; ++i)
  {
    sum += copy[i];
  }
#else
  dvec3 parts = dvec3(0.0LF);
  for (int i = 0; i < smCount; ++i)
  {
    parts[i % 3] += smOperand(i) * double(i + 1);
  }
  sum = parts.x + parts.y + parts.z;
#endif
  smValues[gl_LocalInvocationID.x] = sum;
}
