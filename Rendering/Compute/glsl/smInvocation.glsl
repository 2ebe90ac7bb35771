// Index of this invocation in a dispatch of ComputeProgram::Dispatch(), whose groups form a rectangle when
// one axis has not enough of them. Include it after the local_size_x layout; local_size_y and _z are 1.
uint smInvocationIndex()
{
  uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  return group * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
}
