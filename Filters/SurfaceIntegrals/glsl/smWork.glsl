// Functions common to all items of integration: Gauss rules and placements.
//
// Needs: chunks smPortable, smWorkRecord; SM_PLACEMENT (true if faces are placed); smPlacementOffset; double
// smParameter(uint at).

// Returns the number of points along an item.
int smGetNodes(smWorkRecord work)
{
  return int((work.detail.x >> 8) & 255u);
}

// Returns node and weight of the rule of `count` points on [0,1].
dvec2 smRule(int count, int index)
{
  uint at = uint(count * (count - 1) + 2 * index);
  return dvec2(smParameter(at), smParameter(at + 1u));
}

// Returns three numbers of a placement.
dvec3 smPlacementVector(uint at)
{
  return dvec3(smParameter(at), smParameter(at + 1u), smParameter(at + 2u));
}

// Applies the placement of the face, if faces are placed.
void smPlace(uint face, SM_INOUT(dvec3) position, SM_INOUT(dvec3) normal)
{
  if (SM_PLACEMENT)
  {
    uint at = smPlacementOffset + face * 12u;
    dvec3 rowX = smPlacementVector(at);
    dvec3 rowY = smPlacementVector(at + 4u);
    dvec3 rowZ = smPlacementVector(at + 8u);
    // No component is written by an index: NVIDIA's compiler does not link that.
    position = dvec3(dot(rowX, position) + smParameter(at + 3u), dot(rowY, position) + smParameter(at + 7u),
      dot(rowZ, position) + smParameter(at + 11u));
    normal = dvec3(dot(rowX, normal), dot(rowY, normal), dot(rowZ, normal));
  }
}
