// edit_part: moves control points of a part with the mouse, and shows its mass properties at every move.
#include "smBodyScene.h"
#include "smEditScene.h"
#include "smEditStyle.h"
#include "smEventPlayer.h"
#include "smJsonFields.h"
#include "smOptions.h"
#include "smQuantities.h"
#include "smText.h"

#include <smMassPropertyNames.h>
#include <smSafeFile.h>
#include <vtkComputeContext.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkImageAppend.h>
#include <vtkImageData.h>
#include <vtkMassPropertiesGPU.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPolyData.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSMPTools.h>
#include <vtkSTEPReader.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <vector>

namespace
{
using sm::Json;

const char* const Footer =
  R"(In the window: click a face, drag a control point; h shows the other mouse buttons and keys.
Without a display --play draws off screen. A recording holds the size of its window, which --play uses; it cannot be
played in a window of another size.

Examples:
  edit_part
  edit_part bracket.step
  edit_part --record drag.events
  edit_part --play drag.events --json values.json --screenshot after.png

Exit status:
  0  ended with status ok
  1  wrong usage, no display, or an output could not be written
  2  the file is unreadable, or has no solid or surface
  3  the last result is flagged: open, tolerance-not-met, suspect)";

/// Returns the path of the sample part: that of the installation, otherwise that of the sources.
std::string GetDefaultPart()
{
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  const fs::path installed = (program.parent_path() / SM_INSTALLED_PART).lexically_normal();
  return fs::exists(installed, ignored) ? installed.string() : SM_FREE_FORM_PART;
}

struct Arguments
{
  std::string File = GetDefaultPart();
  std::string Play;
  std::string Record;
  std::string Json;
  std::string Screenshot;
  std::string BeforeAfter;
  std::vector<int> Size; ///< width and height; empty: that of the recording, or the default
  bool NoTimes = false;
  bool HoldVolume = false;
};

const std::array<int, 2> DefaultSize = { 900, 700 };

int Complain(const std::string& message)
{
  std::cerr << "edit_part: " << message << "\n";
  return sm::UsageOrOutput;
}

/// Reads the arguments. Returns false, with the exit status, if the program must end.
bool Parse(int argc, char** argv, Arguments& arguments, int& exitStatus)
{
  CLI::App app(
    "Move the control points of a part with the mouse and watch its mass properties.", "edit_part");
  app.footer(Footer);
  app.add_option("file", arguments.File, "STEP file; without one, a pull handle of 40 free-form faces")
    ->type_name("FILE");
  auto* play = sm::AddFileOption(app, "--play", arguments.Play, "Play mouse and keys from FILE, then quit");
  sm::AddFileOption(app, "--record", arguments.Record, "Write mouse and keys to FILE")->excludes(play);
  sm::AddFileOption(app, "--json", arguments.Json,
    "Write the first and the last results and the times to FILE (- for standard\noutput) at the end");
  sm::AddFileOption(app, "--screenshot", arguments.Screenshot, "Write the last picture to FILE, a PNG");
  sm::AddFileOption(app, "--before-after", arguments.BeforeAfter,
    "Write the first and the last picture side by side to FILE, a PNG");
  app
    .add_option("--size", arguments.Size,
      "Width and height of the window in pixels (default: those of the recording\nto play, otherwise 900 "
      "700)")
    ->expected(2)
    ->check(CLI::Range(300, 8192))
    ->type_name("NUMBER");
  app.add_flag("--hold-volume", arguments.HoldVolume,
    "Hold the volume during drags, to 1e-9 of it: other control points of the face\nfollow; the key v "
    "switches it");
  app.add_flag("--no-times", arguments.NoTimes, "Show no times: they differ from run to run");
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    exitStatus = app.exit(error) == 0 ? sm::AllOk : sm::UsageOrOutput;
    return false;
  }
  if (arguments.Size.empty())
  {
    const std::array<int, 2> size = sm::ReadWindowSize(arguments.Play).value_or(DefaultSize);
    arguments.Size.assign(size.begin(), size.end());
  }
  return true;
}

/// Returns the minimum, median and maximum of one part of the times of all updates except the first one,
/// which is not that of an edit.
Json Summarize(const std::vector<sm::UpdateTimes>& times, double (*get)(const sm::UpdateTimes&))
{
  std::vector<double> values;
  for (std::size_t i = 1; i < times.size(); ++i)
  {
    values.push_back(get(times[i]));
  }
  if (values.empty())
  {
    return nullptr;
  }
  std::sort(values.begin(), values.end());
  return { { "best", values.front() }, { "median", values[values.size() / 2] }, { "worst", values.back() } };
}

