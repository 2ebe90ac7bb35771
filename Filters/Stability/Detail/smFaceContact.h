/**
 * @file smFaceContact.h
 * @brief A face in the ground's frame: its patches, trim curves and creases, and their parts inside the
 * loops; not installed
 */
#ifndef smFaceContact_h
#define smFaceContact_h

#include "smFacePanelsCache.h"
#include "smGroundNet.h"
#include "smSupportPolygon.h"
#include "smTrimClassifier.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace sm
{
inline Point2 Project(const GroundPoint& p)
{
  return { p[0] / p[3], p[1] / p[3] };
}

inline double GetHeight(const GroundPoint& p)
{
  return p[2] / p[3];
}

/// A curve on a face: a piece of a trim curve in one patch, or (Clipped) a border of a patch, of which a part
/// is inside the loops.
struct Segment
{
  int Patch = 0;
  /// Index of the ribbon; -1: the border given by Direction and End.
  int Ribbon = -1;
  int Direction = 0;
  int End = 0;
  bool Clipped = false;
  int Coedge = -1;
  std::int64_t EdgeId = 0;
  GroundCurve Curve;
  bool Composed = false;
};

struct FaceContact
{
  CutFacePointer Cut;
  GroundFrame Frame;
  double Low = 0.0;
  bool Ready = false;
  std::vector<GroundPatch> Patches;
  std::vector<HeightRange> Heights;
  std::vector<Segment> Segments;
  std::unique_ptr<TrimClassifier> Region;

  void Prepare();
  void Compose(Segment& segment);
  TrimSide Classify(int patch, const double low[2], const double high[2], bool* hopeless = nullptr) const;
  TrimSide Classify(const Segment& segment, const GroundCurve& curve, bool* hopeless = nullptr) const;
  TrimSide Classify(int patch, const GroundPatch& box, bool* hopeless = nullptr) const
  {
    return this->Classify(patch, box.Low, box.High, hopeless);
  }
  /// (s, r) of a curve's parameter.
  std::array<double, 2> GetParameters(const Segment& segment, double t) const;

private:
  void AddBorders();
  bool IsCrease(int direction, double knot) const;
};

/// The knot at an end of a patch, and whether the face's domain ends there.
struct BorderKnot
{
  int Direction;
  double Value;
  bool Outer;
};

BorderKnot GetBorderKnot(const NURBSSurface& surface, const Patch& patch, int direction, int end);
}

#endif
