#include "smBuoyancy.h"
#include "smParallelFor.h"
#include "smPlacementError.h"
#include "smSubmergedStrips.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include "vtkTimerLog.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sm
{
namespace
{
using Point3 = std::array<double, 3>;
using Wide = long double;
using Wide3 = std::array<Wide, 3>;

// Shares of a face's tolerance for cutting and for the quadrature. Rotating first moments to the world's axes multiplies their
// bounds by at most sqrt(3), and a face may be twice as far from the frame's origin as the radius.
constexpr double CutShare = 0.125;
constexpr double QuadratureShare = 0.4;
constexpr std::size_t Quantities = 4;
// Share of the progress for cutting all faces, and faces cut at the waterline between two reports of progress.
constexpr double CutProgress = 0.5;
constexpr std::size_t CutsPerReport = 64;

/// Returns the radius of a ball about `center` that contains a cut face.
double GetReach(const FacePanels& panels, const Point3& center)
{
  double reach = 0.0;
  const auto add = [&](const double* p, double radius)
  { reach = std::max(reach, std::hypot(p[0] - center[0], p[1] - center[1], p[2] - center[2]) + radius); };
  for (const Patch& patch : panels.Patches)
  {
    add(patch.Center, patch.Radius);
  }
  for (const Ribbon& ribbon : panels.Ribbons)
  {
    for (int i = 0; i <= ribbon.EdgeDegree; ++i)
    {
      add(panels.Coefficients.data() + ribbon.Edge + 3 * i, 0.0);
    }
  }
  for (const Cap& cap : panels.Caps)
  {
    add(cap.Apex.data(), 0.0);
    add(cap.From.data(), 0.0);
    add(cap.To.data(), 0.0);
  }
  return reach;
}

/// Returns an upper bound of the area of the closed chain of a face: of its patches, ribbons and caps.
double GetLargestArea(const FacePanels& panels, double stripArea)
{
  double area = stripArea;
  for (const Patch& patch : panels.Patches)
  {
    area += patch.Stretch[0] * patch.Stretch[1];
  }
  return area;
}

/// Range of heights above the plane.
struct HeightSpan
{
  double Low = std::numeric_limits<double>::infinity();
  double High = -std::numeric_limits<double>::infinity();

  void Add(double height)
  {
    this->Low = std::min(this->Low, height);
    this->High = std::max(this->High, height);
  }
  /// Returns 1 or -1 if all heights are above or below the plane by more than the distance, else 0.
  int GetSide(double distance) const { return this->Low > distance ? 1 : this->High < -distance ? -1 : 0; }
};

/// Returns the side of the plane on which a patch is, see HeightSpan.
int FindSide(const FacePanels& panels, const Patch& patch, const HeightPlane& plane, double distance)
{
  const double middle = plane.GetHeight({ patch.Center[0], patch.Center[1], patch.Center[2] });
  if (std::abs(middle) > 2.0 * patch.Radius + distance)
  {
    return middle > 0.0 ? 1 : -1;
  }
  HeightSpan span;
  for (int i = 0; i < (patch.Degree[0] + 1) * (patch.Degree[1] + 1); ++i)
  {
    const std::array<double, 4>& p = panels.Points[patch.FirstPoint + i];
    span.Add(middle + (plane.Up[0] * p[0] + plane.Up[1] * p[1] + plane.Up[2] * p[2]) / p[3]);
  }
  return span.GetSide(distance);
}

/// Returns false if all of the chain of a face is further from the plane than the distance.
bool MayTouch(const FacePanels& panels, const HeightPlane& plane, double distance)
{
  std::vector<int> sides;
  for (const Patch& patch : panels.Patches)
  {
    sides.push_back(FindSide(panels, patch, plane, distance));
    if (sides.back() == 0)
    {
      return true;
    }
  }
  for (const Ribbon& ribbon : panels.Ribbons)
  {
    HeightSpan span;
    for (int i = 0; i <= ribbon.EdgeDegree; ++i)
    {
      const double* p = panels.Coefficients.data() + ribbon.Edge + 3 * i;
      span.Add(plane.GetHeight({ p[0], p[1], p[2] }));
    }
    if (span.GetSide(distance) != sides[ribbon.Patch])
    {
      return true;
    }
  }
  return std::any_of(panels.Caps.begin(), panels.Caps.end(),
    [&](const Cap& cap)
    {
      HeightSpan span;
      span.Add(plane.GetHeight(cap.Apex));
      span.Add(plane.GetHeight(cap.From));
      span.Add(plane.GetHeight(cap.To));
      return span.GetSide(distance) == 0;
    });
}

/// Transforms the values or bounds of one kind of a face's results to moments about the world's origin, along its axes.
void ToWorld(const Point3& origin, const std::array<Point3, 3>& axes, std::vector<double>& values, bool bound)
{
  std::vector<double> world(Quantities, 0.0);
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
    { &to.Rounding, &from.Rounding }, { &to.Conversion, &from.Conversion } };
  for (const auto& [sum, more] : pairs)
  {
    for (std::size_t k = 0; k < Quantities; ++k)
    {
      (*sum)[k] += (*more)[k];
    }
  }
  to.Estimated = to.Estimated || from.Estimated;
  to.Skipped = to.Skipped || from.Skipped;
  to.CoverageDefects += from.CoverageDefects;
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

BuoyancyIntegrator::Frame BuoyancyIntegrator::MakeFrame(const BodyIntegrals& body, const Waterline& waterline)
{
  const Wide3 up = Normalized(Wide3{ waterline.Up[0], waterline.Up[1], waterline.Up[2] });
  const int least = static_cast<int>(
    std::min_element(up.begin(), up.end(), [](Wide a, Wide b) { return std::abs(a) < std::abs(b); }) -
    up.begin());
  Wide3 axis{};
  axis[least] = 1.0L;
  const Wide3 x = Normalized(Cross(axis, up));
  const std::array<Wide3, 3> axes = { x, Cross(up, x), up };

  const std::array<double, 6> box = GetBox(*body.Model);
  const double* modelOrigin = body.Model->GetOrigin();
  const double* m = body.Placement.data();
  Frame frame;
  // Model origin and middle of the model's box, relative to the waterline's point.
  Wide3 toModel;
  Wide3 toMiddle;
  double distance = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    toModel[i] = static_cast<Wide>(m[4 * i + 3]) - waterline.Point[i];
    Wide local = 0.0L;
    for (int j = 0; j < 3; ++j)
    {
      toModel[i] += static_cast<Wide>(m[4 * i + j]) * modelOrigin[j];
      local += static_cast<Wide>(m[4 * i + j]) * 0.5L * (static_cast<Wide>(box[2 * j]) + box[2 * j + 1]);
      distance += std::abs(m[4 * i + j] * modelOrigin[j]);
    }
    toMiddle[i] = toModel[i] + local;
    frame.LocalMiddle[i] = 0.5 * (box[2 * i] + box[2 * i + 1]);
    frame.Middle[i] = static_cast<double>(toMiddle[i] + waterline.Point[i]);
    distance += std::abs(m[4 * i + 3]) + std::abs(waterline.Point[i]);
  }
  frame.Plane.Offset = Dot(up, toModel);
  const double radius = GetRadius(*body.Model);
  frame.PlacementBound = PlacementError::Make(body).Moved;
  frame.PlaneBound = 16.0 * WideRoundoff * distance + frame.PlacementBound;
  const std::array<Wide, 3> middle = { Dot(axes[0], toMiddle), Dot(axes[1], toMiddle),
    Dot(axes[2], toMiddle) };
  for (int k = 0; k < 3; ++k)
  {
    for (int j = 0; j < 3; ++j)
    {
      Wide entry = 0.0L;
      for (int i = 0; i < 3; ++i)
      {
        entry += axes[k][i] * m[4 * i + j];
      }
      frame.Placement[4 * k + j] = static_cast<double>(entry);
      frame.Axes[k][j] = static_cast<double>(axes[k][j]);
    }
    // The frame's origin is near the body in the two directions across `up`, and in the plane along `up`.
    frame.Placement[4 * k + 3] = static_cast<double>(Dot(axes[k], toModel) - (k < 2 ? middle[k] : 0.0L));
  }
  frame.Plane.Up = { frame.Placement[8], frame.Placement[9], frame.Placement[10] };
  for (int i = 0; i < 3; ++i)
  {
    frame.Origin[i] =
      static_cast<double>(waterline.Point[i] + middle[0] * axes[0][i] + middle[1] * axes[1][i]);
  }
  frame.Reach = radius;
  return frame;
}

void BuoyancyIntegrator::MoveToMiddle(Frame& frame)
{
  // For a body that is entirely below the waterline any plane of this direction gives the same integrals; a plane through the
  // body keeps the numbers small.
  frame.Placement[11] = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    frame.Placement[11] -= frame.Plane.Up[c] * frame.LocalMiddle[c];
  }
  frame.Origin = frame.Middle;
  frame.PlaneBound = frame.PlacementBound;
}

