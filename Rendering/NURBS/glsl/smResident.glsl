// The storage of a page of resident faces, see smResidentFaces.h. Bindings 0 to 2.
struct smPatchRecord
{
  dvec4 centerRadius; // centre x y z, largest distance of a control point from it
  dvec4 domain;       // u start, v start, u width, v width
  uvec4 shape;        // first control point, degree in s, degree in r, unused
};

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
