#include "Detail/smWindowScope.h"

#include "Detail/smCurrentContext.h"
#include "smContextResources.h"
#include "smOpenGL.h"
#include "smWindowResources.h"
#include "vtkComputeContext.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace
{
/// The shaders use these.
constexpr int IndexedBindings = 8;

constexpr GLenum GenericTargets[] = { GL_SHADER_STORAGE_BUFFER, GL_UNIFORM_BUFFER, GL_COPY_READ_BUFFER,
  GL_COPY_WRITE_BUFFER, GL_DISPATCH_INDIRECT_BUFFER };
constexpr GLenum GenericQueries[] = { GL_SHADER_STORAGE_BUFFER_BINDING, GL_UNIFORM_BUFFER_BINDING,
  GL_COPY_READ_BUFFER_BINDING, GL_COPY_WRITE_BUFFER_BINDING, GL_DISPATCH_INDIRECT_BUFFER_BINDING };
constexpr int GenericCount = 5;

/// The state that compute code may change.
struct Bindings
{
  GLint Program = 0;
  GLint Generic[GenericCount] = {};
  GLint Buffer[IndexedBindings] = {};
  GLint64 Offset[IndexedBindings] = {};
  GLint64 Bytes[IndexedBindings] = {};
  int Count = 0;

  void Save()
  {
    GLint count = 0;
    sm::GL::GetIntegerv(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, &count);
    this->Count = std::min(count, IndexedBindings);
    sm::GL::GetIntegerv(GL_CURRENT_PROGRAM, &this->Program);
    for (int i = 0; i < GenericCount; ++i)
    {
      sm::GL::GetIntegerv(GenericQueries[i], &this->Generic[i]);
    }
    for (int i = 0; i < this->Count; ++i)
    {
      const GLuint index = static_cast<GLuint>(i);
      sm::GL::GetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, index, &this->Buffer[i]);
      sm::GL::GetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, index, &this->Offset[i]);
      sm::GL::GetInteger64i_v(GL_SHADER_STORAGE_BUFFER_SIZE, index, &this->Bytes[i]);
    }
  }

  /// Returns the name of a buffer, or 0 if it was deleted inside the scope: binding a deleted name is a GL
  /// error.
  static GLuint Living(GLint buffer)
  {
    const GLuint name = static_cast<GLuint>(buffer);
    return name != 0 && sm::GL::IsBuffer(name) ? name : 0;
  }

  void Restore() const
  {
    for (int i = 0; i < this->Count; ++i)
    {
      const GLuint index = static_cast<GLuint>(i);
      const GLuint name = Living(this->Buffer[i]);
      if (name != 0 && this->Bytes[i] > 0)
      {
        sm::GL::BindBufferRange(GL_SHADER_STORAGE_BUFFER, index, name, static_cast<GLintptr>(this->Offset[i]),
          static_cast<GLsizeiptr>(this->Bytes[i]));
      }
      else
      {
        sm::GL::BindBufferBase(GL_SHADER_STORAGE_BUFFER, index, name);
      }
    }
    // Restored after the indexed bindings, because these change the generic one, too.
    for (int i = 0; i < GenericCount; ++i)
    {
      sm::GL::BindBuffer(GenericTargets[i], Living(this->Generic[i]));
    }
    const GLuint program = static_cast<GLuint>(this->Program);
    sm::GL::UseProgram(program != 0 && sm::GL::IsProgram(program) ? program : 0);
  }
};

class SavedScope : public sm::WindowScope
{
public:
  ~SavedScope() override;
  /// Enters the scope; returns false, and changes nothing, if the window cannot be made current.
  bool Enter(vtkComputeContext* context, vtkOpenGLRenderWindow* window);

private:
  sm::CurrentContext Previous;
  std::shared_ptr<sm::ContextResources> Resources;
  std::shared_ptr<sm::WindowResources> Window;
  std::uint64_t Generation = 0;
  bool WasCurrent = false;
  vtkSmartPointer<vtkShaderProgram> Shader;
  bool HasSaved = false;
  Bindings Saved;
};

bool SavedScope::Enter(vtkComputeContext* context, vtkOpenGLRenderWindow* window)
{
  this->WasCurrent = window->IsCurrent();
  if (!this->WasCurrent && !sm::MakeWindowCurrent(window))
  {
    this->Previous.Restore();
    return false;
  }
  this->Resources = context->GetResources();
  this->Generation = this->Resources->Generation;
  const bool isInside = this->Resources->Window->ScopeDepth > 0;
  if (!isInside)
  {
    // Errors of other code; inside a scope all are ours.
    sm::GL::DrainErrors();
  }
  // What renders with a window of ours, such as an example, relies on no binding between its calls.
  this->HasSaved = isInside || !this->Resources->Window->IsOwn;
  if (this->HasSaved)
  {
    this->Saved.Save();
  }
  this->Shader = window->GetShaderCache()->GetLastShaderBound();
  window->GetShaderCache()->ReleaseCurrentShader();
  this->Window = this->Resources->Window;
  ++this->Window->ScopeDepth;
  ++sm::GetOpenScopes();
  return true;
}

SavedScope::~SavedScope()
{
  if (!this->Window)
  {
    return;
  }
  --this->Window->ScopeDepth;
  --sm::GetOpenScopes();
  vtkComputeContext* context = this->Resources->Context;
  if (!context || this->Resources->Generation != this->Generation)
  {
    // Our context ended inside the scope. If it was also the previous context, there is none to restore.
    if (!this->WasCurrent)
    {
      this->Previous.Restore();
    }
    return;
  }
  vtkOpenGLRenderWindow* window = context->GetRenderWindow();
  if (sm::MakeWindowCurrent(window))
  {
    if (this->Shader)
    {
      // VTK's shader cache must have its program as the current one again, because code in the middle of a
      // draw relies on it.
      window->GetShaderCache()->ReadyShaderProgram(this->Shader);
    }
    else
    {
      window->GetShaderCache()->ReleaseCurrentShader();
    }
    if (this->HasSaved)
    {
      this->Saved.Restore();
    }
  }
  this->Previous.Restore();
}
}

namespace sm
{
std::unique_ptr<WindowScope> EnterWindowScope(vtkComputeContext* context)
{
  vtkOpenGLRenderWindow* window = context->GetRenderWindow();
  auto scope = window ? std::make_unique<SavedScope>() : nullptr;
  return scope && scope->Enter(context, window) ? std::move(scope) : nullptr;
}
}