bool BuoyancyIntegrator::CutFaces(const std::vector<CutFacePointer>& faces, const HeightPlane& plane,
  double tolerance, const ProgressCallback& progress, std::vector<SubmergedFace>& below)
{
  below.assign(faces.size(), {});
  const CutKey key{ plane, tolerance };
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (const SubmergedFace* known = this->Below.Find(faces[i]->Source->Id, key))
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
          below[missing[i]] = CutBelow(faces[missing[i]], plane, tolerance);
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
      this->Below.Store(faces[i]->Source->Id, key, below[i], bytes);
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
  double tolerance, const ProgressCallback& progress, CutBody& cut)
{
  const std::vector<FacePointer>& sources = body.Model->GetFaces();
  // The two halves of the progress: faces into panels, panels at the waterline.
  const auto firstHalf = [&progress](double fraction) { return progress(0.5 * fraction); };
  const auto secondHalf = [&progress](double fraction) { return progress(0.5 + 0.5 * fraction); };
  if (!this->Cuts.Acquire(sources, cut.Faces, firstHalf))
  {
    this->CutError = this->WasCutAborted ? "" : this->Cuts.GetError();
    return false;
  }
  Frame& frame = cut.View;
  frame = MakeFrame(body, waterline);
  if (!this->CutFaces(cut.Faces, frame.Plane, CutShare * tolerance, secondHalf, cut.Below))
  {
    return false;
  }
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    cut.IsWhole = cut.IsWhole && cut.Below[i].Parts[0] == cut.Faces[i];
  }
  // Faces below or above the plane by no more than the rounding error of the plane and of their own numbers: a body found to be
  // entirely on one side may have a thin sheet on the other side.
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
      below.CutError + (mayHaveSheet ? 2.0 * rounded * GetLargestArea(panels, GetStripArea(panels)) : 0.0);
    cut.Errors[i] = cut.Faces[i]->Error;
  }
  if (cut.IsWhole)
  {
    MoveToMiddle(frame);
  }
  return true;
}

