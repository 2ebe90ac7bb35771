// A tile of the paper's schemes: a block of sub-patches of one face, see smSchemeBatch.h. A sub-patch is a knot
// interval's k-th part in u and in v; its texels are its part of the trim texture, factor x factor of them.
struct smSchemeTile
{
  uvec4 begin;  // of the batch's lists: first sub-patch (and result row), first part of a trim curve, first row of texels; knot intervals of the face in u
  uvec4 grid;   // within the face: first column and row; columns and rows of the tile
  uvec4 shape;  // first patch of the face, k, texture factor (0: not trimmed), 1 when the outward normal is -(Su x Sv)
  uvec4 values; // where in smValue: borders in u, borders in v, deviations, trim curves
  uvec4 texels; // first texel, parts of trim curves, unused, unused
};

// What a sub-patch is evaluated from: one rational Bezier patch.
struct smSchemePatch
{
  dvec4 center; // x y z that control points are relative to
  uvec4 shape;  // first control point, degree in u, degree in v, unused
};
