/**
 * @file smSchemeIntegrator.h
 * @brief Integrates faces by the schemes of the paper, with the paper's error estimate
 *
 * "Accurate Moment Computation Using the GPU" (SPM 2010): a face is divided into sub-patches
 * (smSubPatches.h), each with n x n Gauss points (section 5). The integrands are the fluxes along z of its
 * Eq. 16-28, over the faces alone, about the origin of the faces' coordinates. A trimmed sub-patch is
 * weighted by the fraction of its texels that are in the face (section 5.4). Planes are integrated by
 * triangles (section 4), on the CPU. In addition to the integrals there are two sums of its Eq. 36, int |2 K
 * n_z| du dv by the same points: over the sub-patches that are entirely in the face, and over these and the
 * sub-patches that a trim curve crosses. They estimate the error of the volume and are not bounds; the
 * schemes have no bound.
 */
#ifndef smSchemeIntegrator_h
#define smSchemeIntegrator_h

#include "smFiltersMomentSchemesModule.h"
#include "smPreparedFaces.h"
#include "smProgressCallback.h"
#include "smSurfaceIntegrator.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace sm
{
class SchemeRunner;

/// The trim texture of a face, from bottom to top, with 1 where the centre of a texel is in the face. Origin
/// is the centre of the first texel in (u,v). Spacing is the distance of centres, averaged over the domain if
/// knot intervals differ in width.
struct TrimTexture
{
  int Width = 0;
  int Height = 0;
  std::array<double, 2> Origin{};
  std::array<double, 2> Spacing{};
  std::vector<unsigned char> Texels;
};

/// Results of one face.
struct SchemeResult
{
  /// The 14 integrals as in smMassIntegrands.h in Face; Closing is 0, and the bounds and gaps are NaN.
  FaceIntegrals Integrals;
  /// The paper's estimate of the volume's error over the sub-patches entirely in the face, and the same with
  /// the sub-patches on its boundary counted in full.
  double Estimate = 0.0;
  double EstimateWithBoundary = 0.0;
  /// Number of sub-patches; 0 for a planar face.
  std::int64_t SubPatches = 0;
  /// Trim texture; empty for faces that are planar or not trimmed, and if KeepTextures is false.
  TrimTexture Texture;
};

/**
 * Integrates faces by a runner. The sums of a face are computed tile by tile (smSchemeBatch.h), by the runner
 * over a fixed tree, and compensated over its tiles, so that the result of a face depends only on the face
 * and the options. PreparedFaces prepares the faces and keeps them between runs. The time limit and
 * `progress` are checked in the calling thread about every tenth of a second. Not thread safe.
 */
class SMFILTERSMOMENTSCHEMES_EXPORT SchemeIntegrator
{
public:
  SchemeIntegrator();
  ~SchemeIntegrator();

  /// Options of Integrate().
  struct Setup
  {
    /// n: 1 (midpoint), 2 or 3 Gauss points in each direction.
    int Points = 2;
    /// Options of the sub-patches. ChordTolerance is not used, as each task has its own.
    SchemeOptions Options;
    double Perturbation = 1.0;
    bool KeepTextures = false;
    /// Largest number of evaluations. A run that needs more fails before anything is evaluated.
    std::int64_t MaximumEvaluations = 2000000000;
    /// Limit of the run time in seconds; 0: no limit.
    double MaximumSeconds = 0.0;
  };

  /// Sets the runner that evaluates the tiles. It must not be null when Integrate() is called.
  void SetRunner(std::unique_ptr<SchemeRunner> runner);

  /// Computes one result per task. Returns false, and sets GetError(), if the run was stopped, needs too many
  /// evaluations, lacks memory or a shader cannot be compiled. There are no results then, as without a bound
  /// a part of them permits no conclusion. A face that cannot be integrated has the reason in its result's
  /// Error.
  bool Integrate(const std::vector<SchemeTask>& tasks, const Setup& setup, std::vector<SchemeResult>& results,
    const ProgressCallback& progress);

  /// Returns the number of evaluations that a face with this surface takes.
  static double CountEvaluations(const NURBSSurface& surface, const Setup& setup);
  /// Returns the counters of the last Integrate()'s preparation; its faces have been released.
  const PreparedFaces& GetPrepared() const;
  const std::string& GetError() const;
  bool WasAborted() const;
  bool WasTimedOut() const;
  std::int64_t GetEvaluations() const;
  /// Seconds of the last Integrate() for the shaders including a first dispatch, for sub-patches, deviations
  /// and trim curves, and for the integration.
  double GetStartSeconds() const;
  double GetPrepareSeconds() const;
  double GetIntegrateSeconds() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};
}

#endif
