/**
 * @file smGLObjects.h
 * @brief The objects that live in the current OpenGL context, counted by asking the driver for every name
 *
 * glIs...() over a range of names knows of everybody's objects, whoever forgot them; no book-keeping of ours
 * is asked.
 */
#ifndef smGLObjects_h
#define smGLObjects_h

#include "Detail/smLoader.h"

#include <algorithm>
#include <array>
#include <string>

namespace smtest
{
struct GLObjects
{
  static constexpr std::size_t Kinds = 10;
  static const char* GetName(std::size_t kind)
  {
    static const char* const names[Kinds] = { "buffers", "textures", "framebuffers", "renderbuffers",
      "vertex arrays", "programs", "shaders", "queries", "samplers", "pipelines" };
    return names[kind];
  }
  std::array<long, Kinds> Counts{};
  /// The highest living name; when it comes near Range, objects may live beyond.
  unsigned int Highest = 0;
  static constexpr unsigned int Range = 65536;

  long GetTotal() const
  {
    long total = 0;
    for (const long count : this->Counts)
    {
      total += count;
    }
    return total;
  }
  std::string GetText() const
  {
    std::string text;
    for (std::size_t kind = 0; kind < Kinds; ++kind)
    {
      text += this->Counts[kind] ? std::to_string(this->Counts[kind]) + " " + GetName(kind) + ", " : "";
    }
    return text + "highest name " + std::to_string(this->Highest);
  }
};

/// Objects of the context that is current on the thread.
inline GLObjects CountGLObjects()
{
  using Ask = GLboolean (*)(GLuint);
  const std::array<Ask, GLObjects::Kinds> asks = { [](GLuint name) { return glIsBuffer(name); },
    [](GLuint name) { return glIsTexture(name); }, [](GLuint name) { return glIsFramebuffer(name); },
    [](GLuint name) { return glIsRenderbuffer(name); }, [](GLuint name) { return glIsVertexArray(name); },
    [](GLuint name) { return glIsProgram(name); }, [](GLuint name) { return glIsShader(name); },
    [](GLuint name) { return glIsQuery(name); }, [](GLuint name) { return glIsSampler(name); },
    [](GLuint name) { return glIsProgramPipeline(name); } };
  GLObjects objects;
  for (GLuint name = 1; name < GLObjects::Range; ++name)
  {
    for (std::size_t kind = 0; kind < GLObjects::Kinds; ++kind)
    {
      if (asks[kind](name))
      {
        ++objects.Counts[kind];
        objects.Highest = std::max(objects.Highest, name);
      }
    }
  }
  return objects;
}
}

#endif
