/**
 * @file smItemRunner.h
 * @brief Interface of the GPU and CPU runners, which evaluate items of integration (panels, ribbons, caps) and sum their results
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
#include <string>
#include <utility>
#include <vector>

namespace sm
{
/**
 * Methods are called in this order:
 *   1. Configure(): integrands and constants.
 *   2. Acquire(): the cut faces of the run. Faces with GetFaceError() have no items.
 *   3. BeginBatch() for some faces of one GetGroup(); for this batch
 *   4. BeginRows() for a list of items, each with its own row, which has no meaning until the item ran,
 *   5. Run() for any of these items, any number of times. An item has its orders and flags in its record. Its sums are compared
 *      with the content of its row (unless a flag excludes the comparison) and then overwrite it, so that an item can be repeated
 *      at a higher order,
 *   6. Sum() of any segments of rows.
 * Steps 3 to 6 repeat; Release() ends the run. The integrator chooses orders and tolerances, not the runner.
 *
 * The row of an item depends only on the item, its face, and the arguments of Configure() and BeginBatch(); the sum of a segment
 * depends only on its rows and their order. Results are therefore bitwise the same for any order, batch, number of threads or
 * dispatches.
 *
 * Methods return false if they fail, with GetError(), or if `shouldContinue` returned false. Not thread safe.
 */
class ItemRunner
{
public:
  virtual ~ItemRunner() = default;

  struct Setup
  {
    std::vector<Integrand> Integrands;
    /// Number of Gauss points across ribbons and caps.
    int StripPoints = 3;
    /// If true, the placement of each face is applied to positions and normals.
    bool UsePlacements = false;
    /// Factor applied to every sample, for tests.
    double Perturbation = 1.0;
  };

  /// Data of one face of a batch.
  struct BatchFace
  {
    /// Index into the faces of Acquire().
    std::size_t Face = 0;
    /// Tolerance of every integrand for one undivided item of the face.
    std::vector<double> Tolerances;
    /// Rows of a 3x4 placement; used if UsePlacements is set.
    std::array<double, 12> Placement{};
  };

  /// Returns the reason why this runner cannot evaluate an integrand; empty if it can.
  virtual std::string GetObstacle(const Integrand& integrand) const = 0;

  /// Sets integrands and constants, from the next BeginBatch() on. GetObstacle() must be empty for all integrands.
  void Configure(const Setup& setup)
  {
    this->Configured = setup;
    this->Layout = RowLayout(setup.Integrands);
    this->OnConfigure();
  }
  const RowLayout& GetLayout() const { return this->Layout; }

  /// Prepares the faces for items, with all work that does not count as integration.
  virtual bool Acquire(const std::vector<CutFacePointer>& faces, const ProgressCallback& progress) = 0;
  /// Returns the reason why a face of the last Acquire() cannot be integrated by this runner; empty if it can.
  virtual std::string GetFaceError(std::size_t face) const = 0;
  /// Returns the group of a face. Only faces of one group may share a batch.
  virtual int GetGroup(std::size_t face) const = 0;
  /// Returns the largest number of items that may have rows at a time.
  virtual std::size_t GetRowLimit() const = 0;

  /// Sets the faces to which the slots of the following items refer.
  virtual bool BeginBatch(const std::vector<BatchFace>& faces) = 0;
  virtual bool BeginRows(std::size_t rows) = 0;

  /// Evaluates items[active[i]] and sets unconverged[i] to 1 if its differences are above the tolerances, else to 0.
  /// `evaluations` is increased by the number of points of panels and ribbons.
  virtual bool Run(const std::vector<WorkItem>& items, const std::vector<std::size_t>& active,
    std::vector<std::uint8_t>& unconverged, std::int64_t& evaluations,
    const ContinueCallback& shouldContinue) = 0;

  /// Computes the sums of all columns over each segment [first, last) of rows, GetLayout().GetStride() doubles each, and the
  /// maximum of the column LargestGap. An empty segment has zeros. Sums are compensated; a NaN is preserved.
  using Segment = std::pair<unsigned int, unsigned int>;
  virtual bool Sum(
    const std::vector<Segment>& segments, std::vector<double>& sums, std::vector<double>& largestGaps) = 0;

  /// Ends a run and releases the faces of Acquire(). Resident faces are kept within their own memory budget.
  virtual void Release() = 0;

  /// Returns the seconds that the last Acquire() needed for work that belongs to no face (shaders).
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

/// Number of Gauss-Newton steps to the foot point of a gap.
constexpr int FootPointSteps = 3;
}

#endif
