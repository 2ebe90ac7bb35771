// Each invocation below the count adds smStep * (index + 1) to its own value.
//SM::Define
layout(local_size_x = LOCAL_SIZE) in;
layout(std430, binding = 0) buffer smTestValues
{
  double values[];
};
uniform uint smCount;
uniform double smStep;

//SM::Include smInvocation

void main()
{
  uint index = smInvocationIndex();
  if (index < smCount)
  {
    values[index] += smStep * double(index + 1u);
  }
}
