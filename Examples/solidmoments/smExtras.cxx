#include "smExtras.h"

#include "smOnDemandLibrary.h"
#include "smVersion.h"

namespace sm
{
const ExtraFunctions* GetExtras(std::string& problem)
{
  static const ExtraFunctions* functions = nullptr;
  std::string reason;
  if (!functions)
  {
    functions = static_cast<const ExtraFunctions*>(
      LoadOnDemand(SOLIDMOMENTS_EXTRAS_LIBRARY, ExtrasEntryName, Version, reason));
  }
  problem = functions ? std::string()
                      : "the library " SOLIDMOMENTS_EXTRAS_LIBRARY " " + reason +
      "; install SolidMoments again, with all its libraries in one folder";
  return functions;
}
}
