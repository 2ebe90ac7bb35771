// A filter that computes in the middle of a window's Render() leaves the image as it is, whatever context it
// computes in; and a scene is rendered with no display. Arguments: display or headless, folder for pictures.
#include "smComputeTesting.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkEGLSurfacelessRenderWindow.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

using namespace smtest;

namespace
{
/// Passes its input on and computes on the way.
class ComputingFilter : public vtkPolyDataAlgorithm
{
public:
  static ComputingFilter* New();
  vtkTypeMacro(ComputingFilter, vtkPolyDataAlgorithm);

  vtkSmartPointer<vtkComputeContext> Context;
  int Computed = 0;
  std::string Detail;

protected:
  int RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override
  {
    vtkPolyData::GetData(output)->ShallowCopy(vtkPolyData::GetData(input[0]));
    if (this->Context && this->Context->Start() == vtkComputeContext::READY &&
      Compute(this->Context, 1000, 64, this->Detail))
    {
      ++this->Computed;
    }
    return 1;
  }
};
vtkStandardNewMacro(ComputingFilter);

struct Scene
{
  explicit Scene(bool display)
  {
    if (display)
    {
      this->Window = vtkSmartPointer<vtkRenderWindow>::New();
      this->Window->SetShowWindow(false);
      this->Window->SetUseOffScreenBuffers(true);
    }
    else
    {
      this->Window = vtkSmartPointer<vtkEGLSurfacelessRenderWindow>::New();
    }
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(300, 300);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetBackground(0.1, 0.2, 0.4);
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(32);
    sphere->SetPhiResolution(32);
    this->Filter->SetInputConnection(sphere->GetOutputPort());
    this->Mapper->SetInputConnection(this->Filter->GetOutputPort());
    vtkNew<vtkActor> first;
    first->SetMapper(this->Mapper);
    first->GetProperty()->SetColor(0.9, 0.6, 0.2);
    first->SetPosition(-0.3, 0.0, 0.0);
    this->Renderer->AddActor(first);
    // Drawn after the computing one.
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    vtkNew<vtkActor> second;
    second->SetMapper(mapper);
    second->GetProperty()->SetEdgeVisibility(true);
    second->SetPosition(0.4, 0.0, 0.0);
    this->Renderer->AddActor(second);
    vtkNew<vtkTextActor> text;
    text->SetInput("SolidMoments");
    text->GetTextProperty()->SetFontSize(28);
    text->SetPosition(60, 10);
    this->Renderer->AddActor(text);
  }

  vtkSmartPointer<vtkImageData> Render()
  {
    this->Filter->Modified();
    this->Window->Render();
    vtkNew<vtkWindowToImageFilter> grab;
    grab->SetInput(this->Window);
    grab->ShouldRerenderOff();
    grab->Update();
    vtkSmartPointer<vtkImageData> image = vtkSmartPointer<vtkImageData>::New();
    image->DeepCopy(grab->GetOutput());
    return image;
  }

  // The window is destroyed before the other members, which must tolerate it.
  vtkNew<ComputingFilter> Filter;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
};

int GetMaximumDifference(vtkImageData* first, vtkImageData* second)
{
  auto a = vtkUnsignedCharArray::SafeDownCast(first->GetPointData()->GetScalars());
  auto b = vtkUnsignedCharArray::SafeDownCast(second->GetPointData()->GetScalars());
  if (!a || !b || a->GetNumberOfValues() != b->GetNumberOfValues() || a->GetNumberOfValues() == 0)
  {
    return 256;
  }
  int difference = 0;
  for (vtkIdType i = 0; i < a->GetNumberOfValues(); ++i)
  {
    difference = std::max(difference, std::abs(int(a->GetValue(i)) - int(b->GetValue(i))));
  }
  return difference;
}

void Write(vtkImageData* image, const std::string& file)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(file.c_str());
  writer->Write();
  std::printf("%s\n", file.c_str());
}

enum class Kind
{
  SameWindow,
  OwnContext,
  OwnEGL,
  OtherWindow
};

