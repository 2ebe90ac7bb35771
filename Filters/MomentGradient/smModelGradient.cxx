#include "Detail/smModelGradient.h"

#include "smBodyScales.h"
#include "smFacePanelsCache.h"
#include "smParallelFor.h"
#include "smUnitRoundoff.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <set>

namespace sm
{
namespace
{
// Faces between two reports of progress.
constexpr std::size_t FacesPerReport = 32;
// Faces whose plans and integrals are in memory.
constexpr std::size_t FacesPerPart = 512;
// Fractions of the progress for cutting, and for the bounds of ribbons; the integration takes the rest.
constexpr double CutShare = 0.3;
constexpr double StripShare = 0.2;

/// Calls work(index) for all indices on all threads, with reports of progress from `from` on. Returns false
/// if stopped.
template <class Work>
bool RunFaces(
  std::size_t count, const ProgressCallback& progress, double from, double share, const Work& work)
{
  for (std::size_t begin = 0; begin < count; begin += FacesPerReport)
  {
    if (progress && !progress(from + share * static_cast<double>(begin) / static_cast<double>(count)))
    {
      return false;
    }
    ParallelFor(std::min(FacesPerReport, count - begin), 1,
      [&](std::size_t first, std::size_t last)
      {
        for (std::size_t i = begin + first; i < begin + last; ++i)
        {
          work(i);
        }
      });
  }
  return true;
}

std::set<std::array<double, 3>> GetVertices(const Face& face)
{
  std::set<std::array<double, 3>> vertices;
  for (const Loop& loop : face.Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      vertices.insert({ coedge.Use->StartVertex, coedge.Use->EndVertex });
    }
  }
  return vertices;
}
}

bool ModelGradient::Compute(vtkTrimmedNURBSModel* model, const std::vector<bool>& faces,
  const std::vector<double>& sides, double relativeTolerance, const ProgressCallback& progress,
  PatchIntegrator& integrator, Closing closing)
{
  this->Faces.assign(faces.size(), {});
  this->Evaluations = 0;
  this->Error.clear();
  // The ribbons of all faces along an edge count, and the caps at a vertex, so the neighbours of a face are
  // cut, too.
  std::set<std::array<double, 3>> vertices;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (faces[f] && closing == Closing::Gaps)
    {
      vertices.merge(GetVertices(*model->GetFaces()[f]));
    }
  }
  std::vector<std::size_t> indices;
  std::vector<FacePointer> sources;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const std::set<std::array<double, 3>> own = GetVertices(*model->GetFaces()[f]);
    if (faces[f] ||
      std::any_of(own.begin(), own.end(), [&vertices](const auto& at) { return vertices.count(at) > 0; }))
    {
      indices.push_back(f);
      sources.push_back(model->GetFaces()[f]);
    }
  }
  FacePanelsCache cache;
  std::vector<CutFacePointer> cut;
  const auto cutting = [&progress](double fraction) { return !progress || progress(CutShare * fraction); };
  if (!cache.Acquire(sources, cut, cutting))
  {
    this->Error = cache.GetError();
    return false;
  }
  for (const CutFacePointer& face : cut)
  {
    if (!face->Error.empty())
    {
      this->Error = face->Error;
      return false;
    }
  }
  const double tolerance = std::max(relativeTolerance, 1e-15) * GetAreaScale(*model);
  const double length = GetRadius(*model);
  std::vector<FaceStrips> strips(cut.size());
  if (!RunFaces(cut.size(), progress, CutShare, StripShare,
        [&](std::size_t i)
        {
          strips[i] = closing == Closing::Gaps ? FaceStrips::Make(*cut[i], tolerance)
                                               : FaceStrips::MakeWithout(*cut[i]);
        }))
  {
    this->Error = "aborted";
    return false;
  }
  BodyStrips body;
  double reach = 0.0;
  for (std::size_t i = 0; i < cut.size(); ++i)
  {
    body.Add(*cut[i]->Source, strips[i]);
    reach = std::max(reach, strips[i].Reach);
  }
  std::vector<FaceTask> tasks;
  for (std::size_t i = 0; i < cut.size(); ++i)
  {
    if (faces[indices[i]])
    {
      tasks.push_back({ indices[i], { cut[i].get(), &strips[i], &body, i, reach, tolerance, length } });
    }
  }
  for (std::size_t begin = 0; begin < tasks.size(); begin += FacesPerPart)
  {
    const std::size_t end = std::min(begin + FacesPerPart, tasks.size());
    const auto share = [&tasks](std::size_t count) {
      return (1.0 - CutShare - StripShare) * static_cast<double>(count) / static_cast<double>(tasks.size());
    };
    if (!this->ComputePart({ tasks.begin() + static_cast<std::ptrdiff_t>(begin),
                             tasks.begin() + static_cast<std::ptrdiff_t>(end) },
          sides, integrator, progress, CutShare + StripShare + share(begin), share(end - begin)))
    {
      this->Error = "aborted";
      return false;
    }
  }
  return true;
}

