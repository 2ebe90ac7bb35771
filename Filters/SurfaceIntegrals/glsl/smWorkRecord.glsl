// One item of integration. Needs: chunk smPortable.
struct smWorkRecord
{
  uvec4 item;   // panel, ribbon: patch, first trim coefficient; cap: 0, first coordinate; row of the result; face
  uvec4 detail; // trim degree | points in t << 8 | points across << 16 | flags << 24, first edge coefficient, edge degree, bits of the float that scales the tolerance
  dvec4 range;  // panel: t start, t end, xi start, xi end; ribbon: t start, t end, edge start, edge end
};

SM_CONSTANT uint smFlagNegative = 1u;   // coverage counts negatively
SM_CONSTANT uint smFlagFlip = 2u;       // outward normal is the other way
SM_CONSTANT uint smFlagFirst = 4u;      // nothing to compare with: the row holds no result of a lower order
SM_CONSTANT uint smFlagDiscard = 8u;    // not converged: leave zeros, the item is bisected
SM_CONSTANT uint smFlagAlongEdge = 16u; // the ribbon's width is the gap to the edge
