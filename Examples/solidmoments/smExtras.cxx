#include "smExtras.h"

#include "smOnDemandLibrary.h"
#include "smVersion.h"

#ifdef SOLIDMOMENTS_LINKS_ALL
extern "C" sm::LibraryEntry smGetExtras();
#endif

namespace sm
{
const ExtraFunctions* GetExtras(std::string& problem)
{
  static const ExtraFunctions* functions = nullptr;
  std::string reason;
  if (!functions)
  {
#ifdef SOLIDMOMENTS_LINKS_ALL
    functions = static_cast<const ExtraFunctions*>(smGetExtras().Content);
#else
    functions = static_cast<const ExtraFunctions*>(
      LoadOnDemand(SOLIDMOMENTS_EXTRAS_LIBRARY, ExtrasEntryName, Version, reason));
#endif
  }
  problem = functions ? std::string()
                      : "the library " SOLIDMOMENTS_EXTRAS_LIBRARY " " + reason +
      "; install SolidMoments again, with all its libraries in one folder";
  return functions;
}
}
