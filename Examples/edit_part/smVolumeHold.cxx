#include "smVolumeHold.h"

#include <smMomentGradient.h>
#include <vtkMath.h>
#include <vtkNURBSDataSet.h>
#include <vtkTimerLog.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace sm
{
namespace
{
const int Directions = 4;
const int MaxSteps = 30;
// Faces that follow: each costs an update some 0.4 ms.
const std::size_t MaxFaces = 12;
// Trimmed ones cost more, up to 10 ms.
const std::size_t MaxTrimmedFaces = 1;
// Newton's method ends below this deviation, relative to the volume: rounding of the polynomial.
const double SolveTolerance = 1e-13;
// A gap that a direction opens, relative to its amount: rounding.
const double NoGap = 1e-9;
// The moves for which the polynomials are made, over half the diagonal; their bounds hold for any move.
const double ShareOfReach = 0.1;

// Distances in parameters that count as none, relative to the range.
const double NoWidth = 1e-11;

using TiedGroups = std::vector<std::vector<int>>;

std::array<double, 3> GetMean(const NURBSSurface& surface)
{
  std::array<double, 3> mean{};
  for (const std::array<double, 4>& point : surface.ControlPoints)
  {
    for (int c = 0; c < 3; ++c)
    {
      mean[c] += point[c] / point[3] / static_cast<double>(surface.ControlPoints.size());
    }
  }
  return mean;
}

/// The numbers of faces that have a point of each group.
std::map<int, std::set<int>> FindFacesOfGroups(const TiedGroups& groups)
{
  std::map<int, std::set<int>> faces;
  for (std::size_t f = 0; f < groups.size(); ++f)
  {
    for (const int group : groups[f])
    {
      faces[group].insert(static_cast<int>(f));
    }
  }
  return faces;
}

/// True when other faces share all points of the net's border, so that it is the border of the face.
bool HasSharedBorder(
  const NURBSSurface& surface, const std::vector<int>& groups, const std::map<int, std::set<int>>& facesOf)
{
  const int* count = surface.NumberOfControlPoints;
  for (std::size_t i = 0; i < groups.size(); ++i)
  {
    const int u = static_cast<int>(i) % count[0];
    const int v = static_cast<int>(i) / count[0];
    const bool isBorder = u == 0 || v == 0 || u + 1 == count[0] || v + 1 == count[1];
    if (isBorder && facesOf.at(groups[i]).size() < 2)
    {
      return false;
    }
  }
  return true;
}

/// True where the basis function `index` of a direction is 0 on an interval.
bool IsZero(const NURBSSurface& surface, int direction, int index, double low, double high)
{
  const std::vector<double>& knots = surface.Knots[direction];
  const int p = surface.Degree[direction];
  const double room = NoWidth * (knots.back() - knots.front());
  // At an end where p + 1 knots are equal the function is 1.
  const bool isBelow = high <= knots[index] + (knots[index] < knots[index + p] ? room : -room);
  const bool isAbove = low >= knots[index + p + 1] - (knots[index + 1] < knots[index + p + 1] ? room : -room);
  return isBelow || isAbove;
}

/// The edges of a face, by the order of their coedges, that a control point moves.
std::set<int> FindMovedEdges(const Face& face, int u, int v)
{
  std::set<int> moved;
  int edge = 0;
  for (const Loop& loop : face.Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      const TrimCurve& curve = coedge.Curve;
      for (int piece = 0; piece < curve.GetNumberOfPieces() && moved.count(edge) == 0; ++piece)
      {
        double low[2];
        double high[2];
        for (int d = 0; d < 2; ++d)
        {
          const auto [from, to] = std::minmax_element(curve.Coefficients.begin() + curve.Offsets[piece],
            curve.Coefficients.begin() + curve.Offsets[piece + 1],
            [d](const auto& a, const auto& b) { return a[d] < b[d]; });
          low[d] = (*from)[d];
          high[d] = (*to)[d];
        }
        if (!IsZero(face.Surface, 0, u, low[0], high[0]) && !IsZero(face.Surface, 1, v, low[1], high[1]))
        {
          moved.insert(edge);
        }
      }
      ++edge;
    }
  }
  return moved;
}

/// The faces that are farthest from a control point, of those that a condition holds for.
template <class Holds>
std::set<int> FindFarFaces(
  vtkTrimmedNURBSModel* model, const Grip& grip, std::size_t maxFaces, const Holds& holds)
{
  std::array<double, 4> dragged{ 0.0, 0.0, 0.0, 1.0 };
  GetControlPoint(model, grip.Face, grip.Index, dragged);
  vtkMath::MultiplyScalar(dragged.data(), 1.0 / dragged[3]);
  std::vector<std::pair<double, int>> faces;
  for (int f = 0; f < model->GetNumberOfFaces(); ++f)
  {
    const NURBSSurface& surface = model->GetFaces()[f]->Surface;
    if (f != grip.Face && holds(f))
    {
      faces.push_back(
        { -std::sqrt(vtkMath::Distance2BetweenPoints(GetMean(surface).data(), dragged.data())), f });
    }
  }
  std::sort(faces.begin(), faces.end());
  std::set<int> far;
  for (std::size_t i = 0; i < std::min(faces.size(), maxFaces); ++i)
  {
    far.insert(faces[i].second);
  }
  return far;
}

/// For each face, control points and their displacements in world coordinates.
using PointMoves = std::map<int, std::vector<std::pair<ControlPointIndex, std::array<double, 3>>>>;

/// Faces whose control points follow, and which of them: those of a group, if all faces that share it permit
/// them.
struct Followers
{
  std::set<int> Faces;
  /// For each of these faces, by the order of its ControlPoints.
  std::map<int, std::vector<bool>> Points;
  /// True if they open edges, those that the drag opens, too.
  bool MayOpen = false;

  void Add(int face, std::vector<bool> points)
  {
    this->Faces.insert(face);
    this->Points[face] = std::move(points);
  }
};

/// Finds control points that may follow, in the order of preference.
class FollowerSearch
{
public:
  FollowerSearch(vtkTrimmedNURBSModel* model, const Grip& grip)
    : Groups(FindTiedPoints(model))
    , FacesOf(FindFacesOfGroups(this->Groups))
    , Model(model)
    , Dragged(grip)
  {
  }

  /// All points of the farthest faces that are their whole nets.
  Followers FindWholeNets() const
  {
    Followers found;
    for (const int f : FindFarFaces(this->Model, this->Dragged, MaxFaces,
           [this](int face)
           { return HasSharedBorder(this->GetFace(face).Surface, this->Groups[face], this->FacesOf); }))
    {
      found.Add(f, std::vector<bool>(this->Groups[f].size(), true));
    }
    return found;
  }

  /// Points of the dragged face that move no other edges than the dragged one does.
  Followers FindInSameFace() const
  {
    const Face& face = this->GetFace(this->Dragged.Face);
    const std::set<int> allowed = FindMovedEdges(face, this->Dragged.Index.U, this->Dragged.Index.V);
    Followers found;
    found.MayOpen = true;
    found.Add(this->Dragged.Face, this->Select(this->Dragged.Face, allowed));
    return found;
  }

  /// Points of other faces that move no edge.
  Followers FindInsides() const
  {
    Followers found;
    for (const int f : FindFarFaces(this->Model, this->Dragged, MaxTrimmedFaces,
           [this](int face)
           {
             const std::vector<bool> points = this->Select(face, {});
             return std::find(points.begin(), points.end(), true) != points.end();
           }))
    {
      found.Add(f, this->Select(f, {}));
    }
    return found;
  }

  const TiedGroups Groups;
  const std::map<int, std::set<int>> FacesOf;

private:
  const Face& GetFace(int face) const { return *this->Model->GetFaces()[face]; }

  /// The points of a face with loops that move no edges but some of the `allowed` ones, and are not dragged.
  std::vector<bool> Select(int index, const std::set<int>& allowed) const
  {
    const Face& face = this->GetFace(index);
    const int* count = face.Surface.NumberOfControlPoints;
    const auto& own = this->Groups[this->Dragged.Face];
    const int dragged = own[this->Dragged.Index.U +
      static_cast<std::size_t>(this->GetFace(this->Dragged.Face).Surface.NumberOfControlPoints[0]) *
        this->Dragged.Index.V];
    std::vector<bool> selected(this->Groups[index].size(), false);
    for (std::size_t i = 0; i < selected.size() && !face.Loops.empty(); ++i)
    {
      const std::set<int> moved =
        FindMovedEdges(face, static_cast<int>(i) % count[0], static_cast<int>(i) / count[0]);
      selected[i] = this->Groups[index][i] != dragged &&
        std::includes(allowed.begin(), allowed.end(), moved.begin(), moved.end());
    }
    return selected;
  }

  vtkTrimmedNURBSModel* Model;
  const Grip& Dragged;
};

/// Returns the derivatives of the volume by the points that follow, a group once, and the length of the
/// largest one.
PointMoves FindPointMoves(const MomentGradientResult& gradient, const Followers& followers,
  const FollowerSearch& search, double& largest)
{
  std::set<int> refused;
  for (std::size_t f = 0; f < search.Groups.size(); ++f)
  {
    const auto found = followers.Points.find(static_cast<int>(f));
    for (std::size_t i = 0; i < search.Groups[f].size(); ++i)
    {
      if (found == followers.Points.end() || !found->second[i])
      {
        refused.insert(search.Groups[f][i]);
      }
    }
  }
  PointMoves moves;
  std::set<int> seen;
  for (const FaceMomentGradient& face : gradient.Faces)
  {
    const double* values = face.Values.data();
    for (int v = 0; v < face.Count[1]; ++v)
    {
      for (int u = 0; u < face.Count[0]; ++u)
      {
        const int group = search.Groups[face.Face][static_cast<std::size_t>(u) + face.Count[0] * v];
        if (refused.count(group) == 0 && seen.insert(group).second)
        {
          const std::array<double, 3> along{ values[face.GetIndex(u, v, 0, 0)],
            values[face.GetIndex(u, v, 1, 0)], values[face.GetIndex(u, v, 2, 0)] };
          largest = std::max(largest, vtkMath::Norm(along.data()));
          moves[face.Face].push_back({ { u, v }, along });
        }
      }
    }
  }
  return moves;
}

/// Moves points by `factor` times their displacements, with those that are tied to them.
ModelEdit MovePoints(vtkNURBSDataSet* body, const PointMoves& moves, double factor)
{
  ModelEdit edit;
  edit.Model = body->GetModel();
  for (const auto& [face, points] : moves)
  {
    std::vector<std::pair<ControlPointIndex, std::array<double, 4>>> moved;
    for (const auto& [index, along] : points)
    {
      std::array<double, 4> point{};
      GetControlPoint(edit.Model, face, index, point);
      const std::array<double, 3> by = ToModelVector(body, along);
      for (int c = 0; c < 3; ++c)
      {
        point[c] += point[3] * by[c] * factor;
      }
      moved.push_back({ index, point });
    }
    edit = SetControlPoints(edit.Model, face, moved, EditRule::MoveSharedBoundary);
    if (edit.Status != EditStatus::Ok)
    {
      break;
    }
  }
  return edit;
}
}

