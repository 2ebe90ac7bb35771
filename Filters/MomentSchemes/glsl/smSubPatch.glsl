// The paper's integrals over one sub-patch, equations 16 to 28 with the flux along z, by n x n Gauss points,
// weighted by the fraction of the sub-patch's texels that are in the face; and its error estimate, equation
// 36: 2 K |n_z| by the same points.
//
// Needs: chunks smSchemeTile, smTrimTexture, smPatch; SM_DEGREE_S, SM_DEGREE_R (degrees of `source`,
// constants for the common degrees); int smPoints (n), double smPerturbation (a factor of every sample);
// smSchemePatch smGetSource(uint index), void smSetResult(uint at, double value). Writes the 16 results of
// row `to`: V X Y Z XX YY ZZ XY YZ XZ, vector area, area, estimate if all texels are in the face, estimate if
// any texel is.

// Returns node on [0,1] and weight of point i of n, equations 32 to 35; the weights add up to 1.
dvec2 smSchemeRule(int n, int i)
{
  if (n == 1)
  {
    return dvec2(0.5LF, 1.0LF);
  }
  if (n == 2)
  {
    return dvec2(i == 0 ? 0.21132486540518711775LF : 0.78867513459481288225LF, 0.5LF);
  }
  return i == 1 ? dvec2(0.5LF, 4.0LF / 9.0LF)
                : dvec2(i == 0 ? 0.11270166537925831148LF : 0.88729833462074168852LF, 5.0LF / 18.0LF);
}

// Returns the number of evaluations. `index` is that of the sub-patch within the tile.
uint smIntegrateSubPatch(smSchemeTile tile, uint index, uint to)
{
  uint row = index / tile.grid.z;
  uint column = index - row * tile.grid.z;
  uint factor = tile.shape.z;
  uint texels = max(factor * factor, 1u);
  uint covered = factor > 0u ? smCountTexels(tile, column, row) : 1u;
  double share = double(covered) / double(texels);

  double volume = 0.0LF;
  dvec3 first = dvec3(0.0LF);
  dvec3 second = dvec3(0.0LF);
  dvec3 mixed = dvec3(0.0LF);
  dvec3 vectorArea = dvec3(0.0LF);
  double area = 0.0LF;
  double shadow = 0.0LF;
  // Sub-patches without a texel in the face are not evaluated.
  int n = covered > 0u ? smPoints : 0;

  uint k = tile.shape.y;
  uint faceColumn = tile.grid.x + column;
  uint faceRow = tile.grid.y + row;
  smSchemePatch source = smGetSource(tile.shape.x + (faceRow / k) * tile.begin.w + faceColumn / k);
  int p = SM_DEGREE_S;
  int q = SM_DEGREE_R;
  dvec3 center = dvec3(source.center.x, source.center.y, source.center.z);
  double side = tile.shape.w != 0u ? -1.0LF : 1.0LF;
  for (int j = 0; j < n; ++j)
  {
    dvec2 ruleR = smSchemeRule(n, j);
    SM_VECTORS(points, SM_ROW_SIZE);
    SM_VECTORS(pointsS, SM_ROW_SIZE);
    SM_VECTORS(pointsR, SM_ROW_SIZE);
    smCollapse(source.shape.x, p, q, (double(faceRow % k) + ruleR.x) / double(k), points, pointsS, pointsR);
    for (int i = 0; i < n; ++i)
    {
      dvec2 ruleS = smSchemeRule(n, i);
      dvec3 offset;
      dvec3 tangentS;
      dvec3 tangentR;
      smEvaluateRow(
        p, (double(faceColumn % k) + ruleS.x) / double(k), points, pointsS, pointsR, offset, tangentS,
        tangentR);
      dvec3 position = center + offset;
      double weight = smPerturbation * ruleS.y * ruleR.y / double(k * k);
      dvec3 normal = side * weight * cross(tangentS, tangentR);
      double x = position.x;
      double y = position.y;
      double z = position.z;
      double flux = z * normal.z;
      volume += flux;
      first += flux * dvec3(x, y, 0.5LF * z);
      second += flux * dvec3(x * x, y * y, z * z / 3.0LF);
      mixed += flux * dvec3(x * y, 0.5LF * y * z, 0.5LF * x * z);
      vectorArea += normal;
      area += length(normal);
      shadow += abs(normal.z);
    }
  }

  double estimate = 2.0LF * smValue(tile.values.z + index) * shadow;
  smSetResult(to, share * volume);
  smSetResult(to + 1u, share * first.x);
  smSetResult(to + 2u, share * first.y);
  smSetResult(to + 3u, share * first.z);
  smSetResult(to + 4u, share * second.x);
  smSetResult(to + 5u, share * second.y);
  smSetResult(to + 6u, share * second.z);
  smSetResult(to + 7u, share * mixed.x);
  smSetResult(to + 8u, share * mixed.y);
  smSetResult(to + 9u, share * mixed.z);
  smSetResult(to + 10u, share * vectorArea.x);
  smSetResult(to + 11u, share * vectorArea.y);
  smSetResult(to + 12u, share * vectorArea.z);
  smSetResult(to + 13u, share * area);
  smSetResult(to + 14u, covered == texels ? estimate : 0.0LF);
  smSetResult(to + 15u, covered > 0u ? estimate : 0.0LF);
  return uint(n * n);
}
