/**
 * @file smGPUItemRunnerInternals.h
 * @brief Buffers and programs of a GPUItemRunner
 */
#ifndef smGPUItemRunnerInternals_h
#define smGPUItemRunnerInternals_h

#include "Items/smBatchParameters.h"
#include "Items/smGPUItemRunner.h"
#include "Items/smIntegrationPrograms.h"
#include "Items/smWorkList.h"
#include "smComputeBuffer.h"
#include "smContextResources.h"
#include "smResidentFaces.h"

#include "vtkComputeContext.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace sm
{
struct GPUItemRunner::Internals
{
  /// Numbers of invocations per work group, as in the shaders.
  static constexpr unsigned int LocalSize = 32;
  static constexpr unsigned int LocalSizeOfBlocks = 64;
  static constexpr ProgramKey FinishProgram = { ProgramKind::Finish, 0, 0 };
  static constexpr ProgramKey RowBlockProgram = { ProgramKind::RowBlocks, 0, 0 };
  static constexpr ProgramKey FaceSumProgram = { ProgramKind::FaceSums, 0, 0 };

  explicit Internals(vtkComputeContext* context)
    : Context(context)
    , Resident(context)
    , Programs(context)
    , Work(context)
    , Shapes(context)
    , Parameters(context)
    , Rows(context)
    , StatusFlags(context)
    , LineSums(context)
    , Blocks(context)
    , BlockSums(context)
    , Parts(context)
    , Faces(context)
    , Totals(context)
  {
  }

  vtkSmartPointer<vtkComputeContext> Context;
  ResidentFaces Resident;
  IntegrationPrograms Programs;
  ComputeBuffer Work;
  ComputeBuffer Shapes;
  ComputeBuffer Parameters;
  ComputeBuffer Rows;
  ComputeBuffer StatusFlags;
  /// The sums of the lines of a portion.
  ComputeBuffer LineSums;
  /// Tables of AddUp(), and its results.
  ComputeBuffer Blocks;
  ComputeBuffer BlockSums;
  ComputeBuffer Parts;
  ComputeBuffer Faces;
  ComputeBuffer Totals;

  /// Places of the faces of the last Acquire().
  std::vector<ResidentFace> Places;
  /// Places of the faces of the last BeginBatch(), by slot; all are on one page.
  std::vector<const ResidentFace*> Slots;
  BatchParameters Batch;
  /// True if Parameters has the numbers of Batch, which Run() uploads in the scope that it enters anyway.
  bool IsBatchUploaded = false;
  /// The order of evaluation of the last Run(), and whether an item of it was compared.
  std::vector<std::uint32_t> Order;
  bool HasComparisons = false;
  /// Programs whose results were compared with those of the CPU, in which generation of the context.
  std::set<ProgramKey> Proved;
  std::uint64_t ProvedGeneration = 0;

  std::string GetBufferErrors() const
  {
    std::string errors;
    for (const ComputeBuffer* buffer :
      { &this->Work, &this->Shapes, &this->Parameters, &this->Rows, &this->StatusFlags, &this->LineSums,
        &this->Blocks, &this->BlockSums, &this->Parts, &this->Faces, &this->Totals })
    {
      errors += buffer->GetError();
    }
    return errors;
  }

  bool Bind(const ProgramKey& key, int page)
  {
    switch (std::get<0>(key))
    {
      case ProgramKind::Panels:
      case ProgramKind::Ribbons:
        return this->Resident.Bind(page) && this->BindLines();
      case ProgramKind::Caps:
        return this->Resident.BindCaps(page) && this->BindLines();
      case ProgramKind::Finish:
        return this->StatusFlags.Bind(0) && this->Rows.Bind(5) && this->BindLines();
      case ProgramKind::RowBlocks:
        return this->Rows.Bind(5) && this->Blocks.Bind(6) && this->BlockSums.Bind(7);
      default:
        return this->Faces.Bind(3) && this->Parts.Bind(4) && this->Totals.Bind(6) && this->BlockSums.Bind(7);
    }
  }
  bool BindLines()
  {
    return this->Work.Bind(3) && this->Parameters.Bind(4) && this->Shapes.Bind(6) && this->LineSums.Bind(7);
  }

  bool IsSoftware() const { return this->Context->GetResources()->IsSoftware; }
  ProgramKey ChooseProgram(const WorkItem& item) const
  {
    return IntegrationPrograms::ChooseProgram(item.Kind, item.Degree[0], item.Degree[1], this->IsSoftware());
  }
  PortionLimits GetLimits(const RowLayout& layout) const;
  static std::size_t GetLineBytes(const RowLayout& layout)
  {
    return static_cast<std::size_t>(layout.GetNumberOfIntegrands() + layout.GetNumberOfRoundings() + 3) *
      sizeof(double);
  }
  /// Bytes of the sums of a block: all columns but the differences, and their rounding errors.
  static std::size_t GetBlockBytes(const RowLayout& layout)
  {
    return 2 * static_cast<std::size_t>(layout.GetDifference(0)) * sizeof(double);
  }

  /// Returns the record with indices into the page's data of its face.
  WorkRecord MakeRecord(const WorkItem& item) const
  {
    const ResidentFace& place = *this->Slots[item.GetSlot()];
    WorkRecord record = item.Work;
    if (item.Kind == ItemKind::Cap)
    {
      record.Item[1] += 9 * place.FirstCap;
      return record;
    }
    record.Item[0] += place.FirstPatch;
    record.Item[1] += place.FirstCoefficient;
    if (item.Kind == ItemKind::Ribbon)
    {
      record.Detail[1] += place.FirstCoefficient;
    }
    return record;
  }

  /// Makes the buffers for as many items as the faces have, since a new store takes a GPU's driver up to a
  /// millisecond; the plan may have more.
  bool Reserve(const RowLayout& layout, const std::vector<CutFacePointer>& faces, std::size_t maximumRows);
  /// Builds the programs that the faces need and runs each once, as drivers finish compilation at the first
  /// dispatch.
  bool WarmUp(const std::vector<CutFacePointer>& faces, const ProgressCallback& progress, std::string& error);
  /// Runs a program for a range of a portion's lines, or the program that finishes the portion's items.
  bool DispatchLines(const RowLayout& layout, const WorkPortion& portion, const LineRange& range);
  bool DispatchFinish(const RowLayout& layout, const WorkPortion& portion);
  bool RunPortion(const RowLayout& layout, const WorkPortion& portion, std::string& error);
  /// Uploads the tables of AddUp().
  bool UploadParts(const RowLayout& layout, const std::vector<RowPart>& parts, std::uint32_t& blocks,
    std::uint32_t& coedges);
  bool DispatchSums(const RowLayout& layout, std::uint32_t blocks, std::uint32_t faces, std::string& error);
};
}

#endif
