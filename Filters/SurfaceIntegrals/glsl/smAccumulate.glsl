// The sums of a line, and functions that add a sample to them; the terms are generated from the list of
// integrands. Every sum is a variable of its own: smPortable says why they are not an array. Needs: chunks
// smWorkStorage, smLineStorage.

//SM::DeclareSums

uniform uint smFirstLine; // the lines of this dispatch
uniform uint smLineCount;

void smClear()
{
  //SM::ClearSums
}

// Stores the sums of a line, which is counted from the first one of the portion.
void smStoreLine(uint line)
{
  uint at = line;
  //SM::StoreSums
}

// Stores the gaps of a line.
void smStoreLineGaps(uint line, dvec3 gaps)
{
  uint at = line + (smIntegrandCount + smRoundingCount) * smLineStride;
  smLineSums[at] = gaps.x;
  smLineSums[at + smLineStride] = gaps.y;
  smLineSums[at + 2u * smLineStride] = gaps.z;
}

// Returns the item of a line, an index into smWork, and the first node of the line and the one behind its
// last.
uvec3 smFindItem(uint line)
{
  uvec4 shape = smFindShape(line, 0);
  uint lines = shape.w & ~smMeasuresGaps;
  uint place = (line - shape.x) / shape.z;
  uint item = shape.y + (line - shape.x) - place * shape.z;
  uint nodes = uint(smGetNodes(smWork[item]));
  return uvec3(item, place * nodes / lines, (place + 1u) * nodes / lines);
}

//SM::UserFunctions

// Adds a sample of a face to all integrands.
void smAccumulateFace(double weight, double noise, dvec3 position, dvec3 normal)
{
  double size = length(position);
  //SM::AccumulateFaces
  //SM::AccumulateFaceRoundings
}

// Adds a sample of a ribbon or cap to the integrands of the closed chain.
void smAccumulateChain(double weight, double noise, dvec3 position, dvec3 normal)
{
  double size = length(position);
  //SM::AccumulateChain
  //SM::AccumulateChainRoundings
}
