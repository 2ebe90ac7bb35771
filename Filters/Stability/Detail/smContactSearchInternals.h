/**
 * @file smContactSearchInternals.h
 * @brief State and constants of ContactSearch, shared by its source files: the searches for the minimum
 * height and for contacts; not installed
 */
#ifndef smContactSearchInternals_h
#define smContactSearchInternals_h

#include "smFaceContact.h"
#include "smGroundContact.h"
#include "smUnitRoundoff.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <vector>

namespace sm
{
// Rounding of a height, in units of u times the size: compositions have degrees up to some hundred, and each
// of their products is rounded.
constexpr double RoundingUnits = 512.0;
// Accuracy, relative to the size, to which contacts are located and corners distinguished.
constexpr double RelativeResolution = 1e-13;
constexpr int MaximumNets = 40000;
inline const double MinWidth = std::ldexp(1.0, -50);
// Cosine of an angle of 1e-3 radians between surface and ground, up to which they count as tangent.
constexpr double TangentCosine = 1.0 - 5e-7;

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// An entry of the priority queue: a control net that is still to be divided, the lowest first.
struct Candidate
{
  double Low;
  /// Index of the segment, or -1 - index of the patch.
  int Owner;
  GroundCurve Curve;
  GroundPatch Box;
  bool operator<(const Candidate& other) const { return this->Low > other.Low; }
};

struct ContactSearch::Internals
{
  std::vector<FaceContact> Faces;
  double Size = 0.0;
  /// The minimum height that a point of a trimmed face is known to have.
  double Reached = Infinity;

  // Results of FindContacts.
  double Limit = 0.0;
  GroundContacts Found;
  /// Hull of the contacts that are certain.
  SupportPolygon Certain;

  /// Returns the factor between the rounding of coefficients and that of slopes: the degree times the largest
  /// weight.
  static double GetSlackFactor(const std::vector<GroundPoint>& points, double degree)
  {
    double weight = 0.0;
    for (const GroundPoint& p : points)
    {
      weight = std::max(weight, p[3]);
    }
    return degree * weight;
  }
  double GetRounding() const { return RoundingUnits * UnitRoundoff * this->Size; }
  double GetResolution() const { return RelativeResolution * this->Size; }
  double GetSlack(const GroundPatch& root) const
  {
    return 64.0 * UnitRoundoff * this->Size *
      GetSlackFactor(root.Points, std::max(root.Degree[0], root.Degree[1]));
  }
  double GetSlack(const GroundCurve& root) const
  {
    // A composition of degree n is rounded n times.
    const double degree = static_cast<double>(root.Points.size());
    return 16.0 * degree * UnitRoundoff * this->Size * GetSlackFactor(root.Points, degree);
  }

  /// Returns false if the segment is certainly above a height; a coarse test without composition.
  bool MayReach(const FaceContact& face, const Segment& segment, double height) const;
  void Reach(double height) { this->Reached = std::min(this->Reached, height); }

  double BoundFace(FaceContact& face);
  bool StepCurve(FaceContact& face, Candidate& item, std::priority_queue<Candidate>& queue, double& low);
  bool StepPatch(FaceContact& face, Candidate& item, std::priority_queue<Candidate>& queue, double& low);

  void AddSample(const FaceContact& face, int patch, std::array<double, 2> sr, const Point2& position);
  static std::uint32_t FindDirections(
    const FaceContact& face, int patch, const std::array<double, 2>& sr, const GroundPatch::Shape& shape);
  static std::uint32_t FindPoleDirections(const FaceContact& face, int patch, std::array<double, 2> sr);
  void AddPoint(const FaceContact& face, const Segment& segment, double t, const GroundPoint& point);
  void AddCurve(const FaceContact& face, const Segment& segment, const GroundCurve& curve);
  void FindOnTrims(FaceContact& face);
  void FindOnCurve(FaceContact& face, const Segment& segment);
  void FindOnBorder(FaceContact& face, const Segment& segment, const GroundCurve& root, bool whole);
  void FindOnPatch(FaceContact& face, int patch);
  void FindArea(FaceContact& face, int patch);
  /// Returns the size of the enclosure of a stationary point; for a strip, its width.
  double AddLeaf(const FaceContact& face, int patch, const GroundPatch& box, bool inside);
  bool IsCovered(const std::vector<GroundPoint>& points) const;
  void UpdateCertain();
};
}

#endif
