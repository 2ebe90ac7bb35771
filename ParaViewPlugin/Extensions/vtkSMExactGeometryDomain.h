/**
 * @class   vtkSMExactGeometryDomain
 * @brief   accepts inputs that hold exact NURBS geometry
 *
 * For the input property of filters that need the exact faces: `<ExactGeometryDomain name="exact_geometry"/>`. It asks the server
 * (vtkExactGeometryInformation) on every check, so that a part whose points were changed, which keeps its class and loses its faces, is
 * refused. ParaView 5.11 greys out a filter that a domain refuses and has no words for it from a plugin; the filters'
 * own error says what to connect.
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

  /** IN_DOMAIN when the (unchecked) input of the property holds exact geometry. */
  int IsInDomain(vtkSMProperty* property) override;

protected:
  vtkSMExactGeometryDomain();
  ~vtkSMExactGeometryDomain() override;

private:
  vtkSMExactGeometryDomain(const vtkSMExactGeometryDomain&) = delete;
  void operator=(const vtkSMExactGeometryDomain&) = delete;
};

#endif
