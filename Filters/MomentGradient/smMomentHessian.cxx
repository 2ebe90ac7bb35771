#include "smMomentHessian.h"

#include "Detail/smGradientBodies.h"
#include "Detail/smModelGradient.h"
#include "Detail/smMomentFrame.h"
#include "smBodyScales.h"
#include "smFailureReason.h"
#include "smFormat.h"
#include "smUnitRoundoff.h"

#include "vtkDataObject.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <map>
#include <memory>
#include <set>

namespace sm
{
namespace
{
// Fraction of the progress for the mass properties.
constexpr double HessianMassShare = 0.2;
// Positions on the line P + t v, as multiples of one t, and their factors in the derivative at 0, times 12 t:
// exact for polynomials of degree 4. The volume's gradient has degree 2: the inner two suffice, with 6.
constexpr int Positions[4] = { -2, -1, 1, 2 };
constexpr double Factors[4] = { 1.0, -8.0, 8.0, -1.0 };
constexpr double VolumeFactors[4] = { 0.0, -6.0, 6.0, 0.0 };
// The largest displacement at t, over half the diagonal of the body.
constexpr double Reach = 0.5;
// Differences of the displacements of tied points, relative to the largest one.
constexpr double EqualMoves = 1e-12;
// The largest displacement of a body that moves: products and bounds stay far from overflow and underflow.
constexpr double MinMove = 1e-200;
constexpr double MaxMove = 1e200;
// Distance of a trim curve from the border of the domain, relative to it: rounding of what was read.
constexpr double OnBorder = 1e-9;
constexpr double ProductGrowth = 1.0 + 1e-10;

using Displacements = std::vector<std::array<double, 3>>;

/// One computation.
class HessianRun
{
public:
  HessianRun(const std::vector<NetDirection>& direction, const MomentHessianOptions& options)
    : Direction(direction)
    , Options(options)
  {
  }

  MomentHessianResult Run(vtkDataObject* model);

private:
  MomentHessianResult Stop(const std::string& reason) const;
  bool AddBody(std::size_t body, std::string& error);
  /// Returns the displacements of each face of a body, in the model's axes and the order of ControlPoints,
  /// empty where a face stays; false with the reason.
  bool FindMoves(
    std::size_t body, const TiedVariables& tied, std::vector<Displacements>& moves, std::string& error) const;
  bool Integrate(std::size_t body, const std::vector<Displacements>& moves,
    std::vector<NetGradient>& products, std::string& error);
  FaceHessianProduct MakeFace(
    std::size_t body, std::size_t face, const NetGradient& product, bool hasTiedBorder) const;
  bool Report(std::size_t body, double fraction) const;

