#include "Detail/smNetChange.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace sm
{
namespace
{
// Rows whose points are closer than this, relative to the size of the body, coincide.
constexpr double RowTolerance = 1e-9;
// Step of difference quotients, relative to the size of the body.
constexpr double SlopeStep = 1e-4;

/// Returns a point, displaced as a control point was from `from` to `to`.
std::array<double, 3> Move(
  const std::array<double, 3>& point, const std::array<double, 4>& from, const std::array<double, 4>& to)
{
  std::array<double, 3> result = point;
  for (int c = 0; c < 3 && from != to; ++c)
  {
    result[c] += to[c] / to[3] - from[c] / from[3];
  }
  return result;
}

const std::array<double, 3>& GetVertex(const Edge& edge, std::size_t end)
{
  return end % 2 == 0 ? edge.StartVertex : edge.EndVertex;
}
}

double GetBodySize(vtkTrimmedNURBSModel* model)
{
  const double* bounds = model->GetLocalBounds();
  const double size = std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  if (size > 0.0)
  {
    return size;
  }
  double farthest = 0.0;
  for (const FacePointer& face : model->GetFaces())
  {
    for (const std::array<double, 4>& point : face->Surface.ControlPoints)
    {
      const double distance = std::hypot(point[0], point[1], point[2]) / point[3];
      farthest = std::isfinite(distance) ? std::max(farthest, distance) : farthest;
    }
  }
  return 2.0 * farthest;
}

NetChange::NetChange(vtkTrimmedNURBSModel* model, EditRule rule)
  : Model(model)
  , Rule(rule)
  , Faces(model->GetFaces())
  , Chosen(model->GetFaces().size(), false)
  , Tolerance(RowTolerance * GetBodySize(model))
  , Step(SlopeStep * GetBodySize(model))
{
}

void NetChange::SetTemplate(int face, const FacePointer& face_)
{
  // The control net remains the old one, because its rows are compared with those of the neighbours.
  auto copy = std::make_shared<Face>(*face_);
  copy->Surface.ControlPoints = this->Faces[face]->Surface.ControlPoints;
  this->Faces[face] = copy;
}

void NetChange::RaiseErrors(int face, const MapSlopes& slopes)
{
  const NURBSSurface& old = this->GetFace(face).Surface;
  std::array<double, 3> rounding = slopes.Apply(old.Rounding);
  for (int c = 0; c < 3; ++c)
  {
    rounding[c] = std::max(rounding[c], old.Rounding[c]);
  }
  const double residual = old.Residual * std::max(1.0, slopes.Lengthening);
  if (rounding != old.Rounding || residual != old.Residual)
  {
    auto copy = std::make_shared<Face>(this->GetFace(face));
    copy->Surface.Rounding = rounding;
    copy->Surface.Residual = residual;
    this->Faces[face] = copy;
  }
}

void NetChange::FollowErrors(int from, int to)
{
  const auto before = [this](int face) -> const std::array<double, 3>&
  { return this->Model->GetFaces()[face]->Surface.Rounding; };
  const std::array<double, 3>& raised = this->GetFace(from).Surface.Rounding;
  if (raised == before(from))
  {
    return;
  }
  auto copy = std::make_shared<Face>(*this->Faces[to]);
  for (int c = 0; c < 3; ++c)
  {
    copy->Surface.Rounding[c] =
      std::max(copy->Surface.Rounding[c], before(to)[c] + before(from)[c] + raised[c]);
  }
  this->Faces[to] = copy;
}

void NetChange::SetMap(const std::vector<bool>& faces, const PointMap& map)
{
  this->Chosen = faces;
  this->Map = map;
}

const std::vector<NetChange::Homogeneous>& NetChange::GetNet(int face) const
{
  const auto found = this->Nets.find(face);
  return found == this->Nets.end() ? this->GetFace(face).Surface.ControlPoints : found->second;
}

void NetChange::SetPoint(int face, std::size_t entry, const Homogeneous& point)
{
  const std::vector<Homogeneous>& old = this->GetFace(face).Surface.ControlPoints;
  this->Nets.try_emplace(face, old).first->second[entry] = point;
  if (this->Moved.insert({ face, entry }).second)
  {
    this->Queue.emplace_back(face, entry);
  }
}

void NetChange::CollectEdges()
{
  std::unordered_map<const Edge*, std::size_t> known;
  this->EdgesOfFace.resize(this->Faces.size());
  for (std::size_t f = 0; f < this->Faces.size(); ++f)
  {
    const Face& face = *this->Faces[f];
    for (std::size_t l = 0; l < face.Loops.size(); ++l)
    {
      for (std::size_t c = 0; c < face.Loops[l].Coedges.size(); ++c)
      {
        const Coedge& coedge = face.Loops[l].Coedges[c];
        const auto [place, isNew] = known.emplace(coedge.Use.get(), this->Edges.size());
        if (isNew)
        {
          this->Edges.push_back({ coedge.Use, {}, false, false, false });
        }
        this->EdgesOfFace[f].emplace_back(place->second, this->Edges[place->second].Uses.size());
        this->Edges[place->second].Uses.push_back(
          { static_cast<int>(f), static_cast<int>(l), static_cast<int>(c), false, {} });
      }
    }
  }
  for (EdgeUses& edge : this->Edges)
  {
    edge.Mapped = this->Map != nullptr &&
      std::all_of(
        edge.Uses.begin(), edge.Uses.end(), [this](const Use& use) { return this->Chosen[use.Face]; });
  }
}

bool NetChange::FindRows(EdgeUses& edge)
{
  if (edge.HasRows)
  {
    return edge.Coincident;
  }
  edge.HasRows = true;
  edge.Coincident = !edge.Source->Degenerate && edge.Source->Curve.GetNumberOfPieces() > 0;
  RowCurve row;
  for (Use& use : edge.Uses)
  {
    const NURBSSurface& surface = this->GetFace(use.Face).Surface;
    use.IsRow =
      edge.Coincident && surface.Check().empty() && FindBoundaryRow(surface, this->GetTrim(use), use.Row);
    edge.Coincident = use.IsRow;
    if (!edge.Coincident)
    {
      return false;
    }
    if (&use == &edge.Uses.front())
    {
      row = RowCurve(surface, use.Row);
    }
    else
    {
      edge.Coincident = Coincide(row, RowCurve(surface, use.Row), this->Tolerance);
    }
  }
  return edge.Coincident;
}

bool NetChange::IsTouched(const EdgeUses& edge) const
{
  return std::any_of(
    edge.Uses.begin(), edge.Uses.end(), [this](const Use& use) { return this->Nets.count(use.Face) > 0; });
}

std::size_t NetChange::FindVertex(std::size_t end) const
{
  while (this->SameVertex[end] != end)
  {
    end = this->SameVertex[end];
  }
  return end;
}

void NetChange::JoinEnds()
{
  this->SameVertex.resize(2 * this->Edges.size());
  std::iota(this->SameVertex.begin(), this->SameVertex.end(), std::size_t{ 0 });
  for (std::size_t f = 0; f < this->Faces.size(); ++f)
  {
    // The edges of a face are in the order of its coedges.
    std::size_t first = 0;
    for (const Loop& loop : this->Faces[f]->Loops)
    {
      const std::size_t count = loop.Coedges.size();
      for (std::size_t c = 0; c < count; ++c)
      {
        const std::size_t next = (c + 1) % count;
        const std::size_t a = 2 * this->EdgesOfFace[f][first + c].first + (loop.Coedges[c].Reversed ? 0 : 1);
        const std::size_t b =
          2 * this->EdgesOfFace[f][first + next].first + (loop.Coedges[next].Reversed ? 1 : 0);
        if (GetVertex(*loop.Coedges[c].Use, a) == GetVertex(*loop.Coedges[next].Use, b))
        {
          const std::size_t vertices[2] = { this->FindVertex(a), this->FindVertex(b) };
          this->SameVertex[std::max(vertices[0], vertices[1])] = std::min(vertices[0], vertices[1]);
        }
      }
      first += count;
    }
  }
}

void NetChange::Follow(const EdgeUses& edge, const Use& use, std::size_t entry)
{
  const NURBSSurface& surface = this->GetFace(use.Face).Surface;
  const Homogeneous from = surface.ControlPoints[entry];
  const Homogeneous to = this->GetNet(use.Face)[entry];
  for (int k = 0; k < use.Row.GetSize(surface); ++k)
  {
    if (use.Row.GetEntry(surface, k) != entry)
    {
      continue;
    }
    for (const Use& other : edge.Uses)
    {
      const NURBSSurface& neighbour = this->GetFace(other.Face).Surface;
      const std::size_t there = other.Row.GetEntry(neighbour, k);
      if (this->Moved.count({ other.Face, there }) > 0)
      {
        continue;
      }
      const Homogeneous& old = neighbour.ControlPoints[there];
      Homogeneous point = to;
      if (old != from)
      {
        const double weight = to[3] * (old[3] / from[3]);
        for (int c = 0; c < 3; ++c)
        {
          point[c] = (old[c] / old[3] + (to[c] / to[3] - from[c] / from[3])) * weight;
        }
        point[3] = weight;
      }
      this->SetPoint(other.Face, there, point);
      this->FollowErrors(use.Face, other.Face);
    }
  }
}

void NetChange::Propagate()
{
  while (this->Rule == EditRule::MoveSharedBoundary && !this->Queue.empty())
  {
    const auto [face, entry] = this->Queue.front();
    this->Queue.pop_front();
    for (const auto& [edge, use] : this->EdgesOfFace[face])
    {
      if (this->FindRows(this->Edges[edge]))
      {
        this->Follow(this->Edges[edge], this->Edges[edge].Uses[use], entry);
      }
    }
  }
}

std::vector<std::vector<int>> NetChange::FindGroups()
{
  // Union-find over all control points, face after face.
  std::vector<std::size_t> first(1, 0);
  for (const FacePointer& face : this->Faces)
  {
    first.push_back(first.back() + face->Surface.ControlPoints.size());
  }
  std::vector<std::size_t> other(first.back());
  std::iota(other.begin(), other.end(), std::size_t{ 0 });
  const auto find = [&other](std::size_t at)
  {
    while (other[at] != at)
    {
      at = other[at] = other[other[at]];
    }
    return at;
  };
  this->CollectEdges();
  for (EdgeUses& edge : this->Edges)
  {
    if (!this->FindRows(edge))
    {
      continue;
    }
    const Use& leader = edge.Uses.front();
    const NURBSSurface& surface = this->GetFace(leader.Face).Surface;
    for (int k = 0; k < leader.Row.GetSize(surface); ++k)
    {
      for (const Use& use : edge.Uses)
      {
        const std::size_t a = find(first[leader.Face] + leader.Row.GetEntry(surface, k));
        const std::size_t b = find(first[use.Face] + use.Row.GetEntry(this->GetFace(use.Face).Surface, k));
        other[std::max(a, b)] = std::min(a, b);
      }
    }
  }
  std::vector<std::vector<int>> groups(this->Faces.size());
  for (std::size_t f = 0; f < groups.size(); ++f)
  {
    for (std::size_t at = first[f]; at < first[f + 1]; ++at)
    {
      groups[f].push_back(static_cast<int>(find(at)));
    }
  }
  return groups;
}

std::shared_ptr<const EdgeOrigin> NetChange::GetOrigin(const EdgeUses& edge, const RowCurve& row)
{
  const std::shared_ptr<const EdgeOrigin>& older = edge.Source->Origin;
  return older && older->Now == row ? older
                                    : std::make_shared<const EdgeOrigin>(EdgeOrigin{ edge.Source, row, row });
}

std::shared_ptr<Edge> NetChange::GetNewEdge(const std::shared_ptr<const Edge>& edge)
{
  const auto found = this->NewEdges.find(edge.get());
  auto copy = std::make_shared<Edge>(found == this->NewEdges.end() ? *edge : *found->second);
  copy->Id = NewId();
  this->NewEdges[edge.get()] = copy;
  return copy;
}

void NetChange::MoveVertex(std::size_t end, const Point3& to)
{
  if (GetVertex(*this->Edges[end / 2].Source, end) != to)
  {
    if (this->SameVertex.empty())
    {
      this->JoinEnds();
    }
    this->Vertices.emplace(this->FindVertex(end), to);
  }
}

void NetChange::CarryEdge(std::size_t index)
{
  const EdgeUses& edge = this->Edges[index];
  const Use& first = edge.Uses.front();
  NURBSSurface surface = this->GetFace(first.Face).Surface;
  const RowCurve before(surface, first.Row);
  surface.ControlPoints = this->GetNet(first.Face);
  const RowCurve now(surface, first.Row);
  if (now == before)
  {
    return;
  }
  const std::shared_ptr<const EdgeOrigin> origin = GetOrigin(edge, before);
  for (std::size_t end = 2 * index; end < 2 * index + 2; ++end)
  {
    const auto get = [end](const RowCurve& row)
    { return end % 2 == 0 ? row.Points.front() : row.Points.back(); };
    if (get(now) != get(before))
    {
      // The vertex is displaced from its position before the first edit, so that an undo restores its bits;
      // if other edges moved it since, from its present position.
      const Point3& vertex = GetVertex(*edge.Source, end);
      const Point3& source = GetVertex(*origin->Source, end);
      const bool followed = Move(source, get(origin->Row), get(before)) == vertex;
      this->MoveVertex(
        end, followed ? Move(source, get(origin->Row), get(now)) : Move(vertex, get(before), get(now)));
    }
  }
  if (now == origin->Row)
  {
    this->NewEdges[edge.Source.get()] = origin->Source;
    return;
  }
  const std::shared_ptr<Edge> result = this->GetNewEdge(edge.Source);
  result->Curve = Displace(*origin, now, surface, first.Row, this->GetTrim(first));
  result->Origin = std::make_shared<const EdgeOrigin>(EdgeOrigin{ origin->Source, origin->Row, now });
}

void NetChange::MapEdge(std::size_t index)
{
  EdgeUses& edge = this->Edges[index];
  EdgeCurve curve = edge.Source->Curve;
  for (EdgeCurve::Point& point : curve.Coefficients)
  {
    point = this->Map(point);
  }
  const Point3 ends[2] = { this->Map(edge.Source->StartVertex), this->Map(edge.Source->EndVertex) };
  const bool moves = curve.Coefficients != edge.Source->Curve.Coefficients;
  // An edge with coincident rows whose control points do not move is not changed, even if the map moves
  // points between them.
  if ((!moves && ends[0] == edge.Source->StartVertex && ends[1] == edge.Source->EndVertex) ||
    this->FindRows(edge))
  {
    return;
  }
  this->MoveVertex(2 * index, ends[0]);
  this->MoveVertex(2 * index + 1, ends[1]);
  const auto isFinite = [](const Point3& point)
  { return std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); }); };
  this->Finite = this->Finite && isFinite(ends[0]) && isFinite(ends[1]) &&
    std::all_of(curve.Coefficients.begin(), curve.Coefficients.end(), isFinite);
  if (moves)
  {
    const std::shared_ptr<Edge> result = this->GetNewEdge(edge.Source);
    MapSlopes slopes;
    for (const EdgeCurve::Point& point : edge.Source->Curve.Coefficients)
    {
      slopes.Add(this->Map, point, this->Step);
    }
    curve.Residual = slopes.Apply(curve.Residual);
    result->Curve = curve;
    result->Origin = nullptr;
  }
}

