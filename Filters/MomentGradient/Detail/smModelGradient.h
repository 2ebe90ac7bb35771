/**
 * @file smModelGradient.h
 * @brief Gradients of a model's moments by the control points of some of its faces, and tied control points
 */
#ifndef smModelGradient_h
#define smModelGradient_h

#include "smNetGradient.h"
#include "smPatchIntegrator.h"
#include "smProgressCallback.h"

#include "vtkTrimmedNURBSModel.h"

#include <cstdint>
#include <string>
#include <vector>

namespace sm
{
/// Groups of control points that are one variable: a number for each control point of each face, in the order
/// of ControlPoints; equal numbers are tied.
struct TiedVariables
{
  std::vector<std::vector<int>> Points;
  std::vector<std::vector<int>> Weights;

  static TiedVariables Find(vtkTrimmedNURBSModel* model);
  /// Every control point is a variable of its own.
  static TiedVariables MakeSeparate(vtkTrimmedNURBSModel* model);
  /// Adds the faces that have a variable in common with one of `faces`.
  std::vector<bool> AddFollowers(const std::vector<bool>& faces) const;
};

/// Replaces derivatives by those of the variables. All followers must have been computed.
void JoinTied(vtkTrimmedNURBSModel* model, const TiedVariables& tied, std::vector<NetGradient>& faces);

/// The gradients of all faces of a model that were asked for.
class ModelGradient
{
public:
  /// What bounds include besides the integrals over the faces.
  enum class Closing
  {
    /// What gaps between faces leave open.
    Gaps,
    /// Nothing: the derivatives are those of the faces with their trim curves.
    Nothing
  };

  /// `side` is 1 or -1 for each face, a factor of its fluxes. Returns false if stopped, or if a face cannot
  /// be cut; GetError() has the reason.
  bool Compute(vtkTrimmedNURBSModel* model, const std::vector<bool>& faces, const std::vector<double>& sides,
    double relativeTolerance, const ProgressCallback& progress, PatchIntegrator& integrator,
    Closing closing = Closing::Gaps);
  /// See JoinTied().
  void Join(vtkTrimmedNURBSModel* model, const TiedVariables& tied) { JoinTied(model, tied, this->Faces); }

  const NetGradient& Get(std::size_t face) const { return this->Faces[face]; }
  std::int64_t GetEvaluations() const { return this->Evaluations; }
  const std::string& GetError() const { return this->Error; }

private:
  struct FaceTask
  {
    /// Index of the face in the model.
    std::size_t Face;
    NetGradientTask Task;
  };
  bool ComputePart(const std::vector<FaceTask>& tasks, const std::vector<double>& sides,
    PatchIntegrator& integrator, const ProgressCallback& progress, double from, double share);

  std::vector<NetGradient> Faces;
  std::int64_t Evaluations = 0;
  std::string Error;
};
}

#endif
