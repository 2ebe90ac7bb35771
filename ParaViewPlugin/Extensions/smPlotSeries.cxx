#include "smPlotSeries.h"

#include "smMassPropertyNames.h"

#include "vtkSMChartSeriesSelectionDomain.h"

#include <string>

namespace sm
{
namespace
{
constexpr const char* HiddenColumns[] = { names::SurfaceArea, names::FirstMoments, names::SecondMoments,
  names::VolumeInertia, names::VolumeInertiaAtOrigin, names::PrincipalMoments, names::PrincipalAxes,
  names::PrincipalAxesDegenerate, names::RadiiOfGyration, names::Density, names::Mass, names::MassCenter,
  names::MassInertia, names::MassPrincipalMoments, names::MassPrincipalAxes, names::MassRadiiOfGyration,
  names::MassUncertainty, names::ClosureCorrection, names::ClosureResidual, names::GapSquared, names::GapArea,
  names::MaxGap, names::OpenEdges, names::FlippedShells, names::BoundsEstimated, names::BoundsMeasured,
  names::Faces };

void SetVisible(const std::string& series, bool isVisible)
{
  vtkSMChartSeriesSelectionDomain::AddSeriesVisibilityDefault(series.c_str(), isVisible);
}
}

void ChoosePlotSeries()
{
  static bool isChosen = false;
  if (isChosen)
  {
    return;
  }
  isChosen = true;
  // Names of series are "MaxGap (id=0)", "CenterOfMass_X (id=0)" of one row, "MaxGap (stats)", "CenterOfMass (0) (stats)" of statistics.
  for (const char* column : HiddenColumns)
  {
    SetVisible("^" + std::string(column) + "(" + names::BoundSuffix + ")?(_[^ ]+)? [(]", false);
  }
  // For a vector ParaView would show only the magnitude, which has no meaning for a position.
  const std::string center = "^" + std::string(names::CenterOfMass);
  SetVisible(center + "(_| [(])Magnitude", false);
  SetVisible(center + "(_[XYZ]| [(][012][)]) [(]", true);
}
}