  const std::vector<NetDirection>& Direction;
  const MomentHessianOptions& Options;
  GradientBodies Mass;
  MomentHessianResult Result;
};

MomentHessianResult HessianRun::Stop(const std::string& reason) const
{
  MomentHessianResult failure;
  failure.Status = GetText(Status::NotComputed);
  failure.Reason = reason;
  return failure;
}

bool HessianRun::Report(std::size_t body, double fraction) const
{
  const double share = (1.0 - HessianMassShare) / static_cast<double>(this->Mass.Bodies.size());
  return !this->Options.Progress ||
    this->Options.Progress(HessianMassShare + share * (static_cast<double>(body) + fraction));
}

std::string DescribeNet(const NetDirection& net)
{
  return "face " + std::to_string(net.Face) + " of solid " + std::to_string(net.Solid);
}

/// Returns a face with its control points moved by `factor` times the displacements.
FacePointer MoveFace(const Face& source, const Displacements& moves, double factor, double axesOff)
{
  auto moved = std::make_shared<Face>(source);
  moved->Id = NewId();
  NURBSSurface& surface = moved->Surface;
  std::array<double, 3> rounding{};
  for (std::size_t i = 0; i < moves.size(); ++i)
  {
    std::array<double, 4>& point = surface.ControlPoints[i];
    double length = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      length += std::abs(moves[i][c] * factor);
    }
    for (int c = 0; c < 3; ++c)
    {
      // Two products and a sum; the displacement itself is rounded, and rotated by axes that are.
      rounding[c] = std::max(rounding[c],
        4.0 * UnitRoundoff * (std::abs(point[c] / point[3]) + std::abs(moves[i][c] * factor)) +
          axesOff * length);
      point[c] += point[3] * (factor * moves[i][c]);
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    surface.Rounding[c] += rounding[c];
  }
  return moved;
}

/// Moves tied points by the displacement of the first one, as they are one variable. Returns the first face
/// of which a point moves unlike one that it is tied to, by more than `tolerance`; -1 if there is none.
int JoinMoves(std::vector<Displacements>& moves, const TiedVariables& tied, double tolerance)
{
  std::map<int, std::array<double, 3>> first;
  for (std::size_t f = 0; f < moves.size(); ++f)
  {
    for (std::size_t i = 0; i < tied.Points[f].size(); ++i)
    {
      const std::array<double, 3> by = moves[f].empty() ? std::array<double, 3>{} : moves[f][i];
      const std::array<double, 3>& other = first.insert({ tied.Points[f][i], by }).first->second;
      if (!(std::hypot(by[0] - other[0], by[1] - other[1], by[2] - other[2]) <= tolerance))
      {
        return static_cast<int>(f);
      }
      if (by != other)
      {
        moves[f].resize(tied.Points[f].size());
        moves[f][i] = other;
      }
    }
  }
  return -1;
}

bool HessianRun::FindMoves(
  std::size_t body, const TiedVariables& tied, std::vector<Displacements>& moves, std::string& error) const
{
  const BodyIntegrals& source = this->Mass.Bodies[body];
  const std::vector<FacePointer>& faces = source.Model->GetFaces();
  moves.assign(faces.size(), {});
  double largest = 0.0;
  for (const NetDirection& net : this->Direction)
  {
    if (net.Solid != this->Mass.Indices[body])
    {
      continue;
    }
    if (net.Face < 0 || static_cast<std::size_t>(net.Face) >= faces.size() || !moves[net.Face].empty())
    {
      error = DescribeNet(net) + " does not exist or is named twice; name each face that moves once";
      return false;
    }
    const NURBSSurface& surface = faces[net.Face]->Surface;
    const int* count = surface.NumberOfControlPoints;
    if (net.Displacements.size() != surface.ControlPoints.size())
    {
      error = DescribeNet(net) + " has " + std::to_string(surface.ControlPoints.size()) +
        " control points; give as many displacements instead of " + std::to_string(net.Displacements.size());
      return false;
    }
    moves[net.Face].resize(net.Displacements.size());
    for (int i = 0; i < count[0]; ++i)
    {
      for (int j = 0; j < count[1]; ++j)
      {
        const std::array<double, 3>& by = net.Displacements[static_cast<std::size_t>(i) * count[1] + j];
        std::array<double, 3>& to = moves[net.Face][i + static_cast<std::size_t>(count[0]) * j];
        for (int c = 0; c < 3; ++c)
        {
          to[c] =
            source.Placement[c] * by[0] + source.Placement[4 + c] * by[1] + source.Placement[8 + c] * by[2];
        }
        const double length = std::hypot(by[0], by[1], by[2]);
        if (!std::isfinite(length))
        {
          error = "a displacement of " + DescribeNet(net) + " is not finite; give numbers";
          return false;
        }
        largest = std::max(largest, length);
      }
    }
  }
  if (largest != 0.0 && !(largest >= MinMove && largest <= MaxMove))
  {
    error = "the largest displacement of solid " + std::to_string(this->Mass.Indices[body]) + " is " +
      FormatDigits(largest, 6) +
      ", so that the product may overflow or underflow; scale the direction to 1e-200 "
      "to 1e200, as the product is linear in it";
    return false;
  }
  const int torn = this->Options.Tied ? JoinMoves(moves, tied, EqualMoves * largest) : -1;
  if (torn >= 0)
  {
    error = "tied points move apart at face " + std::to_string(torn) + " of solid " +
      std::to_string(this->Mass.Indices[body]) +
      "; give coinciding points of all faces the same displacement, or switch Tied off";
  }
  return torn < 0;
}

bool HessianRun::Integrate(std::size_t body, const std::vector<Displacements>& moves,
  std::vector<NetGradient>& products, std::string& error)
{
  const BodyIntegrals& source = this->Mass.Bodies[body];
  const std::vector<FacePointer>& faces = source.Model->GetFaces();
  const MomentFrame frame(source.Placement.data(), source.Model->GetOrigin(), {});
  std::vector<bool> isMoved(faces.size());
  double largest = 0.0;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    for (const std::array<double, 3>& by : moves[f])
    {
      largest = std::max(largest, std::hypot(by[0], by[1], by[2]));
      isMoved[f] = isMoved[f] || by != std::array<double, 3>{};
    }
  }
  const double t = largest > 0.0 ? Reach * GetRadius(*source.Model) / largest : 0.0;
  products.assign(faces.size(), {});
  for (int k = 0; k < 4 && largest > 0.0; ++k)
  {
    std::vector<FacePointer> moved = faces;
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      moved[f] = isMoved[f] ? MoveFace(*faces[f], moves[f], Positions[k] * t, frame.GetAxesOff()) : faces[f];
    }
    auto model = vtkSmartPointer<vtkTrimmedNURBSModel>::New();
    model->ShallowCopy(source.Model);
    model->SetFaces(moved);
    ModelGradient gradient;
    PatchIntegrator processor;
    if (!gradient.Compute(
          model, isMoved, this->Mass.GetSides(body), this->Options.RelativeTolerance,
          [&](double fraction) { return this->Report(body, 0.25 * (k + fraction)); }, processor,
          ModelGradient::Closing::Nothing))
    {
      error = gradient.GetError();
      return false;
    }
    this->Result.Evaluations += gradient.GetEvaluations();
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      const NetGradient& from = gradient.Get(f);
      NetGradient& to = products[f];
      if (!isMoved[f])
      {
        continue;
      }
      to.Values.resize(from.Values.size());
      to.Bounds.resize(from.Bounds.size());
      std::copy_n(from.Count, 2, to.Count);
      for (std::size_t i = 0; i < from.Values.size(); ++i)
      {
        const double factor = (i % NumberOfIntegrals == 0 ? VolumeFactors[k] : Factors[k]) / (12.0 * t);
        if (factor != 0.0)
        {
          to.Values[i] += factor * from.Values[i];
          to.Bounds[i] += std::abs(factor) *
            (ProductGrowth * from.Bounds[i] + 8.0 * UnitRoundoff * std::abs(from.Values[i]));
        }
      }
    }
  }
  return true;
}

