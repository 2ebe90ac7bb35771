#include "smGearTrainParts.h"
#include "smModelling.h"
#include "smPaperParts.h"

#include <gp_Trsf.hxx>

#include <cmath>

namespace smpaper
{
namespace
{
const double PlateGap = 46.0;

TopLoc_Location At(const gp_Pnt& place, double turn = 0.0)
{
  gp_Trsf motion;
  motion.SetTranslation(gp_Vec(gp_Pnt(), place));
  gp_Trsf rotation;
  rotation.SetRotation(gp_Ax1(gp_Pnt(), gp_Dir(0, 0, 1)), turn);
  return { motion * rotation };
}
}

PaperPart MakeGearTrain()
{
  // Pinions and wheels mesh in pairs; a wheel and the next pinion share a shaft.
  const int pinionTeeth = 21;
  const int wheelTeeth = 40;
  const double distance = 0.5 * GearModule * (pinionTeeth + wheelTeeth);
  const int shaftCount = 4;
  Component pinions{ "pinion", MakeGear(pinionTeeth, 14.0), {} };
  Component wheels{ "wheel", MakeGear(wheelTeeth, 12.0), {} };
  Component shafts{ "shaft", MakeShaft(PlateGap), {} };
  Component outerRings{ "bearing outer ring", MakeBearingRing(true), {} };
  Component innerRings{ "bearing inner ring", MakeBearingRing(false), {} };
  Component balls{ "ball", MakeBall(), {} };
  Component plates{ "plate", MakePlate(shaftCount, distance), {} };
  Component spacers{ "spacer", MakeSpacer(PlateGap), {} };
  Component bolts{ "bolt", MakeBolt(PlateGap), {} };
  Component nuts{ "nut", MakeNut(), {} };

  plates.Placements = { At(gp_Pnt(0, 0, -PlateThickness)), At(gp_Pnt(0, 0, PlateGap)) };
  for (int i = 0; i < shaftCount; ++i)
  {
    const gp_Pnt shaft(i * distance, 0, 0);
    shafts.Placements.push_back(At(shaft, 0.4 * i));
    // The gears lie in two planes alternately.
    const double z = i % 2 == 0 ? 4.0 : 26.0;
    if (i + 1 < shaftCount)
    {
      pinions.Placements.push_back(At(gp_Pnt(shaft.X(), 0, z)));
      // Rotates the wheel so that a gap faces the pinion's tooth.
      wheels.Placements.push_back(At(gp_Pnt(shaft.X() + distance, 0, z), Pi + Pi / wheelTeeth));
    }
    for (const double seat : { -PlateThickness, PlateGap })
    {
      outerRings.Placements.push_back(At(gp_Pnt(shaft.X(), 0, seat)));
      innerRings.Placements.push_back(At(gp_Pnt(shaft.X(), 0, seat)));
      for (int k = 0; k < 9; ++k)
      {
        const double angle = 2.0 * Pi * k / 9.0;
        balls.Placements.push_back(At(gp_Pnt(shaft.X() + BallCircle * std::cos(angle),
          BallCircle * std::sin(angle), seat + PlateThickness / 2.0)));
      }
    }
  }
  for (const gp_Pnt& corner : GetSpacerPlaces(shaftCount, distance))
  {
    spacers.Placements.push_back(At(corner));
    bolts.Placements.push_back(At(gp_Pnt(corner.X(), corner.Y(), -PlateThickness)));
    nuts.Placements.push_back(At(gp_Pnt(corner.X(), corner.Y(), PlateGap + PlateThickness), 0.15));
  }
  PaperPart part;
  part.Name = "gear_train";
  part.Components = { plates, spacers, shafts, pinions, wheels, outerRings, innerRings, balls, bolts, nuts };
  return part;
}
}
