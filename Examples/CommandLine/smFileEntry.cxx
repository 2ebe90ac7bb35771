#include "smFileEntry.h"

#include "smMassPropertyNames.h"
#include "smQuantities.h"
#ifdef SM_HAS_MOMENT_SCHEMES
#include "smSchemeJob.h"
#endif

#include "vtkBoundingBox.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkNURBSDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkTable.h"

#include <vector>

namespace sm
{
namespace
{
/// Returns the quantities in a row of field data or of a table.
Json GetRow(vtkFieldData* data, vtkIdType row)
{
  Json quantities = GetQuantities(data, row);
  // A build without the schemes has the same keys, with null values.
  quantities.update({ { "paper_error_estimate", nullptr }, { "paper_error_estimate_with_boundary", nullptr },
    { "sub_patches", nullptr } });
#ifdef SM_HAS_MOMENT_SCHEMES
  quantities.update(GetSchemeQuantities(data, row));
#endif
  quantities["bounding_box"] = nullptr;
  quantities["bounds"]["bounding_box"] = nullptr;
  return quantities;
}

/// Returns for each solid the edges with the widest gaps, at most five, without edges that have no gap. In the table the widest gap is
/// first.
std::vector<Json> WorstEdges(vtkTable* table, vtkIdType solids)
{
  const size_t most = 5;
  std::vector<Json> worst(static_cast<size_t>(solids), Json::array());
  vtkDataSetAttributes* columns = table->GetRowData();
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const Json widest = GetNumber(columns, row, names::MaxGap);
    if (widest.is_null() || widest == 0.0)
    {
      break;
    }
    Json& edges = worst.at(GetCount(columns, row, names::Solid).get<size_t>());
    if (edges.size() == most)
    {
      continue;
    }
    Json edge;
    edge["id"] = GetCount(columns, row, names::EdgeId);
    edge["name"] = GetText(columns, row, names::Name);
    edge["uses"] = GetCount(columns, row, names::Uses);
    edge["open"] = GetCount(columns, row, names::Open) != 0;
    edge["max_gap"] = widest;
    edge["gap_area"] = GetNumber(columns, row, names::GapArea);
    edge["gap_squared"] = GetNumber(columns, row, names::GapSquared);
    edges.push_back(std::move(edge));
  }
  return worst;
}
}

Json GetTotal(vtkFieldData* fields)
{
  Json total = GetRow(fields, 0);
  const std::string bound = std::string(names::KnownMass) + names::BoundSuffix;
  total["known_mass"] = GetNumber(fields, 0, names::KnownMass);
  total["bounds"]["known_mass"] = GetNumber(fields, 0, bound);
  total["solids_with_mass"] = GetCount(fields, 0, names::SolidsWithMass);
  total["solids_with_volume"] = GetCount(fields, 0, names::SolidsWithVolume);
  return total;
}

Json GetSolids(vtkTable* table, vtkTable* edges)
{
  Json solids = Json::array();
  const std::vector<Json> worst = WorstEdges(edges, table->GetNumberOfRows());
  vtkDataSetAttributes* columns = table->GetRowData();
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    Json solid;
    solid["name"] = GetText(columns, row, names::Name);
    solid["id"] = GetText(columns, row, names::Id);
    solid["path"] = GetText(columns, row, names::Path);
    solid["status"] = GetText(columns, row, names::Status);
    solid.update(GetRow(columns, row));
    solid["worst_edges"] = worst[static_cast<size_t>(row)];
    solids.push_back(std::move(solid));
  }
  return solids;
}

Json MakeEmptyFile(const std::string& fileName)
{
  vtkNew<vtkFieldData> nothing;
  Json file;
  SetFileName(file, fileName);
  file["length_unit"] = nullptr;
  file["status"] = names::StatusUnreadable;
  file["messages"] = Json::array();
  file["scheme"] = nullptr;
  file["scheme_options"] = nullptr;
  file["backend"] = nullptr;
  file["renderer"] = nullptr;
  file["backend_reason"] = nullptr;
  file["estimate"] = { { "evaluations", nullptr }, { "cpu_seconds", nullptr },
    { "opengl_seconds", nullptr } };
  file["frame"] = nullptr;
  file["total"] = GetTotal(nothing);
  file["solids"] = Json::array();
  file["integrals"] = Json::object();
  file["waterlines"] = Json::array();
  file["sections"] = Json::array();
  file["faces"] = nullptr;
  file["free_faces"] = nullptr;
  file["diagonal"] = nullptr;
  file["evaluations"] = nullptr;
  file["dispatches"] = nullptr;
  file["seconds"] = { { "start", nullptr }, { "read", nullptr }, { "parse", nullptr },
    { "transfer", nullptr }, { "trims", nullptr }, { "prepare", nullptr }, { "mesh", nullptr },
    { "convert", nullptr }, { "cut", nullptr }, { "plan", nullptr }, { "upload", nullptr },
    { "integrate", nullptr }, { "analyse", nullptr } };
  return file;
}

Json GetDiagonal(vtkDataObject* input)
{
  vtkBoundingBox box;
  auto* parts = vtkPartitionedDataSetCollection::SafeDownCast(input);
  for (unsigned int i = 0; parts && i < parts->GetNumberOfPartitionedDataSets(); ++i)
  {
    for (unsigned int j = 0; j < parts->GetNumberOfPartitions(i); ++j)
    {
      auto* solid = vtkNURBSDataSet::SafeDownCast(parts->GetPartitionAsDataObject(i, j));
      double bounds[6];
      if (solid && solid->GetBodyBounds(bounds))
      {
        box.AddBounds(bounds);
      }
    }
  }
  return box.IsValid() ? Json(box.GetDiagonalLength()) : Json();
}
}
