#include "smBuoyancy.h"
#include "Detail/smChainExtent.h"
#include "Detail/smSubmergedStrips.h"
#include "smBodyScales.h"
#include "smCoedgeGaps.h"
#include "smParallelFor.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include "vtkTimerLog.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>

namespace sm
{
namespace
{
// Shares of a face's tolerance for cutting and for the quadrature. Rotating first moments to the world's axes
// multiplies their bounds by at most sqrt(3), and a face may be twice as far from the frame's origin as the
// radius.
constexpr double CutShare = 0.125;
constexpr double QuadratureShare = 0.4;
/// Number of quantities of the submerged part, and degrees of the moments of the section, which follow them
/// in the list of integrands.
constexpr std::size_t Quantities = 4;
constexpr int SectionDegrees[] = { 0, 1, 1, 2, 2, 2 };
// Share of the progress for cutting all faces, and faces cut at the waterline between two reports of
// progress.
constexpr double CutProgress = 0.5;
// Roundings of a placement's entries and of the plane's normal, relative to the distance of a point.
constexpr double PlacementRoundings = 8.0;
constexpr std::size_t CutsPerReport = 64;

/// Transforms the values or bounds of one kind of a face's results to moments about the world's origin, along
/// its axes.
void ToWorld(const Point3& origin, const std::array<Point3, 3>& axes, std::vector<double>& values, bool bound)
{
  std::vector<double> world = values;
  world[0] = values[0];
  for (int c = 0; c < 3; ++c)
  {
    world[1 + c] = (bound ? std::abs(origin[c]) : origin[c]) * values[0];
    for (int k = 0; k < 3; ++k)
    {
      world[1 + c] += (bound ? std::abs(axes[k][c]) : axes[k][c]) * values[1 + k];
    }
  }
  values = std::move(world);
}

/// Adds the results of one part of a face to those of the face.
void AddPart(const FaceIntegrals& from, FaceIntegrals& to)
{
  const std::pair<std::vector<double>*, const std::vector<double>*> pairs[] = { { &to.Face, &from.Face },
    { &to.Closing, &from.Closing }, { &to.QuadratureError, &from.QuadratureError },
    { &to.Rounding, &from.Rounding }, { &to.Conversion, &from.Conversion },
    { &to.Residual, &from.Residual } };
  for (const auto& [sum, more] : pairs)
  {
    for (std::size_t k = 0; k < sum->size(); ++k)
    {
      (*sum)[k] += (*more)[k];
    }
  }
  to.Estimated = to.Estimated || from.Estimated;
  to.Skipped = to.Skipped || from.Skipped;
  to.LeftOut = to.LeftOut || from.LeftOut;
  AddGaps(from, to);
  to.CoverageDefects += from.CoverageDefects;
  to.Overlap = std::max(to.Overlap, from.Overlap);
  to.Outside.Add(from.Outside);
  to.IsContinued = to.IsContinued || from.IsContinued;
  to.Error = from.Error.empty() ? to.Error : from.Error;
}
}

void DisplacedMoments::Add(const DisplacedMoments& other)
{
  for (int c = 0; c < 3; ++c)
  {
    const double shift = other.Origin[c] - this->Origin[c];
    this->First[c] += other.First[c] + shift * other.Volume;
    this->FirstBound[c] += other.FirstBound[c] + std::abs(shift) * other.VolumeBound +
      4.0 * UnitRoundoff *
        (std::abs(this->First[c]) + std::abs(other.First[c]) +
          (std::abs(other.Origin[c]) + std::abs(this->Origin[c])) * std::abs(other.Volume));
  }
  this->Volume += other.Volume;
  this->VolumeBound += other.VolumeBound + 2.0 * UnitRoundoff * std::abs(this->Volume);
}

Point3 DisplacedMoments::GetCenter(double& bound) const
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double size = std::abs(this->Volume);
  if (!(size > this->VolumeBound))
  {
    bound = nan;
    return { nan, nan, nan };
  }
  // Bound of a quotient: |m/V - c| <= (b_i + |c_i| b) / (|V| - b).
  Point3 center;
  bound = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    const double local = this->First[c] / this->Volume;
    center[c] = this->Origin[c] + local;
    bound = std::max(bound,
      (this->FirstBound[c] + std::abs(local) * this->VolumeBound) / (size - this->VolumeBound) +
        4.0 * UnitRoundoff * (std::abs(local) + std::abs(this->Origin[c])));
  }
  return center;
}

