// TestDisplayMeshDemand SOLIDS: a reader makes points and triangles when something downstream needs them,
// later without reading the file again, and exact results have the same bits whenever that is.
#include "smTestManifest.h"
#include "smTestPipeline.h"

#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSet.h>
#include <vtkElevationFilter.h>
#include <vtkMath.h>
#include <vtkNURBSDataSet.h>
#include <vtkNURBSDeform.h>
#include <vtkNURBSTransform.h>
#include <vtkObjectFactory.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkTable.h>
#include <vtkTrimmedNURBSModel.h>

#include <cstring>
#include <functional>
#include <string>
#include <vector>

namespace
{
using namespace smtest;
namespace names = sm::names;

/// Counts how often a file is read.
class CountingReader : public vtkSTEPReader
{
public:
  static CountingReader* New();
  vtkTypeMacro(CountingReader, vtkSTEPReader);
  int Readings = 0;

protected:
  void InspectDocument(const sm::Document&) override { ++this->Readings; }
};
vtkStandardNewMacro(CountingReader);

vtkIdType CountPoints(vtkDataObject* data)
{
  auto* tree = vtkCompositeDataSet::SafeDownCast(data);
  auto* set = vtkDataSet::SafeDownCast(data);
  return tree ? tree->GetNumberOfPoints() : set ? set->GetNumberOfPoints() : -1;
}

vtkNURBSDataSet* GetLeaf(vtkAlgorithm* algorithm, unsigned int index)
{
  auto* tree = vtkPartitionedDataSetCollection::SafeDownCast(algorithm->GetOutputDataObject(0));
  return tree ? vtkNURBSDataSet::SafeDownCast(tree->GetPartitionAsDataObject(index, 0)) : nullptr;
}

/// Totals and the tables of solids, faces and edges, bit by bit, with the status and the messages.
struct Results
{
  std::vector<double> Numbers;
  std::string Text;
};

Results Collect(vtkMassPropertiesGPU* mass)
{
  Results results;
  results.Numbers = GetFieldNumbers(mass->GetOutput()->GetFieldData());
  for (const int port : { 1, 3, 4 })
  {
    auto* table = vtkTable::SafeDownCast(mass->GetOutputDataObject(port));
    const std::vector<double> more = GetFieldNumbers(table->GetRowData());
    results.Numbers.insert(results.Numbers.end(), more.begin(), more.end());
  }
  results.Text = mass->GetStatus() + "\n" + GetMessages(mass);
  return results;
}

void CheckSame(const std::string& what, const Results& expected, const Results& actual)
{
  const std::vector<double>& a = expected.Numbers;
  const std::vector<double>& b = actual.Numbers;
  CheckTrue(what + ": the same bits",
    a.size() == b.size() && a.size() > 50 && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0,
    std::to_string(a.size()) + " numbers");
  CheckEqual(what + ": status and messages", expected.Text, actual.Text);
}

/// Reader, a filter between where there is one, mass properties, and something that shows points.
struct Scene
{
  vtkNew<CountingReader> Reader;
  vtkSmartPointer<vtkAlgorithm> Between;
  vtkNew<vtkMassPropertiesGPU> Mass;
  vtkNew<vtkElevationFilter> View;

