// The sums of the lines of a dispatch, column by column, so that neighbouring invocations access neighbouring numbers. Binding 7.
layout(std430, binding = 7) buffer smLineSumBuffer
{
  double smLineSums[];
};

uniform uint smFirstLine;
uniform uint smLineCount;
