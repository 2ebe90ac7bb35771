// Display points of faces, see vtkNURBSPointEvaluatorGPU.
//SM::Define
layout(local_size_x = 32) in;

//SM::Include smPortable
//SM::Include smInvocation
//SM::Include smResident
//SM::Include smBernstein
//SM::Include smPatch
//SM::Include smDisplayPoint

struct smLocalPoint
{
  double s;
  double r;
  uvec2 place; // patch of the face, face of the model
};
layout(std430, binding = 3) readonly buffer smLocalPointBuffer
{
  smLocalPoint smLocalPoints[];
};
// First patch of every face of the model on the page.
layout(std430, binding = 4) readonly buffer smFirstPatchBuffer
{
  uint smFirstPatches[];
};
// Position and normal.
layout(std430, binding = 5) writeonly buffer smResultBuffer
{
  double smResults[];
};

uniform uint smFirstPoint;  // in smLocalPoints
uniform uint smFirstResult; // in smResults, in points
uniform uint smPointCount;

void main()
{
  uint index = smInvocationIndex();
  if (index >= smPointCount)
  {
    return;
  }
  smLocalPoint point = smLocalPoints[smFirstPoint + index];
  dvec3 position;
  dvec3 normal;
  smEvaluateDisplayPoint(
    smGetPatch(smFirstPatches[point.place.y] + point.place.x), point.s, point.r, position, normal);
  uint at = 6u * (smFirstResult + index);
  for (int c = 0; c < 3; ++c)
  {
    smResults[at + uint(c)] = position[c];
    smResults[at + uint(3 + c)] = normal[c];
  }
}
