#include "smClosingSpread.h"

#include "smBodyScales.h"
#include "smEdgeSpread.h"
#include "smFaceCache.h"
#include "smParallelFor.h"
#include "smUnitRoundoff.h"

#include "vtkTrimmedNURBSModel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <unordered_map>
#include <utility>

namespace sm
{
namespace
{
/// Largest stated tolerance that counts, relative to the diagonal of the body.
constexpr double MaxTolerance = 1e-3;
/// Volumes are measured coarsely up to this part of the cube of the diagonal.
constexpr double NegligibleVolume = 1e-15;
/// Corners are closed if their gaps are within so many u of the coordinates.
constexpr double CornerRoundings = 16.0;
/// Number of edges that a thread measures at a time.
constexpr std::size_t EdgeGrain = 16;

/// The caps of a face at one of its vertices: half the sum of cross products along their border, relative to
/// the vertex, and the largest distance of the border from it.
struct Corner
{
  Vector3 Vertex;
  Vector3 Area{};
  double Unsigned = 0.0;
  double Reach = 0.0;

  void AddSide(const Vector3& from, const Vector3& to)
  {
    const Vector3 a = Subtract(from, this->Vertex);
    const Vector3 b = Subtract(to, this->Vertex);
    const Vector3 twice = Cross(a, b);
    for (int d = 0; d < 3; ++d)
    {
      this->Area[d] += 0.5 * twice[d];
    }
    this->Unsigned += 0.5 * Norm(twice);
    this->Reach = std::max({ this->Reach, Norm(a), Norm(b) });
  }
};

Vector3 EvaluateTrim(const Face& face, const std::array<double, 2>& at)
{
  Vector3 point;
  face.Surface.Evaluate(at[0], at[1], point.data());
  return point;
}

/// Returns true if a curve can be evaluated.
template <int Dimension>
bool IsUsable(const PolynomialCurve<Dimension>& curve)
{
  const int pieces = curve.GetNumberOfPieces();
  if (pieces < 1 || static_cast<int>(curve.Breaks.size()) != pieces + 1 ||
    curve.Coefficients.size() < curve.Offsets.back())
  {
    return false;
  }
  for (int i = 0; i < pieces; ++i)
  {
    const double width = curve.Breaks[i + 1] - curve.Breaks[i];
    if (curve.GetDegree(i) < 0 || curve.GetDegree(i) > MaximumDegree ||
      !(width > 0.0 && std::isfinite(width)))
    {
      return false;
    }
  }
  return true;
}

bool IsUsable(const Coedge& coedge)
{
  return !coedge.Use->Degenerate && IsUsable(coedge.Use->Curve) && IsUsable(coedge.Curve);
}

/// Returns the corner between two coedges that follow each other in a loop of a face.
Corner MakeCorner(const Face& face, const Coedge& before, const Coedge& after)
{
  const Edge& from = *before.Use;
  const Edge& to = *after.Use;
  Corner corner;
  corner.Vertex = before.Reversed ? from.StartVertex : from.EndVertex;
  const std::array<double, 2>& leave =
    before.Reversed ? before.Curve.GetStartPoint() : before.Curve.GetEndPoint();
  const std::array<double, 2>& enter =
    after.Reversed ? after.Curve.GetEndPoint() : after.Curve.GetStartPoint();
  Vector3 last = before.Reversed ? from.Curve.GetStartPoint() : from.Curve.GetEndPoint();
  // The straight line in the parameters of the face has its middle here, too.
  for (const double way : { 0.0, 0.5, 1.0 })
  {
    const Vector3 next = EvaluateTrim(
      face, { (1.0 - way) * leave[0] + way * enter[0], (1.0 - way) * leave[1] + way * enter[1] });
    corner.AddSide(last, next);
    last = next;
  }
  corner.AddSide(last, after.Reversed ? to.Curve.GetEndPoint() : to.Curve.GetStartPoint());
  if (face.Reversed)
  {
    corner.Area = { -corner.Area[0], -corner.Area[1], -corner.Area[2] };
  }
  return corner;
}

using CornerList = std::vector<Corner>;

/// Returns the corners of a face that have a gap. Poles have none.
std::shared_ptr<const CornerList> MakeCorners(const Face& face)
{
  auto corners = std::make_shared<CornerList>();
  for (const Loop& loop : face.Loops)
  {
    for (std::size_t i = 0; i < loop.Coedges.size(); ++i)
    {
      const Coedge& before = loop.Coedges[i];
      const Coedge& after = loop.Coedges[(i + 1) % loop.Coedges.size()];
      if (IsUsable(before) && IsUsable(after))
      {
        const Corner corner = MakeCorner(face, before, after);
        if (corner.Reach > CornerRoundings * UnitRoundoff * Norm(corner.Vertex))
        {
          corners->push_back(corner);
        }
      }
    }
  }
  return corners;
}

/// What the spread of an edge depends on besides the edge.
struct UsesKey
{
  std::vector<std::uint64_t> Faces;
  std::vector<const Coedge*> Boundaries;
  double Tolerance = 0.0;

