#include "smRibbonPlanner.h"
#include "smUnitRoundoff.h"
#include "smVector.h"
#include "smWideEvaluation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
constexpr double Radii[] = { 1.3, 1.6, 2.0, 2.5, 3.2, 4.2, 6.0, 9.0, 15.0, 30.0, 100.0 };
constexpr int LargestOrder = 20;
constexpr int LargestDepth = 12;
// Nodes that are always affordable, and most of them.
constexpr int FewNodes = 10;
constexpr int MostNodes = 128;
// Points along a ribbon that also measures the gap between coedge and edge.
constexpr int LeastGapPoints = 3;

// Estimated error of evaluating a ribbon: rounding of its width, in units of u times the patch's radius and its stretch.
constexpr double RibbonRoundings = 8.0;
constexpr double TrimRoundings = 3.0;
// Roundings of a sample of the gap: those of the trim curve, the patch and the edge, up to degree 25 each.
constexpr double SampleRoundings = 64.0;
}

RibbonPlanner::RibbonPlanner(
  const Face& face, const FacePanels& panels, const PlanRequest& request, FacePlan& plan)
  : Panels(panels)
  , Request(request)
  , Result(plan)
{
  // Panels may have u and v exchanged, see smFacePanels.h.
  const bool transposed = face.Surface.Degree[0] > face.Surface.Degree[1];
  for (const Loop& loop : face.Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      const std::array<double, 2>& trim = coedge.Curve.Residual;
      const std::array<double, 3>& edge = coedge.Use->Curve.Residual;
      this->Residuals.push_back(
        { transposed ? std::array<double, 2>{ trim[1], trim[0] } : trim, Norm(edge.data()) });
    }
  }
}

void RibbonPlanner::ExpandEdge(const Ribbon& ribbon, double start, double end)
{
  const int degree = ribbon.EdgeDegree;
  std::array<double, 3> points[MaximumDegree + 1];
  for (int i = 0; i <= degree; ++i)
  {
    std::copy_n(this->Panels.Coefficients.data() + ribbon.Edge + 3 * i, 3, points[i].begin());
  }
  const BernsteinPiece<3> piece{ points, degree };
  const ChebyshevRule& rule = ChebyshevRule::Get(degree + 1);
  const double width = ribbon.EdgeEnd - ribbon.EdgeStart;
  this->Curve.assign(degree + 1, { 0.0, 0.0, 0.0 });
  for (int i = 0; i <= degree; ++i)
  {
    const double t = start + (end - start) * 0.5 * (1.0 + rule.GetNode(i));
    const std::array<double, 3> point = piece.Evaluate(ribbon.EdgeStart + width * t);
    for (int k = 0; k <= degree; ++k)
    {
      for (int c = 0; c < 3; ++c)
      {
        this->Curve[k][c] += rule.GetTransform(k)[i] * point[c];
      }
    }
  }
  double center[3];
  for (int c = 0; c < 3; ++c)
  {
    center[c] = this->Curve[0][c] + this->Request.Shift[c];
  }
  this->CurveDistance = Norm(center);
}

