/**
 * @class   vtkVariantMoments
 * @brief   volume, first and second moments of many variants of one solid, for scripts
 *
 * A base model and directions in which its control points move, each a moved model: the variant of c_1 ...
 * c_K has the control points P_0 + sum c_k D_k, see smVariantShape.h. Build() integrates once, Evaluate()
 * takes any number of variants. Moments are the signed volume, the integrals of x y z, and of xx yy zz xy yz
 * xz, relative to GetReference(), in the model's length unit; bounds are those of smVariantPolynomial.h.
 *
 * A call that fails returns false, GetMessage() has the reason, and nothing is an error event. Not thread
 * safe.
 */
#ifndef vtkVariantMoments_h
#define vtkVariantMoments_h

#include "smFiltersVariantsModule.h"
#include "vtkObject.h"

#include <memory> // for the implementation
#include <string> // for the messages

class vtkComputeContext;
class vtkDataArray;
class vtkDoubleArray;
class vtkTrimmedNURBSModel;

class SMFILTERSVARIANTS_EXPORT vtkVariantMoments : public vtkObject
{
public:
  static vtkVariantMoments* New();
  vtkTypeMacro(vtkVariantMoments, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** How variants are evaluated. */
  enum MethodType
  {
    /** What takes less time for ExpectedVariants. */
    AUTOMATIC = 0,
    POLYNOMIAL = 1,
    POINTS = 2
  };

  ///@{
  /** The method; values outside the enumeration are clamped. Default: AUTOMATIC. */
  vtkSetClampMacro(Method, int, AUTOMATIC, POINTS);
  vtkGetMacro(Method, int);
  ///@}

  /** The device that evaluates variants. */
  enum BackendType
  {
    /** OpenGL on a GPU where ExpectedVariants take the CPU more than a second and OpenGL is faster; else the
     * CPU. */
    AUTOMATIC_BACKEND = 0,
    /** OpenGL, also of a software renderer; the CPU, with the reason, where it cannot be used. */
    OPENGL = 1,
    CPU = 2
  };

  ///@{
  /** The device; values outside the enumeration are clamped. Default: AUTOMATIC_BACKEND. */
  vtkSetClampMacro(Backend, int, AUTOMATIC_BACKEND, CPU);
  vtkGetMacro(Backend, int);
  ///@}

  /** The OpenGL context of the next Build(); null (default): an own one. */
  void SetComputeContext(vtkComputeContext* context);

  ///@{
  /** The number of variants that AUTOMATIC is to be fast for; clamped to >= 1. Default: 100000. */
  vtkSetClampMacro(ExpectedVariants, vtkIdType, 1, VTK_ID_MAX);
  vtkGetMacro(ExpectedVariants, vtkIdType);
  ///@}

  /** Sets the base and removes all directions. */
  void SetBase(vtkTrimmedNURBSModel* model);

  ///@{
  /**
   * Adds a direction and returns its index. `moved` is the base after a move, `amount` the number that the
   * move belongs to, not 0. `range` is the largest |c| that orders are chosen for, positive.
   */
  int AddDirection(vtkTrimmedNURBSModel* moved, double amount, double range);
  /**
   * Adds a direction that moves a face along its outward normal; exact for planes and surfaces of revolution.
   * Edges stay. Returns -1 for a face that does not exist, or has more than 400 control points.
   */
  int AddNormalOffset(int face, double range);
  /**
   * Adds a direction without displacements, for AddDisplacement(), which displaces the control points of a
   * face of it: 3 components, u fastest. Edges stay where they are and ribbons lead to them, so that moments
   * are right where faces that meet move alike; GetGap() includes the way to the edges.
   */
  int AddEmptyDirection(double range);
  bool AddDisplacement(int direction, int face, vtkDataArray* displacements);
  ///@}
  int GetNumberOfDirections() const;

  /**
   * Integrates. Returns false if a moved model does not fit the base, a face cannot be cut, or it was
   * stopped. Invokes ProgressEvent, whose data is a double from 0 to 1, between portions of the faces; an
   * observer may call StopBuild().
   */
  bool Build();
  /** Stops the running Build(), which then returns false. */
  void StopBuild() { this->AbortBuild = true; }

  /**
   * Evaluates the variants of `c`, K components each. The results get 10 components, `bounds` may be null.
   * Returns false before Build(), or with other components.
   */
  bool Evaluate(vtkDataArray* c, vtkDoubleArray* values, vtkDoubleArray* bounds);
  /** The same with the derivatives by c, 10 K components, moment by moment. Needs polynomials. */
  bool EvaluateGradients(
    vtkDataArray* c, vtkDoubleArray* values, vtkDoubleArray* bounds, vtkDoubleArray* gradients);

  ///@{
  /** After Build(): POLYNOMIAL or POINTS, and why; the point that moments are about, part coordinates; and
   * how far a direction moves a face away from an edge for c = 1. */
  int GetUsedMethod() const;
  /** OPENGL or CPU; OPENGL becomes CPU where it fails, and GetReason() has why. */
  int GetUsedBackend() const;
  std::string GetReason() const;
  void GetReference(double point[3]) const;
  double GetGap(int direction) const;
  ///@}
  /** Returns why the last call failed; empty if it did not. */
  std::string GetMessage() const { return this->Message; }

protected:
  vtkVariantMoments();
  ~vtkVariantMoments() override;

private:
  vtkVariantMoments(const vtkVariantMoments&) = delete;
  void operator=(const vtkVariantMoments&) = delete;

  bool Fail(const std::string& reason);
  bool Run(vtkDataArray* c, vtkDoubleArray* values, vtkDoubleArray* bounds, vtkDoubleArray* gradients);

  struct Internals;
  std::unique_ptr<Internals> Implementation;
  int Method = AUTOMATIC;
  int Backend = AUTOMATIC_BACKEND;
  bool AbortBuild = false;
  vtkIdType ExpectedVariants = 100000;
  std::string Message;
};

#endif
