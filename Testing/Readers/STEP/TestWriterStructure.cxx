// TestWriterStructure SOLIDS OUTPUT: what vtkSTEPWriter keeps in addition to the geometry: assembly,
// instances, names, colours, materials.
#include "smRoundTrip.h"
#include "smTestManifest.h"
#include "smWriterFiles.h"

#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataAssembly.h>
#include <vtkInformation.h>
#include <vtkMatrix4x4.h>
#include <vtkNURBSDataSet.h>
#include <vtkNURBSTransform.h>
#include <vtkPartitionedDataSet.h>
#include <vtkUnsignedCharArray.h>

#include <map>
#include <set>

namespace
{
using namespace smtest;

/// Two boxes and their mirror images in an assembly, with colours, a material and a layer.
vtkSmartPointer<vtkPartitionedDataSetCollection> MakeStructure(const std::string& folder)
{
  const auto source = ReadFile(Manifest(folder).GetSolid("slanted_hole", "plain")[0].Path);
  auto* part = vtkNURBSDataSet::SafeDownCast(source->GetPartitionAsDataObject(0, 0));
  vtkNew<vtkTrimmedNURBSModel> model;
  model->ShallowCopy(part->GetModel());
  model->SetName("bored block");
  model->SetMaterial("Steel");
  model->SetDensity(7850.0);
  model->SetFileUnit("cm");
  const auto red = std::make_shared<sm::Face>(*model->GetFaces()[2]);
  red->Color = { 0.75, 0.11, 0.2 };
  red->Name = "bore's face";
  model->SetFace(2, red);
  auto result = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  vtkNew<vtkDataAssembly> assembly;
  assembly->SetRootNodeName("STEP");
  const int top = assembly->AddNode("Top", 0);
  assembly->SetAttribute(top, "label", "Top / 1");
  const int sub = assembly->AddNode("Sub", top);
  for (unsigned int i = 0; i < 4; ++i)
  {
    vtkNew<vtkNURBSDataSet> leaf;
    leaf->ShallowCopy(part);
    leaf->SetModel(model);
    vtkNew<vtkMatrix4x4> place;
    const double turn = 0.3 + i;
    place->SetElement(0, 0, (i < 2 ? -1 : 1) * std::cos(turn));
    place->SetElement(1, 0, (i < 2 ? -1 : 1) * std::sin(turn));
    place->SetElement(0, 1, -std::sin(turn));
    place->SetElement(1, 1, std::cos(turn));
    place->SetElement(2, 3, 200.0 * i);
    leaf->SetPlacement(place);
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetName("Color");
    colors->SetNumberOfComponents(3);
    vtkDataArray* faces = leaf->GetCellData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName());
    for (vtkIdType c = 0; c < faces->GetNumberOfTuples(); ++c)
    {
      const double blue[3] = { 20, 40, 250 };
      const double own[3] = { std::round(0.75 * 255), std::round(0.11 * 255), std::round(0.2 * 255) };
      const double green[3] = { 10, 200, 30 };
      colors->InsertNextTuple(i == 3 ? green : faces->GetComponent(c, 0) == 2.0 ? own : blue);
    }
    leaf->GetCellData()->AddArray(colors);
    result->SetPartition(i, 0, leaf);
    const std::string name = "block " + std::to_string(i);
    result->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), name.c_str());
    const int node = assembly->AddNode("Block", i < 2 ? sub : top);
    assembly->SetAttribute(node, "label", "Block");
    assembly->SetAttribute(node, "layer", "metal");
    assembly->AddDataSetIndex(node, i);
  }
  result->SetDataAssembly(assembly);
  return result;
}

std::string DescribeTree(vtkDataAssembly* assembly, int node, bool root = true)
{
  std::string text = root ? "" : assembly->GetAttributeOrDefault(node, "label", "?");
  text += root ? "" : std::string("[") + assembly->GetAttributeOrDefault(node, "layer", "") + "]";
  for (const unsigned int i : assembly->GetDataSetIndices(node, false))
  {
    text += " " + std::to_string(i);
  }
  text += "(";
  for (const int child : assembly->GetChildNodes(node, false))
  {
    text += DescribeTree(assembly, child, false);
  }
  return text + ")";
}

