// Shells that are whole spheres are nested, touch or cross, with each other, boxes and tori, as their radii
// and centres say: without a mesh of them, and with a few samples.
#include "Detail/smSelfCrossing.h"
#include "smBoxBodies.h"
#include "smMassIntegrands.h"
#include "smRoundFaces.h"
#include "smTestPipeline.h"
#include "smWholeSphere.h"

#include <vtkMatrix4x4.h>

namespace
{
using namespace smtest;
namespace names = sm::names;
using Faces = std::vector<sm::FacePointer>;

double GetBallVolume(double radius)
{
  return 4.0 / 3.0 * vtkMath::Pi() * radius * radius * radius;
}

/// Computes the mass properties of a leaf, also in another place and mirrored. `said` is a part of a message;
/// empty: there is none.
void CheckBallLeaf(const char* name, vtkNURBSDataSet* leaf, double volume, const std::string& said = "",
  int flipped = 0, bool isSuspect = true)
{
  std::printf("--- %s\n", name);
  for (const bool isPlaced : { false, true })
  {
    if (isPlaced && leaf->GetNumberOfPoints() > 0)
    {
      continue;
    }
    vtkNew<vtkMatrix4x4> placement;
    const double moved[16] = { 0, 0.6, 0.8, 40, 0, -0.8, 0.6, -7, -1, 0, 0, 3, 0, 0, 0, 1 };
    if (isPlaced)
    {
      placement->DeepCopy(moved);
    }
    leaf->SetPlacement(placement);
    vtkNew<vtkMassPropertiesGPU> mass;
    MessageTrap trap(mass);
    mass->SetBackend(vtkMassPropertiesGPU::CPU);
    mass->SetInputData(leaf);
    mass->Update();
    CheckEqual("status", said.empty() || !isSuspect ? names::StatusOk : names::StatusSuspect,
      std::string(mass->GetStatus()));
    Check("volume", volume, mass->GetVolume(), mass->GetVolumeBound(), "the bound");
    CheckEqual("reversed shells", flipped,
      static_cast<long long>(GetField(mass->GetOutput()->GetFieldData(), names::FlippedShells)));
    CheckTrue(said.empty() ? "nothing is said" : "it is said",
      said.empty() ? mass->GetNumberOfMessages() == 0 : Says(mass, said), GetMessages(mass));
  }
}

void CheckBalls()
{
  const std::string crossing = "two of its shells cross";
  const auto ball = MakeBall({ 0, 0, 0 }, 2.0);
  const auto check = [&](const char* name, const Faces& others, double volume, const std::string& said = "",
                       int flipped = 0, bool isSuspect = true)
  {
    Faces faces = { ball };
    faces.insert(faces.end(), others.begin(), others.end());
    CheckBallLeaf(name, MakeRoundBody(faces), volume, said, flipped, isSuspect);
  };
  check("a ball", {}, GetBallVolume(2.0));
  CheckBallLeaf("a ball inside out", MakeRoundBody({ MakeBall({ 1, 2, 3 }, 2.0, false) }), GetBallVolume(2.0),
    "inside out", 1, false);
  check("a void", { MakeBall({ 0.1, 0.2, 0.3 }, 1.0, false) }, GetBallVolume(2.0) - GetBallVolume(1.0));
  check("a void that touches from inside", { MakeBall({ 0.6, 0.0, 0.8 }, 1.0, false) },
    GetBallVolume(2.0) - GetBallVolume(1.0));
  check("a void that leaves the ball by 1e-6", { MakeBall({ 0.6, 0.0, 0.8 }, 1.0 + 1e-6, false) },
    GetBallVolume(2.0) - GetBallVolume(1.0 + 1e-6), crossing);
  check("a void that leaves the ball", { MakeBall({ 1.5, 0.0, 0.0 }, 1.0, false) },
    GetBallVolume(2.0) - GetBallVolume(1.0), crossing);
  check("a solid ball in the ball", { MakeBall({ 0.1, 0.2, 0.3 }, 1.0) },
    GetBallVolume(2.0) - GetBallVolume(1.0), "shells was inside out", 1, false);
  check("a ball in a void", { MakeBall({ 0.1, 0.2, 0.3 }, 1.0, false), MakeBall({ 0.1, 0.2, 0.4 }, 0.8) },
    GetBallVolume(2.0) - GetBallVolume(1.0) + GetBallVolume(0.8));
  check("two voids that touch", { MakeBall({ 0.9, 0, 0 }, 0.9, false), MakeBall({ -0.9, 0, 0 }, 0.9, false) },
    GetBallVolume(2.0) - 2.0 * GetBallVolume(0.9));
  check("two voids that cross",
    { MakeBall({ 0.9, 0, 0 }, 0.91, false), MakeBall({ -0.9, 0, 0 }, 0.91, false) },
    GetBallVolume(2.0) - 2.0 * GetBallVolume(0.91), crossing);
  check("another ball", { MakeBall({ 3.0, 3.0, 0.0 }, 1.0) }, GetBallVolume(2.0) + GetBallVolume(1.0));
  check("a ball that touches", { MakeBall({ 1.8, 2.4, 0.0 }, 1.0) }, GetBallVolume(2.0) + GetBallVolume(1.0));
  check("a ball that crosses by 1e-6", { MakeBall({ 1.8, 2.4, 0.0 }, 1.0 + 1e-6) },
    GetBallVolume(2.0) + GetBallVolume(1.0 + 1e-6), crossing);
  check(
    "the same ball again", { MakeBall({ 0, 0, 0 }, 2.0) }, 2.0 * GetBallVolume(2.0), "so near each other");
}

void CheckBallsAndBoxes()
{
  const auto check = [](const char* name, const BoxShell& box, const sm::FacePointer& ball, double volume,
                       const std::string& said = "", int flipped = 0, bool isSuspect = true)
  {
    BoxBody maker;
    maker.Add(box);
    const auto leaf = maker.Make();
    AddShells(leaf, { ball });
    CheckBallLeaf(name, leaf, volume, said, flipped, isSuspect);
  };
  const std::string crossing = "two of its shells cross";
  const BoxShell box{ { 0, 0, 0 }, { 10, 12, 14 } };
  check("a void in a box", box, MakeBall({ 5, 6, 7 }, 3.0, false), 1680.0 - GetBallVolume(3.0));
  check("a void that touches a wall", box, MakeBall({ 3, 6, 7 }, 3.0, false), 1680.0 - GetBallVolume(3.0));
  check("a void that leaves the box by 1e-5", box, MakeBall({ 3 - 1e-5, 6, 7 }, 3.0, false),
    1680.0 - GetBallVolume(3.0), crossing);
  check("a void that leaves the box at a corner", box, MakeBall({ 1.7, 1.7, 1.7 }, 3.0, false),
    1680.0 - GetBallVolume(3.0), crossing);
  check("a solid ball in the box", box, MakeBall({ 5, 6, 7 }, 3.0), 1680.0 - GetBallVolume(3.0),
    "shells was inside out", 1, false);
  check("a ball next to the box", box, MakeBall({ 14, 6, 7 }, 3.0), 1680.0 + GetBallVolume(3.0));
  check("a ball on the box", box, MakeBall({ 13, 6, 7 }, 3.0), 1680.0 + GetBallVolume(3.0));
  check("a ball next to a corner, in the same box", { { 0, 0, 0 }, { 10, 10, 10 } },
    MakeBall({ 12, 12, 12 }, 3.4), 1000.0 + GetBallVolume(3.4));
  check("a ball that reaches over the corner", { { 0, 0, 0 }, { 10, 10, 10 } }, MakeBall({ 12, 12, 12 }, 3.5),
    1000.0 + GetBallVolume(3.5), crossing);
  const BoxShell inner{ { -1, -1, -1 }, { 1, 1, 1 }, false };
  check("a box as a void in a ball", inner, MakeBall({ 0, 0, 0 }, 1.8), GetBallVolume(1.8) - 8.0);
  check("with a corner outside", inner, MakeBall({ 0.1, 0.1, 0.1 }, 1.8), GetBallVolume(1.8) - 8.0, crossing);
  check("with all corners outside", inner, MakeBall({ 0, 0, 0 }, 1.7), GetBallVolume(1.7) - 8.0, crossing);
}

void CheckBallsAndTori()
{
  const double torusVolume = 2.0 * vtkMath::Pi() * vtkMath::Pi() * 10.0 * 9.0;
  const auto check = [](const char* name, const sm::FacePointer& ball, double volume,
                       const std::string& said = "", int flipped = 0, bool isSuspect = true)
  {
    const sm::FacePointer torus = MakeTorus({ 0, 0, 0 }, 10.0, 3.0);
    const auto leaf = MakeRoundBody({ torus });
    AddGrids(leaf, { torus }, 60);
    AddShells(leaf, { ball });
    CheckBallLeaf(name, leaf, volume, said, flipped, isSuspect);
  };
  const auto add = [torusVolume](double radius) { return torusVolume + GetBallVolume(radius); };
  const std::string crossing = "two of its shells cross";
  check("a ball in the hole of a torus", MakeBall({ 0, 0, 0 }, 6.5), add(6.5));
  check("that crosses the torus", MakeBall({ 0, 0, 0 }, 7.2), add(7.2), crossing);
  check("off the middle of the hole", MakeBall({ 0, 0, 5 }, 8.0), add(8.0));
  check("a void in the tube", MakeBall({ 0, 10, 0 }, 2.5, false), torusVolume - GetBallVolume(2.5));
  check(
    "that leaves the tube", MakeBall({ 0, 10, 0 }, 3.3, false), torusVolume - GetBallVolume(3.3), crossing);
  check("a ball around the torus", MakeBall({ 0, 0, 0 }, 14.0), GetBallVolume(14.0) - torusVolume,
    "shells was inside out", 1, false);
}

/// A body with the exact integrals of its faces: whole spheres, and boxes before them.
sm::BodyIntegrals MakeBallIntegrals(vtkNURBSDataSet* leaf, double boxArea = 0.0)
{
  sm::BodyIntegrals body;
  body.Model = leaf->GetModel();
  body.Mesh = leaf;
  body.Status = sm::Status::Ok;
  std::copy_n(leaf->GetPlacementData(), 16, body.Placement.begin());
  std::vector<sm::FaceIntegrals> faces;
  body.Value.assign(sm::NumberOfMassIntegrands, 0.0);
  for (const sm::FacePointer& face : body.Model->GetFaces())
  {
    const sm::WholeSphere sphere = sm::FindWholeSphere(*face);
    faces.emplace_back();
    for (std::size_t i = 0; i < sm::NumberOfMassIntegrands; ++i)
    {
      faces.back().Append(0.0);
    }
    faces.back().Face[sm::MassArea] = sphere.GetArea();
    faces.back().Face[sm::MassVolume] = sphere.GetSignedVolume();
    body.Value[sm::MassArea] += sphere.GetArea();
  }
  body.Value[sm::MassArea] += boxArea;
  body.Faces = std::make_shared<const std::vector<sm::FaceIntegrals>>(std::move(faces));
  return body;
}

sm::SelfCrossing CheckBallWinding(const char* name, const Faces& faces, int winding, double gap = 0.0)
{
  sm::BodyIntegrals body = MakeBallIntegrals(MakeRoundBody(faces));
  body.MaxGap = gap;
  const sm::SelfCrossing found = sm::FindSelfCrossing({ &body });
  CheckEqual(std::string(name) + ": checked", "", found.Unchecked);
  CheckEqual(std::string(name) + ": winding number", winding, found.Winding);
  if (winding != 0)
  {
    // The number of the spheres about the point that is named, off all of them.
    double sum = 0.0;
    for (const sm::FacePointer& face : faces)
    {
      const sm::WholeSphere sphere = sm::FindWholeSphere(*face);
      const double distance = sm::GetDistance(found.Point, sphere.Center);
      sum += distance < sphere.Radius ? (sphere.Inward ? -1.0 : 1.0) : 0.0;
      CheckTrue(std::string(name) + ": off the sphere", std::abs(distance - sphere.Radius) > sphere.Error);
    }
    Check(std::string(name) + ": about the point", winding, sum, 0.0);
  }
  return found;
}

void CheckBallWindings()
{
  const auto ball = MakeBall({ 1, 2, 3 }, 2.0);
  const sm::SelfCrossing one = CheckBallWinding("a ball", { ball }, 0);
  CheckRange("points of a ball", 1.0, static_cast<double>(one.Samples), 8.0, "by a formula");
  CheckBallWinding("a void", { ball, MakeBall({ 1, 2, 3.5 }, 1.0, false) }, 0);
  CheckBallWinding("a void that touches", { ball, MakeBall({ 1, 2, 4 }, 1.0, false) }, 0);
  CheckBallWinding("a ball in the ball", { ball, MakeBall({ 1, 2, 3.5 }, 1.0) }, 2);
  CheckBallWinding("a ball apart", { ball, MakeBall({ 5, 2, 3 }, 1.0) }, 0);
  CheckBallWinding("balls that touch", { ball, MakeBall({ 4, 2, 3 }, 1.0) }, 0);
  CheckBallWinding("balls that cross", { ball, MakeBall({ 3.5, 2, 3 }, 1.0) }, 2);
  CheckBallWinding("balls that cross by 1e-7", { ball, MakeBall({ 4 - 1e-7, 2, 3 }, 1.0) }, 2);
  CheckBallWinding("by less than their gaps", { ball, MakeBall({ 4 - 1e-3, 2, 3 }, 1.0) }, 0, 2e-3);
  CheckBallWinding("a void that leaves the ball", { ball, MakeBall({ 1, 2, 4.5 }, 1.0, false) }, -1);
  CheckBallWinding("a void outside", { ball, MakeBall({ 5, 2, 3 }, 1.0, false) }, -1);
  CheckBallWinding("two voids that cross in a ball",
    { ball, MakeBall({ 1, 2, 3.5 }, 0.6, false), MakeBall({ 1, 2, 2.5 }, 0.6, false) }, -1);
  CheckBallWinding(
    "a void in a void", { ball, MakeBall({ 1, 2, 3 }, 1.0, false), MakeBall({ 1, 2, 3 }, 0.5, false) }, -1);
  CheckBallWinding(
    "a ball in a void", { ball, MakeBall({ 1, 2, 3 }, 1.0, false), MakeBall({ 1, 2, 3 }, 0.5) }, 0);
  CheckBallWinding("a ball in a void that leaves it",
    { ball, MakeBall({ 1, 2, 3 }, 1.0, false), MakeBall({ 1, 2, 3.8 }, 0.5) }, 2);
  CheckBallWinding("inside out", { MakeBall({ 1, 2, 3 }, 2.0, false) }, -1);

  sm::BodyIntegrals body = MakeBallIntegrals(MakeRoundBody({ MakeBall({ 1, 2, 3 }, 2.0, false) }));
  body.InsideOut = true;
  CheckEqual("one that the run reversed", 0, sm::FindSelfCrossing({ &body }).Winding);
  body.InsideOut = false;
  body.Sides = { -1 };
  CheckEqual("as a shell", 0, sm::FindSelfCrossing({ &body }).Winding);
  std::vector<sm::FaceIntegrals> twice = *body.Faces;
  twice[0].Face[sm::MassArea] *= 2.0;
  body.Faces = std::make_shared<const std::vector<sm::FaceIntegrals>>(twice);
  CheckEqual("a face of twice the area of its sphere", "face #7 does not cover its sphere once",
    sm::FindSelfCrossing({ &body }).Unchecked);
}

/// Voids in a cube of balls: points and pairs do not grow with the square of their number, and the one that
/// crosses another is found.
void CheckManyVoids()
{
  constexpr int side = 8;
  for (const bool isCrossing : { false, true })
  {
    Faces faces = { MakeBall({ 4, 4, 4 }, 8.0) };
    for (int i = 0; i < side * side * side; ++i)
    {
      const sm::Vector3 center = { 0.5 + i % side, 0.5 + i / side % side, 0.5 + i / side / side };
      faces.push_back(MakeBall(center, isCrossing && i == 300 ? 0.51 : 0.5, false));
    }
    const sm::SelfCrossing found =
      CheckBallWinding("voids that touch each other", faces, isCrossing ? -1 : 0);
    CheckRange("points of a void", 0.0, static_cast<double>(found.Samples) / (side * side * side), 10.0);
  }
}
}

int TestBallBodies(int, char*[])
{
  CheckBalls();
  CheckBallsAndBoxes();
  CheckBallsAndTori();
  CheckBallWindings();
  CheckManyVoids();
  return Finish();
}
