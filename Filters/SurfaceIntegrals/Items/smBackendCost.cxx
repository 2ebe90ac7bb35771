#include "smBackendCost.h"

#include "smFormat.h"

#include <algorithm>

namespace sm
{
namespace
{
/// Bytes of an item on the GPU: its share of patches, points and coefficients, 123 of the real files on
/// average, and a work record of 64.
constexpr double BytesPerItem = 190.0;
/// Number of integrands of mass properties (smMassIntegrands.h).
constexpr double MassIntegrands = 14.0;
/// Number of integrands that take as long as evaluating the surface: 84 moments were measured to take 2.6
/// times as long as 10.
constexpr double IntegrandsPerSurface = 40.0;

/// Number of intervals between different knots in the domain.
int CountSpans(const NURBSSurface& surface, int direction)
{
  const std::vector<double>& knots = surface.Knots[direction];
  // Nothing has checked the face yet.
  const int degree = std::max(surface.Degree[direction], 0);
  const int last = static_cast<int>(knots.size()) - 1 - degree;
  int spans = 0;
  for (int i = degree; i < last; ++i)
  {
    spans += knots[i] < knots[i + 1] ? 1 : 0;
  }
  return std::max(spans, 1);
}

double GetCPURate(const ProcessorSize& processor, const BackendRates& rates)
{
  const int power = processor.Lanes >= 8 ? 3 : processor.Lanes >= 4 ? 2 : processor.Lanes >= 2 ? 1 : 0;
  return std::max(processor.Threads, 1) * rates.CPUEvaluationsPerSecond[power];
}
}

double CountItems(const Face& face)
{
  double items = static_cast<double>(CountSpans(face.Surface, 0)) * CountSpans(face.Surface, 1);
  for (const Loop& loop : face.Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      items += 1.0 + coedge.Curve.GetNumberOfPieces() + coedge.Use->Curve.GetNumberOfPieces();
    }
  }
  return items;
}

RunSize EstimateSize(const Face& face)
{
  const NURBSSurface& surface = face.Surface;
  const double items = CountItems(face);
  const double coefficients = (1.0 + surface.Degree[0]) * (1.0 + surface.Degree[1]);
  const bool isCurved = surface.Rational && std::min(surface.Degree[0], surface.Degree[1]) > 1;
  return { items * coefficients * (isCurved ? 2.0 : 1.0), items * BytesPerItem };
}

BackendCost EstimateBackends(
  const RunSize& size, std::size_t integrands, const ProcessorSize& processor, const BackendRates& rates)
{
  const double weight =
    (IntegrandsPerSurface + static_cast<double>(integrands)) / (IntegrandsPerSurface + MassIntegrands);
  BackendCost cost;
  cost.Size = size;
  cost.CPUSeconds = rates.CPURunSeconds + weight * size.Evaluations / GetCPURate(processor, rates);
  cost.OpenGLSeconds = rates.ContextSeconds + rates.ProgramSeconds + rates.GPURunSeconds +
    size.Bytes / rates.UploadBytesPerSecond + weight * size.Evaluations / rates.GPUEvaluationsPerSecond;
  return cost;
}

std::string FormatEstimate(double seconds)
{
  return FormatDigits(seconds, 2) + " s";
}
}