/// Plans the faces, integrates their patches together, and sums up.
bool ModelGradient::ComputePart(const std::vector<FaceTask>& tasks, const std::vector<double>& sides,
  PatchIntegrator& integrator, const ProgressCallback& progress, double from, double share)
{
  std::vector<NetGradientPlan> plans(tasks.size());
  if (!RunFaces(tasks.size(), progress, from, 0.5 * share,
        [&](std::size_t i) { plans[i] = PlanNetGradient(tasks[i].Task); }))
  {
    return false;
  }
  std::vector<PatchTask> patches;
  for (const NetGradientPlan& plan : plans)
  {
    patches.insert(patches.end(), plan.Patches.begin(), plan.Patches.end());
  }
  std::vector<PatchSums> sums;
  if (!integrator.Compute(patches, sums,
        [&](double fraction) { return !progress || progress(from + share * (0.5 + 0.4 * fraction)); }))
  {
    return false;
  }
  std::vector<std::size_t> first(tasks.size(), 0);
  for (std::size_t i = 1; i < tasks.size(); ++i)
  {
    first[i] = first[i - 1] + plans[i - 1].Patches.size();
  }
  std::atomic<std::int64_t> evaluations{ 0 };
  const bool done = RunFaces(tasks.size(), progress, from + 0.9 * share, 0.1 * share,
    [&](std::size_t i)
    {
      NetGradient gradient = FinishNetGradient(tasks[i].Task, plans[i], sums.data() + first[i]);
      for (std::size_t k = 0; sides[tasks[i].Face] < 0.0 && k < gradient.Values.size(); ++k)
      {
        gradient.Values[k] *= k % NumberOfIntegrals < NumberOfMoments ? -1.0 : 1.0;
      }
      evaluations += gradient.Evaluations;
      this->Faces[tasks[i].Face] = std::move(gradient);
    });
  this->Evaluations += evaluations;
  return done;
}

void JoinTied(vtkTrimmedNURBSModel* model, const TiedVariables& tied, std::vector<NetGradient>& faces)
{
  struct Sum
  {
    std::array<long double, NumberOfIntegrals> Values{};
    std::array<double, NumberOfIntegrals> Bounds{};
  };
  // A weight of a group is that of the group's first member times a ratio that stays.
  for (int component = 0; component < 4; ++component)
  {
    const std::vector<std::vector<int>>& groups = component < 3 ? tied.Points : tied.Weights;
    std::map<int, Sum> sums;
    const auto visit = [&](const auto& work)
    {
      for (std::size_t f = 0; f < faces.size(); ++f)
      {
        NetGradient& face = faces[f];
        for (int i = 0; i < face.Count[0]; ++i)
        {
          for (int j = 0; j < face.Count[1]; ++j)
          {
            const std::size_t entry = i + static_cast<std::size_t>(face.Count[0]) * j;
            const double weight = model->GetFaces()[f]->Surface.ControlPoints[entry][3];
            work(sums[groups[f][entry]], face, face.GetIndex(i, j, component), component < 3 ? 1.0 : weight);
          }
        }
      }
    };
    visit(
      [](Sum& sum, const NetGradient& face, std::size_t at, double weight)
      {
        for (int k = 0; k < NumberOfIntegrals; ++k)
        {
          sum.Values[k] += static_cast<long double>(weight) * face.Values[at + k];
          sum.Bounds[k] +=
            weight * (face.Bounds[at + k] + 4.0 * UnitRoundoff * std::abs(face.Values[at + k]));
        }
      });
    visit(
      [](const Sum& sum, NetGradient& face, std::size_t at, double weight)
      {
        for (int k = 0; k < NumberOfIntegrals; ++k)
        {
          face.Values[at + k] = static_cast<double>(sum.Values[k] / weight);
          face.Bounds[at + k] =
            (1.0 + 1e-12) * (sum.Bounds[k] / weight + 4.0 * UnitRoundoff * std::abs(face.Values[at + k]));
        }
      });
  }
}
}
