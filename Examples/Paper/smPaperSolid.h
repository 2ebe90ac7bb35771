/**
 * @file smPaperSolid.h
 * @brief The solids of the paper's graphs, made in memory with exactly known volumes and patches
 */
#ifndef smPaperSolid_h
#define smPaperSolid_h

#include <vtkNURBSDataSet.h>
#include <vtkSmartPointer.h>

namespace smfigure
{
struct PaperSolid
{
  vtkSmartPointer<vtkNURBSDataSet> DataSet;
  /// The volume by formula; NaN where there is none.
  double Volume;
};

/// A quarter of a cylinder of radius 10 and length 25 that lies along x, its axis at y = z = 0: one rational
/// patch of degree 2 x 1 without a knot inside, u along the arc, and four planes in which z nz is 0. Volume:
/// pi r^2 h / 4, to which only the patch contributes.
PaperSolid MakeQuarterCylinder();

/// A block of 60 x 40 x 30 with a hole of radius 9 through it from top to bottom, 25 degrees off the
/// vertical: six planes and a rational cylinder of four quarter arcs, trimmed by two waves. Volume: the block
/// less pi r^2 (30 / cos 25 deg), since the hole is a sheared circular prism.
PaperSolid MakeSlantedBlock();

/// A bicubic patch of 4 x 3 knot intervals with a round hole and a wavy cut on one side, as an example of a
/// trimmed face. A shell: no volume.
PaperSolid MakeTrimmedPatch();
}

#endif
