/**
 * @file smGearTrainParts.h
 * @brief What the gear train is put together from; each stands on z = 0, its axis along z
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

/// Involute teeth at 20 degrees whose ends are turned to a cone; a tooth points along +x.
TopoDS_Shape MakeGear(int teeth, double width);
/// Through both plates, stepped, with a key's groove.
TopoDS_Shape MakeShaft(double length);
TopoDS_Shape MakeBearingRing(bool outer);
TopoDS_Shape MakeBall();
/// The frame's plate: seats of the bearings, windows, slanted oil holes, screw holes.
TopoDS_Shape MakePlate(int shafts, double distance);
TopoDS_Shape MakeSpacer(double length);
/// With a hexagon socket; its head hangs below z = 0.
TopoDS_Shape MakeBolt(double gap);
/// A hexagon nut, both ends turned.
TopoDS_Shape MakeNut();
/// Middles of the spacers, on z = 0.
std::vector<gp_Pnt> GetSpacerPlaces(int shafts, double distance);
}

#endif
