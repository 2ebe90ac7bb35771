// Reader, filter, actors and window in one pipeline and one OpenGL context;
// run with --help for its arguments.
#include <smFormat.h>
#include <smVTKCompatibility.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkComputeContext.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkMassPropertiesGPU.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSTEPReader.h>
#include <vtkSmartPointer.h>
#include <vtkWindowToImageFilter.h>

#include <cmath>
#include <iostream>
#include <string>

namespace
{
const char* const Help = R"(usage: MassPropertiesPipeline FILE.step [OUT.png]
Shows a part translucent around its centre of mass and prints its volume with the bound of its error.

  FILE.step            on the display; the left button rotates the part
  FILE.step OUT.png    as a PNG file, drawn off screen without a display

Exit status: 0 status ok; 1 wrong usage, no display, or the picture cannot be written; 2 nothing to show;
3 the result is flagged.
)";

const int NothingToShow = 2;

void PrintMessages(vtkSTEPReader* reader)
{
  for (int i = 0; i < reader->GetNumberOfMessages(); ++i)
  {
    std::cerr << reader->GetMessage(i) << "\n";
  }
  std::cerr << "There is nothing to show.\n";
}

/// Builds the pipeline of `fileName` in `window`, runs it by rendering, and prints the results. Returns the
/// exit status.
int Show(const char* fileName, vtkRenderWindow* window)
{
  // [twenty lines]
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(fileName);
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetInputConnection(reader->GetOutputPort());
  mass->SetRenderWindow(window); // integrate in the context that draws

  vtkNew<sm::CompositeMapper> partMapper; // smVTKCompatibility.h
  partMapper->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkActor> part;
  part->SetMapper(partMapper);
  part->GetProperty()->SetOpacity(0.4);
  vtkNew<vtkPolyDataMapper> centerMapper; // a green sphere at the centre of mass, and the principal axes
  centerMapper->SetInputConnection(mass->GetOutputPort());
  vtkNew<vtkActor> center;
  center->SetMapper(centerMapper);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(part);
  renderer->AddActor(center);
  window->AddRenderer(renderer);
  window->Render(); // runs reader, filter and drawing
  // [twenty lines]
  if (reader->GetStatus() != vtkSTEPReader::OK)
  {
    PrintMessages(reader);
    return NothingToShow;
  }
  if (std::isfinite(mass->GetVolume())) // a surface has none
  {
    const std::string unit = reader->GetLengthUnit() + "^3";
    std::cout << "volume " << sm::FormatWithBound(mass->GetVolume(), mass->GetVolumeBound(), unit) << "\n";
  }

  renderer->SetBackground(0.92, 0.94, 0.97);
  renderer->GetActiveCamera()->SetPosition(-1.0, -1.7, 1.1);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->ResetCamera();
  window->Render();
  std::cout << "status " << mass->GetStatus() << ", " << mass->GetBackendName() << " on "
            << mass->GetRenderer() << std::endl;
  return mass->GetStatus() == "ok" ? 0 : 3;
}

int ShowOnDisplay(const char* fileName)
{
  {
    // vtkRenderWindow ends the program when the display does not answer; a context returns a status.
    vtkNew<vtkComputeContext> probe;
    probe->SetSource(vtkComputeContext::X);
    if (probe->Start() != vtkComputeContext::READY)
    {
      std::cerr << "There is no display to draw on: " << probe->GetReason()
                << "\nName a picture to write as second argument.\n";
      return 1;
    }
  }
  vtkNew<vtkRenderWindow> window;
  window->SetSize(900, 700);
  window->SetWindowName("SolidMoments");
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor->SetInteractorStyle(style);
  const int status = Show(fileName, window);
  if (status != NothingToShow)
  {
    interactor->Start();
  }
  return status;
}

int DrawToFile(const char* fileName, const char* pictureName)
{
  vtkNew<vtkComputeContext> context; // its window needs a GPU or Mesa, but no display
  context->Start();
  vtkRenderWindow* window = context->GetRenderWindow();
  if (!window)
  {
    std::cerr << context->GetReason() << "\n";
    return 1;
  }
  window->SetSize(900, 700);
  const int status = Show(fileName, window);
  if (status == NothingToShow)
  {
    return status;
  }
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->SetFileName(pictureName);
  writer->Write();
  return writer->GetErrorCode() == 0 ? status : 1;
}
}

int main(int argc, char** argv)
{
  if (argc == 2 && (argv[1] == std::string("--help") || argv[1] == std::string("-h")))
  {
    std::cout << Help;
    return 0;
  }
  if ((argc != 2 && argc != 3) || argv[1][0] == '-' || argv[argc - 1][0] == '-')
  {
    std::cerr << Help;
    return 1;
  }
  return argc == 2 ? ShowOnDisplay(argv[1]) : DrawToFile(argv[1], argv[2]);
}
