// TestBuoyancySums FOLDER BACKEND: what is below a plane and what is above it are the whole, for solids and
// face by face.
#include "smBuoyancySums.h"
#include "smTestManifest.h"

namespace
{
using namespace smtest;

void CheckSolid(const Expected& solid, const std::vector<Vector>& directions, bool withFaces)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(solid.Path.c_str());
  UseCoarseMesh(reader);
  CheckBelowAndAbove(reader, solid.Solid, directions, withFaces);
}

void CheckSums(const Manifest& manifest)
{
  const std::vector<Vector> directions = { { 0, 0, 1 }, { 1, 0, 0 }, { 0.3L, -0.5L, 0.8L } };
  for (const char* solid :
    { "slanted_hole", "bicylinder", "hollow_sphere", "airfoil", "wavy_plate", "torus" })
  {
    CheckSolid(manifest.GetSolid(solid, "plain")[0], directions, true);
  }
  for (const char* solid :
    { "ellipsoid", "gear", "spline_ring", "graph_9_9", "rational_block", "moebius_1000" })
  {
    CheckSolid(manifest.GetSolid(solid, "plain")[0], { directions.back() }, false);
  }
  // The tori's inner circle: a plane that touches a saddle.
  Scene scene(manifest.GetSolid("torus", "plain")[0].Path);
  double sum = 0.0;
  double bound = 0.0;
  for (const Real sign : { 1, -1 })
  {
    SetPlane(scene.Filter, { "", { 14, 0, 0 }, { sign, 0, 0 }, {} });
    scene.Filter->Update();
    CheckEqual("status of the torus at its saddle", "ok", scene.Filter->GetStatus());
    sum += scene.Filter->GetDisplacedVolume();
    bound += scene.Filter->GetDisplacedVolumeBound();
  }
  Check("torus at its saddle", 2.0 * 3.14159265358979323846 * 3.14159265358979323846 * 20.0 * 36.0, sum,
    bound, "the bounds");
}
}

int TestBuoyancySums(int argc, char* argv[])
{
  RequireUsage(argc == 3, "TestBuoyancySums FOLDER BACKEND");
  SetBackend(argv[2]);
  CheckSums(Manifest(argv[1]));
  return Finish();
}
