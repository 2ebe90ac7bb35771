#include "smVariantShape.h"

#include "Detail/smVariantBase.h"
#include "smBernstein.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
constexpr std::size_t MaximumDirections = 10000;

bool IsSameCurve(const TrimCurve& a, const TrimCurve& b)
{
  return a.Breaks == b.Breaks && a.Offsets == b.Offsets && a.Coefficients == b.Coefficients;
}

/// Returns the coefficients of a curve on [start, end], which lies in one of its pieces, with this degree.
std::vector<Point3> GetPart(const EdgeCurve& curve, double start, double end, int degree)
{
  const int piece = curve.FindPiece(0.5 * (start + end));
  const BernsteinPiece<3> source = curve.GetPiece(piece);
  std::vector<Point3> points(source.Coefficients, source.Coefficients + source.Degree + 1);
  const double first = curve.Breaks[piece];
  const double width = curve.Breaks[piece + 1] - first;
  const double low = (start - first) / width;
  const double high = end == curve.Breaks[piece + 1] ? 1.0 : (end - first) / width;
  if (source.Degree > 0 && (low != 0.0 || high != 1.0))
  {
    RestrictBernstein(points.data(), source.Degree, 1, low, high);
  }
  for (int n = source.Degree; n < degree; ++n)
  {
    points.push_back(points.back());
    for (int i = n; i > 0; --i)
    {
      const double share = static_cast<double>(i) / (n + 1);
      for (int c = 0; c < 3; ++c)
      {
        points[i][c] = share * points[i - 1][c] + (1.0 - share) * points[i][c];
      }
    }
  }
  return points;
}

int GetDegreeAt(const EdgeCurve& curve, double t)
{
  return curve.GetDegree(curve.FindPiece(t));
}
}

std::shared_ptr<const VariantShape> VariantShape::Make(
  vtkTrimmedNURBSModel* base, const std::vector<MovedModel>& directions, std::string& error)
{
  error.clear();
  if (!base || base->GetNumberOfFaces() == 0)
  {
    error = "the base model has no faces: give it exact geometry first";
    return nullptr;
  }
  if (directions.size() > MaximumDirections)
  {
    error = std::to_string(directions.size()) + " directions are more than 10000: use fewer";
    return nullptr;
  }
  error = FindBaseProblem(*base);
  if (!error.empty())
  {
    return nullptr;
  }
  const std::shared_ptr<VariantShape> shape(new VariantShape);
  shape->Base = base;
  for (const FacePointer& face : base->GetFaces())
  {
    shape->Faces.push_back({ face, {} });
    for (const Loop& loop : face->Loops)
    {
      for (const Coedge& coedge : loop.Coedges)
      {
        VariantEdge& edge = shape->Edges[coedge.Use.get()];
        edge.Source = coedge.Use;
        edge.Curve = coedge.Use->Curve;
      }
    }
  }
  for (const MovedModel& moved : directions)
  {
    error = shape->AddDirection(moved);
    if (!error.empty())
    {
      error = "direction " + std::to_string(shape->NumberOfDirections) + ": " + error;
      return nullptr;
    }
    ++shape->NumberOfDirections;
  }
  shape->DivideEdges();
  return shape;
}

std::string VariantShape::AddDirection(const MovedModel& moved)
{
  if (!moved.Model || moved.Model->GetNumberOfFaces() != this->Base->GetNumberOfFaces())
  {
    return "the moved model does not have the faces of the base: move a copy of the base";
  }
  if (!std::isfinite(moved.Amount) || moved.Amount == 0.0)
  {
    return "an amount of 0, or one that is not finite, gives no direction: state how far the model was moved";
  }
  const double* origin = moved.Model->GetOrigin();
  if (!std::equal(origin, origin + 3, this->Base->GetOrigin()))
  {
    return "the moved model has another origin than the base: move control points, not the model";
  }
  for (std::size_t i = 0; i < this->Faces.size(); ++i)
  {
    const std::string problem =
      this->AddFace(i, *moved.Model->GetFaces()[i], 1.0 / moved.Amount, this->NumberOfDirections);
    if (!problem.empty())
    {
      return "face " + std::to_string(i) + " of the moved model " + problem +
        ": its volume would be wrong; move control points only, and those that coincide alike, or give the "
        "face edges";
    }
  }
  return {};
}

