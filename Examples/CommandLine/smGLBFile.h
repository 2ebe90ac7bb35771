/**
 * @file smGLBFile.h
 * @brief The display mesh of a part as a binary glTF 2.0 file
 */
#ifndef smGLBFile_h
#define smGLBFile_h

#include <string>

class vtkPartitionedDataSetCollection;

namespace sm
{
/**
 * The bytes of a file with one node for each body, named like it, with normals and the colours of its faces; empty where no body has
 * triangles. glTF has metres and y upwards: the node above all others scales lengths in `unit` and turns z upwards into y. Positions are
 * single precision, relative to the centre of their body. Every face has points of its own; on a common edge they have the same bits.
 */
std::string MakeGLB(vtkPartitionedDataSetCollection* bodies, const std::string& unit);
}

#endif
