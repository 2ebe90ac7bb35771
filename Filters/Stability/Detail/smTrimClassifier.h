/**
 * @file smTrimClassifier.h
 * @brief Classifies boxes of a face's parameters: inside its loops, outside, or possibly crossed by one
 */
#ifndef smTrimClassifier_h
#define smTrimClassifier_h

#include "smFace.h"
#include "smFiltersStabilityModule.h"

#include <array>
#include <vector>

namespace sm
{
enum class TrimSide
{
  Inside,
  Outside,
  /// A loop crosses the box, or runs so near that it may.
  Undecided
};

/// The loops as polygons whose distance from the curves is known, sorted by v for the search.
class SMFILTERSSTABILITY_EXPORT TrimClassifier
{
public:
  /// Copies the loops of the face, which need not outlive the classifier.
  explicit TrimClassifier(const Face& face);

  /// Classifies a closed box in the face's own (u, v), which may have width 0. Inside and Outside are proved
  /// for the trim curves themselves. Points with a winding number other than 0 are inside; without loops all
  /// points are. `hopeless`, if not null, becomes true when the box is undecided and smaller ones near it
  /// would be, too.
  TrimSide Classify(
    const std::array<double, 2>& low, const std::array<double, 2>& high, bool* hopeless = nullptr) const;

private:
  struct Chord
  {
    std::array<double, 2> From;
    std::array<double, 2> To;
    int Curve;
  };
  void AddLoop(const Loop& loop, const std::array<double, 2>& tolerance);
  int GetWinding(const std::array<double, 2>& point) const;

  std::vector<Chord> Chords;
  /// Chords by rows of equal height in v, for the search.
  std::vector<std::vector<int>> Rows;
  double RowStart = 0.0;
  double RowHeight = 1.0;
  int GetRow(double v) const;
  /// Largest distance of the chords of each curve from it, in u and in v; and the largest in v of all.
  std::vector<std::array<double, 2>> Deviations;
  double Largest = 0.0;
  bool Everything = false;
};
}

#endif
