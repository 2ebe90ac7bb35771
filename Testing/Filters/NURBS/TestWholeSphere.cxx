// Whole spheres are recognised with a proved error, whatever their place, direction and loops; other closed
// surfaces are not. Their grids are closed, on the sphere, and within the deviation that they state.
#include "smRoundFaces.h"
#include "smTesting.h"
#include "smWholeSphere.h"

#include <map>

namespace
{
using namespace smtest;

constexpr double Right = 1.5707963267948966;
const sm::Vector3 Center = { 3.0, -2.0, 5.0 };
constexpr double Radius = 1.25;

void CheckFound(const char* name, const sm::Face& face, bool inward)
{
  std::printf("--- %s\n", name);
  const sm::WholeSphere sphere = sm::FindWholeSphere(face);
  CheckTrue("is a sphere", static_cast<bool>(sphere));
  Check("radius", Radius, sphere.Radius, 1e-15 * 16.0, "rounding");
  Check("centre", 0.0, sm::GetDistance(Center, sphere.Center), 1e-15 * 16.0, "rounding");
  CheckTrue("its normals", sphere.Inward == inward);
  Check("volume", (inward ? -4.0 : 4.0) / 3.0 * vtkMath::Pi() * Radius * Radius * Radius,
    sphere.GetSignedVolume(), 1e-13, "rounding");
  double farthest = 0.0;
  for (int k = 0; k < 40000; ++k)
  {
    double at[2];
    for (int d = 0; d < 2; ++d)
    {
      const double x = std::fmod(k * (d == 0 ? 0.7548776662466927 : 0.5698402909980532), 1.0);
      at[d] = (1.0 - x) * face.Surface.GetDomainStart(d) + x * face.Surface.GetDomainEnd(d);
    }
    sm::Vector3 p;
    face.Surface.Evaluate(at[0], at[1], p.data());
    farthest = std::max(farthest, std::abs(sm::GetDistance(p, sphere.Center) - sphere.Radius));
  }
  CheckRange("distance of points", 0.0, farthest, sphere.Error + 1e-15 * 16.0, "the bound, and rounding");
  CheckRange("the bound", 0.0, sphere.Error, 1e-12, "not vacuous");
}

void CheckNotFound(const char* name, const sm::Face& face)
{
  CheckTrue(name, !sm::FindWholeSphere(face));
}

/// Adds a loop around the domain: straight trim curves through these corners, in units of the domain.
void AddLoop(sm::Face& face, const std::vector<std::array<double, 2>>& corners, std::size_t reversed = 99)
{
  sm::Loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    std::array<double, 2> ends[2] = { corners[i], corners[(i + 1) % corners.size()] };
    for (auto& end : ends)
    {
      for (int d = 0; d < 2; ++d)
      {
        end[d] = (1.0 - end[d]) * face.Surface.GetDomainStart(d) + end[d] * face.Surface.GetDomainEnd(d);
      }
    }
    sm::Coedge coedge;
    coedge.Use = std::make_shared<sm::Edge>();
    coedge.Reversed = i == reversed;
    if (coedge.Reversed)
    {
      std::swap(ends[0], ends[1]);
    }
    coedge.Curve.Breaks.push_back(0.0);
    coedge.Curve.AppendPiece(1.0, ends, 1);
    loop.Coedges.push_back(coedge);
  }
  face.Loops.push_back(loop);
}

