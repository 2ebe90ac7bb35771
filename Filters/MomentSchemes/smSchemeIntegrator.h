/**
 * @file smSchemeIntegrator.h
 * @brief Integrates faces by the paper's own schemes, with its error estimate
 *
 * "Accurate Moment Computation Using the GPU" (SPM 2010): a face is divided into sub-patches (smSubPatches.h), each with n x n
 * Gauss points (section 5); the integrands are the fluxes along z of its Eq. 16-28, over the faces alone, about the origin of the
 * faces' coordinates; a trimmed sub-patch is weighed by the fraction of its texels that are in the face (section 5.4); planes are
 * integrated by triangles (section 4), on the CPU. Beside the integrals go two sums of its Eq. 36,
 * int |2 K n_z| du dv by the same points, over the sub-patches that are wholly in the face, and over those that a trim curve crosses
 * as well. They estimate the error of the volume; they bound nothing. There is no bound.
 */
#ifndef smSchemeIntegrator_h
#define smSchemeIntegrator_h

#include "smFiltersMomentSchemesModule.h"
#include "smPreparedFaces.h"
#include "smProgressCallback.h"
#include "smSurfaceIntegrator.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace sm
{
class SchemeRunner;

/// The trim texture of a face, from bottom to top, 1 where a texel's centre is in the face. Origin is the centre of the first texel in
/// (u,v), Spacing the distance of centres, averaged over the domain where knot intervals differ in width.
struct TrimTexture
{
  int Width = 0;
  int Height = 0;
  std::array<double, 2> Origin{};
  std::array<double, 2> Spacing{};
  std::vector<unsigned char> Texels;
};

struct SchemeResult
{
  /// 14 integrals as in smMassIntegrands.h in Face; Closing is 0, the bounds and gaps are NaN.
  FaceIntegrals Integrals;
  /// The paper's estimate of the volume's error: sub-patches wholly in the face; and those on its boundary counted whole as well.
  double Estimate = 0.0;
  double EstimateWithBoundary = 0.0;
  /// Of a planar face 0.
  std::int64_t SubPatches = 0;
  /// Empty for faces that are planar or not trimmed, and unless textures are kept.
  TrimTexture Texture;
};

/**
 * The sums of a face are made tile by tile (smSchemeBatch.h), by the runner over a fixed tree, and compensated over its tiles: the
 * result of a face depends on nothing but the face and the options. Faces are prepared, and kept from run to run, by
 * PreparedFaces. The clock and `progress` are asked in the calling thread about every tenth of a second. Not thread safe.
 */
class SMFILTERSMOMENTSCHEMES_EXPORT SchemeIntegrator
{
public:
  SchemeIntegrator();
  ~SchemeIntegrator();

  struct Setup
  {
    /// n: 1 (midpoint), 2 or 3 Gauss points in each direction.
    int Points = 2;
    /// Its ChordTolerance is not used: see the tasks.
    SchemeOptions Options;
    double Perturbation = 1.0;
    bool KeepTextures = false;
    /// More than that are refused, before anything is evaluated.
    std::int64_t MaximumEvaluations = 2000000000;
    /// 0: no limit.
    double MaximumSeconds = 0.0;
  };

  /// What evaluates; never null once Integrate() is called.
  void SetRunner(std::unique_ptr<SchemeRunner> runner);

  /// False, with GetError(), when it was stopped, takes too many evaluations, memory is short or a shader does not build; there are
  /// no results then, for without a bound a part of them would say nothing. A face that cannot be integrated says so in its
  /// result's Error.
  bool Integrate(const std::vector<SchemeTask>& tasks, const Setup& setup, std::vector<SchemeResult>& results,
    const ProgressCallback& progress);

  /// What the last Integrate() prepared; its faces are gone.
  const PreparedFaces& GetPrepared() const;
  const std::string& GetError() const;
  bool WasAborted() const;
  bool WasTimedOut() const;
  std::int64_t GetEvaluations() const;
  /// Seconds of the last Integrate(): shaders with a warm dispatch; sub-patches, deviations and trim curves; integration.
  double GetStartSeconds() const;
  double GetPrepareSeconds() const;
  double GetIntegrateSeconds() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};
}

#endif