int RibbonPlanner::ChooseNodes(const Ribbon& ribbon, double& tail)
{
  // U has the degree of P(c(t)) plus that of C.
  const Patch& patch = this->Panels.Patches[ribbon.Patch];
  const int inS = this->Trim.GetLow(0) == this->Trim.GetHigh(0) ? 0 : patch.Degree[0];
  const int inR = this->Trim.GetLow(1) == this->Trim.GetHigh(1) ? 0 : patch.Degree[1];
  const int exact = (inS + inR) * this->Trim.GetDegree() + ribbon.EdgeDegree + 1;
  tail = 0.0;
  this->Rough = false;
  if (exact <= FewNodes)
  {
    return exact;
  }
  // Interpolation in n nodes misses at most 4 M rho^(1-n) / (rho - 1) of a function below M in the ellipse.
  PatchTraits traits;
  traits.Polynomial = false;
  const ParameterBox box = this->Trim.GetBox(1.0, 1.0);
  this->Crude.ExpandWithoutNormal(
    this->Panels.Points.data() + patch.FirstPoint, patch.Degree[0], patch.Degree[1], traits, box);
  double size;
  double realWeight;
  const Ellipse real = Ellipse::FromRadius(1.0);
  this->Crude.EvaluatePosition(real, real, size, realWeight);
  const double wanted = 0.01 * UnitRoundoff * (this->CurveDistance * realWeight + size);
  int nodes = std::min(exact, MostNodes);
  tail = exact <= MostNodes ? 0.0 : std::numeric_limits<double>::infinity();
  for (const double radius : Radii)
  {
    const Ellipse t = Ellipse::FromRadius(radius);
    double position;
    double weight;
    this->Crude.EvaluatePosition(
      this->Trim.Map(t, 0, box, 1.0, 1.0), this->Trim.Map(t, 1, box, 1.0, 1.0), position, weight);
    t.GetMajorants(static_cast<int>(this->Curve.size()), this->Powers);
    const double offset[3] = { this->Curve[0][0] - patch.Center[0], this->Curve[0][1] - patch.Center[1],
      this->Curve[0][2] - patch.Center[2] };
    double curve = Norm(offset);
    for (std::size_t k = 1; k < this->Curve.size(); ++k)
    {
      curve += Norm(this->Curve[k].data()) * this->Powers[k];
    }
    const double largest = curve * weight + position;
    const double factor = 4.0 * radius * largest / (radius - 1.0);
    const double count = std::ceil(std::log(std::max(factor / wanted, 1.0)) / std::log(radius)) + 1.0;
    const double mostly = factor * std::pow(radius, -MostNodes);
    if (count < nodes)
    {
      nodes = std::max(FewNodes, static_cast<int>(count));
      tail = wanted;
    }
    else if (nodes == MostNodes && mostly < tail)
    {
      tail = mostly;
    }
  }
  this->Rough = !(tail <= 100.0 * wanted);
  return nodes;
}

void RibbonPlanner::SampleGap(const Ribbon& ribbon, double start, double end, int nodes, double tail)
{
  const Patch& patch = this->Panels.Patches[ribbon.Patch];
  const ChebyshevRule& rule = ChebyshevRule::Get(nodes);
  this->Nodes = nodes;
  std::vector<std::array<Wide, 4>> series(nodes);
  this->Stretch = this->TrimSlope = { 0.0, 0.0 };
  this->NormalLength = 0.0;
  double size = 0.0;
  for (int i = 0; i < nodes; ++i)
  {
    const double x = rule.GetNode(i);
    const Wide t = start + (static_cast<Wide>(end) - start) * 0.5L * (1.0L + x);
    Wide at[2];
    EvaluatePiece(this->Panels.Coefficients.data() + ribbon.Trim, 2, ribbon.TrimDegree,
      ribbon.Start + (static_cast<Wide>(ribbon.End) - ribbon.Start) * t, patch.Start, at);
    Wide h[3][4];
    EvaluatePatch(this->Panels.Points.data() + patch.FirstPoint, patch.Degree[0], patch.Degree[1],
      at[0] / patch.Width[0], at[1] / patch.Width[1], h);
    Wide edge[3];
    EvaluatePiece(this->Panels.Coefficients.data() + ribbon.Edge, 3, ribbon.EdgeDegree,
      ribbon.EdgeStart + (static_cast<Wide>(ribbon.EdgeEnd) - ribbon.EdgeStart) * t, patch.Center, edge);
    std::array<Wide, 4> gap;
    for (int c = 0; c < 3; ++c)
    {
      gap[c] = edge[c] * h[0][3] - h[0][c];
      size = std::max(
        { size, static_cast<double>(std::abs(edge[c] * h[0][3])), static_cast<double>(std::abs(h[0][c])) });
    }
    gap[3] = h[0][3];
    for (int k = 0; k < nodes; ++k)
    {
      for (int c = 0; c < 4; ++c)
      {
        series[k][c] += rule.GetTransform(k)[i] * gap[c];
      }
    }
    this->SampleTangents(x, h);
  }
  this->Gap.resize(nodes);
  for (int k = 0; k < nodes; ++k)
  {
    std::copy(series[k].begin(), series[k].end(), this->Gap[k].begin());
    if (k > 0 && std::abs(this->Gap[k][3]) <= 16.0 * UnitRoundoff * this->Gap[0][3])
    {
      this->Gap[k][3] = 0.0;
    }
  }
  // The series interpolates samples that are off by rounding; between the nodes, by that times Lebesgue's constant.
  this->Noise = tail + SampleRoundings * WideRoundoff * size * (1.0 + std::log(static_cast<double>(nodes)));
}

