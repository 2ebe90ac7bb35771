#include "smMassAnalysis.h"

#include "Detail/smCoincidentSolids.h"
#include "Detail/smMassSpread.h"
#include "Detail/smMirroredTwins.h"
#include "Detail/smPlausibility.h"
#include "Detail/smProductMasses.h"
#include "Detail/smSelfCrossing.h"
#include "Detail/smTotalMass.h"
#include "smBodyScales.h"
#include "smCoincidentFaces.h"
#include "smFormat.h"
#include "smMassIntegrands.h"
#include "smMoments.h"
#include "smPlacementError.h"
#include "smUnitRoundoff.h"

#include "vtkBoundingBox.h"
#include "vtkMath.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace sm
{
namespace
{
/// Adds to the bounds the effect of the rounding of a placement (smPlacementError.h): an error of the
/// translation by some u of its length, and of the rotation, which deforms and rotates the body and the
/// vector to its origin by as much.
void AddPlacementError(const BodyIntegrals& body, Moments& moments)
{
  const double rotated = PlacementError::GetRotated(body);
  if (!(rotated > 0.0))
  {
    return;
  }
  const std::array<double, 16>& m = body.Placement;
  moments.ReferenceBound += rotated * vtkMath::Norm(body.Model->GetOrigin()) +
    PlacementError::Rounding * std::hypot(m[3], m[7], m[11]);
  // A product of k lengths changes by k times that, and a moment of order n by n + 3 times.
  const auto grow = [rotated](double order, const double* values, double* bounds, int count)
  {
    double largest = 0.0;
    for (int i = 0; i < count; ++i)
    {
      largest = std::max(largest, std::abs(values[i]));
    }
    for (int i = 0; i < count; ++i)
    {
      bounds[i] += (order + 3.0) * rotated * largest;
    }
  };
  grow(0.0, &moments.Volume, &moments.VolumeBound, 1);
  grow(1.0, moments.First.data(), moments.FirstBound.data(), 3);
  grow(2.0, moments.Second.data(), moments.SecondBound.data(), 6);
}

/// Returns the moments of a body in the world, about its placed origin, with the body's bounds or the parts
/// of them that are estimated.
Moments GetMoments(const BodyIntegrals& body, const std::vector<double>& bounds)
{
  Moments moments;
  std::copy_n(body.Model->GetOrigin(), 3, moments.Reference.begin());
  moments.Volume = body.Value[MassVolume];
  moments.VolumeBound = bounds[MassVolume];
  std::copy_n(body.Value.begin() + MassFirst, 3, moments.First.begin());
  std::copy_n(bounds.begin() + MassFirst, 3, moments.FirstBound.begin());
  std::copy_n(body.Value.begin() + MassSecond, 6, moments.Second.begin());
  std::copy_n(bounds.begin() + MassSecond, 6, moments.SecondBound.begin());
  if (body.InsideOut)
  {
    moments.Negate();
  }
  moments.Place(body.Placement.data());
  AddPlacementError(body, moments);
  return moments;
}

/// Sets the estimated parts of the bounds of a row: those that follow from `measured`, its moments with the
/// estimated parts of theirs. Rounding of placements, which is estimated, is a part of both.
void SetMeasuredBounds(const Moments& measured, double area, MassRow& row)
{
  const MassProperties p = ComputeMassProperties(measured);
  row.MeasuredBounds = { std::min(p.VolumeBound, row.Properties.VolumeBound), std::min(area, row.AreaBound),
    std::min(p.CenterBound, row.Properties.CenterBound),
    std::min(p.InertiaBound, row.Properties.InertiaBound) };
}

/// Sets the bounds of moments to 0, so that the centre and the inertia follow from them as from exact ones.
void ZeroBounds(Moments& moments)
{
  moments.VolumeBound = 0.0;
  moments.FirstBound.fill(0.0);
  moments.SecondBound.fill(0.0);
}

/// Flags a body as suspect if its properties violate a fact that holds for every solid.
void CheckPlausibility(BodyIntegrals& body, const MassProperties& properties)
{
  std::array<double, 3> center;
  for (int i = 0; i < 3; ++i)
  {
    center[i] = body.Value[MassFirst + i] / body.Value[MassVolume];
  }
  // A trim curve that leaves its surface may lead beyond the control points.
  double slack = 1e-12 * GetRadius(*body.Model);
  for (const FaceIntegrals& face : *body.Faces)
  {
    slack = std::max(slack, 2.0 * face.Outside.Distance);
  }
  // Only a volume that may be zero is compared with the size of the box.
  const bool isPositive = properties.Volume > properties.VolumeBound;
  for (const std::string& violation :
    FindImplausibilities(properties, center, GetHullBox(*body.Model, isPositive ? &center : nullptr), slack))
  {
    body.Flag(Status::Suspect, violation);
  }
}

/// Returns the largest closure residual of a surface that counts as closed. The part of the residual that a
/// loose tolerance or missing convergence causes in the vector area is not an opening.
double GetMaxClosureResidual(
  const BodyIntegrals& body, double residualPerArea, const MassAnalysisOptions& options)
{
  return options.HasBounds
    ? options.MaxClosureResidual + residualPerArea * vtkMath::Norm(body.Bound.data() + MassVectorArea)
    // The texels of the schemes leave the faces of a correct solid open.
    : body.IsSolid() ? std::numeric_limits<double>::infinity()
                     : options.MaxClosureResidual;
}

/// Flags a body whose volume changes too much when its gaps are closed. A boundary that is off by the
/// uncertainty of the file everywhere changes the volume by that times the area.
void CheckClosureCorrection(BodyIntegrals& body, const MassRow& row, double limit)
{
  const double volume = std::abs(body.Value[MassVolume]);
  const double excuse = body.Model->GetFileUncertainty() * body.Value[MassArea];
  if (body.OpenEdges == 0 && row.ClosureCorrection > GetExcused(limit, volume, excuse))
  {
    body.Flag(Status::Suspect,
      "closing the gaps between its faces changes the volume by " +
        FormatDigits(100.0 * row.ClosureCorrection / volume, 2) + " %");
    body.ExcusedGap = std::min(body.ExcusedGap, 2.0 * LargeGap * GetRadius(*body.Model));
  }
}

/// Computes the properties of a body that encloses a volume. Returns false if the body turns out to be a
/// surface.
bool AnalyzeVolume(BodyIntegrals& body, const MassAnalysisOptions& options, MassRow& row, Moments& moments)
{
  FlagCoincidentFaces(body, MassVolume, MassArea);
  ReverseShells(body, GetMassIntegrands(), MassVolume);
  moments = GetMoments(body, body.Bound);
  if (!options.HasBounds)
  {
    ZeroBounds(moments);
  }
  row.Properties = ComputeMassProperties(moments);
  if (options.HasBounds)
  {
    SetMeasuredBounds(GetMoments(body, body.MeasuredBound), row.MeasuredBounds[1], row);
    row.ClosureCorrection = std::abs(body.Value[MassVolume] - body.FaceValue[MassVolume]);
    row.Spread = ComputeSpread({ GetSpreadMoments(body) }, moments.Volume, row.Properties.Center);
  }
  else
  {
    row.RemoveBounds();
  }
  const double residualPerArea = std::cbrt(moments.Volume) / (3.0 * moments.Volume);
  row.ClosureResidual = residualPerArea * vtkMath::Norm(body.Value.data() + MassVectorArea);
  const bool isClosed = row.ClosureResidual <= GetMaxClosureResidual(body, residualPerArea, options);
  if (!isClosed)
  {
    // A border without edges has no gaps that could be bounded.
    body.Spread = nullptr;
    row.Spread = MassSpread();
    row.AreaSpread = vtkMath::Nan();
  }
  if (!body.IsSolid() && body.SkippedFaces == 0 && !isClosed)
  {
    // The border of the surface has no edges: it is a patch without loops.
    body.Flag(Status::Open, "a surface, not a solid: it has an area and no volume");
    row.Properties = MassProperties();
    row.MeasuredBounds[0] = row.MeasuredBounds[2] = row.MeasuredBounds[3] = vtkMath::Nan();
    row.ClosureCorrection = row.ClosureResidual = vtkMath::Nan();
    return false;
  }
  // Without a volume, which CheckPlausibility() reports, there is no residual.
  if (body.OpenEdges == 0 && body.SkippedFaces == 0 && !isClosed && !std::isnan(row.ClosureResidual))
  {
    body.Flag(Status::Suspect,
      "the faces do not close although every edge is shared: a loop is broken or a face is wrong" +
        (std::isfinite(row.ClosureResidual) ? ". The volume changes by " + FormatBound(row.ClosureResidual) +
              " of itself when the origin moves by the cube root of the volume"
                                            : std::string()));
  }
  CheckClosureCorrection(body, row, options.GapLimit);
  CheckPlausibility(body, row.Properties);
  return true;
}

/// Returns true if a body has no faces, or all of them are left out, so that its sums are empty.
bool IsLeftOut(const BodyIntegrals& body)
{
  return body.Faces &&
    std::none_of(
      body.Faces->begin(), body.Faces->end(), [](const FaceIntegrals& face) { return face.Error.empty(); });
}

/// Negative areas of faces count above this part of the area of the body.
constexpr double NegligibleArea = 1e-6;

/// Flags a body as suspect if the area of a face is below 0: its loops run around it the wrong way. An area
/// of the body below 0 becomes NaN.
void FlagNegativeAreas(BodyIntegrals& body)
{
  std::size_t negative = 0;
  std::string first;
  double sum = 0.0;
  for (const FaceIntegrals& face : *body.Faces)
  {
    sum += face.Error.empty() ? std::abs(face.Face[MassArea]) : 0.0;
  }
  for (std::size_t i = 0; i < body.Faces->size(); ++i)
  {
    const FaceIntegrals& face = (*body.Faces)[i];
    // The loops of a sliver may cross within their gaps: ploopy_buttons has a face of -2e-4 mm^2.
    const double allowed = face.GetBound(MassArea) + 2.0 * face.GapArea + NegligibleArea * sum;
    if (face.Error.empty() && face.Face[MassArea] < -allowed)
    {
      first = negative++ == 0
        ? "face #" + std::to_string(body.Model->GetFaces()[i]->FileId) + ": its area is negative, " +
          FormatDigits(face.Face[MassArea], 6) + ": its loops run around it the wrong way"
        : first;
      body.FaceDefects.push_back({ { i }, "its area is negative", true });
    }
  }
  if (negative > 0)
  {
    body.Flag(Status::Suspect,
      first + (negative > 1 ? ", and " + std::to_string(negative - 1) + " more are" : std::string()));
  }
  if (body.Value[MassArea] < -body.Bound[MassArea])
  {
    body.Value[MassArea] = vtkMath::Nan();
  }
}

/// Returns the end of a message about wide bounds of a body that lies so far from the origin that the
/// roundings of its coordinates are a part of them worth mentioning; empty for others.
std::string DescribeDistance(const MassRow& row, double distance, double size, const std::string& unit)
{
  constexpr double farAway = 1e4;
  constexpr double share = 0.01;
  const bool isFar = size > 0.0 && distance > farAway * size &&
    UnitRoundoff * distance * row.Area > share * row.Properties.VolumeBound;
  return isFar ? "; the reason is its distance to the origin, " + FormatDigits(distance, 3) + " " + unit +
      " for a size of " + FormatDigits(size, 3) + " " + unit +
      ", which coordinates lose digits at: move it to the origin, or ask for less (--tolerance)"
               : std::string();
}

/// Returns how far other closings of the gaps may change the area; NaN if it is not known.
double GetAreaSpread(const BodyIntegrals& body)
{
  return body.Spread ? SumSpread(*body.Spread, body.Sides, {}).Area : vtkMath::Nan();
}

/// Computes the row of a body. `moments` receives its moments in the world if it has a volume.
MassRow AnalyzeBody(BodyIntegrals& body, const MassAnalysisOptions& options, Moments& moments)
{
  MassRow row;
  if (body.Faces && options.HasBounds)
  {
    FlagNegativeAreas(body);
  }
  row.Area = body.Value[MassArea];
  // An affine map that lengthens nothing by more than this lengthens normals by twice as much.
  const double stretched =
    options.HasBounds ? 2.0 * PlacementError::GetRotated(body) * body.Value[MassArea] : 0.0;
  row.AreaBound = body.Bound[MassArea] + stretched;
  row.GapSquared = body.GapSquared;
  row.MaxGap = body.MaxGap;
  row.GapArea = body.GapArea;
  row.AreaSpread = options.HasBounds ? GetAreaSpread(body) : vtkMath::Nan();
  row.MeasuredBounds[1] = std::min(body.MeasuredBound[MassArea] + stretched, row.AreaBound);
  if (!body.Faces)
  {
    return row;
  }
  if (body.Faces->empty() && body.Model->GetNumberOfMissingFaces() == 0)
  {
    // It encloses nothing, and the total of the others is complete.
    body.Flag(Status::Suspect, "it has no faces and no values, and adds nothing to the total");
    row.Area = row.AreaBound = row.GapSquared = row.MaxGap = row.GapArea = row.MeasuredBounds[1] =
      row.AreaSpread = 0.0;
    return row;
  }
  if (IsLeftOut(body))
  {
    // The values are 0 with infinite bounds, so that the total is not taken for complete.
    body.Flag(Status::Suspect, "no face of it was integrated: it has no values");
    moments = GetMoments(body, body.Bound);
    row.Properties = ComputeMassProperties(moments);
    return row;
  }
  if (body.HasVolume() && !AnalyzeVolume(body, options, row, moments))
  {
    return row;
  }
  if (body.HasVolume() && !std::isfinite(body.Value[MassVolume]))
  {
    body.Flag(Status::Suspect, "the volume is not a finite number");
  }
  if (!std::isfinite(row.Area))
  {
    body.Flag(Status::Suspect, "the area is not a finite number");
  }
  if (!options.HasBounds)
  {
    body.Degrade(Status::ToleranceNotMet);
    // The schemes leave a residual of the size of their texels, which says nothing about the model.
    row.ClosureResidual = vtkMath::Nan();
    return row;
  }
  const std::string unmet = FindUnmet(row, options.Tolerance, GetRadius(*body.Model));
  if (!unmet.empty())
  {
    const double* origin = body.Model->GetOrigin();
    body.Flag(Status::ToleranceNotMet,
      "bounds above the tolerance, relative: " + unmet +
        DescribeDistance(
          row, vtkMath::Norm(origin), 2.0 * GetRadius(*body.Model), body.Model->GetLengthUnit()));
  }
  return row;
}

/// Sets the rows of bodies of which all faces are left out to NaN, and those quantities of the total that no
/// other body has.
void RemoveLeftOut(
  const std::vector<BodyIntegrals>& bodies, const MassAnalysisOptions& options, MassAnalysis& analysis)
{
  bool isComplete = true;
  bool hasVolume = false;
  MassRow total;
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    if (IsLeftOut(bodies[b]))
    {
      isComplete = false;
      analysis.Rows[b] = MassRow();
      SetMass(
        analysis.Rows[b], ChooseMaterial(bodies[b], options), nullptr, bodies[b].Model->GetLengthUnit());
    }
    else
    {
      hasVolume = hasVolume || std::isfinite(analysis.Rows[b].Properties.Volume);
      total.Area = analysis.Total.Area;
      total.AreaBound = analysis.Total.AreaBound;
      total.AreaSpread = analysis.Total.AreaSpread;
      total.MeasuredBounds[1] = analysis.Total.MeasuredBounds[1];
      total.GapSquared = analysis.Total.GapSquared;
      total.GapArea = analysis.Total.GapArea;
      total.MaxGap = analysis.Total.MaxGap;
    }
  }
  if (!isComplete && !hasVolume)
  {
    analysis.Total = total;
  }
}

/// Adds the quantities whose total is their sum.
void AddRow(const MassRow& row, MassRow& total)
{
  total.Area += row.Area;
  total.AreaBound += row.AreaBound + 2.0 * UnitRoundoff * total.Area;
  total.MeasuredBounds[1] += row.MeasuredBounds[1];
  total.AreaSpread += row.AreaSpread;
  total.GapSquared += row.GapSquared;
  total.GapArea += row.GapArea;
  // std::max is not used here because it may drop a NaN.
  total.MaxGap = row.MaxGap > total.MaxGap || std::isnan(row.MaxGap) ? row.MaxGap : total.MaxGap;
  if (std::isfinite(row.Properties.Volume))
  {
    total.ClosureCorrection += row.ClosureCorrection;
  }
}

/// Computes the total of all bodies that have a volume.
void AnalyzeTotal(const std::vector<BodyIntegrals>& bodies, const std::vector<Moments>& parts,
  const MassAnalysisOptions& options, MassAnalysis& analysis)
{
  MassRow& total = analysis.Total;
  if (parts.empty() || !analysis.HasOneUnit)
  {
    total.ClosureCorrection = vtkMath::Nan();
    return;
  }
  double vectorArea[3] = { 0.0, 0.0, 0.0 };
  std::vector<Moments> measured;
  std::vector<Moments> spreads;
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    if (!std::isfinite(analysis.Rows[b].Properties.Volume))
    {
      continue;
    }
    for (int i = 0; i < 3; ++i)
    {
      vectorArea[i] += std::abs(bodies[b].Value[MassVectorArea + i]);
    }
    measured.push_back(GetMoments(bodies[b], bodies[b].MeasuredBound));
    spreads.push_back(GetSpreadMoments(bodies[b]));
  }
  const Moments sum = Moments::Sum(parts);
  total.Properties = ComputeMassProperties(sum);
  if (options.HasBounds)
  {
    total.ClosureResidual = vtkMath::Norm(vectorArea) * std::cbrt(sum.Volume) / (3.0 * sum.Volume);
    SetMeasuredBounds(Moments::Sum(measured), total.MeasuredBounds[1], total);
    total.Spread = ComputeSpread(spreads, sum.Volume, total.Properties.Center);
  }
  SetTotalMass(bodies, parts, sum, spreads, options, analysis);
  if (!options.HasBounds)
  {
    total.RemoveBounds();
  }
}
}

