#include "smEdgeConversion.h"

#include "Geometry/smCurveFit.h"
#include "Geometry/smGeometryConversion.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sm
{
AffineMap BodyPlace::MakeMap(const Placement& location) const
{
  AffineMap map = IsIdentity(location) ? this->Scale : Compose(this->Scale, location);
  for (int i = 0; i < 3; ++i)
  {
    for (double& entry : map.Linear[i])
    {
      entry *= this->Unit;
    }
    map.Translation[i] = this->Unit * map.Translation[i] - this->Origin[i];
  }
  return map;
}

double BodyPlace::GetMaxOrigin() const
{
  return std::max({ std::abs(this->Origin[0]), std::abs(this->Origin[1]), std::abs(this->Origin[2]) });
}

std::shared_ptr<const Edge> ConvertEdgeShape(
  const EdgeShape& edge, const BodyPlace& place, const DraftFace& face, const DraftCoedge& coedge)
{
  auto result = std::make_shared<Edge>();
  result->Id = NewId();
  result->FileId = edge.Data.FileId;
  result->Name = edge.Data.Name;
  result->Tolerance = place.Unit * edge.Tolerance;
  result->Degenerate = edge.Degenerate;

  const AffineMap toModel = place.MakeMap(Placement());
  const VertexShape* const vertices[2] = { edge.Start.get(), edge.End.get() };
  Vector3* const points[2] = { &result->StartVertex, &result->EndVertex };
  for (int i = 0; i < 2; ++i)
  {
    if (vertices[i])
    {
      *points[i] = toModel.MapPoint(vertices[i]->Point);
    }
  }
  const NativeTrim& trim = coedge.Trim;
  if (result->Degenerate)
  {
    result->Curve.Breaks.push_back(trim.First);
    result->Curve.AppendPiece(trim.Last, &result->StartVertex, 0);
  }
  else if (edge.HasCurve())
  {
    result->Curve = ConvertCurve(*edge.Curve, edge.First, edge.Last, place.MakeMap(edge.Location));
  }
  else if (!trim.Curve)
  {
    throw std::runtime_error("its parameter range is empty");
  }
  else
  {
    const AffineMap map = place.MakeMap(face.Location);
    result->Curve = FitEdge(
      [&](double t)
      {
        const auto uv = trim.Evaluate(t);
        return map.MapPoint(face.Surface->Evaluate(uv[0], uv[1]));
      },
      trim.GetBreaks(), place.GetMaxOrigin());
  }
  for (int i = 0; i < 2; ++i)
  {
    if (!vertices[i])
    {
      *points[i] = i == 0 ? result->Curve.GetStartPoint() : result->Curve.GetEndPoint();
    }
  }
  return result;
}
}
