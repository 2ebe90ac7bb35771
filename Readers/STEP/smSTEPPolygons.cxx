#include "smSTEPPolygons.h"

#include <Geom_Line.hxx>
#include <Precision.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pnt.hxx>

namespace sm
{
bool STEPPolygons::Add(const std::vector<Vector3>& corners, bool isForward, TopoDS_Face& face)
{
  TopoDS_Wire wire;
  this->Builder.MakeWire(wire);
  bool hasSides = false;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Vector3& from = corners[i];
    const Vector3& to = corners[(i + 1) % corners.size()];
    if (Norm(Subtract(to, from)) > Precision::Confusion())
    {
      const bool isAscending = from < to;
      const TopoDS_Edge side = isAscending ? this->GetSide(from, to) : this->GetSide(to, from);
      this->Builder.Add(wire, side.Oriented(isAscending ? TopAbs_FORWARD : TopAbs_REVERSED));
      hasSides = true;
    }
  }
  if (hasSides)
  {
    wire.Closed(true);
    wire.Orientation(isForward ? TopAbs_FORWARD : TopAbs_REVERSED);
    this->Builder.Add(face, wire);
  }
  return hasSides;
}

TopoDS_Edge STEPPolygons::GetSide(const Vector3& from, const Vector3& to)
{
  TopoDS_Edge& side = this->Sides[{ from, to }];
  if (side.IsNull())
  {
    const gp_Pnt start(from[0], from[1], from[2]);
    const gp_Pnt end(to[0], to[1], to[2]);
    this->Builder.MakeEdge(side, new Geom_Line(start, gp_Vec(start, end)), Precision::Confusion());
    for (const Vector3* point : { &from, &to })
    {
      TopoDS_Vertex& corner = this->Corners[*point];
      if (corner.IsNull())
      {
        this->Builder.MakeVertex(corner, point == &from ? start : end, Precision::Confusion());
      }
      this->Builder.Add(side, corner.Oriented(point == &from ? TopAbs_FORWARD : TopAbs_REVERSED));
    }
    this->Builder.Range(side, 0.0, start.Distance(end));
  }
  return side;
}
}
