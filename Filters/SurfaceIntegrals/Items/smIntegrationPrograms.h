/**
 * @file smIntegrationPrograms.h
 * @brief Compute programs of integration for a list of integrands, built on first use
 */
#ifndef smIntegrationPrograms_h
#define smIntegrationPrograms_h

#include "smComputeProgram.h"
#include "smItemRunner.h"

#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <vector>

class vtkComputeContext;

namespace sm
{
class ShaderSource;

enum class ProgramKind
{
  ///@{
  /// Lines of items.
  Panels,
  Ribbons,
  Caps,
  ///@}
  /// Adds up the lines of items, and stores their rows.
  Finish,
  /// Adds up blocks of rows.
  RowBlocks,
  /// Adds up the blocks of faces.
  FaceSums
};

/// Key of a program: its kind, and the degrees it is compiled for (0: any).
using ProgramKey = std::tuple<ProgramKind, int, int>;

/// Builds and keeps the compute programs of one context.
class IntegrationPrograms
{
public:
  explicit IntegrationPrograms(vtkComputeContext* context);

  /// Sets integrands and layout. A change releases the compiled shaders.
  void Configure(const ItemRunner::Setup& setup, const RowLayout& layout);

  /// Returns the key of the program for an item on a patch of these degrees. The choice depends on nothing
  /// else, so that the results of a face are bitwise the same in any batch.
  static ProgramKey ChooseProgram(ItemKind kind, int degreeS, int degreeR);

  bool IsBuilt(const ProgramKey& key) const;
  /// Builds programs side by side, as far as the driver can. Returns false, with GetError(), if one cannot be
  /// built.
  bool Build(const std::vector<ProgramKey>& keys);
  /// Returns the program, which is built on first use; null, with GetError(), if it cannot be built.
  ComputeProgram* Get(const ProgramKey& key);

  /// Returns the reason why an integrand does not compile, with the column in the user's text; empty if it
  /// compiles. Each integrand is compiled separately, and only once.
  std::string FindError(const Integrand& integrand);

  const std::string& GetError() const { return this->Error; }

private:
  ShaderSource MakeSource(const ProgramKey& key) const;
  std::string MakeFunctions(bool isPanel) const;
  /// Calls `make` with the variable of each integrand's sum and then of each rounding's.
  std::string MakeForSums(const std::function<std::string(const std::string&)>& make) const;
  std::string MakeValues(bool chainOnly) const;
  std::string MakeRoundings(bool chainOnly) const;
  /// Returns the level of SM_SAMPLE_DETAIL that the integrands need, see UserExpression.
  int GetDetail(bool isPanel) const;

  vtkComputeContext* Context;
  ItemRunner::Setup Setup;
  RowLayout Layout;
  std::map<ProgramKey, ComputeProgram> Programs;
  /// Results of FindError() by the text of the user's functions.
  std::map<std::string, std::string> Checked;
  std::string Error;
};
}

#endif
