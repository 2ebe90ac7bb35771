#include "smComputeProgram.h"

#include "Detail/smDispatchLog.h"
#include "smContextResources.h"
#include "smContextScope.h"
#include "smOpenGL.h"
#include "smShaderSource.h"
#include "vtkComputeContext.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

namespace
{
std::string GetLog(GLuint name, PFNGLGETSHADERIVPROC query, PFNGLGETSHADERINFOLOGPROC getLog)
{
  GLint length = 0;
  query(name, GL_INFO_LOG_LENGTH, &length);
  if (length <= 1)
  {
    return {};
  }
  std::vector<char> text(static_cast<std::size_t>(length), '\0');
  getLog(name, length, nullptr, text.data());
  return text.data();
}
}

namespace sm
{
ComputeProgram::ComputeProgram() = default;

ComputeProgram::~ComputeProgram()
{
  this->Free();
}

ComputeProgram::ComputeProgram(ComputeProgram&& other) noexcept
{
  *this = std::move(other);
}

ComputeProgram& ComputeProgram::operator=(ComputeProgram&& other) noexcept
{
  if (this != &other)
  {
    this->Free();
    this->Resources = std::move(other.Resources);
    this->Generation = std::exchange(other.Generation, 0);
    this->Name = std::exchange(other.Name, 0);
    this->LocalSize = std::exchange(other.LocalSize, 0);
    this->BegunShader = std::exchange(other.BegunShader, 0);
    this->Source = std::move(other.Source);
    this->Uniforms = std::move(other.Uniforms);
    this->Label = std::move(other.Label);
    this->Error = std::move(other.Error);
    this->Log = std::move(other.Log);
  }
  return *this;
}

bool ComputeProgram::Fail(const std::string& what)
{
  this->Error = this->Label + ": " + what;
  return false;
}

bool ComputeProgram::IsBuilt() const
{
  return this->LocalSize != 0 && this->Generation == this->Resources->Generation;
}

void ComputeProgram::Free()
{
  if (this->Name != 0 && this->Generation == this->Resources->Generation)
  {
    // If the context cannot be entered now, it frees the name itself when it ends.
    std::optional<ContextScope> scope;
    if (ContextScope::IsInside(this->Resources->Context) || scope.emplace(this->Resources->Context))
    {
      this->Resources->FreeProgram(this->Name);
    }
  }
  this->Name = 0;
  this->Generation = 0;
  this->LocalSize = 0;
  this->BegunShader = 0;
  this->Uniforms.clear();
}

bool ComputeProgram::Build(vtkComputeContext* context, const std::string& name, const std::string& source)
{
  return this->BeginBuild(context, name, source) && this->FinishBuild();
}

bool ComputeProgram::BeginBuild(
  vtkComputeContext* context, const std::string& name, const std::string& source)
{
  this->Free();
  this->Label = name;
  this->Error.clear();
  this->Log.clear();
  std::optional<ContextScope> scope;
  if (!ContextScope::IsInside(context) && !scope.emplace(context))
  {
    return this->Fail("the compute context is not ready");
  }
  this->Resources = context->GetResources();
  this->Generation = this->Resources->Generation;
  this->Source = source;

  // No status is asked for here: the driver would finish the compilation first.
  this->BegunShader = GL::CreateShader(GL_COMPUTE_SHADER);
  const char* text = source.c_str();
  GL::ShaderSource(this->BegunShader, 1, &text, nullptr);
  GL::CompileShader(this->BegunShader);
  this->Name = GL::CreateProgram();
  GL::AttachShader(this->Name, this->BegunShader);
  GL::LinkProgram(this->Name);
  // The shader exists until it is detached.
  GL::DeleteShader(this->BegunShader);
  this->Resources->AddProgram(this->Name);
  return true;
}

bool ComputeProgram::FinishBuild()
{
  const GLuint shader = std::exchange(this->BegunShader, 0);
  const std::string source = std::exchange(this->Source, {});
  std::optional<ContextScope> scope;
  if (shader == 0 || this->Generation != this->Resources->Generation ||
    (!ContextScope::IsInside(this->Resources->Context) && !scope.emplace(this->Resources->Context)))
  {
    return this->Fail("the compute context is not ready");
  }
  GLint isCompiled = GL_FALSE;
  GLint isLinked = GL_FALSE;
  GL::GetShaderiv(shader, GL_COMPILE_STATUS, &isCompiled);
  GL::GetProgramiv(this->Name, GL_LINK_STATUS, &isLinked);
  if (!isCompiled)
  {
    this->Log = ::GetLog(shader, GL::GetShaderiv, GL::GetShaderInfoLog);
  }
  else if (!isLinked)
  {
    this->Log = ::GetLog(this->Name, GL::GetProgramiv, GL::GetProgramInfoLog);
  }
  GL::DetachShader(this->Name, shader);
  if (!isLinked)
  {
    this->Free();
    return this->Fail((isCompiled ? "does not link\n" : "does not compile\n") + this->Log + "\n" +
      ShaderSource::NumberLines(source));
  }
  GLint size[3] = { 0, 0, 0 };
  GL::GetProgramiv(this->Name, GL_COMPUTE_WORK_GROUP_SIZE, size);
  this->LocalSize = static_cast<unsigned int>(size[0]);
  this->FindUniforms();
  const std::string error = GL::TakeError();
  return error.empty() || this->Fail(error + " while the program was built");
}

void ComputeProgram::FindUniforms()
{
  GLint count = 0;
  GL::GetProgramiv(this->Name, GL_ACTIVE_UNIFORMS, &count);
  char name[64];
  for (GLint i = 0; i < count; ++i)
  {
    GLint size = 0;
    GLenum type = 0;
    GL::GetActiveUniform(this->Name, static_cast<GLuint>(i), sizeof(name), nullptr, &size, &type, name);
    this->Uniforms.push_back({ name, GL::GetUniformLocation(this->Name, name), type, false, 0 });
  }
}

ComputeProgram::Uniform* ComputeProgram::FindUniform(const char* name)
{
  const auto found = std::find_if(this->Uniforms.begin(), this->Uniforms.end(),
    [name](const Uniform& uniform) { return std::strcmp(uniform.Name.c_str(), name) == 0; });
  return found == this->Uniforms.end() ? nullptr : &*found;
}

template <typename T>
bool ComputeProgram::ChangeUniform(
  const char* name, unsigned int type, T value, void (*const& set)(GLuint, GLint, T))
{
  this->Error.clear();
  if (!this->IsBuilt() || !ContextScope::IsInside(this->Resources->Context))
  {
    return this->Fail(std::string("uniform ") + name + " set outside a scope of a built program's context");
  }
  Uniform* const uniform = this->FindUniform(name);
  if (!uniform)
  {
    return this->Fail(std::string("has no active uniform ") + name);
  }
  if (uniform->Type != type)
  {
    return this->Fail(std::string("uniform ") + name + " is of another type");
  }
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(value));
  // The program keeps its uniforms between dispatches.
  if (!uniform->IsSet || uniform->Bits != bits)
  {
    set(this->Name, uniform->Location, value);
    uniform->IsSet = true;
    uniform->Bits = bits;
  }
  return true;
}