Json GetQuantities(vtkFieldData* fields)
{
  sm::Quantities quantities = sm::ReadQuantities(fields, 0);
  return sm::WriteJsonFields([&quantities](sm::Fields& members) { quantities.Visit(members); });
}

Json Describe(const Arguments& arguments, const Json& first, sm::EditScene& scene)
{
  vtkMassPropertiesGPU* mass = scene.GetMass();
  vtkFieldData* fields = mass->GetOutput()->GetFieldData();
  const std::vector<sm::UpdateTimes>& times = scene.GetTimes();
  Json result{ { "version", 2 } };
  std::string name = arguments.File;
  result.update(sm::WriteJsonFields([&name](sm::Fields& members) { sm::VisitFileName(members, name); }));
  result.update({ { "length_unit", sm::GetText(fields, 0, sm::names::LengthUnit) },
    { "status", mass->GetStatus() }, { "backend", mass->GetBackendName() },
    { "renderer", mass->GetRenderer() }, { "first", first }, { "last", GetQuantities(fields) },
    { "opened", Json::array() }, { "faces", mass->GetNumberOfFaces() }, { "updates", times.size() - 1 } });
  for (int body = 0; body < scene.GetPart().GetNumberOfBodies(); ++body)
  {
    for (const sm::OpenedEdge& opened : scene.GetPart().GetOpened(body))
    {
      result["opened"].push_back(
        { { "edge", opened.Source->FileId }, { "face", opened.Face }, { "gap", opened.Gap } });
    }
  }
  const sm::VolumeHold& hold = scene.GetHold();
  result["hold"] = nullptr;
  if (hold.IsOn() && hold.GetVolume())
  {
    result["hold"] = { { "volume", *hold.GetVolume() }, { "largest_deviation", hold.GetMaxDeviation() },
      { "begin_seconds", hold.GetBeginSeconds() } };
  }
  Json& seconds = result["seconds"];
  seconds["hold"] = Summarize(times, [](const sm::UpdateTimes& t) { return t.Hold; });
  seconds["edit"] = Summarize(times, [](const sm::UpdateTimes& t) { return t.Edit; });
  seconds["display_points"] = Summarize(times, [](const sm::UpdateTimes& t) { return t.Display; });
  seconds["moments"] = Summarize(times, [](const sm::UpdateTimes& t) { return t.Moments; });
  seconds["computing"] = Summarize(times, [](const sm::UpdateTimes& t) { return t.GetComputing(); });
  seconds["picture"] = Summarize(times, [](const sm::UpdateTimes& t) { return t.Draw; });
  return result;
}

int WriteJson(const std::string& fileName, const Json& result)
{
  const std::string text = sm::Dump(result, 1) + "\n";
  if (fileName == "-")
  {
    return std::cout << text << std::flush ? sm::AllOk : Complain("the standard output cannot be written");
  }
  const std::string problem = sm::SaveFile(fileName, text);
  return problem.empty() ? sm::AllOk : Complain(fileName + " cannot be written: " + problem);
}

int WriteImage(vtkImageData* image, const std::string& fileName)
{
  const std::string error = sm::WriteImage(image, fileName);
  return error.empty() ? sm::AllOk : Complain(error);
}

/// Writes the requested files after the events. Returns the exit status.
int WriteOutputs(const Arguments& arguments, const Json& first, vtkImageData* before, vtkImageData* after,
  sm::EditScene& scene)
{
  int exitStatus = scene.GetMass()->GetStatus() == sm::names::StatusOk ? sm::AllOk : sm::Flagged;
  if (!arguments.Json.empty() && WriteJson(arguments.Json, Describe(arguments, first, scene)) != sm::AllOk)
  {
    exitStatus = sm::UsageOrOutput;
  }
  if (!arguments.Screenshot.empty() && WriteImage(after, arguments.Screenshot) != sm::AllOk)
  {
    exitStatus = sm::UsageOrOutput;
  }
  if (!arguments.BeforeAfter.empty())
  {
    vtkNew<vtkImageAppend> both;
    both->AddInputData(before);
    both->AddInputData(after);
    both->Update();
    exitStatus =
      WriteImage(both->GetOutput(), arguments.BeforeAfter) == sm::AllOk ? exitStatus : sm::UsageOrOutput;
  }
  return exitStatus;
}

/// Keeps the window's picture of the moment when the user ends the event loop: afterwards the interactor does
/// not render any more, and the frame buffer is undefined.
class LastPicture
{
public:
  LastPicture(vtkRenderWindow* window, vtkRenderWindowInteractor* interactor)
    : Window(window)
    , Interactor(interactor)
  {
    this->Tag = interactor->AddObserver(vtkCommand::ExitEvent, this, &LastPicture::OnExit);
  }
  ~LastPicture() { this->Interactor->RemoveObserver(this->Tag); }
  LastPicture(const LastPicture&) = delete;
  LastPicture& operator=(const LastPicture&) = delete;

