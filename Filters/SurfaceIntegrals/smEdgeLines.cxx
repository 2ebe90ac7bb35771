#include "smEdgeLines.h"

#include "vtkTrimmedNURBSModel.h"

namespace sm
{
namespace
{
/// Smallest number of chords of a curved edge.
constexpr int MinChords = 32;
}

std::vector<Vector3> SampleEdge(const Edge& edge)
{
  std::vector<Vector3> points{ edge.StartVertex };
  const auto add = [&points](const Vector3& p)
  {
    if (p != points.back())
    {
      points.push_back(p);
    }
  };
  const int pieces = edge.Curve.GetNumberOfPieces();
  for (int i = 0; i < pieces; ++i)
  {
    const BernsteinPiece<3> piece = edge.Curve.GetPiece(i);
    // A straight edge has a point in its middle, where its number is drawn.
    const int chords = 1 + ((piece.Degree <= 1 ? 2 : MinChords) - 1) / pieces;
    for (int k = 0; k <= chords; ++k)
    {
      add(piece.Evaluate(static_cast<double>(k) / chords));
    }
  }
  add(edge.EndVertex);
  return points;
}

Vector3 PlacePoint(vtkTrimmedNURBSModel& model, const double* placement, const Vector3& stored)
{
  const double* origin = model.GetOrigin();
  const double* m = placement;
  const Vector3 p{ origin[0] + stored[0], origin[1] + stored[1], origin[2] + stored[2] };
  return { Dot(m, p.data()) + m[3], Dot(m + 4, p.data()) + m[7], Dot(m + 8, p.data()) + m[11] };
}
}