void VolumeHold::SetOn(bool on)
{
  this->On = on;
  this->MaxDeviation = 0.0;
  this->Forget();
}

void VolumeHold::Forget()
{
  this->Volume.reset();
  this->Deviation = 0.0;
}

/// Returns the model with the points that follow moved along the gradient, the farthest by `amount`; null
/// with the reason in Message.
vtkSmartPointer<vtkTrimmedNURBSModel> VolumeHold::MoveAlongGradient(
  vtkNURBSDataSet* body, const Grip& grip, double amount)
{
  const FollowerSearch search(body->GetModel(), grip);
  PointMoves moves;
  double largest = 0.0;
  for (int choice = 0; choice < 3 && !(largest > 0.0); ++choice)
  {
    const Followers followers = choice == 0 ? search.FindWholeNets()
      : choice == 1                         ? search.FindInSameFace()
                                            : search.FindInsides();
    if (followers.Faces.empty())
    {
      continue;
    }
    MomentGradientOptions options;
    options.Faces.assign(followers.Faces.begin(), followers.Faces.end());
    const MomentGradientResult gradient = ComputeMomentGradient(body, options);
    if (gradient.Status != "ok")
    {
      this->Message = "the volume cannot be held: the part is " + gradient.Status + "; " + gradient.Reason;
      return nullptr;
    }
    moves = FindPointMoves(gradient, followers, search, largest);
    this->MayOpen = followers.MayOpen;
  }
  if (!(largest > 0.0))
  {
    this->Message = "the volume cannot be held: there are no other control points that may move "
                    "without opening an edge; press v to drag without";
    return nullptr;
  }
  const ModelEdit edit = MovePoints(body, moves, amount / largest);
  this->Message = edit.Message;
  return edit.Model;
}

