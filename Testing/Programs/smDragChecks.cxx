// Checks of the drags of the shipped recording.
#include "smEditPartChecks.h"
#include "smNetMoments.h"

#include "smBodyScene.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNURBSDataSet.h>
#include <vtkPointData.h>
#include <vtkTesting.h>

#include <algorithm>
#include <fstream>

namespace smtest
{
namespace
{
namespace names = sm::names;

/// The number of pixels in which two pictures differ; -1 when their sizes differ.
long long CountDifferent(vtkImageData* a, vtkImageData* b)
{
  vtkDataArray* x = a->GetPointData()->GetScalars();
  vtkDataArray* y = b->GetPointData()->GetScalars();
  if (x->GetNumberOfValues() != y->GetNumberOfValues() || x->GetNumberOfValues() == 0)
  {
    return -1;
  }
  long long count = 0;
  for (vtkIdType i = 0; i < x->GetNumberOfTuples(); ++i)
  {
    const double* p = x->GetTuple3(i);
    const Point3 first{ p[0], p[1], p[2] };
    const double* q = y->GetTuple3(i);
    const Point3 second{ q[0], q[1], q[2] };
    if (first != second && ++count <= 5)
    {
      const int width = a->GetDimensions()[0];
      std::printf("     pixel %d %d: %g %g %g and %g %g %g\n", static_cast<int>(i % width),
        static_cast<int>(i / width), first[0], first[1], first[2], second[0], second[1], second[2]);
    }
  }
  return count;
}

/// The largest distance of the display points from their faces, for a body without a placement.
double GetMeshError(vtkNURBSDataSet* body)
{
  vtkDataArray* faces = body->GetPointData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName());
  vtkDataArray* parameters = body->GetPointData()->GetArray(vtkNURBSDataSet::ParametersArrayName());
  const double* origin = body->GetModel()->GetOrigin();
  double worst = 0.0;
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    const sm::FacePointer& face =
      body->GetModel()->GetFaces().at(static_cast<std::size_t>(faces->GetComponent(i, 0)));
    double p[3];
    double q[3];
    face->Surface.Evaluate(parameters->GetComponent(i, 0), parameters->GetComponent(i, 1), p);
    body->GetPoint(i, q);
    worst =
      std::max(worst, std::hypot(p[0] + origin[0] - q[0], p[1] + origin[1] - q[1], p[2] + origin[2] - q[2]));
  }
  return worst;
}

/// One drag of the shipped recording: its start, its displacement in pixels, and true when it is along the
/// normal.
struct Drag
{
  int X;
  int Y;
  int Dx;
  int Dy;
  bool AlongNormal;
};

/// The drags of a recording.
std::vector<Drag> ReadDrags(const std::string& fileName)
{
  std::vector<Drag> drags;
  std::ifstream file(fileName);
  std::string event;
  int x = 0;
  int y = 0;
  int modifiers = 0;
  int ignored = 0;
  std::string key;
  std::string comment;
  while (file.peek() == '#')
  {
    std::getline(file, comment);
  }
  Drag drag{};
  while (file >> event >> x >> y >> modifiers >> ignored >> ignored >> key)
  {
    if (event == "LeftButtonPressEvent")
    {
      drag = { x, y, 0, 0, (modifiers & EditSession::Shift) != 0 };
    }
    else if (event == "LeftButtonReleaseEvent" && (x != drag.X || y != drag.Y))
    {
      drag.Dx = x - drag.X;
      drag.Dy = y - drag.Y;
      drags.push_back(drag);
    }
  }
  return drags;
}

void CheckAgainstFormula(EditSession& session, NetMoments& expected)
{
  expected.Integrate();
  vtkMassPropertiesGPU* mass = session.Scene.GetMass();
  const double* origin = session.Part.GetBody(0)->GetModel()->GetOrigin();
  const char* why = "Gauss sums, 25600 samples";
  Check("volume", expected.Volume, mass->GetVolume(), 1e-12 * expected.Volume + mass->GetVolumeBound(), why);
  double center[3];
  double inertia[9];
  mass->GetCenterOfMass(center);
  mass->GetVolumeInertia(inertia);
  const double size = std::cbrt(expected.Volume);
  const double trace = inertia[0] + inertia[4] + inertia[8];
  for (int r = 0; r < 3; ++r)
  {
    Check(
      "centre", expected.Center[r] + origin[r], center[r], 1e-12 * size + mass->GetCenterOfMassBound(), why);
    for (int c = r; c < 3; ++c)
    {
      Check("inertia", expected.Inertia[r][c], inertia[3 * r + c],
        1e-12 * trace + mass->GetVolumeInertiaBound(), why);
    }
  }
}

