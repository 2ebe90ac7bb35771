// One user expression alone, compiled to obtain the compiler's messages about it. Never dispatched.
//SM::Define
layout(local_size_x = 1) in;
//SM::Include smPortable
layout(std430, binding = 0) buffer smResultBuffer
{
  double smResult;
};
//SM::UserFunctions

void main()
{
  smResult = smUser0(dvec3(smResult), dvec3(smResult));
}
