// TestEditPart MODE FILE.step EVENTS FOLDER [-T FOLDER -V BASELINE.png]: the interactive example, played
// back.
//   drag     the shipped recording: values against a full run and against a formula, picture, undo
//   hold     the same with the volume held: the volume after each update, refusals, times
//   placed   a rotated, mirrored, translated body: drags along the screen and the normal, a cancelled drag,
//   weights open     one face moved alone: the opened edges and their gaps record   events of a window are
//   recorded, with its size, and give the same bits when they are played numbers  the texts have decimal
//   points, also in the locale de_DE.UTF-8 where LOCPATH has it
#include "smEditPartChecks.h"

#include "smBodyScene.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPropCollection.h>
#include <vtkRendererCollection.h>
#include <vtkTextActor.h>

#include <clocale>
#include <cstdlib>
#include <regex>
#include <vector>

namespace
{
using namespace smtest;
namespace names = sm::names;

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
    // The row's points move by N_2 d, at most 1/2 of it: knots 0 0 0 0 1/2 1 1 1 1, N_2(1/2) = 1/2. Foot
    // points may be nearer.
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
  if (mode != "drag" && mode != "placed" && mode != "open" && mode != "record" && mode != "numbers" &&
    mode != "hold")
  {
    std::fprintf(stderr,
      "usage: TestEditPart drag|hold|placed|open|record|numbers FILE.step EVENTS FOLDER [-T FOLDER -V "
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
  else if (mode == "hold")
  {
    CheckHold(reader, argv[3], argv[4]);
    const std::string part = argv[2];
    CheckHoldOfTrimmed(part.substr(0, part.rfind('/') + 1) + "sample_part.step", argv[4]);
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
