/**
 * @file smItemRunner.h
 * @brief Interface of the GPU and CPU runners, which evaluate items of integration (panels, ribbons, caps)
 * and sum their results
 */
#ifndef smItemRunner_h
#define smItemRunner_h

#include "Engine/smFaceIntegrals.h"
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
/// Consecutive rows [Begin, End) of the items of one kind of a face, those of ribbons of one coedge. Parts of
/// a face are consecutive, too.
struct RowPart
{
  std::uint32_t Slot = 0;
  ItemKind Kind = ItemKind::Panel;
  /// Index of the coedge of ribbons within the face; -1: none.
  int Coedge = -1;
  std::uint32_t Begin = 0, End = 0;

  /// Returns true if rows of this slot, kind and coedge belong to the part.
  bool Continues(std::uint32_t slot, ItemKind kind, int coedge) const
  {
    return this->Slot == slot && this->Kind == kind && this->Coedge == coedge;
  }
};

/// The largest gap along a part of the boundary, and the integrals of the squared gap and of the gap.
struct RowGaps
{
  double Largest = 0.0, Squared = 0.0, Area = 0.0;

  void Add(const RowGaps& other)
  {
    this->Largest = GetLargerGap(this->Largest, other.Largest);
    this->Squared += other.Squared;
    this->Area += other.Area;
  }
};

/// What the rows of a face add up to, for one integrand: sums of panels, of ribbons and caps, of errors and
/// of roundings.
struct RowTotal
{
  double Face = 0.0, Chain = 0.0, Error = 0.0, Rounding = 0.0;
};

/// What the rows of some faces add up to.
class FaceTotals
{
public:
  /// All sums are 0.
  FaceTotals(std::size_t faces, std::size_t integrands)
    : Gaps(faces)
    , Integrands(integrands)
    , Values(faces * integrands)
  {
  }

  RowTotal& At(std::size_t face, std::size_t integrand)
  {
    return this->Values[face * this->Integrands + integrand];
  }
  const RowTotal& At(std::size_t face, std::size_t integrand) const
  {
    return this->Values[face * this->Integrands + integrand];
  }
  std::size_t GetNumberOfFaces() const { return this->Gaps.size(); }

  /// By face.
  std::vector<RowGaps> Gaps;

private:
  std::size_t Integrands;
  std::vector<RowTotal> Values;
};

/**
 * Methods are called in this order:
 *   1. Configure(): integrands and constants.
 *   2. Acquire(): the cut faces of the run. Faces with GetFaceError() have no items.
 *   3. BeginBatch() for some faces of one GetGroup(); for this batch
 *   4. BeginRows() for a list of items, each with its own row, which has no meaning until the item ran,
 *   5. Run() for any of these items, any number of times. An item has its orders and flags in its record. Its
 *   sums are compared with the content of its row (unless a flag excludes the comparison) and then overwrite
 *   it, so that an item can be repeated at a higher order,
 *   6. AddUp() of parts of the rows, and GetUnconverged(), in any order: a GPU is read in these two alone.
 * Steps 3 to 6 repeat; Release() ends the run. The integrator chooses orders and tolerances, not the runner.
 *
 * The row of an item depends only on the item, its face, and the arguments of Configure() and BeginBatch();
 * the sum of a part depends only on its rows and their order. Results are therefore bitwise the same for any
 * order, batch, number of threads or dispatches.
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

  /// Sets integrands and constants, from the next BeginBatch() on. GetObstacle() must be empty for all
  /// integrands.
  void Configure(const Setup& setup)
  {
    this->Configured = setup;
    this->Layout = RowLayout(setup.Integrands);
    this->OnConfigure();
  }
  const RowLayout& GetLayout() const { return this->Layout; }

  /// Prepares the faces for items, with all work that does not count as integration.
  virtual bool Acquire(const std::vector<CutFacePointer>& faces, const ProgressCallback& progress) = 0;
  /// Returns the reason why a face of the last Acquire() cannot be integrated by this runner; empty if it
  /// can.
  virtual std::string GetFaceError(std::size_t face) const = 0;
  /// Returns the group of a face. Only faces of one group may share a batch.
  virtual int GetGroup(std::size_t face) const = 0;
  /// Returns the largest number of items that may have rows at a time.
  virtual std::size_t GetRowLimit() const = 0;

  ///@{
  /// Whether the code that evaluates an item has been compared with that of the CPU, see
  /// FindRunnerDifference(), and to report it.
  virtual bool IsProved(const WorkItem&) const { return true; }
  virtual void SetProved(const WorkItem&) {}
  virtual void ForgetProofs() {}
  ///@}

  /// Sets the faces to which the slots of the following items refer.
  virtual bool BeginBatch(const std::vector<BatchFace>& faces) = 0;
  virtual bool BeginRows(std::size_t rows) = 0;

  /// Evaluates items[active[i]]. `evaluations` is increased by the number of points of panels and ribbons.
  virtual bool Run(const WorkItems& items, const ActiveItems& active, std::int64_t& evaluations,
    const ContinueCallback& shouldContinue) = 0;

  /// Sets unconverged[i] to 1 if the differences of items[active[i]] of the last Run() are above the
  /// tolerances, else to 0.
  virtual bool GetUnconverged(std::vector<std::uint8_t>& unconverged) = 0;

  /// Adds what the rows of each part sum up to: values, errors and roundings to the totals of the part's
  /// face, where each addition adds its rounding; its gaps to those of the face and, for a coedge, to `gaps`.
  /// `totals` has an entry for each face of the parts, in their order; `gaps` gets one for each part of a
  /// coedge. Sums within a part are compensated; a NaN is preserved.
  virtual bool AddUp(const std::vector<RowPart>& parts, FaceTotals& totals, std::vector<RowGaps>& gaps) = 0;

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