void CheckLoops()
{
  const std::vector<std::array<double, 2>> around = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  auto face = MakeBall(Center, Radius);
  AddLoop(*face, around);
  CheckFound("with a loop around the domain", *face, false);
  face = MakeBall(Center, Radius);
  AddLoop(*face, around, 2);
  CheckFound("with a coedge against its edge", *face, false);
  face = MakeBall(Center, Radius);
  AddLoop(*face, { { 0, 0 }, { 0.5, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } });
  CheckFound("with a border of two coedges", *face, false);

  face = MakeBall(Center, Radius);
  AddLoop(*face, { around.rbegin(), around.rend() });
  CheckNotFound("a loop that runs clockwise", *face);
  face = MakeBall(Center, Radius);
  AddLoop(*face, around);
  AddLoop(*face, around);
  CheckNotFound("two loops around the domain", *face);
  face = MakeBall(Center, Radius);
  AddLoop(*face, { { 0, 0 }, { 1, 0 }, { 1, 0.5 }, { 0, 0.5 } });
  CheckNotFound("a half", *face);
  face = MakeBall(Center, Radius);
  AddLoop(*face, around);
  AddLoop(*face, { { 0.2, 0.2 }, { 0.2, 0.3 }, { 0.3, 0.3 }, { 0.3, 0.2 } });
  CheckNotFound("a hole", *face);
  face = MakeBall(Center, Radius);
  AddLoop(*face, { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 1e-6, 1 }, { 0, 0 } });
  CheckNotFound("a loop that leaves the border by a millionth", *face);
  // Borders of the right area whose ends do not meet.
  face = MakeBall(Center, Radius);
  AddLoop(*face, around);
  face->Loops[0].Coedges.erase(face->Loops[0].Coedges.begin() + 1);
  CheckNotFound("a loop that lacks a border", *face);
}

void CheckOthers()
{
  CheckNotFound("a torus", *MakeTorus(Center, 3.0, 1.0));
  CheckNotFound("half a sphere", *MakeRevolved(Center, 0.0, Radius, { 0.0, 4.0 * Right }, { 0.0, Right }));
  CheckNotFound("a lune", *MakeRevolved(Center, 0.0, Radius, { 0.0, 3.0 * Right }, { -Right, Right }));
  auto face = MakeBall(Center, Radius);
  for (auto& p : face->Surface.ControlPoints)
  {
    p[2] = Center[2] * p[3] + (1.0 + 1e-7) * (p[2] - Center[2] * p[3]);
  }
  CheckNotFound("an ellipsoid, longer by a ten millionth", *face);
  face = MakeBall(Center, Radius);
  face->Surface.ControlPoints[20][1] += 1e-8;
  CheckNotFound("a control point that is moved by 1e-8", *face);
  face = MakeBall(Center, Radius);
  face->Surface.ControlPoints[20][3] *= 1.0 + 1e-8;
  CheckNotFound("a weight that is changed by 1e-8", *face);

  // The surface runs around the sphere twice: only the area shows it.
  face = MakeRevolved(Center, 0.0, Radius, { 0.0, 8.0 * Right }, { -Right, Right });
  const sm::WholeSphere twice = sm::FindWholeSphere(*face);
  CheckTrue("twice around: on a sphere", static_cast<bool>(twice));
  const double area = twice.GetArea();
  const double volume = twice.GetSignedVolume();
  CheckTrue("covered once", sm::Covers(twice, area, 0.0, volume) && sm::Covers(twice, area, 0.0, -volume));
  CheckTrue("covered twice", !sm::Covers(twice, 2.0 * area, 0.0, 2.0 * volume));
  CheckTrue("covered three times, once back", !sm::Covers(twice, 3.0 * area, 0.0, volume));
  CheckTrue("covered and removed", !sm::Covers(twice, 2.0 * area, 0.0, 0.0));
  CheckTrue("a hundredth is folded", !sm::Covers(twice, 1.02 * area, 0.0, volume));
  CheckTrue("a loose tolerance", sm::Covers(twice, 1.02 * area, 0.05 * area, 0.9 * volume));
  CheckTrue("bounds that say nothing", !sm::Covers(twice, 1.5 * area, HUGE_VAL, volume));
  CheckTrue("not known", !sm::Covers(twice, std::nan(""), 0.0, volume));

  const std::vector<sm::WholeSphere> all =
    sm::FindWholeSpheres({ MakeTorus(Center, 3.0, 1.0), MakeBall(Center, Radius) });
  CheckTrue("of two faces the second", all.size() == 2 && !all[0] && all[1]);
  CheckTrue("of a torus none", sm::FindWholeSpheres({ MakeTorus(Center, 3.0, 1.0) }).empty());
}

