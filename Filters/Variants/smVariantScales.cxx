#include "Detail/smVariantScales.h"

#include "smFailureReason.h"
#include "smParallelFor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace sm
{
namespace
{
constexpr std::size_t FacesOfPortion = 16;
}

std::string FindProblem(const VariantOptions& options, int directions)
{
  if (!options.Ranges.empty() && options.Ranges.size() != static_cast<std::size_t>(directions))
  {
    return std::to_string(options.Ranges.size()) + " ranges do not fit " + std::to_string(directions) +
      " directions: give one for each, or none";
  }
  for (const double range : options.Ranges)
  {
    if (!(range > 0.0) || !std::isfinite(range))
    {
      return "a range that is not positive and finite does not limit |c|: give the largest |c| that matters";
    }
  }
  if (!(options.Tolerance >= 1e-15 && options.Tolerance <= 1.0))
  {
    return "the tolerance is outside 1e-15 to 1: 1e-12 suits most solids";
  }
  return {};
}

VariantChainOptions MakeChainOptions(const VariantShape& shape, const VariantOptions& options)
{
  vtkTrimmedNURBSModel* model = shape.GetBase();
  double box[6] = {};
  std::copy(model->GetLocalBounds(), model->GetLocalBounds() + 6, box);
  if (!(box[1] > box[0] || box[3] > box[2] || box[5] > box[4]))
  {
    for (int c = 0; c < 3; ++c)
    {
      box[2 * c] = std::numeric_limits<double>::max();
      box[2 * c + 1] = -box[2 * c];
    }
    for (const VariantFace& face : shape.GetFaces())
    {
      for (const std::array<double, 4>& point : face.Source->Surface.ControlPoints)
      {
        for (int c = 0; c < 3; ++c)
        {
          box[2 * c] = std::min(box[2 * c], point[c] / point[3]);
          box[2 * c + 1] = std::max(box[2 * c + 1], point[c] / point[3]);
        }
      }
    }
  }
  VariantChainOptions result;
  double size = 0.0;
  double volume = 1.0;
  for (int c = 0; c < 3; ++c)
  {
    // 24 bits are enough, and a rounded middle is exact.
    result.Reference[c] = static_cast<float>(0.5 * (box[2 * c] + box[2 * c + 1]));
    size = std::max(size, box[2 * c + 1] - box[2 * c]);
    volume *= box[2 * c + 1] - box[2 * c];
  }
  volume =
    model->GetVolumeScale() > 0.0 ? model->GetVolumeScale() : std::max(volume, 1e-3 * size * size * size);
  result.Scales = { volume, volume * std::cbrt(volume), volume * std::cbrt(volume) * std::cbrt(volume) };
  result.Ranges = options.Ranges;
  result.Ranges.resize(shape.GetNumberOfDirections(), 1.0);
  result.Tolerance = options.Tolerance;
  double items = 1.0;
  for (const VariantFace& face : shape.GetFaces())
  {
    // The number of knot spans and trim pieces, about that of panels and ribbons.
    const NURBSSurface& surface = face.Source->Surface;
    items += static_cast<double>(surface.GetSpanBreaks(0).size() * surface.GetSpanBreaks(1).size());
    for (const Loop& loop : face.Source->Loops)
    {
      for (const Coedge& coedge : loop.Coedges)
      {
        items += 2.0 * coedge.Curve.GetNumberOfPieces();
      }
    }
  }
  result.Items = items;
  return result;
}

ProgressCallback GetPartOf(const ProgressCallback& progress, double first, double last)
{
  if (!progress)
  {
    return {};
  }
  return [=](double fraction) { return progress(first + (last - first) * fraction); };
}

bool MakeChains(const VariantShape& shape, const VariantChainOptions& options,
  const ProgressCallback& progress, std::vector<VariantFaceChain>& chains, std::string& error)
{
  const std::size_t count = shape.GetFaces().size();
  chains.resize(count);
  std::vector<std::string> problems(count);
  const auto make = [&](std::size_t i)
  {
    try
    {
      chains[i] = MakeFaceChain(shape, i, options);
    }
    catch (const std::runtime_error& problem)
    {
      problems[i] = problem.what();
    }
  };
  // Progress is reported by the calling thread, between portions of the faces.
  const std::size_t portion = progress ? FacesOfPortion : std::max<std::size_t>(count, 1);
  for (std::size_t first = 0; first < count; first += portion)
  {
    if (progress && !progress(static_cast<double>(first) / static_cast<double>(count)))
    {
      error = StoppedReason;
      return false;
    }
    ParallelFor(std::min(portion, count - first), 1,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          make(first + i);
        }
      });
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!problems[i].empty())
    {
      error = "face " + std::to_string(i) + ": " + problems[i] +
        ": its variants cannot be integrated, edit the face";
      return false;
    }
  }
  return true;
}

std::string ExplainFailure(const std::exception_ptr& failure)
{
  return std::string("the variants could not be prepared: ") + GetReason(failure) +
    "; nothing can be evaluated: use fewer directions or faces, or frozen points";
}

void HideNotFinite(const double* c, std::size_t directions, std::size_t n,
  const std::vector<std::pair<double*, std::size_t>>& results)
{
  for (std::size_t i = 0; i < n; ++i)
  {
    if (std::all_of(
          c + i * directions, c + (i + 1) * directions, [](double number) { return std::isfinite(number); }))
    {
      continue;
    }
    for (const auto& [to, size] : results)
    {
      if (to)
      {
        std::fill_n(to + i * size, size, std::numeric_limits<double>::quiet_NaN());
      }
    }
  }
}

std::vector<VariantGap> FindGaps(const std::vector<VariantFaceChain>& chains, int directions)
{
  std::vector<VariantGap> gaps(directions);
  for (std::size_t f = 0; f < chains.size(); ++f)
  {
    for (std::size_t a = 1; a < chains[f].Gaps.size(); ++a)
    {
      VariantGap& gap = gaps[chains[f].Directions[a - 1]];
      if (chains[f].Gaps[a] > gap.Distance)
      {
        gap = { chains[f].Gaps[a], static_cast<int>(f) };
      }
    }
  }
  return gaps;
}
}
