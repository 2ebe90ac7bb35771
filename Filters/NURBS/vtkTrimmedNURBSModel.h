/**
 * @class   vtkTrimmedNURBSModel
 * @brief   the exact geometry of one body: trimmed NURBS faces joined along edges
 *
 * A model is one solid or one free shell, in the coordinates of its own part. It is shared by all its
 * instances (vtkNURBSDataSet holds a model and the placement of the instance) and its faces are immutable
 * values shared by pointer (smFace.h), so a shallow copy costs a vector of pointers.
 *
 * Every coordinate in the faces and edges is relative to Origin, so that a part far from the file's
 * origin keeps its digits: position in part coordinates = Origin + stored coordinate.
 *
 * Lengths are in LengthUnit. Not thread safe while being changed; reading from several threads is safe.
 */
#ifndef vtkTrimmedNURBSModel_h
#define vtkTrimmedNURBSModel_h

#include "smFiltersNURBSModule.h"
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for the scale mesh

#include "smFace.h" // for FacePointer

#include <memory> // for std::shared_ptr
#include <string> // for std::string
#include <vector> // for std::vector

class vtkDataArray;
class vtkPolyData;

class SMFILTERSNURBS_EXPORT vtkTrimmedNURBSModel : public vtkObject
{
public:
  static vtkTrimmedNURBSModel* New();
  vtkTypeMacro(vtkTrimmedNURBSModel, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Kind of the model: a solid (its faces should close) or a free shell (a surface with area only). */
  enum BodyType
  {
    SOLID = 0,
    SHELL = 1
  };
  vtkSetClampMacro(Body, int, SOLID, SHELL);
  vtkGetMacro(Body, int);

  /** Product or body name from the file; may be empty. */
  vtkSetMacro(Name, std::string);
  vtkGetMacro(Name, std::string);

  /** Entity number of the body in the file (1234 for #1234); 0 when it has none. */
  vtkSetMacro(FileId, vtkTypeInt64);
  vtkGetMacro(FileId, vtkTypeInt64);

  /** Unit of every length: "mm" by default. */
  vtkSetMacro(LengthUnit, std::string);
  vtkGetMacro(LengthUnit, std::string);

  /** Unit of the file that the body was read from, as LengthUnit names it; empty when it was read from none,
   * or in a unit without a name here. A writer saves in it. */
  vtkSetMacro(FileUnit, std::string);
  vtkGetMacro(FileUnit, std::string);

  ///@{
  /** Material name and density (kg/m^3) the file states; empty and 0 when it states none. A density that is
   * neither 0 nor from 1e-200 to 1e200 is an error, and changes nothing. */
  vtkSetMacro(Material, std::string);
  vtkGetMacro(Material, std::string);
  void SetDensity(double density);
  vtkGetMacro(Density, double);
  ///@}

  /** Volume (LengthUnit^3) and area (LengthUnit^2) that the originating CAD system wrote into the file; NaN
   * if it wrote none. */
  vtkSetMacro(FileVolume, double);
  vtkGetMacro(FileVolume, double);
  vtkSetMacro(FileArea, double);
  vtkGetMacro(FileArea, double);

  /** Accuracy of coordinates that the file states for the body (UNCERTAINTY_MEASURE_WITH_UNIT), in
   * LengthUnit; 0 when it states none. Gaps up to this width do not make a result suspect; see
   * vtkSurfaceIntegralBase::SetGapLimit(). */
  vtkSetMacro(FileUncertainty, double);
  vtkGetMacro(FileUncertainty, double);

  /** Faces of the file that could not be carried over and are missing here; GetMessages() names them. Default
   * 0. */
  vtkSetMacro(NumberOfMissingFaces, int);
  vtkGetMacro(NumberOfMissingFaces, int);

  ///@{
  /**
   * Places where the faces here are not what the file states, besides missing ones: loops that close neither
   * within the tolerances of their vertices and edges nor within 1e-5 of the body's size, loops that go round
   * a periodic surface without a seam, edges and coedges left out, edges without a curve on their face, edges
   * that end 1e-2 of the body's size or more away from their vertices, scales and mirrors of the body's
   * instances that were dropped. 0 for a sound body; GetMessages() names them. Default: 0. Clamped to >= 0.
   */
  vtkSetClampMacro(NumberOfDefects, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfDefects, int);
  ///@}

  /** Part coordinates of the point that stored coordinates are relative to. Default: 0 0 0. */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);

