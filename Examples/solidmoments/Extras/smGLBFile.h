/**
 * @file smGLBFile.h
 * @brief Writes the display mesh of a part as a binary glTF 2.0 file
 */
#ifndef smGLBFile_h
#define smGLBFile_h

#include <string>

class vtkPartitionedDataSetCollection;

namespace sm
{
/**
 * Returns the bytes of a file with one node for each body, with its name, normals and the colours of its
 * faces; empty if no body has triangles. glTF has metres and the y axis upwards: the root node scales lengths
 * in `unit` and rotates z to y. Positions are single precision, relative to the centre of their body. Every
 * face has points of its own; on a common edge they have the same bits.
 */
std::string MakeGLB(vtkPartitionedDataSetCollection* bodies, const std::string& unit);
}

#endif
