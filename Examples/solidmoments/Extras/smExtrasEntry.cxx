#include "smExtras.h"

#include "smBodyScene.h"
#include "smBudgetPicture.h"
#include "smComparisonPicture.h"
#include "smMeshFile.h"
#include "smOnDemandLibrary.h"
#include "smPicture.h"
#include "smSectionRun.h"
#include "smVersion.h"

// The program looks for it by sm::ExtrasEntryName.
extern "C" __attribute__((visibility("default"))) sm::LibraryEntry smGetExtras()
{
  static sm::ExtraFunctions functions = {
    sm::WriteBudget, sm::WriteComparison, sm::WriteImage, sm::WriteLinkMesh, sm::WriteMesh, sm::WritePicture,
#ifdef SOLIDMOMENTS_HAS_SECTION
    sm::RunSections
#else
    nullptr
#endif
  };
  return { sm::Version, &functions };
}
