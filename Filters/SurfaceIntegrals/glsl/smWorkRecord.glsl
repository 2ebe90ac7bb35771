// One item of integration. Needs: chunk smPortable.
struct smWorkRecord
{
  // panel, ribbon: patch, first trim coefficient; cap: 0, first coordinate; row of the result; face
  uvec4 item;
  // trim degree | points in t << 8 | points across << 16 | flags << 24, first edge coefficient, edge degree,
  // bits of the float that scales the tolerance
  uvec4 detail;
  // panel: t start, t end, xi start, xi end; ribbon: t start, t end, edge start, edge end
  dvec4 range;
};

SM_CONSTANT uint smFlagNegative = 1u;   // the covered area counts negatively
SM_CONSTANT uint smFlagFlip = 2u;       // the outward normal is reversed
SM_CONSTANT uint smFlagFirst = 4u;      // no comparison: the row has no result of a lower order
SM_CONSTANT uint smFlagDiscard = 8u;    // if not converged: leave zeros in the row, as the item is bisected
SM_CONSTANT uint smFlagAlongEdge = 16u; // the width of the ribbon is the gap to the edge

// Unit roundoff u: half the spacing of doubles at 1.
SM_CONSTANT double smUnitRoundoff = 1.1102230246251565e-16LF;
