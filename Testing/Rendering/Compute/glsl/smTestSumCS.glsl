// Adds up all inputs, so slowly that the host can change them meanwhile.
layout(local_size_x = 32) in;
//SM::Include smInvocation

layout(std430, binding = 0) readonly buffer smInputBuffer
{
  uint smInputs[];
};
layout(std430, binding = 1) writeonly buffer smSumBuffer
{
  uint smSums[];
};
uniform uint smCount;

void main()
{
  uint index = smInvocationIndex();
  uint sum = 0u;
  for (uint i = 0u; i < smCount; ++i)
  {
    sum += smInputs[(i * 97u + index) % smCount];
  }
  smSums[index] = sum;
}