void RibbonPlanner::SampleTangents(double x, const Wide h[3][4])
{
  double tangent[2][3];
  const std::array<double, 2> slope = this->Trim.EvaluateDerivative(x);
  for (int d = 0; d < 2; ++d)
  {
    for (int c = 0; c < 3; ++c)
    {
      tangent[d][c] = static_cast<double>((h[d + 1][c] - h[d + 1][3] * h[0][c] / h[0][3]) / h[0][3]);
    }
    this->Stretch[d] = std::max(this->Stretch[d], Norm(tangent[d]));
    this->TrimSlope[d] = std::max(this->TrimSlope[d], std::abs(slope[d]));
  }
  const double normal[3] = { tangent[0][1] * tangent[1][2] - tangent[0][2] * tangent[1][1],
    tangent[0][2] * tangent[1][0] - tangent[0][0] * tangent[1][2],
    tangent[0][0] * tangent[1][1] - tangent[0][1] * tangent[1][0] };
  this->NormalLength = std::max(this->NormalLength, Norm(normal));
}

bool RibbonPlanner::Evaluate(const Ellipse& t, Majorants& majorants) const
{
  t.GetMajorants(std::max<int>(this->Nodes, static_cast<int>(this->Curve.size())), this->Powers);
  // The derivative's series by its majorant: |T_k'| <= k T_k(A) .. on the ellipse is too small near the foci, so the
  // coefficients of the derivative are summed.
  majorants = { this->CurveDistance, 0.0, 0.0, 0.0, this->Gap[0][3] };
  const auto slope = [this](std::size_t count, const auto& norm)
  {
    // d_{k-1} = d_{k+1} + 2 k c_k, all taken positive; times 2 from [-1,1] to [0,1].
    double sum = 0.0;
    double odd = 0.0;
    double even = 0.0;
    for (std::size_t k = count; k-- > 1;)
    {
      double& d = k % 2 ? odd : even;
      d += 2.0 * static_cast<double>(k) * norm(k);
      sum += (k == 1 ? 0.5 : 1.0) * d * this->Powers[k - 1];
    }
    return 2.0 * sum;
  };
  for (std::size_t k = 1; k < this->Curve.size(); ++k)
  {
    majorants.Curve += Norm(this->Curve[k].data()) * this->Powers[k];
  }
  majorants.CurveSlope =
    slope(this->Curve.size(), [this](std::size_t k) { return Norm(this->Curve[k].data()); });
  double numerator = Norm(this->Gap[0].data());
  for (std::size_t k = 1; k < this->Gap.size(); ++k)
  {
    numerator += Norm(this->Gap[k].data()) * this->Powers[k];
    majorants.Weight -= std::abs(this->Gap[k][3]) * this->Powers[k];
  }
  if (!(majorants.Weight > 1e-9 * this->Gap[0][3]))
  {
    return false;
  }
  majorants.Gap = numerator / majorants.Weight;
  const double numeratorSlope =
    slope(this->Gap.size(), [this](std::size_t k) { return Norm(this->Gap[k].data()); });
  const double weightSlope =
    slope(this->Gap.size(), [this](std::size_t k) { return std::abs(this->Gap[k][3]); });
  majorants.GapSlope = (numeratorSlope + weightSlope * majorants.Gap) / majorants.Weight;
  return true;
}