/// Compares the moved control points of the net with the drags, and moves those of `net` alike. Returns the
/// number of dragged points.
int CheckMoves(
  EditSession& session, vtkTrimmedNURBSModel* original, const std::vector<Drag>& drags, NetMoments& net)
{
  const int face = session.Scene.GetNet().GetFace();
  CheckTrue("a net is shown", session.Scene.GetNet().IsShown());
  const sm::NURBSSurface& surface = original->GetFaces().at(face)->Surface;
  int moved = 0;
  int followed = 0;
  for (int i = 0; i < surface.NumberOfControlPoints[0] * surface.NumberOfControlPoints[1]; ++i)
  {
    const sm::Grip grip = session.Scene.GetNet().GetGrip(i);
    const std::array<double, 4>& from = surface.ControlPoints[i];
    const Point3 was = sm::ToWorld(session.Part.GetBody(0), from);
    const Point3 now = GetWorld(session, grip);
    const Point3 by{ now[0] - was[0], now[1] - was[1], now[2] - was[2] };
    const double length = std::hypot(by[0], by[1], by[2]);
    if (length == 0.0)
    {
      continue;
    }
    const std::array<int, 2> pixel = session.ToPixel(was);
    const auto drag = std::find_if(drags.begin(), drags.end(),
      [&](const Drag& d) { return std::hypot(d.X - pixel[0], d.Y - pixel[1]) < 12.0; });
    if (!CheckTrue("a point that moved was dragged", drag != drags.end()))
    {
      continue;
    }
    ++moved;
    if (!drag->AlongNormal)
    {
      CheckVector("displacement", session.ToDisplacement(was, drag->Dx, drag->Dy), by, 1e-9 * length);
    }
    followed += net.Move({ from[0], from[1], from[2] }, by);
  }
  CheckEqual("every drag moved a point", static_cast<long long>(drags.size()), moved);
  CheckTrue("and those of neighbours with it", followed > moved, std::to_string(followed));
  return moved;
}

/// Undo, redo and reset by keys; a click outside the part removes the net and the notice.
void CheckUndo(EditSession& session, int steps, const std::vector<double>& first, vtkImageData* before)
{
  vtkMassPropertiesGPU* mass = session.Scene.GetMass();
  const std::vector<double> last = GetFieldNumbers(mass);
  const auto press = [&](int count, const char* key)
  {
    for (int i = 0; i < count; ++i)
    {
      session.AddKey(key, EditSession::Control);
    }
  };
  press(steps, "z");
  session.AddClick(700, 540);
  session.Play();
  CheckTrue("undone, the first bits", HaveSameBits(first, GetFieldNumbers(mass)));
  CheckEqual("undone, the first picture", 0, CountDifferent(before, sm::GrabImage(session.Window)));
  press(1, "z");
  session.Play();
  CheckTrue("nothing more to undo", HaveSameBits(first, GetFieldNumbers(mass)));
  press(steps, "y");
  session.Play();
  CheckTrue("redone, the last bits", HaveSameBits(last, GetFieldNumbers(mass)));
  session.AddKey("r");
  session.AddClick(700, 540);
  session.Play();
  CheckTrue("reset, the first bits", HaveSameBits(first, GetFieldNumbers(mass)));
  CheckEqual("reset, the first picture", 0, CountDifferent(before, sm::GrabImage(session.Window)));
}
}

void CheckDrag(
  vtkSTEPReader* reader, const std::string& events, const std::string& folder, int argc, char* argv[])
{
  EditSession session(reader->GetOutput(), "free_form_part.step", folder);
  vtkMassPropertiesGPU* mass = session.Scene.GetMass();
  const std::vector<double> first = GetFieldNumbers(mass);
  const vtkSmartPointer<vtkImageData> before = sm::GrabImage(session.Window);
  CheckRange(
    "display points on their faces", 0.0, GetMeshError(session.Part.GetBody(0)), 1e-6, "OpenCASCADE's");
  NetMoments net(session.Part.GetBody(0)->GetModel());
  CheckAgainstFormula(session, net);
  vtkSmartPointer<vtkTrimmedNURBSModel> original = session.Part.GetBody(0)->GetModel();

  // The effect of each drag follows from the recording and the camera, which does not move.
  const std::vector<Drag> drags = ReadDrags(events);
  CheckTrue("the recording has drags", drags.size() >= 3);
  CheckEqual("played", "", sm::PlayEvents(session.Interactor, events));
  const int moved = CheckMoves(session, original, drags, net);
  CheckEqual("status", names::StatusOk, mass->GetStatus());
  CheckEqual("nothing opened", 0, static_cast<long long>(session.Part.GetOpened(0).size()));
  CheckAgainstFormula(session, net);
  CheckTrue("the volume is another", std::fabs(mass->GetVolume() - first[0]) > 100.0);
  const std::vector<double> last = GetFieldNumbers(mass);
  CheckTrue("the bits of a full run", HaveSameBits(last, RunAnew(session)));
  CheckRange("display points on the new faces", 0.0, GetMeshError(session.Part.GetBody(0)), 1e-6);
  CheckTrue("an update for every move", session.Scene.GetTimes().size() > 3 * drags.size());

  // vtkImageDifference forgives shifts by a pixel and 16 of 255 in colour, and sums the rest: the same driver
  // gives 0.
  vtkNew<vtkTesting> testing;
  testing->AddArguments(argc, const_cast<const char**>(argv));
  testing->SetRenderWindow(session.Window);
  CheckEqual("picture", vtkTesting::PASSED, testing->RegressionTest(5.0));
  const vtkSmartPointer<vtkImageData> after = sm::GrabImage(session.Window);
  CheckRange("pixels that changed", 5000.0, static_cast<double>(CountDifferent(before, after)), 400000.0);

  CheckUndo(session, moved, first, before);
}
}
