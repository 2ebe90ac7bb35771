/**
 * @class   vtkNURBSPointEvaluatorGPU
 * @brief   display points of edited faces by compute shaders, with the evaluator of the integrals
 *
 * vtkNURBSPointEvaluator::New() makes this class where this module is loaded. Patches of the faces that
 * changed are uploaded (sm::ResidentFaces). The parameters of the points stay on the GPU from update to
 * update. One invocation evaluates one point, by the chunks that the integration uses (smPatch.glsl). Where
 * OpenGL 4.3 with doubles is missing, or memory on the GPU, the CPU evaluates, unless Backend is OPENGL.
 *
 * The evaluator makes its own context unless one is set: that of a window that shows the points, or that of a
 * filter (vtkSurfaceIntegralBase::GetComputeContext()), so that a program needs one context only.
 * UpdatePoints() enters it by sm::ContextScope and may therefore run inside a Render().
 */
#ifndef vtkNURBSPointEvaluatorGPU_h
#define vtkNURBSPointEvaluatorGPU_h

#include "smRenderingNURBSModule.h"
#include "vtkNURBSPointEvaluator.h"

#include <memory> // for std::unique_ptr

class vtkComputeContext;
class vtkRenderWindow;

class SMRENDERINGNURBS_EXPORT vtkNURBSPointEvaluatorGPU : public vtkNURBSPointEvaluator
{
public:
  static vtkNURBSPointEvaluatorGPU* New();
  vtkTypeMacro(vtkNURBSPointEvaluatorGPU, vtkNURBSPointEvaluator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The window whose context evaluates, held weakly; see vtkComputeContext::SetWindow(). Null (default): a
   * context of its own, or the one that was given. */
  void SetRenderWindow(vtkRenderWindow* window);
  vtkRenderWindow* GetRenderWindow();
  ///@}

  ///@{
  /** The context that evaluates; started at the first need. Null: an own one again. Default: an own one. */
  void SetComputeContext(vtkComputeContext* context);
  vtkComputeContext* GetComputeContext();
  ///@}

protected:
  vtkNURBSPointEvaluatorGPU();
  ~vtkNURBSPointEvaluatorGPU() override;

#ifndef __VTK_WRAP__
  bool EvaluateByOpenGL(
    const Work& work, std::vector<sm::PointAndNormal>& results, std::string& reason) override;
#endif

private:
  vtkNURBSPointEvaluatorGPU(const vtkNURBSPointEvaluatorGPU&) = delete;
  void operator=(const vtkNURBSPointEvaluatorGPU&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Implementation;
};

#endif