void MassAnalysisOptions::TakeProducts(vtkDataObject* input)
{
  if (std::any_of(this->Materials.begin(), this->Materials.end(),
        [](const MaterialRule& rule) { return rule.IsOfProduct; }))
  {
    this->Products = MakeProductTree(input);
  }
}

MassAnalysis AnalyzeMass(std::vector<BodyIntegrals>& bodies, const MassAnalysisOptions& given)
{
  MassAnalysisOptions options = given;
  MassAnalysis analysis;
  if (bodies.empty())
  {
    return analysis;
  }
  // The unit of the total is that of the first body; a reader gives all its bodies the same unit.
  analysis.Unit = bodies.front().Model->GetLengthUnit();
  analysis.HasOneUnit = HaveOneUnit(bodies);
  MassRow& total = analysis.Total;
  if (analysis.HasOneUnit)
  {
    total.MeasuredBounds[1] = 0.0;
    total.Area = total.AreaBound = total.ClosureCorrection = total.GapSquared = total.GapArea = total.MaxGap =
      total.AreaSpread = 0.0;
  }
  else
  {
    // Volumes in different units cannot be added.
    analysis.Messages.push_back(MixedUnitsMessage);
  }
  std::vector<Moments> parts;
  for (BodyIntegrals& body : bodies)
  {
    Moments moments;
    MassRow row = AnalyzeBody(body, options, moments);
    if (options.Frame.IsGiven && std::isfinite(row.Properties.Volume))
    {
      row.InFrame = ComputeInFrame(moments, options.Frame);
    }
    if (std::isfinite(row.Properties.Volume))
    {
      parts.push_back(moments);
    }
    analysis.Rows.push_back(row);
  }
  const std::vector<std::string> shared = ShareProductMasses(bodies, analysis.Rows, options);
  analysis.HasMass = std::any_of(bodies.begin(), bodies.end(),
    [&options](const BodyIntegrals& body) { return ChooseMaterial(body, options).HasMass(); });
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    const BodyIntegrals& body = bodies[b];
    MassRow& row = analysis.Rows[b];
    SetMass(row, ChooseMaterial(body, options), FindShare(body, options), body.Model->GetLengthUnit());
    if (!options.HasBounds && std::isfinite(row.Properties.Volume))
    {
      row.RemoveBounds();
    }
    AddRow(row, total);
    analysis.OpenEdges += body.OpenEdges;
    analysis.FlippedShells += body.FlippedShells;
  }
  AnalyzeTotal(bodies, parts, options, analysis);
  RemoveLeftOut(bodies, options, analysis);
  NoteUnknownUnits(bodies, options, analysis);
  analysis.Messages.insert(analysis.Messages.end(), shared.begin(), shared.end());
  NoteStatedMasses(bodies, options, analysis);
  NoteUnusedRules(bodies, options, analysis);
  NoteCoincidences(bodies, analysis);
  // Bounds add up but scales need not, for example for parts on opposite sides of the origin.
  vtkBoundingBox box;
  for (const BodyIntegrals& body : bodies)
  {
    AddPlacedBox(body, box);
  }
  const std::string unmet =
    FindUnmet(total, options.Tolerance, box.IsValid() ? 0.5 * box.GetDiagonalLength() : 0.0);
  const bool isOk = std::all_of(
    bodies.begin(), bodies.end(), [](const BodyIntegrals& body) { return body.Status == Status::Ok; });
  if (isOk && !unmet.empty())
  {
    analysis.TotalStatus = Status::ToleranceNotMet;
    const double far =
      std::isfinite(total.Properties.Center[0]) ? vtkMath::Norm(total.Properties.Center.data()) : 0.0;
    analysis.Messages.insert(analysis.Messages.begin(),
      "bounds of the total above the tolerance, relative: " + unmet +
        DescribeDistance(total, far, box.IsValid() ? box.GetDiagonalLength() : 0.0, analysis.Unit));
  }
  return analysis;
}

