#include "smPlacement.h"

#include "smGeometryTransform.h"

#include <stdexcept>

namespace sm
{
namespace
{
AffineTransform<3> ToTransform(const Placement& placement)
{
  AffineTransform<3> transform;
  for (int i = 0; i < 3; ++i)
  {
    std::copy(placement.Linear[i], placement.Linear[i] + 3, transform.Linear[i].begin());
  }
  transform.Translation = placement.Translation;
  return transform;
}
}

Placement Compose(const Placement& first, const Placement& second)
{
  Placement result;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      result.Linear[i][j] = first.Linear[i][0] * second.Linear[0][j] +
        first.Linear[i][1] * second.Linear[1][j] + first.Linear[i][2] * second.Linear[2][j];
    }
  }
  result.Translation = first.MapPoint(second.Translation);
  return result;
}

Placement Invert(const Placement& placement)
{
  const double scale = placement.GetScale();
  Placement result;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      result.Linear[i][j] = placement.Linear[j][i] / (scale * scale);
    }
  }
  result.Translation = Multiply(-1.0, result.MapVector(placement.Translation));
  return result;
}

bool IsIdentity(const Placement& placement)
{
  bool isIdentity = true;
  for (int i = 0; i < 3; ++i)
  {
    isIdentity = isIdentity && placement.Translation[i] == 0.0;
    for (int j = 0; j < 3; ++j)
    {
      isIdentity = isIdentity && placement.Linear[i][j] == (i == j ? 1.0 : 0.0);
    }
  }
  return isIdentity;
}

Placement MakeScale(double factor)
{
  Placement result;
  for (int i = 0; i < 3; ++i)
  {
    result.Linear[i][i] = factor;
  }
  return result;
}

Placement MakeMotion(const GeometricFrame& frame)
{
  Placement result;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      result.Linear[i][j] = frame.Axes[j][i];
    }
  }
  result.Translation = frame.Origin;
  return result;
}

CurvePointer<3> MoveCurve(const CurvePointer<3>& curve, const Placement& placement)
{
  if (IsIdentity(placement))
  {
    return curve;
  }
  ParameterScale parameter;
  std::string problem;
  CurvePointer<3> moved = TransformCurve<3>(curve, ToTransform(placement), parameter, problem);
  if (!moved)
  {
    throw std::runtime_error(problem);
  }
  return moved;
}

SurfacePointer MoveSurface(const SurfacePointer& surface, const Placement& placement)
{
  if (IsIdentity(placement))
  {
    return surface;
  }
  ParameterScale parameters[2];
  std::string problem;
  SurfacePointer moved = TransformSurface(surface, ToTransform(placement), parameters, problem);
  if (!moved)
  {
    throw std::runtime_error(problem);
  }
  return moved;
}
}
