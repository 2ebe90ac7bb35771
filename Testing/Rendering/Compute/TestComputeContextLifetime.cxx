// Windows end, contexts end, buffers and programs end, in every order; nothing is freed twice, nothing leaks
// and whatever was current before is current afterwards. First argument: display or headless.
#include "smComputeTesting.h"

#include "vtkEGLSurfacelessRenderWindow.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <memory>

using namespace smtest;

namespace
{
bool HasDisplay = false;

vtkSmartPointer<vtkRenderWindow> NewWindow()
{
  vtkSmartPointer<vtkRenderWindow> window;
  if (HasDisplay)
  {
    window = vtkSmartPointer<vtkRenderWindow>::New();
    window->SetShowWindow(false);
    window->SetUseOffScreenBuffers(true);
  }
  else
  {
    window = vtkSmartPointer<vtkEGLSurfacelessRenderWindow>::New();
  }
  window->SetSize(64, 64);
  window->AddRenderer(vtkNew<vtkRenderer>());
  return window;
}

/// A program and a buffer with something in it.
struct Things
{
  explicit Things(vtkComputeContext* context)
    : Buffer(context)
  {
    CheckTrue("program builds", BuildIndexProgram(context, this->Program, 64));
    CheckTrue("buffer fills", this->Buffer.Upload(std::vector<double>(100, 1.0)), this->Buffer.GetError());
    CheckAlive(true);
  }
  void CheckAlive(bool alive) const
  {
    CheckTrue(alive ? "program lives" : "program is gone", this->Program.IsBuilt() == alive);
    CheckTrue(alive ? "buffer lives" : "buffer is lost", this->Buffer.IsLost() != alive);
    CheckEqual("size", alive ? 800 : 0, static_cast<long long>(this->Buffer.GetSize()));
  }
  sm::ComputeProgram Program;
  sm::ComputeBuffer Buffer;
};

void CheckLost(vtkComputeContext* context, Things& things)
{
  CheckEqual("lost", vtkComputeContext::LOST, context->GetStatus());
  CheckEqual("generation", 0, static_cast<long long>(context->GetGeneration()));
  CheckTrue("no window", context->GetRenderWindow() == nullptr);
  CheckTrue("reason", !context->GetReason().empty(), context->GetReason());
  things.CheckAlive(false);
  CheckNothingLives();
  double value = 0.0;
  CheckTrue("nothing can be read", !things.Buffer.Read(&value, sizeof(value)));
}

void TestFinalize()
{
  std::printf("-- finalized\n");
  const vtkSmartPointer<vtkRenderWindow> window = NewWindow();
  vtkNew<vtkComputeContext> context;
  context->SetSource(vtkComputeContext::WINDOW);
  context->SetWindow(window);
  CheckEqual("start", vtkComputeContext::READY, context->Start());
  window->Render();
  Things things(context);
  const auto generation = context->GetGeneration();
  window->Finalize();
  CheckLost(context, things);

  CheckEqual("a closed window is not opened", vtkComputeContext::NO_CONTEXT, context->Start());
  CheckTrue("reason", context->GetReason().find("closed") != std::string::npos, context->GetReason());
  CheckTrue("buffer fails", !things.Buffer.Allocate(10), things.Buffer.GetError());
  context->SetSource(vtkComputeContext::AUTOMATIC);
  CheckEqual("an own context instead", vtkComputeContext::READY, context->Start());
  CheckEqual("source", HasDisplay ? "x" : "egl", context->GetSourceName());
  CheckComputes("computes", context);
  context->SetSource(vtkComputeContext::WINDOW);
  window->Render();
  CheckEqual("rendering opens it", vtkComputeContext::READY, context->Start());
  CheckTrue("generation", context->GetGeneration() > generation);
  CheckTrue(
    "the buffer is used again", things.Buffer.Upload(std::vector<double>(3, 2.0)), things.Buffer.GetError());
  CheckTrue("the program too", BuildIndexProgram(context, things.Program, 64));
  CheckComputes("computes", context);
  things.Buffer.Free();
  things.Program.Free();
  CheckNothingLives();
}

void TestFinalizeBefore()
{
  std::printf("-- finalized before the start\n");
  const vtkSmartPointer<vtkRenderWindow> window = NewWindow();
  window->Render();
  window->Finalize();
  vtkNew<vtkComputeContext> context;
  context->SetWindow(window);
  CheckEqual("start", vtkComputeContext::READY, context->Start());
  CheckEqual("source", "window", context->GetSourceName());
  CheckComputes("computes", context);
}

void TestRemap()
{
  std::printf("-- remapped\n");
  const vtkSmartPointer<vtkRenderWindow> window = NewWindow();
  window->Render();
  vtkNew<vtkComputeContext> context;
  context->SetSource(vtkComputeContext::WINDOW);
  context->SetWindow(window);
  CheckEqual("start", vtkComputeContext::READY, context->Start());
  Things things(context);
  window->WindowRemap();
  CheckLost(context, things);
  window->Render();
  CheckEqual("start again", vtkComputeContext::READY, context->Start());
  CheckComputes("computes", context);
}

void TestDelete()
{
  std::printf("-- window deleted\n");
  vtkSmartPointer<vtkRenderWindow> window = NewWindow();
  vtkNew<vtkComputeContext> context;
  context->SetWindow(window);
  CheckEqual("start", vtkComputeContext::READY, context->Start());
  CheckEqual("the window is not held", 1, window->GetReferenceCount());
  Things things(context);
  window = nullptr;
  CheckLost(context, things);
  CheckTrue("the window is gone", context->GetWindow() == nullptr);
  context->SetSource(vtkComputeContext::WINDOW);
  CheckEqual("no window", vtkComputeContext::NO_CONTEXT, context->Start());
  CheckTrue(
    "reason", context->GetReason().find("no longer exists") != std::string::npos, context->GetReason());
  context->SetSource(vtkComputeContext::AUTOMATIC);
  CheckEqual("an own context instead", vtkComputeContext::READY, context->Start());
  CheckComputes("computes", context);
}

void TestEndInsideScope()
{
  std::printf("-- ends inside a scope\n");
  for (const bool wasCurrent : { false, true })
  {
    for (const bool stop : { false, true })
    {
      const vtkSmartPointer<vtkRenderWindow> other = NewWindow();
      vtkSmartPointer<vtkRenderWindow> window = NewWindow();
      window->Render();
      other->Render();
      vtkNew<vtkComputeContext> context;
      context->SetWindow(window);
      CheckEqual("start", vtkComputeContext::READY, context->Start());
      (wasCurrent ? window : other)->MakeCurrent();
      {
        const sm::ContextScope scope(context);
        Things things(context);
        if (stop)
        {
          context->Stop();
        }
        else
        {
          window = nullptr;
        }
        things.CheckAlive(false);
      }
      CheckTrue("the other is current again", wasCurrent || other->IsCurrent());
      CheckNothingLives();
      other->Render();
    }
  }
}

void TestContextEndsFirst()
{
  std::printf("-- context ends first\n");
  const vtkSmartPointer<vtkRenderWindow> window = NewWindow();
  window->Render();
  std::unique_ptr<Things> given;
  std::unique_ptr<Things> own;
  {
    vtkNew<vtkComputeContext> context;
    context->SetWindow(window);
    CheckEqual("start", vtkComputeContext::READY, context->Start());
    given.reset(new Things(context));
    vtkNew<vtkComputeContext> other;
    CheckEqual("start", vtkComputeContext::READY, other->Start());
    own.reset(new Things(other));
    window->MakeCurrent();
  }
  CheckNothingLives();
  CheckTrue("the window is still current", window->IsCurrent());
  given->CheckAlive(false);
  own->CheckAlive(false);
  CheckTrue("no upload", !own->Buffer.Upload(std::vector<double>(1000)), own->Buffer.GetError());
  given.reset();
  own.reset();
  window->Render();
}

void TestOwnWindowLeftCurrent()
{
  std::printf("-- own window left current\n");
  vtkNew<vtkComputeContext> context;
  CheckEqual("start", vtkComputeContext::READY, context->Start());
  context->GetRenderWindow()->MakeCurrent();
  {
    const sm::ContextScope scope(context);
    CheckTrue("scope", static_cast<bool>(scope));
    context->Stop();
  }
  CheckEqual("start again", vtkComputeContext::READY, context->Start());
  context->GetRenderWindow()->MakeCurrent();
  context->SetSource(vtkComputeContext::EGL);
  CheckEqual("start with EGL", vtkComputeContext::READY, context->Start());
  context->GetRenderWindow()->MakeCurrent();
}

/// Runs scopes of `context` while `window` is current or nothing is.
void CheckRestores(vtkRenderWindow* window, vtkComputeContext* context)
{
  window->MakeCurrent();
  CheckTrue("current before", window->IsCurrent());
  {
    const sm::ContextScope scope(context);
    CheckTrue("inside", scope && sm::ContextScope::IsInside(context));
    {
      const sm::ContextScope nested(context);
      CheckTrue("nested", static_cast<bool>(nested));
    }
    CheckTrue("still inside", sm::ContextScope::IsInside(context));
    CheckComputes("computes", context);
  }
  CheckTrue("outside", !sm::ContextScope::IsInside(context));
  CheckTrue("current after", window->IsCurrent());
  window->ReleaseCurrent();
  {
    const sm::ContextScope scope(context);
    CheckTrue("inside", static_cast<bool>(scope));
  }
  CheckTrue("none after", !window->IsCurrent() && !context->GetRenderWindow()->IsCurrent());
}

void TestPreviousContext()
{
  std::printf("-- previous context\n");
  const vtkSmartPointer<vtkRenderWindow> given = NewWindow();
  const vtkSmartPointer<vtkRenderWindow> other = NewWindow();
  vtkNew<vtkEGLSurfacelessRenderWindow> surfaceless;
  other->Render();
  surfaceless->AddRenderer(vtkNew<vtkRenderer>());
  surfaceless->Render();
  vtkNew<vtkComputeContext> first;
  first->SetWindow(given);
  vtkNew<vtkComputeContext> second;
  second->SetSource(HasDisplay ? vtkComputeContext::X : vtkComputeContext::EGL);
  vtkNew<vtkComputeContext> third;
  third->SetSource(vtkComputeContext::EGL);
  for (vtkComputeContext* context : { first.Get(), second.Get(), third.Get() })
  {
    CheckEqual("start", vtkComputeContext::READY, context->Start());
    surfaceless->ReleaseCurrent();
    CheckRestores(other, context);
    CheckRestores(surfaceless, context);
  }

  // Scopes of different kinds nest, and a buffer of the outer one can be used in the inner one.
  sm::ComputeBuffer outer(first);
  other->MakeCurrent();
  {
    const sm::ContextScope scope(first);
    CheckTrue("upload", outer.Upload(std::vector<double>(2, 3.0)));
    {
      const sm::ContextScope inner(third);
      CheckTrue("in the inner scope", inner && !sm::ContextScope::IsInside(first));
      double read[2] = { 0.0, 0.0 };
      CheckTrue(
        "read in the inner scope", outer.Read(read, sizeof(read)) && read[1] == 3.0, outer.GetError());
      CheckTrue("back in the inner scope", sm::ContextScope::IsInside(third));
    }
    CheckTrue("back in the outer scope", sm::ContextScope::IsInside(first));
  }
  CheckTrue("current after", other->IsCurrent());
}

void TestManyContexts()
{
  std::printf("-- many contexts\n");
  for (int i = 0; i < 20; ++i)
  {
    vtkNew<vtkComputeContext> context;
    context->SetSource(i % 2 == 0 ? vtkComputeContext::AUTOMATIC : vtkComputeContext::EGL);
    std::string detail;
    const bool computed = context->Start() == vtkComputeContext::READY && Compute(context, 100, 64, detail);
    CheckTrue("context " + std::to_string(i), computed, detail);
  }
}
}

int TestComputeContextLifetime(int argc, char* argv[])
{
  HasDisplay = argc > 1 && std::string(argv[1]) == "display";
  {
    const Silence silence;
    TestFinalize();
    TestFinalizeBefore();
    if (HasDisplay)
    {
      TestRemap();
    }
    TestDelete();
    TestEndInsideScope();
    TestContextEndsFirst();
    TestOwnWindowLeftCurrent();
    TestPreviousContext();
    TestManyContexts();
  }
  CheckNothingLives();
  return Finish();
}
