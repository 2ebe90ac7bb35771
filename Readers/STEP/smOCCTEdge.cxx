#include "smOCCTEdge.h"

#include "smOCCTCurve.h"

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS_Vertex.hxx>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sm
{
AffineMap BodyPlace::MakeMap(const gp_Trsf& location) const
{
  return AffineMap::Make(this->Trsf * location, this->Unit, this->Origin);
}

double BodyPlace::GetLargestOrigin() const
{
  return std::max({ std::abs(this->Origin[0]), std::abs(this->Origin[1]), std::abs(this->Origin[2]) });
}

std::shared_ptr<const Edge> ConvertEdgeShape(const TopoDS_Edge& edge, const ShapeInfo& info,
  const BodyPlace& place, const DraftFace& face, const DraftCoedge& coedge)
{
  auto result = std::make_shared<Edge>();
  result->Id = NewId();
  result->FileId = info.FileId;
  result->Name = info.Name;
  result->Tolerance = place.Unit * BRep_Tool::Tolerance(edge);
  result->Degenerate = BRep_Tool::Degenerated(edge);

  const AffineMap toModel = place.MakeMap(gp_Trsf());
  const TopoDS_Vertex vertices[2] = { TopExp::FirstVertex(edge), TopExp::LastVertex(edge) };
  Vector3* const points[2] = { &result->StartVertex, &result->EndVertex };
  for (int i = 0; i < 2; ++i)
  {
    if (!vertices[i].IsNull())
    {
      *points[i] = toModel.MapPoint(BRep_Tool::Pnt(vertices[i]).XYZ());
    }
  }
  double first = 0.0;
  double last = 0.0;
  TopLoc_Location location;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, location, first, last);
  const NativeTrim& trim = coedge.Trim;
  if (result->Degenerate)
  {
    result->Curve.Breaks.push_back(trim.First);
    result->Curve.AppendPiece(trim.Last, &result->StartVertex, 0);
  }
  else if (!curve.IsNull() && last > first)
  {
    result->Curve = ConvertEdge(curve, first, last, place.MakeMap(location.Transformation()));
  }
  else if (trim.Curve.IsNull())
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
        return map.MapPoint(face.Surface->Value(uv[0], uv[1]).XYZ());
      },
      trim.GetBreaks(), place.GetLargestOrigin());
  }
  for (int i = 0; i < 2; ++i)
  {
    if (vertices[i].IsNull())
    {
      *points[i] = i == 0 ? result->Curve.GetStartPoint() : result->Curve.GetEndPoint();
    }
  }
  return result;
}
}
