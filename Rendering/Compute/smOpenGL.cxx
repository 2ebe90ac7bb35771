#include "smOpenGL.h"

#include <mutex>

namespace sm
{
#define SM_DEFINE(type, name) PFNGL##type##PROC GL::name = nullptr;
SM_OPENGL_FUNCTIONS(SM_DEFINE)
#undef SM_DEFINE

void GL::Load(void* (*getAddress)(const char* name))
{
  static std::mutex mutex;
  static bool isComplete = false;
  const std::lock_guard<std::mutex> lock(mutex);
  if (isComplete)
  {
    return;
  }
  isComplete = true;
#define SM_LOAD(type, name)                                                                                  \
  GL::name = reinterpret_cast<PFNGL##type##PROC>(getAddress("gl" #name));                                    \
  isComplete = isComplete && GL::name;
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
