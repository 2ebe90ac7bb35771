// Each invocation integrates one line of a panel.
//SM::Define
// NVIDIA: loops over constant degrees become straight code, and what they index stays in registers.
#pragma optionNV(unroll all)
layout(local_size_x = 32) in;
//SM::Include smPortable
//SM::Include smInvocation
//SM::Include smResident
//SM::Include smBernstein
//SM::Include smPatch
//SM::Include smWorkStorage
//SM::Include smLineStorage
//SM::Include smWork
//SM::Include smAccumulate
//SM::Include smPanel

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
  smIntegratePanel(smWork[item.x], int(item.y), int(item.z));
  smStoreLine(line);
}
