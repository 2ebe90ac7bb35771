/**
 * @file smLoader.h
 * @brief The one header of the module that includes VTK's loader of OpenGL; not installed
 */
#ifndef smLoader_h
#define smLoader_h

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
/// Loads OpenGL's functions for VTK's rendering in the current context. Returns the reason of a failure, else
/// an empty text.
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
}

#endif
