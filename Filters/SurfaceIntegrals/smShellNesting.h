/**
 * @file smShellNesting.h
 * @brief Which closed mesh lies in which, told by winding numbers
 */
#ifndef smShellNesting_h
#define smShellNesting_h

#include "vtkBoundingBox.h"

#include <array>
#include <vector>

namespace sm
{
/// Triangles of one closed shell.
class ShellMesh
{
public:
  using Point = std::array<double, 3>;

  /// `normals` of the corners, unit or zero, say how far the surface may stand off a flat triangle.
  void AddTriangle(const std::array<Point, 3>& corners, const std::array<Point, 3>& normals);

  bool IsEmpty() const { return this->Triangles.empty(); }
  const vtkBoundingBox& GetBox() const { return this->Box; }

  enum class Place
  {
    Inside,
    Outside,
    /// Parts of it lie on both sides.
    Crossing,
    /// No point of it is farther from the other than the meshes are from the surfaces.
    Unknown
  };

  /**
   * Where this shell lies with respect to another. Up to 24 points of this mesh, those near the other shell, ask for
   * their winding number about the other's triangles: 0 outside, 1 or -1 inside, whichever way the other is
   * oriented. It is a sum of solid angles, so that small holes between the triangles of two faces do not matter.
   * Points that disagree are asked whether they are farther from the other mesh than both meshes may be from
   * their surfaces; only those count then. A crossing smaller than the distance of the points is not seen.
   */
  Place Find(const ShellMesh& other) const;

private:
  struct Triangle
  {
    std::array<Point, 3> Corners;
    /// Largest distance from the surface it stands for.
    double Deviation;
  };
  struct Sample
  {
    Point Position;
    double Deviation;
  };
  static void AddSamples(const std::array<Point, 3>& corners, double deviation, const vtkBoundingBox& region,
    int depth, std::vector<Sample>& samples);
  std::vector<Sample> TakeSamples(const vtkBoundingBox& box) const;
  double GetWindingNumber(const Point& p) const;
  bool IsFarFrom(const Sample& sample) const;

  std::vector<Triangle> Triangles;
  vtkBoundingBox Box;
};
}

#endif
