#include "smTriangleJudge.h"

#include "smUnitRoundoff.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// A triangle is a line where twice its area is below this part of the square of its longest side.
constexpr double LineShare = 1e-7;
/// A triangle is not inverted where the cosines to the normals of its corners are above this.
constexpr double PlainCosine = 0.5;
/// |S_u x S_v| has no direction below this part of |S_u| |S_v|.
constexpr double MinCrossSine = 1e-10;
}

TriangleJudge::TriangleJudge(
  const SurfaceBlocks& blocks, const std::vector<MeshVertex>& vertices, NURBSSurface::Walker& walker)
  : Blocks(blocks)
  , Vertices(vertices)
  , Walker(walker)
{
}

bool TriangleJudge::IsCollapsed(const Corners& t) const
{
  for (int k = 0; k < 3; ++k)
  {
    const int a = this->Vertices[t[k]].Shared;
    if (a >= 0 && a == this->Vertices[t[(k + 1) % 3]].Shared)
    {
      return true;
    }
  }
  return false;
}

ParameterBox TriangleJudge::GetBox(const Corners& t) const
{
  ParameterBox box{ this->Vertices[t[0]].At, this->Vertices[t[0]].At };
  box.Add(this->Vertices[t[1]].At);
  box.Add(this->Vertices[t[2]].At);
  return box;
}

double TriangleJudge::GetError(const Corners& t) const
{
  return this->Blocks.GetError(this->GetBox(t));
}

double TriangleJudge::GetNormalTurn(const Corners& t, double enough) const
{
  const ParameterBox box = this->GetBox(t);
  double minimum = vtkMath::Pi();
  for (int k = 0; k < 3 && minimum > enough; ++k)
  {
    const MeshVertex& v = this->Vertices[t[k]];
    minimum = std::min(minimum, this->BoundTurn(box, 1.0, v.Derivatives[0], v.Derivatives[1]));
  }
  if (minimum > enough)
  {
    Vector3 position;
    Vector3 du;
    Vector3 dv;
    this->Walker.Evaluate(0.5 * (box.Low[0] + box.High[0]), 0.5 * (box.Low[1] + box.High[1]), position.data(),
      du.data(), dv.data());
    minimum = std::min(minimum, 2.0 * this->BoundTurn(box, 0.5, du, dv));
  }
  return minimum;
}

double TriangleJudge::BoundTurn(
  const ParameterBox& box, double share, const Vector3& du, const Vector3& dv) const
{
  const double speed[2] = { Norm(du), Norm(dv) };
  const Vector3 cross = Cross(du, dv);
  const double area = Norm(cross);
  // A cross product that is not above rounding has no direction.
  if (!(area > MinCrossSine * speed[0] * speed[1]))
  {
    return vtkMath::Pi();
  }
  const SurfaceBlocks::DerivativeChanges change =
    this->Blocks.GetDerivativeChanges(box, share, { cross[0] / area, cross[1] / area, cross[2] / area });
  const double along =
    area - change.Full[0] * speed[1] - change.Full[1] * speed[0] - change.Full[0] * change.Full[1];
  // The cross product is rounded, too.
  const double across = change.Along[1] * (speed[0] + change.Full[0]) +
    change.Along[0] * (speed[1] + change.Full[1]) + 8.0 * UnitRoundoff * speed[0] * speed[1];
  return along > 0.0 ? std::atan2(across, along) : vtkMath::Pi();
}

double TriangleJudge::GetGap(const Corners& t) const
{
  return std::max({ this->Vertices[t[0]].Gap, this->Vertices[t[1]].Gap, this->Vertices[t[2]].Gap });
}

double TriangleJudge::GetHeight(const Corners& t) const
{
  const Vector3& a = this->Vertices[t[0]].Position;
  const Vector3 sides[2] = { Subtract(this->Vertices[t[1]].Position, a),
    Subtract(this->Vertices[t[2]].Position, a) };
  return Norm(Cross(sides[0], sides[1])) /
    std::max({ Norm(sides[0]), Norm(sides[1]), Norm(Subtract(sides[0], sides[1])), 1e-300 });
}

bool TriangleJudge::IsAgainstCorners(const Corners& t) const
{
  const MeshVertex* v[3];
  Vector3 mean{ 0.0, 0.0, 0.0 };
  double longest = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    v[k] = &this->Vertices[t[k]];
    const Vector3 side = Subtract(v[k]->Position, this->Vertices[t[(k + 1) % 3]].Position);
    longest = std::max(longest, Dot(side, side));
    for (int c = 0; c < 3; ++c)
    {
      mean[c] += v[k]->Normal[c];
    }
  }
  const Vector3 normal =
    Cross(Subtract(v[1]->Position, v[0]->Position), Subtract(v[2]->Position, v[0]->Position));
  return Dot(normal, mean) < 0.0 && Norm(normal) > LineShare * longest;
}

bool TriangleJudge::IsInverted(const Corners& t) const
{
  return this->IsAgainst(
    { this->Vertices[t[0]].Position, this->Vertices[t[1]].Position, this->Vertices[t[2]].Position }, t);
}

bool TriangleJudge::IsFolded(const Corners& t) const
{
  std::array<Vector3, 3> onSurface;
  for (int k = 0; k < 3; ++k)
  {
    const MeshVertex& v = this->Vertices[t[k]];
    this->Walker.Evaluate(v.At[0], v.At[1], onSurface[k].data());
  }
  return this->IsAgainst(onSurface, t);
}

bool TriangleJudge::IsAgainst(const std::array<Vector3, 3>& corners, const Corners& t) const
{
  const MeshVertex* const v[3] = { &this->Vertices[t[0]], &this->Vertices[t[1]], &this->Vertices[t[2]] };
  const Vector3 sides[3] = { Subtract(corners[1], corners[0]), Subtract(corners[2], corners[0]),
    Subtract(corners[2], corners[1]) };
  const Vector3 normal = Cross(sides[0], sides[1]);
  const double size = Norm(normal);
  double longest = 0.0;
  bool isPlain = true;
  for (int k = 0; k < 3; ++k)
  {
    longest = std::max(longest, Dot(sides[k], sides[k]));
    isPlain = isPlain && Dot(normal, v[k]->Normal) > PlainCosine * size;
  }
  if (isPlain || !(size > LineShare * longest))
  {
    return false;
  }
  Vector3 du;
  Vector3 dv;
  this->EvaluateMiddle(t, du, dv);
  return Dot(normal, Cross(du, dv)) < 0.0;
}

std::array<double, 2> TriangleJudge::GetSpeeds(const Corners& t) const
{
  Vector3 du;
  Vector3 dv;
  this->EvaluateMiddle(t, du, dv);
  return { Norm(du), Norm(dv) };
}

void TriangleJudge::EvaluateMiddle(const Corners& t, Vector3& du, Vector3& dv) const
{
  double at[2];
  for (int d = 0; d < 2; ++d)
  {
    at[d] = (this->Vertices[t[0]].At[d] + this->Vertices[t[1]].At[d] + this->Vertices[t[2]].At[d]) / 3.0;
  }
  Vector3 position;
  this->Walker.Evaluate(at[0], at[1], position.data(), du.data(), dv.data());
}
}
