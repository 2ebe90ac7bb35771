#include "smMassAnalysis.h"

#include "smFormat.h"
#include "smMassIntegrands.h"
#include "smMoments.h"
#include "smPlausibility.h"
#include "smUnitRoundoff.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Moments of a body in the world, about its placed origin.
Moments GetMoments(const BodyIntegrals& body)
{
  Moments moments;
  std::copy_n(body.Model->GetOrigin(), 3, moments.Reference.begin());
  moments.Volume = body.Value[MassVolume];
  moments.VolumeBound = body.Bound[MassVolume];
  std::copy_n(body.Value.begin() + MassFirst, 3, moments.First.begin());
  std::copy_n(body.Bound.begin() + MassFirst, 3, moments.FirstBound.begin());
  std::copy_n(body.Value.begin() + MassSecond, 6, moments.Second.begin());
  std::copy_n(body.Bound.begin() + MassSecond, 6, moments.SecondBound.begin());
  if (moments.Volume < 0.0)
  {
    moments.Negate();
  }
  moments.Place(body.Placement.data());
  return moments;
}

/// Moments without a bound: the centre and the inertia follow from them as if they were exact.
void ZeroBounds(Moments& moments)
{
  moments.VolumeBound = 0.0;
  moments.FirstBound.fill(0.0);
  moments.SecondBound.fill(0.0);
}

void SetMass(MassRow& row, double density, const std::string& unit)
{
  const double metres = GetMetres(unit);
  const double factor = density > 0.0 && metres > 0.0 ? density * metres * metres * metres : vtkMath::Nan();
  row.Mass = factor * row.Properties.Volume;
  row.MassBound = factor * row.Properties.VolumeBound + 4.0 * UnitRoundoff * std::abs(row.Mass);
  for (int i = 0; i < 9; ++i)
  {
    row.MassInertia[i] = factor * row.Properties.Inertia[i];
  }
  row.MassInertiaBound = factor * row.Properties.InertiaBound;
}

/// Facts that hold for every body and not for this result make it suspect.
void CheckPlausibility(BodyIntegrals& body, const MassProperties& properties)
{
  std::array<double, 3> center;
  for (int i = 0; i < 3; ++i)
  {
    center[i] = body.Value[MassFirst + i] / body.Value[MassVolume];
  }
  // A trim that leaves its surface leads beyond the control points.
  double slack = 1e-12 * GetRadius(*body.Model);
  for (const FaceIntegrals& face : *body.Faces)
  {
    slack = std::max(slack, 2.0 * face.Outside);
  }
  for (const std::string& violation :
    FindImplausibilities(properties, center, GetHullBox(*body.Model), slack))
  {
    body.Flag(Status::Suspect, violation);
  }
}

/// The largest closure residual of a closed surface: what quadrature leaves of the vector area, at a loose tolerance or without
/// convergence, is no hole.
double GetLargestClosureResidual(
  const BodyIntegrals& body, double residualPerArea, const MassAnalysisOptions& options)
{
  return options.HasBounds
    ? options.LargestClosureResidual + residualPerArea * vtkMath::Norm(body.Bound.data() + MassVectorArea)
    // Texels leave the faces of a sound solid open.
    : body.IsSolid() ? std::numeric_limits<double>::infinity()
                     : options.LargestClosureResidual;
}

/// Properties of a body that encloses a volume. False when it turns out to be a surface.
bool AnalyzeVolume(BodyIntegrals& body, const MassAnalysisOptions& options, MassRow& row, Moments& moments)
{
  TurnShells(body, MakeMassIntegrands(), MassVolume);
  moments = GetMoments(body);
  if (!options.HasBounds)
  {
    ZeroBounds(moments);
  }
  row.Properties = ComputeMassProperties(moments);
  if (options.HasBounds)
  {
    row.ClosureCorrection = std::abs(body.Value[MassVolume] - body.FaceValue[MassVolume]);
  }
  else
  {
    row.RemoveBounds();
  }
  const double residualPerArea = std::cbrt(moments.Volume) / (3.0 * moments.Volume);
  row.ClosureResidual = residualPerArea * vtkMath::Norm(body.Value.data() + MassVectorArea);
  const bool isClosed = row.ClosureResidual <= GetLargestClosureResidual(body, residualPerArea, options);
  if (!body.IsSolid() && body.SkippedFaces == 0 && !isClosed)
  {
    // A surface whose border is no edge: a patch without loops.
    body.Flag(Status::Open, "a surface, not a solid: it has an area and no volume");
    row.Properties = MassProperties();
    row.ClosureCorrection = row.ClosureResidual = vtkMath::Nan();
    return false;
  }
  if (body.OpenEdges == 0 && body.SkippedFaces == 0 && !isClosed)
  {
    body.Flag(Status::Suspect,
      "the faces do not close although every edge is shared: a loop is broken or a face is wrong" +
        (std::isfinite(row.ClosureResidual) ? ". The volume changes by " + FormatBound(row.ClosureResidual) +
              " of itself when the origin moves by its cube root"
                                            : std::string()));
  }
  CheckPlausibility(body, row.Properties);
  return true;
}

