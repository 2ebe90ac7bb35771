/**
 * @file smClosing.h
 * @brief Checks that the edges of a converted body meet: at their vertices, and along the loops of a face
 */
#ifndef smClosing_h
#define smClosing_h

#include "smDraftFace.h"
#include "smFace.h"

#include <memory>
#include <vector>

namespace sm
{
/// A loop with gaps below this, relative to the body's size, is closed for any tolerances of the file.
constexpr double LoopTolerance = 1e-5;

/// Tolerances of vertices count up to this, relative to the body's size.
constexpr double VertexTolerance = 1e-3;

/// Returns the diagonal of the box of all edges; null pointers are ignored.
double MeasureSize(const std::vector<std::shared_ptr<const Edge>>& edges);

/// Returns the larger one of the distances of the curve's ends from the vertices of the edge.
double GetVertexGap(const Edge& edge);

/// Returns the largest distance that is not a defect; `size`: of the body.
double GetVertexLimit(const Edge& edge, double size);

/// Adds the number of places where loops are open to the defects of the draft, and writes a message. Gaps are
/// measured in space and compared with the tolerances of the file. `unit`: model lengths per millimetre;
/// `size`: of the body, in model lengths.
void CheckClosing(double unit, double size, DraftFace& draft, Face& face);
}

#endif
