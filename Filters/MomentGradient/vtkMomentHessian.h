/**
 * @class   vtkMomentHessian
 * @brief   the Hessian of volume, first and second moments by control points, times a direction
 *
 * Computes sm::ComputeMomentHessianProduct() (smMomentHessian.h, with formulas, and where it is the Hessian
 * of the solid) for a vtkNURBSDataSet or a composite dataset with any number of them; for scripts. It runs on
 * the processor and needs no OpenGL. Coordinates are those of the world, L is the length unit, the density 1:
 * entries of quantity q have the unit L^(power of q - 1) for a direction in L.
 */
#ifndef vtkMomentHessian_h
#define vtkMomentHessian_h

#include "smFiltersMomentGradientModule.h"
#include "vtkObject.h"

#include <memory> // for the internals
#include <string> // for std::string

class vtkDataObject;
class vtkDoubleArray;

class SMFILTERSMOMENTGRADIENT_EXPORT vtkMomentHessian : public vtkObject
{
public:
  static vtkMomentHessian* New();
  vtkTypeMacro(vtkMomentHessian, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Adds a face that moves: solid and face by their indices from 0, and a displacement (3 components) for
   * each control point of its net, the index in v fastest. Faces that are not added stay. False if the array
   * is null or has other components; what does not fit the face makes Compute() fail. */
  bool AddDisplacements(int solid, int face, vtkDoubleArray* displacements);
  void ClearDisplacements();
  ///@}

  ///@{
  /** If on, coinciding control points are one variable, and have to move alike. If off, every control point
   * of every face is a variable of its own. Default: on. */
  vtkSetMacro(Tied, bool);
  vtkGetMacro(Tied, bool);
  ///@}

  ///@{
  /** Tolerance of the quadrature, relative to the area of the solid times powers of half its diagonal. In (0,
   * 1]; what is not in it makes Compute() fail. Default: 1e-9. */
  vtkSetMacro(RelativeTolerance, double);
  vtkGetMacro(RelativeTolerance, double);
  ///@}

  /** Computes the product. Returns false, with GetStatus() and GetReason(), if there is none. */
  bool Compute(vtkDataObject* model);

  ///@{
  /** Status of the last run ("ok", "open", ...), and why it is not "ok"; messages; the length unit. */
  std::string GetStatus() const;
  std::string GetReason() const;
  int GetNumberOfMessages() const;
  std::string GetMessage(int index) const;
  std::string GetLengthUnit() const;
  ///@}

  ///@{
  /**
   * Results for face `index` (from 0): Values and Bounds have a tuple of 3 x 10 numbers for each control
   * point, the index in v fastest, in the order of (GetCountU(), GetCountV(), 3, 10): by x, y, z; quantities
   * in the order of vtkMomentGradient::GetQuantityName(0 .. 9). Null, 0, -1 and false for an index that does
   * not exist.
   */
  int GetNumberOfFaces() const;
  vtkDoubleArray* GetValues(int index) const;
  vtkDoubleArray* GetBounds(int index) const;
  int GetCountU(int index) const;
  int GetCountV(int index) const;
  int GetSolid(int index) const;
  int GetFace(int index) const;
  /** True if the face is its whole net, and its border is tied to others: there it is the solid's Hessian. */
  bool HasTiedBorder(int index) const;
  ///@}

protected:
  vtkMomentHessian();
  ~vtkMomentHessian() override;

private:
  vtkMomentHessian(const vtkMomentHessian&) = delete;
  void operator=(const vtkMomentHessian&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Implementation;
  bool Tied = true;
  double RelativeTolerance = 1e-9;
};

#endif
