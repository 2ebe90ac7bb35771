// Libraries of another version, in the place of those that are loaded on demand.
#include "smOnDemandLibrary.h"

extern "C" __attribute__((visibility("default"))) sm::LibraryEntry SM_ENTRY()
{
  return { "0.0.0", nullptr };
}
