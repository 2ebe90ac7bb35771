// TestBuoyancyRuns FOLDER MODE BACKEND: outputs of a run, bodies inside out, planes along faces, and runs
// that are stopped
#include "smBoxBodies.h"
#include "smBuoyancyNames.h"
#include "smBuoyancyTesting.h"
#include "smDecimalCommas.h"
#include "smPlacedBox.h"
#include "smTestManifest.h"

#include <vtkDataSetAttributes.h>
#include <vtkMatrix4x4.h>
#include <vtkNURBSDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSurfaceIntegralGPU.h>
#include <vtkTable.h>
#include <vtkTrimmedNURBSModel.h>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace
{
using namespace smtest;

/// A sphere whose face points inwards must not pass as a solid with a negative volume.
void CheckInsideOut(const Manifest& manifest)
{
  Scene scene(manifest.GetSolid("sphere", "plain")[0].Path);
  scene.Reader->Update();
  auto* parts = vtkPartitionedDataSetCollection::SafeDownCast(scene.Reader->GetOutputDataObject(0));
  auto* leaf = vtkNURBSDataSet::SafeDownCast(parts->GetPartition(0, 0));
  vtkNew<vtkTrimmedNURBSModel> reversed;
  reversed->ShallowCopy(leaf->GetModel());
  auto face = std::make_shared<sm::Face>(*reversed->GetFaces()[0]);
  face->Id = sm::NewId();
  face->Reversed = !face->Reversed;
  reversed->SetFace(0, face);
  vtkNew<vtkNURBSDataSet> copy;
  copy->ShallowCopy(leaf);
  copy->SetModel(reversed);
  scene.Filter->SetInputData(copy);
  scene.Filter->Update();
  CheckTrue("inside out: a negative volume", scene.Filter->GetDisplacedVolume() < -1.0);
  CheckEqual("inside out: status", "suspect", scene.Filter->GetStatus());
}

/// A solid whose void lies outside its outer shell, by the file's own word, must not pass.
void CheckVoids(const Manifest& manifest)
{
  Scene scene(manifest.GetSolid("hollow_sphere", "plain")[0].Path);
  scene.Reader->Update();
  scene.Filter->Update();
  CheckEqual("a hollow ball: status", "ok", scene.Filter->GetStatus());
  auto* parts = vtkPartitionedDataSetCollection::SafeDownCast(scene.Reader->GetOutputDataObject(0));
  auto* leaf = vtkNURBSDataSet::SafeDownCast(parts->GetPartition(0, 0));
  vtkNew<vtkTrimmedNURBSModel> model;
  model->ShallowCopy(leaf->GetModel());
  model->SetNumberOfOuterShells(2);
  vtkNew<vtkNURBSDataSet> copy;
  copy->ShallowCopy(leaf);
  copy->SetModel(model);
  scene.Filter->SetInputData(copy);
  scene.Filter->Update();
  CheckEqual("a void outside: status", "suspect", scene.Filter->GetStatus());
  CheckTrue("a void outside: said",
    std::string(scene.Filter->GetMessage(0)).find("a void lies outside the outer shell") !=
      std::string::npos);
}

/// Planes along the top of a rotated box of 30 x 20 x `thickness`, by less than what rounding leaves of a
/// point far away in them: whether the box is below as a whole, or with all but a sheet, is beyond what can
/// be decided, and the bound has to say so.
void CheckTop(const std::string& what, Scene& scene, double thickness)
{
  const Real volume = 600 * static_cast<Real>(thickness);
  scene.Filter->SetRelativeTolerance(1e-12);
  for (const int degrees : { 10, 25, 40, 55, 70, 85 })
  {
    vtkNew<vtkMatrix4x4> matrix;
    scene.Move->SetRotation(0, degrees, 0);
    scene.Move->GetMatrix(matrix);
    const double up[3] = { matrix->GetElement(0, 2), 0.0, matrix->GetElement(2, 2) };
    const Real length = std::sqrt(static_cast<Real>(up[0]) * up[0] + static_cast<Real>(up[2]) * up[2]);
    // In the plane, and exactly so.
    const double far = std::ldexp(1.0, 40);
    const double x = -far * up[2];
    const double z = far * up[0];
    for (const double delta : { -1e-7, -1e-8, 0.0, 1e-8, 1e-7 })
    {
      const double move = static_cast<double>((delta - thickness * length) * length / up[2]);
      scene.Move->SetTranslation(0, 0, move);
      // Height of the top over the plane.
      const Real height = thickness * length + move * up[2] / length;
      for (const double sense : { 1.0, -1.0 })
      {
        scene.Filter->SetPoint(x, 0, z);
        scene.Filter->SetNormal(sense * up[0], 0, sense * up[2]);
        scene.Filter->Update();
        const Real above = 600 * std::max<Real>(height, 0);
        const Real exact = sense > 0.0 ? volume - above : above;
        char label[80];
        std::snprintf(label, sizeof(label), "%s rotated by %d, %g over a far plane, %g", what.c_str(),
          degrees, delta, sense);
        const double bound = scene.Filter->GetDisplacedVolumeBound();
        Check(label, static_cast<double>(exact), scene.Filter->GetDisplacedVolume(), bound, "the bound");
        CheckRange(std::string(label) + ", bound", 0.0, bound, 0.01);
      }
    }
  }
}

void CheckTouching(const Manifest& manifest)
{
  Scene scene(manifest.GetSolid("box", "plain")[0].Path);
  CheckTop("box", scene, 10.0);
}

/// The same of a plate whose top has a surface of a thousandth of its size: ribbons to its edges cover the
/// rest.
void CheckWideRibbons(const Manifest& manifest)
{
  constexpr double thickness = 1.0 / 128.0;
  BoxBody body;
  body.Add({ { 0.0, 0.0, 0.0 }, { 30.0, 20.0, thickness } });
  const vtkSmartPointer<vtkNURBSDataSet> leaf = body.Make();
  constexpr int top = 5;
  auto face = std::make_shared<sm::Face>(*leaf->GetModel()->GetFaces()[top]);
  face->Id = sm::NewId();
  const double middle[3] = { 15.0, 10.0, thickness };
  for (std::array<double, 4>& point : face->Surface.ControlPoints)
  {
    for (int c = 0; c < 3; ++c)
    {
      point[c] = middle[c] + 1e-3 * (point[c] - middle[c]);
    }
  }
  leaf->GetModel()->SetFace(top, face);
  Scene scene(manifest.GetSolid("box", "plain")[0].Path);
  scene.Move->SetInputDataObject(leaf);
  CheckTop("plate with wide ribbons", scene, thickness);
}

/// Volume, first moments and centre of the box below z = height, from getters, field data and tables.
void CheckBoxTables(vtkBuoyancy* filter, double height)
{
  filter->SetPoint(0, 0, height);
  filter->Update();
  CheckEqual("status", "ok", filter->GetStatus());
  const double volume = 600.0 * height;
  const double bound = filter->GetDisplacedVolumeBound();
  Check("volume", volume, filter->GetDisplacedVolume(), bound);
  double first[3];
  filter->GetDisplacedFirstMoments(first);
  vtkFieldData* fields = filter->GetOutput()->GetFieldData();
  auto* solids = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  const double exact[3] = { volume * 15.0, volume * 10.0, volume * 0.5 * height };
  for (int c = 0; c < 3; ++c)
  {
    Check("first moment", exact[c], first[c], filter->GetDisplacedFirstMomentsBound());
    Check("in the field data", first[c], GetField(fields, sm::names::DisplacedFirstMoments, c), 0.0);
    Check("centre in the field data", exact[c] / volume, GetField(fields, sm::names::CenterOfBuoyancy, c),
      GetFieldBound(fields, sm::names::CenterOfBuoyancy));
    Check("centre of the solid", exact[c] / volume,
      solids->GetRowData()->GetArray(sm::names::CenterOfBuoyancy)->GetComponent(0, c),
      GetFieldBound(fields, sm::names::CenterOfBuoyancy));
  }
  Check("bound in the field data", bound, GetFieldBound(fields, sm::names::DisplacedVolume), 0.0);
  auto* faces = vtkTable::SafeDownCast(filter->GetOutputDataObject(3));
  double sum = 0.0;
  double largest = 0.0;
  for (vtkIdType row = 0; row < faces->GetNumberOfRows(); ++row)
  {
    const double share = faces->GetValueByName(row, sm::names::DisplacedVolume).ToDouble();
    sum += share;
    largest = std::max(largest, std::abs(share));
  }
  Check("sum of the faces", volume, sum, bound);
  // Only the bottom has a normal that is not level.
  Check("the bottom's share", volume, largest, bound);
}

/// A ball below planes that miss it, and at half its radius to either side.
void CheckCaps(const Expected& part)
{
  Scene scene(part.Path);
  scene.Filter->SetPoint(0.0, 0.0, 1e6);
  scene.Filter->Update();
  Check("the whole ball", part.Volume, scene.Filter->GetDisplacedVolume(), 1e-8 * part.Volume);
  const double radius = std::cbrt(part.Volume * 0.75 / static_cast<double>(Pi));
  scene.Filter->SetPoint(0.0, 0.5 * radius, 0.0);
  scene.Filter->SetNormal(0.0, 2.0, 0.0);
  scene.Filter->Update();
  Check("below a cap of height r / 2", part.Volume * 27.0 / 32.0, scene.Filter->GetDisplacedVolume(),
    1e-8 * part.Volume);
  scene.Filter->SetNormal(0.0, -1.0, 0.0);
  scene.Filter->Update();
  Check("the cap", part.Volume * 5.0 / 32.0, scene.Filter->GetDisplacedVolume(), 1e-8 * part.Volume);
}

void CheckTables(const Manifest& manifest)
{
  CheckCaps(manifest.GetSolid("sphere", "plain").front());
  Scene scene(manifest.GetSolid("box", "plain")[0].Path);
  double center[3];
  scene.Filter->GetCenterOfBuoyancy(center);
  CheckTrue("no centre before the first run", std::isnan(center[0]));
  // Another filter over the same bodies, updated between two waterlines.
  vtkNew<vtkSurfaceIntegralGPU> other;
  other->SetInputConnection(scene.Move->GetOutputPort());
  other->SetBackend(Backend);
  other->AddVolumeMoment("V", 0, 0, 0);
  other->AddAreaMoment("A", 0, 0, 0);
  CheckBoxTables(scene.Filter, 7.5);
  other->Update();
  Check("volume", 6000.0, other->GetIntegral("V"), other->GetIntegralBound("V"));
  Check("area", 2200.0, other->GetIntegral("A"), other->GetIntegralBound("A"));
  CheckBoxTables(scene.Filter, 2.5);
  const vtkTypeInt64 first = scene.Filter->GetEvaluations();
  scene.Filter->Modified();
  scene.Filter->Update();
  CheckTrue("cut once, integrated once", first > 0 && scene.Filter->GetEvaluations() == 0);

  MessageTrap messages(scene.Filter);
  const double nan = std::nan("");
  scene.Filter->SetNormal(0, 0, 0);
  CheckEqual("errors of no direction", 1, messages.NumberOfErrors);
  {
    const DecimalCommas commas;
    scene.Filter->SetNormal(0.25, nan, 1);
  }
  CheckEqual("errors of a direction that is not a number", 2, messages.NumberOfErrors);
  CheckTrue("decimal points", messages.Errors.find("(0.25, nan, 1)") != std::string::npos, messages.Errors);
  scene.Filter->SetPoint(0, 1.0 / 0.0, 0);
  CheckEqual("errors of an infinite point", 3, messages.NumberOfErrors);
  const double* point = scene.Filter->GetPoint();
  const double* normal = scene.Filter->GetNormal();
  CheckTrue("and nothing is changed",
    point[0] == 0.0 && point[1] == 0.0 && point[2] == 2.5 && normal[0] == 0.0 && normal[1] == 0.0 &&
      normal[2] == 1.0);
}
/// Stops a run at its progress event number `allowed`, counted from 0; returns false if the run was over
/// before.
bool UpdateAndStop(vtkBuoyancy* filter, int allowed)
{
  struct Stop
  {
    int Left;
    bool Stopped = false;
  } stop{ allowed };
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&stop);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* running = static_cast<vtkBuoyancy*>(caller);
      auto* state = static_cast<Stop*>(data);
      // The executive reports 1 when the run is over.
      if (running->GetProgress() < 1.0 && state->Left-- == 0)
      {
        state->Stopped = true;
        running->SetAbortExecute(1);
      }
    });
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, command);
  filter->Modified();
  filter->Update();
  filter->RemoveObserver(tag);
  return stop.Stopped;
}

