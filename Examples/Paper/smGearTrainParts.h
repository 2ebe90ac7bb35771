/**
 * @file smGearTrainParts.h
 * @brief The components of the gear train; each stands on z = 0, with its axis along z
 */
#ifndef smGearTrainParts_h
#define smGearTrainParts_h

#include <TopoDS_Shape.hxx>
#include <gp_Pnt.hxx>

#include <vector>

namespace smpaper
{
constexpr double GearModule = 2.0;
constexpr double PlateThickness = 8.0;
constexpr double BallCircle = 11.5;

/// A gear with involute teeth at 20 degrees whose ends are cut by a cone; a tooth points along +x.
TopoDS_Shape MakeGear(int teeth, double width);
/// A stepped shaft through both plates, with a keyway.
TopoDS_Shape MakeShaft(double length);
TopoDS_Shape MakeBearingRing(bool outer);
TopoDS_Shape MakeBall();
/// The frame's plate: seats of the bearings, windows, slanted oil holes, screw holes.
TopoDS_Shape MakePlate(int shafts, double distance);
TopoDS_Shape MakeSpacer(double length);
/// A screw with a hexagon socket; its head is below z = 0.
TopoDS_Shape MakeBolt(double gap);
/// A hexagon nut with both ends chamfered.
TopoDS_Shape MakeNut();
/// The centres of the spacers, on z = 0.
std::vector<gp_Pnt> GetSpacerPlaces(int shafts, double distance);
}

#endif
