/**
 * @file smHessianSums.h
 * @brief Directions of control points, and the second derivatives along two of them
 */
#ifndef smHessianSums_h
#define smHessianSums_h

#include "smGradientSums.h"
#include "smMomentHessian.h"

#include <vector>

namespace smtest
{
/// The direction in which each control point moves by the vector that move(face, point) returns. `gradient`
/// has the points.
template <class Move>
std::vector<sm::NetDirection> MakeDirection(const sm::MomentGradientResult& gradient, const Move& move)
{
  std::vector<sm::NetDirection> direction;
  for (const sm::FaceMomentGradient& face : gradient.Faces)
  {
    sm::NetDirection net;
    net.Solid = face.Solid;
    net.Face = face.Face;
    for (const std::array<double, 4>& point : face.Points)
    {
      net.Displacements.push_back(move(face, point));
    }
    direction.push_back(net);
  }
  return direction;
}

/// Returns u . H v for quantity q, a tied variable once, with its bound.
inline GradientSum Multiply(const sm::MomentGradientResult& gradient, const std::vector<sm::NetDirection>& u,
  const sm::MomentHessianResult& product, int q)
{
  GradientSum sum;
  std::set<std::int64_t> seen;
  for (std::size_t f = 0; f < product.Faces.size(); ++f)
  {
    const sm::FaceHessianProduct& face = product.Faces[f];
    for (int i = 0; i < face.Count[0]; ++i)
    {
      for (int j = 0; j < face.Count[1]; ++j)
      {
        const std::size_t at = static_cast<std::size_t>(i) * face.Count[1] + j;
        if (!seen.insert(gradient.Faces[f].PointVariables[at]).second)
        {
          continue;
        }
        for (int c = 0; c < 3; ++c)
        {
          const std::size_t place = face.GetIndex(i, j, c, q);
          sum.Add(u[f].Displacements[at][c], face.Values[place], face.Bounds[place]);
        }
      }
    }
  }
  return sum;
}
}

#endif
