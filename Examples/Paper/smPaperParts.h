/**
 * @file smPaperParts.h
 * @brief The parts of Table 1, modelled in the spirit of the paper's
 *
 * Lengths in mm. Nothing is random: the same shapes on every run.
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
/// A solid and where it stands in the part, once or often.
struct Component
{
  std::string Name;
  TopoDS_Shape Solid;
  std::vector<TopLoc_Location> Placements;
};

/// What a formula says of a part, independent of its model.
struct ExactValues
{
  double Volume = 0.0;
  double Area = 0.0;
  double CenterOfMass[3] = { 0.0, 0.0, 0.0 };
};

struct PaperPart
{
  std::string Name;
  /// One component with one placement is written as a part, else as an assembly.
  std::vector<Component> Components;
  std::optional<ExactValues> Exact;
};

/// A quarter of a cylinder that lies along y, its axis through the file's origin; its round face is one rational patch.
PaperPart MakeQuarterCylinder();
/// A block less a slanted cylinder, after the paper's Figure 1(i).
PaperPart MakeSlantedBlock();
/// A tube round a trefoil knot: one face, closed both ways.
PaperPart MakeTrefoilTube();
/// A handle of B-spline faces alone, with grooves and a duct.
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
