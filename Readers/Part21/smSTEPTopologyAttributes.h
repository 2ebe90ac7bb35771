/**
 * @file smSTEPTopologyAttributes.h
 * @brief Attributes of faces, bounds, loops and edges
 */
#ifndef smSTEPTopologyAttributes_h
#define smSTEPTopologyAttributes_h

#include "smSTEPAttributes.h"

namespace sm
{
constexpr STEPAttribute LoopOfBound = { "FACE_BOUND", 0, 1, "bound" };
constexpr STEPAttribute SenseOfBound = { "FACE_BOUND", 1, 2, "orientation" };
constexpr STEPAttribute EdgesOfLoop = { "PATH", 0, 1, "edges" };
constexpr STEPAttribute EdgeOfOriented = { "ORIENTED_EDGE", 0, 3, "edge" };
constexpr STEPAttribute SenseOfOriented = { "ORIENTED_EDGE", 1, 4, "orientation" };
constexpr STEPAttribute SurfaceOfFace = { "FACE_SURFACE", 0, 2, "surface" };
constexpr STEPAttribute SenseOfFace = { "FACE_SURFACE", 1, 3, "same sense" };
constexpr STEPAttribute StartOfEdge = { "EDGE", 0, 1, "start" };
constexpr STEPAttribute EndOfEdge = { "EDGE", 1, 2, "end" };
constexpr STEPAttribute PointOfVertex = { "VERTEX_POINT", 0, 1, "point" };
constexpr STEPAttribute CurveOfEdge = { "EDGE_CURVE", 0, 3, "geometry" };
constexpr STEPAttribute CurveInSpace = { "SURFACE_CURVE", 0, 1, "3D curve" };
}

#endif
