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
#include <string>
#include <vector>

class vtkComputeContext;
class vtkFieldData;
class vtkTable;

namespace sm
{
/// Sums of the paper's estimates (lengths cubed; NaN: not computed) and of sub-patches over faces.
struct SchemeTotals
{
  double Estimate = std::numeric_limits<double>::quiet_NaN();
  double EstimateWithBoundary = std::numeric_limits<double>::quiet_NaN();
  std::int64_t SubPatches = 0;
};

/// A face's trim texture as an image of 0 and 255 over (u,v), and its name: that of the solid and the face's entity number.
struct NamedTexture
{
  std::string Name;
  vtkSmartPointer<vtkImageData> Image;
};

/**
 * Integrates every model once, about its origin, however many instances it has. Keeps the runner and prepared faces from run to run.
 * Not thread safe.
 */
class SchemeRun
{
public:
  struct Options
  {
    SchemeIntegrator::Setup Setup;
    /// Of planes: relative to the diagonal of the model's box.
    double ChordTolerance = 1e-8;
    /// Compute shaders in this context, which is READY; null: the CPU.
    vtkComputeContext* Context = nullptr;
  };

  /// Gives every body its Faces. False when nothing came of it; then GetMessage() says why.
  bool Integrate(
    const Options& options, std::vector<BodyIntegrals>& bodies, const ProgressCallback& progress);
  std::string GetMessage() const;

  /// Of the last Integrate(), for a model, and for all bodies; nothing computed for what it did not have.
  SchemeTotals GetTotals(vtkTrimmedNURBSModel* model) const;
  SchemeTotals GetTotals(const std::vector<BodyIntegrals>& bodies) const;
  /// Scheme, PaperErrorEstimate, PaperErrorEstimateWithBoundary and SubPatches, of every body and of `total`.
  void AddColumns(const std::string& scheme, const std::vector<BodyIntegrals>& bodies,
    const SchemeTotals& total, vtkFieldData* totals, vtkTable* solids) const;
  const std::vector<NamedTexture>& GetTextures() const { return this->Textures; }
  const SchemeIntegrator& GetIntegrator() const { return this->Integrator; }

  /// Forgets the results of the last run.
  void Forget();

private:
  void KeepTextures(const BodyIntegrals& body, std::vector<SchemeResult>& results, std::size_t first);

  SchemeIntegrator Integrator;
  /// What the runner computes with.
  bool HasRunner = false;
  vtkSmartPointer<vtkComputeContext> RunnerContext;
  std::map<vtkTrimmedNURBSModel*, SchemeTotals> Totals;
  std::vector<NamedTexture> Textures;
};

/// "MIDPOINT", "GAUSS2", "GAUSS3" for n = 1, 2, 3; empty for anything else.
std::string GetSchemeName(int points);
}

#endif
