/**
 * @file smSharedStructure.h
 * @brief Gives a collection of meshes the same blocks on all ranks
 *
 * ParaView sends the blocks of a composite dataset from rank to rank by their order, so that a rank with
 * fewer blocks ends all ranks.
 */
#ifndef smSharedStructure_h
#define smSharedStructure_h

#include "Sharing/smFaceExchange.h"

class vtkPartitionedDataSetCollection;

namespace sm
{
/// Called by all ranks together. Afterwards `meshes` has the blocks of all ranks in the order of the ranks,
/// with their names, and the assembly of the first rank that has blocks; a block of another rank has one
/// partition, which is null. Where a rank has not enough memory, or the connection is lost, the collection is
/// empty on all ranks, and the result is false.
bool ShareStructure(FaceExchange& exchange, vtkPartitionedDataSetCollection& meshes);
}

#endif