  bool operator==(const UsesKey& other) const
  {
    return this->Faces == other.Faces && this->Boundaries == other.Boundaries &&
      this->Tolerance == other.Tolerance;
  }
};

/// The uses of an edge by a model.
struct UsedEdge
{
  const Edge* Source = nullptr;
  std::vector<std::size_t> Faces;
  std::vector<EdgeUse> Uses;

  /// Returns true if the signed uses cancel, and all curves can be evaluated.
  bool IsClosed() const
  {
    double sum = 0.0;
    for (const EdgeUse& use : this->Uses)
    {
      sum += IsUsable(*use.Boundary) ? use.GetSign() : std::numeric_limits<double>::quiet_NaN();
    }
    return sum == 0.0;
  }
  UsesKey GetKey(double tolerance) const
  {
    UsesKey key;
    key.Tolerance = tolerance;
    for (const EdgeUse& use : this->Uses)
    {
      key.Faces.push_back(use.Source->Id);
      key.Boundaries.push_back(use.Boundary);
    }
    return key;
  }
};

/// Returns the edges in the order in which the faces use them.
std::vector<UsedEdge> CollectEdges(const vtkTrimmedNURBSModel& model)
{
  std::vector<UsedEdge> edges;
  std::unordered_map<const Edge*, std::size_t> places;
  for (std::size_t f = 0; f < model.GetFaces().size(); ++f)
  {
    const Face& face = *model.GetFaces()[f];
    // The integrals leave out what cannot be evaluated.
    if (!face.Surface.Check().empty())
    {
      continue;
    }
    for (const Loop& loop : face.Loops)
    {
      for (const Coedge& coedge : loop.Coedges)
      {
        if (coedge.Use->Degenerate)
        {
          continue;
        }
        const auto [entry, isNew] = places.emplace(coedge.Use.get(), edges.size());
        if (isNew)
        {
          edges.emplace_back();
          edges.back().Source = coedge.Use.get();
        }
        UsedEdge& edge = edges[entry->second];
        edge.Faces.push_back(f);
        edge.Uses.push_back({ &face, &coedge });
      }
    }
  }
  return edges;
}

std::size_t CountBytes(const EdgeSpread& spread)
{
  return sizeof(EdgeSpread) + spread.Samples.capacity() * sizeof(SpreadSample);
}
}

double EdgeSpread::GetVolume() const
{
  if (!this->IsKnown)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  double added = 0.0;
  double removed = 0.0;
  for (const SpreadSample& sample : this->Samples)
  {
    added += sample.Added;
    removed += sample.Removed;
  }
  // std::max is not used here because it may drop a NaN.
  return added > removed || std::isnan(added) ? added : removed;
}

class ClosingSpreads::Internals
{
public:
  /// Appends the closings of the corners: a vertex may move as far as a border there is from it.
  void AddVertices(const vtkTrimmedNURBSModel& model, ClosingSpread& spread)
  {
    struct Place
    {
      Corner Sum;
      std::vector<std::size_t> Faces;
    };
    std::map<Vector3, Place> places;
    for (std::size_t f = 0; f < model.GetFaces().size(); ++f)
    {
      const Face& face = *model.GetFaces()[f];
      if (!face.Surface.Check().empty())
      {
        continue;
      }
      const std::shared_ptr<const CornerList>* known = this->Corners.Find(face.Id, {});
      const std::shared_ptr<const CornerList> corners = known ? *known : MakeCorners(face);
      if (!known)
      {
        this->Corners.Store(face.Id, {}, corners, sizeof(CornerList) + corners->size() * sizeof(Corner));
      }
      for (const Corner& corner : *corners)
      {
        Place& place = places[corner.Vertex];
        place.Faces.push_back(f);
        place.Sum.Reach = std::max(place.Sum.Reach, corner.Reach);
        place.Sum.Unsigned += corner.Unsigned;
        for (int d = 0; d < 3; ++d)
        {
          place.Sum.Area[d] += corner.Area[d];
        }
      }
    }
    for (auto& [vertex, place] : places)
    {
      auto entry = std::make_shared<EdgeSpread>();
      SpreadSample sample;
      sample.Position = vertex;
      sample.Added = sample.Removed = place.Sum.Reach * Norm(place.Sum.Area) / 3.0;
      sample.Swept = place.Sum.Reach * place.Sum.Unsigned / 3.0;
      sample.Reach = place.Sum.Reach;
      entry->Samples.push_back(sample);
      spread.push_back({ nullptr, std::move(place.Faces), std::move(entry) });
    }
  }

