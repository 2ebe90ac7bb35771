#include "smPanel.h"

#include <dlfcn.h>

#include <string>

namespace sm
{
namespace
{
bool LoadPanel()
{
  // ParaView's window alone links the library of this function: servers and pvpython load no Qt.
  if (!dlsym(RTLD_DEFAULT, "_ZN17pqApplicationCore8instanceEv"))
  {
    return false;
  }
  Dl_info plugin;
  if (dladdr(reinterpret_cast<const void*>(&HasPanel), &plugin) == 0 || !plugin.dli_fname)
  {
    return false;
  }
  const std::string path = plugin.dli_fname;
  const std::string folder = path.substr(0, path.find_last_of('/') + 1);
  void* library = dlopen((folder + "smParaViewPanel.so").c_str(), RTLD_NOW | RTLD_LOCAL);
  const auto add = library ? reinterpret_cast<bool (*)()>(dlsym(library, "smRegisterPanel")) : nullptr;
  return add && add();
}
}

bool HasPanel()
{
  static const bool isLoaded = LoadPanel();
  return isLoaded;
}
}
