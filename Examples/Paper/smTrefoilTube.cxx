#include "smModelling.h"
#include "smPaperParts.h"

#include <cmath>

namespace smpaper
{
PaperPart MakeTrefoilTube()
{
  const double size = 30.0;
  const double radius = 14.0;
  const int count = 36;
  std::vector<gp_Pnt> points;
  for (int i = 0; i < count; ++i)
  {
    const double t = 2.0 * Pi * i / count;
    points.emplace_back(size * (std::sin(t) + 2.0 * std::sin(2.0 * t)),
      size * (std::cos(t) - 2.0 * std::cos(2.0 * t)), -size * std::sin(3.0 * t));
  }
  // The knot lies on a torus about z. The direction away from the centre line of the torus is never tangent
  // to the knot.
  const auto outwards = [=](const gp_Pnt& p)
  {
    const double fromAxis = std::hypot(p.X(), p.Y());
    const double stretch = (fromAxis - 2.0 * size) / fromAxis;
    return gp_Vec(p.X() * stretch, p.Y() * stretch, p.Z());
  };
  PaperPart part;
  part.Name = "trefoil_tube";
  part.Components.push_back({ part.Name, ClosedTube(points, radius, 1, outwards), { TopLoc_Location() } });
  return part;
}
}