  /** xmin, xmax, ymin … of the body relative to Origin. It fixes the scale and the reference point of
   * integration, so it belongs to the model and does not follow an edit of a face. Default: zeros. */
  vtkSetVector6Macro(LocalBounds, double);
  vtkGetVector6Macro(LocalBounds, double);

  /** Fixed scales that tolerances are relative to: about the volume and the area of the body, from a coarse
   * mesh that does not depend on the one that is shown. They set the accuracy asked of each face, not the
   * result. 0: not known, use LocalBounds. */
  vtkSetMacro(VolumeScale, double);
  vtkGetMacro(VolumeScale, double);
  vtkSetMacro(AreaScale, double);
  vtkGetMacro(AreaScale, double);

  ///@{
  /**
   * The mesh that the scales were taken from, in part coordinates, with the arrays of vtkNURBSDataSet; all
   * instances share it. Filters judge by it whether shells enclose each other or cross themselves, so that
   * their results do not depend on what is shown. Null, the default: there is none, and the display mesh
   * takes its place. A whole sphere is coarse in it: its centre and radius count (smWholeSphere.h). Setting,
   * exchanging or adding faces drops it. Set the faces first.
   */
  void SetScaleMesh(vtkPolyData* mesh);
  vtkPolyData* GetScaleMesh() const;
  ///@}

  vtkIdType GetNumberOfFaces() const { return static_cast<vtkIdType>(this->Faces.size()); }
  /** Number of distinct edges that the faces use. */
  vtkIdType GetNumberOfEdges() const;

  ///@{
  /**
   * Builds the body from arrays: edges first, then faces, then the coedges of each face's loops. C++ can make
   * sm::Face objects and hand them to SetFaces() instead. Coordinates are relative to Origin, in LengthUnit.
   * Documentation/Libraries.md, "Build a dataset by hand", has a complete example.
   *
   * Curves are piecewise polynomials in Bernstein form, all pieces of one degree d (at most 25): `breaks`
   * holds the n + 1 increasing parameters where the n pieces begin and end, `coefficients` holds n d + 1
   * tuples; the last coefficient of a piece is the first of the next. A curve that is not polynomial, a
   * circle for example, has to be fitted; `residual` is then the largest distance of the fit from the curve
   * in any coordinate (not negative, 0: exact), and the bounds of the results include it.
   *
   * AddEdge() adds the curve in space (3 components) that the faces on both sides of an edge share; its first
   * and last points are the vertices. One coefficient over one interval makes a degenerate edge, the pole of
   * a sphere. Any curve near the faces' common boundary will do: the integrals close the gap between a face
   * and its edge.
   *
   * AddFace() adds a B-spline surface. Knots do not decrease; there are (degree + 1 + number of control
   * points) of them in each direction; where a knot occurs more often than the degree the points on both
   * sides have to be equal. `controlPoints` holds all control points, u fastest: 4 components are homogeneous
   * coordinates (w x, w y, w z, w) with w > 0, 3 components are points of weight 1. With `reversed` the
   * outward normal is -(Su x Sv). Without a coedge the face covers the whole domain of the surface, but only
   * coedges connect it with other faces: a solid has coedges along all boundaries.
   *
   * AddCoedge() appends a use of the edge to a loop of the face: 0 to the number of its loops, which begins a
   * new one. Coedges of a loop follow each other counter-clockwise in the (u,v) plane, with the face on their
   * left, whatever `reversed` of the face says; holes run clockwise. `reversed` says that the loop runs
   * against the parameter of the edge. The trim curve has 2 components (u, v) and runs over the same
   * parameter range as the edge, in the direction of the edge. The face becomes a new face with a new id.
   *
   * Both Add methods return the index of what they added, AddCoedge() returns true. A missing array, a wrong
   * number of components or values, a value that is not finite, an index that does not exist, and whatever
   * NURBSSurface::Check() refuses are errors: they return -1 or false and change nothing.
   */
  int AddEdge(vtkDataArray* breaks, vtkDataArray* coefficients, double residual = 0.0);
  int AddFace(int degreeU, vtkDataArray* knotsU, int degreeV, vtkDataArray* knotsV,
    vtkDataArray* controlPoints, bool reversed = false);
  bool AddCoedge(int face, int loop, int edge, bool reversed, vtkDataArray* breaks,
    vtkDataArray* coefficients, double residual = 0.0);
  ///@}

#ifndef __VTK_WRAP__
  const std::vector<sm::FacePointer>& GetFaces() const
  {
    return this->Faces;
  }
  void SetFaces(std::vector<sm::FacePointer> faces);
  /** Exchanges one face; the model is modified. */
  void SetFace(vtkIdType index, sm::FacePointer face);

