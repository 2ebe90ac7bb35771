/**
 * @file smRankComparison.h
 * @brief The outputs of a filter that ranks share compared with those of a filter alone, bit for bit
 */
#ifndef smRankComparison_h
#define smRankComparison_h

#include "smTestPipeline.h"
#include "smTestRanks.h"

#include <vtkDataSetAttributes.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <cstring>
#include <string>

namespace smtest
{
/// True if the shared run has results of faces from earlier runs that the single run has to evaluate, so that
/// counts of evaluations differ.
inline bool countsDiffer = false;

inline void UpdateTogether(vtkSurfaceIntegralBase* filter)
{
  filter->UpdatePiece(rank, ranks, 0);
}

/// Arrays that may differ from a run alone.
inline bool IsOfRanks(const std::string& name)
{
  return name == sm::names::Ranks || name == sm::names::Dispatches ||
    (countsDiffer && name == sm::names::Evaluations);
}

/// A run of ranks may begin its summary with a note about them.
inline bool IsSameText(const std::string& alone, const std::string& shared)
{
  const bool hasNote = shared.rfind("Note: rank ", 0) == 0 && shared.size() > alone.size();
  return alone == (hasNote ? shared.substr(shared.size() - alone.size()) : shared);
}

inline std::string CompareArrays(vtkAbstractArray* a, vtkAbstractArray* b)
{
  if (!a || !b || a->GetNumberOfValues() != b->GetNumberOfValues())
  {
    return "missing or of another size";
  }
  for (vtkIdType i = 0; i < a->GetNumberOfValues(); ++i)
  {
    const vtkVariant x = a->GetVariantValue(i);
    const vtkVariant y = b->GetVariantValue(i);
    const double values[2] = { x.ToDouble(), y.ToDouble() };
    const bool same = x.IsString() ? IsSameText(x.ToString(), y.ToString())
                                   : !std::memcmp(values, values + 1, sizeof(double));
    if (!same)
    {
      return "value " + std::to_string(i) + ": " + x.ToString() + " and " + y.ToString();
    }
  }
  return "";
}

/// All arrays of two sets of fields, bit for bit; the first must be as large as is said.
inline void CompareFields(const std::string& what, vtkFieldData* alone, vtkFieldData* shared, int atLeast)
{
  std::string differences;
  int compared = 0;
  for (int i = 0; i < alone->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = alone->GetAbstractArray(i);
    if (IsOfRanks(array->GetName()))
    {
      continue;
    }
    const std::string difference = CompareArrays(array, shared->GetAbstractArray(array->GetName()));
    differences += difference.empty() ? "" : std::string(array->GetName()) + " " + difference + "; ";
    ++compared;
  }
  CheckTrue(what + ": the same bits", differences.empty() && compared >= atLeast,
    differences + std::to_string(compared) + " arrays");
}

inline void CompareOutputs(
  const std::string& what, vtkSurfaceIntegralBase* alone, vtkSurfaceIntegralBase* shared)
{
  CompareFields(
    what + ", totals", alone->GetOutput()->GetFieldData(), shared->GetOutput()->GetFieldData(), 8);
  CheckEqual(what + ": points of the glyph", alone->GetOutput()->GetNumberOfPoints(),
    shared->GetOutput()->GetNumberOfPoints());
  for (const int port : { 1, 2, 3, 4 })
  {
    auto* a = vtkTable::SafeDownCast(alone->GetOutputDataObject(port));
    auto* b = vtkTable::SafeDownCast(shared->GetOutputDataObject(port));
    CheckEqual(what + ": rows of port " + std::to_string(port), a->GetNumberOfRows(), b->GetNumberOfRows());
    if (port == 2)
    {
      // Notes may name ranks.
      const auto getText = [](vtkTable* table)
      {
        const std::string text = table->GetValueByName(0, "Text").ToString();
        return text.substr(0, text.find("\nNote:"));
      };
      CheckEqual(what + ": summary", getText(a), getText(b));
      continue;
    }
    CompareFields(what + ", port " + std::to_string(port), a->GetRowData(), b->GetRowData(), 1);
  }
}

/// Checks that the outputs of a rank that does not put out results are empty.
inline void CheckEmpty(const std::string& what, vtkSurfaceIntegralBase* filter)
{
  CheckEqual(what + ": arrays on another rank", 0, filter->GetOutput()->GetFieldData()->GetNumberOfArrays());
  CheckEqual(what + ": points on another rank", 0, filter->GetOutput()->GetNumberOfPoints());
  for (const int port : { 1, 2, 3, 4 })
  {
    auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(port));
    CheckEqual(
      what + ": columns on another rank, port " + std::to_string(port), 0, table->GetNumberOfColumns());
  }
  auto* meshes = vtkPartitionedDataSetCollection::SafeDownCast(filter->GetOutputDataObject(5));
  // Its blocks are those of the first rank, without their meshes.
  int made = 0;
  for (unsigned int i = 0; i < meshes->GetNumberOfPartitionedDataSets(); ++i)
  {
    for (unsigned int j = 0; j < meshes->GetNumberOfPartitions(i); ++j)
    {
      made += meshes->GetPartitionAsDataObject(i, j) ? 1 : 0;
    }
  }
  CheckEqual(what + ": meshes on another rank", 0, made);
}

/// Runs `change` and then updates a pipeline that all share and, on the first rank, one that is alone.
struct Pair
{
  Pipeline Shared;
  Pipeline Alone;

  Pair(const std::string& path, int backend)
    : Shared(path)
    , Alone(path)
  {
    this->Shared.Mass->SetController(controller);
    this->Alone.Mass->SetController(nullptr);
    this->Shared.Mass->SetBackend(backend);
    this->Alone.Mass->SetBackend(backend);
  }
  void Compare(const std::string& what, int minimumRanks)
  {
    UpdateTogether(this->Shared.Mass);
    if (rank != 0)
    {
      CheckEmpty(what, this->Shared.Mass);
      return;
    }
    this->Alone.Mass->Update();
    CompareOutputs(what, this->Alone.Mass, this->Shared.Mass);
    CheckTrue(what + ": ranks that integrated", this->Shared.Mass->GetNumberOfRanks() >= minimumRanks,
      std::to_string(this->Shared.Mass->GetNumberOfRanks()) + ", " + GetMessages(this->Shared.Mass));
    CheckEqual(what + ": status", this->Alone.Mass->GetStatus(), this->Shared.Mass->GetStatus());
    CheckEqual(what + ": messages", GetMessages(this->Alone.Mass), GetMessages(this->Shared.Mass));
  }
};
}

#endif
