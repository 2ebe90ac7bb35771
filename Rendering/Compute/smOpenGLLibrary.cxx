#include "smOpenGLLibrary.h"

#include "smOnDemandLibrary.h"

#include <algorithm>
#include <cctype>
#include <mutex>

#ifdef SOLIDMOMENTS_LINKS_ALL
extern "C" sm::LibraryEntry smGetOpenGLEntry();
#endif

namespace sm
{
OpenGLLibrary* GetOpenGLLibrary(std::string& reason)
{
  static std::mutex mutex;
  static OpenGLLibrary* library = nullptr;
  reason.clear();
  const std::lock_guard<std::mutex> lock(mutex);
  if (!library)
  {
#ifdef SOLIDMOMENTS_LINKS_ALL
    library = static_cast<OpenGLLibrary*>(smGetOpenGLEntry().Content);
#else
    library = static_cast<OpenGLLibrary*>(
      LoadOnDemand(SOLIDMOMENTS_OPENGL_LIBRARY, OpenGLEntryName, SM_OPENGL_LIBRARY_VERSION, reason));
#endif
    reason = library ? std::string()
                     : "OpenGL: the library " SOLIDMOMENTS_OPENGL_LIBRARY " " + reason +
        ". Install SolidMoments again, with all its libraries in one folder.";
  }
  return library;
}

bool IsSoftwareRenderer(const std::string& renderer)
{
  std::string text = renderer;
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  for (const char* name :
    { "llvmpipe", "softpipe", "swrast", "swiftshader", "software rasterizer", "basic render" })
  {
    if (text.find(name) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

int& GetOpenScopes()
{
  static thread_local int count = 0;
  return count;
}
}
