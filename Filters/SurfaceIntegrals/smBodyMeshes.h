/**
 * @file smBodyMeshes.h
 * @brief The bodies' display meshes with what was computed for their faces as cell data, to colour them by
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
/// An array of the meshes: a number for every face of every body.
struct MeshArray
{
  std::string Name;
  std::function<double(std::size_t body, std::size_t face)> GetValue;
};

/**
 * Gives `output` a partitioned dataset per body, in their order, with its mesh (points, cells, arrays and exact geometry shared
 * with the input) and the arrays, floats, as cell data; a cell that belongs to no face is NaN there. Equal arrays of instances of
 * one part are shared. An assembly of the input is kept, without the bodies that are not there.
 */
SMFILTERSSURFACEINTEGRALS_EXPORT void MakeBodyMeshes(const std::vector<BodyIntegrals>& bodies,
  const std::vector<MeshArray>& arrays, vtkDataObject* input, vtkPartitionedDataSetCollection* output);
}

#endif
