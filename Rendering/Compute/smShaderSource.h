/**
 * @file smShaderSource.h
 * @brief Assembles a compute shader from a shader file, chunks and definitions
 */
#ifndef smShaderSource_h
#define smShaderSource_h

#include "smRenderingComputeModule.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace sm
{
/**
 * Every GLSL text is a file below glsl/, embedded by solidmoments_encode_shaders(). Tags are whole lines:
 *
 *     //SM::Define           the definitions given to Define(), in that order
 *     //SM::Include NAME     the chunk NAME after a comment `// chunk NAME`; a chunk comes once, where it is
 *                            first included, and may include others
 *     //SM::Anything         the text given to Replace("//SM::Anything", text)
 *
 * A source with a construct that drivers are known to get wrong (arrays of doubles of one invocation, see
 * smShaderCheck.h) is refused.
 *
 * The assembled source starts with `#version 430 core`, which no file repeats. Chunks of this module are
 * always known: smInvocation (include it after the local_size layout), smErrorFree, smPortable.
 */
class SMRENDERINGCOMPUTE_EXPORT ShaderSource
{
public:
  /** `name` is for messages. */
  ShaderSource(const std::string& name, const char* text);

  /** Makes a chunk known to Include lines. The last text of a name wins. */
  void AddChunk(const std::string& name, const char* text);

  ///@{
  /** Adds `#define name value`. */
  void Define(const std::string& name, const std::string& value);
  void Define(const std::string& name, int value);
  void Define(const std::string& name, unsigned int value);
  ///@}

  /** Exchanges every line that consists of `tag`, which starts with "//SM::". The text may have tags itself.
   */
  void Replace(const std::string& tag, const std::string& text);

  /** Leaves out the check of the constructs; for the probe that tests them. */
  void SetUnchecked() { this->IsChecked = false; }

  /** Builds the source. False, with a sentence in GetError() that names shader and line, when a chunk is
   * unknown, a tag is left, a replacement or the definitions have no place, a text has its own #version, or a
   * construct is unsafe. */
  bool Assemble();

  /** The assembled source; empty before Assemble() succeeded. */
  const std::string& GetSource() const { return this->Source; }
  const std::string& GetName() const { return this->Name; }
  const std::string& GetError() const { return this->Error; }

  /** `source` with a line number before each line, as compilers count them. */
  static std::string NumberLines(const std::string& source);

private:
  struct Assembly;
  bool Append(Assembly& assembly, const std::string& where, const std::string& text, int depth);
  bool AppendTag(Assembly& assembly, const std::string& where, const std::string& tag, int depth);

  std::string Name;
  std::string Text;
  std::map<std::string, std::string> Chunks;
  std::vector<std::pair<std::string, std::string>> Definitions;
  std::map<std::string, std::string> Replacements;
  bool IsChecked = true;
  std::string Source;
  std::string Error;
};
}

#endif
