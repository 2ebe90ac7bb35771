/**
 * @file smShellOrientation.h
 * @brief Orientation of the shells of a solid: an outer shell encloses volume, a void inside it removes
 * volume
 */
#ifndef smShellOrientation_h
#define smShellOrientation_h

#include "vtkTrimmedNURBSModel.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkPolyData;

namespace sm
{
/// Result of OrientShells().
struct ShellOrientation
{
  /// Number of closed parts of the boundary that are not joined by an edge.
  int Shells = 0;
  /// Number of these that Sides reverses; all of them if InsideOut.
  int Flipped = 0;
  /// Factor, 1 or -1, of the fluxes of each face. Empty: the orientation of the file is kept.
  std::vector<signed char> Sides;
  /// True if every shell has the wrong orientation: the solid as a whole is to be reversed, and Sides is
  /// empty.
  bool InsideOut = false;
  /// Reason why the file's orientation was kept although it may be wrong; empty otherwise.
  std::string Uncertainty;
  /// Indices of the faces of the shells that it is about, where these are known.
  std::vector<std::size_t> Uncertain;
};

/**
 * Determines the orientation of every shell from the volume it encloses and from its depth, the number of
 * other shells around it. `volume` is the flux of x.n/3 for each face over faces, ribbons and caps, with the
 * error bound `bound`. The volume is positive at even depth, and negative at odd depth, in a void. A shell is
 * a part of the boundary that is closed by itself: faces joined by edges, within a shell of the file, and
 * across shells if they are closed only together.
 *
 * The depth is determined from `mesh`, triangles with the cell array FaceIndex in any placement of the model.
 * Sides remains empty, and Uncertainty has the reason, if shells cross, the nesting cannot be determined or
 * is not that of the model's NumberOfOuterShells, shells would be reversed and the first one, of one outer
 * shell, is a void, the volume of a shell is zero within its bound, or a model of several shells has no mesh.
 * The model must be closed. For a model of one shell Sides is empty, and its mesh is not read.
 */
ShellOrientation OrientShells(vtkTrimmedNURBSModel& model, vtkPolyData* mesh,
  const std::vector<double>& volume, const std::vector<double>& bound);
}

#endif
