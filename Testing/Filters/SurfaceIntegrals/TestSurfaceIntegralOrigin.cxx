// TestSurfaceIntegralOrigin FOLDER PART: the volume of a closed model does not depend on the origin. Every
// exact solid, those whose trims are projections with real gaps, and a real part, moved by ten sizes in seven
// directions; the volume is integrated about the world's origin, where a hole in the chain of 1e-13 of the
// area would show.
#include "smTestManifest.h"
#include "smTestPipeline.h"

#include <vtkMatrix4x4.h>
#include <vtkNURBSDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSurfaceIntegralGPU.h>

namespace
{
using namespace smtest;

vtkNURBSDataSet* ReadLeaf(vtkSTEPReader* reader, const std::string& path)
{
  reader->SetFileName(path.c_str());
  UseCoarseMesh(reader);
  reader->Update();
  auto* output = vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(0));
  return output && output->GetNumberOfPartitionedDataSets() > 0
    ? vtkNURBSDataSet::SafeDownCast(output->GetPartition(0, 0))
    : nullptr;
}

/// Integrals over a leaf whose placement is followed by a translation.
class Movable
{
public:
  explicit Movable(vtkNURBSDataSet* leaf)
    : Leaf(leaf)
  {
    this->Integral->AddVolumeMoment("volume", 0, 0, 0);
    this->Integral->AddIntegrand("faces", "dot(position, normal) / 3.0LF", vtkSurfaceIntegralGPU::FACES);
    this->Integral->SetRelativeTolerance(1e-13);
    this->Integral->SetInputDataObject(this->Copy);
  }

  void MoveBy(const double x, const double y, const double z)
  {
    vtkNew<vtkMatrix4x4> placement;
    this->Leaf->GetPlacement(placement);
    const double shift[3] = { x, y, z };
    for (int i = 0; i < 3; ++i)
    {
      placement->SetElement(i, 3, placement->GetElement(i, 3) + shift[i]);
    }
    this->Copy->ShallowCopy(this->Leaf);
    this->Copy->SetPlacement(placement);
    this->Integral->Update();
  }

  double Get(const char* name) const { return this->Integral->GetIntegral(name); }
  double GetBound(const char* name) const { return this->Integral->GetIntegralBound(name); }

private:
  vtkNURBSDataSet* Leaf;
  vtkNew<vtkNURBSDataSet> Copy;
  vtkNew<vtkSurfaceIntegralGPU> Integral;
  /// A tolerance below rounding is not met and warned of, which does not matter here.
  MessageTrap Messages{ this->Integral };
};

const double Directions[][3] = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 },
  { 0.36, -0.48, -0.8 }, { -2.0 / 3, 2.0 / 3, 1.0 / 3 } };

/// `expected` is null for a part whose volume is not known.
void CheckClosed(const std::string& name, const std::string& path, double size, const Expected* expected)
{
  vtkNew<vtkSTEPReader> reader;
  vtkNURBSDataSet* leaf = ReadLeaf(reader, path);
  CheckTrue(name + " is read", leaf != nullptr);
  if (!leaf)
  {
    return;
  }
  Movable part(leaf);
  part.MoveBy(0, 0, 0);
  const double home = part.Get("volume");
  double worst = 0.0;
  double excess = expected ? -expected->Volume : 0.0;
  for (const double* d : Directions)
  {
    part.MoveBy(10 * size * d[0], 10 * size * d[1], 10 * size * d[2]);
    const double volume = part.Get("volume");
    const double moved = std::abs(volume - home) / home;
    worst = moved <= worst ? worst : moved;
    if (expected)
    {
      const double over = std::abs(volume - expected->Volume) - part.GetBound("volume");
      excess = over <= excess ? excess : over;
    }
  }
  Check(name + " moves its volume by", 0.0, worst, 1e-12, "(a closed chain, rounding times ten sizes)");
  if (expected)
  {
    CheckRange(name + " exceeds its bound by", -expected->Volume, excess, expected->VolumeAccuracy,
      "(digits of the file)");
  }
}

/// The same on a surface with a hole: what the test would see.
void CheckOpen(const std::string& path)
{
  vtkNew<vtkSTEPReader> reader;
  vtkNURBSDataSet* leaf = ReadLeaf(reader, path);
  CheckTrue("the open box is read", leaf != nullptr);
  if (!leaf)
  {
    return;
  }
  // Without the face x = 0, 20 x 10, the flux of r / 3 lacks x / 3 of it.
  Movable part(leaf);
  part.MoveBy(0, 0, 0);
  const double home = part.Get("faces");
  part.MoveBy(300, 0, 0);
  Check("the open box moves its flux by", 300.0 / 3 * 200, part.Get("faces") - home, 1e-9 * 6000,
    "(the area of the hole)");
}
}

int TestSurfaceIntegralOrigin(int argc, char* argv[])
{
  RequireUsage(argc == 3, "TestSurfaceIntegralOrigin FOLDER PART");
  const Manifest manifest(argv[1]);
  for (const char* variant : { "plain", "nopcurves" })
  {
    for (const Expected& expected : manifest.GetVariant(variant))
    {
      CheckClosed(expected.Solid + " " + variant, expected.Path, expected.Size, &expected);
    }
  }
  CheckClosed("a real part", argv[2], 100.0, nullptr);
  CheckOpen(manifest.GetSpecial("open_shell").Path);
  return Finish();
}
