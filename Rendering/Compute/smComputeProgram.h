/**
 * @file smComputeProgram.h
 * @brief A compute program that frees itself in its own context
 */
#ifndef smComputeProgram_h
#define smComputeProgram_h

#include "smRenderingComputeModule.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkComputeContext;

namespace sm
{
struct ContextResources;

/**
 * Owns one GL program with a compute shader. When the context ends the program is gone: IsBuilt() is false
 * and Build() must be called again.
 */
class SMRENDERINGCOMPUTE_EXPORT ComputeProgram
{
public:
  ComputeProgram();
  ~ComputeProgram();
  ComputeProgram(ComputeProgram&& other) noexcept;
  ComputeProgram& operator=(ComputeProgram&& other) noexcept;
  ComputeProgram(const ComputeProgram&) = delete;
  ComputeProgram& operator=(const ComputeProgram&) = delete;

  /** Compiles and links `source` (see ShaderSource) in the started `context`. May be called outside a
   * ContextScope. On failure GetError() holds `name`, the driver's log and the source with line numbers. */
  bool Build(vtkComputeContext* context, const std::string& name, const std::string& source);

  ///@{
  /** Build() in two steps. Drivers compile several programs side by side between the first step of all and
   * the second step of one. Both steps are in one generation of the context; BeginBuild() fails only if the
   * context is not ready. */
  bool BeginBuild(vtkComputeContext* context, const std::string& name, const std::string& source);
  bool FinishBuild();
  ///@}

  /** True when there is a program in the context's present generation. */
  bool IsBuilt() const;

  /** True when the program has an active uniform of this name: the compiler removes unused ones. */
  bool HasUniform(const char* name) { return this->FindUniform(name) != nullptr; }

  ///@{
  /** Sets a uniform of the program, which keeps it between dispatches. Inside a ContextScope only. False when
   * the program has no such active uniform, or one of another type. */
  bool SetUniform(const char* name, int value);
  bool SetUniform(const char* name, unsigned int value);
  bool SetUniform(const char* name, double value);
  ///@}

  /** Without a barrier the next dispatch may run at the same time, and does not see what this one writes. */
  enum class Barrier
  {
    After,
    None
  };

  /** Runs at least `invocations` invocations in groups of `localSize`, the shader's local_size_x, then a
   * memory barrier. Inside a ContextScope only. When one axis has not enough groups the groups form a
   * rectangle: the shader takes its index from smInvocationIndex() (chunk smInvocation) and returns when it
   * is not below the count. With 0 invocations it does nothing. Counts as one dispatch of the context. */
  bool Dispatch(unsigned int invocations, unsigned int localSize, Barrier barrier = Barrier::After);

  /** A memory barrier in the current context: what follows sees what earlier dispatches wrote. */
  static void PlaceBarrier();

  /** Frees the program. */
  void Free();

  /** Returns the reason of the last failure. */
  const std::string& GetError() const { return this->Error; }

  /** The driver's message on the last source, if it refused it; else empty. */
  const std::string& GetLog() const { return this->Log; }

  /** GL programs that exist in the process. Thread safe. */
  static long GetLiveCount();

private:
  /// An active uniform, and the bits of its value if it was set.
  struct Uniform
  {
    std::string Name;
    int Location;
    unsigned int Type;
    bool IsSet;
    std::uint64_t Bits;
  };

  bool Fail(const std::string& what);
  void FindUniforms();
  /// Returns null if there is no active uniform of this name.
  Uniform* FindUniform(const char* name);
  /// Calls set(program, location, value) unless the uniform has this value; its type in OpenGL must be
  /// `type`.
  template <typename T>
  bool ChangeUniform(const char* name, unsigned int type, T value, void (*const& set)(unsigned int, int, T));

  std::shared_ptr<ContextResources> Resources;
  std::uint64_t Generation = 0;
  unsigned int Name = 0;
  unsigned int LocalSize = 0;
  std::string Label;
  std::string Error;
  std::string Log;
  /// The shader and the source of a build that was begun.
  unsigned int BegunShader = 0;
  std::string Source;
  std::vector<Uniform> Uniforms;
};
}

#endif