void BuoyancyIntegrator::AddTasks(
  CutBody& cut, std::size_t body, double tolerance, std::vector<FaceTask>& tasks, std::vector<Place>& places)
{
  Frame& frame = cut.View;
  FaceTask task;
  task.Placement = frame.Placement;
  task.Tolerances.assign(Quantities, QuadratureShare * tolerance * frame.Reach);
  task.Tolerances[0] = 2.0 * QuadratureShare * tolerance;
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
        for (double& own : tasks.back().Tolerances)
        {
          own *= below.Parts[0] && below.Parts[1] ? 0.5 : 1.0;
        }
        places.push_back({ body, i });
        cut.VolumeErrors[i] += moved * GetLargestArea(part->Panels, below.StripArea);
      }
    }
    frame.Reach =
      std::max(frame.Reach, cut.VolumeErrors[i] > 0.0 ? GetReach(cut.Faces[i]->Panels, center) : 0.0);
  }
}

void BuoyancyIntegrator::SumBody(const CutBody& cut, BodyBuoyancy& result)
{
  const Frame& frame = cut.View;
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
    magnitude += std::abs(face.Face[0]) + std::abs(face.Closing[0]);
  }
  // Rounding of sums with this number of terms.
  const double rounding = UnitRoundoff * static_cast<double>(result.Faces.size() + 8) * magnitude;
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

std::vector<Integrand> BuoyancyIntegrator::MakeIntegrands()
{
  return { Integrand::HeightMoment("V", 0, 0, 0), Integrand::HeightMoment("X", 1, 0, 0),
    Integrand::HeightMoment("Y", 0, 1, 0), Integrand::HeightMoment("Z", 0, 0, 1) };
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
    const double tolerance =
      relativeTolerance * GetVolumeScale(model) / std::max<std::size_t>(model.GetFaces().size(), 1);
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
  for (std::size_t k = 0; k < Quantities; ++k)
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
    SumBody(cuts[b], results[b]);
  }
  return true;
}
}
