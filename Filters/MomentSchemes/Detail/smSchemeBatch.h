/**
 * @file smSchemeBatch.h
 * @brief Tiles of sub-patches for the paper's schemes, in flat lists for the GPU or the CPU
 *
 * A **tile** is a block of sub-patches of one face whose texels and result rows fit into any storage block.
 * The division of a face into tiles depends only on the face and the options, so that its sums are bitwise
 * the same in any batch.
 */
#ifndef smSchemeBatch_h
#define smSchemeBatch_h

#include "smFiltersMomentSchemesModule.h"
#include "smSubPatches.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace sm
{
/// Columns of the results of a sub-patch: the integrals as in smMassIntegrands.h (V X Y Z XX YY ZZ XY YZ XZ,
/// vector area, area), then the paper's estimate without and with the sub-patches on a trim boundary.
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

/// Divides the sub-patches of a face into tiles, from bottom to top. A planar face has none.
SMFILTERSMOMENTSCHEMES_EXPORT std::vector<TileRange> MakeTiles(
  std::size_t index, const SubPatchFace& face, int textureFactor);

/// A tile in the layout (std430) of smSchemeTile in glsl/smSchemeTile.glsl.
struct SchemeTile
{
  std::uint32_t Begin[4];
  std::uint32_t Grid[4];
  std::uint32_t Shape[4];
  std::uint32_t Values[4];
  std::uint32_t Texels[4];
};
static_assert(sizeof(SchemeTile) == 80, "layout of smSchemeTile");

/// A patch in the layout (std430) of smSchemePatch there.
struct SchemePatch
{
  double Center[4];
  std::uint32_t Shape[4];
  std::uint32_t Padding[4];
};
static_assert(sizeof(SchemePatch) == 64, "layout of smSchemePatch");

/// Degrees in u and v that a kernel is compiled for; 0 0 for any degrees.
using SchemeKernel = std::pair<int, int>;

/// Returns the kernel for a face. The choice depends only on the face's degrees.
SMFILTERSMOMENTSCHEMES_EXPORT SchemeKernel ChooseSchemeKernel(const SubPatchFace& face);

/// Tiles that are evaluated together. Tiles of the same kernel are adjacent.
class SMFILTERSMOMENTSCHEMES_EXPORT SchemeBatch
{
public:
  /// Adds a tile of `face`. Returns false if a list would exceed `maximumBytes` or the batch is full; the
  /// first tile is always added.
  bool Add(const TileRange& range, const SubPatchFace& face, int textureFactor, std::size_t maximumBytes);

  /// Returns the bytes of the largest list that a face needs by itself, without its trim curves.
  static std::size_t GetFaceBytes(const SubPatchFace& face);

  std::vector<std::array<double, 4>> Points;
  std::vector<SchemePatch> Patches;
  /// Borders, deviations and trim curves of the tiles.
  std::vector<double> Values;
  std::vector<SchemeTile> Tiles;
  /// The face and block of each tile.
  std::vector<TileRange> Ranges;
  /// Numbers of invocations of the three steps (sub-patches, parts of trim curves, rows of texels), and
  /// number of texels.
  std::uint32_t SubPatches = 0;
  std::uint32_t Trims = 0;
  std::uint32_t TexelRows = 0;
  std::uint32_t Texels = 0;

  /// Range of sub-patches [First, Last) that one kernel evaluates, and the highest degrees among them.
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

  /// The face of the last tile, and the index of its first patch.
  const SubPatchFace* Last = nullptr;
  std::uint32_t FirstPatch = 0;
};
}

#endif