CutLimits BuoyancyIntegrator::MakeLimits(
  const CutFace& face, const WaterlineFrame& frame, const Tolerance& tolerance) const
{
  CutLimits limits;
  limits.Volume = CutShare * tolerance.Volume;
  if (this->WithSection)
  {
    const Face& source = *face.Source;
    double moved = 0.0;
    for (const Patch& patch : face.Panels.Patches)
    {
      moved = std::max(moved, Norm(patch.Displacement));
    }
    limits.Area = CutShare * tolerance.Area;
    // Control points as extracted and as read, a fitted surface, the plane, and the rounding of the
    // placement's entries.
    limits.Displacement = moved + Norm(source.Surface.Rounding) + source.Surface.Residual + frame.PlaneBound +
      PlacementRoundings * UnitRoundoff * GetReach(face.Panels, {});
  }
  return limits;
}

bool BuoyancyIntegrator::CutFaces(const std::vector<CutFacePointer>& faces, const HeightPlane& plane,
  const std::vector<CutLimits>& limits, const ProgressCallback& progress, std::vector<SubmergedFace>& below)
{
  below.assign(faces.size(), {});
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (const SubmergedFace* known = this->Below.Find(faces[i]->Source->Id, { plane, limits[i] }))
    {
      below[i] = *known;
    }
    else
    {
      missing.push_back(i);
    }
  }
  for (std::size_t begin = 0; begin < missing.size(); begin += CutsPerReport)
  {
    if (!progress(static_cast<double>(begin) / static_cast<double>(missing.size())))
    {
      return false;
    }
    const std::size_t end = std::min(begin + CutsPerReport, missing.size());
    ParallelFor(end - begin, 1,
      [&](std::size_t from, std::size_t to)
      {
        for (std::size_t i = begin + from; i < begin + to; ++i)
        {
          below[missing[i]] = CutBelow(faces[missing[i]], plane, limits[missing[i]]);
        }
      });
    for (std::size_t k = begin; k < end; ++k)
    {
      const std::size_t i = missing[k];
      std::size_t bytes = 0;
      for (const CutFacePointer& part : below[i].Parts)
      {
        // A face that is entirely below the plane is kept and counted by the other cache.
        bytes += part && part != faces[i] ? CountBytes(*part) : 0;
      }
      this->Below.Store(faces[i]->Source->Id, { plane, limits[i] }, below[i], bytes);
    }
  }
  return true;
}

void BuoyancyIntegrator::ReleaseMemory()
{
  this->Below.Clear();
  this->Cuts.Clear();
}

