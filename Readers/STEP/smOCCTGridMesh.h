/**
 * @file smOCCTGridMesh.h
 * @brief A plain display mesh of one converted face, for faces that OpenCASCADE's mesher gives up on
 */
#ifndef smOCCTGridMesh_h
#define smOCCTGridMesh_h

#include "smFace.h"

#include <array>
#include <vector>

namespace sm
{
/// Points in (u,v) of the face and triangles that are counter-clockwise there.
struct GridMesh
{
  std::vector<std::array<double, 2>> Parameters;
  std::vector<std::array<int, 3>> Triangles;
};

/// A grid over the loops' box, its cells clipped by the loops. Features narrower than a cell are lost.
GridMesh MakeGridMesh(const Face& face, int cells);
}

#endif