bool VolumeHold::MakePolynomial(vtkNURBSDataSet* body, const Grip& grip, EditRule rule)
{
  this->Reach = 0.5 * body->GetLength();
  const double amount = ShareOfReach * this->Reach;
  std::vector<MovedModel> moved;
  for (int k = 0; k < 3; ++k)
  {
    std::array<double, 3> displacement{};
    displacement[k] = amount;
    const ModelEdit edit =
      MoveControlPoints(body->GetModel(), grip.Face, { grip.Index }, ToModelVector(body, displacement), rule);
    this->Message = edit.Message;
    if (edit.Status != EditStatus::Ok)
    {
      return false;
    }
    moved.push_back({ edit.Model, amount });
  }
  moved.push_back({ this->MoveAlongGradient(body, grip, amount), amount });
  if (!moved.back().Model)
  {
    return false;
  }
  VariantOptions options;
  options.Ranges.assign(Directions, amount);
  std::string error;
  this->Shape = VariantShape::Make(body->GetModel(), moved, error);
  this->Polynomial = this->Shape ? VariantPolynomial::Make(this->Shape, options, error) : nullptr;
  if (!this->Polynomial)
  {
    this->Message = "the volume cannot be held: " + error;
    return false;
  }
  if (!this->MayOpen && this->Polynomial->GetGaps()[3].Distance > NoGap)
  {
    this->Message = "the volume cannot be held: the other faces would open an edge; press v to drag without";
    return false;
  }
  return true;
}

