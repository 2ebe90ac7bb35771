/**
 * @file smItemRunner.h
 * @brief What evaluates items of integration (panels, ribbons, caps) and sums their results: the GPU or the CPU
 */
#ifndef smItemRunner_h
#define smItemRunner_h

#include "smFacePanelsCache.h"
#include "smIntegrand.h"
#include "smProgressCallback.h"
#include "smRowLayout.h"
#include "smWorkItems.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace sm
{
/**
 * A runner is driven in this order:
 *   1. Configure(): integrands and constants.
 *   2. Acquire(): the cut faces of the run. Faces with GetFaceError() have no items.
 *   3. BeginBatch() for some faces of one GetGroup(), of which
 *   4. BeginRows() for a list of items, each with a row of its own, full of zeros,
 *   5. Run() for any of these items, any number of times. An item carries its orders and flags in its record; its sums are
 *      compared with what its row holds (unless its flags say that there is nothing to compare with), then
 *      overwrite it, so that an item may come back at a higher order,
 *   6. Sum() of any segments of rows.
 * Steps 3 to 6 repeat; Release() ends the run. A runner decides neither orders nor tolerances; that is the integrator's.
 *
 * An item's row depends on nothing but the item, its face, and what Configure() and BeginBatch() gave; a
 * segment's sum on nothing but its rows, in their order. So results are the same bits for any order, batch, number of
 * threads or dispatches.
 *
 * Methods return false when they fail, with GetError(), or when `shouldContinue` said so. Not thread safe.
 */
class ItemRunner
{
public:
  virtual ~ItemRunner() = default;

  struct Setup
  {
    std::vector<Integrand> Integrands;
    /// Gauss points across ribbons and caps.
    int StripPoints = 3;
    /// Positions and normals are placed, face by face.
    bool UsePlacements = false;
    /// A factor of every sample, for tests.
    double Perturbation = 1.0;
  };

  /// What a batch gives for each of its faces.
  struct BatchFace
  {
    /// Index into the faces of Acquire().
    std::size_t Face = 0;
    /// Tolerance of every integrand for one undivided item of the face.
    std::vector<double> Tolerances;
    /// Rows of a 3x4 placement, where placements are used.
    std::array<double, 12> Placement{};
  };

  /// Why this runner cannot evaluate an integrand; empty when it can.
  virtual std::string GetObstacle(const Integrand& integrand) const = 0;

  /// Takes effect at the next BeginBatch(). All integrands must be without obstacle.
  void Configure(const Setup& setup)
  {
    this->Configured = setup;
    this->Layout = RowLayout(setup.Integrands);
    this->OnConfigure();
  }
  const RowLayout& GetLayout() const { return this->Layout; }

  /// Makes the faces ready to be read by items, and whatever else should not count as integrating.
  virtual bool Acquire(const std::vector<CutFacePointer>& faces, const ProgressCallback& progress) = 0;
  /// Of a face of the last Acquire(): why it cannot be integrated here; empty when it can.
  virtual std::string GetFaceError(std::size_t face) const = 0;
  /// Faces of one group may share a batch.
  virtual int GetGroup(std::size_t face) const = 0;
  /// Items that may have rows at a time.
  virtual std::size_t GetRowLimit() const = 0;

  /// The faces that the slots of the following items mean.
  virtual bool BeginBatch(const std::vector<BatchFace>& faces) = 0;
  virtual bool BeginRows(std::size_t rows) = 0;

  /// Evaluates items[active[i]] and tells in unconverged[i] whether the differences are above the tolerances.
  /// `evaluations` is increased by the points of panels and ribbons.
  virtual bool Run(const std::vector<WorkItem>& items, const std::vector<std::size_t>& active,
    std::vector<std::uint8_t>& unconverged, std::int64_t& evaluations,
    const ContinueCallback& shouldContinue) = 0;

  /// Per segment [first, last) of rows the sums of all columns, GetLayout().GetStride() doubles each, and the largest of
  /// the column LargestGap. Of an empty segment: zeros. Sums are compensated; a NaN is never lost.
  using Segment = std::pair<unsigned int, unsigned int>;
  virtual bool Sum(
    const std::vector<Segment>& segments, std::vector<double>& sums, std::vector<double>& largestGaps) = 0;

  /// Ends a run: lets go of the faces of Acquire(). What is resident stays, within its own budget.
  virtual void Release() = 0;

  /// Frees what is kept between runs, on the GPU above all; the next run makes it again. Not within a run.
  virtual void FreeMemory() { this->Release(); }

  /// Seconds that the last Acquire() spent building what belongs to no face (shaders).
  double GetStartSeconds() const { return this->StartSeconds; }
  const std::string& GetError() const { return this->Error; }

protected:
  virtual void OnConfigure() = 0;
  bool Fail(const std::string& what)
  {
    this->Error = what;
    return false;
  }

  Setup Configured;
  RowLayout Layout;
  double StartSeconds = 0.0;
  std::string Error;
};

/// Steps to the foot point of a gap.
constexpr int FootPointSteps = 3;
}

#endif