/// The row of a body; `moments` gets its moments in the world when it has a volume.
MassRow AnalyzeBody(BodyIntegrals& body, const MassAnalysisOptions& options, Moments& moments)
{
  MassRow row;
  row.Area = body.Value[MassArea];
  row.AreaBound = body.Bound[MassArea];
  row.GapSquared = body.GapSquared;
  row.MaxGap = body.MaxGap;
  row.GapArea = body.GapArea;
  if (!body.Faces)
  {
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
    // It would be that of the texels.
    row.ClosureResidual = vtkMath::Nan();
    return row;
  }
  const std::string unmet = FindUnmet(row, options.Tolerance);
  if (!unmet.empty())
  {
    body.Flag(Status::ToleranceNotMet, "bounds above the tolerance, relative: " + unmet);
  }
  return row;
}

/// Adds what simply adds up.
void AddRow(const MassRow& row, MassRow& total)
{
  total.Area += row.Area;
  total.AreaBound += row.AreaBound + 2.0 * UnitRoundoff * total.Area;
  total.GapSquared += row.GapSquared;
  total.GapArea += row.GapArea;
  // Not std::max, which loses a NaN.
  total.MaxGap = row.MaxGap > total.MaxGap || std::isnan(row.MaxGap) ? row.MaxGap : total.MaxGap;
  if (std::isfinite(row.Properties.Volume))
  {
    total.ClosureCorrection += row.ClosureCorrection;
  }
}

/// The total of bodies that have a volume.
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
  double mass = 0.0;
  double massBound = 0.0;
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
    mass += analysis.Rows[b].Mass;
    massBound += analysis.Rows[b].MassBound;
  }
  const Moments sum = Moments::Sum(parts);
  total.Properties = ComputeMassProperties(sum);
  if (options.HasBounds)
  {
    total.ClosureResidual = vtkMath::Norm(vectorArea) * std::cbrt(sum.Volume) / (3.0 * sum.Volume);
  }
  else
  {
    total.RemoveBounds();
  }
  if (options.Density > 0.0 || bodies.size() == 1)
  {
    SetMass(
      total, options.Density > 0.0 ? options.Density : bodies.front().Model->GetDensity(), analysis.Unit);
    return;
  }
  // Densities differ from part to part: the sum has a mass, but its inertia is not density times VolumeInertia.
  total.Mass = mass;
  total.MassBound = massBound;
}
}

MassAnalysis AnalyzeMass(std::vector<BodyIntegrals>& bodies, const MassAnalysisOptions& options)
{
  MassAnalysis analysis;
  if (bodies.empty())
  {
    return analysis;
  }
  // Instances are named in the length unit of the first; a reader gives all its bodies one unit.
  analysis.Unit = bodies.front().Model->GetLengthUnit();
  analysis.HasOneUnit = std::all_of(bodies.begin(), bodies.end(),
    [&analysis](const BodyIntegrals& body) { return body.Model->GetLengthUnit() == analysis.Unit; });
  analysis.HasMass = options.Density > 0.0 ||
    std::any_of(
      bodies.begin(), bodies.end(), [](const BodyIntegrals& body) { return body.Model->GetDensity() > 0.0; });
  MassRow& total = analysis.Total;
  if (analysis.HasOneUnit)
  {
    total.Area = total.AreaBound = total.ClosureCorrection = total.GapSquared = total.GapArea = total.MaxGap =
      0.0;
  }
  else
  {
    // Cubic inches and cubic millimetres do not add up.
    analysis.Messages.push_back(
      "the parts have different length units: there is no total; read all files with one OutputUnit");
  }
  std::vector<Moments> parts;
  for (BodyIntegrals& body : bodies)
  {
    Moments moments;
    MassRow row = AnalyzeBody(body, options, moments);
    SetMass(
      row, options.Density > 0.0 ? options.Density : body.Model->GetDensity(), body.Model->GetLengthUnit());
    AddRow(row, total);
    if (std::isfinite(row.Properties.Volume))
    {
      parts.push_back(moments);
    }
    analysis.Rows.push_back(row);
    analysis.OpenEdges += body.OpenEdges;
    analysis.FlippedShells += body.FlippedShells;
  }
  AnalyzeTotal(bodies, parts, options, analysis);
  // Bounds add up, scales need not: parts on both sides of the origin.
  const std::string unmet = FindUnmet(total, options.Tolerance);
  const bool isOk = std::all_of(
    bodies.begin(), bodies.end(), [](const BodyIntegrals& body) { return body.Status == Status::Ok; });
  if (isOk && !unmet.empty())
  {
    analysis.TotalStatus = Status::ToleranceNotMet;
    analysis.Messages.push_back("bounds of the total above the tolerance, relative: " + unmet);
  }
  return analysis;
}
}