  vtkSmartPointer<vtkImageData> Get() const
  {
    return this->Picture ? this->Picture : sm::GrabImage(this->Window);
  }

private:
  void OnExit()
  {
    // Other keys that were pressed meanwhile also invoke this callback.
    this->Picture = this->Get();
    this->Interactor->TerminateApp();
  }

  vtkRenderWindow* Window;
  vtkRenderWindowInteractor* Interactor;
  unsigned long Tag;
  vtkSmartPointer<vtkImageData> Picture;
};

int Run(const Arguments& arguments, vtkSTEPReader* reader, vtkRenderWindow* window,
  vtkRenderWindowInteractor* interactor)
{
  const std::string name = sm::GetFileName(arguments.File);
  sm::EditedPart part(reader->GetOutput());
  window->SetSize(arguments.Size[0], arguments.Size[1]);
  window->SetWindowName(("SolidMoments: " + name).c_str());
  interactor->SetRenderWindow(window);
  sm::EditScene scene(window, part, name);
  scene.SetShowTimes(!arguments.NoTimes);
  scene.GetHold().SetOn(arguments.HoldVolume);
  vtkNew<smEditStyle> style;
  style->SetScene(&scene);
  style->SetPictureStem(sm::GetStem(name));
  interactor->SetInteractorStyle(style);
  interactor->Initialize();
  scene.Draw();
  const Json first = GetQuantities(scene.GetMass()->GetOutput()->GetFieldData());
  const vtkSmartPointer<vtkImageData> before = sm::GrabImage(window);
  LastPicture last(window, interactor);
  if (!arguments.Play.empty())
  {
    const std::string wrong = sm::PlayEvents(interactor, arguments.Play);
    if (!wrong.empty())
    {
      return Complain(wrong);
    }
  }
  else if (!arguments.Record.empty())
  {
    sm::EventRecording recording(interactor, arguments.Record);
    interactor->Start();
  }
  else
  {
    interactor->Start();
  }
  const int exitStatus = WriteOutputs(arguments, first, before, last.Get(), scene);
  interactor->SetInteractorStyle(nullptr);
  return exitStatus;
}

bool Read(vtkSTEPReader* reader, const std::string& fileName)
{
  reader->SetFileName(fileName.c_str());
  // An edit keeps the triangles of the mesh, so they are fine enough for a flat face that becomes curved.
  reader->SetLinearDeflection(2e-4);
  reader->SetAngularDeflection(0.12);
  reader->Update();
  if (reader->GetStatus() == vtkSTEPReader::OK)
  {
    return true;
  }
  for (int i = 0; i < reader->GetNumberOfMessages(); ++i)
  {
    std::cerr << "edit_part: " << reader->GetMessage(i) << "\n";
  }
  Complain(fileName + " is " + reader->GetStatusAsString() + ": there is nothing to edit");
  return false;
}
}

int main(int argc, char** argv)
{
  Arguments arguments;
  int exitStatus = sm::AllOk;
  if (!Parse(argc, argv, arguments, exitStatus))
  {
    return exitStatus;
  }
  // Opened for appending, so that an existing recording is kept until the new one starts.
  if (!arguments.Record.empty() && !std::ofstream(arguments.Record, std::ios::app))
  {
    return Complain(arguments.Record + " cannot be written");
  }
  // vtkRenderWindow ends the program when the display does not answer; a context returns a status.
  vtkNew<vtkComputeContext> context;
  context->SetSource(vtkComputeContext::X);
  const int found = context->Start();
  // An old OpenGL is enough for pictures; the filter then computes on the CPU and reports it.
  const bool hasDisplay = found == vtkComputeContext::READY || found == vtkComputeContext::NO_COMPUTE ||
    found == vtkComputeContext::NO_DOUBLES;
  const std::string reason = context->GetReason();
  if (!hasDisplay && arguments.Play.empty())
  {
    return Complain("there is no display to draw on: " + reason + " Use --play to work off screen.");
  }
  vtkSMPTools::SetBackend("STDThread"); // ParaView's VTK starts with a single thread
  vtkNew<vtkSTEPReader> reader;
  if (!Read(reader, arguments.File))
  {
    return sm::Unreadable;
  }
  if (hasDisplay)
  {
    context->Stop();
    vtkNew<vtkRenderWindow> window;
    vtkNew<vtkRenderWindowInteractor> interactor;
    return Run(arguments, reader, window, interactor);
  }
  context->SetSource(vtkComputeContext::EGL);
  context->Start();
  if (!context->GetRenderWindow())
  {
    return Complain(context->GetReason());
  }
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  return Run(arguments, reader, context->GetRenderWindow(), interactor);
}
