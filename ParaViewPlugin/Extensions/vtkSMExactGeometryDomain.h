/**
 * @class   vtkSMExactGeometryDomain
 * @brief   accepts inputs that hold exact NURBS geometry
 *
 * For the input property of filters that need the exact faces: `<ExactGeometryDomain
 * name="exact_geometry"/>`. Every check queries the server (vtkExactGeometryInformation), because a dataset
 * whose points were changed has the same class but no exact faces; it is refused.
 *
 * ParaView 5.11 disables the menu entry of a refused filter with the status text "Requirements not met"; it
 * takes other texts from vtkSMDataTypeDomain and vtkSMInputArrayDomain only, by functions that are not
 * virtual. The documentation of every filter therefore says what its input must be, and a script gets the
 * filter's own error.
 */
#ifndef vtkSMExactGeometryDomain_h
#define vtkSMExactGeometryDomain_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkSMDomain.h"

class SMPARAVIEWEXTENSIONS_EXPORT vtkSMExactGeometryDomain : public vtkSMDomain
{
public:
  static vtkSMExactGeometryDomain* New();
  vtkTypeMacro(vtkSMExactGeometryDomain, vtkSMDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** IN_DOMAIN when the property has (unchecked) inputs and every one holds exact geometry. */
  int IsInDomain(vtkSMProperty* property) override;

protected:
  vtkSMExactGeometryDomain();
  ~vtkSMExactGeometryDomain() override;

private:
  vtkSMExactGeometryDomain(const vtkSMExactGeometryDomain&) = delete;
  void operator=(const vtkSMExactGeometryDomain&) = delete;
};

#endif
