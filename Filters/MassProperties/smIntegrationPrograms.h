/**
 * @file smIntegrationPrograms.h
 * @brief The compute programs of integration, built for a list of integrands when first needed
 */
#ifndef smIntegrationPrograms_h
#define smIntegrationPrograms_h

#include "smComputeProgram.h"
#include "smIntegrand.h"

#include <map>
#include <string>
#include <tuple>
#include <vector>

class vtkComputeContext;

namespace sm
{
enum class ItemKind
{
  Panel = 0,
  Ribbon = 1,
  Cap = 2
};

/// Items that one program integrates: their kind, and the degrees it is compiled for (0: any).
using ProgramKey = std::tuple<ItemKind, int, int>;

class IntegrationPrograms
{
public:
  explicit IntegrationPrograms(vtkComputeContext* context);

  void Configure(
    const std::vector<Integrand>& integrands, int stripPoints, bool usePlacements, double perturbation);

  /// The program for an item on a patch of these degrees. The choice depends on nothing else, so that a face
  /// gets the same bits in any company.
  static ProgramKey ChooseProgram(ItemKind kind, int degreeS, int degreeR);

  /// Builds it if need be; null with GetError() when it does not build.
  ComputeProgram* Get(const ProgramKey& key);

  /// Doubles of a result row, and where the columns start.
  int GetStride() const;
  int GetNumberOfRoundings() const { return static_cast<int>(this->Magnitudes.size()); }
  /// Rounding column of an integrand.
  int GetRoundingOf(int integrand) const { return this->RoundingOf[integrand]; }

  const std::string& GetError() const { return this->Error; }

private:
  std::string MakeAccumulation(bool chainOnly) const;

  vtkComputeContext* Context;
  std::vector<Integrand> Integrands;
  std::vector<std::string> Magnitudes;
  std::vector<int> RoundingOf;
  int StripPoints = 3;
  bool UsePlacements = false;
  double Perturbation = 1.0;
  std::map<ProgramKey, ComputeProgram> Programs;
  std::string Error;
};
}

#endif
