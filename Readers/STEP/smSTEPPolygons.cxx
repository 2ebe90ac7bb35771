#include "smSTEPPolygons.h"

namespace sm
{
bool STEPPolygons::Add(const std::vector<Vector3>& corners, bool isForward, FaceShape& face)
{
  WireShape wire;
  wire.Reversed = !isForward;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Vector3& from = corners[i];
    const Vector3& to = corners[(i + 1) % corners.size()];
    if (Norm(Subtract(to, from)) > DefaultTolerance)
    {
      const bool isAscending = from < to;
      CoedgeShape side;
      side.Edge = isAscending ? this->GetSide(from, to) : this->GetSide(to, from);
      side.Reversed = isAscending != isForward;
      wire.Coedges.push_back(std::move(side));
    }
  }
  const bool hasSides = !wire.Coedges.empty();
  if (hasSides)
  {
    face.Wires.push_back(std::move(wire));
  }
  return hasSides;
}

const EdgePointer& STEPPolygons::GetSide(const Vector3& from, const Vector3& to)
{
  EdgePointer& side = this->Sides[{ from, to }];
  if (!side)
  {
    const Vector3 along = Subtract(to, from);
    side = std::make_shared<EdgeShape>();
    std::string problem;
    side->Curve = GeometricCurve<3>::Make(LineCurve<3>{ from, Normalized(along) }, problem);
    side->Last = Norm(along);
    for (const Vector3* point : { &from, &to })
    {
      VertexPointer& corner = this->Corners[*point];
      if (!corner)
      {
        corner = std::make_shared<VertexShape>();
        corner->Point = *point;
      }
      (point == &from ? side->Start : side->End) = corner;
    }
  }
  return side;
}
}