FaceHessianProduct HessianRun::MakeFace(
  std::size_t body, std::size_t face, const NetGradient& product, bool hasTiedBorder) const
{
  const BodyIntegrals& source = this->Mass.Bodies[body];
  const Face& surface = *source.Model->GetFaces()[face];
  const MomentFrame world(source.Placement.data(), source.Model->GetOrigin(), {});
  FaceHessianProduct result;
  result.Solid = this->Mass.Indices[body];
  result.Face = static_cast<int>(face);
  result.FileId = surface.FileId;
  result.HasTiedBorder = hasTiedBorder;
  std::copy_n(surface.Surface.NumberOfControlPoints, 2, result.Count);
  result.Values.assign(3 * NumberOfHessianQuantities * surface.Surface.ControlPoints.size(), 0.0);
  result.Bounds = result.Values;
  for (int i = 0; i < result.Count[0]; ++i)
  {
    for (int j = 0; j < result.Count[1]; ++j)
    {
      std::array<MomentVector, 3> derivatives;
      for (int c = 0; c < 3; ++c)
      {
        const std::size_t at = product.GetIndex(i, j, c);
        MomentVector moments;
        std::copy_n(product.Values.begin() + at, NumberOfMoments, moments.Values.begin());
        std::copy_n(product.Bounds.begin() + at, NumberOfMoments, moments.Bounds.begin());
        derivatives[c] = world.Map(moments);
      }
      derivatives = world.Rotate(derivatives);
      for (int c = 0; c < 3; ++c)
      {
        const std::size_t at = result.GetIndex(i, j, c, 0);
        std::copy(derivatives[c].Values.begin(), derivatives[c].Values.end(), result.Values.begin() + at);
        std::copy(derivatives[c].Bounds.begin(), derivatives[c].Bounds.end(), result.Bounds.begin() + at);
      }
    }
  }
  return result;
}

/// True if all trim curves of a face lie on the border of its net's domain.
bool IsWholeNet(const Face& face)
{
  for (const Loop& loop : face.Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      bool isOnBorder = false;
      for (int d = 0; d < 2; ++d)
      {
        const double start = face.Surface.GetDomainStart(d);
        const double end = face.Surface.GetDomainEnd(d);
        for (const double side : { start, end })
        {
          isOnBorder = isOnBorder ||
            std::all_of(coedge.Curve.Coefficients.begin(), coedge.Curve.Coefficients.end(),
              [=](const TrimCurve::Point& point)
              { return std::abs(point[d] - side) <= OnBorder * (end - start); });
        }
      }
      if (!isOnBorder)
      {
        return false;
      }
    }
  }
  return true;
}

/// For each face: whether it is its whole net, and all points of its border are tied to others.
std::vector<bool> FindTiedBorders(vtkTrimmedNURBSModel* model, const TiedVariables& tied)
{
  std::map<int, int> members;
  for (const std::vector<int>& face : tied.Points)
  {
    for (const int variable : face)
    {
      ++members[variable];
    }
  }
  std::vector<bool> result;
  for (std::size_t f = 0; f < tied.Points.size(); ++f)
  {
    const int* count = model->GetFaces()[f]->Surface.NumberOfControlPoints;
    bool isTied = IsWholeNet(*model->GetFaces()[f]);
    for (std::size_t i = 0; i < tied.Points[f].size(); ++i)
    {
      const int u = static_cast<int>(i) % count[0];
      const int v = static_cast<int>(i) / count[0];
      const bool isBorder = u == 0 || v == 0 || u + 1 == count[0] || v + 1 == count[1];
      isTied = isTied && (!isBorder || members[tied.Points[f][i]] > 1);
    }
    result.push_back(isTied);
  }
  return result;
}

