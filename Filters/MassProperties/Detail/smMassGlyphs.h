/**
 * @file smMassGlyphs.h
 * @brief Glyph of mass properties: a sphere at the centre of mass, and the principal axes
 */
#ifndef smMassGlyphs_h
#define smMassGlyphs_h

#include "smFiltersMassPropertiesModule.h"
#include "smMassAnalysis.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace sm
{
/// Options of MassGlyphs::Make().
struct MassGlyphOptions
{
  /// Radius of the sphere as a fraction of the diagonal of the bounding box of the body, or of all bodies; 0:
  /// no sphere.
  double Scale = 0.02;
  /// If true, draws the principal axes, if they are determined, to 0.3 of that diagonal on either side of the
  /// centre.
  bool ShowPrincipalAxes = true;
  /// If true, adds a glyph for every body to the glyph of the total.
  bool PerSolid = false;
};

/// Makes the glyphs of every run, and keeps the sphere that they share.
class MassGlyphs
{
public:
  /// Sets the points and cells of `output`. The active cell scalars are colours: green, or red for a flagged
  /// result.
  void Make(const std::vector<BodyIntegrals>& bodies, const MassAnalysis& analysis, Status status,
    const MassGlyphOptions& options, columns::KeptArrays& arrays, vtkPolyData* output);

private:
  /// A sphere of radius 1 about the origin, whose cells and normals all spheres of all runs share.
  vtkSmartPointer<vtkPolyData> UnitSphere;
};
}

#endif
