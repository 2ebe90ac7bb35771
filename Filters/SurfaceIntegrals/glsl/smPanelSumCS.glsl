// Each invocation adds up the lines of one panel in their order.
//SM::Define
layout(local_size_x = 32) in;
//SM::Include smPortable
//SM::Include smInvocation
//SM::Include smWorkStorage
//SM::Include smResultStorage
//SM::Include smLineStorage
//SM::Include smFinish

void main()
{
  uint index = smInvocationIndex();
  if (index >= smWorkCount)
  {
    return;
  }
  index += smFirstWork;
  smWorkRecord work = smWork[index];
  // The first line of a panel takes the place of a ribbon's edge.
  uint first = work.detail.y - smFirstLine;
  uint count = (work.detail.x >> 8) & 255u;
  for (int k = 0; k < SM_INTEGRANDS; ++k)
  {
    smValues[k] = 0.0LF;
    for (uint line = first; line < first + count; ++line)
    {
      smValues[k] += smLineSums[uint(k) * smLineCount + line];
    }
  }
  for (int k = 0; k < SM_ROUNDINGS; ++k)
  {
    smRoundings[k] = 0.0LF;
    for (uint line = first; line < first + count; ++line)
    {
      smRoundings[k] += smLineSums[uint(SM_INTEGRANDS + k) * smLineCount + line];
    }
  }
  smCountEvaluations(count * ((work.detail.x >> 16) & 255u));
  smFinish(index, work);
}