bool HessianRun::AddBody(std::size_t body, std::string& error)
{
  vtkTrimmedNURBSModel* model = this->Mass.Bodies[body].Model;
  const TiedVariables tied = TiedVariables::Find(model);
  std::vector<Displacements> moves;
  std::vector<NetGradient> products;
  const BodyIntegrals& source = this->Mass.Bodies[body];
  const MassProperties& properties = this->Mass.Analysis.Rows[body].Properties;
  const bool hasVolume = source.HasVolume() && std::isfinite(properties.Center[0]) &&
    properties.VolumeBound < std::abs(properties.Volume);
  if (!this->FindMoves(body, tied, moves, error) || !this->Integrate(body, moves, products, error))
  {
    return false;
  }
  for (std::size_t f = 0; f < products.size(); ++f)
  {
    NetGradient& product = products[f];
    if (product.Values.empty())
    {
      std::copy_n(model->GetFaces()[f]->Surface.NumberOfControlPoints, 2, product.Count);
      product.Values.assign(4 * NumberOfIntegrals * model->GetFaces()[f]->Surface.ControlPoints.size(), 0.0);
      product.Bounds = product.Values;
    }
  }
  if (this->Options.Tied)
  {
    JoinTied(model, tied, products);
  }
  const std::vector<bool> hasTiedBorder = FindTiedBorders(model, tied);
  const auto others = std::count(hasTiedBorder.begin(), hasTiedBorder.end(), false);
  if (others > 0)
  {
    this->Result.Messages.push_back("solid " + source.Path + ": " + std::to_string(others) + " of " +
      std::to_string(hasTiedBorder.size()) +
      " faces are not their whole nets with tied borders: there the product is the derivative of the "
      "gradient "
      "with trim curves fixed, not the Hessian of the solid; move other faces for that");
  }
  for (std::size_t f = 0; f < products.size(); ++f)
  {
    this->Result.Faces.push_back(this->MakeFace(body, f, products[f], hasTiedBorder[f]));
    if (!hasVolume)
    {
      FaceHessianProduct& face = this->Result.Faces.back();
      std::fill(face.Values.begin(), face.Values.end(), std::numeric_limits<double>::quiet_NaN());
      face.Bounds = face.Values;
    }
  }
  if (!hasVolume)
  {
    this->Result.Messages.push_back(
      "solid " + source.Path + ": it has no volume that is known, so that all values are NaN");
  }
  return true;
}

MomentHessianResult HessianRun::Run(vtkDataObject* model)
{
  std::set<int> solids;
  for (const NetDirection& net : this->Direction)
  {
    solids.insert(net.Solid);
  }
  if (solids.empty())
  {
    return this->Stop(
      "nothing was computed: no face moves; name one, with displacements of its control points");
  }
  if (!this->Mass.Compute(model, { solids.begin(), solids.end() }, this->Options.RelativeTolerance,
        [this](double fraction)
        { return !this->Options.Progress || this->Options.Progress(HessianMassShare * fraction); }))
  {
    MomentHessianResult failure = this->Stop(this->Mass.Reason);
    failure.Status = this->Mass.Status;
    return failure;
  }
  this->Result.Status = this->Mass.Status;
  this->Result.Reason = this->Mass.Reason;
  this->Result.Messages = this->Mass.Messages;
  this->Result.LengthUnit = this->Mass.Analysis.Unit;
  for (std::size_t body = 0; body < this->Mass.Bodies.size(); ++body)
  {
    std::string error;
    if (!this->AddBody(body, error))
    {
      return this->Stop(error);
    }
  }
  return this->Result;
}
}

MomentHessianResult ComputeMomentHessianProduct(
  vtkDataObject* model, const std::vector<NetDirection>& direction, const MomentHessianOptions& options)
{
  MomentHessianResult failure;
  failure.Status = GetText(Status::NotComputed);
  try
  {
    if (!(options.RelativeTolerance > 0.0 && options.RelativeTolerance <= 1.0))
    {
      failure.Reason = "nothing was computed: RelativeTolerance is " +
        FormatDigits(options.RelativeTolerance, 6) + "; give a number above 0, at most 1";
      return failure;
    }
    return HessianRun(direction, options).Run(model);
  }
  catch (...)
  {
    failure.Reason = std::string("nothing was computed: ") + GetReason(std::current_exception());
    return failure;
  }
}
}
