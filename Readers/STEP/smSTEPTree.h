/**
 * @file smSTEPTree.h
 * @brief The output of vtkSTEPReader without its leaves: names and product structure, also for ranks that have no leaves
 */
#ifndef smSTEPTree_h
#define smSTEPTree_h

#include "smOCCTDocument.h"

#include <string>

class vtkMultiProcessStream;
class vtkPartitionedDataSetCollection;

namespace sm
{
/// Makes the vtkDataAssembly of the products. The attribute "label" of its root is the file's name without folder and extension.
void AddAssembly(
  const ProductNode& root, const std::string& fileName, vtkPartitionedDataSetCollection* output);

/// Appends the number of partitioned datasets of `output`, their names and its assembly to `stream`.
void PackTree(vtkPartitionedDataSetCollection* output, vtkMultiProcessStream& stream);

/// Makes in `output` the tree that PackTree() was given. Every partitioned dataset gets one partition, which is null.
void UnpackTree(vtkMultiProcessStream& stream, vtkPartitionedDataSetCollection* output);
}

#endif
