// TestEditPart MODE FILE.step EVENTS FOLDER [-T FOLDER -V BASELINE.png]: the interactive example, played back.
//   drag     the shipped recording: values against a full run and against a formula, picture, undo
//   placed   a rotated, mirrored, translated body: drags along the screen and the normal, a cancelled drag, weights
//   open     one face moved alone: the opened edges and their gaps
//   record   events of a window are recorded, with its size, and give the same bits when they are played
//   numbers  the texts have decimal points, also in the locale de_DE.UTF-8 where LOCPATH has it
#include "smEditSession.h"
#include "smMassPropertyNames.h"
#include "smNetMoments.h"
#include "smTestPipeline.h"

#include "smBodyScene.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkMassPropertiesGPU.h>
#include <vtkNURBSDataSet.h>
#include <vtkNURBSTransform.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPropCollection.h>
#include <vtkRendererCollection.h>
#include <vtkSTEPReader.h>
#include <vtkTesting.h>
#include <vtkTextActor.h>

#include <algorithm>
#include <clocale>
#include <cstdlib>
#include <regex>
#include <vector>

namespace
{
using namespace smtest;
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

/// The results of a new filter for the part.
std::vector<double> RunAnew(EditSession& session)
{
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetRenderWindow(session.Window);
  mass->ShowPrincipalAxesOn();
  mass->SetInputData(session.Part.GetBodies());
  mass->Update();
  CheckTrue(
    "a full run evaluates everything", mass->GetEvaluations() > session.Scene.GetMass()->GetEvaluations());
  return GetFieldNumbers(mass);
}

Point3 GetStored(EditSession& session, const sm::Grip& grip)
{
  std::array<double, 4> point{};
  sm::GetControlPoint(session.Part.GetBody(grip.Body)->GetModel(), grip.Face, grip.Index, point);
  return { point[0] / point[3], point[1] / point[3], point[2] / point[3] };
}

Point3 GetWorld(EditSession& session, const sm::Grip& grip)
{
  Point3 world{};
  session.Part.GetPosition(grip, world);
  return world;
}

void CheckVector(const std::string& what, const Point3& expected, const Point3& actual, double limit)
{
  for (int c = 0; c < 3; ++c)
  {
    Check(what + " " + "xyz"[c], expected[c], actual[c], limit);
  }
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

// --- drag --------------------------------------------------------------------------------------

/// One drag of the shipped recording: its start, its displacement in pixels, and true when it is along the normal.
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

/// Compares the moved control points of the net with the drags, and moves those of `net` alike. Returns the number of dragged points.
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

/// Undo, redo and reset by keys; a click beside the part removes the net and the notice.
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

  // vtkImageDifference forgives shifts by a pixel and 16 of 255 in colour, and sums the rest: the same driver gives 0.
  vtkNew<vtkTesting> testing;
  testing->AddArguments(argc, const_cast<const char**>(argv));
  testing->SetRenderWindow(session.Window);
  CheckEqual("picture", vtkTesting::PASSED, testing->RegressionTest(5.0));
  const vtkSmartPointer<vtkImageData> after = sm::GrabImage(session.Window);
  CheckRange("pixels that changed", 5000.0, static_cast<double>(CountDifferent(before, after)), 400000.0);

  CheckUndo(session, moved, first, before);
}

// --- placed ------------------------------------------------------------------------------------

/// Drags a point along the normal of its face, then cancels the drag.
void CheckNormal(EditSession& session, const sm::Grip& grip)
{
  std::printf("--- along the normal\n");
  vtkMassPropertiesGPU* mass = session.Scene.GetMass();
  const std::vector<double> before = GetFieldNumbers(mass);
  const Point3 now = GetWorld(session, grip);
  const Point3 normal = session.Part.GetNormal(grip);
  const std::array<int, 2> start = session.ToPixel(now);
  // The direction of the drag on the screen is that of the normal.
  const std::array<int, 2> tip =
    session.ToPixel({ now[0] + 10.0 * normal[0], now[1] + 10.0 * normal[1], now[2] + 10.0 * normal[2] });
  session.AddDrag(start[0], start[1], tip[0] - start[0], tip[1] - start[1], EditSession::Shift);
  session.Play();
  const Point3 pulled = GetWorld(session, grip);
  const Point3 pull{ pulled[0] - now[0], pulled[1] - now[1], pulled[2] - now[2] };
  const double along = vtkMath::Dot(pull, normal);
  Check("along the normal", std::hypot(pull[0], pull[1], pull[2]), along, 1e-9 * along);
  CheckRange("about 10", 7.0, along, 13.0, "pixels are whole, and nearer is larger");
  CheckTrue("outwards: more volume", mass->GetVolume() > before[0]);

  std::printf("--- cancelled\n");
  session.AddKey("z", EditSession::Control); // not in the middle of a drag
  session.AddKey("Escape");
  session.Add("LeftButtonReleaseEvent", tip[0], tip[1]);
  session.Play();
  CheckTrue("the bits before the drag", HaveSameBits(before, GetFieldNumbers(mass)));
}

void CheckWeight(EditSession& session, const sm::Grip& grip)
{
  std::printf("--- weight\n");
  vtkMassPropertiesGPU* mass = session.Scene.GetMass();
  const std::vector<double> before = GetFieldNumbers(mass);
  const Point3 now = GetWorld(session, grip);
  const std::array<int, 2> start = session.ToPixel(now);
  session.Add("MouseWheelForwardEvent", start[0], start[1], EditSession::Control);
  session.Play();
  double weight = 0.0;
  session.Part.GetWeight(grip, weight);
  Check("weight", 1.25, weight, 0.0);
  CheckVector("the same position", now, GetWorld(session, grip), 1e-12 * 600.0);
  CheckTrue("other numbers", !HaveSameBits(before, GetFieldNumbers(mass)));
  CheckTrue("the bits of a full run", HaveSameBits(GetFieldNumbers(mass), RunAnew(session)));
  session.AddKey("z", EditSession::Control);
  session.Play();
  CheckTrue("undone, the same bits", HaveSameBits(before, GetFieldNumbers(mass)));
}

void CheckView(EditSession& session)
{
  std::printf("--- the view alone\n");
  const std::vector<double> before = GetFieldNumbers(session.Scene.GetMass());
  const std::size_t updates = session.Scene.GetTimes().size();
  session.AddDrag(20, 500, 60, 30);
  session.Add("LeftButtonReleaseEvent", 80, 530);
  session.Add("MouseWheelForwardEvent", 360, 280);
  session.Play();
  CheckTrue("changes no number", HaveSameBits(before, GetFieldNumbers(session.Scene.GetMass())));
  CheckEqual("and is no update", static_cast<long long>(updates),
    static_cast<long long>(session.Scene.GetTimes().size()));
}

void CheckPlaced(vtkSTEPReader* reader, const std::string& folder)
{
  vtkNew<vtkNURBSTransform> place;
  place->SetInputData(reader->GetOutput());
  place->SetRotation(35.0, -20.0, 110.0);
  place->SetMirror(vtkNURBSTransform::X);
  place->SetTranslation(300.0, -500.0, 40.0);
  place->Update();
  EditSession session(
    vtkPartitionedDataSetCollection::SafeDownCast(place->GetOutputDataObject(0)), "placed", folder);
  vtkMassPropertiesGPU* mass = session.Scene.GetMass();
  const std::vector<double> first = GetFieldNumbers(mass);
  // Where a user would click; then a point inside the face that was hit.
  int body = -1;
  int face = -1;
  for (int y = 150; y < 400 && face < 0; y += 10)
  {
    session.Scene.PickFace(360, y, body, face);
  }
  if (!CheckTrue("a face in the middle", face >= 0))
  {
    return;
  }
  session.ShowNet(body, face);
  const sm::Grip grip{ body, face, { 2, 2 } };
  NetMoments net(session.Part.GetBody(body)->GetModel());

  const Point3 was = GetWorld(session, grip);
  const Point3 stored = GetStored(session, grip);
  const std::array<int, 2> pixel = session.ToPixel(was);
  // Grabbed two pixels off: it must not jump.
  session.AddDrag(pixel[0] + 2, pixel[1] - 1, 37, 24);
  session.Add("LeftButtonReleaseEvent", pixel[0] + 39, pixel[1] + 23);
  const Point3 expected = session.ToDisplacement(was, 37, 24);
  session.Play();
  const int hit = session.Scene.GetNet().GetSelection();
  const sm::Grip dragged = session.Scene.GetNet().GetGrip(hit);
  CheckEqual("the point that was meant", 2 * 5 + 2, hit);
  CheckTrue("in its face", dragged.Face == face);
  const Point3 now = GetWorld(session, grip);
  const double length = std::hypot(expected[0], expected[1], expected[2]);
  CheckVector(
    "displacement", { was[0] + expected[0], was[1] + expected[1], was[2] + expected[2] }, now, 1e-8 * length);
  const Point3 storedNow = GetStored(session, grip);
  const Point3 storedBy{ storedNow[0] - stored[0], storedNow[1] - stored[1], storedNow[2] - stored[2] };
  Check("of the same length in the model", length, std::hypot(storedBy[0], storedBy[1], storedBy[2]),
    1e-8 * length);
  net.Move(stored, storedBy);
  net.Integrate();
  Check("volume", net.Volume, mass->GetVolume(), 1e-12 * net.Volume + mass->GetVolumeBound());
  CheckTrue("is another", std::fabs(mass->GetVolume() - first[0]) > 1.0);
  const std::vector<double> second = GetFieldNumbers(mass);
  CheckTrue("the bits of a full run", HaveSameBits(second, RunAnew(session)));

  CheckNormal(session, grip);
  CheckWeight(session, grip);
  CheckView(session);
}

// --- open --------------------------------------------------------------------------------------

void CheckOpen(vtkSTEPReader* reader, const std::string& folder)
{
  EditSession session(reader->GetOutput(), "open", folder);
  vtkMassPropertiesGPU* mass = session.Scene.GetMass();
  const std::vector<double> first = GetFieldNumbers(mass);
  int body = -1;
  int face = -1;
  session.Scene.PickFace(355, 205, body, face);
  session.ShowNet(body, face);
  // The middle of a boundary row.
  const sm::Grip grip{ body, face, { 2, 0 } };
  const Point3 was = GetWorld(session, grip);
  const std::array<int, 2> pixel = session.ToPixel(was);
  const auto drag = [&]
  {
    session.AddDrag(pixel[0], pixel[1], 10, 30);
    session.Add("LeftButtonReleaseEvent", pixel[0] + 10, pixel[1] + 30);
    session.Play();
  };
  session.AddKey("o");
  drag();
  const Point3 now = GetWorld(session, grip);
  const double length = std::hypot(now[0] - was[0], now[1] - was[1], now[2] - was[2]);
  CheckRange("it moved", 1.0, length, 50.0);
  const std::vector<sm::OpenedEdge>& opened = session.Part.GetOpened(body);
  CheckEqual("edges that opened", 1, static_cast<long long>(opened.size()));
  if (!opened.empty())
  {
    // The row's points move by N_2 d, at most 1/2 of it: knots 0 0 0 0 1/2 1 1 1 1, N_2(1/2) = 1/2. Foot points may be nearer.
    CheckRange("gap", 0.35 * length, opened[0].Gap, 0.5 * length + 1e-9, "half of the displacement at most");
    Check("as the filter says", opened[0].Gap,
      GetFieldNumbers(mass).empty()
        ? 0.0
        : mass->GetOutput()->GetFieldData()->GetArray(names::MaxGap)->GetComponent(0, 0),
      0.02 * length);
  }
  const std::vector<double> torn = GetFieldNumbers(mass);
  CheckTrue("the bits of a full run", HaveSameBits(torn, RunAnew(session)));
  const vtkSmartPointer<vtkImageData> picture = sm::GrabImage(session.Window);
  long long red = 0;
  vtkDataArray* colors = picture->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
  {
    red +=
      colors->GetComponent(i, 0) > 180 && colors->GetComponent(i, 1) < 60 && colors->GetComponent(i, 2) < 60
      ? 1
      : 0;
  }
  CheckRange("red pixels: the edge, the sentence", 200.0, static_cast<double>(red), 20000.0);

  std::printf("--- together\n");
  session.AddKey("z", EditSession::Control);
  session.AddKey("o");
  session.Play();
  CheckTrue("undone, the first bits", HaveSameBits(first, GetFieldNumbers(mass)));
  drag();
  CheckEqual("nothing opened", 0, static_cast<long long>(session.Part.GetOpened(body).size()));
  CheckTrue("other numbers", !HaveSameBits(torn, GetFieldNumbers(mass)));
}

// --- numbers -------------------------------------------------------------------------------------

/// All texts of the window's layers.
std::string GetTexts(vtkRenderWindow* window)
{
  std::string texts;
  for (int i = 0; i < window->GetRenderers()->GetNumberOfItems(); ++i)
  {
    auto* renderer = vtkRenderer::SafeDownCast(window->GetRenderers()->GetItemAsObject(i));
    vtkPropCollection* props = renderer->GetViewProps();
    for (int k = 0; k < props->GetNumberOfItems(); ++k)
    {
      auto* actor = vtkTextActor::SafeDownCast(props->GetItemAsObject(k));
      texts += actor ? std::string(actor->GetInput()) + "\n" : std::string();
    }
  }
  return texts;
}

void CheckNumbers(vtkSTEPReader* reader, const std::string& folder)
{
  // Where no such locale exists the test checks the locale "C".
  const bool hasCommas = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
  CheckTrue("the locale of LOCPATH", hasCommas || !std::getenv("LOCPATH"));
  EditSession session(reader->GetOutput(), "numbers", folder);
  session.Scene.SetShowTimes(true);
  int body = -1;
  int face = -1;
  session.Scene.PickFace(355, 205, body, face);
  session.ShowNet(body, face);
  const std::array<int, 2> pixel = session.ToPixel(GetWorld(session, { body, face, { 2, 0 } }));
  session.AddKey("o");
  session.AddDrag(pixel[0], pixel[1], 10, 30);
  session.Add("LeftButtonReleaseEvent", pixel[0] + 10, pixel[1] + 30);
  session.Play();
  session.Scene.Draw(); // in the locale of the test, which the player does not use
  std::string texts = GetTexts(session.Window);
  for (const char* pattern : { "Update: [0-9]+[.][0-9] ms", "largest gap [0-9]+[.][0-9]+ mm" })
  {
    CheckTrue(std::string("texts have ") + pattern, std::regex_search(texts, std::regex(pattern)), texts);
  }
  vtkRenderWindowInteractor* interactor = session.Interactor;
  interactor->SetEventInformation(pixel[0], pixel[1], 1);
  interactor->MouseWheelForwardEvent();
  texts = GetTexts(session.Window);
  CheckTrue("weight", std::regex_search(texts, std::regex("weight 1[.]25")), texts);
  CheckTrue("no decimal comma", !std::regex_search(texts, std::regex("[0-9],[0-9]")), texts);
}

// --- record ------------------------------------------------------------------------------------

void CheckRecord(vtkSTEPReader* reader, const std::string& folder)
{
  const std::string events = folder + "/recorded.events";
  std::vector<double> first;
  std::vector<double> last;
  {
    EditSession session(reader->GetOutput(), "recorded", folder);
    first = GetFieldNumbers(session.Scene.GetMass());
    vtkRenderWindowInteractor* interactor = session.Interactor;
    sm::EventRecording recording(interactor, events);
    // As a window's messages arrive.
    interactor->SetEventInformation(355, 205);
    interactor->LeftButtonPressEvent();
    interactor->LeftButtonReleaseEvent();
    interactor->SetEventInformation(369, 242);
    interactor->MouseMoveEvent();
    interactor->LeftButtonPressEvent();
    interactor->SetEventInformation(380, 262, 0, 1);
    interactor->MouseMoveEvent();
    interactor->SetEventInformation(360, 302);
    interactor->MouseMoveEvent();
    interactor->LeftButtonReleaseEvent();
    interactor->SetEventInformation(360, 302, 0, 0, 'h', 0, "h");
    interactor->KeyPressEvent();
    CheckTrue("help is shown", session.Scene.IsHelpShown());
    last = GetFieldNumbers(session.Scene.GetMass());
    CheckTrue("the drag did something", !HaveSameBits(first, last));
  }
  const std::optional<std::array<int, 2>> size = sm::ReadWindowSize(events);
  CheckTrue("the recording has the size of its window",
    size == std::array<int, 2>{ EditSession::Width, EditSession::Height });
  EditSession session(reader->GetOutput(), "played", folder);
  CheckTrue("the file's part again", HaveSameBits(first, GetFieldNumbers(session.Scene.GetMass())));
  CheckEqual("played", "", sm::PlayEvents(session.Interactor, events));
  CheckTrue("the same bits", HaveSameBits(last, GetFieldNumbers(session.Scene.GetMass())));
  CheckTrue("help is shown", session.Scene.IsHelpShown());

  session.Window->SetSize(EditSession::Width - 20, EditSession::Height);
  const std::string refusal = sm::PlayEvents(session.Interactor, events);
  CheckTrue(
    "refused in a window of another size", refusal.find("give --size 720 560") != std::string::npos, refusal);
  CheckTrue("and nothing is played", HaveSameBits(last, GetFieldNumbers(session.Scene.GetMass())));
}
}

int main(int argc, char* argv[])
{
  const std::string mode = argc > 4 ? argv[1] : "";
  if (mode != "drag" && mode != "placed" && mode != "open" && mode != "record" && mode != "numbers")
  {
    std::fprintf(stderr,
      "usage: TestEditPart drag|placed|open|record|numbers FILE.step EVENTS FOLDER [-T FOLDER -V "
      "BASELINE.png]\n");
    return 2;
  }
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(argv[2]);
  reader->SetLinearDeflection(2e-4);
  reader->SetAngularDeflection(0.12);
  reader->Update();
  if (mode == "drag")
  {
    CheckDrag(reader, argv[3], argv[4], argc, argv);
  }
  else if (mode == "placed")
  {
    CheckPlaced(reader, argv[4]);
  }
  else if (mode == "open")
  {
    CheckOpen(reader, argv[4]);
  }
  else if (mode == "numbers")
  {
    CheckNumbers(reader, argv[4]);
  }
  else
  {
    CheckRecord(reader, argv[4]);
  }
  return Finish();
}
