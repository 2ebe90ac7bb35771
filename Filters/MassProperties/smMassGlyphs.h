/**
 * @file smMassGlyphs.h
 * @brief What mass properties are drawn as: a sphere at the centre of mass, and the principal axes
 */
#ifndef smMassGlyphs_h
#define smMassGlyphs_h

#include "smFiltersMassPropertiesModule.h"
#include "smMassAnalysis.h"

class vtkPolyData;

namespace sm
{
struct MassGlyphOptions
{
  /// Radius of the sphere as a fraction of the diagonal of the box of what it belongs to; 0: no sphere.
  double Scale = 0.02;
  /// By 0.3 of that diagonal to either side of the centre, where the axes are determined.
  bool ShowPrincipalAxes = true;
  /// For every body as well as for the whole.
  bool PerSolid = false;
};

/// Gives `output` points and cells. The active cell scalars are their colour: green, red where the result is flagged.
void MakeMassGlyphs(const std::vector<BodyIntegrals>& bodies, const MassAnalysis& analysis, Status status,
  const MassGlyphOptions& options, vtkPolyData* output);
}

#endif
