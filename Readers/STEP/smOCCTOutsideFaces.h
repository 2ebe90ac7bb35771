/**
 * @file smOCCTOutsideFaces.h
 * @brief Faces of which OpenCASCADE's repair takes the wrong part of their surface
 */
#ifndef smOCCTOutsideFaces_h
#define smOCCTOutsideFaces_h

#include <TopoDS_Shape.hxx>

#include <vector>

namespace sm
{
/**
 * Returns the faces of a body on a closed surface, such as a sphere or torus, that lie outside their loops
 * (AddNaturalBoundary()). OpenCASCADE's repair reverses such loops, so that the part inside remains and the
 * sides of the other faces are adapted to it: the result is closed, and wrong.
 */
std::vector<TopoDS_Shape> FindOutsideFaces(const TopoDS_Shape& body);
}

#endif