void NetChange::MoveVertices()
{
  for (std::size_t i = 0; i < this->Edges.size(); ++i)
  {
    const EdgeUses& edge = this->Edges[i];
    const auto found = this->NewEdges.find(edge.Source.get());
    const Edge& now = found == this->NewEdges.end() ? *edge.Source : *found->second;
    const auto moved = [this, &edge](std::size_t end)
    {
      const auto place =
        this->Vertices.empty() ? this->Vertices.end() : this->Vertices.find(this->FindVertex(end));
      return place == this->Vertices.end() ? GetVertex(*edge.Source, end) : place->second;
    };
    const Point3 start = moved(2 * i);
    const Point3 end = moved(2 * i + 1);
    if (start == now.StartVertex && end == now.EndVertex)
    {
      continue;
    }
    const std::shared_ptr<Edge> result = this->GetNewEdge(edge.Source);
    result->StartVertex = start;
    result->EndVertex = end;
    if (result->Degenerate && !edge.Mapped)
    {
      std::fill(result->Curve.Coefficients.begin(), result->Curve.Coefficients.end(), start);
    }
  }
}

void NetChange::MoveEdges()
{
  for (std::size_t i = 0; i < this->Edges.size(); ++i)
  {
    EdgeUses& edge = this->Edges[i];
    const bool isTouched = this->IsTouched(edge);
    if (isTouched && (edge.Mapped || this->Rule == EditRule::MoveSharedBoundary) && this->FindRows(edge))
    {
      this->CarryEdge(i);
    }
    else if (edge.Mapped)
    {
      this->MapEdge(i);
    }
  }
  if (!this->Vertices.empty() || !this->NewEdges.empty())
  {
    this->MoveVertices();
  }
}

