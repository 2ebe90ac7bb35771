/**
 * @class   vtkFaceRowsInformation
 * @brief   tells a client which faces rows of a table of faces on the server stand for
 *
 * The table has the columns Solid and FaceIndex. Runs no pipeline.
 */
#ifndef vtkFaceRowsInformation_h
#define vtkFaceRowsInformation_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkPVInformation.h"

#include <map>    // for the faces
#include <set>    // for the faces
#include <vector> // for the rows

class SMPARAVIEWEXTENSIONS_EXPORT vtkFaceRowsInformation : public vtkPVInformation
{
public:
  static vtkFaceRowsInformation* New();
  vtkTypeMacro(vtkFaceRowsInformation, vtkPVInformation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The output port with the table. Default: 0. */
  vtkSetMacro(PortNumber, int);
  vtkGetMacro(PortNumber, int);
  ///@}

#ifndef __VTK_WRAP__
  /** The numbers of rows to look at, from 0; a row that the table does not have is left out. Default: none. */
  void SetRows(const std::vector<vtkIdType>& rows)
  {
    this->Rows = rows;
  }

  /** The indices of faces, by the number of their solid. */
  const std::map<int, std::set<int>>& GetFaces() const
  {
    return this->Faces;
  }
#endif

  void CopyFromObject(vtkObject* object) override;
  void AddInformation(vtkPVInformation* other) override;
  void CopyToStream(vtkClientServerStream* stream) override;
  void CopyFromStream(const vtkClientServerStream* stream) override;
  void CopyParametersToStream(vtkMultiProcessStream& stream) override;
  void CopyParametersFromStream(vtkMultiProcessStream& stream) override;

protected:
  vtkFaceRowsInformation();
  ~vtkFaceRowsInformation() override;

private:
  vtkFaceRowsInformation(const vtkFaceRowsInformation&) = delete;
  void operator=(const vtkFaceRowsInformation&) = delete;

  int PortNumber = 0;
#ifndef __VTK_WRAP__
  std::vector<vtkIdType> Rows;
  std::map<int, std::set<int>> Faces;
#endif
};

#endif