bool BuoyancyIntegrator::CutAtWaterline(const BodyIntegrals& body, const Waterline& waterline,
  const Tolerance& tolerance, const ProgressCallback& progress, CutBody& cut)
{
  const std::vector<FacePointer>& sources = body.Model->GetFaces();
  // Progress: the first half is cutting faces into panels, the second half cutting panels at the waterline.
  const auto firstHalf = [&progress](double fraction) { return progress(0.5 * fraction); };
  const auto secondHalf = [&progress](double fraction) { return progress(0.5 + 0.5 * fraction); };
  if (!this->Cuts.Acquire(sources, cut.Faces, firstHalf))
  {
    this->CutError = this->WasCutAborted ? "" : this->Cuts.GetError();
    return false;
  }
  WaterlineFrame& frame = cut.View;
  frame = WaterlineFrame::Make(body, waterline);
  std::vector<CutLimits> limits;
  for (const CutFacePointer& face : cut.Faces)
  {
    limits.push_back(this->MakeLimits(*face, frame, tolerance));
  }
  if (!this->CutFaces(cut.Faces, frame.Plane, limits, secondHalf, cut.Below))
  {
    return false;
  }
  cut.AreaErrors.assign(sources.size(), 0.0);
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    const SubmergedFace& below = cut.Below[i];
    const bool isWhole = below.Parts[0] == cut.Faces[i];
    cut.IsWhole = cut.IsWhole && isWhole;
    cut.AreaErrors[i] = below.AreaError;
    cut.IsCrossed = cut.IsCrossed || below.AreaError > 0.0 || !cut.Faces[i]->Error.empty() ||
      (!isWhole && (below.Parts[0] || below.Parts[1]));
  }
  // Adds the error of faces that are below or above the plane by no more than the rounding error of the plane
  // and of their own numbers: a body found to be entirely on one side may have a thin sheet on the other
  // side.
  const double planeBound = frame.PlaneBound + 2.0 * UnitRoundoff * frame.Reach;
  cut.VolumeErrors.assign(sources.size(), 0.0);
  cut.Errors.resize(sources.size());
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    const SubmergedFace& below = cut.Below[i];
    const double rounded = planeBound + Norm(sources[i]->Surface.Rounding);
    const bool isWhole = below.Parts[0] == cut.Faces[i];
    const bool isNothing = !below.Parts[0] && !below.Parts[1];
    const FacePanels& panels = cut.Faces[i]->Panels;
    const bool mayHaveSheet =
      (isNothing || (cut.IsWhole && isWhole)) && MayTouch(panels, frame.Plane, 2.0 * rounded);
    cut.VolumeErrors[i] =
      below.CutError + (mayHaveSheet ? 2.0 * rounded * GetMaxArea(panels, GetStripArea(*cut.Faces[i])) : 0.0);
    cut.Errors[i] = cut.Faces[i]->Error;
  }
  if (cut.IsWhole)
  {
    frame.MoveToMiddle();
  }
  return true;
}

namespace
{
/// Returns the area that the border of a part with one patch sweeps by the displacement of its control
/// points. The planner takes such a patch for a whole face, with no neighbour that is displaced by itself.
double GetSweptBorder(const FacePanels& part)
{
  if (part.Patches.size() != 1)
  {
    return 0.0;
  }
  const Patch& patch = part.Patches[0];
  return 2.0 * Norm(patch.Displacement) * (patch.Stretch[0] + patch.Stretch[1]);
}
}

void BuoyancyIntegrator::AddTasks(CutBody& cut, std::size_t body, const Tolerance& tolerance,
  std::vector<FaceTask>& tasks, std::vector<Place>& places) const
{
  WaterlineFrame& frame = cut.View;
  FaceTask task;
  task.Placement = frame.Placement;
  task.Tolerances.assign(Quantities, QuadratureShare * tolerance.Volume * frame.Reach);
  task.Tolerances[0] = 2.0 * QuadratureShare * tolerance.Volume;
  for (std::size_t k = Quantities; k < this->GetNumberOfQuantities(); ++k)
  {
    task.Tolerances.push_back(
      QuadratureShare * tolerance.Area * std::pow(frame.Reach, SectionDegrees[k - Quantities]));
  }
  // Origin of the frame in the model's coordinates, as placements are orthonormal.
  Point3 center{};
  for (int j = 0; j < 3; ++j)
  {
    for (int k = 0; k < 3; ++k)
    {
      center[j] -= frame.Placement[4 * k + j] * frame.Placement[4 * k + 3];
    }
  }
  for (std::size_t i = 0; i < cut.Faces.size(); ++i)
  {
    const double moved = frame.PlaneBound + (cut.IsWhole ? 0.0 : 2.0 * UnitRoundoff * frame.Reach);
    const SubmergedFace& below = cut.Below[i];
    for (const CutFacePointer& part : below.Parts)
    {
      if (part)
      {
        task.Source = part->Source;
        task.Cut = part;
        tasks.push_back(task);
        if (below.Parts[0] && below.Parts[1])
        {
          for (double& own : tasks.back().Tolerances)
          {
            own *= 0.5;
          }
          // The plane crosses the face, so that no height exceeds twice the radius.
          const double swept = GetSweptBorder(part->Panels);
          cut.VolumeErrors[i] += 2.0 * frame.Reach * swept;
          cut.AreaErrors[i] += swept;
        }
        places.push_back({ body, i });
        cut.VolumeErrors[i] += moved * GetMaxArea(part->Panels, below.StripArea);
      }
    }
    const bool isUncertain = cut.VolumeErrors[i] > 0.0 || cut.AreaErrors[i] > 0.0;
    frame.Reach = std::max(frame.Reach, isUncertain ? GetReach(cut.Faces[i]->Panels, center) : 0.0);
  }
}

