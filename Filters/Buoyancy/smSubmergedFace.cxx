#include "Detail/smSubmergedFace.h"

#include "Detail/smSubmergedPanels.h"
#include "Detail/smSubmergedStrips.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace sm
{
namespace
{
/// Returns -1 if all heights of the face are at most -`margin`, 1 if all are at least `margin`, else 0.
int FindSide(const FacePanels& panels, const HeightPlane& plane, double margin)
{
  bool below = false;
  bool above = panels.Outside.Distance > 0.0;
  below = above;
  const auto add = [&](double height)
  {
    below = below || height < margin;
    above = above || height > -margin;
  };
  for (const Patch& patch : panels.Patches)
  {
    const double middle = plane.GetHeight({ patch.Center[0], patch.Center[1], patch.Center[2] });
    if (std::abs(middle) > 2.0 * patch.Radius + margin)
    {
      add(middle);
      continue;
    }
    for (int i = 0; i < (patch.Degree[0] + 1) * (patch.Degree[1] + 1); ++i)
    {
      const std::array<double, 4>& p = panels.Points[patch.FirstPoint + i];
      add(middle + (plane.Up[0] * p[0] + plane.Up[1] * p[1] + plane.Up[2] * p[2]) / p[3]);
    }
  }
  for (const Ribbon& ribbon : panels.Ribbons)
  {
    for (int i = 0; i <= ribbon.EdgeDegree && !(below && above); ++i)
    {
      const double* p = panels.Coefficients.data() + ribbon.Edge + 3 * i;
      add(plane.GetHeight({ p[0], p[1], p[2] }));
    }
  }
  for (const Cap& cap : panels.Caps)
  {
    add(plane.GetHeight(cap.Apex));
    add(plane.GetHeight(cap.From));
    add(plane.GetHeight(cap.To));
  }
  return below && above ? 0 : above ? 1 : -1;
}

/// Distance from the plane beyond which the side of a point of the face is certain: heights are rounded, too.
/// The border may also be off by the residuals of its curves.
double GetMargin(const CutFace& face, const CutLimits& limits)
{
  double radius = 0.0;
  for (const Patch& patch : face.Panels.Patches)
  {
    radius = std::max(radius, patch.Radius);
  }
  return limits.Displacement + GetBorderResidual(*face.Source, face.Panels) + 16.0 * UnitRoundoff * radius;
}

CutFacePointer MakeFace(const CutFace& source, FacePanels& panels, bool exchanged)
{
  if (panels.Panels.empty() && panels.Ribbons.empty() && panels.Caps.empty())
  {
    return nullptr;
  }
  auto face = std::make_shared<Face>(*source.Source);
  face->Id = NewId();
  if (exchanged)
  {
    // The loops belong to the ribbons, which are all in the other part.
    face->Loops.clear();
  }
  auto cut = std::make_shared<CutFace>();
  cut->Source = std::move(face);
  cut->Degree[0] = source.Degree[exchanged ? 1 : 0];
  cut->Degree[1] = source.Degree[exchanged ? 0 : 1];
  for (int d = 0; d < 2; ++d)
  {
    panels.MaxTrim[d] = source.Panels.MaxTrim[exchanged ? 1 - d : d];
  }
  if (!exchanged)
  {
    panels.CoverageDefects = source.Panels.CoverageDefects;
    panels.Overlap = source.Panels.Overlap;
    panels.Outside = source.Panels.Outside;
    panels.AreTrimsMoved = source.Panels.AreTrimsMoved;
    panels.OpenCorners = source.Panels.OpenCorners;
    panels.VertexReach = source.Panels.VertexReach;
  }
  cut->Panels = std::move(panels);
  return cut;
}
}

SubmergedFace CutBelow(const CutFacePointer& face, const HeightPlane& plane, const CutLimits& limits)
{
  SubmergedFace result;
  const int side = face->Error.empty()
    ? FindSide(face->Panels, plane, limits.HasArea() ? GetMargin(*face, limits) : 0.0)
    : -1;
  if (side > 0)
  {
    return result;
  }
  result.StripArea = GetStripArea(*face);
  if (side < 0)
  {
    result.Parts[0] = face;
    return result;
  }
  const CutLimits half{ 0.5 * limits.Volume, 0.5 * limits.Area, limits.Displacement };
  SubmergedPanels panels(face->Panels, plane, half);
  panels.Cut();
  result.Boxes = panels.GetBoxes();
  const CutErrors strips = CutStripsBelow(*face->Source, face->Panels, plane, half, panels.GetPanels(false));
  result.CutError = panels.GetErrors().Volume + strips.Volume;
  result.AreaError = limits.HasArea() ? panels.GetErrors().Area + strips.Area : 0.0;
  for (int i = 0; i < 2; ++i)
  {
    result.Parts[i] = MakeFace(*face, panels.GetPanels(i == 1), i == 1);
  }
  return result;
}
}
