#include "smMomentGradient.h"

#include "Detail/smGradientBodies.h"
#include "Detail/smModelGradient.h"
#include "Detail/smMomentFrame.h"
#include "Detail/smPatchIntegrator.h"
#include "smFailureReason.h"
#include "smFormat.h"

#include "vtkDataObject.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <map>

namespace sm
{
namespace
{
constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();
// Fraction of the progress for the mass properties.
constexpr double MassShare = 0.3;
constexpr int AreaAt = NumberOfGradientQuantities - 1;

/// One computation.
class Computation
{
public:
  Computation(const MomentGradientOptions& options)
    : Options(options)
    , Integrator(options.Backend, options.Context)
  {
  }

  MomentGradientResult Run(vtkDataObject* model);

private:
  struct Part
  {
    ModelGradient Gradient;
    TiedVariables Tied;
    std::string Error;
  };

  bool Stop(const std::string& reason);
  bool ComputeMass(vtkDataObject* model);
  /// The gradients of a model, which instances share; null if stopped.
  const Part* GetPart(std::size_t body);
  void AddBody(std::size_t body, const Part& part);
  FaceMomentGradient MakeFace(std::size_t body, std::size_t face, const Part& part);
  /// Explains what is NaN for a body.
  void Explain(const BodyIntegrals& body, const DerivedGradient& derived, bool hasVolume);
  /// Adds a message about bounds of the faces from index `first` of the result on that are NaN.
  void ExplainBounds(const BodyIntegrals& body, std::size_t first, bool hasVolume);
  /// Adds one about faces whose bounds of the area's derivatives by points exceed these derivatives.
  void ExplainLargeBounds(const BodyIntegrals& body, std::size_t first);

