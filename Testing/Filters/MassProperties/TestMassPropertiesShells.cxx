// TestMassPropertiesShells FOLDER: shells that are inside out are reversed, counted and said; voids take away
// at any depth; what cannot be decided keeps the file's orientation and is suspect.
#include "smBoxBodies.h"
#include "smTestManifest.h"
#include "smTestPipeline.h"

#include <vtkMatrix4x4.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSurfaceIntegralGPU.h>
#include <vtkTable.h>

namespace
{
using namespace smtest;
namespace names = sm::names;

struct Case
{
  std::string Name;
  std::vector<BoxShell> Boxes;
  double Volume;
  int Flipped;
  std::string Status = names::StatusOk;
  /// Part of a message; empty: there is none.
  std::string Said = "";
  bool Solid = true;
  bool WithMesh = true;
  bool OneShell = false;
  int OuterShells = 0;
};

void CheckCase(const Case& c)
{
  std::printf("--- %s\n", c.Name.c_str());
  BoxBody body;
  for (const BoxShell& box : c.Boxes)
  {
    body.Add(box);
  }
  const auto leaf = body.Make(c.Solid, c.WithMesh, c.OneShell);
  leaf->GetModel()->SetNumberOfOuterShells(c.OuterShells);
  vtkNew<vtkMassPropertiesGPU> mass;
  MessageTrap trap(mass);
  mass->SetInputData(leaf);
  mass->Update();
  vtkFieldData* fields = mass->GetOutput()->GetFieldData();
  CheckEqual("status", c.Status, mass->GetStatus());
  // Products of whole numbers: only the sums round.
  Check("volume", c.Volume, mass->GetVolume(), 1e-12 * std::fabs(c.Volume), "sums of whole numbers");
  CheckEqual("flipped shells", c.Flipped, static_cast<long long>(GetField(fields, names::FlippedShells)));
  double area = 0.0;
  double first = 0.0;
  for (const BoxShell& box : c.Boxes)
  {
    const double d[3] = { box.High[0] - box.Low[0], box.High[1] - box.Low[1], box.High[2] - box.Low[2] };
    area += 2.0 * (d[0] * d[1] + d[1] * d[2] + d[2] * d[0]);
    first += box.GetVolume();
  }
  Check("area counts every face", area, mass->GetSurfaceArea(), 1e-12 * area, "sums of whole numbers");
  CheckTrue(c.Said.empty() ? "nothing is said" : "it is said",
    c.Said.empty() ? mass->GetNumberOfMessages() == 0 : Says(mass, c.Said), GetMessages(mass));
  auto* edges = vtkTable::SafeDownCast(mass->GetOutputDataObject(4));
  CheckEqual("a row for every edge", static_cast<long long>(12 * c.Boxes.size()), edges->GetNumberOfRows());
  // The faces' parts of the volume, of a sound body, are reversed with their shells.
  auto* faces = vtkTable::SafeDownCast(mass->GetOutputDataObject(3));
  auto* column = vtkDataArray::SafeDownCast(faces->GetColumnByName(names::Volume));
  double sum = 0.0;
  for (vtkIdType i = 0; column && i < column->GetNumberOfTuples(); ++i)
  {
    sum += column->GetComponent(i, 0);
  }
  Check("the faces' volumes add up to it", mass->GetVolume(), sum, 1e-11 * first, "rounding of a sum");
  // Moments alone, without an area.
  vtkNew<vtkSurfaceIntegralGPU> moments;
  moments->AddVolumeMoment("z", 0, 0, 1);
  moments->AddVolumeMoment("one", 0, 0, 0);
  moments->SetBackend(vtkSurfaceIntegralGPU::CPU);
  moments->SetInputData(leaf);
  moments->Update();
  double center[3];
  mass->GetCenterOfMass(center);
  Check("volume as a moment", c.Volume, moments->GetIntegral("one"), 1e-12 * std::fabs(first));
  CheckEqual("with its status", mass->GetStatus(), moments->GetStatus());
  if (c.Volume > 0.0)
  {
    Check("first moment", c.Volume * center[2], moments->GetIntegral("z"), 1e-9 * std::fabs(first));
  }
}

/// An open body's moments keep the signs of its faces: that of its volume depends on the origin. The upper
/// side of a box is missing, z / 3 over which is more than its volume.
void CheckOpenMoments()
{
  std::printf("--- the moments of an open body\n");
  BoxBody body;
  body.Add({ { 10, 10, 10 }, { 11, 12, 13 }, true, 5 });
  vtkNew<vtkSurfaceIntegralGPU> moments;
  moments->AddVolumeMoment("one", 0, 0, 0);
  moments->SetBackend(vtkSurfaceIntegralGPU::CPU);
  moments->SetInputData(body.Make());
  moments->Update();
  Check("the flux through five faces", 6.0 - 13.0 * 2.0 / 3.0, moments->GetIntegral("one"), 1e-12);
}

/// A box less a box: the centre by hand, so that all moments are reversed and not the volume alone.
void CheckMoments()
{
  std::printf("--- the moments of a reversed void\n");
  for (const bool wrong : { false, true })
  {
    BoxBody body;
    body.Add({ { 0, 0, 0 }, { 10, 10, 10 } });
    body.Add({ { 6, 2, 2 }, { 9, 8, 8 }, wrong });
    const auto leaf = body.Make();
    vtkNew<vtkMatrix4x4> mirror;
    mirror->SetElement(0, 0, -1.0);
    leaf->SetPlacement(mirror);
    vtkNew<vtkMassPropertiesGPU> mass;
    mass->SetInputData(leaf);
    mass->Update();
    double center[3];
    mass->GetCenterOfMass(center);
    Check("volume", 1000.0 - 108.0, mass->GetVolume(), 1e-10);
    Check("centre of the mirrored part", -(1000.0 * 5.0 - 108.0 * 7.5) / 892.0, center[0], 1e-12);
    double inertia[9];
    mass->GetVolumeInertia(inertia);
    // Steiner, about the common centre in y and z: 1000 (100 + 100)/12 - 108 (36 + 36)/12.
    Check("inertia about x", 1000.0 * 200.0 / 12.0 - 108.0 * 72.0 / 12.0, inertia[0], 1e-9);
    CheckEqual("status", names::StatusOk, mass->GetStatus());
  }
}

/// Solids in one place: a note counts their pairs, and names five.
void CheckCoincidences()
{
  std::printf("--- coincident solids\n");
  for (const auto& [count, said] : std::vector<std::pair<unsigned int, std::string>>{ { 1, "" },
         { 2, "solids 1 and 2 have the same volume and centre of mass: they overlap, and both are counted" },
         { 3, "3 pairs of solids (1 and 2; 1 and 3; 2 and 3) have the same volume" },
         { 4, "6 pairs of solids (1 and 2; 1 and 3; 1 and 4; 2 and 3; 2 and 4; ...) have the same volume" } })
  {
    vtkNew<vtkPartitionedDataSetCollection> solids;
    for (unsigned int i = 0; i < count; ++i)
    {
      BoxBody body;
      body.Add({ { 0, 0, 0 }, { 10, 12, 14 } });
      solids->SetPartition(i, 0, body.Make());
    }
    vtkNew<vtkMassPropertiesGPU> mass;
    mass->SetInputData(solids);
    mass->Update();
    CheckEqual("status", names::StatusOk, mass->GetStatus());
    CheckTrue("note", said.empty() ? mass->GetNumberOfMessages() == 0 : Says(mass, said), GetMessages(mass));
  }
}

/// Exchanges the faces of one of the shells for reversed ones.
void CheckCurved(const std::string& path, double volume)
{
  std::printf("--- a hollow sphere from STEP, its void reversed by hand\n");
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  auto* parts = vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(0));
  auto* leaf = vtkNURBSDataSet::SafeDownCast(parts->GetPartition(0, 0));
  vtkTrimmedNURBSModel* model = leaf->GetModel();
  CheckEqual("shells of the file", 2, static_cast<long long>(model->GetShells().size()));
  for (int wrong = 0; wrong < 4; ++wrong)
  {
    vtkNew<vtkTrimmedNURBSModel> edited;
    edited->ShallowCopy(model);
    for (std::size_t s = 0; s < 2; ++s)
    {
      for (const int f : model->GetShells()[s])
      {
        auto face = std::make_shared<sm::Face>(*model->GetFaces()[f]);
        face->Id = sm::NewId();
        face->Reversed = face->Reversed != (((wrong >> s) & 1) != 0);
        edited->SetFace(f, face);
      }
    }
    vtkNew<vtkNURBSDataSet> copy;
    copy->ShallowCopy(leaf);
    copy->SetModel(edited);
    vtkNew<vtkMassPropertiesGPU> mass;
    mass->SetInputData(copy);
    mass->Update();
    Check("volume", volume, mass->GetVolume(), 1e-9 * volume);
    CheckEqual("status", names::StatusOk, mass->GetStatus());
    CheckEqual("flipped shells",
      wrong == 0     ? 0
        : wrong == 3 ? 2
                     : 1,
      static_cast<long long>(GetField(mass->GetOutput()->GetFieldData(), names::FlippedShells)));
    CheckTrue("said",
      wrong == 0 ||
        Says(mass,
          wrong == 3 ? "the solid is inside out in the file; it was reversed"
                     : "1 of 2 shells was inside out"),
      GetMessages(mass));
  }
}
}

