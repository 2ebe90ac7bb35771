/**
 * @file smLeafBytes.h
 * @brief Bitwise conversion of the leaves of a collection, vtkNURBSDataSets, to bytes and back
 */
#ifndef smLeafBytes_h
#define smLeafBytes_h

#include "smBytes.h"
#include "smFiltersNURBSModule.h"

class vtkPartitionedDataSetCollection;

namespace sm
{
/// Writes the first partition of every partitioned dataset: points, triangles, arrays of numbers, placement,
/// part name and path, and model. An array, a model or an edge that several leaves share is written once.
/// Names of blocks and the assembly of the collection are not written.
SMFILTERSNURBS_EXPORT void PutLeaves(vtkPartitionedDataSetCollection* from, ByteWriter& to);

/// Makes the leaves of PutLeaves() in `to`, which has as many partitioned datasets; what was shared is shared
/// again. Returns false if the message is invalid; the leaves up to there are made then.
SMFILTERSNURBS_EXPORT bool GetLeaves(ByteReader& from, vtkPartitionedDataSetCollection* to);
}

#endif
