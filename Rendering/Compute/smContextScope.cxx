#include "smContextScope.h"

#include "smContextResources.h"
#include "smOpenGLLibrary.h"
#include "smWindowResources.h"
#include "vtkComputeContext.h"

#include "vtkOpenGLRenderWindow.h"

namespace sm
{
ContextScope::ContextScope(vtkComputeContext* context)
{
  std::string reason;
  OpenGLLibrary* const library = context && context->GetRenderWindow() ? GetOpenGLLibrary(reason) : nullptr;
  this->Entered = library ? library->EnterScope(context) : nullptr;
}

ContextScope::~ContextScope() = default;

ContextScope::operator bool() const
{
  return this->Entered != nullptr;
}

bool ContextScope::IsInside(vtkComputeContext* context)
{
  vtkOpenGLRenderWindow* window = context ? context->GetRenderWindow() : nullptr;
  return window && context->GetResources()->Window->ScopeDepth > 0 && window->IsCurrent();
}
}
