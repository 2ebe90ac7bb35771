/**
 * @file smBodyMeshes.h
 * @brief Display meshes of the bodies with the results of their faces as cell data, for colouring
 */
#ifndef smBodyMeshes_h
#define smBodyMeshes_h

#include "smBodyIntegrals.h"
#include "smFiltersSurfaceIntegralsModule.h"

#include <functional>
#include <string>
#include <vector>

class vtkPartitionedDataSetCollection;

namespace sm
{
/// A cell array of the meshes: a number for every face of every body.
struct MeshArray
{
  std::string Name;
  std::function<double(std::size_t body, std::size_t face)> GetValue;
};

/// Returns a block's name for each body: that of its block in the input, with a number where names repeat.
SMFILTERSSURFACEINTEGRALS_EXPORT std::vector<std::string> NameBlocks(
  const std::vector<BodyIntegrals>& bodies);

/**
 * Fills `output` with one partitioned dataset per body, in their order, named by NameBlocks(). Each has the
 * mesh of the body (points, cells, arrays and exact geometry shared with the input) and the arrays (float) as
 * cell data; cells without a face have NaN. Instances of one part share equal arrays. An assembly of the
 * input is preserved without the bodies that are not in the output.
 */
SMFILTERSSURFACEINTEGRALS_EXPORT void MakeBodyMeshes(const std::vector<BodyIntegrals>& bodies,
  const std::vector<MeshArray>& arrays, vtkDataObject* input, vtkPartitionedDataSetCollection* output);
}

#endif
