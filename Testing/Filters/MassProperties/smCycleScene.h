/**
 * @file smCycleScene.h
 * @brief Reader, deformation, mass filter and their actors, as a user of the library joins them; to be made
 * and ended in any order
 */
#ifndef smCycleScene_h
#define smCycleScene_h

#include "smTestManifest.h"
#include "smTestPipeline.h"
#include "smVTKCompatibility.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNURBSDeform.h>
#include <vtkNURBSPointEvaluatorGPU.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkSmartPointer.h>

namespace smtest
{
/// A window that is not shown, 200 x 150.
inline vtkSmartPointer<vtkRenderWindow> NewCycleWindow(const Expected& part)
{
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetShowWindow(false);
  window->SetUseOffScreenBuffers(true);
  window->SetMultiSamples(0);
  window->SetSize(200, 150);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.2, 0.3, 0.4);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(part.Center.data());
  camera->SetPosition(
    part.Center[0] + part.Size, part.Center[1] + 1.5 * part.Size, part.Center[2] + part.Size);
  camera->SetViewUp(0, 0, 1);
  camera->SetClippingRange(0.1 * part.Size, 10 * part.Size);
  window->AddRenderer(renderer);
  return window;
}

inline vtkRenderer* GetRenderer(vtkRenderWindow* window)
{
  return window->GetRenderers()->GetFirstRenderer();
}

/// The pipeline and the props of a window. Its members may be reset one by one.
struct CycleScene
{
  vtkSmartPointer<vtkSTEPReader> Reader = vtkSmartPointer<vtkSTEPReader>::New();
  vtkSmartPointer<vtkNURBSDeform> Deform = vtkSmartPointer<vtkNURBSDeform>::New();
  vtkSmartPointer<vtkNURBSPointEvaluatorGPU> Points = vtkSmartPointer<vtkNURBSPointEvaluatorGPU>::New();
  vtkSmartPointer<vtkMassPropertiesGPU> Mass = vtkSmartPointer<vtkMassPropertiesGPU>::New();
  vtkSmartPointer<vtkActor> Part = vtkSmartPointer<vtkActor>::New();
  vtkSmartPointer<vtkActor> Glyph = vtkSmartPointer<vtkActor>::New();

  /// `window` is where the filters compute: null for contexts of their own.
  CycleScene(const Expected& part, vtkRenderWindow* window)
  {
    this->Reader->SetFileName(part.Path.c_str());
    this->Deform->SetInputConnection(this->Reader->GetOutputPort());
    this->Deform->SetPointEvaluator(this->Points);
    this->Move(0.02 * part.Size);
    this->Mass->SetInputConnection(this->Deform->GetOutputPort());
    this->Mass->SetGlyphScale(0.1);
    this->Mass->SetBackend(vtkMassPropertiesGPU::OPENGL);
    this->Points->SetRenderWindow(window);
    this->Mass->SetRenderWindow(window);
    vtkNew<sm::CompositeMapper> partMapper;
    partMapper->SetInputConnection(this->Deform->GetOutputPort());
    this->Part->SetMapper(partMapper);
    this->Part->GetProperty()->SetOpacity(0.5);
    vtkNew<vtkPolyDataMapper> glyphMapper;
    glyphMapper->SetInputConnection(this->Mass->GetOutputPort());
    this->Glyph->SetMapper(glyphMapper);
  }

  /// Moves all control points by the same distance along x: new faces, with the same volume.
  void Move(double distance) { this->Deform->SetDisplacement(distance, 0.0, 0.0); }

  void Show(vtkRenderWindow* window)
  {
    GetRenderer(window)->AddActor(this->Glyph);
    GetRenderer(window)->AddActor(this->Part);
  }
  void Hide(vtkRenderWindow* window)
  {
    GetRenderer(window)->RemoveActor(this->Glyph);
    GetRenderer(window)->RemoveActor(this->Part);
  }
};
}

#endif
