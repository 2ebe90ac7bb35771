// Each invocation integrates one cap.
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
//SM::Include smResultStorage
//SM::Include smWork
//SM::Include smFinish
//SM::Include smAccumulate
//SM::Include smCap

void main()
{
  uint index = smInvocationIndex();
  if (index >= smWorkCount)
  {
    return;
  }
  index += smFirstWork;
  smWorkRecord work = smWork[index];
  smClear();
  smIntegrateCap(work);
  smFinish(index, work);
}