  ///@{
  /**
   * The faces of another model with the same geometry relative to its Origin, bit for bit, and in the same
   * order: only ids, entity numbers, names, colours and messages differ. Filters integrate them once for all
   * models that have them. Setting, exchanging or adding faces drops them; set the faces first. The default,
   * an empty vector, stands for the model's own faces. Another number of faces than that of the model is an
   * error, and changes nothing.
   */
  void SetEqualFaces(std::vector<sm::FacePointer> faces);
  const std::vector<sm::FacePointer>& GetEqualFaces() const
  {
    return this->EqualFaces.empty() ? this->Faces : this->EqualFaces;
  }
  ///@}

  /** Number of shells of a solid that enclose volume, all others being voids inside them; a STEP file has one
   * for each solid. A result is suspect if another number lies outside all others. 0, the default: not known.
   * Clamped to >= 0. */
  vtkSetClampMacro(NumberOfOuterShells, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfOuterShells, int);

  /** Shells as lists of face indices; the reader keeps the order of the file. */
  const std::vector<std::vector<int>>& GetShells() const
  {
    return this->Shells;
  }
  void SetShells(std::vector<std::vector<int>> shells);

  /** Notes of the reader on the body, one sentence each. */
  const std::vector<std::string>& GetMessages() const
  {
    return this->Messages;
  }
  void SetMessages(std::vector<std::string> messages);
#endif

  /** Shares all faces of `source` and copies the rest. */
  void ShallowCopy(vtkTrimmedNURBSModel* source);

  /** Memory of faces, edges and the scale mesh in kibibytes. Shared faces count in every model that uses
   * them. */
  unsigned long GetActualMemorySize() const;

protected:
  vtkTrimmedNURBSModel();
  ~vtkTrimmedNURBSModel() override;

private:
  vtkTrimmedNURBSModel(const vtkTrimmedNURBSModel&) = delete;
  void operator=(const vtkTrimmedNURBSModel&) = delete;

  /// Drops what belongs to the faces as they were.
  void ChangeFaces();

  int Body = SOLID;
  std::string Name;
  vtkTypeInt64 FileId = 0;
  std::string LengthUnit = "mm";
  std::string FileUnit;
  std::string Material;
  double Density = 0.0;
  double FileVolume;
  double FileArea;
  double FileUncertainty = 0.0;
  int NumberOfMissingFaces = 0;
  int NumberOfDefects = 0;
  int NumberOfOuterShells = 0;
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double LocalBounds[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
  double VolumeScale = 0.0;
  double AreaScale = 0.0;
  vtkSmartPointer<vtkPolyData> ScaleMesh;
  std::vector<sm::FacePointer> Faces;
  std::vector<sm::FacePointer> EqualFaces;
  std::vector<std::vector<int>> Shells;
  std::vector<std::string> Messages;
  /// The edges added by AddEdge(), in the order of their indices.
  std::vector<std::shared_ptr<const sm::Edge>> AddedEdges;
  // The face that AddCoedge() changed last, which only this model has made; shared with Faces.
  std::shared_ptr<sm::Face> GrowingFace;
};

#endif