namespace
{
/// Sums the section's moments of all faces. `rounding` is the relative rounding of the sums.
void SumSection(const std::vector<FaceIntegrals>& faces, double rounding, SectionMoments& section)
{
  double* const values[] = { &section.Area, &section.First[0], &section.First[1], &section.Second[0],
    &section.Second[1], &section.Second[2] };
  double* const bounds[] = { &section.AreaBound, &section.FirstBound[0], &section.FirstBound[1],
    &section.SecondBound[0], &section.SecondBound[1], &section.SecondBound[2] };
  for (std::size_t k = 0; k < std::size(values); ++k)
  {
    for (const FaceIntegrals& face : faces)
    {
      const std::size_t column = Quantities + k;
      *values[k] -= face.Face[column] + face.Closing[column];
      *bounds[k] += face.Error.empty()
        ? face.GetBound(column) + rounding * (std::abs(face.Face[column]) + std::abs(face.Closing[column]))
        : std::numeric_limits<double>::infinity();
    }
  }
}
}

void BuoyancyIntegrator::SumBody(const CutBody& cut, BodyBuoyancy& result) const
{
  const WaterlineFrame& frame = cut.View;
  DisplacedMoments& total = result.Total;
  total.Origin = frame.Origin;
  std::vector<double> sums(Quantities, 0.0);
  std::vector<double> bounds(Quantities, 0.0);
  double magnitude = 0.0;
  for (std::size_t i = 0; i < result.Faces.size(); ++i)
  {
    FaceIntegrals& face = result.Faces[i];
    face.Error = face.Error.empty() ? cut.Errors[i] : face.Error;
    for (std::size_t k = 0; k < Quantities; ++k)
    {
      face.Conversion[k] += cut.VolumeErrors[i] * (k == 0 ? 1.0 : frame.Reach);
      sums[k] += face.Face[k] + face.Closing[k];
      bounds[k] += face.Error.empty() ? face.GetBound(k) : std::numeric_limits<double>::infinity();
    }
    for (std::size_t k = Quantities; k < this->GetNumberOfQuantities(); ++k)
    {
      face.Conversion[k] += cut.AreaErrors[i] * std::pow(frame.Reach, SectionDegrees[k - Quantities]);
    }
    magnitude += std::abs(face.Face[0]) + std::abs(face.Closing[0]);
  }
  // Rounding of sums with this number of terms.
  const double relative = UnitRoundoff * static_cast<double>(result.Faces.size() + 8);
  const double rounding = relative * magnitude;
  result.Section.Origin = frame.PlaneOrigin;
  result.Section.Axes = { frame.Axes[0], frame.Axes[1] };
  if (cut.IsCrossed && this->WithSection)
  {
    SumSection(result.Faces, relative, result.Section);
  }
  bounds[0] += rounding;
  for (std::size_t k = 1; k < Quantities; ++k)
  {
    bounds[k] += rounding * frame.Reach;
  }
  total.Volume = sums[0];
  total.VolumeBound = bounds[0];
  for (int c = 0; c < 3; ++c)
  {
    for (int k = 0; k < 3; ++k)
    {
      total.First[c] += frame.Axes[k][c] * sums[1 + k];
      total.FirstBound[c] += std::abs(frame.Axes[k][c]) * bounds[1 + k];
    }
  }
  for (FaceIntegrals& face : result.Faces)
  {
    const double volume = std::abs(face.Face[0]) + std::abs(face.Closing[0]);
    ToWorld(frame.Origin, frame.Axes, face.Face, false);
    ToWorld(frame.Origin, frame.Axes, face.Closing, false);
    ToWorld(frame.Origin, frame.Axes, face.QuadratureError, true);
    ToWorld(frame.Origin, frame.Axes, face.Rounding, true);
    ToWorld(frame.Origin, frame.Axes, face.Conversion, true);
    for (int c = 0; c < 3; ++c)
    {
      face.Rounding[1 + c] += 8.0 * UnitRoundoff * (std::abs(frame.Origin[c]) + frame.Reach) * volume;
    }
  }
}

