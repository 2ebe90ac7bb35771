/**
 * @file smFaceStatement.h
 * @brief What a file states about a face in space, without parameters of its surface
 */
#ifndef smFaceStatement_h
#define smFaceStatement_h

#include "smLineIntegrals.h"

#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

namespace sm
{
/// Surfaces by the size of the two parts into which a loop divides them.
enum class SurfaceExtent
{
  /// One part is infinite, or nothing is known.
  Open,
  /// Both are finite: a sphere, a torus.
  Closed
};

/// Use of an edge by a face, in the direction of its bound.
struct EdgeUseStatement
{
  std::uint64_t Edge = 0;
  bool IsForward = true;
  /// True for a part of a circle or an ellipse: the rest of the curve connects the same vertices.
  bool IsArc = false;
};

/// A torus whose minor radius exceeds the major one: it crosses itself.
struct SpindleTorus
{
  Vector3 Origin{};
  Vector3 Axis{};
  double Major = 0.0;
  /// 0: the surface is none.
  double Minor = 0.0;
};

struct FaceStatement
{
  std::uint64_t Id = 0;
  /// False if the file has a bound or a curve that is not understood: the face is not checked.
  bool IsKnown = false;
  /// True if the face's normal is that of the surface (same_sense).
  bool IsForward = true;
  SurfaceExtent Extent = SurfaceExtent::Open;
  /// Area of the whole surface; infinite for one that is not closed.
  double WholeArea = std::numeric_limits<double>::infinity();
  /// Volume that the whole surface encloses; NaN if it is not closed, or crosses itself.
  double WholeVolume = std::numeric_limits<double>::quiet_NaN();
  SpindleTorus Spindle;
  /// False if the orientation of the face's shell in its body is .F. (ORIENTED_CLOSED_SHELL).
  bool IsShellForward = true;
  /// Mean of the vertices.
  Vector3 Center{};
  /// Integrals along all bounds about the centre, in the directions of EDGE_CURVE, ORIENTED_EDGE and
  /// FACE_BOUND, which refer to the face's normal.
  LineIntegrals Boundary;
  /// Change of the vector area if each arc is replaced by the rest of its curve.
  Vector3 OtherArcs{};
  /// Largest gap between two edges of a bound.
  double MaxGap = 0.0;
  int EdgeLoops = 0;
  int VertexLoops = 0;
  /// Two edges that follow each other in a bound and cover the same part of one curve; 0: there are none.
  std::uint64_t Overlap[2] = { 0, 0 };
  std::vector<EdgeUseStatement> Uses;
};

/// Statements by the entity number of the face. Lengths are in millimetres.
using FaceStatements = std::unordered_map<std::uint64_t, FaceStatement>;
}

#endif