  using EdgeCache = FaceCache<UsesKey, std::shared_ptr<const EdgeSpread>>;
  /// By the ids of edges.
  EdgeCache Edges;
  FaceCache<NoKey, std::shared_ptr<const CornerList>> Corners;
};

ClosingSpreads::ClosingSpreads()
  : Implementation(new Internals)
{
}

ClosingSpreads::~ClosingSpreads() = default;

std::shared_ptr<const ClosingSpread> ClosingSpreads::Measure(vtkTrimmedNURBSModel& model)
{
  Internals& self = *this->Implementation;
  const double diagonal = 2.0 * GetRadius(model);
  const double largest = MaxTolerance * diagonal;
  const double negligible = NegligibleVolume * diagonal * diagonal * diagonal;
  auto spread = std::make_shared<ClosingSpread>();
  const std::vector<UsedEdge> edges = CollectEdges(model);
  std::vector<std::size_t> unknown;
  std::vector<double> tolerances;
  for (const UsedEdge& edge : edges)
  {
    tolerances.push_back(std::min(std::max(edge.Source->Tolerance, model.GetFileUncertainty()), largest));
    spread->push_back({ edge.Source, edge.Faces, nullptr });
    if (!edge.IsClosed())
    {
      auto entry = std::make_shared<EdgeSpread>();
      entry->IsKnown = false;
      spread->back().Spread = entry;
    }
    else if (const auto* known = self.Edges.Find(edge.Source->Id, edge.GetKey(tolerances.back())))
    {
      spread->back().Spread = *known;
    }
    else
    {
      unknown.push_back(spread->size() - 1);
    }
  }
  ParallelFor(unknown.size(), EdgeGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const std::size_t k = unknown[i];
        (*spread)[k].Spread = MeasureEdge(*edges[k].Source, edges[k].Uses, tolerances[k], negligible);
      }
    });
  for (const std::size_t k : unknown)
  {
    const std::shared_ptr<const EdgeSpread>& entry = (*spread)[k].Spread;
    self.Edges.Store(edges[k].Source->Id, edges[k].GetKey(tolerances[k]), entry, CountBytes(*entry));
  }
  self.AddVertices(model, *spread);
  return spread;
}

void ClosingSpreads::EndRun()
{
  this->Implementation->Edges.EndRun();
  this->Implementation->Corners.EndRun();
}

void ClosingSpreads::Clear()
{
  this->Implementation->Edges.Clear();
  this->Implementation->Corners.Clear();
}

SpreadSums SumSpread(
  const ClosingSpread& spread, const std::vector<signed char>& sides, const Vector3& center)
{
  // Pairs of coordinates of the second moments.
  constexpr int pairs[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 1, 2 }, { 0, 2 } };
  SpreadSums sums;
  double volumes[2] = { 0.0, 0.0 };
  for (const ClosingSpreadEntry& entry : spread)
  {
    const auto getSide = [&sides](std::size_t face) { return sides.empty() ? 1 : sides[face]; };
    const int side = getSide(entry.Faces.front());
    const bool isMixed = std::any_of(
      entry.Faces.begin(), entry.Faces.end(), [&](std::size_t face) { return getSide(face) != side; });
    if (!entry.Spread->IsKnown)
    {
      volumes[0] = volumes[1] = std::numeric_limits<double>::quiet_NaN();
    }
    for (const SpreadSample& sample : entry.Spread->Samples)
    {
      const double signedVolumes[2] = { isMixed ? sample.Swept : sample.Added,
        isMixed ? sample.Swept : sample.Removed };
      volumes[0] += signedVolumes[side > 0 ? 0 : 1];
      volumes[1] += signedVolumes[side > 0 ? 1 : 0];
      const double volume = std::max(signedVolumes[0], signedVolumes[1]);
      const double near = sample.Reach * sample.Swept;
      Vector3 distance;
      for (int d = 0; d < 3; ++d)
      {
        distance[d] = std::abs(sample.Position[d] - center[d]);
        sums.First[d] += distance[d] * volume + near;
      }
      for (int k = 0; k < 6; ++k)
      {
        const double a = distance[pairs[k][0]];
        const double b = distance[pairs[k][1]];
        sums.Second[k] += a * b * volume + (a + b + sample.Reach) * near;
      }
    }
    sums.Area += entry.Spread->Area;
  }
  sums.Volume = volumes[0] > volumes[1] || std::isnan(volumes[0]) ? volumes[0] : volumes[1];
  if (std::isnan(sums.Volume))
  {
    sums.Area = sums.Volume;
    std::fill_n(sums.First, 3, sums.Volume);
    std::fill_n(sums.Second, 6, sums.Volume);
  }
  return sums;
}
}
