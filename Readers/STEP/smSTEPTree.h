/**
 * @file smSTEPTree.h
 * @brief The output of vtkCADReader without its leaves: names and product structure, also for ranks that have
 * no leaves
 */
#ifndef smSTEPTree_h
#define smSTEPTree_h

#include "smDocument.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkDataAssembly;
class vtkMultiProcessController;
class vtkMultiProcessStream;
class vtkPartitionedDataSetCollection;

namespace sm
{
/// Makes the vtkDataAssembly of the products. Its root is named `format`; the attribute "label" of it is the
/// file's name without folder and extension. Nodes of one parent have different names: where those of the
/// file repeat, their labels have a number, "nut (1)", and their attribute "name" is that of the file
/// (smInstanceNames.h). `unit` is the length of a millimetre in the unit of the output.
vtkSmartPointer<vtkDataAssembly> MakeAssembly(
  const ProductNode& root, const char* format, const std::string& fileName, double unit);

/// More bytes than the field data of an output need.
constexpr std::size_t SpareMemory = std::size_t{ 1 } << 20;

/// Throws std::bad_alloc unless so many bytes are available, because VTK's containers do not tolerate an
/// exception of operator new.
void CheckMemory(std::size_t bytes);

/// Sends `bytes` from the rank `root` to all ranks. A rank without memory for them receives all of them
/// nevertheless, so that no other rank waits for it, and returns false in `hasMemory`, which is else left
/// alone. Returns false if the connection is lost.
bool BroadcastBytes(
  vtkMultiProcessController* controller, int root, std::vector<unsigned char>& bytes, bool& hasMemory);

/// Appends the number of partitioned datasets of `output`, their names and its assembly to `stream`.
void PackTree(vtkPartitionedDataSetCollection* output, vtkMultiProcessStream& stream);

/// Makes in `output` the tree that PackTree() was given. Every partitioned dataset gets one partition, which
/// is null. Throws std::bad_alloc if there is not enough memory, or was not for PackTree().
void UnpackTree(vtkMultiProcessStream& stream, vtkPartitionedDataSetCollection* output);
}

#endif