bool ComputeProgram::SetUniform(const char* name, int value)
{
  return this->ChangeUniform<GLint>(name, GL_INT, value, GL::ProgramUniform1i);
}

bool ComputeProgram::SetUniform(const char* name, unsigned int value)
{
  return this->ChangeUniform<GLuint>(name, GL_UNSIGNED_INT, value, GL::ProgramUniform1ui);
}

bool ComputeProgram::SetUniform(const char* name, double value)
{
  return this->ChangeUniform<GLdouble>(name, GL_DOUBLE, value, GL::ProgramUniform1d);
}

bool ComputeProgram::Dispatch(unsigned int invocations, unsigned int localSize, Barrier barrier)
{
  this->Error.clear();
  if (!this->IsBuilt() || !ContextScope::IsInside(this->Resources->Context))
  {
    return this->Fail("dispatched outside a scope of a built program's context");
  }
  if (localSize == 0 || localSize != this->LocalSize)
  {
    return this->Fail("dispatched with local size " + std::to_string(localSize) + ", but the shader has " +
      std::to_string(this->LocalSize));
  }
  if (invocations == 0)
  {
    return true;
  }
  const std::uint64_t groups = (static_cast<std::uint64_t>(invocations) + localSize - 1) / localSize;
  const std::uint64_t maximumX = static_cast<std::uint64_t>(this->Resources->MaximumWorkGroupCount[0]);
  const std::uint64_t maximumY = static_cast<std::uint64_t>(this->Resources->MaximumWorkGroupCount[1]);
  const std::uint64_t rows = (groups + maximumX - 1) / maximumX;
  const std::uint64_t columns = (groups + rows - 1) / rows;
  // The shader's index is an unsigned 32-bit number, and those beyond the count must not wrap around to 0.
  if (rows > maximumY || rows * columns * localSize > 0xffffffffu)
  {
    return this->Fail(std::to_string(invocations) + " invocations are too many for one dispatch");
  }
  GL::UseProgram(this->Name);
  GL::DispatchCompute(static_cast<GLuint>(columns), static_cast<GLuint>(rows), 1);
  if (barrier == Barrier::After)
  {
    GL::MemoryBarrier(GL_ALL_BARRIER_BITS);
  }
  ++this->Resources->Dispatches;
  LogDispatch(this->Resources->Context, this->Label);
  const std::string error = GL::TakeError();
  if (error.empty())
  {
    return true;
  }
  // It may be that of a uniform.
  for (Uniform& uniform : this->Uniforms)
  {
    uniform.IsSet = false;
  }
  return this->Fail(
    error + " in a dispatch of " + std::to_string(columns) + " x " + std::to_string(rows) + " groups");
}

void ComputeProgram::PlaceBarrier()
{
  GL::MemoryBarrier(GL_ALL_BARRIER_BITS);
}

long ComputeProgram::GetLiveCount()
{
  return ContextResources::GetLivePrograms();
}
}
