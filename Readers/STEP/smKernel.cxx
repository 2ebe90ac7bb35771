#include "smKernel.h"

#include "smRepairNotice.h"

#include <vtksys/DynamicLoader.hxx>
#include <vtksys/SystemTools.hxx>

#include <dlfcn.h>
#include <utility>

namespace sm
{
namespace
{
/// Returns the folder of the library that this code is in; empty if it is not known.
std::string GetLibraryFolder()
{
  Dl_info info;
  const auto function = reinterpret_cast<const void*>(&GetKernel);
  return dladdr(function, &info) != 0 && info.dli_fname ? vtksys::SystemTools::GetFilenamePath(info.dli_fname)
                                                        : std::string();
}

const Kernel* LoadKernel()
{
  using Loader = vtksys::DynamicLoader;
  const std::string folder = GetLibraryFolder();
  const std::string name = SOLIDMOMENTS_KERNEL_LIBRARY;
  Loader::LibraryHandle library = Loader::OpenLibrary((folder.empty() ? name : folder + "/" + name).c_str());
  library = library ? library : Loader::OpenLibrary(name.c_str());
  const auto function = library
    ? reinterpret_cast<const Kernel* (*)()>(Loader::GetSymbolAddress(library, "SolidMomentsGetKernel"))
    : nullptr;
  return function ? function() : nullptr;
}

std::function<void(bool)>& GetRepairObserver()
{
  static std::function<void(bool)> observer;
  return observer;
}
}

Kernel::~Kernel() = default;

const Kernel* GetKernel()
{
  static const Kernel* const kernel = LoadKernel();
  return kernel;
}

void SetRepairObserver(std::function<void(bool)> observer)
{
  GetRepairObserver() = std::move(observer);
}

RepairNotice::RepairNotice()
{
  if (GetRepairObserver())
  {
    GetRepairObserver()(true);
  }
}

RepairNotice::~RepairNotice()
{
  if (GetRepairObserver())
  {
    GetRepairObserver()(false);
  }
}
}