void RibbonPlanner::Bound(const Majorants& m, std::vector<double>& bounds) const
{
  const double strip = m.Gap * (m.CurveSlope + m.GapSlope);
  bounds.assign(this->Request.Classes.size(), 0.0);
  for (std::size_t i = 0; i < bounds.size(); ++i)
  {
    const BoundClass& c = this->Request.Classes[i];
    if (c.Kind == BoundClass::VolumeMoment)
    {
      bounds[i] = m.Curve * strip * std::pow(m.Curve + m.Gap, c.Degree) / (3 + c.Degree);
    }
    else if (c.Kind == BoundClass::HeightMoment)
    {
      bounds[i] = strip * std::pow(m.Curve + m.Gap, c.Degree + 1);
    }
    else if (c.Kind == BoundClass::VectorArea)
    {
      bounds[i] = strip;
    }
  }
}

bool RibbonPlanner::IsRounding(const Ribbon& ribbon, const Majorants& real) const
{
  // An estimate of the rounding bound of smRibbon.glsl; both bounds hold, this one is to be the smaller.
  const Patch& patch = this->Panels.Patches[ribbon.Patch];
  const double rounding =
    UnitRoundoff * (RibbonRoundings * patch.Radius + TrimRoundings * (this->Stretch[0] + this->Stretch[1]));
  return real.Gap + this->Noise / real.Weight <= rounding;
}

void RibbonPlanner::AddNoiseError(const Majorants& real)
{
  // With G off by e, G' by at most 2 N^2 e (Markov): a rule errs by at most twice what the integrand changes.
  const double e = this->Noise / real.Weight;
  const double strip =
    e * (real.CurveSlope + real.GapSlope) + (real.Gap + e) * 2.0 * this->Nodes * this->Nodes * e;
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    const BoundClass& c = this->Request.Classes[i];
    if (c.Kind == BoundClass::VolumeMoment)
    {
      this->Result.QuadratureBound[i] +=
        2.0 * (real.Curve + real.Gap) * strip * std::pow(real.Curve + real.Gap, c.Degree) / (3 + c.Degree);
    }
    else if (c.Kind == BoundClass::HeightMoment)
    {
      this->Result.QuadratureBound[i] += 2.0 * strip * std::pow(real.Curve + real.Gap, c.Degree + 1);
    }
    else if (c.Kind == BoundClass::VectorArea)
    {
      this->Result.QuadratureBound[i] += 2.0 * strip;
    }
  }
}

void RibbonPlanner::AddResidualError(const Ribbon& ribbon, const Majorants& real)
{
  if (ribbon.Coedge < 0)
  {
    return;
  }
  const Patch& patch = this->Panels.Patches[ribbon.Patch];
  const Residual& residual = this->Residuals[ribbon.Coedge];
  const double ds = residual.Trim[0] / patch.Width[0];
  const double dr = residual.Trim[1] / patch.Width[1];
  if (ds == 0.0 && dr == 0.0 && residual.Edge == 0.0)
  {
    return;
  }
  // The faces' boundary moves by Ss ds + Sr dr, and sweeps |Ss x Sr| |ds r' - dr s'| of their area. The chain stays closed, and its
  // volume changes by what the ribbon sweeps: a triangle of the gap and the displacement along the length. 2: these are
  // known at nodes only.
  const double area = 2.0 * this->NormalLength * (ds * this->TrimSlope[1] + dr * this->TrimSlope[0]);
  const double moved = 2.0 * (ds * this->Stretch[0] + dr * this->Stretch[1]) + residual.Edge;
  const double length = real.CurveSlope + real.GapSlope;
  const double reach = real.Curve + real.Gap;
  for (std::size_t i = 0; i < this->Request.Classes.size(); ++i)
  {
    const BoundClass& c = this->Request.Classes[i];
    const double power = std::pow(reach, c.Degree);
    this->Result.ConversionBound[i] += c.Kind == BoundClass::AreaMoment ? area * power
      : c.Kind == BoundClass::VolumeMoment || c.Kind == BoundClass::HeightMoment
      ? moved * (real.Gap + moved) * length * power
      : 0.0;
  }
}

