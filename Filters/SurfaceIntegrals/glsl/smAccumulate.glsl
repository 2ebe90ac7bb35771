// Adds a sample to smValues and smRoundings; the terms are generated from the list of integrands.
// Needs: chunk smWorkStorage.

//SM::UserFunctions

// A sample of a face: all integrands.
void smAccumulateFace(double weight, double noise, dvec3 position, dvec3 normal)
{
  double size = length(position);
  //SM::AccumulateFaces
  //SM::AccumulateFaceRoundings
}

// A sample of a ribbon or cap: the integrands of the closed chain.
void smAccumulateChain(double weight, double noise, dvec3 position, dvec3 normal)
{
  double size = length(position);
  //SM::AccumulateChain
  //SM::AccumulateChainRoundings
}
