// Each invocation integrates one line of a panel: a processor with thousands of lanes has work for them in few panels. smPanelSumCS
// adds up the lines.
//SM::Define
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

// The panel, an index into smWork, and the node of each line.
layout(std430, binding = 6) readonly buffer smLineBuffer
{
  uvec2 smLines[];
};

void main()
{
  uint index = smInvocationIndex();
  if (index >= smLineCount)
  {
    return;
  }
  uvec2 line = smLines[smFirstLine + index];
  smClear();
  smIntegratePanel(smWork[line.x], int(line.y), int(line.y) + 1);
  for (int k = 0; k < SM_INTEGRANDS; ++k)
  {
    smLineSums[uint(k) * smLineCount + index] = smValues[k];
  }
  for (int k = 0; k < SM_ROUNDINGS; ++k)
  {
    smLineSums[uint(SM_INTEGRANDS + k) * smLineCount + index] = smRoundings[k];
  }
}
