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
/// Use of an edge by a face; both are numbered from 0.
struct EdgeUse
{
  std::size_t Face = 0;
  std::size_t Edge = 0;
  /// True if the edge runs against the loop of the face, seen from outside.
  bool Reversed = false;
};

/// Finds the groups of faces that are connected by edges: returns, for each face, the index of the first face
/// of its group. The uses are in the order of the faces.
std::vector<std::size_t> GroupFaces(
  const std::vector<EdgeUse>& uses, std::size_t faceCount, std::size_t edgeCount);

/// Returns the connected parts of a shell as shells, in the order of their first faces, without the placement
/// and orientation of the shell. If it is connected, returns the shell itself, without these.
std::vector<TopoDS_Shape> SplitShell(const TopoDS_Shape& shell);
}

#endif