  explicit Scene(const std::string& path, vtkAlgorithm* between = nullptr)
    : Between(between)
  {
    this->Reader->SetFileName(path.c_str());
    if (between)
    {
      between->SetInputConnection(this->Reader->GetOutputPort());
    }
    this->Mass->SetBackend(vtkMassPropertiesGPU::CPU);
    this->Mass->SetInputConnection(this->GetSource()->GetOutputPort());
  }
  vtkAlgorithm* GetSource() { return this->Between ? this->Between.Get() : this->Reader.Get(); }
  vtkIdType GetReaderPoints() { return CountPoints(this->Reader->GetOutputDataObject(0)); }
  /// Connects the view, also to a port of the mass filter, and updates it.
  vtkIdType Show(vtkAlgorithmOutput* port)
  {
    this->View->SetInputConnection(port);
    this->View->Update();
    return CountPoints(this->View->GetOutputDataObject(0));
  }
  vtkIdType Show() { return this->Show(this->GetSource()->GetOutputPort()); }
};

/// The filter that is between, made anew for each scene; null for none.
using MakeBetween = std::function<vtkSmartPointer<vtkAlgorithm>()>;

void CheckOrders(const std::string& what, const std::string& path, const MakeBetween& make)
{
  std::printf("--- %s\n", what.c_str());
  Scene first(path, make());
  first.Mass->Update();
  const Results alone = Collect(first.Mass);
  CheckEqual(what + ": points for the mass filter alone", 0, first.GetReaderPoints());
  CheckEqual(what + ": points behind it", 0, CountPoints(first.Mass->GetOutputDataObject(5)));
  CheckTrue(
    what + ": exact geometry", GetLeaf(first.GetSource(), 0) && GetLeaf(first.GetSource(), 0)->GetModel());
  CheckEqual(what + ": readings", 1, first.Reader->Readings);
  const vtkIdType points = first.Show();
  CheckTrue(what + ": points for a view", points > 0, std::to_string(points));
  CheckEqual(what + ": points of the reader then", points, first.GetReaderPoints());
  CheckEqual(what + ": readings after the view", 1, first.Reader->Readings);
  first.Mass->Update();
  CheckSame(what + ", after the view", alone, Collect(first.Mass));
  CheckEqual(
    what + ": points behind the mass filter", points, CountPoints(first.Mass->GetOutputDataObject(5)));
  first.Mass->SetDensity(1.0);
  first.Mass->SetDensity(0.0);
  first.Mass->Update();
  CheckSame(what + ", computed again", alone, Collect(first.Mass));
  CheckEqual(what + ": points stay", points, first.GetReaderPoints());

  Scene second(path, make());
  CheckEqual(what + ": points for a view at first", points, second.Show());
  second.Mass->Update();
  CheckSame(what + ", the view first", alone, Collect(second.Mass));
  CheckEqual(what + ": readings, the view first", 1, second.Reader->Readings);

  Scene never(path, make());
  never.Reader->SetDisplayMeshToNever();
  CheckEqual(what + ": points for a view, never", 0, never.Show());
  never.Mass->Update();
  CheckSame(what + ", never", alone, Collect(never.Mass));
  never.Reader->SetDisplayMeshToAlways();
  never.Mass->Update();
  CheckEqual(what + ": points, always", points, never.GetReaderPoints());
  CheckEqual(what + ": readings after both", 1, never.Reader->Readings);
  CheckSame(what + ", always", alone, Collect(never.Mass));
}

/// Without a mesh a leaf has the box of the mesh that would be shown.
void CheckBoxes(const std::string& path)
{
  std::printf("--- boxes\n");
  Scene scene(path);
  scene.Mass->Update();
  double bare[6];
  GetLeaf(scene.Reader, 7)->GetBounds(bare);
  const unsigned long bareSize = scene.Reader->GetOutput()->GetActualMemorySize();
  scene.Show();
  double shown[6];
  GetLeaf(scene.Reader, 7)->GetBounds(shown);
  for (int i = 0; i < 6; ++i)
  {
    CheckEqual("bound " + std::to_string(i), shown[i], bare[i]);
  }
  const unsigned long size = scene.Reader->GetOutput()->GetActualMemorySize();
  const double points = static_cast<double>(scene.GetReaderPoints());
  CheckRange("bytes more for each point of 500 instances", 36.0,
    1024.0 * static_cast<double>(size - bareSize) / points, 200.0,
    "(points, normals and, shared, the rest, which counts in each leaf)");
  auto* a = GetLeaf(scene.Reader, 7);
  auto* b = GetLeaf(scene.Reader, 8);
  CheckTrue("instances share triangles", a->GetPolys() == b->GetPolys() && a->GetNumberOfPolys() > 0);
  CheckTrue("and parameters",
    a->GetPointData()->GetArray(vtkNURBSDataSet::ParametersArrayName()) ==
      b->GetPointData()->GetArray(vtkNURBSDataSet::ParametersArrayName()));
  CheckTrue("and colours", a->GetCellData()->GetArray("Color") == b->GetCellData()->GetArray("Color"));
}

/// A mesh behind a filter of ours is made for what is connected there, and for an Update() of that port.
void CheckPorts(const std::string& path)
{
  std::printf("--- ports\n");
  Scene scene(path);
  scene.Mass->Update();
  const Results alone = Collect(scene.Mass);
  const vtkIdType points = scene.Show(scene.Mass->GetOutputPort(5));
  CheckTrue("points behind the mass filter", points > 0);
  CheckEqual("readings", 1, scene.Reader->Readings);
  CheckSame("with a view behind it", alone, Collect(scene.Mass));

  Scene table(path);
  table.Mass->Update(1);
  CheckEqual("points for a table", 0, table.GetReaderPoints());
  table.Mass->Update(5);
  CheckEqual("points for Update(5)", points, CountPoints(table.Mass->GetOutputDataObject(5)));
  // Mappers call Update() of the filter whose port 5 they draw.
  Scene drawn(path);
  drawn.View->SetInputConnection(drawn.Mass->GetOutputPort(5));
  drawn.Mass->Update();
  CheckEqual(
    "points for Update() with a view behind port 5", points, CountPoints(drawn.Mass->GetOutputDataObject(5)));
  CheckEqual("readings for both", 1, table.Reader->Readings);

  // A second mass filter behind the first.
  Scene chain(path);
  vtkNew<vtkMassPropertiesGPU> again;
  again->SetBackend(vtkMassPropertiesGPU::CPU);
  again->SetInputConnection(chain.Mass->GetOutputPort(5));
  again->Update();
  CheckSame("a mass filter behind a mass filter", alone, Collect(again));
  CheckEqual("points for both", 0, chain.GetReaderPoints());
  CheckEqual("points for a view behind both", points, chain.Show(again->GetOutputPort(5)));
  CheckEqual("readings for the chain", 1, chain.Reader->Readings);

  // A filter of VTK between a reader and one of ours has points to work with.
  Scene mixed(path);
  mixed.View->SetInputConnection(mixed.Reader->GetOutputPort());
  vtkNew<vtkMassPropertiesGPU> behind;
  const MessageTrap trap(behind);
  behind->SetInputConnection(mixed.View->GetOutputPort());
  behind->Update();
  CheckEqual("points of a filter of VTK between", points, CountPoints(mixed.View->GetOutputDataObject(0)));
}

/// An update of the reader itself makes points; other settings of the mesh make it again without reading the
/// file again, and settings of the reading read it again.
void CheckReadings(const std::string& path, const std::string& other)
{
  std::printf("--- readings\n");
  Scene scene(path);
  scene.Mass->Update();
  const Results alone = Collect(scene.Mass);
  scene.Reader->Update();
  const vtkIdType points = scene.GetReaderPoints();
  CheckTrue("points for Update()", points > 0);
  CheckEqual("readings", 1, scene.Reader->Readings);
  scene.Reader->SetLinearDeflection(1e-4);
  scene.Mass->Update();
  CheckTrue("more points for a finer mesh", scene.GetReaderPoints() > points);
  CheckSame("with a finer mesh", alone, Collect(scene.Mass));
  scene.Reader->SetLinearDeflection(0.1);
  scene.Reader->SetAngularDeflection(1.0);
  scene.Mass->Update();
  CheckTrue("fewer points for a coarser mesh", scene.GetReaderPoints() < points);
  CheckSame("with a coarser mesh", alone, Collect(scene.Mass));
  CheckEqual("readings for three meshes", 1, scene.Reader->Readings);
  for (const int piece : { 1, 0 })
  {
    scene.View->SetInputConnection(scene.Reader->GetOutputPort());
    scene.View->UpdatePiece(piece, 2, 0);
    CheckTrue("points of piece " + std::to_string(piece), (scene.GetReaderPoints() > 0) == (piece == 0));
  }
  CheckEqual("readings for pieces", 1, scene.Reader->Readings);

  scene.Reader->Modified();
  scene.Mass->Update();
  CheckEqual("readings after Modified()", 2, scene.Reader->Readings);
  vtkTrimmedNURBSModel* model = GetLeaf(scene.Reader, 0)->GetModel();
  model->SetFace(0, model->GetFaces()[1]);
  scene.Reader->SetLinearDeflection(0.01);
  scene.Mass->Update();
  CheckEqual("readings after an edit in place", 3, scene.Reader->Readings);
  CheckSame("read again", alone, Collect(scene.Mass));
  scene.Reader->SetFileName(other.c_str());
  scene.Reader->SetLinearDeflection(0.02);
  scene.Mass->Update();
  CheckEqual("readings of another file", 4, scene.Reader->Readings);
  CheckTrue("other numbers", Collect(scene.Mass).Numbers != alone.Numbers);

  // Filters that have ended are not asked.
  Scene after(path);
  after.Mass->Update();
  for (int i = 0; i < 20; ++i)
  {
    vtkNew<vtkMassPropertiesGPU> ended;
    ended->SetInputConnection(after.Reader->GetOutputPort());
    ended->UpdateInformation();
  }
  after.Mass->Modified();
  after.Mass->Update();
  CheckEqual("points after filters that have ended", 0, after.GetReaderPoints());

  Scene released(path);
  released.Reader->ReleaseDataFlagOn();
  released.Mass->Update();
  released.Show();
  CheckEqual("readings where data is released", 2, released.Reader->Readings);
}

void CheckCoarse(const std::string& path)
{
  std::printf("--- coarse\n");
  Scene scene(path);
  const vtkIdType points = scene.Show();
  scene.Mass->Update();
  const Results alone = Collect(scene.Mass);
  CheckTrue("as asked for", !scene.Reader->IsMeshCoarse());
  scene.Reader->SetCoarseAbove(1000);
  const vtkIdType coarse = scene.Show();
  CheckRange(
    "points of the coarse mesh", 1.0, static_cast<double>(coarse), 0.5 * static_cast<double>(points));
  CheckTrue("coarse", scene.Reader->IsMeshCoarse());
  scene.Mass->Update();
  CheckSame("coarse", alone, Collect(scene.Mass));
  scene.Reader->RefinedOn();
  CheckEqual("points when refined", points, scene.Show());
  CheckTrue("refined", !scene.Reader->IsMeshCoarse());
  scene.Reader->RefinedOff();
  scene.Reader->SetCoarseAbove(100000000);
  CheckEqual("points below the limit", points, scene.Show());
  CheckEqual("readings", 1, scene.Reader->Readings);
}

/// Checks of shells go by the mesh of the scales after an edit, too, and not by the coarse one that is shown.
void CheckEditOfCoarse(const std::string& path, const MakeBetween& make)
{
  Scene scene(path, make());
  scene.Reader->SetCoarseAbove(1000);
  const vtkIdType shown = scene.Show();
  CheckTrue("coarse before the edit", scene.Reader->IsMeshCoarse());
  vtkIdType points = 0;
  double bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  if (vtkNURBSDataSet* leaf = GetLeaf(scene.Between, 0))
  {
    vtkPolyData* mesh = leaf->GetModel()->GetScaleMesh();
    points = mesh ? mesh->GetNumberOfPoints() : 0;
    mesh ? mesh->GetBounds(bounds) : void();
  }
  CheckTrue("the mesh of the scales is finer", points > shown, std::to_string(points) + " points");
  double before[6];
  GetLeaf(scene.Reader, 0)->GetModel()->GetScaleMesh()->GetBounds(before);
  CheckRange("it was moved with the edit, in x", 1e-3, std::abs(bounds[1] - before[1]), 1.0);
}
}