void NetChange::Finish(ModelEdit& edit)
{
  this->CollectEdges();
  this->Propagate();
  this->MoveEdges();
  if (!this->Finite)
  {
    edit.Status = EditStatus::NotFinite;
    edit.Message = "a point of an edge is not finite";
    return;
  }
  const std::vector<FacePointer>& before = this->Model->GetFaces();
  std::vector<FacePointer> after = before;
  for (std::size_t f = 0; f < after.size(); ++f)
  {
    const std::vector<Homogeneous>& old = before[f]->Surface.ControlPoints;
    const std::vector<Homogeneous>& net = this->GetNet(static_cast<int>(f));
    bool changed = this->Faces[f] != before[f] || (&net != &old && net != old);
    for (const auto& [edge, use] : this->EdgesOfFace[f])
    {
      changed = changed || this->NewEdges.count(this->Edges[edge].Source.get()) > 0;
    }
    if (!changed)
    {
      continue;
    }
    auto face = std::make_shared<Face>(*this->Faces[f]);
    face->Id = NewId();
    const auto differ = [](const Homogeneous& a, const Homogeneous& b) { return a[3] != b[3]; };
    const bool reweighted = !std::equal(net.begin(), net.end(), old.begin(), old.end(),
      [&differ](const Homogeneous& a, const Homogeneous& b) { return !differ(a, b); });
    face->Surface.ControlPoints = net;
    if (reweighted)
    {
      face->Surface.Rational = std::any_of(
        net.begin(), net.end(), [&](const Homogeneous& point) { return differ(point, net.front()); });
    }
    for (Loop& loop : face->Loops)
    {
      for (Coedge& coedge : loop.Coedges)
      {
        const auto found = this->NewEdges.find(coedge.Use.get());
        coedge.Use = found == this->NewEdges.end() ? coedge.Use : found->second;
      }
    }
    edit.Replaced.emplace_back(static_cast<int>(f), before[f]);
    after[f] = face;
  }
  edit.Model = vtkSmartPointer<vtkTrimmedNURBSModel>::New();
  edit.Model->ShallowCopy(this->Model);
  edit.Model->SetFaces(std::move(after));
  edit.Opened = FindOpenedEdges(this->Model, edit.Model);
}
}
