/**
 * @file smPointLayout.h
 * @brief The display points of a mesh by face and Bezier patch, ready to be evaluated on edited faces
 */
#ifndef smPointLayout_h
#define smPointLayout_h

#include "smFacePanelsCache.h"
#include "smFiltersNURBSModule.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class vtkDataArray;

namespace sm
{
/// Location of a display point: the patch of its face, and its parameters there.
struct LocalPoint
{
  double S;
  double R;
  std::uint32_t Patch;
  /// Index of the face in the model.
  std::uint32_t Face;
};

/**
 * Points are sorted by face, those of a face by patch. The points of a face are located when the face is
 * first asked for, and again when its knots change. Only patches with points are listed, u fastest; a point
 * outside the surface's domain belongs to the nearest patch.
 */
class SMFILTERSNURBS_EXPORT PointLayout
{
public:
  /// Arrays of a mesh's points, one tuple each; `parameters` must live, unchanged, as long as MakePatches()
  /// is called. Indices below 0 and from `faces` on belong to no face.
  PointLayout(vtkDataArray* faceIndex, vtkDataArray* parameters, std::size_t faces);

  /// Points of one face, in GetIds() and GetPoints().
  std::size_t GetFirst(std::size_t face) const { return this->Firsts[face]; }
  std::size_t GetCount(std::size_t face) const { return this->Firsts[face + 1] - this->Firsts[face]; }
  std::size_t GetNumberOfFaces() const { return this->Firsts.size() - 1; }

  /// The patches of `face`, which stands at `index`, without panels, ribbons and caps; locates its points
  /// where that is needed. Thread safe for different indices.
  CutFacePointer MakePatches(const FacePointer& face, std::size_t index);

  /// Indices of the points in the mesh, and their patches and parameters; valid for faces for which
  /// MakePatches() was called.
  const std::vector<std::int64_t>& GetIds() const { return this->Ids; }
  const std::vector<LocalPoint>& GetPoints() const { return this->Points; }
  /// Counts how often the points of a face were located.
  std::uint64_t GetVersion(std::size_t face) const { return this->Faces[face].Version; }

private:
  struct FacePatches
  {
    std::vector<double> Knots[2];
    int Degree[2] = { 0, 0 };
    /// Spans (u, v) of the patches, as indices of breaks.
    std::vector<std::array<std::uint32_t, 2>> Cells;
    std::uint64_t Version = 0;
  };
  void Sort(const NURBSSurface& surface, std::size_t index);

  vtkDataArray* Parameters;
  std::vector<std::size_t> Firsts;
  std::vector<std::int64_t> Ids;
  std::vector<LocalPoint> Points;
  std::vector<FacePatches> Faces;
};

/// Position (x y z relative to the model's origin) and unit normal along Su x Sv of one point.
using PointAndNormal = std::array<double, 6>;

/**
 * Where |Ss x Sr| is below 1e-6 of what the patch's control points allow, at poles and other degenerate
 * edges, the normal is taken a 4096th of the way to the patch's middle; where it vanishes there, too, it is 0
 * 0 0. In Rendering/NURBS/glsl/smDisplayPoint.glsl, too.
 */
SMFILTERSNURBS_EXPORT PointAndNormal EvaluateDisplayPoint(
  const Patch& patch, const std::array<double, 4>* points, double s, double r);
}

#endif