IntegralRequest MakeMassRequest(const MassTolerance& tolerance)
{
  IntegralRequest request;
  request.Integrands = GetMassIntegrands();
  request.UsePlacements = false;
  request.MeasureSpread = true;
  request.GetTolerances = [tolerance](const BodyIntegrals& body)
  { return ShareTolerance(tolerance, *body.Model); };
  return request;
}

std::function<bool()> MakeContinue(const IntegralLimits& limits, const RunReport& report)
{
  using Clock = std::chrono::steady_clock;
  const auto left =
    std::chrono::duration<double>(limits.MaximumSeconds - report.PrepareSeconds - report.IntegrateSeconds);
  return [limits, left, start = Clock::now()]
  { return limits.Progress(1.0) && !(limits.MaximumSeconds > 0.0 && Clock::now() - start > left); };
}

MassAnalysis AnalyzeRun(std::vector<BodyIntegrals>& bodies, const MassAnalysisOptions& options,
  bool checkEdits, const IntegralLimits& limits, SelfCrossingCheck& crossings, RunReport& report)
{
  MassAnalysisOptions completed = options;
  const std::function<bool()> goesOn = MakeContinue(limits, report);
  const std::vector<std::string> twins = FindMirroredTwins(bodies, limits, report, goesOn, completed);
  MassAnalysis analysis = AnalyzeMass(bodies, completed);
  analysis.Messages.insert(analysis.Messages.end(), twins.begin(), twins.end());
  if (options.HasBounds)
  {
    crossings.Run(bodies, checkEdits, goesOn);
  }
  report.Status = std::max(report.Status, analysis.TotalStatus);
  report.Messages.insert(report.Messages.end(), analysis.Messages.begin(), analysis.Messages.end());
  return analysis;
}
}
