#include "Detail/smContextSearch.h"
#include "Detail/smWindowScope.h"
#include "smOnDemandLibrary.h"
#include "smOpenGLLibrary.h"
#include "smRenderingOpenGLModule.h"
#include "vtkEGLSurfacelessRenderWindow.h"

namespace
{
class Library : public sm::OpenGLLibrary
{
public:
  bool MayHaveGPU() override { return vtkEGLSurfacelessRenderWindow::MayHaveGPU(); }
  std::unique_ptr<sm::WindowSource> NewSource(sm::ContextState& state) override
  {
    return std::make_unique<sm::ContextSearch>(state);
  }
  std::unique_ptr<sm::WindowScope> EnterScope(vtkComputeContext* context) override
  {
    return sm::EnterWindowScope(context);
  }
};
}

// The module Rendering/Compute looks for it by sm::OpenGLEntryName.
extern "C" SMRENDERINGOPENGL_EXPORT sm::LibraryEntry smGetOpenGLEntry()
{
  static sm::OpenGLLibrary* library = new Library; // outlives all statics
  return { SM_OPENGL_LIBRARY_VERSION, library };
}
