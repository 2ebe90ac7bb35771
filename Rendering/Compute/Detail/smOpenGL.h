/**
 * @file smOpenGL.h
 * @brief The one header of the module that includes the OpenGL loader; not installed
 */
#ifndef smOpenGL_h
#define smOpenGL_h

// GLEW until VTK 9.3, glad from 9.4 on.
#if __has_include("vtk_glew.h")
#include "vtk_glew.h"
#define SM_HAS_GLEW
#else
#include "vtk_glad.h"
#endif

#include <string>

namespace sm
{
/// Removes pending GL errors of other code. The number of calls is limited, because a lost context may report
/// errors for ever.
inline void DrainErrors()
{
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
  {
  }
}

/// Loads OpenGL's functions for the current context. Returns the reason of a failure, else an empty text.
template <typename GetAddress>
std::string LoadOpenGL(GetAddress getAddress)
{
#ifdef SM_HAS_GLEW
  (void)getAddress;
  // A GLEW built for GLX searches a GLX display after it has loaded all pointers. The pointers are valid
  // although it returns GLEW_ERROR_NO_GLX_DISPLAY (4), which is therefore ignored.
  glewExperimental = GL_TRUE;
  const GLenum result = glewInit();
  const bool loaded = (result == GLEW_OK || result == 4) && glGenVertexArrays != nullptr;
#else
  const int result = gladLoadGL(getAddress);
  const bool loaded = result != 0;
#endif
  return loaded ? std::string() : "result " + std::to_string(result);
}

/// Returns the name of the first pending error, or an empty text, and removes all others.
inline std::string TakeError()
{
  const GLenum error = glGetError();
  DrainErrors();
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

#endif