void CheckGrid(const sm::Face& face, int steps)
{
  const sm::WholeSphere sphere = sm::FindWholeSphere(face);
  const sm::SphereGrid grid = sm::MakeSphereGrid(face, sphere, steps);
  std::printf("--- a grid of %zu triangles\n", grid.Triangles.size());
  CheckEqual("triangles", steps * (steps - 2), static_cast<long long>(grid.Triangles.size()));
  double volume = 0.0;
  double farthest = 0.0;
  double turn = 0.0;
  // Corners at the seam and at the poles are one.
  std::map<std::array<long long, 3>, int> corners;
  std::map<std::pair<int, int>, int> sides;
  const auto getCorner = [&](int i)
  {
    std::array<long long, 3> key;
    for (int d = 0; d < 3; ++d)
    {
      key[d] = std::llround(grid.Points[i][d] * 1e9);
    }
    return corners.emplace(key, static_cast<int>(corners.size())).first->second;
  };
  for (const auto& t : grid.Triangles)
  {
    const sm::Vector3& a = grid.Points[t[0]];
    const sm::Vector3 n = sm::Cross(sm::Subtract(grid.Points[t[1]], a), sm::Subtract(grid.Points[t[2]], a));
    volume += sm::Dot(sm::Subtract(a, sphere.Center), n) / 6.0;
    for (int k = 0; k < 3; ++k)
    {
      const int from = getCorner(t[k]);
      const int to = getCorner(t[(k + 1) % 3]);
      ++sides[{ from, to }];
      --sides[{ to, from }];
      turn = std::max(turn, std::acos(sm::Dot(grid.Normals[t[k]], grid.Normals[t[(k + 1) % 3]])));
      CheckTrue("wound as its normals", sm::Dot(n, grid.Normals[t[k]]) > 0.0);
    }
    for (int k = 0; k < 100; ++k)
    {
      const double x = std::fmod(0.5 + k * 0.7548776662466927, 1.0);
      const double y = std::fmod(0.5 + k * 0.5698402909980532, 1.0) * (1.0 - x);
      sm::Vector3 p;
      for (int d = 0; d < 3; ++d)
      {
        p[d] = x * grid.Points[t[1]][d] + y * grid.Points[t[2]][d] + (1.0 - x - y) * a[d];
      }
      farthest = std::max(farthest, std::abs(sm::GetDistance(p, sphere.Center) - sphere.Radius));
    }
  }
  CheckTrue("it is closed",
    std::all_of(sides.begin(), sides.end(), [](const auto& side) { return side.second == 0; }));
  CheckRange("distance / stated", 0.8, farthest / grid.Deviation, 1.0);
  CheckRange("turn of the normal / stated", 0.8, turn / grid.NormalTurn, 1.0);
  CheckRange("volume / that of the sphere", 1.0 - 4.0 * grid.Deviation / Radius,
    volume / sphere.GetSignedVolume(), 1.0, "within the sphere, by the deviation");
}
}

int TestWholeSphere(int, char*[])
{
  CheckFound("a ball", *MakeBall(Center, Radius), false);
  CheckFound("a void", *MakeBall(Center, Radius, false), true);
  auto face = MakeBall(Center, Radius);
  face->Surface = face->Surface.Transposed();
  CheckFound("u and v exchanged", *face, true);
  CheckGrid(*face, 16);
  CheckLoops();
  CheckOthers();
  for (const int steps : { 8, 16, 48 })
  {
    CheckGrid(*MakeBall(Center, Radius), steps);
    CheckGrid(*MakeBall(Center, Radius, false), steps);
  }
  return Finish();
}