bool HaveSameColors(vtkPartitionedDataSetCollection* a, vtkPartitionedDataSetCollection* b)
{
  for (unsigned int i = 0; i < a->GetNumberOfPartitionedDataSets(); ++i)
  {
    std::map<int, std::string> colors[2];
    for (int k = 0; k < 2; ++k)
    {
      auto* leaf = vtkPolyData::SafeDownCast((k == 0 ? a : b)->GetPartitionAsDataObject(i, 0));
      vtkDataArray* rgb = leaf->GetCellData()->GetArray("Color");
      vtkDataArray* face = leaf->GetCellData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName());
      for (vtkIdType c = 0; rgb && c < rgb->GetNumberOfTuples(); ++c)
      {
        std::string& text = colors[k][static_cast<int>(face->GetComponent(c, 0))];
        text.clear();
        for (int x = 0; x < 3; ++x)
        {
          text += std::to_string(static_cast<int>(rgb->GetComponent(c, x))) + " ";
        }
      }
    }
    if (colors[0].empty() || colors[0] != colors[1])
    {
      std::printf("leaf %u: face 0 %s> %s; face 2 %s> %s\n", i, colors[0][0].c_str(), colors[1][0].c_str(),
        colors[0][2].c_str(), colors[1][2].c_str());
      return false;
    }
  }
  return true;
}

void CheckStructure(const std::string& folder)
{
  const auto before = MakeStructure(folder);
  std::string messages;
  const auto after = Save("structure", before, &messages);
  if (!after)
  {
    return;
  }
  CompareProperties("structure", before, after, 1e-13, 700.0);
  const Properties a = Weigh(before);
  CheckKernel(Output + "/structure.brep", "structure", before, a.Volume, a.Area);
  const auto models = GetModels(after);
  CheckEqual("instances", 4, static_cast<long long>(models.size()));
  CheckTrue("plain ones share a model", models[2] == models[3]);
  CheckTrue("mirrored ones share another", models[0] == models[1] && models[2] != models[0]);
  CheckTrue("a message says so",
    messages.find("1 part is saved mirrored as a part of its own") != std::string::npos, messages);
  CheckEqual("tree",
    "(Top / 1[](Sub[](Block (mirrored) (1)[metal] 0()Block (mirrored) (2)[metal] 1())Block (1)[metal] 2()"
    "Block (2)[metal] 3()))",
    DescribeTree(after->GetDataAssembly(), 0));
  CheckEqual("body's name", "bored block", models[0]->GetName());
  CheckEqual("face's name", "bore's face", models[0]->GetFaces()[2]->Name);
  CheckEqual("material", "Steel", models[2]->GetMaterial());
  Check("density", 7850.0, models[0]->GetDensity(), 1e-9, "seven digits and more");
  CheckEqual("the file's unit", "cm", models[0]->GetFileUnit());
  CheckTrue("colours of bodies, faces and an instance", HaveSameColors(before, after));
  Check("the colour's digits", 0.75, models[0]->GetFaces()[2]->Color[0], 1e-6, "OpenCASCADE keeps floats");
  CheckTrue(
    "the header names us", ReadAll(Output + "/structure.step").find("SolidMoments") != std::string::npos);
}

/// Two turns of the mirror are none: a mirrored part is rigid again, and saved as an instance of the same
/// model.
void CheckInstances(const std::string& folder)
{
  const Expected many = Manifest(folder).GetSpecial("assembly");
  const auto assembly = ReadFile(many.Path);
  const auto manyAfter = Save("assembly500", assembly);
  CompareProperties("500 instances", assembly, manyAfter, 1e-12);
  std::set<vtkTrimmedNURBSModel*> distinct;
  for (const auto& model : GetModels(manyAfter))
  {
    distinct.insert(model);
  }
  CheckEqual("500 instances: models", 1, static_cast<long long>(distinct.size()));
  for (const char* special : { "two_solids", "open_shell", "open_solid" })
  {
    const auto data = ReadFile(Manifest(folder).GetSpecial(special).Path);
    CompareProperties(special, data, Save(special, data), 1e-13);
  }
}

/// Two bodies of the same faces and of different materials are two parts.
void CheckMaterials(vtkPartitionedDataSetCollection* box)
{
  vtkNew<vtkPartitionedDataSetCollection> pair;
  for (const double density : { 2700.0, 7850.0 })
  {
    vtkNew<vtkNURBSDataSet> leaf;
    leaf->ShallowCopy(box->GetPartitionAsDataObject(0, 0));
    vtkNew<vtkTrimmedNURBSModel> model;
    model->ShallowCopy(leaf->GetModel());
    model->SetDensity(density);
    leaf->SetModel(model);
    pair->SetPartition(pair->GetNumberOfPartitionedDataSets(), 0, leaf);
  }
  const auto saved = GetModels(Save("materials", pair));
  CheckEqual("two bodies", 2, static_cast<long long>(saved.size()));
  Check("density of the first", 2700.0, saved.front()->GetDensity(), 1e-9, "seven digits and more");
  Check("density of the second", 7850.0, saved.back()->GetDensity(), 1e-9, "seven digits and more");
}

