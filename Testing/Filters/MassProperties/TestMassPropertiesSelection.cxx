// TestMassPropertiesSelection FOLDER: solids chosen by nodes of an assembly and by blocks; the meshes that
// come with their results, and the glyph's colour.
#include "smPartsList.h"
#include "smTestManifest.h"
#include "smTestPipeline.h"

#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataAssembly.h>
#include <vtkDataSetAttributes.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNURBSDataSet.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkTable.h>

#include <algorithm>
#include <map>
#include <set>

namespace
{
using namespace smtest;
namespace names = sm::names;

vtkSmartPointer<vtkDataObject> ReadLeaf(const Expected& expected)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(expected.Path.c_str());
  reader->Update();
  return vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(0))->GetPartition(0, 0);
}

vtkPartitionedDataSetCollection* GetBodies(vtkAlgorithm* filter)
{
  return vtkPartitionedDataSetCollection::SafeDownCast(filter->GetOutputDataObject(5));
}

/// The volume of what the selectors choose; only warnings are expected.
void CheckChoice(vtkMassPropertiesGPU* mass, const std::string& assembly,
  const std::vector<std::string>& selectors, double volume, int solids)
{
  mass->ClearSelectors();
  mass->SetAssemblyName(assembly);
  std::string what = assembly + ":";
  for (const std::string& selector : selectors)
  {
    mass->AddSelector(selector);
    what += " " + selector;
  }
  mass->Update(5);
  CheckEqual(what + ", solids", solids, mass->GetNumberOfSolids());
  Check(what + ", volume", volume, mass->GetVolume(), 1e-9 * volume);
  CheckEqual(what + ", meshes", solids, GetBodies(mass)->GetNumberOfPartitionedDataSets());
}

/// Solids in the parts list, and their volume.
void CheckParts(vtkMassPropertiesGPU* mass, const std::string& what, int solids, double volume)
{
  mass->Update();
  int listed = 0;
  double sum = 0.0;
  for (const sm::PartsListEntry& entry : mass->GetPartsList())
  {
    listed += entry.CountInAll * entry.Solids;
    sum += entry.InAll.Volume.GetValue();
  }
  CheckEqual(what + ", solids in the parts list", solids, listed);
  Check(what + ", their volume", volume, sum, 1e-9 * volume);
  Check(what + ", all solids", volume, mass->GetVolume(), 1e-9 * volume);
}

/// An assembly that has a body in two nodes, and one that leaves a body out: each body is listed once.
void CheckPartsList(const Manifest& manifest)
{
  const Expected box = manifest.GetSolid("box", "plain").front();
  const Expected ball = manifest.GetSolid("sphere", "plain").front();
  vtkNew<vtkPartitionedDataSetCollection> input;
  input->SetPartition(0, 0, ReadLeaf(box));
  input->SetPartition(1, 0, ReadLeaf(ball));
  vtkNew<vtkDataAssembly> assembly;
  const int left = assembly->AddNode("Left");
  const int right = assembly->AddNode("Right");
  assembly->AddDataSetIndex(left, 0);
  input->SetDataAssembly(assembly);
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetInputDataObject(input);
  CheckParts(mass, "a body in no node", 2, box.Volume + ball.Volume);
  assembly->AddDataSetIndex(right, 0);
  assembly->AddDataSetIndex(right, 1);
  mass->Modified();
  CheckParts(mass, "a body in two nodes", 2, box.Volume + ball.Volume);
}

