/**
 * @class   vtkSelectedPlacesInformation
 * @brief   tells a client what is selected in the tables and meshes of a filter on the server: solids, faces, edges
 *
 * The filter has the outputs of vtkSurfaceIntegralBase. Rows of its tables, or cells of its meshes, give the numbers of their solids and faces, the rows of
 * those faces, the lines of the edges, and a text with names, masses, areas and gaps. Runs no pipeline.
 */
#ifndef vtkSelectedPlacesInformation_h
#define vtkSelectedPlacesInformation_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkPVInformation.h"

#include <array>   // for the lines
#include <map>     // for the faces
#include <set>     // for the solids
#include <string>  // for the text
#include <utility> // for the cells
#include <vector>  // for the rows

class vtkPartitionedDataSetCollection;
class vtkTable;

class SMPARAVIEWEXTENSIONS_EXPORT vtkSelectedPlacesInformation : public vtkPVInformation
{
public:
  static vtkSelectedPlacesInformation* New();
  vtkTypeMacro(vtkSelectedPlacesInformation, vtkPVInformation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The ports of vtkSurfaceIntegralBase with the tables and the meshes. */
  enum Port
  {
    SolidsPort = 1,
    FacesPort = 3,
    EdgesPort = 4,
    MeshesPort = 5
  };

#ifndef __VTK_WRAP__
  /** The numbers, from 0, of the rows that are selected in the table on a port; those that the table does not have are left out. The row
   * of the total stands for all solids. */
  void SelectRows(Port table, const std::vector<vtkIdType>& rows);
  /** The solids that are selected in a view, and of single cells the number of the solid and that of the cell. */
  void SelectMeshes(
    const std::set<vtkIdType>& solids, const std::vector<std::pair<vtkIdType, vtkIdType>>& cells);

  /** The numbers of the solids that are selected themselves, not by faces or edges. */
  const std::set<vtkIdType>& GetSolids() const
  {
    return this->Solids;
  }
  /** The indices of the faces that are selected, by the number of their solid. */
  const std::map<vtkIdType, std::set<vtkIdType>>& GetFaces() const
  {
    return this->Faces;
  }
  /** The cells of the faces whose rows are selected: number of the solid, and cell. */
  const std::vector<std::pair<vtkIdType, vtkIdType>>& GetFaceCells() const
  {
    return this->FaceCells;
  }
  /** The rows of these faces in the table of faces. */
  const std::vector<vtkIdType>& GetFaceRows() const
  {
    return this->FaceRows;
  }
  /** Points of the edges that are selected: world coordinates and the number of the line. */
  const std::vector<std::array<double, 4>>& GetLines() const
  {
    return this->Lines;
  }
  /** Names, masses, areas and gaps of what is selected, in lines; empty if nothing is. */
  const std::string& GetText() const
  {
    return this->Text;
  }
#endif

  void CopyFromObject(vtkObject* object) override;
  void AddInformation(vtkPVInformation* other) override;
  void CopyToStream(vtkClientServerStream* stream) override;
  void CopyFromStream(const vtkClientServerStream* stream) override;
  void CopyParametersToStream(vtkMultiProcessStream& stream) override;
  void CopyParametersFromStream(vtkMultiProcessStream& stream) override;

protected:
  vtkSelectedPlacesInformation();
  ~vtkSelectedPlacesInformation() override;

private:
  vtkSelectedPlacesInformation(const vtkSelectedPlacesInformation&) = delete;
  void operator=(const vtkSelectedPlacesInformation&) = delete;

#ifndef __VTK_WRAP__
  void FindSolids(vtkTable* solids);
  void FindFacesOfRows(vtkTable* faces);
  void FindCellsOfFaces(vtkPartitionedDataSetCollection* meshes);
  void FindFacesOfCells(vtkPartitionedDataSetCollection* meshes, vtkTable* faces);
  void DrawEdges(vtkTable* edges, vtkPartitionedDataSetCollection* meshes);

  /// What to look at.
  Port Table = MeshesPort;
  std::vector<vtkIdType> Rows;
  std::vector<std::pair<vtkIdType, vtkIdType>> Cells;
  /// What was found.
  std::set<vtkIdType> Solids;
  std::map<vtkIdType, std::set<vtkIdType>> Faces;
  std::vector<std::pair<vtkIdType, vtkIdType>> FaceCells;
  std::vector<vtkIdType> FaceRows;
  std::vector<std::array<double, 4>> Lines;
  std::string Text;
#endif
};

#endif
