/**
 * @class   vtkSMMaterialTableDomain
 * @brief   updates the table of parts and materials in the panel of Mass Properties when the input, the rules
 * or the results change
 *
 * The property has the cells of smMaterialTable.h. The domain fills them when the filter gets its input,
 * after every change of the input's data, of the rules or of Density, and with the masses after every run.
 * When somebody changes the cells, it sets the rules. Required properties:
 * @code{xml}
 * <MaterialTableDomain name="rows">
 *   <RequiredProperties>
 *     <Property name="Input" function="Input"/>
 *     <Property name="Materials" function="Rules"/>
 *     <Property name="Density" function="Density"/>
 *     <Property name="Selectors" function="Selectors"/>
 *   </RequiredProperties>
 * </MaterialTableDomain>
 * @endcode
 * Port 1 of the filter is its table of solids. The property has no command: the filter gets the rules only.
 */
#ifndef vtkSMMaterialTableDomain_h
#define vtkSMMaterialTableDomain_h

#include "smMaterialTable.h"            // for the rules
#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkNew.h"                     // for the parts
#include "vtkSMDomain.h"

#include <vector> // for the rules

class vtkPartMaterialsInformation;

class SMPARAVIEWEXTENSIONS_EXPORT vtkSMMaterialTableDomain : public vtkSMDomain
{
public:
  static vtkSMMaterialTableDomain* New();
  vtkTypeMacro(vtkSMMaterialTableDomain, vtkSMDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Update(vtkSMProperty* requestingProperty) override;

protected:
  vtkSMMaterialTableDomain();
  ~vtkSMMaterialTableDomain() override;

private:
  vtkSMMaterialTableDomain(const vtkSMMaterialTableDomain&) = delete;
  void operator=(const vtkSMMaterialTableDomain&) = delete;

#ifndef __VTK_WRAP__
  std::vector<sm::MaterialRow> GetRules();
  double GetDensity();
  /// Returns true if only selected solids are computed.
  bool IsSomeSolids();
  void GatherParts();
  void FollowCells();
  void FollowRun();
  void FillCells();
  std::vector<std::string> MakeCells();

  vtkNew<vtkPartMaterialsInformation> Parts;
  /// Masses of the last run, unless something has changed since.
  vtkNew<vtkPartMaterialsInformation> Masses;
  /// The table as it was filled last.
  std::vector<std::string> Filled;
  bool IsObserving = false;
  bool IsFilling = false;
#endif
};

#endif
