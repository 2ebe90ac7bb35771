/**
 * @file smShells.h
 * @brief Connected parts of a shell
 */
#ifndef smShells_h
#define smShells_h

#include "smShape.h"

#include <cstddef>
#include <vector>

namespace sm
{
/// Use of an edge by a face; both are numbered from 0.
struct EdgeOfFace
{
  std::size_t Face = 0;
  std::size_t Edge = 0;
  /// True if the edge runs against the loop of the face, seen from outside.
  bool Reversed = false;
};

/// Finds the groups of faces that are connected by edges: returns, for each face, the index of the first face
/// of its group. The uses are in the order of the faces.
SMREADERSFACES_EXPORT std::vector<std::size_t> GroupFaces(
  const std::vector<EdgeOfFace>& uses, std::size_t faceCount, std::size_t edgeCount);

/// Returns the connected parts of a shell as shells, in the order of their first faces; the shell itself if
/// it is connected.
SMREADERSFACES_EXPORT std::vector<ShellPointer> SplitShell(const ShellPointer& shell);
}

#endif
