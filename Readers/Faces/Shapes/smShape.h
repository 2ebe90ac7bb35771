/**
 * @file smShape.h
 * @brief Solids, shells, faces, edges and vertices of a file on their native geometry
 *
 * | shape | has | an oriented use of it |
 * |---|---|---|
 * | SolidShape | shells | SolidUse |
 * | ShellShape | faces | ShellUse |
 * | FaceShape | a surface, and wires of edges | FaceUse |
 * | EdgeShape | a curve between two vertices | CoedgeShape, with its curve in the parameters of the face |
 *
 * Shapes that are shared are one object: two faces meet at an edge if they use the same EdgeShape. All
 * placements of a file within a solid or shell are part of its faces, edges and vertices. Lengths are in
 * millimetres, angles in radians. A shape does not change once its file has been read.
 */
#ifndef smShape_h
#define smShape_h

#include "Geometry/smPeriodicSurface.h"
#include "Geometry/smPlacement.h"

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace sm
{
struct DraftFace;

/// Tolerance of edges and vertices for which a file states none.
constexpr double DefaultTolerance = 1e-7;

/// Largest number of instances of bodies and sub-assemblies that are read. Each becomes a node of the tree,
/// and each instance of a body a leaf with points of its own.
constexpr std::uint64_t MaxInstances = 100000;

/// What a file states about a shape besides its geometry.
struct ShapeData
{
  /// Number of the entity; 0: none.
  std::int64_t FileId = 0;
  std::string Name;
  /// Red, green, blue from 0 to 1; negative: none.
  Vector3 Color{ -1.0, -1.0, -1.0 };
};

struct VertexShape
{
  Vector3 Point{};
  double Tolerance = DefaultTolerance;
};
using VertexPointer = std::shared_ptr<VertexShape>;

struct EdgeShape
{
  ShapeData Data;
  /// Null for a pole, and for an edge that has only curves in the parameters of its faces.
  CurvePointer<3> Curve;
  /// Part of the curve, First < Last.
  double First = 0.0;
  double Last = 0.0;
  /// From the coordinates of Curve to those of the body.
  Placement Location;
  /// Vertices at First and at Last; null: none.
  VertexPointer Start;
  VertexPointer End;
  double Tolerance = DefaultTolerance;
  /// True for a line of constant parameter that is one point of its surface.
  bool Degenerate = false;

  Vector3 Evaluate(double t) const { return this->Location.MapPoint(this->Curve->Evaluate(t)); }
  /// Returns the point that divides it as `fraction`, from 0 to 1, divides its parameters.
  Vector3 EvaluateAt(double fraction) const
  {
    return this->Evaluate((1.0 - fraction) * this->First + fraction * this->Last);
  }
  bool HasCurve() const { return this->Curve && this->Last > this->First; }
};
using EdgePointer = std::shared_ptr<EdgeShape>;

/// A use of an edge by a face.
struct CoedgeShape
{
  EdgePointer Edge;
  /// True if the wire runs against the edge.
  bool Reversed = false;
  /// The edge in the parameters of the face's surface, in its direction; null: none.
  CurvePointer<2> Trim;
  double First = 0.0;
  double Last = 0.0;
};

struct WireShape
{
  std::vector<CoedgeShape> Coedges;
  /// True if the coedges are in the opposite order. The flags of coedges include it.
  bool Reversed = false;
};

struct FaceShape
{
  ShapeData Data;
  SurfacePointer Surface;
  /// Part of the surface that the file names, in directions in which it is less than the surface's domain.
  ParameterRange Range[2];
  /// From the coordinates of Surface to those of the body.
  Placement Location;
  /// The face is on the left of its wires, seen against the normal of the surface.
  std::vector<WireShape> Wires;
  /// True if the file has bounds for it.
  bool Bounded = false;
  /// The surface of the file, if Surface was made periodic.
  FileSurface Own;
  /// The completed loops of a face that was not repaired; null for other faces. They refer to this face.
  std::shared_ptr<const DraftFace> Completed;
  /// The face that a repair made this one of; null if it was not repaired, or if that is not known.
  std::shared_ptr<FaceShape> Source;

  bool IsTrimmed(int direction) const
  {
    return std::isfinite(this->Range[direction].Low) || std::isfinite(this->Range[direction].High);
  }
  /// Returns the part of the surface that the file names.
  ParameterRange GetDomain(int direction) const
  {
    return this->IsTrimmed(direction) ? this->Range[direction] : this->Surface->GetDomain(direction);
  }
};
using FaceShapePointer = std::shared_ptr<FaceShape>;

struct FaceUse
{
  FaceShapePointer Face;
  /// True if the outer side is against the normal of the surface.
  bool Reversed = false;
};

struct ShellShape
{
  ShapeData Data;
  std::vector<FaceUse> Faces;
  /// Number of faces of the file that are left out.
  int LostFaces = 0;
  /// True for a shell that the file declares as a solid, and of which a repair made none.
  bool OpenSolid = false;
  /// True if the file states that it is closed.
  bool Closed = false;
};
using ShellPointer = std::shared_ptr<ShellShape>;

struct ShellUse
{
  ShellPointer Shell;
  bool Reversed = false;
  /// Of a shell that is not part of a solid.
  Placement Location;
};

struct SolidShape
{
  ShapeData Data;
  std::vector<ShellUse> Shells;
};
using SolidPointer = std::shared_ptr<SolidShape>;

struct SolidUse
{
  SolidPointer Solid;
  bool Reversed = false;
  Placement Location;
};

/// What a body of a file is: mostly one solid, or some shells.
struct ShapeGroup
{
  std::vector<SolidUse> Solids;
  /// Shells that are not part of a solid, and faces that are not part of a shell.
  std::vector<ShellUse> Shells;
  std::vector<FaceUse> Faces;

  bool IsEmpty() const { return this->Solids.empty() && this->Shells.empty() && this->Faces.empty(); }
};

/// One solid, one shell, or loose faces, without a placement of its own.
struct BodyShape
{
  bool IsSolid = false;
  std::vector<ShellUse> Shells;
  std::vector<FaceUse> Faces;

  /// Calls visit(face) for each face, with its orientation in the body; first those of shells.
  template <class Visit>
  void VisitFaces(const Visit& visit) const
  {
    for (const ShellUse& shell : this->Shells)
    {
      for (const FaceUse& face : shell.Shell->Faces)
      {
        visit(FaceUse{ face.Face, face.Reversed != shell.Reversed });
      }
    }
    for (const FaceUse& face : this->Faces)
    {
      visit(face);
    }
  }
};

/// Returns a solid as a body.
SMREADERSFACES_EXPORT BodyShape MakeBody(const SolidUse& solid);
SMREADERSFACES_EXPORT BodyShape MakeBody(const ShellUse& shell);

/// Numbers objects in the order in which they are added.
template <class Key>
class PointerIndex
{
public:
  /// Returns the number of an object, which is added if it is new.
  int Add(const Key* key)
  {
    const auto [found, isNew] = this->Numbers.emplace(key, static_cast<int>(this->Keys.size()));
    if (isNew)
    {
      this->Keys.push_back(key);
    }
    return found->second;
  }
  /// Returns the number of an object; -1 if it was not added.
  int Find(const Key* key) const
  {
    const auto found = this->Numbers.find(key);
    return found == this->Numbers.end() ? -1 : found->second;
  }
  std::size_t GetSize() const { return this->Keys.size(); }
  const Key* operator[](std::size_t number) const { return this->Keys[number]; }

private:
  std::unordered_map<const Key*, int> Numbers;
  std::vector<const Key*> Keys;
};
using EdgeIndex = PointerIndex<EdgeShape>;

/// Adds the natural boundary of its surface to a face without wires: seams where the surface is closed, poles
/// where a border is one point. Returns false if the surface has no such boundary.
SMREADERSFACES_EXPORT bool AddNaturalWires(FaceShape& face);
}

#endif