std::string VariantShape::AddFace(std::size_t index, const Face& moved, double factor, int direction)
{
  VariantFace& face = this->Faces[index];
  const Face& base = *face.Source;
  if (&moved == &base)
  {
    return {};
  }
  const NURBSSurface& a = base.Surface;
  const NURBSSurface& b = moved.Surface;
  if (!std::equal(a.Degree, a.Degree + 2, b.Degree) || a.Knots[0] != b.Knots[0] || a.Knots[1] != b.Knots[1] ||
    a.ControlPoints.size() != b.ControlPoints.size() || base.Reversed != moved.Reversed)
  {
    return "has other degrees, knots or another orientation";
  }
  std::vector<Point3> displacements(a.ControlPoints.size());
  bool isMoved = false;
  for (std::size_t i = 0; i < displacements.size(); ++i)
  {
    if (a.ControlPoints[i][3] != b.ControlPoints[i][3])
    {
      return "has other weights";
    }
    for (int c = 0; c < 3; ++c)
    {
      displacements[i][c] = factor * (b.ControlPoints[i][c] - a.ControlPoints[i][c]);
      isMoved = isMoved || displacements[i][c] != 0.0;
      if (!std::isfinite(displacements[i][c]))
      {
        return "has control points that are not finite";
      }
    }
  }
  if (isMoved && base.Loops.empty() && OpensFace(a, displacements))
  {
    return "opens, or moves a border that no edge closes, of a face without loops";
  }
  if (isMoved)
  {
    face.Displacements[direction] = std::move(displacements);
  }
  if (base.Loops.size() != moved.Loops.size())
  {
    return "has other loops";
  }
  for (std::size_t l = 0; l < base.Loops.size(); ++l)
  {
    const std::vector<Coedge>& from = base.Loops[l].Coedges;
    const std::vector<Coedge>& to = moved.Loops[l].Coedges;
    if (from.size() != to.size())
    {
      return "has other loops";
    }
    for (std::size_t i = 0; i < from.size(); ++i)
    {
      if (from[i].Reversed != to[i].Reversed || !IsSameCurve(from[i].Curve, to[i].Curve))
      {
        return "has other trim curves";
      }
      const EdgeCurve& curve = to[i].Use->Curve;
      if (from[i].Use == to[i].Use)
      {
        continue;
      }
      if (curve.GetNumberOfPieces() < 1 || from[i].Use->Curve.GetNumberOfPieces() < 1 ||
        curve.GetStart() != from[i].Use->Curve.GetStart() || curve.GetEnd() != from[i].Use->Curve.GetEnd())
      {
        return "has an edge with another range of its parameter";
      }
      auto& known = this->MovedEdges[from[i].Use.get()][direction];
      if (known.first && known.first != to[i].Use)
      {
        return "does not share an edge that the base shares";
      }
      known = { to[i].Use, factor };
    }
  }
  return {};
}

void VariantShape::DivideEdges()
{
  for (const auto& [source, moved] : this->MovedEdges)
  {
    VariantEdge& edge = this->Edges[source];
    std::vector<double> breaks = source->Curve.Breaks;
    for (const auto& [direction, other] : moved)
    {
      breaks.insert(breaks.end(), other.first->Curve.Breaks.begin(), other.first->Curve.Breaks.end());
    }
    std::sort(breaks.begin(), breaks.end());
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    EdgeCurve curve;
    curve.Residual = source->Curve.Residual;
    curve.Breaks = { breaks.front() };
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    {
      const double middle = 0.5 * (breaks[i] + breaks[i + 1]);
      int degree = GetDegreeAt(source->Curve, middle);
      for (const auto& [direction, other] : moved)
      {
        degree = std::max(degree, GetDegreeAt(other.first->Curve, middle));
      }
      const std::vector<Point3> base = GetPart(source->Curve, breaks[i], breaks[i + 1], degree);
      const std::size_t first = curve.Coefficients.size();
      curve.AppendPiece(breaks[i + 1], base.data(), degree);
      for (const auto& [direction, other] : moved)
      {
        std::vector<Point3>& to = edge.Displacements[direction];
        const std::vector<Point3> part = GetPart(other.first->Curve, breaks[i], breaks[i + 1], degree);
        for (int k = 0; k <= degree; ++k)
        {
          Point3 d;
          for (int c = 0; c < 3; ++c)
          {
            d[c] = other.second * (part[k][c] - base[k][c]);
          }
          // Neighbouring pieces share their end.
          to.push_back(k == 0 && first > 0 ? to.back() : d);
        }
      }
    }
    edge.Curve = std::move(curve);
    for (const auto& [direction, other] : moved)
    {
      std::array<Point3, 2>& vertices = edge.Vertices[direction];
      for (int c = 0; c < 3; ++c)
      {
        vertices[0][c] = other.second * (other.first->StartVertex[c] - source->StartVertex[c]);
        vertices[1][c] = other.second * (other.first->EndVertex[c] - source->EndVertex[c]);
      }
    }
  }
  this->MovedEdges.clear();
}

