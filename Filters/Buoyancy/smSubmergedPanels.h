/**
 * @file smSubmergedPanels.h
 * @brief The panels of a face below a plane, see smSubmergedFace.h
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
class SubmergedPanels
{
public:
  SubmergedPanels(const FacePanels& source, const HeightPlane& plane, double tolerance);

  /// Cuts the panels of all patches.
  void Cut();

  /// Panels in the parameters of the source, and with them exchanged.
  FacePanels& GetPanels(bool exchanged) { return this->Results[exchanged ? 1 : 0]; }
  double GetCutError() const { return this->CutError; }
  std::size_t GetBoxes() const { return this->Boxes; }

private:
  struct Box
  {
    std::size_t Net;
    ParameterRange Range;
    Region Parts;
    /// No less than the integral of |h| |n| over the box.
    double Majorant = 0.0;
  };
  /// A box in hand where the height is monotone in its first parameter.
  struct Monotone
  {
    const HeightNet* Net;
    ParameterRange Range;
    bool Exchanged;
    std::uint32_t Patch;
    PanelShape Shape;
    bool Increasing;
    /// Least absolute slope in the first parameter, lowest weight; error per N^2 and step of the second parameter.
    double Slope;
    double Rate;
    double Room;
    /// Bound of the integral of |h| |n| over the box, per step of the second parameter.
    double Whole;
    /// Halvings of graphs that are left.
    int Halvings;
  };
  struct Source
  {
    std::uint32_t Patch;
    PanelShape Shape;
    bool Flip;
    HeightNet Net;
    HeightNet Turned;
  };

  void AddPatch(std::uint32_t patch, Region parts);
  /// Emits what is below, or finds that the box has to be halved.
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
  /// What a single cut or fit may cost.
  double Small;
  std::vector<Source> Sources;
  std::vector<Box> Open;
  FacePanels Results[2];
  std::map<const void*, std::uint32_t> Trims[2];
  /// Pieces whose addresses are in Trims.
  std::vector<PiecePointer> Kept;
  bool Flip = false;
  double CutError = 0.0;
  std::size_t Boxes = 0;
};
}

#endif
