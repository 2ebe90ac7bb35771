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
/// The edge bounds the face that uses it: it is no pole, and not inside or outside of it.
bool IsBoundary(const TopoDS_Shape& edge);

/// Groups of faces that are connected by boundary edges: for each face the index of the first face of its group.
std::vector<std::size_t> GroupFaces(const std::vector<TopoDS_Shape>& faces);

/// The connected parts of a shell as shells, in the order of their first faces, without its placement and orientation; the shell itself,
/// without them, if it is connected.
std::vector<TopoDS_Shape> SplitShell(const TopoDS_Shape& shell);
}

#endif
