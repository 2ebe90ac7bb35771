/**
 * @file smEdgeSamples.h
 * @brief The points of an edge that all of its faces share
 */
#ifndef smEdgeSamples_h
#define smEdgeSamples_h

#include "smFiltersTessellationModule.h"

#include "smFace.h"
#include "smMeshLimits.h"
#include "smSurfaceBlocks.h"

#include <vector>

namespace sm
{
/// A face adjacent to an edge.
struct EdgeUse
{
  const SurfaceBlocks* Blocks;
  const TrimCurve* Trim;
};

/// Points of an edge.
struct EdgeSamples
{
  /// Parameters from the start of the edge to its end, increasing.
  std::vector<double> T;
  /// In (u,v) of the faces adjacent to the edge: T.size() points of the first use, then of the next.
  std::vector<std::array<double, 2>> At;
};

/**
 * Chords are within the deflection of the edge's curve: proved by the coefficients of the curve; and such
 * that along every chord the surfaces of its faces leave room for triangles (SurfaceBlocks::GetError()). At
 * least `minimum` chords; no more than 20,000, whatever that leaves.
 */
SMFILTERSTESSELLATION_EXPORT EdgeSamples SampleEdge(
  const Edge& edge, const std::vector<EdgeUse>& uses, const MeshLimits& limits, int minimum);

/// Sets EdgeSamples::At for its T.
void EvaluateTrims(const std::vector<EdgeUse>& uses, EdgeSamples& samples);

/// No less than the distance of the curve from the chord between parameters `low` and `high`.
SMFILTERSTESSELLATION_EXPORT double BoundSagitta(const EdgeCurve& curve, double low, double high);
}

#endif
