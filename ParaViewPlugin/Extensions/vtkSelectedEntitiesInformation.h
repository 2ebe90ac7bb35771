/**
 * @class   vtkSelectedEntitiesInformation
 * @brief   reports to a client which solids, faces and edges are selected in the tables and meshes of a
 * filter on the server
 *
 * The filter has the outputs of vtkSurfaceIntegralBase. A selection of rows of its tables, or of cells of its
 * meshes, gives the numbers of solids and faces, the rows of those faces, the elements to highlight in a
 * view, the lines of the edges, and a text with names, masses, areas and gaps. Runs no pipeline.
 */
#ifndef vtkSelectedEntitiesInformation_h
#define vtkSelectedEntitiesInformation_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkPVInformation.h"

#ifndef __VTK_WRAP__
#include "smSelectionTerms.h"
#endif

#include <map>    // for the faces
#include <set>    // for the solids
#include <string> // for the text
#include <vector> // for the rows

class vtkDataArray;
class vtkPartitionedDataSetCollection;
class vtkTable;

class SMPARAVIEWEXTENSIONS_EXPORT vtkSelectedEntitiesInformation : public vtkPVInformation
{
public:
  static vtkSelectedEntitiesInformation* New();
  vtkTypeMacro(vtkSelectedEntitiesInformation, vtkPVInformation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The ports of vtkSurfaceIntegralBase with the tables and the meshes, and that of the clipped meshes of
   * vtkSolidSection. */
  enum Port
  {
    SolidsPort = 1,
    FacesPort = 3,
    EdgesPort = 4,
    MeshesPort = 5,
    ClippedPort = 7
  };

#ifndef __VTK_WRAP__
  /// The elements that a view highlights: whole solids, and cells by the number of their solid.
  struct Highlight
  {
    std::set<vtkIdType> Solids;
    std::map<vtkIdType, std::vector<vtkIdType>> Cells;
    bool operator==(const Highlight& other) const
    {
      return this->Solids == other.Solids && this->Cells == other.Cells;
    }
  };

  /**
   * Sets the selection on a port: rows of its table, or cells of its meshes. The row of the total stands for
   * all solids. `meshes` is the port whose cells are highlighted for rows: MeshesPort or ClippedPort.
   * Default: nothing.
   */
  void Select(Port port, const sm::SelectionTerms& terms, Port meshes = MeshesPort);
  /**
   * Sets the solids and faces that were selected before. A face with some selected cells is selected; but if
   * it was so before and lacks cells now, the user has deselected it. Default: none.
   */
  void SetBefore(const std::set<vtkIdType>& solids, const std::map<vtkIdType, std::set<vtkIdType>>& faces);

  /** Returns the numbers of the solids that are selected themselves, not by faces or edges. */
  const std::set<vtkIdType>& GetSolids() const
  {
    return this->Solids;
  }
  /** Returns the indices of the selected faces, by the number of their solid. */
  const std::map<vtkIdType, std::set<vtkIdType>>& GetFaces() const
  {
    return this->Faces;
  }
  /** Returns the rows of these faces in the table of faces. */
  const std::vector<vtkIdType>& GetFaceRows() const
  {
    return this->FaceRows;
  }
  /** Returns the column Id of all solids that are selected or have selected faces. */
  const std::vector<std::string>& GetSolidIds() const
  {
    return this->SolidIds;
  }
  /**
   * Returns the elements by which a view shows the selection: all cells of selected faces. A solid all of
   * whose faces are selected is highlighted as a whole, and so are all solids of selected rows if there are
   * too many cells for ParaView; of picked cells the result is empty then. Empty for edges. In clipped meshes
   * the section of a solid is a face with the index -1.
   */
  const Highlight& GetHighlight() const
  {
    return this->Shown;
  }
  /** Returns the lines of the selected edges, in the format of FormatPolylines() (smPolylineText.h). */
  const std::string& GetEdgeLines() const
  {
    return this->EdgeLines;
  }
  /** Returns a text with names, masses, areas and gaps of the selection, in lines; empty if nothing is
   * selected. */
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
  vtkSelectedEntitiesInformation();
  ~vtkSelectedEntitiesInformation() override;

private:
  vtkSelectedEntitiesInformation(const vtkSelectedEntitiesInformation&) = delete;
  void operator=(const vtkSelectedEntitiesInformation&) = delete;

#ifndef __VTK_WRAP__
  void Clear();
  std::vector<vtkIdType> FindRows(vtkTable* table) const;
  void FindSolidsOfRows(vtkTable* solids);
  void FindFacesOfRows(vtkTable* faces);
  void FindSolidsAndFacesOfCells(vtkPartitionedDataSetCollection* meshes, vtkTable* faces);
  void FindHighlight(vtkPartitionedDataSetCollection* meshes);
  void FindEdges(vtkTable* solids, vtkTable* edges, vtkPartitionedDataSetCollection* meshes);
  void FindSolidIds(vtkTable* solids);

  /// Selects the faces of some cells of a solid.
  void AddFacesOfCells(vtkIdType solid, const std::vector<vtkIdType>& cells, vtkDataArray* index);

  /// The request: port and selection, and what was selected before.
  Port Selected = MeshesPort;
  Port Meshes = MeshesPort;
  sm::SelectionTerms Terms;
  std::set<vtkIdType> SolidsBefore;
  std::map<vtkIdType, std::set<vtkIdType>> FacesBefore;
  /// The results.
  std::set<vtkIdType> Solids;
  std::map<vtkIdType, std::set<vtkIdType>> Faces;
  std::vector<vtkIdType> FaceRows;
  std::vector<std::string> SolidIds;
  Highlight Shown;
  std::string EdgeLines;
  std::string Text;
#endif
};

#endif
