/**
 * @file vtkSolidStabilityInternals.h
 * @brief Results that vtkSolidStability keeps of its last run, and their conversion to arrays; not installed
 */
#ifndef vtkSolidStabilityInternals_h
#define vtkSolidStabilityInternals_h

#include "smFacePanelsCache.h"
#include "smSupportedBody.h"
#include "vtkMassPropertiesGPU.h"
#include "vtkSolidStability.h"

#include "vtkMath.h"
#include "vtkNew.h"

#include <string>
#include <vector>

class vtkFieldData;
class vtkTable;

namespace sm
{
namespace columns
{
class KeptArrays;
}
const char* GetName(Verdict verdict);
const char* GetName(SupportKind support);
constexpr double DegreesPerRadian = 57.295779513082321;
}

struct vtkSolidStability::Internals
{
  vtkNew<vtkMassPropertiesGPU> Mass;
  sm::FacePanelsCache Cache;
  sm::SupportedBody Worst;
  std::string Status;
  std::vector<std::string> Messages;
  /// See sm::FileState.
  std::vector<std::string> FileNotes;

  /// Removes the bodies that the mass filter has no row for, because its selectors leave them out.
  void KeepChosen(std::vector<sm::BodyIntegrals>& bodies) const;
  std::vector<sm::SupportedBody> Collect(const std::vector<sm::BodyIntegrals>& bodies, bool together);
  static double GetEnergy(const sm::SupportedBody& body, double rise, double strength);
  static void AddColumns(sm::columns::KeptArrays& arrays, const std::vector<sm::SupportedBody>& bodies,
    const sm::GroundDirections& ground, double strength, vtkFieldData* data);
  static void AddSides(sm::columns::KeptArrays& arrays, const std::vector<sm::SupportedBody>& bodies,
    const sm::GroundDirections& ground, double strength, vtkTable* sides);
  static std::string GetSummary(const std::vector<sm::SupportedBody>& bodies, double strength);
};

#endif