void CheckSelectors(const Manifest& manifest)
{
  const Expected box = manifest.GetSolid("box", "plain").front();
  const Expected ball = manifest.GetSolid("sphere", "plain").front();
  const double sum = box.Volume + ball.Volume;
  vtkNew<vtkPartitionedDataSetCollection> input;
  input->SetNumberOfPartitionedDataSets(2);
  input->SetPartition(0, 0, ReadLeaf(box));
  input->SetPartition(1, 0, ReadLeaf(ball));
  input->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "a box");
  input->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "a ball");
  vtkNew<vtkDataAssembly> assembly;
  assembly->SetRootNodeName("Product");
  const int left = assembly->AddNode("Left");
  const int right = assembly->AddNode("Right");
  assembly->AddDataSetIndex(assembly->AddNode("Box", left), 0);
  assembly->AddDataSetIndex(assembly->AddNode("Ball", right), 1);
  input->SetDataAssembly(assembly);

  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetInputDataObject(input);
  MessageTrap trap(mass);
  CheckChoice(mass, "Assembly", {}, sum, 2);
  CheckChoice(mass, "Assembly", { "//Ball" }, ball.Volume, 1);
  auto* table = vtkTable::SafeDownCast(mass->GetOutputDataObject(1));
  CheckEqual("the id is that in the whole input", "2", table->GetValueByName(0, names::Id).ToString());
  CheckEqual(
    "the name of the mesh", "a ball", GetBodies(mass)->GetMetaData(0u)->Get(vtkCompositeDataSet::NAME()));
  vtkDataAssembly* kept = GetBodies(mass)->GetDataAssembly();
  const std::vector<unsigned int> indices = kept->GetDataSetIndices(kept->SelectNodes({ "//Ball" }));
  CheckTrue("the assembly is kept and counts anew", indices.size() == 1 && indices[0] == 0);
  CheckTrue("and lost what is not there", kept->GetDataSetIndices(kept->SelectNodes({ "//Box" })).empty());
  CheckEqual("the input's assembly is as it was", 2,
    static_cast<long long>(assembly->GetDataSetIndices(vtkDataAssembly::GetRootNode()).size()));
  CheckChoice(mass, "Assembly", { "/Product/Left" }, box.Volume, 1);
  CheckChoice(mass, "Assembly", { "/Product/Left", "//Box" }, box.Volume, 1);
  CheckChoice(mass, "Assembly", { "//Box", "//Right" }, sum, 2);
  CheckEqual("messages", 0, mass->GetNumberOfMessages());
  CheckChoice(mass, "Assembly", { "//Box", "//Bolt" }, box.Volume, 1);
  CheckTrue("a selector that names nothing is reported", Says(mass, "//Bolt"));
  CheckEqual("and harms nothing", names::StatusOk, mass->GetStatus());
  CheckEqual("errors and warnings so far", 0, trap.NumberOfErrors + trap.NumberOfWarnings);

  mass->ClearSelectors();
  mass->AddSelector("//Bolt");
  mass->Update(5);
  CheckEqual("nothing chosen: status", names::StatusEmpty, mass->GetStatus());
  CheckTrue("nothing chosen: no volume, not 0", std::isnan(mass->GetVolume()));
  CheckTrue("nothing chosen: said", Says(mass, "no solid is chosen"));
  CheckEqual("nothing chosen: meshes", 0, GetBodies(mass)->GetNumberOfPartitionedDataSets());
  CheckEqual("nothing chosen: no error", 0, trap.NumberOfErrors);

  CheckChoice(mass, "Hierarchy", { "/Root/aball" }, ball.Volume, 1);
  // The ball once more, the same object, elsewhere: each place is chosen for itself.
  input->SetPartition(2, 0, input->GetPartition(1, 0));
  const int again = assembly->AddNode("Again");
  assembly->AddDataSetIndex(again, 2);
  input->Modified();
  CheckChoice(mass, "Assembly", {}, sum + ball.Volume, 3);
  for (const std::string place : { "//Ball", "//Again" })
  {
    CheckChoice(mass, "Assembly", { place }, ball.Volume, 1);
    table = vtkTable::SafeDownCast(mass->GetOutputDataObject(1));
    CheckEqual("its id", place == "//Ball" ? "2" : "3", table->GetValueByName(0, names::Id).ToString());
    kept = GetBodies(mass)->GetDataAssembly();
    CheckEqual("its place in the assembly of the meshes", 1,
      static_cast<long long>(kept->GetDataSetIndices(kept->SelectNodes({ place })).size()));
  }
  CheckChoice(mass, "Assembly", { "//Ball", "//Again" }, 2 * ball.Volume, 2);
  input->SetNumberOfPartitionedDataSets(2);
  assembly->RemoveNode(again);
  mass->SetAssemblyName("Elsewhere");
  mass->Update(5);
  CheckTrue("an unknown assembly is reported", Says(mass, "no assembly \"Elsewhere\""));
  CheckEqual("an unknown assembly: status", names::StatusEmpty, mass->GetStatus());

  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkMultiBlockDataSet> group;
  group->SetBlock(0, input->GetPartition(1, 0));
  group->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "Ball");
  blocks->SetBlock(0, input->GetPartition(0, 0));
  blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "Box");
  blocks->SetBlock(1, group);
  blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "Group");
  mass->SetInputDataObject(blocks);
  CheckChoice(mass, "Hierarchy", { "//Group" }, ball.Volume, 1);
  CheckChoice(mass, "Hierarchy", { "//Box" }, box.Volume, 1);
  CheckChoice(mass, "Assembly", {}, sum, 2);
}