std::vector<Integrand> BuoyancyIntegrator::MakeIntegrands() const
{
  std::vector<Integrand> integrands = { Integrand::HeightMoment("V", 0, 0, 0),
    Integrand::HeightMoment("X", 1, 0, 0), Integrand::HeightMoment("Y", 0, 1, 0),
    Integrand::HeightMoment("Z", 0, 0, 1) };
  if (this->WithSection)
  {
    for (const auto& [name, i, j] :
      { std::make_tuple("A", 0, 0), std::make_tuple("AX", 1, 0), std::make_tuple("AY", 0, 1),
        std::make_tuple("AXX", 2, 0), std::make_tuple("AYY", 0, 2), std::make_tuple("AXY", 1, 1) })
    {
      integrands.push_back(Integrand::SectionMoment(name, i, j));
    }
  }
  return integrands;
}

bool BuoyancyIntegrator::CutBodies(const std::vector<BodyIntegrals>& bodies, const Waterline& waterline,
  double relativeTolerance, const ProgressCallback& progress, std::vector<CutBody>& cuts,
  std::vector<FaceTask>& tasks, std::vector<Place>& places)
{
  cuts.assign(bodies.size(), {});
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    const auto report = [&](double fraction)
    {
      const double done = (static_cast<double>(b) + fraction) / static_cast<double>(bodies.size());
      this->WasCutAborted = this->WasCutAborted || (progress && !progress(CutProgress * done));
      return !this->WasCutAborted;
    };
    vtkTrimmedNURBSModel& model = *bodies[b].Model;
    const double share =
      relativeTolerance / static_cast<double>(std::max<std::size_t>(model.GetFaces().size(), 1));
    const Tolerance tolerance{ share * GetVolumeScale(model), share * GetAreaScale(model) };
    if (!this->CutAtWaterline(bodies[b], waterline, tolerance, report, cuts[b]))
    {
      return false;
    }
    AddTasks(cuts[b], b, tolerance, tasks, places);
  }
  return true;
}

bool BuoyancyIntegrator::Integrate(SurfaceIntegrator& integrator, const std::vector<BodyIntegrals>& bodies,
  const Waterline& waterline, double relativeTolerance, const ProgressCallback& progress,
  std::vector<BodyBuoyancy>& results)
{
  const double start = vtkTimerLog::GetUniversalTime();
  this->CutError.clear();
  this->WasCutAborted = false;
  std::vector<FaceTask> tasks;
  std::vector<Place> places;
  std::vector<CutBody> cuts;
  const bool hasCut = this->CutBodies(bodies, waterline, relativeTolerance, progress, cuts, tasks, places);
  this->CutSeconds = vtkTimerLog::GetUniversalTime() - start;
  const auto integrating = [&progress](double fraction)
  { return !progress || progress(CutProgress + (1.0 - CutProgress) * fraction); };
  std::vector<FaceIntegrals> integrals;
  const bool done = hasCut && integrator.Integrate(tasks, integrals, integrating);
  this->Below.EndRun();
  if (!done)
  {
    return false;
  }
  FaceIntegrals zero;
  for (std::size_t k = 0; k < this->GetNumberOfQuantities(); ++k)
  {
    zero.Append(0.0);
  }
  results.assign(bodies.size(), {});
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    results[b].Faces.assign(cuts[b].Faces.size(), zero);
  }
  for (std::size_t i = 0; i < tasks.size(); ++i)
  {
    AddPart(integrals[i], results[places[i].Body].Faces[places[i].Face]);
  }
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    this->SumBody(cuts[b], results[b]);
  }
  return true;
}
}
