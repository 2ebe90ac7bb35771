/**
 * @class   vtkNURBSDeform
 * @brief   deforms solids by moving the control points of their exact faces
 *
 * Every chosen vtkNURBSDataSet of the input (one, or the leaves of a composite dataset) of which a control
 * point moves gets a new model, which shares the unchanged faces; other leaves keep their model. Structure,
 * names and assembly are kept, and the input is not changed. There are two modes:
 *
 * DISPLACE: control points of the chosen faces move by Displacement (1 - r^2)^3, r = distance from Center /
 * Radius, up to r = 1: twice continuously differentiable. World coordinates; an instance that is moved gets a
 * model of its own.
 *
 * LATTICE: free-form deformation (Sederberg and Parry, "Free-form deformation of solid geometric models",
 * SIGGRAPH 1986). Control points of all faces move by sum B_i(x) B_j(y) B_k(z) d_ijk, Bernstein polynomials
 * over the box of the solid (LocalBounds of its model), with the d_ijk given; coordinates and displacements
 * are those of the part, and instances keep sharing one model.
 *
 * A closed solid stays closed where faces meet along whole boundary rows of the same control points, however
 * they are oriented: rows, edge and vertices move together. Elsewhere (trimmed faces, rows of different
 * degree or knots) the coefficients of the edge's curve are mapped like control points. Mapping control
 * points is not the same as mapping points, so a gap of about h^2/8 times the second derivatives of the map
 * opens between face and edge, where h is the distance of control points. Ribbons and caps close this gap, so
 * volume and moments are those of a closed surface. GetNumberOfOpenedEdges() and GetMaxGap() measure the
 * gaps; MaxGap and ClosureCorrection of vtkMassPropertiesGPU measure their effect. A bump of 5 % of the
 * part's size with a radius of 0.6 sizes opens no gap on a sphere, a torus and blocks of Bezier faces, one of
 * 0.6 % of the size on Examples/Models/sample_part.step, and one of 5 % on a slanted hole in a block, whose
 * faces have four control points.
 *
 * Display points that have FaceIndex and Parameters are evaluated again on the new faces, with their normals,
 * by a vtkNURBSPointEvaluator: on the GPU where the module RenderingNURBS is loaded and there is OpenGL 4.3
 * with doubles, else on the CPU by vtkSMPTools. Points without these arrays are mapped like control points,
 * which places them near the faces but not on them. LocalBounds and scales of a model do not change, nor do
 * the tolerances to which faces are integrated. In a parallel run a piece without solids is not an error, and
 * an error leaves an empty output.
 *
 * Not thread safe.
 */
#ifndef vtkNURBSDeform_h
#define vtkNURBSDeform_h

#include "smFiltersNURBSEditModule.h"
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkSmartPointer.h" // for the evaluator

#include <array>  // for the lattice
#include <map>    // for the lattice
#include <vector> // for the faces

class vtkNURBSPointEvaluator;