/// Several bodies in one place of the assembly, and one body in several.
void CheckShared(const Manifest& manifest)
{
  vtkNew<vtkPartitionedDataSetCollection> input;
  const vtkSmartPointer<vtkDataObject> leaf = ReadLeaf(manifest.GetSolid("box", "plain").front());
  vtkNew<vtkNURBSDataSet> other;
  other->ShallowCopy(leaf);
  input->SetPartition(0, 0, leaf);
  input->SetPartition(0, 1, other);
  input->SetPartition(1, 0, leaf);
  vtkNew<vtkDataAssembly> assembly;
  const int first = assembly->AddNode("First");
  const int second = assembly->AddNode("Second");
  assembly->AddDataSetIndex(first, 0);
  assembly->AddDataSetIndex(second, 1);
  input->SetDataAssembly(assembly);
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetInputDataObject(input);
  mass->Update(5);
  CheckEqual("shared: bodies", 3, mass->GetNumberOfSolids());
  vtkDataAssembly* kept = GetBodies(mass)->GetDataAssembly();
  CheckTrue("shared: two bodies of one partitioned dataset",
    kept->GetDataSetIndices(first, false) == std::vector<unsigned int>({ 0, 1 }));
  CheckTrue("shared: the same body once more",
    kept->GetDataSetIndices(second, false) == std::vector<unsigned int>({ 2 }));
}

double Get(vtkDataSet* mesh, const char* name, vtkIdType cell)
{
  auto* array = vtkFloatArray::SafeDownCast(mesh->GetCellData()->GetArray(name));
  return array ? array->GetValue(cell) : std::nan("");
}

void CheckMeshes(const Manifest& manifest)
{
  Pipeline pipeline(manifest.GetSolid("slanted_hole", "moved").front().Path);
  pipeline.Mass->Update(5);
  auto* input = vtkPartitionedDataSetCollection::SafeDownCast(pipeline.Reader->GetOutputDataObject(0));
  auto* source = vtkNURBSDataSet::SafeDownCast(input->GetPartition(0, 0));
  auto* mesh = vtkNURBSDataSet::SafeDownCast(GetBodies(pipeline.Mass)->GetPartition(0, 0));
  CheckTrue("points are shared", mesh->GetPoints() == source->GetPoints());
  CheckTrue("cells are shared",
    mesh->GetPolys()->GetConnectivityArray() == source->GetPolys()->GetConnectivityArray());
  CheckTrue("the exact geometry is there", mesh->GetModel() && mesh->GetModel() == source->GetModel());
  CheckTrue("the input has no new arrays", !source->GetCellData()->HasArray(names::FaceShare));

  std::map<int, double> shares;
  std::map<int, double> bounds;
  double gap = 0.0;
  vtkDataArray* index = mesh->GetCellData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName());
  bool same = true;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const int face = static_cast<int>(index->GetComponent(cell, 0));
    const double share = Get(mesh, names::FaceShare, cell);
    same = same && (shares.count(face) == 0 || shares[face] == share);
    shares[face] = share;
    bounds[face] = Get(mesh, names::FaceBound, cell);
    gap = std::max(gap, Get(mesh, names::FaceGap, cell));
  }
  const double volume = pipeline.Mass->GetVolume();
  CheckEqual("faces", 7, static_cast<long long>(shares.size()));
  CheckTrue("every cell of a face has its share", same);
  double share = 0.0;
  double bound = 0.0;
  for (const auto& [face, value] : shares)
  {
    share += value;
    bound += bounds[face];
  }
  Check("shares add up to 1", 1.0, share, 7 * 6e-8, "(roundoff of a float)");
  CheckRange("bounds of the faces make the solid's", 0.0, bound, 1.001 * pipeline.Mass->GetVolumeBound());
  Check("volume of the solid", volume, Get(mesh, names::VolumeOfWholeSolid, 0), 6e-8 * volume,
    "(roundoff of a float)");
  Check("widest gap", GetField(pipeline.Mass->GetOutput()->GetFieldData(), names::MaxGap), gap, 6e-8 * gap);

  // The meshes are an input like any other, of the same bits.
  vtkNew<vtkMassPropertiesGPU> again;
  again->SetBackend(pipeline.Mass->GetBackend());
  again->SetInputConnection(pipeline.Mass->GetOutputPort(5));
  again->Update(5);
  Check("volume of the meshes", volume, again->GetVolume(), 0.0);
}

