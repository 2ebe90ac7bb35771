/**
 * @class   vtkLabeledSolidsRepresentation
 * @brief   draws solids, with their names or names and masses as labels, and edges that are selected
 *
 * A label begins in the middle of its solid's box. The 50 largest solids that are not hidden have labels;
 * where two would overlap, the larger solid keeps its own. The mass is that of the cell array
 * MassOfWholeSolid, with four digits. Labels and selected edges are in front of everything, drawn by the
 * process with the window, and not at all while a server renders for it.
 */
#ifndef vtkLabeledSolidsRepresentation_h
#define vtkLabeledSolidsRepresentation_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkNew.h"                     // for the labels
#include "vtkPVCompositeRepresentation.h"

class vtkActor;
class vtkActor2D;
class vtkCompositeDataDisplayAttributes;
class vtkDataObject;
class vtkLabelPlacementMapper;
class vtkPolyData;
class vtkTextProperty;

class SMPARAVIEWEXTENSIONS_EXPORT vtkLabeledSolidsRepresentation : public vtkPVCompositeRepresentation
{
public:
  static vtkLabeledSolidsRepresentation* New();
  vtkTypeMacro(vtkLabeledSolidsRepresentation, vtkPVCompositeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum LabelKind
  {
    NoLabels = 0,
    Names = 1,
    NamesAndMasses = 2
  };

  ///@{
  /** Content of the labels, a LabelKind, clamped. A solid without a mass has its name only. Default:
   * NoLabels. */
  vtkSetClampMacro(PartLabels, int, NoLabels, NamesAndMasses);
  vtkGetMacro(PartLabels, int);
  ///@}

  ///@{
  /** Colour of the labels: red, green and blue, each from 0 to 1. Default: 1 1 1. */
  vtkSetVector3Macro(LabelColor, double);
  vtkGetVector3Macro(LabelColor, double);
  ///@}

  ///@{
  /** Height of the labels in points, 1 to 100, clamped. Default: 14. */
  vtkSetClampMacro(LabelFontSize, int, 1, 100);
  vtkGetMacro(LabelFontSize, int);
  ///@}

  /** The lines of the edges that are drawn as selected, in world coordinates, as FormatPolylines() of
   * smPolylineText.h writes them. Default: none. */
  void SetSelectedEdges(const char* polylines);

  void SetVisibility(bool visible) override;
  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkLabeledSolidsRepresentation();
  ~vtkLabeledSolidsRepresentation() override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkLabeledSolidsRepresentation(const vtkLabeledSolidsRepresentation&) = delete;
  void operator=(const vtkLabeledSolidsRepresentation&) = delete;

  void MakeLabels(vtkDataObject* data);
  /// Returns the attributes with the blocks that the user has hidden; may be null.
  vtkCompositeDataDisplayAttributes* GetBlockAttributes();

  int PartLabels = NoLabels;
  double LabelColor[3] = { 1.0, 1.0, 1.0 };
  int LabelFontSize = 14;
  /// A point for each label, with its text and its priority.
  vtkNew<vtkPolyData> LabelPoints;
  vtkNew<vtkTextProperty> Text;
  vtkNew<vtkLabelPlacementMapper> Mapper;
  vtkNew<vtkActor2D> Labels;
  vtkNew<vtkPolyData> SelectedEdges;
  vtkNew<vtkActor> SelectedEdgesActor;
};

#endif
