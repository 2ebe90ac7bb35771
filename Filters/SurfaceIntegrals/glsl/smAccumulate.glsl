// Functions that add a sample to smValues and smRoundings; their terms are generated from the list of integrands.
// Needs: chunk smWorkStorage.

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
