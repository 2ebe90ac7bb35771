// The storage of a page of resident faces, see smResidentFaces.h. Bindings 0 to 2.
//SM::Include smPatchRecord

layout(std430, binding = 0) readonly buffer smControlPointBuffer
{
  dvec4 smControlPoints[];
};
layout(std430, binding = 1) readonly buffer smPatchBuffer
{
  smPatchRecord smPatches[];
};
layout(std430, binding = 2) readonly buffer smCoefficientBuffer
{
  double smCoefficients[];
};

dvec4 smControlPoint(uint index)
{
  return smControlPoints[index];
}

double smCoefficient(uint index)
{
  return smCoefficients[index];
}

smPatchRecord smGetPatch(uint index)
{
  return smPatches[index];
}
