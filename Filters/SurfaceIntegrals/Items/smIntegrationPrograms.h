/**
 * @file smIntegrationPrograms.h
 * @brief The compute programs of integration, built for a list of integrands when first needed
 */
#ifndef smIntegrationPrograms_h
#define smIntegrationPrograms_h

#include "smComputeProgram.h"
#include "smItemRunner.h"

#include <map>
#include <string>
#include <tuple>

class vtkComputeContext;

namespace sm
{
class ShaderSource;

/// Items that one program integrates: their kind, and the degrees it is compiled for (0: any).
using ProgramKey = std::tuple<ItemKind, int, int>;

class IntegrationPrograms
{
public:
  explicit IntegrationPrograms(vtkComputeContext* context);

  /// A change drops the compiled shaders.
  void Configure(const ItemRunner::Setup& setup, const RowLayout& layout);

  /// The program for an item on a patch of these degrees. The choice depends on nothing else, so that a face
  /// gets the same bits in any company.
  static ProgramKey ChooseProgram(ItemKind kind, int degreeS, int degreeR);

  /// Builds it if need be; null with GetError() when it does not build.
  ComputeProgram* Get(const ProgramKey& key);

  /// Why an integrand does not compile, at the user's column; empty when it does. Each is compiled alone, and once.
  std::string FindError(const Integrand& integrand);

  const std::string& GetError() const { return this->Error; }

private:
  std::string MakeFunctions(bool isPanel) const;
  std::string MakeValues(bool chainOnly) const;
  std::string MakeRoundings(bool chainOnly) const;
  /// What the samples of panels must be described by, see UserExpression.
  int GetDetail(bool isPanel) const;

  vtkComputeContext* Context;
  ItemRunner::Setup Setup;
  RowLayout Layout;
  std::map<ProgramKey, ComputeProgram> Programs;
  /// What the compiler said of functions of the user's.
  std::map<std::string, std::string> Checked;
  std::string Error;
};
}

#endif
