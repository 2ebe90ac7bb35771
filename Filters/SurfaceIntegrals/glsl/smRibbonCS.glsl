// Each invocation integrates one ribbon.
//SM::Define
layout(local_size_x = 32) in;
//SM::Include smPortable
//SM::Include smInvocation
//SM::Include smResident
//SM::Include smBernstein
//SM::Include smPatch
//SM::Include smWorkStorage
//SM::Include smResultStorage
//SM::Include smWork
//SM::Include smFinish
//SM::Include smAccumulate

uniform int smGapSteps;

//SM::Include smRibbon

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
  dvec3 gaps;
  smCountEvaluations(smIntegrateRibbon(work, gaps));
  bool kept = smFinish(index, work);
  smStoreGaps(work, kept, gaps);
}
