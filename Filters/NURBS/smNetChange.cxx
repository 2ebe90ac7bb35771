#include "smNetChange.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace sm
{
namespace
{
// Relative to the size of the body: rows nearer than this are one.
constexpr double RowTolerance = 1e-9;

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
      farthest = std::max(farthest, std::hypot(point[0], point[1], point[2]) / point[3]);
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
{
}

void NetChange::SetTemplate(int face, const FacePointer& face_)
{
  // The net stays the old one, for the rows to be compared with the neighbours'.
  auto copy = std::make_shared<Face>(*face_);
  copy->Surface.ControlPoints = this->Faces[face]->Surface.ControlPoints;
  this->Faces[face] = copy;
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
  edge.Coincident = !edge.Source->Degenerate;
  RowCurve row;
  for (Use& use : edge.Uses)
  {
    const NURBSSurface& surface = this->GetFace(use.Face).Surface;
    use.IsRow = edge.Coincident && FindBoundaryRow(surface, this->GetTrim(use), use.Row);
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

std::shared_ptr<const EdgeOrigin> NetChange::GetOrigin(const EdgeUses& edge) const
{
  const Use& first = edge.Uses.front();
  auto origin = std::make_shared<EdgeOrigin>();
  origin->Source = edge.Source;
  origin->Row = RowCurve(this->GetFace(first.Face).Surface, first.Row);
  const auto& older = edge.Source->Origin;
  // An older one counts as long as it belongs to the same kind of row.
  return older && older->Row.Degree == origin->Row.Degree && older->Row.Knots == origin->Row.Knots ? older
                                                                                                   : origin;
}

std::shared_ptr<Edge> NetChange::GetNewEdge(const std::shared_ptr<const Edge>& edge)
{
  const auto found = this->NewEdges.find(edge.get());
  auto copy = std::make_shared<Edge>(found == this->NewEdges.end() ? *edge : *found->second);
  copy->Id = NewId();
  this->NewEdges[edge.get()] = copy;
  return copy;
}

void NetChange::MoveVertex(const Point& from, const Point& to)
{
  if (from != to)
  {
    this->Vertices.emplace(from, to);
  }
}

void NetChange::CarryEdge(const EdgeUses& edge)
{
  const Use& first = edge.Uses.front();
  NURBSSurface surface = this->GetFace(first.Face).Surface;
  const RowCurve before(surface, first.Row);
  surface.ControlPoints = this->GetNet(first.Face);
  const RowCurve now(surface, first.Row);
  if (now == before)
  {
    return;
  }
  const std::shared_ptr<const EdgeOrigin> origin = this->GetOrigin(edge);
  const Edge& source = *origin->Source;
  const auto moved = [](const Point& vertex, const Homogeneous& from, const Homogeneous& to)
  {
    Point result = vertex;
    for (int c = 0; c < 3 && from != to; ++c)
    {
      result[c] += to[c] / to[3] - from[c] / from[3];
    }
    return result;
  };
  this->MoveVertex(
    edge.Source->StartVertex, moved(source.StartVertex, origin->Row.Points.front(), now.Points.front()));
  this->MoveVertex(
    edge.Source->EndVertex, moved(source.EndVertex, origin->Row.Points.back(), now.Points.back()));
  if (now == origin->Row)
  {
    this->NewEdges[edge.Source.get()] = origin->Source;
    return;
  }
  const std::shared_ptr<Edge> result = this->GetNewEdge(edge.Source);
  result->Curve = Displace(*origin, now, surface, first.Row, this->GetTrim(first));
  result->Origin = origin;
}

void NetChange::MapEdge(EdgeUses& edge)
{
  EdgeCurve curve = edge.Source->Curve;
  for (EdgeCurve::Point& point : curve.Coefficients)
  {
    point = this->Map(point);
  }
  const Point start = this->Map(edge.Source->StartVertex);
  const Point end = this->Map(edge.Source->EndVertex);
  const bool moves = curve.Coefficients != edge.Source->Curve.Coefficients;
  // Coincident rows that are not touched stay where they are, whatever the map does between their control points.
  if ((!moves && start == edge.Source->StartVertex && end == edge.Source->EndVertex) || this->FindRows(edge))
  {
    return;
  }
  this->MoveVertex(edge.Source->StartVertex, start);
  this->MoveVertex(edge.Source->EndVertex, end);
  if (moves)
  {
    const std::shared_ptr<Edge> result = this->GetNewEdge(edge.Source);
    result->Curve = curve;
    result->Origin = nullptr;
  }
}

void NetChange::MoveVertices()
{
  for (const EdgeUses& edge : this->Edges)
  {
    const auto found = this->NewEdges.find(edge.Source.get());
    const Edge& now = found == this->NewEdges.end() ? *edge.Source : *found->second;
    const auto moved = [this](const Point& vertex)
    {
      const auto place = this->Vertices.find(vertex);
      return place == this->Vertices.end() ? vertex : place->second;
    };
    const Point start = moved(edge.Source->StartVertex);
    const Point end = moved(edge.Source->EndVertex);
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
  for (EdgeUses& edge : this->Edges)
  {
    const bool isTouched = this->IsTouched(edge);
    if (isTouched && (edge.Mapped || this->Rule == EditRule::MoveSharedBoundary) && this->FindRows(edge))
    {
      this->CarryEdge(edge);
    }
    else if (edge.Mapped)
    {
      this->MapEdge(edge);
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