bool VolumeHold::Begin(const EditedPart& part, const Grip& grip, EditRule rule, double volume)
{
  const double start = vtkTimerLog::GetUniversalTime();
  this->Message.clear();
  const bool made = this->MakePolynomial(part.GetBody(grip.Body), grip, rule);
  if (made)
  {
    this->Volume = this->Volume.value_or(volume);
    const double zero[Directions] = {};
    double values[VariantPolynomial::NumberOfValues];
    this->Polynomial->Evaluate(zero, 1, values);
    // A body that is inside out has a negative volume there.
    this->Wanted = values[0] + (*this->Volume - volume) * (values[0] < 0.0 ? -1.0 : 1.0);
  }
  this->BeginSeconds = vtkTimerLog::GetUniversalTime() - start;
  return made;
}

vtkSmartPointer<vtkTrimmedNURBSModel> VolumeHold::Solve(const std::array<double, 3>& displacement)
{
  const double start = vtkTimerLog::GetUniversalTime();
  double c[Directions] = { displacement[0], displacement[1], displacement[2], 0.0 };
  double values[VariantPolynomial::NumberOfValues];
  double bounds[VariantPolynomial::NumberOfValues];
  double gradients[VariantPolynomial::NumberOfValues * Directions];
  bool found = false;
  // From t = 0 each time, so that the path of the mouse makes no difference.
  for (int step = 0; step < MaxSteps && std::abs(c[3]) <= this->Reach; ++step)
  {
    this->Polynomial->Evaluate(c, 1, values, bounds, gradients);
    const double deviation = values[0] - this->Wanted;
    if (std::abs(deviation) <= SolveTolerance * std::abs(this->Wanted))
    {
      found = bounds[0] <= 0.1 * Tolerance * std::abs(this->Wanted);
      break;
    }
    c[3] -= deviation / gradients[3];
  }
  const vtkSmartPointer<vtkTrimmedNURBSModel> model = found ? this->Shape->MakeModel(c) : nullptr;
  this->Message = found ? "" : "the volume cannot be held so far away; the last position stays";
  this->SolveSeconds = vtkTimerLog::GetUniversalTime() - start;
  return model;
}

void VolumeHold::Record(double volume)
{
  if (this->On && this->Volume)
  {
    this->Deviation = std::abs(volume - *this->Volume) / std::abs(*this->Volume);
    this->MaxDeviation = std::max(this->MaxDeviation, this->Deviation);
  }
}
}
