/**
 * @file smNetGradient.h
 * @brief Gradients of the moments and the area of one face by its control points and weights
 *
 * In stored coordinates of the model, moments about their origin, outwards as the face says. Each control
 * point and weight is a variable of its own.
 */
#ifndef smNetGradient_h
#define smNetGradient_h

#include "smFacePanelsCache.h"
#include "smPatchGradient.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace sm
{
/// Derivatives of the ten moments and of the area, in this order.
constexpr int NumberOfIntegrals = NumberOfMoments + 1;

struct NetGradient
{
  int Count[2] = { 0, 0 };
  /// Derivatives by x, y, z and the weight (0 .. 3) of control point (i,j) of the face's net, and their
  /// bounds: NaN where unknown.
  std::vector<double> Values;
  std::vector<double> Bounds;
  std::int64_t Evaluations = 0;

  std::size_t GetIndex(int i, int j, int component) const
  {
    return NumberOfIntegrals * (4 * (static_cast<std::size_t>(i) * this->Count[1] + j) + component);
  }
};

/// Bounds of ribbons and caps of one face.
struct FaceStrips
{
  std::vector<StripBound> Ribbons;
  /// The area of all ribbons along each coedge, counted through all loops.
  std::vector<double> Coedges;
  /// The area of all caps, and of the ribbons at corners, which lead from a vertex to the face.
  double Corners = 0.0;
  /// Largest distance of patches and ribbons from the origin.
  double Reach = 0.0;

  /// `tolerance`: an area that is negligible.
  static FaceStrips Make(const CutFace& face, double tolerance);
  /// Strips without an area.
  static FaceStrips MakeWithout(const CutFace& face);
};

/// Bounds of the areas of ribbons and caps by the edge and the vertex that moves them.
struct BodyStrips
{
  struct Use
  {
    std::size_t Face;
    int Coedge;
    double Area;
  };
  std::map<const Edge*, std::vector<Use>> Edges;
  /// The faces at each vertex, by its coordinates, each once.
  std::map<std::array<double, 3>, std::vector<std::size_t>> Vertices;
  /// FaceStrips::Corners of each face.
  std::vector<double> Corners;

  void Add(const Face& face, const FaceStrips& strips);
};

struct NetGradientTask
{
  const CutFace* Cut = nullptr;
  const FaceStrips* Strips = nullptr;
  const BodyStrips* Body = nullptr;
  /// Index of the face in Body.
  std::size_t Index = 0;
  /// Largest distance of the body from the origin.
  double Reach = 0.0;
  /// Absolute tolerance of a derivative of the volume by a control point, and the length that scales those of
  /// higher moments.
  double Tolerance = 0.0;
  double Length = 1.0;
};

/// The integrals that the gradient of a face needs, and what their bounds add.
struct NetGradientPlan
{
  std::vector<PatchPlan> Plans;
  /// Of the patches that have panels.
  std::vector<PatchTask> Patches;
};

/// The three steps of a gradient; each throws std::bad_alloc and is thread safe. `sums` are
/// ComputePatchSums() of the plan's patches. Tasks point to the plan, which is moved but not copied.
NetGradientPlan PlanNetGradient(const NetGradientTask& task);
NetGradient FinishNetGradient(
  const NetGradientTask& task, const NetGradientPlan& plan, const PatchSums* sums);
}

#endif
