#include "smExportBytes.h"

#include "smLeafBytes.h"
#include "vtkNURBSDataSet.h"

#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"

#include <cstdint>
#include <unordered_map>

namespace sm
{
namespace
{
void PutNode(const ExportNode& node, ByteWriter& to)
{
  to.PutText(node.Name);
  to.PutText(node.Layer);
  to.Put(node.Part);
  to.Put(node.Place);
  to.Put(node.InstanceColor);
  to.Put(static_cast<std::uint64_t>(node.Children.size()));
  for (const ExportNode& child : node.Children)
  {
    PutNode(child, to);
  }
}

ExportNode GetNode(ByteReader& from)
{
  ExportNode node;
  node.Name = from.GetText();
  node.Layer = from.GetText();
  node.Part = from.Get<int>();
  node.Place = from.Get<MatrixRows>();
  node.InstanceColor = from.Get<Color>();
  node.Children.resize(from.GetCount(1));
  for (ExportNode& child : node.Children)
  {
    child = from.IsGood() ? GetNode(from) : ExportNode();
  }
  return node;
}

/// Returns true if every node refers to a part of the tree, or to none.
bool HasParts(const ExportNode& node, std::size_t parts)
{
  bool has = node.Part < 0 || static_cast<std::size_t>(node.Part) < parts;
  for (const ExportNode& child : node.Children)
  {
    has = has && HasParts(child, parts);
  }
  return has;
}
}

void PutExport(const ExportTree& tree, const ExportOptions& options, ByteWriter& to)
{
  to.PutTexts({ options.UnitName, options.FileName, options.System });
  to.Put(options.Unit);
  // Each model once, as a leaf without a mesh.
  std::unordered_map<const vtkTrimmedNURBSModel*, std::uint64_t> numbers;
  vtkNew<vtkPartitionedDataSetCollection> models;
  for (const ExportPart& part : tree.Parts)
  {
    for (const ExportBody& body : part.Bodies)
    {
      if (numbers.emplace(body.Model, numbers.size()).second)
      {
        vtkNew<vtkNURBSDataSet> leaf;
        leaf->SetModel(body.Model);
        models->SetPartition(models->GetNumberOfPartitionedDataSets(), 0, leaf);
      }
    }
  }
  to.Put(static_cast<std::uint64_t>(numbers.size()));
  PutLeaves(models, to);
  to.Put(static_cast<std::uint64_t>(tree.Parts.size()));
  for (const ExportPart& part : tree.Parts)
  {
    to.PutText(part.Name);
    to.PutText(part.Layer);
    to.Put(static_cast<std::uint64_t>(part.Bodies.size()));
    for (const ExportBody& body : part.Bodies)
    {
      to.Put(numbers.at(body.Model));
      to.Put(body.Own);
      to.Put(body.BodyColor);
      to.PutAll(body.FaceColors);
    }
  }
  PutNode(tree.Root, to);
  to.PutText(tree.LengthUnit);
  to.PutText(tree.FileUnit);
}

bool GetExport(ByteReader& from, ExportTree& tree, ExportOptions& options)
{
  const std::vector<std::string> texts = from.GetTexts();
  options.Unit = from.Get<double>();
  const std::size_t count = from.GetCount(1);
  vtkNew<vtkPartitionedDataSetCollection> models;
  models->SetNumberOfPartitionedDataSets(static_cast<unsigned int>(count));
  if (texts.size() != 3 || !GetLeaves(from, models))
  {
    return false;
  }
  options.UnitName = texts[0];
  options.FileName = texts[1];
  options.System = texts[2];
  tree.Parts.resize(from.GetCount(1));
  for (ExportPart& part : tree.Parts)
  {
    part.Name = from.GetText();
    part.Layer = from.GetText();
    part.Bodies.resize(from.GetCount(1));
    for (ExportBody& body : part.Bodies)
    {
      const auto number = from.Get<std::uint64_t>();
      auto* leaf = number < count ? vtkNURBSDataSet::SafeDownCast(
                                      models->GetPartitionAsDataObject(static_cast<unsigned int>(number), 0))
                                  : nullptr;
      body.Model = leaf ? leaf->GetModel() : nullptr;
      body.Own = from.Get<MatrixRows>();
      body.BodyColor = from.Get<Color>();
      body.FaceColors = from.GetAll<Color>();
      if (!body.Model || !from.IsGood())
      {
        return false;
      }
    }
  }
  tree.Root = GetNode(from);
  tree.LengthUnit = from.GetText();
  tree.FileUnit = from.GetText();
  return from.IsGood() && HasParts(tree.Root, tree.Parts.size());
}

void PutExportResult(const ExportResult& result, ByteWriter& to)
{
  to.PutText(result.Problem);
  to.PutTexts(result.Warnings);
  to.Put(result.Faces);
  to.Put(result.Aborted);
}

bool GetExportResult(ByteReader& from, ExportResult& result)
{
  result.Problem = from.GetText();
  result.Warnings = from.GetTexts();
  result.Faces = from.Get<int>();
  result.Aborted = from.Get<bool>();
  return from.IsGood();
}
}