/// A file has the lengths and the unit that it was asked for.
void CheckUnits(vtkPartitionedDataSetCollection* box)
{
  for (const char* unit : { "mm", "cm", "m", "um", "inch", "ft" })
  {
    const std::string name = std::string("unit_") + unit;
    const std::string path = Output + "/" + name + ".step";
    vtkNew<vtkSTEPWriter> writer;
    writer->SetInputDataObject(box);
    writer->SetFileName(path.c_str());
    writer->SetOutputUnit(unit);
    CheckEqual(name + " is written", 1, writer->Write());
    const auto after = ReadFile(path);
    // A factor that is not a double, on the way to the file and on the way back.
    CompareProperties(name, box, after, 2e-14);
    const auto models = GetModels(after);
    CheckEqual(name + ": the file's", unit, models.empty() ? "" : models[0]->GetFileUnit());
  }
}

/// Any text is a name.
void CheckNames(vtkPartitionedDataSetCollection* box)
{
  vtkNew<vtkNURBSDataSet> odd;
  odd->ShallowCopy(box->GetPartitionAsDataObject(0, 0));
  vtkNew<vtkTrimmedNURBSModel> named;
  named->ShallowCopy(odd->GetModel());
  const std::string name = "O'Ring \\ \"\xC3\xBC\" #1;";
  named->SetName(name);
  named->SetMaterial(name);
  const auto renamed = std::make_shared<sm::Face>(*named->GetFaces()[1]);
  renamed->Name = name;
  named->SetFace(1, renamed);
  odd->SetModel(named);
  const auto again = GetModels(Save("names", odd));
  CheckEqual("a body's odd name", name, again.empty() ? "" : again[0]->GetName());
  CheckEqual("a material's odd name", name, again.empty() ? "" : again[0]->GetMaterial());
  CheckEqual("a face's odd name", name, again.empty() ? "" : again[0]->GetFaces()[1]->Name);
}

/// An assembly whose only part OpenCASCADE refuses is left out.
void CheckRefusedPart(vtkPartitionedDataSetCollection* box)
{
  vtkNew<vtkPartitionedDataSetCollection> halves;
  vtkNew<vtkDataAssembly> tree;
  for (unsigned int i = 0; i < 2; ++i)
  {
    vtkNew<vtkNURBSDataSet> leaf;
    leaf->ShallowCopy(box->GetPartitionAsDataObject(0, 0));
    vtkNew<vtkTrimmedNURBSModel> model;
    model->ShallowCopy(leaf->GetModel());
    for (int f = 0; i == 0 && f < 6; ++f)
    {
      const auto bad = std::make_shared<sm::Face>(*model->GetFaces()[f]);
      bad->Surface.ControlPoints[0][3] = -1.0;
      model->SetFace(f, bad);
    }
    leaf->SetModel(model);
    halves->SetPartition(i, 0, leaf);
    const int node = tree->AddNode(i == 0 ? "Bad" : "Good", 0);
    tree->AddDataSetIndex(tree->AddNode("Part", node), i);
  }
  halves->SetDataAssembly(tree);
  const auto half = Save("half", halves);
  CheckEqual(
    "what is left", "(Good[](Part[] 0()))", half ? DescribeTree(half->GetDataAssembly(), 0) : "nothing");
}

/// A part that was moved keeps its own coordinates and stands in an assembly.
void CheckMoved(const std::string& folder)
{
  vtkNew<vtkNURBSTransform> move;
  move->SetInputDataObject(ReadFile(Manifest(folder).GetSolid("hollow_sphere", "plain")[0].Path));
  move->SetTranslation(1e5, 0.0, 0.0);
  move->SetMirror(vtkNURBSTransform::X);
  move->Update();
  CompareProperties(
    "moved", move->GetOutputDataObject(0), Save("moved_far", move->GetOutputDataObject(0)), 1e-13);
}
}

int TestWriterStructure(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::fprintf(stderr, "usage: TestWriterStructure SOLIDS OUTPUT\n");
    return 1;
  }
  const std::string folder = argv[1];
  Output = MakeFolder(argv[2], "writers-structure");
  CheckStructure(folder);
  CheckInstances(folder);
  const auto box = ReadFile(Manifest(folder).GetSolid("box", "plain")[0].Path);
  CheckMaterials(box);
  CheckUnits(box);
  CheckNames(box);
  CheckRefusedPart(box);
  CheckMoved(folder);
  return Finish();
}
