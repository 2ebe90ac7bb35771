// Each invocation integrates one panel.
//SM::Define
layout(local_size_x = 32) in;
//SM::Include smPortable
//SM::Include smInvocation
//SM::Include smResident
//SM::Include smBernstein
//SM::Include smPatch
//SM::Include smWorkStorage
//SM::Include smWork
//SM::Include smFinish
//SM::Include smAccumulate
//SM::Include smPanel

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
  smCountEvaluations(smIntegratePanel(work));
  smFinish(index, work);
}