class SMFILTERSNURBSEDIT_EXPORT vtkNURBSDeform : public vtkPassInputTypeAlgorithm
{
public:
  static vtkNURBSDeform* New();
  vtkTypeMacro(vtkNURBSDeform, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The displacement of control points. */
  enum ModeType
  {
    DISPLACE = 0,
    LATTICE = 1
  };

  ///@{
  /** The mode. Values outside the enumeration are clamped. Default: DISPLACE. */
  vtkSetClampMacro(Mode, int, DISPLACE, LATTICE);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /** With DISPLACE: the displacement at the centre, world coordinates, in the input's length unit. Default: 0
   * 0 0. */
  vtkSetVector3Macro(Displacement, double);
  vtkGetVector3Macro(Displacement, double);
  ///@}

  ///@{
  /** With DISPLACE: the point where the displacement is largest, world coordinates. Default: 0 0 0. */
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /** With DISPLACE: the distance from the centre, a length, beyond which nothing moves; 0: everything moves
   * alike. Clamped to
   * >= 0. Default: 0. */
  vtkSetClampMacro(Radius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /** With DISPLACE: faces by their index, as in the array FaceIndex, of every solid that is chosen. None: all
   * faces. An index that no chosen solid has is reported as an error by the next run; a negative one is
   * reported at once and not added. Default: none. */
  void AddFace(int index);
  void RemoveAllFaces();
  int GetNumberOfFaces() const;
  ///@}

  ///@{
  /** The solid to deform, counted from 0 over the leaves with exact geometry; -1: all. A solid that does not
   * exist is an error. Clamped to >= -1. Default: -1. */
  vtkSetClampMacro(Solid, int, -1, VTK_INT_MAX);
  vtkGetMacro(Solid, int);
  ///@}

  ///@{
  /** The same by the number in the column Id of the tables, counted from 1; 0 or less: all. Default: 0. */
  void SetSolidId(int id) { this->SetSolid(id <= 0 ? -1 : id - 1); }
  int GetSolidId() { return this->Solid + 1; }
  ///@}

  ///@{
  /** With DISPLACE: faces that were not chosen follow along boundary rows that they share with chosen ones.
   * Off: the chosen faces leave their neighbours, and the solid opens. Default: on. */
  vtkSetMacro(KeepClosed, bool);
  vtkGetMacro(KeepClosed, bool);
  vtkBooleanMacro(KeepClosed, bool);
  ///@}

  ///@{
  /** With LATTICE: the number of its points in x, y and z, each clamped to 2 .. 10. Displacements of points
   * that are not in it are ignored. Default: 2 2 2. */
  void SetLatticeSize(int x, int y, int z);
  void SetLatticeSize(const int size[3]) { this->SetLatticeSize(size[0], size[1], size[2]); }
  vtkGetVector3Macro(LatticeSize, int);
  ///@}

  ///@{
  /** With LATTICE: displacement of point i, j, k, counted from 0, in the model's length unit. Default: none,
   * all are 0. */
  void SetLatticeDisplacement(int i, int j, int k, double x, double y, double z);
  void ClearLatticeDisplacements();
  /** The same for callers that pass all arguments as doubles, such as server manager properties; i, j and k
   * are rounded. */
  void AddLatticeDisplacement(double i, double j, double k, double x, double y, double z);
  ///@}

  ///@{
  /** The evaluator of the display points. Its getters report on the leaf that was updated last. Set its
   * window, context or backend before the first run. Several filters may share one evaluator. Null (default):
   * the filter makes its own. */
  void SetPointEvaluator(vtkNURBSPointEvaluator* evaluator);
  vtkNURBSPointEvaluator* GetPointEvaluator();
  ///@}

  /** Includes the modification time of the evaluator, so that a change of its backend executes the filter. */
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * Results of the last run: the number of edges from which a face moved away, by more than 1e-12 of the
   * solid's size, and the widest such gap, a length. 0 where every solid is as closed as before.
   */
  vtkGetMacro(NumberOfOpenedEdges, int);
  vtkGetMacro(MaxGap, double);
  ///@}
  ///@{
  /** Returns the number of new faces of the last run; those of a shared model count once. */
  vtkGetMacro(NumberOfChangedFaces, int);
  ///@}

  ///@{
  /**
   * Number of time steps of the output, at the times 0 to 1 at equal distances; at time t the displacement,
   * or those of the lattice, are multiplied by t. Clamped to 0 .. 100000. Below 2 (default: 0): no times, and
   * the whole edit.
   */
  vtkSetClampMacro(TimeSteps, int, 0, 100000);
  vtkGetMacro(TimeSteps, int);
  ///@}

  ///@{
  /** Updates the filter, and also requests the input's display mesh, as a connected view does. */
  using vtkPassInputTypeAlgorithm::Update;
  void Update(int port) override;
  vtkTypeBool Update(int port, vtkInformationVector* requests) override;
  ///@}

  /** Reports to the input whether its display mesh is needed, see smMeshDemand.h. */
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputs,
    vtkInformationVector* outputs, int port, vtkMTimeType* time) override;

protected:
  vtkNURBSDeform();
  ~vtkNURBSDeform() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkNURBSDeform(const vtkNURBSDeform&) = delete;
  void operator=(const vtkNURBSDeform&) = delete;

  struct Run;
  // RequestData() without the handling of exceptions; false when the output must be empty.
  bool DeformInput(vtkDataObject* input, int piece, double share, vtkDataObject* output);

  int Mode = DISPLACE;
  double Displacement[3] = { 0.0, 0.0, 0.0 };
  double Center[3] = { 0.0, 0.0, 0.0 };
  double Radius = 0.0;
  std::vector<int> Faces;
  int Solid = -1;
  bool KeepClosed = true;
  int TimeSteps = 0;
  int LatticeSize[3] = { 2, 2, 2 };
  std::map<std::array<int, 3>, std::array<double, 3>> LatticeDisplacements;
  vtkSmartPointer<vtkNURBSPointEvaluator> PointEvaluator;
  int NumberOfOpenedEdges = 0;
  double MaxGap = 0.0;
  int NumberOfChangedFaces = 0;
};

#endif