int TestDisplayMeshDemand(int argc, char** argv)
{
  if (argc < 2)
  {
    return EXIT_FAILURE;
  }
  const std::string folder = argv[1];
  const std::string assembly = folder + "/assembly.step";
  const std::string hollow = folder + "/hollow_sphere-plain.step";
  const auto none = []() { return vtkSmartPointer<vtkAlgorithm>(); };
  const auto move = []()
  {
    auto transform = vtkSmartPointer<vtkNURBSTransform>::New();
    transform->SetTranslation(1.0, 2.0, 3.0);
    transform->SetRotation(10.0, 20.0, 30.0);
    return vtkSmartPointer<vtkAlgorithm>(transform);
  };
  const auto deform = []()
  {
    auto filter = vtkSmartPointer<vtkNURBSDeform>::New();
    filter->SetDisplacement(0.1, 0.2, 0.0);
    filter->SetCenter(0.0, 0.0, 0.0);
    filter->SetRadius(1e3);
    return vtkSmartPointer<vtkAlgorithm>(filter);
  };
  CheckOrders("assembly", assembly, none);
  CheckOrders("hollow sphere", hollow, none);
  CheckOrders("mirrored", folder + "/bicylinder-mirrored.step", none);
  CheckOrders("moved assembly", assembly, move);
  CheckOrders("deformed hollow sphere", hollow, deform);
  CheckBoxes(assembly);
  CheckPorts(assembly);
  CheckReadings(assembly, hollow);
  CheckCoarse(assembly);
  CheckEditOfCoarse(hollow, deform);
  return Finish();
}
