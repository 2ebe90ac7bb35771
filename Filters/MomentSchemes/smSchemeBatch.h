/**
 * @file smSchemeBatch.h
 * @brief Tiles of sub-patches as the paper's schemes evaluate them, in flat lists for the GPU or the CPU
 *
 * A **tile** is a block of sub-patches of one face, small enough for its texels and result rows to fit anywhere. How a face is
 * cut into tiles depends on nothing but the face and the options, so that its sums are the same bits in any company.
 */
#ifndef smSchemeBatch_h
#define smSchemeBatch_h

#include "smFiltersMomentSchemesModule.h"
#include "smSubPatches.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace sm
{
/// Results of a sub-patch, in this order: the integrals as in smMassIntegrands.h (V X Y Z XX YY ZZ XY YZ XZ, vector area, area), then
/// the paper's estimate without and with the sub-patches on a trim boundary.
enum SchemeColumn
{
  SchemeEstimate = 14,
  SchemeEstimateWithBoundary = 15,
  NumberOfSchemeColumns = 16
};

/// A block of sub-patches of a face.
struct TileRange
{
  std::size_t Face = 0;
  std::uint32_t Column = 0;
  std::uint32_t Row = 0;
  std::uint32_t Columns = 0;
  std::uint32_t Rows = 0;

  std::size_t GetNumberOfSubPatches() const { return static_cast<std::size_t>(this->Columns) * this->Rows; }
};

/// Cuts the sub-patches of a face into tiles, from bottom to top. Nothing of a planar face.
SMFILTERSMOMENTSCHEMES_EXPORT std::vector<TileRange> MakeTiles(
  std::size_t index, const SubPatchFace& face, int textureFactor);

/// As smSchemeTile in glsl/smSchemeTile.glsl, std430.
struct SchemeTile
{
  std::uint32_t Begin[4];
  std::uint32_t Grid[4];
  std::uint32_t Shape[4];
  std::uint32_t Values[4];
  std::uint32_t Texels[4];
};
static_assert(sizeof(SchemeTile) == 80, "layout of smSchemeTile");

/// As smSchemePatch there.
struct SchemePatch
{
  double Center[4];
  std::uint32_t Shape[4];
  std::uint32_t Padding[4];
};
static_assert(sizeof(SchemePatch) == 64, "layout of smSchemePatch");

/// Degrees in u and v that a kernel is compiled for; 0 0: any.
using SchemeKernel = std::pair<int, int>;

/// The kernel for a face. The choice depends on nothing but its degrees.
SMFILTERSMOMENTSCHEMES_EXPORT SchemeKernel ChooseSchemeKernel(const SubPatchFace& face);

/// Tiles that are evaluated at once, those of one kernel side by side.
class SMFILTERSMOMENTSCHEMES_EXPORT SchemeBatch
{
public:
  /// Adds a tile of `face` unless a list would exceed `maximumBytes`, or the batch has enough; then false. The first tile always
  /// finds room.
  bool Add(const TileRange& range, const SubPatchFace& face, int textureFactor, std::size_t maximumBytes);

  /// Bytes of the largest list that a face needs for itself, apart from its trim curves.
  static std::size_t GetFaceBytes(const SubPatchFace& face);

  std::vector<std::array<double, 4>> Points;
  std::vector<SchemePatch> Patches;
  /// Borders, deviations and trim curves of the tiles.
  std::vector<double> Values;
  std::vector<SchemeTile> Tiles;
  /// Whose they are.
  std::vector<TileRange> Ranges;
  /// What the invocations of the three steps count.
  std::uint32_t SubPatches = 0;
  std::uint32_t Trims = 0;
  std::uint32_t TexelRows = 0;
  std::uint32_t Texels = 0;

  /// Sub-patches [First, Last) that one kernel evaluates, and the highest degrees among them.
  struct Part
  {
    SchemeKernel Kernel;
    std::uint32_t First;
    std::uint32_t Last;
    int Degree[2];
  };
  std::vector<Part> Parts;

private:
  void AddFace(const SubPatchFace& face);

  /// Of the face that the last tile is of.
  const SubPatchFace* Last = nullptr;
  std::uint32_t FirstPatch = 0;
};
}

#endif
