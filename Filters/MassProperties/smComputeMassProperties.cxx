#include "smComputeMassProperties.h"

#include "Detail/smSelfCrossing.h"
#include "smCountedBodies.h"
#include "smFailureReason.h"
#include "smFileState.h"
#include "smFormat.h"
#include "smIntegralEngine.h"
#include "smMassAnalysis.h"
#include "smWeights.h"

#include "vtkDataObject.h"

#include <algorithm>
#include <cmath>
#include <exception>

namespace sm
{
namespace
{
/// The option that is out of its range, in a sentence; empty if there is none.
std::string FindWrongOption(const MassPropertiesOptions& options)
{
  const auto say = [](const char* name, double value, const char* range)
  { return std::string(name) + " is " + FormatDigits(value, 6) + "; give " + range; };
  if (!(options.RelativeTolerance > 0.0 && options.RelativeTolerance <= 1.0))
  {
    return say("RelativeTolerance", options.RelativeTolerance, "a number above 0, at most 1");
  }
  if (options.Density != 0.0 && !IsWeight(options.Density))
  {
    return say("Density", options.Density,
      (std::string("kg/m^3 from ") + WeightRange + ", or 0 for what the file states").c_str());
  }
  if (!(options.DensityTolerance >= 0.0 && options.DensityTolerance <= 1.0))
  {
    return say("DensityTolerance", options.DensityTolerance, "0 to 1");
  }
  if (!(options.GapLimit >= 0.0 && options.GapLimit <= 1.0))
  {
    return say("GapLimit", options.GapLimit, "0 to 1");
  }
  if (options.MaximumEvaluations < 1)
  {
    return say("MaximumEvaluations", static_cast<double>(options.MaximumEvaluations), "at least 1");
  }
  if (!(options.MaximumSeconds >= 0.0))
  {
    return say("MaximumSeconds", options.MaximumSeconds, "a time, or 0 for no limit");
  }
  for (const MaterialRule& rule : options.Materials)
  {
    const std::string problem = FindRuleProblem(rule);
    if (!problem.empty())
    {
      return "Materials, " + rule.Pattern + ": " + problem;
    }
  }
  return {};
}

BodyMassProperties MakeBody(const MassRow& row)
{
  const MassProperties& p = row.Properties;
  BodyMassProperties body;
  body.Volume = { p.Volume, p.VolumeBound };
  body.Area = { row.Area, row.AreaBound };
  body.Center = { p.Center, p.CenterBound };
  body.Inertia = { p.Inertia, p.InertiaBound };
  body.InertiaAtOrigin = { p.InertiaAtOrigin, p.InertiaAtOriginBound };
  body.PrincipalMoments = { p.Principal, p.PrincipalBound };
  body.PrincipalAxes = { p.Axes, p.AxesBound };
  body.PrincipalAxesDegenerate = p.AxesDegenerate;
  body.RadiiOfGyration = { p.Gyration, p.GyrationBound };
  body.Density = row.Density;
  body.Material = row.Material;
  body.Mass = { row.Mass, row.MassBound };
  body.OverriddenMass = row.OverriddenMass;
  body.MassCenter = { row.Weighted.Center, row.Weighted.CenterBound };
  body.MassInertia = { row.MassInertia, row.MassInertiaBound };
  body.Volume.Spread = row.Spread.Volume;
  body.Area.Spread = row.AreaSpread;
  body.Center.Spread = row.Spread.Center;
  body.Inertia.Spread = row.Spread.Inertia;
  body.PrincipalMoments.Spread = row.Spread.Principal;
  body.Mass.Spread = row.WeightedSpread.Volume;
  body.MassCenter.Spread = row.WeightedSpread.Center;
  body.MassInertia.Spread = row.WeightedSpread.Inertia;
  body.ClosureCorrection = row.ClosureCorrection;
  body.ClosureResidual = row.ClosureResidual;
  body.GapSquared = row.GapSquared;
  body.GapArea = row.GapArea;
  body.MaxGap = row.MaxGap;
  return body;
}

MassPropertiesResult MakeResult(
  const MassAnalysis& analysis, const std::vector<BodyIntegrals>& bodies, const RunReport& report)
{
  MassPropertiesResult result;
  result.Total = MakeBody(analysis.Total);
  result.Total.Status = GetText(report.Status);
  result.Total.OpenEdges = analysis.OpenEdges;
  result.Reason = report.Status == Status::Ok ? "" : report.FindReason(bodies);
  result.LengthUnit = analysis.Unit;
  result.KnownMass = { analysis.Total.KnownMass, analysis.Total.KnownMassBound };
  result.SolidsWithMass = analysis.Weighed;
  result.SolidsWithVolume = analysis.Weighable;
  result.Faces = report.Faces;
  result.Evaluations = report.Evaluations;
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    BodyMassProperties body = MakeBody(analysis.Rows[i]);
    body.Name = bodies[i].Name;
    body.Id = bodies[i].Id;
    body.Status = GetText(bodies[i].Status);
    body.Messages = bodies[i].Messages;
    body.OpenEdges = bodies[i].OpenEdges;
    result.Solids.push_back(std::move(body));
  }
  return result;
}

MassPropertiesResult Compute(vtkDataObject* model, const MassPropertiesOptions& options)
{
  IntegralEngine engine;
  engine.SetController(nullptr);
  RunReport& report = engine.GetReport();
  RejectedInput rejected;
  std::vector<BodyIntegrals> bodies = CollectBodies(model, rejected);
  MassAnalysis analysis;
  if (bodies.empty() && rejected.Plain + rejected.Withheld > 0)
  {
    report.RejectInput(rejected.Withheld > 0);
    MassPropertiesResult result = MakeResult(analysis, bodies, report);
    result.Reason = report.Messages.back();
    result.Total.Messages = report.Messages;
    return result;
  }
  report.Messages = LeaveOutBodies(options.Materials, model, true, bodies);
  report.AddBodies(bodies, rejected);
  report.AddFile(GetFileState(model), !bodies.empty(), !bodies.empty());

  const Tolerance tolerance{ std::max(options.RelativeTolerance, 1e-15), 0.0 };
  MassAnalysisOptions wanted;
  wanted.Tolerance = { tolerance, tolerance, tolerance, tolerance };
  wanted.Density = options.Density;
  wanted.DensityTolerance = options.DensityTolerance;
  wanted.Materials = options.Materials;
  wanted.TakeProducts(model);
  wanted.GapLimit = options.GapLimit;
  IntegralLimits limits;
  limits.Backend = BackendChoice::CPU;
  limits.MaximumEvaluations = options.MaximumEvaluations;
  limits.MaximumSeconds = options.MaximumSeconds;
  limits.CacheFaceResults = false;
  limits.Progress = options.Progress ? options.Progress : [](double) { return true; };
  const IntegralRequest request = MakeMassRequest(wanted.Tolerance);
  const bool computed = !bodies.empty() && engine.Integrate(request, limits, bodies);
  engine.Sum(request, computed, wanted.GapLimit, bodies);
  SelfCrossingCheck crossings;
  analysis = AnalyzeRun(bodies, wanted, true, limits, crossings, report);
  report.AddStatuses(bodies);
  MassPropertiesResult result = MakeResult(analysis, bodies, report);
  // The messages of a body are with the body.
  result.Total.Messages = report.Messages;
  return result;
}

MassPropertiesResult MakeFailure(const std::string& reason)
{
  RunReport report;
  report.Status = Status::NotComputed;
  report.SetReason(reason);
  MassPropertiesResult result = MakeResult({}, {}, report);
  result.Total.Messages = report.Messages;
  return result;
}
}

MassPropertiesResult ComputeMassProperties(vtkDataObject* model, const MassPropertiesOptions& options)
{
  try
  {
    const std::string wrong = FindWrongOption(options);
    return wrong.empty() ? Compute(model, options) : MakeFailure("nothing was computed: " + wrong);
  }
  catch (...)
  {
    return MakeFailure(std::string("nothing was computed: ") + GetReason(std::current_exception()));
  }
}
}
