/**
 * @file smOCCTShells.h
 * @brief Connected parts of a shell
 */
#ifndef smOCCTShells_h
#define smOCCTShells_h

#include <TopoDS_Shape.hxx>

#include <cstddef>
#include <vector>

namespace sm
{
/// Returns true if the edge bounds the face that uses it: it is no pole, and has neither orientation INTERNAL nor EXTERNAL.
bool IsBoundary(const TopoDS_Shape& edge);

/// Finds the groups of faces that are connected by boundary edges: returns, for each face, the index of the first face of its group.
std::vector<std::size_t> GroupFaces(const std::vector<TopoDS_Shape>& faces);

/// Returns the connected parts of a shell as shells, in the order of their first faces, without the placement and orientation of the shell.
/// If it is connected, returns the shell itself, without these.
std::vector<TopoDS_Shape> SplitShell(const TopoDS_Shape& shell);
}

#endif
