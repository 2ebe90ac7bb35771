/**
 * @file smPaperParts.h
 * @brief The parts of Table 1, modelled after the descriptions and pictures of the paper
 *
 * Lengths are in mm. The shapes are the same on every run.
 */
#ifndef smPaperParts_h
#define smPaperParts_h

#include <TopLoc_Location.hxx>
#include <TopoDS_Shape.hxx>

#include <optional>
#include <string>
#include <vector>

namespace smpaper
{
/// A solid and its placements in the part.
struct Component
{
  std::string Name;
  TopoDS_Shape Solid;
  std::vector<TopLoc_Location> Placements;
};

/// The exact values of a part by formula.
struct ExactValues
{
  double Volume = 0.0;
  double Area = 0.0;
  double CenterOfMass[3] = { 0.0, 0.0, 0.0 };
};

struct PaperPart
{
  std::string Name;
  /// One component with one placement is written as a part, otherwise all are written as an assembly.
  std::vector<Component> Components;
  std::optional<ExactValues> Exact;
};

/// A quarter of a cylinder that lies along y, its axis through the file's origin; its round face is one
/// rational patch.
PaperPart MakeQuarterCylinder();
/// A block with a slanted cylindrical hole, after the paper's Figure 1(i).
PaperPart MakeSlantedBlock();
/// A tube around a trefoil knot: one face, closed in both directions.
PaperPart MakeTrefoilTube();
/// A handle that has only B-spline faces, with grooves and a duct.
PaperPart MakeFreeForm();
/// A hub with five blades, bored and keyed.
PaperPart MakePropeller();
/// A crankshaft of four throws.
PaperPart MakeCrank();
/// A V8's block: bores, tunnel, ribs, bolt holes.
PaperPart MakeEngineBlock();
/// A gear train in its frame: over a thousand trimmed faces.
PaperPart MakeGearTrain();
}

#endif
