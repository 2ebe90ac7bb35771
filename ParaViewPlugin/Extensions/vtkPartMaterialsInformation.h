/**
 * @class   vtkPartMaterialsInformation
 * @brief   reports to a client the parts in an output on the server by their names, with material, density
 * and mass
 *
 * Solids of one name are one part. For exact geometry (the output of a reader) the information has the
 * statements of the file; for the table of solids of Mass Properties, the masses. Runs no pipeline.
 */
#ifndef vtkPartMaterialsInformation_h
#define vtkPartMaterialsInformation_h

#include "smMaterialTable.h"            // for the parts
#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkPVInformation.h"

#include <vector> // for the parts

class SMPARAVIEWEXTENSIONS_EXPORT vtkPartMaterialsInformation : public vtkPVInformation
{
public:
  static vtkPartMaterialsInformation* New();
  vtkTypeMacro(vtkPartMaterialsInformation, vtkPVInformation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The output port to examine. Default: 0. */
  vtkSetMacro(PortNumber, int);
  vtkGetMacro(PortNumber, int);
  ///@}

#ifndef __VTK_WRAP__
  /** The parts in the order of their first solids. */
  const std::vector<sm::PartMaterial>& GetParts() const
  {
    return this->Parts;
  }
  void Clear()
  {
    this->Parts.clear();
  }
#endif

  void CopyFromObject(vtkObject* object) override;
  void AddInformation(vtkPVInformation* other) override;
  void CopyToStream(vtkClientServerStream* stream) override;
  void CopyFromStream(const vtkClientServerStream* stream) override;
  void CopyParametersToStream(vtkMultiProcessStream& stream) override;
  void CopyParametersFromStream(vtkMultiProcessStream& stream) override;

protected:
  vtkPartMaterialsInformation();
  ~vtkPartMaterialsInformation() override;

private:
  vtkPartMaterialsInformation(const vtkPartMaterialsInformation&) = delete;
  void operator=(const vtkPartMaterialsInformation&) = delete;

  int PortNumber = 0;
#ifndef __VTK_WRAP__
  std::vector<sm::PartMaterial> Parts;
#endif
};

#endif
