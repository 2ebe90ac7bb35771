/**
 * @class   vtkExactGeometryInformation
 * @brief   reports to a client whether an algorithm's output on the server holds exact NURBS geometry, and
 * its length unit
 *
 * ParaView's own data information knows classes of VTK only. This class examines the data object: true when
 * it, or a leaf of it, is a vtkNURBSDataSet with a model, on any rank of a parallel server. Runs no pipeline.
 */
#ifndef vtkExactGeometryInformation_h
#define vtkExactGeometryInformation_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkPVInformation.h"

#include <string> // for the unit

class SMPARAVIEWEXTENSIONS_EXPORT vtkExactGeometryInformation : public vtkPVInformation
{
public:
  static vtkExactGeometryInformation* New();
  vtkTypeMacro(vtkExactGeometryInformation, vtkPVInformation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The output port to examine. Default: 0. */
  vtkSetMacro(PortNumber, int);
  vtkGetMacro(PortNumber, int);
  ///@}

  /** True if CopyFromObject() found exact geometry. */
  vtkGetMacro(HasExactGeometry, bool);

  /** Unit of lengths of all exact leaves; empty where they differ, and without exact geometry. */
  vtkGetMacro(LengthUnit, std::string);

  void CopyFromObject(vtkObject* object) override;
  void AddInformation(vtkPVInformation* other) override;
  void CopyToStream(vtkClientServerStream* stream) override;
  void CopyFromStream(const vtkClientServerStream* stream) override;
  void CopyParametersToStream(vtkMultiProcessStream& stream) override;
  void CopyParametersFromStream(vtkMultiProcessStream& stream) override;

protected:
  vtkExactGeometryInformation();
  ~vtkExactGeometryInformation() override;

private:
  vtkExactGeometryInformation(const vtkExactGeometryInformation&) = delete;
  void operator=(const vtkExactGeometryInformation&) = delete;

  int PortNumber = 0;
  bool HasExactGeometry = false;
  std::string LengthUnit;
};

#endif
