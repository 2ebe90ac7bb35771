// How vtkComputeContext finds a context, or says why there is none. The case is the first argument:
//   display      an X display with GL 4.3
//   headless     no DISPLAY, but EGL
//   nothing      neither display nor EGL driver
//   no-compute   the environment limits Mesa to OpenGL 3.3
//   no-doubles   the environment takes Mesa's double precision away
#include "smComputeTesting.h"

#include "vtkEGLSurfacelessRenderWindow.h"
#include "vtkRenderWindow.h"
#include "vtkXOpenGLRenderWindow.h"

using namespace smtest;

namespace
{
void CheckReady(int source, const std::string& name)
{
  vtkNew<vtkComputeContext> context;
  CheckEqual("status before", vtkComputeContext::NOT_STARTED, context->GetStatus());
  CheckEqual("generation before", 0, static_cast<long long>(context->GetGeneration()));
  CheckTrue("no window before", context->GetRenderWindow() == nullptr);
  context->SetSource(source);
  const int status = context->Start();
  if (!CheckEqual("status", vtkComputeContext::READY, status))
  {
    std::printf("%s\n", context->GetReason().c_str());
    return;
  }
  CheckEqual("status as a string", "ready", context->GetStatusAsString());
  CheckEqual("source", name, context->GetSourceName());
  CheckEqual("reason", "", context->GetReason());
  CheckTrue("renderer", !context->GetRenderer().empty(), context->GetRenderer());
  CheckTrue("version", !context->GetVersionString().empty(), context->GetVersionString());
  // The minimum that OpenGL 4.3 guarantees.
  CheckTrue("block size", context->GetMaximumStorageBlockSize() >= 1 << 24);
  CheckTrue("groups", context->GetMaximumWorkGroupCount() >= 65535);
  CheckTrue("not current outside a scope", !context->GetRenderWindow()->IsCurrent());
  CheckEqual("the probe is not counted", 0, static_cast<long long>(context->GetNumberOfDispatches()));

  const auto generation = context->GetGeneration();
  CheckTrue("generation", generation != 0);
  context->Start();
  CheckTrue("Start() again changes nothing", context->GetGeneration() == generation);
  CheckComputes("computes in " + name, context);
  CheckEqual("dispatches", 1, static_cast<long long>(context->GetNumberOfDispatches()));
  context->ResetCounters();
  CheckEqual("dispatches after reset", 0, static_cast<long long>(context->GetNumberOfDispatches()));

  context->Stop();
  CheckEqual("stopped", vtkComputeContext::NOT_STARTED, context->GetStatus());
  CheckTrue("no scope when stopped", !sm::ContextScope(context));
  context->Start();
  CheckTrue("a new generation", context->GetGeneration() != 0 && context->GetGeneration() != generation);
  CheckComputes("computes again", context);
}

void CheckFails(int source, int expected, const std::string& clue, vtkRenderWindow* window = nullptr)
{
  vtkNew<vtkComputeContext> context;
  context->SetSource(source);
  context->SetWindow(window);
  CheckEqual("status of source " + std::to_string(source), expected, context->Start());
  CheckTrue("reason", context->GetReason().find(clue) != std::string::npos, context->GetReason());
  CheckTrue("remedy", context->GetReason().find("Install or choose") != std::string::npos);
  CheckTrue("no scope", !sm::ContextScope(context));
  CheckTrue("no window", context->GetRenderWindow() == nullptr);
  sm::ComputeBuffer buffer(context);
  CheckTrue("no buffer", !buffer.Allocate(16) && !buffer.GetError().empty(), buffer.GetError());
  sm::ComputeProgram program;
  CheckTrue(
    "no program", !program.Build(context, "any", "") && !program.GetError().empty(), program.GetError());
}

void CheckLimited(int source)
{
  vtkNew<vtkComputeContext> context;
  context->SetSource(source);
  context->SetMaximumVersion(3, 3);
  CheckEqual("limited to 3.3", vtkComputeContext::NO_COMPUTE, context->Start());
  CheckTrue(
    "reason names 3.3", context->GetReason().find("OpenGL 3.3") != std::string::npos, context->GetReason());
  context->SetMaximumVersion(4, 3);
  CheckEqual("limited to 4.3", vtkComputeContext::READY, context->Start());
  context->SetMaximumVersion(0, 0);
  CheckEqual("a new limit stops", vtkComputeContext::NOT_STARTED, context->GetStatus());
  CheckEqual("no limit", vtkComputeContext::READY, context->Start());
}

void TestDisplay()
{
  CheckReady(vtkComputeContext::AUTOMATIC, "x");
  CheckReady(vtkComputeContext::X, "x");
  CheckReady(vtkComputeContext::EGL, "egl");
  CheckFails(vtkComputeContext::WINDOW, vtkComputeContext::NO_CONTEXT, "SetWindow");
  for (const int source : { vtkComputeContext::AUTOMATIC, vtkComputeContext::X, vtkComputeContext::EGL })
  {
    CheckLimited(source);
  }

  vtkNew<vtkRenderWindow> window;
  window->SetShowWindow(false);
  vtkNew<vtkComputeContext> context;
  context->SetWindow(window);
  CheckEqual("a window that was never opened", vtkComputeContext::READY, context->Start());
  CheckEqual("source", "window", context->GetSourceName());
  CheckTrue("the window's own context", context->GetRenderWindow() == window.Get());
  CheckTrue("Start() leaves it as it was", !window->IsCurrent());
  CheckComputes("computes in the window", context);
  context->SetSource(vtkComputeContext::EGL);
  CheckEqual("EGL next to it", vtkComputeContext::READY, context->Start());
  CheckEqual("source", "egl", context->GetSourceName());
}

void TestHeadless()
{
  CheckReady(vtkComputeContext::AUTOMATIC, "egl");
  CheckReady(vtkComputeContext::EGL, "egl");
  CheckFails(vtkComputeContext::X, vtkComputeContext::NO_CONTEXT, "no X display");
  CheckLimited(vtkComputeContext::EGL);
  CheckLimited(vtkComputeContext::AUTOMATIC);

  // VTK itself would abort here.
  vtkNew<vtkXOpenGLRenderWindow> window;
  CheckFails(vtkComputeContext::WINDOW, vtkComputeContext::NO_CONTEXT, "no X display", window);
  vtkNew<vtkComputeContext> context;
  context->SetWindow(window);
  CheckEqual("AUTOMATIC goes on to EGL", vtkComputeContext::READY, context->Start());
  CheckEqual("source", "egl", context->GetSourceName());

  vtkNew<vtkEGLSurfacelessRenderWindow> surfaceless;
  context->SetWindow(surfaceless);
  CheckEqual("given surfaceless window", vtkComputeContext::READY, context->Start());
  CheckEqual("source", "window", context->GetSourceName());
  CheckComputes("computes in the given surfaceless window", context);

  // A generic window whose owner makes nothing current.
  vtkNew<vtkGenericOpenGLRenderWindow> generic;
  CheckFails(vtkComputeContext::WINDOW, vtkComputeContext::NO_CONTEXT, "WindowMakeCurrentEvent", generic);
}

void TestNothing()
{
  CheckFails(vtkComputeContext::AUTOMATIC, vtkComputeContext::NO_CONTEXT, "EGL: ");
  CheckFails(vtkComputeContext::EGL, vtkComputeContext::NO_CONTEXT, "EGL: ");
  CheckFails(vtkComputeContext::X, vtkComputeContext::NO_CONTEXT, "no X display");
  CheckFails(vtkComputeContext::WINDOW, vtkComputeContext::NO_CONTEXT, "SetWindow");
}

void TestEnvironment(int status, const std::string& clue)
{
  for (const int source : { vtkComputeContext::AUTOMATIC, vtkComputeContext::X, vtkComputeContext::EGL })
  {
    CheckFails(source, status, clue);
  }
  vtkNew<vtkRenderWindow> window;
  window->SetShowWindow(false);
  CheckFails(vtkComputeContext::WINDOW, status, clue, window);
}
}

int TestComputeContext(int argc, char* argv[])
{
  const std::string which = argc > 1 ? argv[1] : "";
  {
    const Silence silence;
    if (which == "display")
    {
      TestDisplay();
    }
    else if (which == "headless")
    {
      TestHeadless();
    }
    else if (which == "nothing")
    {
      TestNothing();
    }
    else if (which == "no-compute")
    {
      TestEnvironment(vtkComputeContext::NO_COMPUTE, "MESA_GL_VERSION_OVERRIDE=3.3");
    }
    else if (which == "no-doubles")
    {
      TestEnvironment(vtkComputeContext::NO_DOUBLES, "no double precision");
    }
    else
    {
      CheckTrue("a case is given", false, which);
    }
  }
  CheckNothingLives();
  return Finish();
}
