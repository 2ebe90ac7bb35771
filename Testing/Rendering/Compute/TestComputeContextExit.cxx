// The process exits while a context, with a program and a buffer in it, lives on in a static object, as
// ParaView's filters do after Python's sys.exit(): the driver may have ended when these are destroyed. The
// context is stopped by then, nothing crashes, and the exit status is the program's. First argument: display
// or headless; "own" or "window" says whose context it is.
#include "smComputeTesting.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <memory>

namespace
{
struct Things
{
  explicit Things(vtkComputeContext* context)
    : Buffer(context)
  {
  }
  sm::ComputeProgram Program;
  sm::ComputeBuffer Buffer;
};

vtkSmartPointer<vtkRenderWindow> Window;
vtkSmartPointer<vtkComputeContext> Context;
std::unique_ptr<Things> Made;

/// The first static to be destroyed.
struct Witness
{
  ~Witness()
  {
    if (Context && Context->GetStatus() != vtkComputeContext::NOT_STARTED)
    {
      std::printf("FAIL the context is %s when statics end\n", Context->GetStatusAsString());
      std::fflush(stdout);
      std::_Exit(1);
    }
  }
} TheWitness;
}

int TestComputeContextExit(int argc, char* argv[])
{
  smtest::RequireUsage(argc >= 3, "TestComputeContextExit display|headless own|window");
  const std::string source = argv[2];
  Context = vtkSmartPointer<vtkComputeContext>::New();
  if (source == "window")
  {
    Window = vtkSmartPointer<vtkRenderWindow>::New();
    Window->SetShowWindow(false);
    Window->SetUseOffScreenBuffers(true);
    Window->AddRenderer(vtkNew<vtkRenderer>());
    Window->Render();
    Context->SetWindow(Window);
  }
  smtest::CheckEqual("status", vtkComputeContext::READY, Context->Start());
  smtest::CheckEqual("source",
    source == "window"                    ? "window"
      : argv[1] == std::string("display") ? "x"
                                          : "egl",
    Context->GetSourceName());
  Made = std::make_unique<Things>(Context);
  smtest::CheckTrue("program builds", smtest::BuildIndexProgram(Context, Made->Program, 64));
  smtest::CheckTrue("buffer fills", Made->Buffer.Upload(std::vector<double>(100, 1.0)));
  std::exit(smtest::Finish());
}