const VariantEdge* VariantShape::FindEdge(const Edge* edge) const
{
  const auto found = this->Edges.find(edge);
  return found == this->Edges.end() ? nullptr : &found->second;
}

vtkSmartPointer<vtkTrimmedNURBSModel> VariantShape::MakeModel(const double* c) const
{
  std::map<const Edge*, std::shared_ptr<const Edge>> edges;
  for (const auto& [source, edge] : this->Edges)
  {
    if (edge.Displacements.empty())
    {
      continue;
    }
    auto moved = std::make_shared<Edge>(*edge.Source);
    moved->Id = NewId();
    moved->Origin = nullptr;
    moved->Curve = edge.Curve;
    for (const auto& [direction, displacements] : edge.Displacements)
    {
      for (std::size_t i = 0; i < displacements.size(); ++i)
      {
        for (int d = 0; d < 3; ++d)
        {
          moved->Curve.Coefficients[i][d] += c[direction] * displacements[i][d];
        }
      }
    }
    for (const auto& [direction, vertices] : edge.Vertices)
    {
      for (int d = 0; d < 3; ++d)
      {
        moved->StartVertex[d] += c[direction] * vertices[0][d];
        moved->EndVertex[d] += c[direction] * vertices[1][d];
      }
    }
    edges[source] = moved;
  }
  std::vector<FacePointer> faces;
  for (const VariantFace& face : this->Faces)
  {
    auto moved = std::make_shared<Face>(*face.Source);
    bool isNew = !face.Displacements.empty();
    std::array<double, 3> largest{};
    NURBSSurface& surface = moved->Surface;
    for (std::size_t i = 0; i < surface.ControlPoints.size(); ++i)
    {
      std::array<double, 4>& point = surface.ControlPoints[i];
      std::array<double, 3> size{ std::abs(point[0]), std::abs(point[1]), std::abs(point[2]) };
      for (const auto& [direction, displacements] : face.Displacements)
      {
        for (int d = 0; d < 3; ++d)
        {
          point[d] += c[direction] * displacements[i][d];
          size[d] += std::abs(c[direction] * displacements[i][d]);
        }
      }
      for (int d = 0; d < 3; ++d)
      {
        largest[d] = std::max(largest[d], size[d] / point[3]);
      }
    }
    for (int d = 0; d < 3 && isNew; ++d)
    {
      // One product and one sum for each direction.
      surface.Rounding[d] += 2.0 * static_cast<double>(face.Displacements.size()) * UnitRoundoff * largest[d];
    }
    for (Loop& loop : moved->Loops)
    {
      for (Coedge& coedge : loop.Coedges)
      {
        const auto found = edges.find(coedge.Use.get());
        if (found != edges.end())
        {
          coedge.Use = found->second;
          isNew = true;
        }
      }
    }
    moved->Id = isNew ? NewId() : moved->Id;
    faces.push_back(isNew ? FacePointer(moved) : face.Source);
  }
  auto model = vtkSmartPointer<vtkTrimmedNURBSModel>::New();
  model->ShallowCopy(this->Base);
  model->SetFaces(faces);
  return model;
}
}
