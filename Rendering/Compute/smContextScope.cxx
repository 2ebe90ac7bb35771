#include "smContextScope.h"

#include "Detail/smCurrentContext.h"
#include "Detail/smOpenGL.h"
#include "smContextResources.h"
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
    glGetIntegerv(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, &count);
    this->Count = std::min(count, IndexedBindings);
    glGetIntegerv(GL_CURRENT_PROGRAM, &this->Program);
    for (int i = 0; i < GenericCount; ++i)
    {
      glGetIntegerv(GenericQueries[i], &this->Generic[i]);
    }
    for (int i = 0; i < this->Count; ++i)
    {
      const GLuint index = static_cast<GLuint>(i);
      glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, index, &this->Buffer[i]);
      glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, index, &this->Offset[i]);
      glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_SIZE, index, &this->Bytes[i]);
    }
  }

  /// Returns the name of a buffer, or 0 if it was deleted inside the scope: binding a deleted name is a GL
  /// error.
  static GLuint Living(GLint buffer)
  {
    const GLuint name = static_cast<GLuint>(buffer);
    return name != 0 && glIsBuffer(name) ? name : 0;
  }

  void Restore() const
  {
    for (int i = 0; i < this->Count; ++i)
    {
      const GLuint index = static_cast<GLuint>(i);
      const GLuint name = Living(this->Buffer[i]);
      if (name != 0 && this->Bytes[i] > 0)
      {
        glBindBufferRange(GL_SHADER_STORAGE_BUFFER, index, name, static_cast<GLintptr>(this->Offset[i]),
          static_cast<GLsizeiptr>(this->Bytes[i]));
      }
      else
      {
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, index, name);
      }
    }
    // Restored after the indexed bindings, because these change the generic one, too.
    for (int i = 0; i < GenericCount; ++i)
    {
      glBindBuffer(GenericTargets[i], Living(this->Generic[i]));
    }
    const GLuint program = static_cast<GLuint>(this->Program);
    glUseProgram(program != 0 && glIsProgram(program) ? program : 0);
  }
};
}

namespace sm
{
struct ContextScope::State
{
  CurrentContext Previous;
  std::shared_ptr<ContextResources> Resources;
  std::shared_ptr<WindowResources> Window;
  std::uint64_t Generation = 0;
  bool WasCurrent = false;
  vtkSmartPointer<vtkShaderProgram> Shader;
  Bindings Saved;

  void Leave();
};

ContextScope::ContextScope(vtkComputeContext* context)
{
  vtkOpenGLRenderWindow* window = context ? context->GetRenderWindow() : nullptr;
  if (!window)
  {
    return;
  }
  auto state = std::make_unique<State>();
  state->WasCurrent = window->IsCurrent();
  if (!state->WasCurrent && !MakeWindowCurrent(window))
  {
    state->Previous.Restore();
    return;
  }
  state->Resources = context->GetResources();
  state->Generation = state->Resources->Generation;
  state->Saved.Save();
  state->Shader = window->GetShaderCache()->GetLastShaderBound();
  window->GetShaderCache()->ReleaseCurrentShader();
  state->Window = state->Resources->Window;
  ++state->Window->ScopeDepth;
  ++GetOpenScopes();
  this->Saved = std::move(state);
}

ContextScope::~ContextScope()
{
  if (this->Saved)
  {
    this->Saved->Leave();
  }
}

void ContextScope::State::Leave()
{
  --this->Window->ScopeDepth;
  --GetOpenScopes();
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
  if (MakeWindowCurrent(window))
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
    this->Saved.Restore();
  }
  this->Previous.Restore();
}

ContextScope::operator bool() const
{
  return this->Saved != nullptr;
}

bool ContextScope::IsInside(vtkComputeContext* context)
{
  vtkOpenGLRenderWindow* window = context ? context->GetRenderWindow() : nullptr;
  return window && context->GetResources()->Window->ScopeDepth > 0 && window->IsCurrent();
}
}
