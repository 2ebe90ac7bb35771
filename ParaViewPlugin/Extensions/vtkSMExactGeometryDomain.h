/**
 * @class   vtkSMExactGeometryDomain
 * @brief   accepts inputs that hold exact NURBS geometry
 *
 * For the input property of filters that need the exact faces: `<ExactGeometryDomain name="exact_geometry"/>`. It asks the server
 * (vtkExactGeometryInformation) on every check, so that a part whose points were changed, which keeps its class and loses its faces, is
 * refused. With the attribute `inverse="1"` it accepts inputs that hold none.
 *
 * ParaView 5.11 greys out a filter that a domain refuses, and takes words for it from none but its own domains: "Requirements not
 * met". So the menu has an entry that is there for the refused inputs (WhyNotThisInput in inputs.xml) and tells what to
 * connect; to scripts the filters' own error says it.
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

  /** IN_DOMAIN when every (unchecked) input of the property holds exact geometry; the inverse: when none does. */
  int IsInDomain(vtkSMProperty* property) override;

protected:
  vtkSMExactGeometryDomain();
  ~vtkSMExactGeometryDomain() override;

  int ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element) override;

private:
  vtkSMExactGeometryDomain(const vtkSMExactGeometryDomain&) = delete;
  void operator=(const vtkSMExactGeometryDomain&) = delete;

  bool Inverse = false;
};

#endif
