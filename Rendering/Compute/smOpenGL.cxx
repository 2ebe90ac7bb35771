#include "smOpenGL.h"

#include <cstring>
#include <mutex>

namespace sm
{
#define SM_DEFINE(type, name) PFNGL##type##PROC GL::name = nullptr;
SM_OPENGL_FUNCTIONS(SM_DEFINE)
#undef SM_DEFINE

namespace
{
/// Returns true if the current context has glBufferStorage: from version 4.4 on, or by an extension. The
/// loaders of EGL and GLX give an address for it in any case.
bool HasBufferStorage()
{
  GLint version[2] = { 0, 0 };
  GLint extensions = 0;
  GL::GetIntegerv(GL_MAJOR_VERSION, &version[0]);
  GL::GetIntegerv(GL_MINOR_VERSION, &version[1]);
  if (version[0] > 4 || (version[0] == 4 && version[1] >= 4))
  {
    return true;
  }
  GL::GetIntegerv(GL_NUM_EXTENSIONS, &extensions);
  for (GLint i = 0; i < extensions; ++i)
  {
    const GLubyte* name = GL::GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
    if (name && std::strcmp(reinterpret_cast<const char*>(name), "GL_ARB_buffer_storage") == 0)
    {
      return true;
    }
  }
  return false;
}
}

void GL::Load(void* (*getAddress)(const char* name))
{
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  // A function that was found is never written again: other threads may be calling it. BufferStorage is the
  // last one of the list, since others find whether it is there.
#define SM_LOAD(type, name)                                                                                  \
  if (!GL::name && (std::strcmp(#name, "BufferStorage") != 0 || HasBufferStorage()))                         \
  {                                                                                                          \
    GL::name = reinterpret_cast<PFNGL##type##PROC>(getAddress("gl" #name));                                  \
  }
  SM_OPENGL_FUNCTIONS(SM_LOAD)
#undef SM_LOAD
}

void GL::DrainErrors()
{
  for (int i = 0; i < 16 && GL::GetError() != GL_NO_ERROR; ++i)
  {
  }
}

std::string GL::TakeError()
{
  const GLenum error = GL::GetError();
  GL::DrainErrors();
  switch (error)
  {
    case GL_NO_ERROR:
      return {};
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    default:
      return "GL error " + std::to_string(error);
  }
}
}