int TestMassPropertiesShells(int argc, char* argv[])
{
  RequireUsage(argc == 2, "TestMassPropertiesShells FOLDER");
  const BoxShell outer{ { 0, 0, 0 }, { 10, 12, 14 } };
  const BoxShell middle{ { 1, 1, 1 }, { 9, 10, 12 }, false };
  const BoxShell lump{ { 2, 3, 4 }, { 6, 7, 8 } };
  const BoxShell beside{ { 20, 0, 0 }, { 25, 5, 5 } };
  const auto reversed = [](BoxShell box)
  {
    box.Outward = !box.Outward;
    return box;
  };
  const double v0 = outer.GetVolume();
  const double v1 = middle.GetVolume();
  const double v2 = lump.GetVolume();
  const double v3 = beside.GetVolume();
  const std::string whole = "the solid is inside out in the file; it was reversed";
  CheckCase({ "one shell", { outer }, v0, 0 });
  CheckCase({ "one shell inside out", { reversed(outer) }, v0, 1, names::StatusOk, whole });
  CheckCase({ "a void", { outer, middle }, v0 - v1, 0 });
  CheckCase({ "a void that is inside out", { outer, reversed(middle) }, v0 - v1, 1, names::StatusOk,
    "1 of 2 shells was inside out and was reversed" });
  CheckCase({ "an outer shell that is inside out", { reversed(outer), middle }, v0 - v1, 1, names::StatusOk,
    "1 of 2 shells was inside out and was reversed" });
  CheckCase({ "both inside out", { reversed(outer), reversed(middle) }, v0 - v1, 2, names::StatusOk, whole });
  CheckCase({ "a lump in a void", { middle, lump, outer }, v0 - v1 + v2, 0 });
  CheckCase({ "a lump in a void, two of them wrong", { reversed(middle), reversed(lump), outer },
    v0 - v1 + v2, 2, names::StatusOk, "2 of 3 shells were inside out and were reversed" });
  CheckCase({ "two lumps side by side, one wrong", { outer, reversed(beside) }, v0 + v3, 1, names::StatusOk,
    "1 of 2 shells was inside out and was reversed" });
  CheckCase({ "a void in the file's one shell", { outer, reversed(middle) }, v0 - v1, 1, names::StatusOk,
    "1 of 2 shells was inside out and was reversed", true, true, true });
  CheckCase({ "a closed free shell with a wrong void", { outer, reversed(middle) }, v0 - v1, 1,
    names::StatusOk, "1 of 2 shells was inside out and was reversed", false });
  // A plus sign of two bars: no corner of either lies in the other.
  const BoxShell bar{ { -10, -1, -1 }, { 10, 1, 1 } };
  const BoxShell across{ { -2, -10, -2 }, { 2, 10, 2 }, false };
  CheckCase({ "shells that cross", { bar, across }, across.GetVolume() - bar.GetVolume(), 2,
    names::StatusSuspect, "two of its shells cross; its shells are taken as the file orients them" });
  CheckCase({ "a void that touches its shell from inside", { outer, { { 0, 3, 3 }, { 5, 6, 6 }, true } },
    v0 - 45.0, 1, names::StatusOk, "1 of 2 shells was inside out" });
  CheckCase({ "the same shell twice", { outer, reversed(outer) }, 0.0, 0, names::StatusSuspect,
    "so near each other" });
  CheckCase({ "no mesh to decide by", { outer, reversed(middle) }, v0 + v1, 0, names::StatusSuspect,
    "no display mesh", true, false });
  const std::string swapped =
    "the file's outer shell lies inside a void of it; its shells are taken as the file orients them";
  CheckCase({ "an outer shell in its void, both outwards", { reversed(middle), outer }, v1 + v0, 0,
    names::StatusSuspect, swapped, true, true, false, 1 });
  CheckCase({ "an outer shell in its void, all inside out", { reversed(middle), reversed(outer) }, v0 - v1, 2,
    names::StatusOk, whole, true, true, false, 1 });
  CheckCase({ "a void first, oriented rightly", { middle, outer }, v0 - v1, 0, names::StatusOk, "", true,
    true, false, 1 });
  CheckCase({ "both inside out, one of them the outer shell", { reversed(outer), reversed(middle) }, v0 - v1,
    2, names::StatusOk, whole, true, true, false, 1 });
  CheckMoments();
  CheckOpenMoments();
  CheckCoincidences();
  const Manifest manifest(argv[1]);
  const Expected sphere = manifest.GetSolid("hollow_sphere", "plain")[0];
  CheckCurved(sphere.Path, sphere.Volume);
  return Finish();
}