void CheckSharedArrays(const Manifest& manifest)
{
  const Expected expected = manifest.GetSpecial("assembly");
  Pipeline pipeline(expected.Path);
  pipeline.Mass->Update(5);
  for (const char* name : { names::VolumeOfWholeSolid, names::FaceShare, names::FaceGap, names::FaceBound })
  {
    std::set<vtkDataArray*> arrays;
    for (unsigned int i = 0; i < static_cast<unsigned int>(expected.Solids); ++i)
    {
      arrays.insert(vtkPolyData::SafeDownCast(GetBodies(pipeline.Mass)->GetPartition(i, 0))
                      ->GetCellData()
                      ->GetArray(name));
    }
    CheckTrue(std::string(name) + ": 500 instances share an array", arrays.size() == 1 && *arrays.begin());
  }
}

void CheckColors(const Manifest& manifest)
{
  const auto getColor = [](vtkMassPropertiesGPU* mass)
  {
    vtkDataArray* colors = mass->GetOutput()->GetCellData()->GetScalars();
    const bool complete = colors && colors->GetNumberOfTuples() == mass->GetOutput()->GetNumberOfCells() &&
      colors->GetDataType() == VTK_UNSIGNED_CHAR && std::string(colors->GetName()) == names::Color;
    return complete ? colors->GetComponent(0, 0) < colors->GetComponent(0, 1) ? "green" : "red" : "none";
  };
  Pipeline good(manifest.GetSolid("box", "plain").front().Path);
  good.Mass->Update(5);
  CheckEqual("a good result is", "green", getColor(good.Mass));
  CheckEqual("principal axes by default, lines", 3, good.Mass->GetOutput()->GetNumberOfLines());
  Pipeline open(manifest.GetSpecial("open_solid").Path);
  MessageTrap trap(open.Mass);
  open.Mass->Update(5);
  CheckEqual("an open solid is", names::StatusOpen, open.Mass->GetStatus());
  CheckEqual("and its marker", "red", getColor(open.Mass));
  const auto getStatus = [](vtkMassPropertiesGPU* mass)
  { return GetFieldText(mass->GetOutputDataObject(2)->GetFieldData(), names::Status); };
  CheckEqual("the text knows", names::StatusOpen, getStatus(open.Mass));
  CheckEqual("and that a good one is", names::StatusOk, getStatus(good.Mass));
}

/// A part without exact geometry is missing in the sums: it makes the result suspect, unless it is not
/// selected.
void CheckMissingParts(const Manifest& manifest)
{
  vtkNew<vtkPolyData> mesh;
  mesh->ShallowCopy(ReadLeaf(manifest.GetSolid("box", "plain").front()));
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkPartitionedDataSetCollection> input;
  const Expected expected = manifest.GetSolid("sphere", "plain").front();
  input->SetPartition(0, 0, ReadLeaf(expected));
  input->SetPartition(1, 0, mesh);
  input->SetPartition(2, 0, nothing);
  input->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "ball");
  input->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "lid");
  input->GetMetaData(2u)->Set(vtkCompositeDataSet::NAME(), "nothing");
  vtkNew<vtkMassPropertiesGPU> mass;
  MessageTrap trap(mass);
  mass->SetInputDataObject(input);
  mass->Update();
  CheckEqual("missing: status", names::StatusSuspect, mass->GetStatus());
  CheckTrue("missing: it is named", Says(mass, "left out: lid"));
  CheckTrue("missing: an empty block is not", !Says(mass, "nothing"));
  Check("missing: the volume of the others", expected.Volume, mass->GetVolume(), 1e-9 * expected.Volume);
  const std::string text =
    GetFieldText(vtkTable::SafeDownCast(mass->GetOutputDataObject(2))->GetRowData(), names::Text);
  CheckTrue("missing: the text begins with it",
    text.rfind("Status: suspect\n1 part of the input has no exact", 0) == 0);
  mass->SetAssemblyName("Hierarchy");
  mass->AddSelector("/Root/ball");
  mass->Update();
  CheckEqual("not selected: status", names::StatusOk, mass->GetStatus());
}
}

int TestMassPropertiesSelection(int argc, char* argv[])
{
  RequireUsage(argc >= 2, "TestMassPropertiesSelection FOLDER");
  const Manifest manifest(argv[1]);
  CheckPartsList(Manifest(argv[1]));
  CheckSelectors(manifest);
  CheckShared(manifest);
  CheckMeshes(manifest);
  CheckSharedArrays(manifest);
  CheckColors(manifest);
  CheckMissingParts(manifest);
  return smtest::Finish();
}
