/**
 * @file smSurfaceIntegrator.h
 * @brief Integrates a list of integrands over faces on the GPU, face by face, with an error for each
 */
#ifndef smSurfaceIntegrator_h
#define smSurfaceIntegrator_h

#include "smFace.h"
#include "smIntegrand.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkComputeContext;

namespace sm
{
/// One face to integrate. Its result depends on nothing but this.
struct FaceTask
{
  FacePointer Source;
  /// Absolute tolerance of each integrand for this face.
  std::vector<double> Tolerances;
  /// Rows of a 3x4 placement applied to positions and normals; used when SetUsePlacements(true).
  std::array<double, 12> Placement{};
};

/// The gap between one use of an edge and its curve, at foot points: integral of the square, of the gap, and the largest.
struct CoedgeGap
{
  int Loop = 0;
  int Coedge = 0;
  double GapSquared = 0.0;
  double GapArea = 0.0;
  double MaxGap = 0.0;
};

/// Results of one face, one entry per integrand.
struct FaceIntegrals
{
  /// Integral over the face alone, and over its ribbons and caps.
  std::vector<double> Face;
  std::vector<double> Closing;
  /// Estimated from the differences of orders, and the rounding of every sample, summed over both.
  std::vector<double> QuadratureError;
  std::vector<double> Rounding;
  /// Gaps between coedges and their edges, at foot points: integral of the square, of the gap, and the largest.
  double GapSquared = 0.0;
  double GapArea = 0.0;
  double MaxGap = 0.0;
  /// The same for every coedge that was measured.
  std::vector<CoedgeGap> Gaps;
  /// Items whose two highest orders still differ by more than their share.
  std::int64_t Unconverged = 0;
  int CoverageDefects = 0;
  double Outside = 0.0;
  /// Not empty: the face could not be integrated; everything else is zero.
  std::string Error;
};

/**
 * The order of each item (panel, ribbon) is raised along a ladder of Gauss rules until two orders agree to its
 * share of the face's tolerance; an item that does not reach it at the highest order is bisected. Where an order
 * is known to be exact one evaluation is made and the difference is 0. A face's tolerance is shared equally
 * among its items, so that the result of a face does not depend on others. Sums over items follow a fixed tree.
 *
 * Enters the context by itself, and is outside of it whenever it reports progress. Not thread safe.
 */
class SurfaceIntegrator
{
public:
  explicit SurfaceIntegrator(vtkComputeContext* context);
  ~SurfaceIntegrator();

  /// Fraction done, false to stop.
  using Progress = std::function<bool(double)>;

  /// A change drops the compiled shaders.
  void SetIntegrands(const std::vector<Integrand>& integrands);
  void SetUsePlacements(bool use);
  void SetPerturbation(double factor);
  void SetMaximumEvaluations(std::int64_t evaluations);

  /// False when a shader does not build, GPU memory is short, or progress stopped it; GetError() says why.
  bool Integrate(
    const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results, const Progress& progress);

  const std::string& GetError() const;
  bool WasAborted() const;
  std::int64_t GetEvaluations() const;
  /// Seconds of the last Integrate(): shaders with a warm dispatch; cutting and upload; integration.
  double GetStartSeconds() const;
  double GetPrepareSeconds() const;
  double GetIntegrateSeconds() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};
}

#endif
