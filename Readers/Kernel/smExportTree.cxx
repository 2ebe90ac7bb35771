#include "smExportTree.h"

#include "smExportColors.h"
#include "smFormat.h"
#include "smInstanceNames.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataAssembly.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkNURBSDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace sm
{
namespace
{
/// Placements are equal if their entries differ by no more than this, relative to 1 or, for translations, to
/// the larger one.
constexpr double SamePlacement = 1e-12;

/// Largest deviation of a rotation's rows from orthonormality.
constexpr double RigidTolerance = 1e-12;

struct Leaf
{
  vtkSmartPointer<vtkNURBSDataSet> Data;
  std::string Name;
  bool Used = false;
};

MatrixRows GetPlace(vtkNURBSDataSet* leaf)
{
  vtkNew<vtkMatrix4x4> matrix;
  leaf->GetPlacement(matrix);
  MatrixRows place;
  std::copy_n(matrix->GetData(), 12, place.begin());
  return place;
}

/// Returns true for a finite 4x4 matrix with the last row 0 0 0 1.
bool IsAffine(const double* m)
{
  return std::all_of(m, m + 16, [](double entry) { return std::isfinite(entry); }) && m[12] == 0.0 &&
    m[13] == 0.0 && m[14] == 0.0 && m[15] == 1.0;
}

MatrixRows Multiply(const MatrixRows& a, const MatrixRows& b)
{
  MatrixRows c{};
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      c[4 * i + j] = j == 3 ? a[4 * i + 3] : 0.0;
      for (int k = 0; k < 3; ++k)
      {
        c[4 * i + j] += a[4 * i + k] * b[4 * k + j];
      }
    }
  }
  return c;
}

/// Returns the inverse of a rigid placement.
MatrixRows Invert(const MatrixRows& a)
{
  MatrixRows b{};
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      b[4 * i + j] = a[4 * j + i];
      b[4 * i + 3] -= a[4 * j + i] * a[4 * j + 3];
    }
  }
  return b;
}

double GetDeterminant(const MatrixRows& m)
{
  return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
    m[2] * (m[4] * m[9] - m[5] * m[8]);
}

bool IsRigid(const MatrixRows& m)
{
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      double dot = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        dot += m[4 * i + k] * m[4 * j + k];
      }
      if (!(std::abs(dot - (i == j ? 1.0 : 0.0)) <= RigidTolerance))
      {
        return false;
      }
    }
  }
  return true;
}

bool AreSame(const MatrixRows& a, const MatrixRows& b)
{
  double scale = 1.0;
  for (int i = 3; i < 12; i += 4)
  {
    scale = std::max({ scale, std::abs(a[i]), std::abs(b[i]) });
  }
  for (int i = 0; i < 12; ++i)
  {
    if (std::abs(a[i] - b[i]) > SamePlacement * (i % 4 == 3 ? scale : 1.0))
    {
      return false;
    }
  }
  return true;
}

/// Returns true if two models have the same faces and the same material, as copies of one model have.
bool AreSame(vtkTrimmedNURBSModel* a, vtkTrimmedNURBSModel* b)
{
  return a == b ||
    (a->GetFaces() == b->GetFaces() && a->GetShells() == b->GetShells() && a->GetName() == b->GetName() &&
      a->GetBody() == b->GetBody() && a->GetMaterial() == b->GetMaterial() &&
      a->GetDensity() == b->GetDensity() && std::equal(a->GetOrigin(), a->GetOrigin() + 3, b->GetOrigin()));
}

