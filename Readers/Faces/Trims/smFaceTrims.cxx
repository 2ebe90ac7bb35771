#include "smFaceTrims.h"

#include "Geometry/smCurveFit.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sm
{
namespace
{
NativeBox GetNaturalBox(const DraftFace& face)
{
  NativeBox box;
  for (int d = 0; d < 2; ++d)
  {
    const ParameterRange domain = face.IsPart ? face.Surface->GetDomain(d) : face.Source->GetDomain(d);
    box.Low[d] = domain.Low;
    box.High[d] = domain.High;
    if (!std::isfinite(box.Low[d]) || !std::isfinite(box.High[d]))
    {
      throw std::runtime_error("it has no loops and its surface is infinite");
    }
  }
  return box;
}
}

TrimCurve ProjectOnPlane(const DraftFace& face, const AffineMap& map, const EdgeCurve& curve)
{
  const GeometricFrame& frame = face.Surface->GetIf<ElementarySurface>()->Frame;
  const Vector3 origin = map.MapPoint(frame.Origin);
  const Vector3 axes[2] = { map.MapVector(frame.Axes[0]), map.MapVector(frame.Axes[1]) };
  TrimCurve result;
  result.Breaks = curve.Breaks;
  result.Offsets = curve.Offsets;
  for (const Vector3& p : curve.Coefficients)
  {
    TrimCurve::Point uv{};
    for (int d = 0; d < 2; ++d)
    {
      double square = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        uv[d] += (p[c] - origin[c]) * axes[d][c];
        square += axes[d][c] * axes[d][c];
      }
      uv[d] /= square;
    }
    result.Coefficients.push_back(uv);
  }
  // Lengths in the plane's parameters are lengths in space.
  const double residual =
    std::hypot(curve.Residual[0], curve.Residual[1], curve.Residual[2]) / map.GetScale();
  result.Residual = { residual, residual };
  return result;
}

std::vector<std::shared_ptr<const Edge>> MakeAddedEdges(
  const DraftFace& face, const AffineMap& map, const AffineMap& toModel, double magnitude)
{
  std::vector<std::shared_ptr<const Edge>> edges(face.AddedEdges);
  for (const DraftLoop& loop : face.Loops)
  {
    for (const DraftCoedge& coedge : loop)
    {
      if (coedge.EdgeIndex >= 0 || edges[-1 - coedge.EdgeIndex])
      {
        continue;
      }
      const auto position = [&](double t)
      {
        const auto uv = coedge.Trim.Evaluate(t);
        return map.MapPoint(face.Surface->Evaluate(uv[0], uv[1]));
      };
      const auto locate = [&](const VertexShape* vertex, double t)
      { return vertex ? toModel.MapPoint(vertex->Point) : position(t); };
      auto edge = std::make_shared<Edge>();
      edge->Id = NewId();
      edge->Degenerate = coedge.Degenerate;
      edge->StartVertex = locate(coedge.Start, coedge.Trim.First);
      edge->EndVertex = locate(coedge.End, coedge.Trim.Last);
      if (edge->Degenerate)
      {
        edge->Curve.Breaks.push_back(coedge.Trim.First);
        edge->Curve.AppendPiece(coedge.Trim.Last, &edge->StartVertex, 0);
      }
      else
      {
        edge->Curve = FitEdge(position, coedge.Trim.GetBreaks(), magnitude);
      }
      edges[-1 - coedge.EdgeIndex] = edge;
    }
  }
  return edges;
}

NativeBox GetCoveredBox(const DraftFace& face, const std::vector<std::vector<TrimCurve>>& projected)
{
  if (face.Loops.empty())
  {
    return GetNaturalBox(face);
  }
  NativeBox box{ { 1e300, 1e300 }, { -1e300, -1e300 } };
  for (std::size_t l = 0; l < face.Loops.size(); ++l)
  {
    for (std::size_t i = 0; i < face.Loops[l].size(); ++i)
    {
      const DraftCoedge& coedge = face.Loops[l][i];
      NativeBox own{ { 1e300, 1e300 }, { -1e300, -1e300 } };
      if (coedge.Projected)
      {
        for (const auto& p : projected[l][i].Coefficients)
        {
          for (int d = 0; d < 2; ++d)
          {
            own.Low[d] = std::min(own.Low[d], p[d]);
            own.High[d] = std::max(own.High[d], p[d]);
          }
        }
      }
      else
      {
        coedge.Trim.AddTo(own);
      }
      for (int d = 0; d < 2; ++d)
      {
        box.Low[d] = std::min(box.Low[d], own.Low[d] + coedge.Trim.Shift[d]);
        box.High[d] = std::max(box.High[d], own.High[d] + coedge.Trim.Shift[d]);
      }
    }
  }
  for (int d = 0; d < 2; ++d)
  {
    const double minimum = 1e-9 * std::max({ 1.0, std::abs(box.Low[d]), std::abs(box.High[d]) });
    if (!(box.High[d] - box.Low[d] >= minimum))
    {
      box.Low[d] -= minimum;
      box.High[d] += minimum;
    }
  }
  return box;
}

void SnapToKnots(const std::vector<double> knots[2], TrimCurve& curve)
{
  for (int d = 0; d < 2; ++d)
  {
    const double value = curve.Coefficients[0][d];
    if (!std::all_of(curve.Coefficients.begin(), curve.Coefficients.end(),
          [d, value](const TrimCurve::Point& p) { return p[d] == value; }))
    {
      continue;
    }
    const auto after = std::lower_bound(knots[d].begin(), knots[d].end(), value);
    for (auto knot = after == knots[d].begin() ? after : after - 1; knot != knots[d].end() && knot <= after;
         ++knot)
    {
      const double scale = std::max({ std::abs(*knot), knots[d].back() - knots[d].front() });
      if (*knot != value && std::abs(*knot - value) <= 1e-14 * scale)
      {
        for (auto& p : curve.Coefficients)
        {
          p[d] = *knot;
        }
        curve.RaiseResidual(d, std::abs(*knot - value));
        break;
      }
    }
  }
}
}
