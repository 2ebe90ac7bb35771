#include "Detail/smVariantPoints.h"

#include "Detail/smVariantKernels.h"

#include <cstdint>

namespace sm
{
// Each is compiled for a processor of its own: registers of 2, 4 and 8 doubles.
void AddPoints2(const PointsView& face, const double* c, std::size_t directions, std::size_t count,
  double* sums, double* carries, double* scratch);
#ifdef SM_WIDE_LANES
void AddPoints4(const PointsView& face, const double* c, std::size_t directions, std::size_t count,
  double* sums, double* carries, double* scratch);
void AddPoints8(const PointsView& face, const double* c, std::size_t directions, std::size_t count,
  double* sums, double* carries, double* scratch);
#endif

void AddPoints(const PointsFace& face, const double* c, std::size_t directions, std::size_t count,
  double* sums, double* carries, std::vector<double>& scratch)
{
  const std::size_t lanes = GetVariantLanes();
  constexpr std::size_t alignment = 64;
  scratch.resize((face.NetSize + face.Directions.size() + 1) * lanes + alignment / sizeof(double));
  const auto address = reinterpret_cast<std::uintptr_t>(scratch.data());
  double* const aligned = scratch.data() + (alignment - address % alignment) % alignment / sizeof(double);
#ifdef SM_WIDE_LANES
  const auto add = lanes == 16 ? AddPoints8 : lanes == 8 ? AddPoints4 : AddPoints2;
#else
  const auto add = AddPoints2;
#endif
  const PointsView view{ face.Directions.data(), static_cast<int>(face.Directions.size()), face.NetSize,
    face.Nets.data(), face.Records.data(), face.Blocks.data(), face.Blocks.size() };
  add(view, c, directions, count, sums, carries, aligned);
}
}
