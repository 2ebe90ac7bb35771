// One rational Bezier patch, as shaders read it.
struct smPatchRecord
{
  dvec4 centerRadius; // centre x y z, largest distance of a control point from it
  dvec4 domain;       // u start, v start, u width, v width
  // First control point, degree in s, degree in r, 1 where (s, r) are (v, u) of the face, else 0.
  uvec4 shape;
  dvec2 stretch;      // no less than |dS/ds| and |dS/dr| anywhere, see smFacePanels.h
};
