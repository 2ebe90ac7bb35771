/**
 * @file smShellNesting.h
 * @brief Nesting of closed meshes, determined by winding numbers
 */
#ifndef smShellNesting_h
#define smShellNesting_h

#include "smVector.h"

#include "vtkBoundingBox.h"

#include <array>
#include <vector>

namespace sm
{
/// Triangles of one closed shell, or the sphere that it is.
class ShellMesh
{
public:
  /// Adds a triangle. The `normals` at the corners, unit or zero, determine how far the surface may deviate
  /// from the flat triangle.
  void AddTriangle(const std::array<Point3, 3>& corners, const std::array<Point3, 3>& normals);

  /// Makes the shell a sphere, which needs no triangles.
  void SetSphere(const Point3& center, double radius);

  bool IsEmpty() const { return this->Triangles.empty() && !(this->Radius > 0.0); }
  const vtkBoundingBox& GetBox() const { return this->Box; }

  /// Position of a shell with respect to another one.
  enum class Place
  {
    Inside,
    Outside,
    /// Parts of the shell lie on both sides.
    Crossing,
    /// No point of the shell is farther from the other one than the meshes may be from their surfaces.
    Unknown
  };

  /**
   * Returns the position of this shell with respect to another one. The winding number about the other's
   * triangles is computed at up to 24 points of this mesh near the other shell: 0 outside, 1 or -1 inside,
   * for either orientation of the other shell. It is a sum of solid angles, so that small holes between the
   * triangles of two faces have little effect. If points disagree, only those count whose distance from the
   * other mesh exceeds the possible distance of both meshes from their surfaces. A crossing smaller than the
   * distance between the points is not detected.
   *
   * Spheres are compared by formulas. Two of them that touch do not cross. The place of a shell with respect
   * to a sphere follows from the distances of its corners from the centre, and the place of a sphere from the
   * distance of its centre from all triangles, and from the winding number there: every crossing of a sphere
   * that is deeper than the triangles may be from their surfaces is detected.
   */
  Place Find(const ShellMesh& other) const;

private:
  struct Triangle
  {
    std::array<Point3, 3> Corners;
    /// Largest distance between the triangle and the surface.
    double Deviation;
  };
  struct Sample
  {
    Point3 Position;
    double Deviation;
  };
  static void AddSamples(const std::array<Point3, 3>& corners, double deviation, const vtkBoundingBox& region,
    int depth, std::vector<Sample>& samples);
  std::vector<Sample> TakeSamples(const vtkBoundingBox& box) const;
  double GetWindingNumber(const Point3& p) const;
  bool IsFarFrom(const Sample& sample) const;
  double GetRounding() const;
  Place FindSphereInSphere(const ShellMesh& other) const;
  Place FindMeshInSphere(const ShellMesh& other) const;
  Place FindSphereInMesh(const ShellMesh& other) const;

  std::vector<Triangle> Triangles;
  /// The sphere; Radius 0: there are triangles.
  Point3 Center{};
  double Radius = 0.0;
  vtkBoundingBox Box;
};
}

#endif