void CheckUnchanged(bool display, Kind kind, vtkImageData* reference, const std::string& folder)
{
  static const char* const names[] = { "same window", "own context", "own EGL context", "other window" };
  const std::string name = names[static_cast<int>(kind)];
  std::printf("-- %s\n", name.c_str());
  Scene other(display);
  Scene scene(display);
  vtkNew<vtkComputeContext> context;
  if (kind == Kind::OwnEGL)
  {
    context->SetSource(vtkComputeContext::EGL);
  }
  else if (kind != Kind::OwnContext)
  {
    context->SetWindow(kind == Kind::SameWindow ? scene.Window : other.Window);
  }
  // The context starts inside the first Render().
  scene.Filter->Context = context;
  for (int i = 1; i <= 3; ++i)
  {
    const vtkSmartPointer<vtkImageData> image = scene.Render();
    CheckEqual("computed inside Render()", i, scene.Filter->Computed);
    const int difference = GetMaximumDifference(reference, image);
    if (!CheckEqual("image " + std::to_string(i) + " differs by", 0, difference))
    {
      Write(image, folder + "/ComputeChanged.png");
    }
  }
  // An X window stays current after Render(), as always in VTK; the surfaceless one never does.
  CheckTrue("current after Render()", scene.Window->IsCurrent() == display);
  CheckEqual("reason", "", context->GetReason());

  // In the middle of a draw call's preparation, with VTK's shader bound.
  int calls = 0;
  struct Data
  {
    vtkComputeContext* Context;
    int* Calls;
  } data = { context, &calls };
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&data);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* client, void*)
    {
      std::string detail;
      Data& own = *static_cast<Data*>(client);
      *own.Calls += Compute(own.Context, 100, 64, detail) ? 1 : 0;
    });
  scene.Mapper->AddObserver(vtkCommand::UpdateShaderEvent, command);
  scene.Renderer->AddObserver(vtkCommand::StartEvent, command);
  scene.Renderer->AddObserver(vtkCommand::EndEvent, command);
  const vtkSmartPointer<vtkImageData> image = scene.Render();
  CheckTrue("computed while drawing", calls >= 3, std::to_string(calls) + " times");
  CheckEqual("image differs by", 0, GetMaximumDifference(reference, image));

  // Updated outside any Render().
  scene.Filter->Modified();
  scene.Filter->Update();
  CheckEqual("image differs by", 0, GetMaximumDifference(reference, scene.Render()));
}

/// How many pixels are not of the background's colour.
long CountDrawn(vtkImageData* image)
{
  auto values = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
  const int components = values->GetNumberOfComponents();
  long drawn = 0;
  for (vtkIdType i = 1; i < values->GetNumberOfTuples(); ++i)
  {
    drawn += std::memcmp(values->GetPointer(0), values->GetPointer(i * components), 3) != 0 ? 1 : 0;
  }
  return drawn;
}
}

int TestComputeContextRender(int argc, char* argv[])
{
  const bool display = argc > 1 && std::string(argv[1]) == "display";
  const std::string folder = argc > 2 ? argv[2] : ".";
  {
    const Silence silence;
    vtkSmartPointer<vtkImageData> reference;
    {
      Scene scene(display);
      reference = scene.Render();
      CheckEqual("rendering repeats", 0, GetMaximumDifference(reference, scene.Render()));
    }
    Write(reference, folder + (display ? "/ComputeDisplay.png" : "/ComputeHeadless.png"));
    // Two spheres and a line of text over 300 x 300 pixels.
    CheckRange("pixels drawn", 20000.0, static_cast<double>(CountDrawn(reference)), 70000.0);

    // EGL draws what the window draws, also while a window's context is current.
    Scene surfaceless(false);
    vtkSmartPointer<vtkImageData> image = surfaceless.Render();
    // One driver, two framebuffer configurations: equal except for rounding.
    CheckRange("EGL differs by", 0.0, GetMaximumDifference(reference, image), display ? 2.0 : 0.0);
    surfaceless.Window->SetSize(150, 100);
    image = surfaceless.Render();
    CheckEqual("resized width", 150, image->GetDimensions()[0]);
    surfaceless.Window->Finalize();
    surfaceless.Window->SetSize(300, 300);
    image = surfaceless.Render();
    CheckRange(
      "after Finalize() EGL differs by", 0.0, GetMaximumDifference(reference, image), display ? 2.0 : 0.0);

    for (const Kind kind : { Kind::SameWindow, Kind::OwnContext, Kind::OwnEGL, Kind::OtherWindow })
    {
      CheckUnchanged(display, kind, reference, folder);
    }
  }
  CheckNothingLives();
  return Finish();
}
