#include "smPlotSeries.h"

#include "smMassPropertyNames.h"

#include "vtkPVVersion.h"
#if PARAVIEW_VERSION_NUMBER < PARAVIEW_VERSION_CHECK(5, 12, 0)
#include "vtkSMChartSeriesSelectionDomain.h"
#else
#include "vtkPVRepresentedArrayListSettings.h"
#endif

#include <string>

namespace sm
{
namespace
{
constexpr const char* HiddenColumns[] = { names::SurfaceArea, names::FirstMoments, names::SecondMoments,
  names::VolumeInertia, names::VolumeInertiaAtOrigin, names::PrincipalMoments, names::PrincipalAxes,
  names::PrincipalAxesDegenerate, names::RadiiOfGyration, names::Density, names::Mass, names::MassCenter,
  names::MassInertia, names::MassPrincipalMoments, names::MassPrincipalAxes, names::MassRadiiOfGyration,
  names::MassUncertainty, names::OverriddenMass, names::ClosureCorrection, names::ClosureResidual,
  names::GapSquared, names::GapArea, names::MaxGap, names::OpenEdges, names::FlippedShells,
  names::BoundsEstimated, names::BoundsMeasured, names::Faces };

#if PARAVIEW_VERSION_NUMBER < PARAVIEW_VERSION_CHECK(5, 12, 0)
void SetVisible(const std::string& series, bool isVisible)
{
  vtkSMChartSeriesSelectionDomain::AddSeriesVisibilityDefault(series.c_str(), isVisible);
}
#else
/// ParaView's settings only hide series, and components of vectors are hidden there whatever the settings
/// say.
void SetVisible(const std::string& series, bool isVisible)
{
  if (!isVisible)
  {
    vtkPVRepresentedArrayListSettings* settings = vtkPVRepresentedArrayListSettings::GetInstance();
    const int count = settings->GetNumberOfChartsHiddenAttributes();
    settings->SetNumberOfChartsHiddenAttributes(count + 1);
    settings->SetChartsHiddenAttributes(count, series.c_str());
  }
}
#endif
}

void ChoosePlotSeries()
{
  static bool isChosen = false;
  if (isChosen)
  {
    return;
  }
  isChosen = true;
  // Names of series are "MaxGap (id=0)", "CenterOfMass_X (id=0)" of one row, "MaxGap (stats)", "CenterOfMass
  // (0) (stats)" of statistics; of one row "MaxGap" from ParaView 6.1 on, where charts of others have some.
  for (const std::string column : HiddenColumns)
  {
    const bool isCommon = column == names::Density || column == names::Mass || column == names::Faces;
    SetVisible("^" + column + "(" + names::BoundSuffix + "|" + names::SpreadSuffix + ")?(_[^ ]+)?" +
        (isCommon ? " [(]" : "( [(]|$)"),
      false);
  }
  // For a vector ParaView would show only the magnitude, which has no meaning for a position.
  const std::string center = "^" + std::string(names::CenterOfMass);
  SetVisible(center + "(_| [(])Magnitude", false);
  SetVisible(center + "(_[XYZ]| [(][012][)])( [(]|$)", true);
}
}
