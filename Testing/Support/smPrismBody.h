/**
 * @file smPrismBody.h
 * @brief Prisms over profiles of lines and arcs, for tests that need no file: wedges, cylinders, brackets
 */
#ifndef smPrismBody_h
#define smPrismBody_h

#include "smFace.h"
#include "smRoundFaces.h"

#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace smtest
{
/// A piece of a profile from `Start` to the start of the next: a line, or an arc of at most 90 degrees about
/// `Center`.
struct ProfilePiece
{
  sm::Point2 Start;
  bool IsArc = false;
  sm::Point2 Center{};
};

/// A prism from z = 0 to a height. The profile runs counter-clockwise. Faces are those of the pieces, bottom
/// and top; faces have the numbers 100, 101, ... in this order.
class PrismBody
{
public:
  PrismBody(const std::vector<ProfilePiece>& profile, double height)
    : Profile(profile)
    , Height(height)
  {
    const std::size_t n = profile.size();
    for (std::size_t i = 0; i < n; ++i)
    {
      const sm::Point2& p = profile[i].Start;
      this->Upright.push_back(this->MakeEdge({ { p[0], p[1], 0.0 }, { p[0], p[1], height } }));
      for (int level = 0; level < 2; ++level)
      {
        this->Around[level].push_back(this->MakeEdge(this->FitPiece(i, level * height)));
      }
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      this->AddSide(i);
    }
    this->AddCap(0);
    this->AddCap(1);
  }

  const std::vector<sm::FacePointer>& GetFaces() const { return this->Faces; }

  vtkSmartPointer<vtkNURBSDataSet> Make(const char* name = "prism") const
  {
    vtkNew<vtkTrimmedNURBSModel> model;
    model->SetName(name);
    model->SetFaces(this->Faces);
    std::vector<int> shell(this->Faces.size());
    for (std::size_t f = 0; f < shell.size(); ++f)
    {
      shell[f] = static_cast<int>(f);
    }
    model->SetShells({ shell });
    SetBounds(model);
    auto leaf = vtkSmartPointer<vtkNURBSDataSet>::New();
    leaf->SetModel(model);
    return leaf;
  }

private:
  const sm::Point2& GetEnd(std::size_t i) const
  {
    return this->Profile[(i + 1) % this->Profile.size()].Start;
  }

  /// Homogeneous control points of a piece, 2 or 3 of them: (w x, w y, w).
  std::vector<sm::Vector3> GetPoints(std::size_t i) const
  {
    const ProfilePiece& piece = this->Profile[i];
    const sm::Point2& a = piece.Start;
    const sm::Point2& b = this->GetEnd(i);
    if (!piece.IsArc)
    {
      return { { a[0], a[1], 1.0 }, { b[0], b[1], 1.0 } };
    }
    const sm::Point2& c = piece.Center;
    const double radius = std::hypot(a[0] - c[0], a[1] - c[1]);
    const sm::Point2 sum{ a[0] + b[0] - 2.0 * c[0], a[1] + b[1] - 2.0 * c[1] };
    const double length = std::hypot(sum[0], sum[1]);
    // The cosine of half of the opening; the middle point lies at the radius over it.
    const double w = 0.5 * length / radius;
    const double away = radius / w / length;
    return { { a[0], a[1], 1.0 }, { w * (c[0] + away * sum[0]), w * (c[1] + away * sum[1]), w },
      { b[0], b[1], 1.0 } };
  }

  /// Points of a polynomial curve with the parameter of the side's surface: a line, or cubics that
  /// interpolate points and derivatives of the arc.
  std::vector<sm::Vector3> FitPiece(std::size_t i, double z) const
  {
    const std::vector<sm::Vector3> h = this->GetPoints(i);
    if (h.size() == 2)
    {
      return { { h[0][0], h[0][1], z }, { h[1][0], h[1][1], z } };
    }
    std::vector<sm::Vector3> points;
    for (int k = 0; k <= Cubics; ++k)
    {
      const double t = static_cast<double>(k) / Cubics;
      double value[3];
      double slope[3];
      for (int d = 0; d < 3; ++d)
      {
        value[d] = (1 - t) * (1 - t) * h[0][d] + 2 * t * (1 - t) * h[1][d] + t * t * h[2][d];
        slope[d] = 2 * (1 - t) * (h[1][d] - h[0][d]) + 2 * t * (h[2][d] - h[1][d]);
      }
      const sm::Vector3 p{ value[0] / value[2], value[1] / value[2], z };
      const double third = 1.0 / (3.0 * Cubics * value[2]);
      const sm::Vector3 step{ third * (slope[0] - p[0] * slope[2]), third * (slope[1] - p[1] * slope[2]),
        0.0 };
      if (k > 0)
      {
        points.push_back({ p[0] - step[0], p[1] - step[1], z });
      }
      points.push_back(k == 0 ? sm::Vector3{ h[0][0], h[0][1], z }
          : k == Cubics       ? sm::Vector3{ h[2][0], h[2][1], z }
                              : p);
      if (k < Cubics)
      {
        points.push_back({ p[0] + step[0], p[1] + step[1], z });
      }
    }
    return points;
  }

  std::shared_ptr<sm::Edge> MakeEdge(const std::vector<sm::Vector3>& points)
  {
    auto edge = std::make_shared<sm::Edge>();
    edge->Id = sm::NewId();
    edge->FileId = 1000 + this->NumberOfEdges++;
    edge->StartVertex = points.front();
    edge->EndVertex = points.back();
    edge->Curve.Breaks = { 0.0 };
    const int degree = points.size() == 2 ? 1 : 3;
    const std::size_t pieces = (points.size() - 1) / degree;
    for (std::size_t k = 0; k < pieces; ++k)
    {
      edge->Curve.AppendPiece(static_cast<double>(k + 1) / pieces, points.data() + degree * k, degree);
    }
    return edge;
  }

  sm::Coedge Use(const std::shared_ptr<const sm::Edge>& edge, bool reversed, const sm::Point2& from,
    const sm::Point2& to) const
  {
    sm::Coedge coedge;
    coedge.Use = edge;
    coedge.Reversed = reversed;
    coedge.Curve.Breaks = { edge->Curve.GetStart() };
    // In the direction of the edge.
    const sm::Point2 ends[2] = { reversed ? to : from, reversed ? from : to };
    coedge.Curve.AppendPiece(edge->Curve.GetEnd(), ends, 1);
    return coedge;
  }

  std::shared_ptr<sm::Face> MakeFace() const
  {
    auto face = std::make_shared<sm::Face>();
    face->Id = sm::NewId();
    face->FileId = 100 + static_cast<int>(this->Faces.size());
    return face;
  }

  void AddSide(std::size_t i)
  {
    const std::vector<sm::Vector3> h = this->GetPoints(i);
    const auto face = this->MakeFace();
    sm::NURBSSurface& surface = face->Surface;
    surface.Degree[0] = static_cast<int>(h.size()) - 1;
    surface.Rational = h.size() == 3;
    surface.Knots[0].assign(h.size(), 0.0);
    surface.Knots[0].insert(surface.Knots[0].end(), h.size(), 1.0);
    surface.Knots[1] = { 0.0, 0.0, 1.0, 1.0 };
    surface.NumberOfControlPoints[0] = static_cast<int>(h.size());
    surface.NumberOfControlPoints[1] = 2;
    for (const double z : { 0.0, this->Height })
    {
      for (const sm::Vector3& p : h)
      {
        surface.ControlPoints.push_back({ p[0], p[1], z * p[2], p[2] });
      }
    }
    const std::size_t next = (i + 1) % this->Profile.size();
    sm::Loop loop;
    loop.Coedges = { this->Use(this->Around[0][i], false, { 0, 0 }, { 1, 0 }),
      this->Use(this->Upright[next], false, { 1, 0 }, { 1, 1 }),
      this->Use(this->Around[1][i], true, { 1, 1 }, { 0, 1 }),
      this->Use(this->Upright[i], true, { 0, 1 }, { 0, 0 }) };
    face->Loops.push_back(loop);
    this->Faces.push_back(face);
  }

  void AddCap(int level)
  {
    const auto face = this->MakeFace();
    face->Reversed = level == 0;
    double low[2] = { 1e300, 1e300 };
    double high[2] = { -1e300, -1e300 };
    for (const auto& edge : this->Around[level])
    {
      for (const sm::Vector3& p : edge->Curve.Coefficients)
      {
        for (int d = 0; d < 2; ++d)
        {
          low[d] = std::min(low[d], p[d]);
          high[d] = std::max(high[d], p[d]);
        }
      }
    }
    sm::NURBSSurface& surface = face->Surface;
    surface.Knots[0] = surface.Knots[1] = { 0.0, 0.0, 1.0, 1.0 };
    surface.NumberOfControlPoints[0] = surface.NumberOfControlPoints[1] = 2;
    for (const double y : { low[1], high[1] })
    {
      for (const double x : { low[0], high[0] })
      {
        surface.ControlPoints.push_back({ x, y, level * this->Height, 1.0 });
      }
    }
    sm::Loop loop;
    for (std::size_t k = 0; k < this->Profile.size(); ++k)
    {
      const std::size_t i = k;
      sm::Coedge coedge;
      coedge.Use = this->Around[level][i];
      const sm::EdgeCurve& curve = coedge.Use->Curve;
      coedge.Curve.Breaks = { curve.GetStart() };
      for (int piece = 0; piece < curve.GetNumberOfPieces(); ++piece)
      {
        const sm::BernsteinPiece<3> source = curve.GetPiece(piece);
        std::vector<sm::Point2> points;
        for (int j = 0; j <= source.Degree; ++j)
        {
          points.push_back({ (source.Coefficients[j][0] - low[0]) / (high[0] - low[0]),
            (source.Coefficients[j][1] - low[1]) / (high[1] - low[1]) });
        }
        coedge.Curve.AppendPiece(curve.Breaks[piece + 1], points.data(), source.Degree);
      }
      loop.Coedges.push_back(coedge);
    }
    face->Loops.push_back(loop);
    this->Faces.push_back(face);
  }

  static constexpr int Cubics = 64;
  std::vector<ProfilePiece> Profile;
  double Height;
  std::vector<std::shared_ptr<const sm::Edge>> Upright, Around[2];
  std::vector<sm::FacePointer> Faces;
  int NumberOfEdges = 0;
};
}

#endif
