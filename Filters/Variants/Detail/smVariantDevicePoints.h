/**
 * @file smVariantDevicePoints.h
 * @brief Frozen samples of the faces that move, as the compute shaders read them
 */
#ifndef smVariantDevicePoints_h
#define smVariantDevicePoints_h

#include "smVariantErrors.h"
#include "smVariantSums.h"

#include <array>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

namespace sm
{
enum class DeviceStep
{
  Panels,
  Ribbons,
  Caps,
  Bounds
};

/// Items that one program evaluates.
struct DeviceGroup
{
  DeviceStep Step = DeviceStep::Panels;
  /// Of the patches.
  int Degree[2] = { 0, 0 };
  /// The net is in a buffer, and the program is for all degrees.
  bool IsNetInBuffer = false;
  std::uint32_t FirstWord = 0;
  std::uint32_t WordsOfItem = 0;
  /// Samples of each item, and iterations of loops by which an invocation evaluates it.
  std::vector<std::uint32_t> Costs;
  std::vector<std::uint32_t> Steps;
};

/// Returns about the multiply-adds by which an invocation evaluates an item: the flux of a sample, and what
/// an iteration multiplies.
inline std::uint64_t CountWork(std::uint64_t samples, std::uint64_t steps)
{
  return 40 * samples + 9 * steps;
}

/// Largest degree of patches whose nets are in registers.
constexpr int MaximumRegisterDegree = 3;
/// Work after which an item of panels is divided, so that dispatches of whole batches stay short.
constexpr std::uint64_t MaximumItemWork = 65536;

struct DevicePoints
{
  std::vector<double> Numbers;
  std::vector<std::uint32_t> Words;
  std::vector<DeviceGroup> Groups;
  /// Numbers of the largest net in a buffer.
  std::size_t MaxNet = 0;
  /// Samples, with three for each node of a ribbon and nine for a cap.
  std::int64_t Samples = 0;
  /// False where a bound is not known for any c.
  bool HasBounds = true;
  /// What nothing moves: faces, and patches, ribbons and caps of faces that move.
  std::array<double, NumberOfMoments> Constant{};
  std::array<double, NumberOfMoments> ConstantBound{};
  /// Errors of the faces that move, with what the device's way of evaluation adds.
  std::vector<PointsErrors> Errors;
  /// Errors of all faces.
  std::size_t Terms = 0;
};

/**
 * Writes faces. What no direction moves is summed here; of each patch, ribbon and cap only the directions
 * that move it are kept.
 *
 * The shaders evaluate derivatives of panels by the control points themselves, where the CPU has their
 * differences. An error e of all points, relative to the patch's centre, moves a derivative by 2 degree e, so
 * that each panel's error of a derivative grows by 2 degree times that of the position.
 */
class DevicePointsWriter
{
public:
  DevicePointsWriter();
  void AddFace(const VariantFaceChain& chain);
  DevicePoints Finish();

private:
  /// Step and degrees.
  using GroupKey = std::tuple<DeviceStep, int, int>;
  struct Items
  {
    std::vector<std::uint32_t> Words;
    std::vector<std::uint32_t> Costs;
    std::vector<std::uint32_t> Steps;
  };

  std::uint32_t AddList(const VariantFaceChain& chain, const std::vector<int>& variables);
  void AddPatch(
    const VariantFaceChain& chain, std::uint32_t patch, const std::vector<const VariantPanel*>& panels);
  std::uint32_t AddMatrix(const VariantPatch& patch, const std::vector<int>& variables);
  std::uint32_t AddPanel(const VariantFaceChain& chain, const VariantPanel& panel, const VariantPatch& patch);
  /// Adds samples that no direction moves; `visit` calls its argument with each.
  template <typename Visit>
  void AddConstant(const Visit& visit);
  void AddRibbon(const VariantFaceChain& chain, const VariantRibbon& ribbon);
  void AddCap(const VariantFaceChain& chain, const VariantCap& cap);
  void AddErrorsOf(const VariantFaceChain& chain);
  void AddItem(
    const GroupKey& key, const std::vector<std::uint32_t>& words, std::size_t cost, std::size_t steps);

  DevicePoints Result;
  std::map<GroupKey, Items> Groups;
  VariantMonomials One;
  VariantTotals Totals;
  VariantMap Map;
};
}

#endif