/// A run is stopped at each of its reports of progress in turn: faces cut into panels, faces cut at the
/// waterline, integration.
void CheckAborts(const Manifest& manifest)
{
  const std::string path = manifest.GetSolid("torus", "plain")[0].Path;
  Scene whole(path);
  whole.Filter->SetPoint(0, 0, 2.5);
  whole.Filter->SetNormal(1, 2, 3);
  whole.Filter->Update();
  CheckEqual("status", "ok", whole.Filter->GetStatus());
  int inCut = 0;
  int stops = 0;
  for (bool stopped = true; stopped && stops < 100; stops += stopped ? 1 : 0)
  {
    // A new scene has nothing from earlier runs.
    Scene scene(path);
    scene.Filter->SetPoint(0, 0, 2.5);
    scene.Filter->SetNormal(1, 2, 3);
    MessageTrap trap(scene.Filter);
    stopped = UpdateAndStop(scene.Filter, stops);
    const std::string name = "stopped at report " + std::to_string(stops);
    if (stopped)
    {
      CheckTrue(name + ", not ok", scene.Filter->GetStatus() != "ok");
      CheckTrue(name + ", said", Says(scene.Filter, "was aborted") || Says(scene.Filter, "was stopped"),
        GetMessages(scene.Filter));
    }
    if (Says(scene.Filter, "the run was aborted while faces were cut at the plane"))
    {
      ++inCut;
      CheckEqual(name + ", status", sm::names::StatusNotComputed, scene.Filter->GetStatus());
      CheckTrue(name + ", no volume", std::isnan(scene.Filter->GetDisplacedVolume()));
      CheckTrue(name + ", nothing evaluated", scene.Filter->GetEvaluations() == 0);
    }
    scene.Filter->Modified();
    scene.Filter->Update();
    Check(name + ", the next run has the same bits", whole.Filter->GetDisplacedVolume(),
      scene.Filter->GetDisplacedVolume(), 0.0);
    Check(name + ", and the same bound", whole.Filter->GetDisplacedVolumeBound(),
      scene.Filter->GetDisplacedVolumeBound(), 0.0);
  }
  Scene slow(path);
  MessageTrap trap(slow.Filter);
  slow.Filter->SetMaximumSeconds(1e-9);
  slow.Filter->Update();
  CheckEqual("no time, status", sm::names::StatusNotComputed, slow.Filter->GetStatus());
  CheckTrue("no time, said", Says(slow.Filter, "the maximum seconds were over"), GetMessages(slow.Filter));
  CheckTrue("no time, nothing evaluated", slow.Filter->GetEvaluations() == 0);
  // The executive's own report before the run, those of both kinds of cutting, and then those of the
  // integration.
  CheckEqual("stops while faces are cut", 3, inCut);
  CheckTrue("stops later", stops > inCut);
}

