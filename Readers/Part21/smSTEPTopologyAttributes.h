/**
 * @file smSTEPTopologyAttributes.h
 * @brief Attributes of bounds, loops and edges
 */
#ifndef smSTEPTopologyAttributes_h
#define smSTEPTopologyAttributes_h

#include "smSTEPAttributes.h"

namespace sm
{
constexpr STEPAttribute LoopOfBound = { "FACE_BOUND", 0, 1, "bound" };
constexpr STEPAttribute EdgesOfLoop = { "PATH", 0, 1, "edges" };
constexpr STEPAttribute EdgeOfOriented = { "ORIENTED_EDGE", 0, 3, "edge" };
constexpr STEPAttribute StartOfEdge = { "EDGE", 0, 1, "start" };
constexpr STEPAttribute EndOfEdge = { "EDGE", 1, 2, "end" };
constexpr STEPAttribute PointOfVertex = { "VERTEX_POINT", 0, 1, "point" };
constexpr STEPAttribute CurveOfEdge = { "EDGE_CURVE", 0, 3, "geometry" };
constexpr STEPAttribute CurveInSpace = { "SURFACE_CURVE", 0, 1, "3D curve" };
}

#endif
