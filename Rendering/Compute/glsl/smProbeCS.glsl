// Tests that the driver computes in double precision, see vtkComputeContext. The operands are uniforms so that nothing is
// folded at compile time.
layout(local_size_x = 1) in;
layout(std430, binding = 0) writeonly buffer smValues
{
  double values[];
};
uniform double smA;
uniform double smB;

//SM::Include smErrorFree

void main()
{
  double quotient = smA / smB;
  values[0] = quotient;
  values[1] = sqrt(smB);
  values[2] = smTwoSum(quotient, smB).y;
}
