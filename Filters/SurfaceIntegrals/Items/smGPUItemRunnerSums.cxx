// Sums of the rows of faces on the device.
#include "smGPUItemRunnerInternals.h"

#include "smContextScope.h"
#include "smUnitRoundoff.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sm
{
namespace
{
// Rows of a block that one invocation adds up. A constant of the results' bits.
constexpr std::uint32_t RowsOfBlock = 64;

/// A block of rows and a part of a face, in the layouts of glsl/smRowBlockCS.glsl and glsl/smFaceSumCS.glsl.
using BlockRecord = std::array<std::uint32_t, 2>;
using PartRecord = std::array<std::uint32_t, 4>;

std::uint32_t GetPartKind(const RowPart& part)
{
  return part.Kind == ItemKind::Panel ? 0u : part.Coedge < 0 ? 1u : 2u;
}
}

bool GPUItemRunner::Internals::UploadParts(
  const RowLayout& layout, const std::vector<RowPart>& parts, std::uint32_t& blocks, std::uint32_t& coedges)
{
  std::vector<BlockRecord> blockRecords;
  std::vector<PartRecord> partRecords;
  std::vector<std::uint32_t> firstParts;
  partRecords.reserve(parts.size());
  coedges = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const RowPart& part = parts[i];
    if (i == 0 || part.Slot != parts[i - 1].Slot)
    {
      firstParts.push_back(static_cast<std::uint32_t>(i));
    }
    const auto first = static_cast<std::uint32_t>(blockRecords.size());
    for (std::uint32_t row = part.Begin; row < part.End; row += RowsOfBlock)
    {
      blockRecords.push_back({ row, std::min(RowsOfBlock, part.End - row) });
    }
    const std::uint32_t kind = GetPartKind(part);
    partRecords.push_back({ first, static_cast<std::uint32_t>(blockRecords.size()) - first, kind, coedges });
    coedges += kind == 2u ? 1u : 0u;
  }
  const std::size_t faces = firstParts.size();
  firstParts.push_back(static_cast<std::uint32_t>(parts.size()));
  blocks = static_cast<std::uint32_t>(blockRecords.size());
  const std::size_t totals = faces * (4 * layout.GetNumberOfIntegrands() + 3) + 3 * coedges;
  return this->Blocks.Upload(blockRecords) && this->Parts.Upload(partRecords) &&
    this->Faces.Upload(firstParts) && this->BlockSums.Allocate(blocks * GetBlockBytes(layout)) &&
    this->Totals.Allocate(totals * sizeof(double));
}

bool GPUItemRunner::Internals::DispatchSums(
  const RowLayout& layout, std::uint32_t blocks, std::uint32_t faces, std::string& error)
{
  ComputeProgram* rows = this->Programs.Get(RowBlockProgram);
  ComputeProgram* sums = this->Programs.Get(FaceSumProgram);
  if (!rows || !sums)
  {
    error = this->Programs.GetError();
    return false;
  }
  // A dispatch of portions, so that the number of invocations is within 32 bits for any number of integrands.
  const auto columns = static_cast<std::uint32_t>(layout.GetDifference(0));
  const std::uint32_t maximum = 0x40000000u / columns;
  bool done = this->Bind(RowBlockProgram, 0);
  for (std::uint32_t first = 0; first < blocks && done; first += maximum)
  {
    const std::uint32_t count = std::min(maximum, blocks - first);
    done = rows->SetUniform("smFirstBlock", first) && rows->SetUniform("smBlockCount", count) &&
      rows->Dispatch(count * columns, LocalSizeOfBlocks);
  }
  const auto integrands = static_cast<std::uint32_t>(layout.GetNumberOfIntegrands());
  done = done && this->Bind(FaceSumProgram, 0) && sums->SetUniform("smFaceCount", faces) &&
    sums->Dispatch(faces * (integrands + 1u), LocalSize);
  error = done ? "" : rows->GetError() + sums->GetError() + this->GetBufferErrors();
  return done;
}

bool GPUItemRunner::AddUp(const std::vector<RowPart>& parts, FaceTotals& totals, std::vector<RowGaps>& gaps)
{
  Internals& self = *this->Implementation;
  gaps.clear();
  if (parts.empty())
  {
    return true;
  }
  const ContextScope scope(self.Context);
  std::uint32_t blocks = 0;
  std::uint32_t coedges = 0;
  std::string error;
  if (!scope || !self.UploadParts(this->Layout, parts, blocks, coedges) ||
    !self.DispatchSums(this->Layout, blocks, static_cast<std::uint32_t>(totals.GetNumberOfFaces()), error))
  {
    return this->Fail("the sums of faces failed: " + error + self.GetBufferErrors());
  }
  const auto integrands = static_cast<std::size_t>(this->Layout.GetNumberOfIntegrands());
  const std::size_t faces = totals.GetNumberOfFaces();
  std::vector<double> sums(faces * (4 * integrands + 3) + 3 * coedges);
  if (!self.Totals.Read(sums.data(), sums.size() * sizeof(double)))
  {
    return this->Fail("the sums of faces failed: " + self.Totals.GetError());
  }
  const double* from = sums.data();
  const auto takeGaps = [&from]
  {
    const RowGaps own = { from[0], from[1], from[2] };
    from += 3;
    return own;
  };
  for (std::size_t face = 0; face < faces; ++face)
  {
    for (std::size_t k = 0; k < integrands; ++k, from += 4)
    {
      RowTotal& total = totals.At(face, k);
      const auto add = [&](double& sum, double value)
      {
        const double before = sum;
        sum += value;
        total.Rounding += before != 0.0 ? UnitRoundoff * std::abs(sum) : 0.0;
      };
      add(total.Face, from[0]);
      add(total.Chain, from[1]);
      total.Error += from[2];
      total.Rounding += from[3];
    }
    totals.Gaps[face].Add(takeGaps());
  }
  for (std::uint32_t i = 0; i < coedges; ++i)
  {
    gaps.push_back(takeGaps());
  }
  return true;
}
}
