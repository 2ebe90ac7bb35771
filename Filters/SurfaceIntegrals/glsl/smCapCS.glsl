// Each invocation integrates one line of a cap.
//SM::Define
layout(local_size_x = 32) in;
//SM::Include smPortable
//SM::Include smInvocation

// Nine doubles per cap: the points apex, from and to.
layout(std430, binding = 2) readonly buffer smCapBuffer
{
  double smCaps[];
};

double smCap(uint index)
{
  return smCaps[index];
}

//SM::Include smWorkStorage
//SM::Include smLineStorage
//SM::Include smWork
//SM::Include smAccumulate
//SM::Include smCap

void main()
{
  uint index = smInvocationIndex();
  if (index >= smLineCount)
  {
    return;
  }
  uint line = smFirstLine + index;
  uvec3 item = smFindItem(line);
  smClear();
  smIntegrateCap(smWork[item.x], int(item.y), int(item.z));
  smStoreLine(line);
}
