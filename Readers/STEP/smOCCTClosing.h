/**
 * @file smOCCTClosing.h
 * @brief Whether the edges of a converted body meet: at their vertices, and around the loops of a face
 */
#ifndef smOCCTClosing_h
#define smOCCTClosing_h

#include "smFace.h"
#include "smOCCTLoop.h"

#include <memory>
#include <vector>

namespace sm
{
/// A gap below that part of the body's size leaves the loop closed, whatever the file's tolerances say.
constexpr double LoopTolerance = 1e-5;

/// A vertex's tolerance beyond that part of the body's size excuses no gap.
constexpr double VertexTolerance = 1e-3;

/// Diagonal of the box around all edges; null ones do not count.
double MeasureSize(const std::vector<std::shared_ptr<const Edge>>& edges);

/// The larger distance of the curve's ends from the vertices of the edge.
double GetVertexGap(const Edge& edge);

/// Counts the places where loops do not close as defects of the draft, and writes a message. Loops are judged in space, against the
/// tolerances the file states; `unit` is that of the draft's shape, `size` the body's, in the face's unit.
void CheckClosing(double unit, double size, DraftFace& draft, Face& face);
}

#endif