/// A box in a placement that was read, partly and wholly below: the volumes of all placements that rounding
/// may have made the same are within the bound.
void CheckPlaced(const Manifest&)
{
  for (const double distance : { 0.0, 1e6 })
  {
    vtkNew<vtkMatrix4x4> placement;
    PlacedBox::SetPlacement(distance, placement);
    vtkNew<vtkBuoyancy> filter;
    filter->SetBackend(Backend);
    filter->SetRelativeTolerance(1e-12);
    filter->SetInputDataObject(PlacedBox::MakeLeaf(placement));
    for (const double depth : { 2.0, 7.0 })
    {
      // Along the third column of the placement, the box's longest edge.
      const double up[3] = { 8.0, 1.0, 4.0 };
      double point[3];
      for (int c = 0; c < 3; ++c)
      {
        point[c] = placement->GetElement(c, 3) + depth * up[c] / 9.0;
      }
      filter->SetPoint(point);
      filter->SetNormal(up[0], up[1], up[2]);
      filter->Update();
      const double bound = filter->GetDisplacedVolumeBound();
      std::mt19937_64 random(7);
      PlacedBox::Real largest = 0;
      for (int i = 0; i < 100; ++i)
      {
        const PlacedBox box(placement, random);
        const PlacedBox::Real exact =
          depth > PlacedBox::Size[2] ? box.GetVolume() : box.GetVolumeBelow(point, up);
        largest = std::max(largest, std::abs(filter->GetDisplacedVolume() - exact) / bound);
      }
      // Wholly below, the volume does not depend on the translation.
      CheckRange("depth " + std::to_string(depth) + " at " + std::to_string(distance) +
          ", largest difference over bound",
        depth > PlacedBox::Size[2] ? 0.0 : 0.005, static_cast<double>(largest), 1.0);
    }
  }
}
}

int TestBuoyancyRuns(int argc, char* argv[])
{
  return RunMode(argc, argv, "TestBuoyancyRuns",
    { { "inside_out", CheckInsideOut }, { "voids", CheckVoids }, { "touching", CheckTouching },
      { "tables", CheckTables }, { "aborts", CheckAborts }, { "wide_ribbons", CheckWideRibbons },
      { "placed", CheckPlaced } });
}
