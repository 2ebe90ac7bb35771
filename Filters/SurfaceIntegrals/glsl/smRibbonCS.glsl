// Each invocation integrates one line of a ribbon.
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

uniform int smGapSteps;

//SM::Include smRibbon

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
  dvec3 gaps;
  smIntegrateRibbon(smWork[item.x], int(item.y), int(item.z), gaps);
  smStoreLine(line);
  smStoreLineGaps(line, gaps);
}
