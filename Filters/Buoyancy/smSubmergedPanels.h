/**
 * @file smSubmergedPanels.h
 * @brief Panels of the part of a face below a plane, see smSubmergedFace.h
 */
#ifndef smSubmergedPanels_h
#define smSubmergedPanels_h

#include "smFacePanels.h"
#include "smHeightNet.h"
#include "smTrimRegion.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace sm
{
/// Cuts the panels of one face at a plane.
class SubmergedPanels
{
public:
  SubmergedPanels(const FacePanels& source, const HeightPlane& plane, double tolerance);

  /// Cuts the panels of all patches.
  void Cut();

  /// Returns the resulting panels: in the parameters of the source, or with these exchanged.
  FacePanels& GetPanels(bool exchanged) { return this->Results[exchanged ? 1 : 0]; }
  double GetCutError() const { return this->CutError; }
  std::size_t GetBoxes() const { return this->Boxes; }

private:
  /// A part of a patch that is being subdivided.
  struct Box
  {
    std::size_t Net;
    ParameterRange Range;
    Region Parts;
    /// Upper bound of the integral of |h| |n| over the box.
    double Majorant = 0.0;
  };
  /// A box in which the height is monotone in the first parameter.
  struct Monotone
  {
    const HeightNet* Net;
    ParameterRange Range;
    bool Exchanged;
    std::uint32_t Patch;
    PanelShape Shape;
    bool Increasing;
    /// Lower bound of |dN| per unit of the first parameter, on the box and Room on both sides of it.
    double Slope;
    /// Bound of the integral of |h| |n| over a sliver beside the waterline, per N^2 and per unit of the second parameter.
    double Rate;
    /// Width on each side of the box, in the first parameter, within which the height is known to be monotone too.
    double Room;
    /// Bound of the integral of |h| |n| over the box and Room on both sides, per unit of the second parameter.
    double Whole;
    /// Number of further halvings of graphs that are allowed.
    int Halvings;
  };
  /// A patch of the source and its height, also with the parameters exchanged.
  struct Source
  {
    std::uint32_t Patch;
    PanelShape Shape;
    bool Flip;
    HeightNet Net;
    HeightNet Exchanged;
  };

  void AddPatch(std::uint32_t patch, Region parts);
  /// Appends the submerged panels of a box. Returns false if the box must be halved.
  bool Resolve(Box& box);
  bool IsResolved(const Box& box, bool& below, int& monotone) const;
  bool IsMonotone(const HeightNet& net, const ParameterRange& range, Monotone& found) const;
  void Halve(const Box& box);
  int ChooseDirection(const Box& box) const;
  void CutMonotone(const Source& source, Monotone& box, const Region& region);
  std::vector<struct SignedRange> FindRanges(const Monotone& box, const RegionPart& part);
  void AddGraph(Monotone& box, double start, double end, int sign);
  bool FitGraph(const Monotone& box, double start, double end, int degree, bool accept, PiecePointer& piece);
  void AddPanel(bool exchanged, std::uint32_t patch, PanelShape shape, bool flip, const RegionPart& part);

  const FacePanels& From;
  HeightPlane Plane;
  double Tolerance;
  /// Largest error that a single cut or fit may cause.
  double Small;
  std::vector<Source> Sources;
  std::vector<Box> Open;
  FacePanels Results[2];
  std::map<const void*, std::uint32_t> Trims[2];
  /// Pieces whose addresses are keys of Trims; they must stay alive.
  std::vector<PiecePointer> Kept;
  bool Flip = false;
  double CutError = 0.0;
  std::size_t Boxes = 0;
};
}

#endif