void RibbonPlanner::BoundAlong(bool sound, const Majorants& real)
{
  const std::size_t count = this->Request.Classes.size();
  this->AlongT.Reset(count);
  this->Supremum.assign(count, std::numeric_limits<double>::infinity());
  if (!sound)
  {
    return;
  }
  this->Bound(real, this->Supremum);
  for (const double radius : Radii)
  {
    Majorants majorants;
    if (!this->Evaluate(Ellipse::FromRadius(radius), majorants))
    {
      break;
    }
    this->Bound(majorants, this->Bounds);
    this->AlongT.AddEllipse(radius, this->Bounds);
  }
}

int RibbonPlanner::ChooseOrder(double share) const
{
  int along = 1;
  for (std::size_t i = 0; i < this->Supremum.size(); ++i)
  {
    const double tolerance = share * this->Request.Tolerances[i];
    if (this->Request.Classes[i].Kind != BoundClass::AreaMoment && tolerance > 0.0 &&
      !(2.0 * this->Supremum[i] <= tolerance))
    {
      along = std::max(along, this->AlongT.FindOrder(i, tolerance, LargestOrder));
    }
  }
  return along;
}

void RibbonPlanner::AddItem(const PlannedItem& item)
{
  for (std::size_t i = 0; i < this->Supremum.size(); ++i)
  {
    if (this->Request.Classes[i].Kind != BoundClass::AreaMoment)
    {
      this->Result.QuadratureBound[i] +=
        std::min(2.0 * this->Supremum[i], this->AlongT.GetError(i, item.Along));
      this->Result.Magnitude[i] += this->Supremum[i];
    }
  }
  this->Result.Evaluations += item.Along;
  this->Result.Items.push_back(item);
}

void RibbonPlanner::PlanPart(std::uint32_t index, double start, double end, int depth)
{
  const Ribbon& ribbon = this->Panels.Ribbons[index];
  const Patch& patch = this->Panels.Patches[ribbon.Patch];
  const double width = ribbon.End - ribbon.Start;
  this->Trim.Expand(this->Panels.Coefficients.data() + ribbon.Trim, ribbon.TrimDegree, patch,
    ribbon.Start + width * start, ribbon.Start + width * end);
  this->ExpandEdge(ribbon, start, end);
  double tail = 0.0;
  const int nodes = this->ChooseNodes(ribbon, tail);
  this->SampleGap(ribbon, start, end, nodes, tail);

  Majorants real;
  const bool sound = this->Evaluate(Ellipse::FromRadius(1.0), real) && std::isfinite(tail);
  this->BoundAlong(sound, real);
  const double share = std::exp2(-depth);
  const int along = this->ChooseOrder(share);
  if ((along > LargestOrder || this->Rough) && depth < LargestDepth)
  {
    const double middle = 0.5 * (start + end);
    this->PlanPart(index, start, middle, depth + 1);
    this->PlanPart(index, middle, end, depth + 1);
    return;
  }
  if (sound && this->IsRounding(ribbon, real))
  {
    for (std::size_t i = 0; i < this->Supremum.size(); ++i)
    {
      this->Result.QuadratureBound[i] += this->Supremum[i];
      this->Result.Magnitude[i] += this->Supremum[i];
    }
    this->AddNoiseError(real);
    this->AddResidualError(ribbon, real);
    return;
  }
  PlannedItem item{ ItemKind::Ribbon, index };
  item.Start = start;
  item.End = end;
  item.Along = std::clamp(along, ribbon.AlongEdge ? LeastGapPoints : 1, LargestOrder);
  item.Share = share;
  this->AddItem(item);
  if (sound)
  {
    this->AddNoiseError(real);
    this->AddResidualError(ribbon, real);
  }
}

void RibbonPlanner::Plan(std::uint32_t index)
{
  this->PlanPart(index, 0.0, 1.0, 0);
}
}
