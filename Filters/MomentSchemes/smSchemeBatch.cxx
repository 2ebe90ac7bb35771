#include "smSchemeBatch.h"

#include <algorithm>

namespace sm
{
namespace
{
// Limits of a tile: the result rows of its sub-patches take 4 MiB, its texels 8 MiB.
constexpr std::size_t SubPatchesOfTile = 32768;
constexpr std::size_t TexelsOfTile = std::size_t{ 1 } << 21;
// Limits of a batch of more than one tile: the smallest storage block of OpenGL 4.3 is 16 MiB.
constexpr std::size_t SubPatchesOfBatch = 65536;
constexpr std::size_t TexelsOfBatch = std::size_t{ 1 } << 22;

// Largest number of texel rows that one invocation draws, so that a long curve is divided among many
// invocations.
constexpr std::uint32_t TexelRowsOfTrim = 64;

/// The rises that affect the texture of a tile: for each block of rows that a rise may cross, {degree, index
/// of its first coefficient, block}; then the coefficients. Indices are relative to the beginning.
struct TileTrims
{
  std::vector<double> Values;
  std::uint32_t Count = 0;
};

TileTrims GetTrims(const TileRange& range, const SubPatchFace& face, std::uint32_t textureFactor)
{
  const double* const bottom = face.Grid.V.data() + range.Row;
  const double* const top = bottom + range.Rows;
  const double right = face.Grid.U[range.Column + range.Columns];
  TileTrims trims;
  std::vector<double> coefficients;
  std::vector<std::size_t> places;
  for (const TrimRise& rise : face.Rises)
  {
    const auto [low, high] = std::minmax(rise.front()[1], rise.back()[1]);
    const auto leftmost =
      std::min_element(rise.begin(), rise.end(), [](const auto& a, const auto& b) { return a[0] < b[0]; });
    // A rise that crosses no row of texel centres of the tile, or only to the right of the tile, changes
    // nothing.
    if (low > *top || high < *bottom || (*leftmost)[0] > right)
    {
      continue;
    }
    const auto rows = static_cast<std::uint32_t>(
      std::upper_bound(bottom + 1, top, high) - std::upper_bound(bottom + 1, top, low) + 1);
    const std::uint32_t blocks = (rows * textureFactor - 1) / TexelRowsOfTrim + 1;
    for (std::uint32_t block = 0; block < blocks; ++block)
    {
      places.push_back(trims.Values.size() + 1);
      trims.Values.insert(trims.Values.end(),
        { static_cast<double>(rise.size() - 1), static_cast<double>(coefficients.size()),
          static_cast<double>(block) });
    }
    for (const std::array<double, 2>& p : rise)
    {
      coefficients.insert(coefficients.end(), p.begin(), p.end());
    }
    trims.Count += blocks;
  }
  for (const std::size_t place : places)
  {
    trims.Values[place] += static_cast<double>(trims.Values.size());
  }
  trims.Values.insert(trims.Values.end(), coefficients.begin(), coefficients.end());
  return trims;
}
}

std::vector<TileRange> MakeTiles(std::size_t index, const SubPatchFace& face, int textureFactor)
{
  const auto columns = static_cast<std::uint32_t>(face.Grid.GetNumberOfColumns());
  const auto rows = static_cast<std::uint32_t>(face.Grid.GetNumberOfRows());
  const std::size_t texels = static_cast<std::size_t>(textureFactor) * textureFactor;
  const auto maximum = static_cast<std::uint32_t>(std::min(SubPatchesOfTile, TexelsOfTile / texels));
  const std::uint32_t width = std::min(columns, maximum);
  const std::uint32_t height = width > 0 ? maximum / width : 0;
  std::vector<TileRange> tiles;
  for (std::uint32_t row = 0; row < rows && width > 0; row += height)
  {
    for (std::uint32_t column = 0; column < columns; column += width)
    {
      tiles.push_back(
        { index, column, row, std::min(width, columns - column), std::min(height, rows - row) });
    }
  }
  return tiles;
}

SchemeKernel ChooseSchemeKernel(const SubPatchFace& face)
{
  static const SchemeKernel common[] = { { 1, 2 }, { 2, 1 }, { 2, 2 }, { 3, 3 } };
  const SchemeKernel degrees = { face.Source->Surface.Degree[0], face.Source->Surface.Degree[1] };
  return std::find(std::begin(common), std::end(common), degrees) != std::end(common) ? degrees
                                                                                      : SchemeKernel{ 0, 0 };
}

std::size_t SchemeBatch::GetFaceBytes(const SubPatchFace& face)
{
  return std::max(face.Points.size() * sizeof(face.Points[0]), face.Patches.size() * sizeof(SchemePatch));
}

void SchemeBatch::AddFace(const SubPatchFace& face)
{
  this->Last = &face;
  this->FirstPatch = static_cast<std::uint32_t>(this->Patches.size());
  const auto firstPoint = static_cast<std::uint32_t>(this->Points.size());
  this->Points.insert(this->Points.end(), face.Points.begin(), face.Points.end());
  for (const Patch& patch : face.Patches)
  {
    this->Patches.push_back({ { patch.Center[0], patch.Center[1], patch.Center[2], 0.0 },
      { firstPoint + patch.FirstPoint, static_cast<std::uint32_t>(patch.Degree[0]),
        static_cast<std::uint32_t>(patch.Degree[1]), 0 },
      { 0, 0, 0, 0 } });
  }
}

bool SchemeBatch::Add(
  const TileRange& range, const SubPatchFace& face, int textureFactor, std::size_t maximumBytes)
{
  const bool isNew = this->Last != &face;
  const auto factor = face.HasTexture() ? static_cast<std::uint32_t>(textureFactor) : 0u;
  const std::size_t subPatches = range.GetNumberOfSubPatches();
  const std::size_t texels = subPatches * factor * factor;
  const TileTrims trims = GetTrims(range, face, factor);
  const std::size_t values = range.Columns + range.Rows + 2 + subPatches + trims.Values.size();
  if (!this->Tiles.empty() &&
    (this->SubPatches + subPatches > SubPatchesOfBatch || this->Texels + texels > TexelsOfBatch ||
      (this->Values.size() + values) * sizeof(double) > maximumBytes ||
      (isNew &&
        std::max(this->Points.size() * sizeof(this->Points[0]), this->Patches.size() * sizeof(SchemePatch)) +
            GetFaceBytes(face) >
          maximumBytes)))
  {
    return false;
  }
  if (isNew)
  {
    this->AddFace(face);
  }
  const auto copy = [this](auto first, auto last)
  {
    const auto at = static_cast<std::uint32_t>(this->Values.size());
    this->Values.insert(this->Values.end(), first, last);
    return at;
  };
  const auto columns = static_cast<std::size_t>(face.Grid.GetNumberOfColumns());
  SchemeTile tile{ { this->SubPatches, this->Trims, this->TexelRows,
                     static_cast<std::uint32_t>(columns / face.Grid.Factor) },
    { range.Column, range.Row, range.Columns, range.Rows },
    { this->FirstPatch, static_cast<std::uint32_t>(face.Grid.Factor), factor,
      face.Source->Reversed ? 1u : 0u },
    { 0, 0, 0, 0 }, { this->Texels, trims.Count, 0, 0 } };
  const double* u = face.Grid.U.data() + range.Column;
  const double* v = face.Grid.V.data() + range.Row;
  tile.Values[0] = copy(u, u + range.Columns + 1);
  tile.Values[1] = copy(v, v + range.Rows + 1);
  tile.Values[2] = static_cast<std::uint32_t>(this->Values.size());
  for (std::uint32_t row = 0; row < range.Rows; ++row)
  {
    const double* deviations = face.Deviations.data() + (range.Row + row) * columns + range.Column;
    copy(deviations, deviations + range.Columns);
  }
  tile.Values[3] = copy(trims.Values.begin(), trims.Values.end());
  this->Tiles.push_back(tile);
  this->Ranges.push_back(range);

  const SchemeKernel kernel = ChooseSchemeKernel(face);
  const auto first = this->SubPatches;
  this->SubPatches += static_cast<std::uint32_t>(subPatches);
  this->Trims += trims.Count;
  this->TexelRows += factor * range.Rows;
  this->Texels += static_cast<std::uint32_t>(texels);
  if (this->Parts.empty() || this->Parts.back().Kernel != kernel)
  {
    this->Parts.push_back({ kernel, first, first, { 0, 0 } });
  }
  Part& part = this->Parts.back();
  part.Last = this->SubPatches;
  for (int d = 0; d < 2; ++d)
  {
    part.Degree[d] = std::max(part.Degree[d], face.Source->Surface.Degree[d]);
  }
  return true;
}
}
