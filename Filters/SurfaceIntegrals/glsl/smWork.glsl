// Functions common to all items of integration: Gauss rules and placements.
//
// Needs: chunks smPortable, smWorkRecord; SM_INTEGRANDS, SM_ROUNDINGS, SM_PLACEMENT (true if faces are placed); arrays smValues of
// SM_INTEGRANDS and smRoundings of SM_ROUNDINGS doubles; smPlacementOffset; double smParameter(uint at).

// Returns node and weight of the rule of `count` points on [0,1].
dvec2 smRule(int count, int index)
{
  uint at = uint(count * (count - 1) + 2 * index);
  return dvec2(smParameter(at), smParameter(at + 1u));
}

void smClear()
{
  for (int k = 0; k < SM_INTEGRANDS; ++k)
  {
    smValues[k] = 0.0LF;
  }
  for (int k = 0; k < SM_ROUNDINGS; ++k)
  {
    smRoundings[k] = 0.0LF;
  }
}

// Applies the placement of the face, if faces are placed.
void smPlace(uint face, SM_INOUT(dvec3) position, SM_INOUT(dvec3) normal)
{
  if (SM_PLACEMENT)
  {
    dvec3 placedPosition = dvec3(0.0LF);
    dvec3 placedNormal = dvec3(0.0LF);
    for (int i = 0; i < 3; ++i)
    {
      uint at = smPlacementOffset + face * 12u + uint(4 * i);
      dvec3 row = dvec3(smParameter(at), smParameter(at + 1u), smParameter(at + 2u));
      placedPosition[i] = dot(row, position) + smParameter(at + 3u);
      placedNormal[i] = dot(row, normal);
    }
    position = placedPosition;
    normal = placedNormal;
  }
}
