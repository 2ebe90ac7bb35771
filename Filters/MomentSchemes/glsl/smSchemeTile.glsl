// A tile of the paper's schemes: a block of sub-patches of one face, see smSchemeBatch.h. A sub-patch is one
// of the k x k parts of a knot interval; factor x factor texels of the trim texture belong to it.
struct smSchemeTile
{
  // Beginnings in the batch's lists: first sub-patch (and result row), first part of a trim curve, first row
  // of texels; then the number of knot intervals of the face in u.
  uvec4 begin;
  // Block within the face: first column and row; number of columns and rows of the tile.
  uvec4 grid;
  // First patch of the face, k, texture factor (0: not trimmed), 1 if the outward normal is -(Su x Sv).
  uvec4 shape;
  // Indices in smValue of the borders in u, borders in v, deviations and trim curves.
  uvec4 values;
  // Index of the first texel, number of parts of trim curves, unused, unused.
  uvec4 texels;
};

// The rational Bezier patch of a knot interval, from which sub-patches are evaluated.
struct smSchemePatch
{
  dvec4 center; // origin x y z of the control points
  uvec4 shape;  // first control point, degree in u, degree in v, unused
};
