/**
 * @file smShellOrientation.h
 * @brief Shells of a solid that are inside out: an outer shell encloses, a void inside it takes away
 */
#ifndef smShellOrientation_h
#define smShellOrientation_h

#include "vtkTrimmedNURBSModel.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace sm
{
struct ShellOrientation
{
  /// Closed parts of the boundary that are not joined by an edge.
  int Shells = 0;
  /// Of those, how many are turned by Sides.
  int Flipped = 0;
  /// By face: the factor, 1 or -1, of its fluxes. Empty: as the file has them.
  std::vector<signed char> Sides;
  /// Every shell points the wrong way: nothing is turned here, the solid as a whole is.
  bool InsideOut = false;
  /// Not empty: why the file's orientation was kept although it may be wrong.
  std::string Doubt;
};

/**
 * The orientation of every shell from what it encloses, `volume`, the flux of x.n/3 by face over faces, ribbons and
 * caps, known to within `bound`, and from its depth: how many other shells it lies in. At even depth the volume is
 * positive, at odd depth, in a void, negative. A shell is a part of the boundary that closes by itself: faces joined by
 * edges, within a shell of the file, and across shells where only together they close.
 *
 * Depth is told with `mesh`, triangles with the cell array FaceIndex in any placement of the model. Shells that cross,
 * whose place cannot be told, whose volume is zero within its bound, or a model of several shells that has no mesh: Sides
 * stays empty and Doubt says why. The model must be closed. One shell: nothing to do, and the mesh is not read.
 */
ShellOrientation OrientShells(vtkTrimmedNURBSModel& model, vtkPolyData* mesh,
  const std::vector<double>& volume, const std::vector<double>& bound);
}

#endif