class TreeMaker
{
public:
  ExportTree Make(vtkDataObject* data)
  {
    vtkDataAssembly* assembly = this->Collect(data);
    if (assembly)
    {
      for (const int child : assembly->GetChildNodes(vtkDataAssembly::GetRootNode(), false))
      {
        this->AddNode(assembly, child, this->Tree.Root);
      }
      this->RootName = GetLabel(assembly, vtkDataAssembly::GetRootNode());
    }
    for (Leaf& leaf : this->Leaves)
    {
      if (!leaf.Used)
      {
        ExportNode node;
        node.Name = leaf.Name;
        this->AddPart({ &leaf }, node);
        this->Tree.Root.Children.push_back(node);
      }
    }
    this->PlaceRoots();
    if (this->Mirrored > 0)
    {
      this->Tree.Notes.push_back(FormatCount(this->Mirrored, "part is saved", "parts are saved") +
        " mirrored as a part of its own: a file cannot place a part mirrored.");
    }
    return std::move(this->Tree);
  }

private:
  vtkDataAssembly* Collect(vtkDataObject* data)
  {
    auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data);
    if (collection)
    {
      this->LeavesOf.resize(collection->GetNumberOfPartitionedDataSets());
      for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
      {
        vtkInformation* info = collection->HasMetaData(i) ? collection->GetMetaData(i) : nullptr;
        const char* name = info ? info->Get(vtkCompositeDataSet::NAME()) : nullptr;
        for (unsigned int k = 0; k < collection->GetNumberOfPartitions(i); ++k)
        {
          const std::size_t before = this->Leaves.size();
          this->AddLeaf(collection->GetPartitionAsDataObject(i, k), name ? name : "");
          if (this->Leaves.size() > before)
          {
            this->LeavesOf[i].push_back(before);
          }
        }
      }
      return collection->GetDataAssembly();
    }
    if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
    {
      const auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
      for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
      {
        vtkInformation* info = it->HasCurrentMetaData() ? it->GetCurrentMetaData() : nullptr;
        const char* name = info ? info->Get(vtkCompositeDataSet::NAME()) : nullptr;
        this->AddLeaf(it->GetCurrentDataObject(), name ? name : "");
      }
      return nullptr;
    }
    this->AddLeaf(data, "");
    return nullptr;
  }

  void AddLeaf(vtkDataObject* data, const std::string& name)
  {
    auto* dataset = vtkDataSet::SafeDownCast(data);
    auto* leaf = vtkNURBSDataSet::SafeDownCast(data);
    vtkTrimmedNURBSModel* model = leaf ? leaf->GetModel() : nullptr;
    const std::string called = name.empty() ? "A dataset" : "\"" + name + "\"";
    if (!model || model->GetNumberOfFaces() == 0)
    {
      if (leaf && leaf->IsModelWithheld())
      {
        this->Tree.Warnings.push_back(called +
          " is not saved: its points were changed since its exact geometry was made. Move it with "
          "NURBS Transform, deform it with NURBS Deform.");
      }
      else if (dataset && (model || dataset->GetNumberOfPoints() > 0))
      {
        this->Tree.Warnings.push_back(
          called + " is not saved: it has no exact geometry" + (model ? " (no faces)." : ", only a mesh."));
      }
      return;
    }
    if (!IsAffine(leaf->GetPlacementData()))
    {
      this->Tree.Warnings.push_back(called + " is not saved: its placement is not finite, or projects it.");
      return;
    }
    if (this->Leaves.empty())
    {
      this->Tree.LengthUnit = model->GetLengthUnit();
      this->Tree.FileUnit = model->GetFileUnit();
    }
    else if (model->GetLengthUnit() != this->Tree.LengthUnit)
    {
      this->Tree.Warnings.push_back(called + " is not saved: its lengths are in " + model->GetLengthUnit() +
        ", those of the first body in " + this->Tree.LengthUnit + ".");
      return;
    }
    this->Leaves.push_back({ leaf, GetPartName(*leaf, name), false });
  }

  static std::string GetLabel(vtkDataAssembly* assembly, int node)
  {
    const std::string label = GetFileName(*assembly, node);
    return label.empty() ? assembly->GetNodeName(node) : label;
  }

  void AddNode(vtkDataAssembly* assembly, int id, ExportNode& parent)
  {
    ExportNode node;
    node.Name = GetLabel(assembly, id);
    node.Layer = assembly->GetAttributeOrDefault(id, "layer", "");
    std::vector<Leaf*> leaves;
    for (const unsigned int index : assembly->GetDataSetIndices(id, false))
    {
      for (const std::size_t place :
        index < this->LeavesOf.size() ? this->LeavesOf[index] : std::vector<std::size_t>())
      {
        if (!this->Leaves[place].Used)
        {
          leaves.push_back(&this->Leaves[place]);
        }
      }
    }
    for (const int child : assembly->GetChildNodes(id, false))
    {
      this->AddNode(assembly, child, node);
    }
    if (!leaves.empty() && node.Children.empty())
    {
      this->AddPart(leaves, node);
    }
    else if (!leaves.empty())
    {
      ExportNode own;
      own.Name = node.Name;
      this->AddPart(leaves, own);
      node.Children.push_back(own);
    }
    if (node.Part >= 0 || !node.Children.empty())
    {
      parent.Children.push_back(node);
    }
  }

  /// Adds a part to a node. Its placement is that of the first leaf; the other leaves are placed relative to
  /// it.
  void AddPart(const std::vector<Leaf*>& leaves, ExportNode& node)
  {
    ExportPart part;
    part.Name = node.Name.empty() ? leaves[0]->Name : node.Name;
    part.Name = part.Name.empty() ? "Part" : part.Name;
    part.Layer = node.Layer;
    node.Name = part.Name;
    node.Place = GetPlace(leaves[0]->Data);
    const bool rigid = IsRigid(node.Place);
    const bool mirrored = rigid && GetDeterminant(node.Place) < 0.0;
    MatrixRows own = IdentityPlacement;
    if (!rigid)
    {
      std::swap(own, node.Place);
      this->Tree.Notes.push_back(
        "\"" + part.Name + "\" is saved deformed: its placement is not rigid, which a file cannot hold.");
    }
    else if (mirrored)
    {
      // The mirror x -> -x is exact and its own inverse.
      own[0] = -1.0;
      node.Place = Multiply(node.Place, own);
      part.Name += " (mirrored)";
    }
    const MatrixRows back = Invert(node.Place);
    Color instance{ -1.0, -1.0, -1.0 };
    for (Leaf* leaf : leaves)
    {
      leaf->Used = true;
      ExportBody body;
      body.Model = leaf->Data->GetModel();
      const MatrixRows place = GetPlace(leaf->Data);
      body.Own = AreSame(place, GetPlace(leaves[0]->Data)) ? own : Multiply(back, place);
      ReadColors(leaf->Data, body, instance);
      part.Bodies.push_back(std::move(body));
    }
    node.Part = this->FindPart(part);
    if (node.Part < 0)
    {
      node.Part = static_cast<int>(this->Tree.Parts.size());
      this->Tree.Parts.push_back(part);
      this->Mirrored += mirrored ? 1 : 0;
      this->AddFitNotes(part);
    }
    else if (instance[0] < 0.0)
    {
      instance = GetDifference(this->Tree.Parts[node.Part].Bodies, part.Bodies);
    }
    node.InstanceColor = instance;
  }

  /// Adds notes about fitted surfaces: the bounds of the reader refer to the original surface, but the file
  /// contains only the fit.
  void AddFitNotes(const ExportPart& part)
  {
    int fits = 0;
    double worst = 0.0;
    for (const ExportBody& body : part.Bodies)
    {
      for (const FacePointer& face : body.Model->GetFaces())
      {
        fits += face->Surface.Residual > 0.0 ? 1 : 0;
        worst = std::max(worst, face->Surface.Residual);
      }
    }
    if (fits > 0)
    {
      this->Tree.Notes.push_back("\"" + part.Name + "\": " + FormatCount(fits, "face is", "faces are") +
        " saved as the reader fitted them, offset surfaces having no exact form: good to " +
        FormatDistance(worst) + " " + this->Tree.LengthUnit + ".");
    }
  }

  int FindPart(const ExportPart& part) const
  {
    for (std::size_t i = 0; i < this->Tree.Parts.size(); ++i)
    {
      const ExportPart& known = this->Tree.Parts[i];
      if (std::equal(part.Bodies.begin(), part.Bodies.end(), known.Bodies.begin(), known.Bodies.end(),
            [](const ExportBody& a, const ExportBody& b)
            { return AreSame(a.Model, b.Model) && AreSame(a.Own, b.Own); }))
      {
        return static_cast<int>(i);
      }
    }
    return -1;
  }

  void PlaceRoots()
  {
    ExportNode& root = this->Tree.Root;
    bool plain = true;
    std::set<int> seen;
    for (const ExportNode& node : root.Children)
    {
      plain = plain &&
        (node.Part < 0 ||
          (node.Place == IdentityPlacement && node.InstanceColor[0] < 0.0 && seen.insert(node.Part).second));
    }
    if (plain)
    {
      return;
    }
    ExportNode above;
    above.Name = this->RootName.empty() ? "Assembly" : this->RootName;
    above.Children = std::move(root.Children);
    root.Children = { above };
  }

  std::vector<Leaf> Leaves;
  /// Indices into Leaves for each partitioned dataset.
  std::vector<std::vector<std::size_t>> LeavesOf;
  std::string RootName;
  int Mirrored = 0;
  ExportTree Tree;
};
}

ExportTree MakeExportTree(vtkDataObject* data)
{
  return TreeMaker().Make(data);
}
}
