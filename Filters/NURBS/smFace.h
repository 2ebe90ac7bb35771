/**
 * @file smFace.h
 * @brief Faces, loops, coedges, edges and vertices of a trimmed NURBS model: immutable values
 *
 * A face and an edge never change once they are shared. An edit makes a new face (with a new id) and
 * swaps one pointer in a shallow copy of the model. Data kept for a face (GPU memory, moments) is
 * keyed by its id. All coordinates are relative to the model's origin, see vtkTrimmedNURBSModel.
 */
#ifndef smFace_h
#define smFace_h

#include "smFiltersNURBSModule.h"

#include "smNURBSSurface.h"
#include "smPolynomialCurve.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace sm
{
struct EdgeOrigin;

/// An edge: the 3D curve that its faces share, and its two vertices.
struct Edge
{
  /// Id unique within the process, see NewId().
  std::uint64_t Id = 0;
  /// Entity number and name in the file, e.g. 1234 for #1234; 0 and empty when it has none.
  std::int64_t FileId = 0;
  std::string Name;
  /// C_e(t). Any fixed common curve closes the chain, so a curve that is not a piecewise polynomial is
  /// refitted to rounding level. A degenerate edge (a pole) has one piece of degree 0 at its vertex.
  EdgeCurve Curve;
  std::array<double, 3> StartVertex{};
  std::array<double, 3> EndVertex{};
  /// The file's tolerance of edge and vertices, a length. For information only: it is not reliable.
  double Tolerance = 0.0;
  bool Degenerate = false;
  /// Not null where an edit moved the edge along with the boundary rows of its faces, see smModelEdit.h: its
  /// origin.
  std::shared_ptr<const EdgeOrigin> Origin;
};

/// One use of an edge by a face.
struct Coedge
{
  std::shared_ptr<const Edge> Use;
  /// True when the loop runs against the edge's parameter.
  bool Reversed = false;
  /// c(t) in the face's own (u,v), over the edge's own parameter range (Curve.GetStart() .. GetEnd()).
  TrimCurve Curve;
};

/// A closed chain of coedges in loop direction: the face lies to its left in the (u,v) plane of the
/// surface (counter-clockwise outer loop), whatever Face::Reversed says.
struct Loop
{
  std::vector<Coedge> Coedges;
};

struct Face
{
  /// Id unique within the process, see NewId().
  std::uint64_t Id = 0;
  /// Entity number and name in the file; 0 and empty when it has none.
  std::int64_t FileId = 0;
  std::string Name;
  NURBSSurface Surface;
  /// True when the solid's outward normal is -(Su x Sv).
  bool Reversed = false;
  /// Empty: the whole domain of the surface is covered.
  std::vector<Loop> Loops;
  /// Display colour, r g b in [0,1]; negative: none given.
  std::array<double, 3> Color{ -1.0, -1.0, -1.0 };
  /// Notes of the reader on what it could not convert exactly, one sentence each; empty for a sound face.
  std::vector<std::string> Messages;
};

using FacePointer = std::shared_ptr<const Face>;

/// A process-wide unique id for a new face or edge. Thread safe.
SMFILTERSNURBS_EXPORT std::uint64_t NewId();

/// Bytes that the face occupies in memory.
SMFILTERSNURBS_EXPORT std::size_t GetMemorySize(const Face& face);
}

#endif
