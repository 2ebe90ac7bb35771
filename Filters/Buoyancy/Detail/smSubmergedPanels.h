/**
 * @file smSubmergedPanels.h
 * @brief Panels of the part of a face below a plane, see smSubmergedFace.h
 */
#ifndef smSubmergedPanels_h
#define smSubmergedPanels_h

#include "smFacePanels.h"
#include "smHeightNet.h"
#include "smSubmergedFace.h"
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
  SubmergedPanels(const FacePanels& source, const HeightPlane& plane, const CutLimits& limits);

  /// Cuts the panels of all patches.
  void Cut();

  /// Returns the resulting panels: in the parameters of the source, or with these exchanged.
  FacePanels& GetPanels(bool exchanged) { return this->Results[exchanged ? 1 : 0]; }
  const CutErrors& GetErrors() const { return this->Errors; }
  std::size_t GetBoxes() const { return this->Boxes; }

private:
  /// A part of a patch that is being subdivided.
  struct Box
  {
    std::size_t Net;
    ParameterRange Range;
    Region Parts;
    /// Upper bounds of the integrals over the box, and the larger of their ratios to the limits.
    CutErrors Majorant;
    double Excess = 0.0;
  };
  /// A box in which the height is monotone in the first parameter.
  struct Monotone
  {
    const HeightNet* Net;
    ParameterRange Range;
    bool Exchanged;
    std::uint32_t Patch;
    std::uint32_t SourcePatch;
    PanelShape Shape;
    bool Increasing;
    /// Lower bound of |dN| per unit of the first parameter, on the box and Room on both sides of it.
    double Slope;
    /// Bound of the integral of |h| |n| over a sliver along the waterline, per N^2 and per unit of the
    /// second parameter.
    double Rate;
    /// Surface area of such a sliver, per |N| and per unit of the second parameter.
    double AreaRate;
    /// Bound of the error of N, for the area.
    double Noise;
    /// Width on each side of the box, in the first parameter, within which the height is known to be monotone
    /// too.
    double Room;
    /// Bounds of the integrals over the box and Room on both sides, per unit of the second parameter.
    CutErrors Whole;
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
  /// Returns a bound of the error of N that decides which side of the plane is certain: 0 if areas are not
  /// wanted.
  double GetNoise(const HeightNet& net) const
  {
    return this->Limits.HasArea() ? net.GetNoise(this->Limits.Displacement) : 0.0;
  }
  /// Returns an upper bound of |n| on a part of a patch of the source: surface area per area in the
  /// parameters of the trim pieces.
  double GetMaxNormal(std::uint32_t patch, const ParameterRange& range) const;
  /// Returns true if halving the box further cannot decide on which side of the plane it is.
  bool IsFinal(const Box& box) const;
  void AddLeftover(const Box& box);
  /// Returns true if an error is so small that a cut or fit may cause it. `largest` is its |N|.
  bool IsSmall(const CutErrors& cost, double largest, double noise) const
  {
    return cost.Volume <= this->Small * this->Limits.Volume &&
      (cost.Area <= this->Small * this->Limits.Area || largest <= noise);
  }
  void Add(const CutErrors& cost)
  {
    this->Errors.Volume += cost.Volume;
    this->Errors.Area += cost.Area;
  }
  /// Appends the submerged panels of a box. Returns false if the box must be halved.
  bool Resolve(Box& box);
  bool IsResolved(const Box& box, bool& below, int& monotone) const;
  bool IsMonotone(const HeightNet& net, const ParameterRange& range, Monotone& found) const;
  void Halve(const Box& box);
  int ChooseDirection(const Box& box) const;
  void CutMonotone(const Source& source, Monotone& box, const Region& region);
  /// Returns bounds of the integrals over a sliver with |N| at most `largest` along a length in the second
  /// parameter; the bound of the area includes the uncertain area next to it.
  CutErrors GetCost(const Monotone& box, double largest, double length) const;
  /// Returns the area next to a part whose side of the plane is uncertain, with |N| at most `largest` along a
  /// length in the second parameter, by bounds near the part; those of the box are used where they are
  /// smaller.
  double GetAreaBeside(const Monotone& box, const RegionPart& part, double largest, double length) const;
  /// Returns the variation of the second parameter along the interval of a part where |N| may be at most
  /// `maximum`.
  double GetUncertainVariation(
    const Monotone& box, const RegionPart& part, double start, double end, double maximum, int depth) const;
  /// Find the ranges of a part on which N has one sign; FindRanges() adds the uncertain area next to it to
  /// the errors.
  std::vector<struct SignedRange> FindRanges(const Monotone& box, const RegionPart& part);
  std::vector<struct SignedRange> FindSigns(const Monotone& box, const RegionPart& part);
  void AddGraph(Monotone& box, double start, double end, int sign);
  /// Adds the area that a graph sweeps when its points are displaced. `extent` is a range of its first
  /// parameter.
  void AddSweep(const Monotone& box, const std::vector<std::array<double, 2>>& graph,
    const std::array<double, 2>& extent);
  bool FitGraph(const Monotone& box, double start, double end, int degree, bool accept, PiecePointer& piece);
  void AddPanel(bool exchanged, std::uint32_t patch, PanelShape shape, bool flip, const RegionPart& part);

  const FacePanels& From;
  HeightPlane Plane;
  CutLimits Limits;
  /// Share of the limits that a single cut or fit may cause.
  double Small;
  std::vector<Source> Sources;
  std::vector<Box> Open;
  FacePanels Results[2];
  std::map<const void*, std::uint32_t> Trims[2];
  /// Pieces whose addresses are keys of Trims; they must stay alive.
  std::vector<PiecePointer> Kept;
  bool Flip = false;
  CutErrors Errors;
  std::size_t Boxes = 0;
};
}

#endif