  const MomentGradientOptions& Options;
  PatchIntegrator Integrator;
  MomentGradientResult Result;
  GradientBodies Mass;
  std::map<vtkTrimmedNURBSModel*, Part> Parts;
  std::int64_t FirstVariable = 0;
};

bool Computation::Stop(const std::string& reason)
{
  this->Result.Faces.clear();
  this->Result.Status = GetText(Status::NotComputed);
  this->Result.Reason = reason;
  return false;
}

bool Computation::ComputeMass(vtkDataObject* model)
{
  const bool computed = this->Mass.Compute(model, this->Options.Solids, this->Options.RelativeTolerance,
    [this](double fraction)
    { return !this->Options.Progress || this->Options.Progress(MassShare * fraction); });
  this->Result.Status = this->Mass.Status;
  this->Result.Reason = this->Mass.Reason;
  this->Result.LengthUnit = this->Mass.Analysis.Unit;
  this->Result.Messages = this->Mass.Messages;
  return computed;
}

const Computation::Part* Computation::GetPart(std::size_t body)
{
  const BodyIntegrals& source = this->Mass.Bodies[body];
  const auto found = this->Parts.find(source.Model);
  if (found != this->Parts.end())
  {
    return &found->second;
  }
  Part& part = this->Parts[source.Model];
  const std::size_t count = source.Model->GetFaces().size();
  const std::string wrong = FindWrongIndex(this->Options.Faces, count, "face");
  if (!wrong.empty())
  {
    this->Stop(wrong + " (solid " + source.Name + ")");
    return nullptr;
  }
  std::vector<bool> faces(count, this->Options.Faces.empty());
  for (const int face : this->Options.Faces)
  {
    faces[face] = true;
  }
  part.Tied =
    this->Options.Tied ? TiedVariables::Find(source.Model) : TiedVariables::MakeSeparate(source.Model);
  const double share = (1.0 - MassShare) / static_cast<double>(this->Mass.Bodies.size());
  const double done = MassShare + share * static_cast<double>(body);
  const auto progress = [this, done, share](double fraction)
  { return !this->Options.Progress || this->Options.Progress(done + share * fraction); };
  if (!part.Gradient.Compute(source.Model, this->Options.Tied ? part.Tied.AddFollowers(faces) : faces,
        this->Mass.GetSides(body), this->Options.RelativeTolerance, progress, this->Integrator))
  {
    this->Stop(part.Gradient.GetError());
    return nullptr;
  }
  this->Result.Evaluations += part.Gradient.GetEvaluations();
  if (this->Options.Tied)
  {
    part.Gradient.Join(source.Model, part.Tied);
  }
  return &part;
}

void Computation::Explain(const BodyIntegrals& body, const DerivedGradient& derived, bool hasVolume)
{
  const std::string name = "solid " + body.Path + ": ";
  if (!hasVolume)
  {
    this->Result.Messages.push_back(
      name + "it has no volume that is known, so that only SurfaceArea has derivatives; the others are NaN");
    return;
  }
  std::string coincident;
  for (int k = 0; k < 3; ++k)
  {
    coincident += derived.IsSingle(k) ? "" : (coincident.empty() ? "" : ", ") + std::to_string(k + 1);
  }
  if (!coincident.empty())
  {
    this->Result.Messages.push_back(name + "principal moments " + coincident +
      " coincide within their bounds and have no derivative: PrincipalMoment_ is NaN there; use Inertia_");
  }
}

void Computation::ExplainBounds(const BodyIntegrals& body, std::size_t first, bool hasVolume)
{
  for (const bool isArea : { false, true })
  {
    const int from = isArea ? AreaAt : 0;
    const int to = isArea ? AreaAt + 1 : NumberOfMoments;
    std::size_t count = 0;
    std::size_t all = 0;
    std::int64_t face = 0;
    for (std::size_t f = first; f < this->Result.Faces.size(); ++f)
    {
      const std::vector<double>& bounds = this->Result.Faces[f].Bounds;
      for (auto at = bounds.begin(); at != bounds.end(); at += NumberOfGradientQuantities, ++all)
      {
        if (std::any_of(at + from, at + to, [](double bound) { return std::isnan(bound); }))
        {
          face = count == 0 ? this->Result.Faces[f].FileId : face;
          ++count;
        }
      }
    }
    if (count == 0 || (!isArea && !hasVolume))
    {
      continue;
    }
    this->Result.Messages.push_back("solid " + body.Path + ": " + std::to_string(count) + " of " +
      std::to_string(all) + " bounds of derivatives of " + (isArea ? "SurfaceArea" : "the moments") +
      " are not known and NaN, first at face #" + std::to_string(face) +
      (isArea ? ": the weight may vanish"
              : ": the weight may vanish near a trim curve, or a strip along an edge has no bound") +
      "; do not rely on these values, or take derivatives by other points");
  }
}

void Computation::ExplainLargeBounds(const BodyIntegrals& body, std::size_t first)
{
  std::size_t count = 0;
  std::int64_t id = 0;
  for (std::size_t f = first; f < this->Result.Faces.size(); ++f)
  {
    const FaceMomentGradient& face = this->Result.Faces[f];
    double value = 0.0;
    double bound = 0.0;
    for (std::size_t at = 0; at < face.Values.size(); at += NumberOfGradientQuantities)
    {
      if (at / NumberOfGradientQuantities % 4 < 3)
      {
        value = std::max(value, std::abs(face.Values[at + AreaAt]));
        bound = std::max(bound, face.Bounds[at + AreaAt]);
      }
    }
    if (bound > value)
    {
      id = count == 0 ? face.FileId : id;
      ++count;
    }
  }
  if (count > 0)
  {
    this->Result.Messages.push_back("solid " + body.Path + ": on " + std::to_string(count) + " of " +
      std::to_string(this->Result.Faces.size() - first) +
      " faces bounds of derivatives of SurfaceArea exceed the derivatives, first on face #" +
      std::to_string(id) +
      ": normals may nearly vanish, weights differ much, or a trim curve is far off; do not rely on these "
      "values, or take "
      "derivatives by other points");
  }
}

FaceMomentGradient Computation::MakeFace(std::size_t body, std::size_t face, const Part& part)
{
  const BodyIntegrals& source = this->Mass.Bodies[body];
  const MassProperties& properties = this->Mass.Analysis.Rows[body].Properties;
  const double* origin = source.Model->GetOrigin();
  const std::array<double, 3> zero{};
  const bool hasVolume = source.HasVolume() && std::isfinite(properties.Center[0]) &&
    properties.VolumeBound < std::abs(properties.Volume);
  const MomentFrame world(source.Placement.data(), origin, zero);
  const MomentFrame central(source.Placement.data(), origin, hasVolume ? properties.Center : zero);
  const DerivedGradient derived(properties);
  const NetGradient& net = part.Gradient.Get(face);
  const Face& surface = *source.Model->GetFaces()[face];

  FaceMomentGradient result;
  result.Solid = this->Mass.Indices[body];
  result.Face = static_cast<int>(face);
  result.FileId = surface.FileId;
  std::copy_n(net.Count, 2, result.Count);
  const std::size_t points = surface.Surface.ControlPoints.size();
  result.Values.assign(4 * NumberOfGradientQuantities * points, Unknown);
  result.Bounds = result.Values;
  for (int i = 0; i < net.Count[0]; ++i)
  {
    for (int j = 0; j < net.Count[1]; ++j)
    {
      const std::size_t entry = i + static_cast<std::size_t>(net.Count[0]) * j;
      const std::array<double, 4>& point = surface.Surface.ControlPoints[entry];
      std::array<double, 4> placed{ 0.0, 0.0, 0.0, point[3] };
      for (int a = 0; a < 3; ++a)
      {
        placed[a] = source.Placement[4 * a + 3];
        for (int c = 0; c < 3; ++c)
        {
          placed[a] += source.Placement[4 * a + c] * (point[c] / point[3] + origin[c]);
        }
      }
      result.Points.push_back(placed);
      result.PointVariables.push_back(this->FirstVariable + part.Tied.Points[face][entry]);
      result.WeightVariables.push_back(this->FirstVariable + part.Tied.Weights[face][entry]);

      std::array<MomentVector, 4> inWorld;
      std::array<MomentVector, 4> aboutCenter;
      std::array<double, 3> area;
      std::array<double, 3> areaBound;
      for (int c = 0; c < 4; ++c)
      {
        const std::size_t at = net.GetIndex(i, j, c);
        MomentVector moments;
        std::copy_n(net.Values.begin() + at, NumberOfMoments, moments.Values.begin());
        std::copy_n(net.Bounds.begin() + at, NumberOfMoments, moments.Bounds.begin());
        inWorld[c] = world.Map(moments);
        aboutCenter[c] = central.Map(moments);
        if (c < 3)
        {
          area[c] = net.Values[at + NumberOfMoments];
          areaBound[c] = net.Bounds[at + NumberOfMoments];
        }
      }
      const std::array<MomentVector, 3> rotated = world.Rotate({ inWorld[0], inWorld[1], inWorld[2] });
      const std::array<MomentVector, 3> centered =
        central.Rotate({ aboutCenter[0], aboutCenter[1], aboutCenter[2] });
      world.Rotate(area, areaBound);
      for (int c = 0; c < 4; ++c)
      {
        const std::size_t at = result.GetIndex(i, j, c, 0);
        double* values = result.Values.data() + at;
        double* bounds = result.Bounds.data() + at;
        const std::size_t weight = net.GetIndex(i, j, 3) + NumberOfMoments;
        values[AreaAt] = c < 3 ? area[c] : net.Values[weight];
        bounds[AreaAt] = c < 3 ? areaBound[c] : net.Bounds[weight];
        if (hasVolume)
        {
          const MomentVector& moments = c < 3 ? rotated[c] : inWorld[3];
          std::copy(moments.Values.begin(), moments.Values.end(), values);
          std::copy(moments.Bounds.begin(), moments.Bounds.end(), bounds);
          derived.Set(c < 3 ? centered[c] : aboutCenter[3], values, bounds);
        }
      }
    }
  }
  return result;
}

void Computation::AddBody(std::size_t body, const Part& part)
{
  const BodyIntegrals& source = this->Mass.Bodies[body];
  const MassProperties& properties = this->Mass.Analysis.Rows[body].Properties;
  const bool hasVolume = source.HasVolume() && std::isfinite(properties.Center[0]) &&
    properties.VolumeBound < std::abs(properties.Volume);
  const std::size_t first = this->Result.Faces.size();
  std::int64_t points = 0;
  for (std::size_t f = 0; f < source.Model->GetFaces().size(); ++f)
  {
    const std::vector<int>& chosen = this->Options.Faces;
    if (chosen.empty() || std::find(chosen.begin(), chosen.end(), static_cast<int>(f)) != chosen.end())
    {
      this->Result.Faces.push_back(this->MakeFace(body, f, part));
    }
    points += static_cast<std::int64_t>(source.Model->GetFaces()[f]->Surface.ControlPoints.size());
  }
  this->FirstVariable += points;
  this->ExplainBounds(source, first, hasVolume);
  this->ExplainLargeBounds(source, first);
  this->Explain(source, DerivedGradient(properties), hasVolume);
}

MomentGradientResult Computation::Run(vtkDataObject* model)
{
  const double start = vtkTimerLog::GetUniversalTime();
  if (!this->ComputeMass(model))
  {
    return this->Result;
  }
  const double middle = vtkTimerLog::GetUniversalTime();
  this->Result.MomentSeconds = middle - start;
  for (std::size_t body = 0; body < this->Mass.Bodies.size(); ++body)
  {
    const Part* part = this->GetPart(body);
    if (!part)
    {
      return this->Result;
    }
    this->AddBody(body, *part);
  }
  this->Result.Backend = this->Integrator.GetUsed();
  this->Result.BackendReason = this->Integrator.GetReason();
  this->Result.IntegralSeconds = this->Integrator.GetSeconds();
  this->Result.GradientSeconds = vtkTimerLog::GetUniversalTime() - middle;
  return this->Result;
}
}

const std::vector<GradientQuantity>& GetGradientQuantities()
{
  static const std::vector<GradientQuantity> quantities{ { "Volume", 3 }, { "FirstMoment_X", 4 },
    { "FirstMoment_Y", 4 }, { "FirstMoment_Z", 4 }, { "SecondMoment_XX", 5 }, { "SecondMoment_YY", 5 },
    { "SecondMoment_ZZ", 5 }, { "SecondMoment_XY", 5 }, { "SecondMoment_YZ", 5 }, { "SecondMoment_XZ", 5 },
    { "CenterOfMass_X", 1 }, { "CenterOfMass_Y", 1 }, { "CenterOfMass_Z", 1 }, { "Inertia_XX", 5 },
    { "Inertia_YY", 5 }, { "Inertia_ZZ", 5 }, { "Inertia_XY", 5 }, { "Inertia_YZ", 5 }, { "Inertia_XZ", 5 },
    { "PrincipalMoment_1", 5 }, { "PrincipalMoment_2", 5 }, { "PrincipalMoment_3", 5 },
    { "SurfaceArea", 2 } };
  return quantities;
}

MomentGradientResult ComputeMomentGradient(vtkDataObject* model, const MomentGradientOptions& options)
{
  MomentGradientResult failure;
  failure.Status = GetText(Status::NotComputed);
  try
  {
    if (!(options.RelativeTolerance > 0.0 && options.RelativeTolerance <= 1.0))
    {
      failure.Reason = "nothing was computed: RelativeTolerance is " +
        FormatDigits(options.RelativeTolerance, 6) + "; give a number above 0, at most 1";
      return failure;
    }
    return Computation(options).Run(model);
  }
  catch (...)
  {
    failure.Reason = std::string("nothing was computed: ") + GetReason(std::current_exception());
    return failure;
  }
}
}
