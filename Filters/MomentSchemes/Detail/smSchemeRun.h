/**
 * @file smSchemeRun.h
 * @brief The paper's schemes over all bodies of an input: the work of vtkSchemeMassPropertiesGPU
 */
#ifndef smSchemeRun_h
#define smSchemeRun_h

#include "smBodyIntegrals.h"
#include "smProgressCallback.h"
#include "smSchemeIntegrator.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkComputeContext;

namespace sm
{
namespace columns
{
class Writer;
}
/// Sums over faces of the paper's estimates (lengths cubed; NaN if not computed) and of the numbers of
/// sub-patches.
struct SchemeTotals
{
  double Estimate = std::numeric_limits<double>::quiet_NaN();
  double EstimateWithBoundary = std::numeric_limits<double>::quiet_NaN();
  std::int64_t SubPatches = 0;
};

/// A face's trim texture as an image of 0 and 255 over (u,v), with the solid's name and the face's entity
/// number as its name.
struct NamedTexture
{
  std::string Name;
  vtkSmartPointer<vtkImageData> Image;
};

/**
 * Integrates every model once, about its origin, independent of its number of instances. The runner and the
 * prepared faces are kept between runs. Not thread safe.
 */
class SchemeRun
{
public:
  struct Options
  {
    SchemeIntegrator::Setup Setup;
    /// Chord tolerance of planes, relative to the diagonal of the model's box.
    double ChordTolerance = 1e-8;
    /// Context, in state READY, of the compute shaders; null for the CPU.
    vtkComputeContext* Context = nullptr;
  };

  /// Sets the Faces of every body. Returns false if nothing was computed; GetMessage() then returns the
  /// reason.
  bool Integrate(
    const Options& options, std::vector<BodyIntegrals>& bodies, const ProgressCallback& progress);
  std::string GetMessage() const;

  /// Return the totals of the last Integrate() for a model or for all bodies; a model that it did not
  /// integrate has no estimate (NaN).
  SchemeTotals GetTotals(vtkTrimmedNURBSModel* model) const;
  SchemeTotals GetTotals(const std::vector<BodyIntegrals>& bodies) const;
  /// Adds Scheme, PaperErrorEstimate, PaperErrorEstimateWithBoundary and SubPatches of every body to `solids`
  /// and those of `total` to `totals`.
  void AddColumns(const std::string& scheme, const std::vector<BodyIntegrals>& bodies,
    const SchemeTotals& total, columns::Writer totals, columns::Writer solids) const;
  const std::vector<NamedTexture>& GetTextures() const { return this->Textures; }
  const SchemeIntegrator& GetIntegrator() const { return *this->Integrator; }

  /// Clears the results of the last run.
  void Forget();
  /// Releases the runner, with its buffers, and the prepared faces; the results of the last run stay.
  void ReleaseMemory();

private:
  void KeepTextures(const BodyIntegrals& body, std::vector<SchemeResult>& results, std::size_t first);

  std::unique_ptr<SchemeIntegrator> Integrator = std::make_unique<SchemeIntegrator>();
  /// True if the integrator has a runner, and the context of that runner; null for the CPU.
  bool HasRunner = false;
  vtkSmartPointer<vtkComputeContext> RunnerContext;
  std::map<vtkTrimmedNURBSModel*, SchemeTotals> Totals;
  std::vector<NamedTexture> Textures;
};

/// Returns "MIDPOINT", "GAUSS2" or "GAUSS3" for n = 1, 2, 3; an empty string for any other number.
std::string GetSchemeName(int points);
}

#endif
