/**
 * @class   vtkNURBSPointEvaluator
 * @brief   evaluates the display points of a mesh again on faces that an edit changed
 *
 * A display point remembers its face and its parameters there (arrays FaceIndex and Parameters of
 * vtkNURBSDataSet). After an edit (smModelEdit.h), UpdatePoints() gives the mesh the edited model, with
 * positions and unit normals of the points of new faces evaluated on the exact surfaces; all others keep
 * their bits.
 *
 * This class evaluates on the CPU, by vtkSMPTools. New() makes a vtkNURBSPointEvaluatorGPU where the module
 * SolidMoments::RenderingNURBS is loaded, by VTK's object factory: programs that link or import
 * FiltersMassProperties, and ParaView's plugin, have it. That one uses OpenGL 4.3 with doubles and falls back
 * to this one. The two agree to rounding of the part's size.
 *
 * A point whose normal vanishes (a pole, a collapsed edge) gets the normal a 4096th of the way to the middle
 * of its Bezier patch; where there is none either, it keeps the old normal.
 *
 * An evaluator remembers how the points of a mesh lie on faces, for meshes that still exist and by their
 * FaceIndex and Parameters arrays, so that the second update of a mesh evaluates only the changes. One object
 * serves many meshes. Not thread safe.
 */
#ifndef vtkNURBSPointEvaluator_h
#define vtkNURBSPointEvaluator_h

#include "smFiltersNURBSModule.h"
#include "vtkObject.h"

#include <memory> // for std::unique_ptr
#include <string> // for std::string
#ifndef __VTK_WRAP__
#include "smPointLayout.h" // for PointLayout
#endif

class vtkNURBSDataSet;
class vtkTrimmedNURBSModel;

class SMFILTERSNURBS_EXPORT vtkNURBSPointEvaluator : public vtkObject
{
public:
  static vtkNURBSPointEvaluator* New();
  vtkTypeMacro(vtkNURBSPointEvaluator, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The device that evaluates; the values are those of vtkSurfaceIntegralBase::BackendType. */
  enum BackendType
  {
    AUTOMATIC = 0, ///< OpenGL where there is 4.3 with doubles, else the CPU
    OPENGL = 1,    ///< OpenGL; where there is none, UpdatePoints() fails
    CPU = 2
  };

  ///@{
  /** The device. Values outside the enumeration are clamped. Default: AUTOMATIC. */
  vtkSetClampMacro(Backend, int, AUTOMATIC, CPU);
  vtkGetMacro(Backend, int);
  ///@}

  /**
   * Gives `mesh` the model `edited`: new points and normals, whatever the mesh shared before stays as it is.
   * Both models have the same faces except for those that were edited, index by index; the placement of the
   * mesh holds, mirrored or not. The precision of points and normals stays. A mesh without normals gets none.
   *
   * Returns false, with GetMessage() and without changes, if the mesh has no model, no points, or no
   * FaceIndex and Parameters for its points; if `edited` is null or has a different number of faces; or if
   * points have to be evaluated, Backend is OPENGL, and OpenGL cannot evaluate them.
   */
  bool UpdatePoints(vtkNURBSDataSet* mesh, vtkTrimmedNURBSModel* edited);

  ///@{
  /**
   * Results of the last UpdatePoints(): the number of points evaluated; the device, "opengl", "cpu", or
   * "none" when it failed or nothing had to be evaluated; the reason why it failed, or why the CPU evaluated
   * where OpenGL would have been preferred, else an empty text.
   */
  vtkGetMacro(NumberOfEvaluations, vtkTypeInt64);
  std::string GetBackendName() const { return this->BackendName; }
  std::string GetMessage() const { return this->Message; }
  ///@}

protected:
  vtkNURBSPointEvaluator();
  ~vtkNURBSPointEvaluator() override;

#ifndef __VTK_WRAP__
  /// A request for evaluation: all points of some faces of a layout.
  struct Work
  {
    std::shared_ptr<sm::PointLayout> Layout;
    /// Indices of the faces, increasing, and their patches.
    std::vector<std::size_t> Faces;
    std::vector<sm::CutFacePointer> Patches;
    std::size_t NumberOfPoints = 0;
  };

  /// Evaluates `work` into one entry per point, face by face, in the layout's order. Returns false, with
  /// `reason`, when OpenGL cannot do so.
  virtual bool EvaluateByOpenGL(
    const Work& work, std::vector<sm::PointAndNormal>& results, std::string& reason);
#endif

private:
  vtkNURBSPointEvaluator(const vtkNURBSPointEvaluator&) = delete;
  void operator=(const vtkNURBSPointEvaluator&) = delete;

  struct Internals;

  bool Fail(const std::string& why);

  int Backend = AUTOMATIC;
  vtkTypeInt64 NumberOfEvaluations = 0;
  std::string BackendName = "none";
  std::string Message;
  std::unique_ptr<Internals> Implementation;
};

#endif
