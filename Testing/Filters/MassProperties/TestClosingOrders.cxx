// TestClosingOrders own|shared|windows|contexts|exit|exit-in-render FOLDER: windows, filters and what feeds
// them end in every order. What is left goes on with the right values, nothing of ours stays on a GPU, and
// the program ends by itself: no crash at its end either.
#include "smCycleScene.h"

#include "smComputeBuffer.h"
#include "smComputeProgram.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkComputeContext.h>
#include <vtkOutputWindow.h>
#include <vtkStringOutputWindow.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

namespace
{
using namespace smtest;

void CheckNothingLives(const std::string& what)
{
  CheckEqual(what + ": buffers", 0, sm::ComputeBuffer::GetLiveCount());
  CheckEqual(what + ": programs", 0, sm::ComputeProgram::GetLiveCount());
}

/// Runs the filter once more, without results of earlier runs.
void CheckRuns(const std::string& what, vtkMassPropertiesGPU* mass, const Expected& part)
{
  mass->CacheFaceResultsOff();
  mass->SetRelativeTolerance(mass->GetRelativeTolerance() == 1e-9 ? 1e-8 : 1e-9);
  mass->Update();
  CheckEqual(what + ": backend", sm::names::BackendOpenGL, mass->GetBackendName());
  CheckTrue(what + ": it evaluates", mass->GetEvaluations() > 0);
  Check(what + ": volume", part.Volume, mass->GetVolume(), 1e-8 * part.Volume);
}

/// A window, its actors, the filter and what is upstream, ended in the order of the letters W, A, F, U.
void CheckOrder(const Expected& part, const std::string& order, bool shared, bool finalize)
{
  vtkSmartPointer<vtkRenderWindow> window = NewCycleWindow(part);
  CycleScene scene(part, shared ? window.Get() : nullptr);
  scene.Show(window);
  window->Render();
  const std::string what = order + (finalize ? ", finalized" : "");
  Check(what, part.Volume, scene.Mass->GetVolume(), 1e-8 * part.Volume);
  for (const char end : order)
  {
    if (end == 'W')
    {
      if (finalize)
      {
        window->Finalize();
      }
      window = nullptr;
    }
    else if (end == 'A')
    {
      if (window)
      {
        scene.Hide(window);
      }
      scene.Part = nullptr;
      scene.Glyph = nullptr;
    }
    else if (end == 'F')
    {
      scene.Mass = nullptr;
    }
    else
    {
      scene.Deform = nullptr;
      scene.Points = nullptr;
      scene.Reader = nullptr;
    }
    if (scene.Deform)
    {
      scene.Move(scene.Deform->GetDisplacement()[0] + 0.01 * part.Size);
    }
    if (scene.Mass)
    {
      CheckRuns(what, scene.Mass, part);
    }
    if (window)
    {
      window->Render();
    }
  }
  CheckNothingLives(what);
}

void CheckOrders(const Expected& part, bool shared)
{
  std::string order = "AFUW";
  do
  {
    CheckOrder(part, order, shared, false);
    CheckOrder(part, order, shared, true);
  } while (std::next_permutation(order.begin(), order.end()));
}

/// One scene in two windows, which are independent or share VTK's objects; the filters compute in the first.
void CheckWindows(const Expected& part)
{
  for (const bool related : { false, true })
  {
    for (const int first : { 0, 1 })
    {
      for (const bool filterFirst : { false, true })
      {
        const std::string what = std::string(related ? "related" : "two") + " windows, " +
          (first == 0 ? "first" : "second") + " closed first" + (filterFirst ? " after the filter" : "");
        vtkSmartPointer<vtkRenderWindow> windows[2] = { NewCycleWindow(part), NewCycleWindow(part) };
        if (related)
        {
          windows[1]->SetSharedRenderWindow(windows[0]);
        }
        CycleScene shown(part, windows[0]);
        // Mappers belong to one window: the second has actors of its own on the same filters.
        CycleScene other(part, windows[1]);
        other.Glyph->GetMapper()->SetInputConnection(shown.Mass->GetOutputPort());
        other.Part->GetMapper()->SetInputConnection(shown.Deform->GetOutputPort());
        other.Mass = nullptr;
        shown.Show(windows[0]);
        other.Show(windows[1]);
        windows[0]->Render();
        windows[1]->Render();
        CheckRuns(what, shown.Mass, part);
        if (filterFirst)
        {
          shown.Hide(windows[0]);
          other.Hide(windows[1]);
          shown.Mass = nullptr;
          shown.Glyph = nullptr;
          other.Glyph = nullptr;
        }
        windows[first] = nullptr;
        windows[1 - first]->Render();
        if (shown.Mass)
        {
          CheckRuns(what, shown.Mass, part);
        }
        windows[1 - first]->Render();
        windows[1 - first] = nullptr;
        if (shown.Mass)
        {
          CheckRuns(what, shown.Mass, part);
        }
      }
    }
  }
  CheckNothingLives("windows");
}

/// The context ends, or is another one, while the model is resident in it.
void CheckContexts(const Expected& part)
{
  {
    vtkSmartPointer<vtkRenderWindow> windows[2] = { NewCycleWindow(part), NewCycleWindow(part) };
    CycleScene scene(part, nullptr);
    scene.Show(windows[0]);
    windows[0]->Render();
    scene.Mass->GetComputeContext()->Stop();
    CheckRuns("stopped", scene.Mass, part);
    scene.Mass->SetRenderWindow(windows[0]);
    CheckRuns("in the window", scene.Mass, part);
    CheckEqual("source", "window", scene.Mass->GetComputeContext()->GetSourceName());
    windows[0]->Finalize();
    CheckRuns("finalized", scene.Mass, part);
    windows[0]->Render();
    scene.Mass->SetRenderWindow(windows[1]);
    CheckRuns("in the second window", scene.Mass, part);
    windows[0] = nullptr;
    CheckRuns("the first is gone", scene.Mass, part);
    windows[1]->WindowRemap();
    CheckRuns("remapped", scene.Mass, part);
    windows[1] = nullptr;
    CheckRuns("the second is gone", scene.Mass, part);
    // The context lives longer than the filter.
    const vtkSmartPointer<vtkComputeContext> context = scene.Mass->GetComputeContext();
    scene.Mass = nullptr;
    scene.Glyph = nullptr;
    CheckEqual("the context without its filter", vtkComputeContext::READY, context->GetStatus());
  }
  CheckNothingLives("contexts");
}

/// All there is, for the end of the program to find.
struct Everything
{
  vtkSmartPointer<vtkRenderWindow> Window;
  std::unique_ptr<CycleScene> Own;
  std::unique_ptr<CycleScene> Shared;
};

Everything& GetEverything()
{
  static Everything everything;
  return everything;
}

int Exit(const Expected& part, bool inRender)
{
  Everything& all = GetEverything();
  all.Window = NewCycleWindow(part);
  all.Own.reset(new CycleScene(part, nullptr));
  all.Shared.reset(new CycleScene(part, all.Window));
  all.Own->Show(all.Window);
  all.Shared->Show(all.Window);
  all.Window->Render();
  CheckRuns("own", all.Own->Mass, part);
  CheckRuns("shared", all.Shared->Mass, part);
  if (inRender)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback([](vtkObject*, unsigned long, void*, void*) { std::exit(Finish()); });
    all.Shared->Mass->AddObserver(vtkCommand::ProgressEvent, command);
    all.Shared->Mass->SetRelativeTolerance(1e-7);
    all.Window->Render();
    CheckTrue("the program should have ended", false);
  }
  return Finish();
}
}

int TestClosingOrders(int argc, char* argv[])
{
  RequireUsage(argc == 3, "TestClosingOrders own|shared|windows|contexts|exit|exit-in-render FOLDER");
  const std::string mode = argv[1];
  const Expected part = Manifest(argv[2]).GetSolid("slanted_hole", "moved")[0];
  if (mode == "exit" || mode == "exit-in-render")
  {
    return Exit(part, mode != "exit");
  }
  vtkNew<vtkStringOutputWindow> complaints;
  vtkOutputWindow::SetInstance(complaints);
  if (mode == "windows")
  {
    CheckWindows(part);
  }
  else if (mode == "contexts")
  {
    CheckContexts(part);
  }
  else
  {
    CheckOrders(part, mode == "shared");
  }
  CheckEqual("VTK's complaints", "", complaints->GetOutput());
  vtkOutputWindow::SetInstance(nullptr);
  return Finish();
}
