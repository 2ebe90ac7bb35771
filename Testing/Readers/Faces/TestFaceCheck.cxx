// Faces against statements about them: each kind of fault that the table of smFaceCheck.h names is found, and
// by what it says.
#include "smFaceCheck.h"
#include "smFacePieces.h"
#include "smSpaceCurve.h"
#include "smTesting.h"

#include <cmath>

namespace
{
using Point = sm::TrimCurve::Point;

constexpr double Pi = 3.14159265358979323846;
constexpr double Radius = 2.0;
constexpr double Height = 3.0;

/// A profile of points (distance from z, height) with weights, revolved about z by `quarters` quarters.
sm::NURBSSurface Revolve(const std::vector<std::array<double, 3>>& profile, const std::vector<double>& knots,
  int degree, int quarters)
{
  sm::NURBSSurface surface;
  surface.Degree[0] = 2;
  surface.Degree[1] = degree;
  surface.NumberOfControlPoints[0] = 2 * quarters + 1;
  surface.NumberOfControlPoints[1] = static_cast<int>(profile.size());
  surface.Knots[0] = { 0.0, 0.0, 0.0 };
  for (int k = 1; k <= quarters; ++k)
  {
    surface.Knots[0].insert(surface.Knots[0].end(), 2, k);
  }
  surface.Knots[0].push_back(quarters);
  surface.Knots[1] = knots;
  for (const auto& [radius, z, weight] : profile)
  {
    for (int i = 0; i <= 2 * quarters; ++i)
    {
      const double own = i % 2 == 0 ? 1.0 : std::sqrt(0.5);
      const double length = i % 2 == 0 ? radius : radius * std::sqrt(2.0);
      const double w = own * weight;
      surface.ControlPoints.push_back(
        { w * length * std::cos(0.25 * Pi * i), w * length * std::sin(0.25 * Pi * i), w * z, w });
    }
  }
  surface.Rational = true;
  return surface;
}

sm::NURBSSurface MakeCylinder(int quarters)
{
  return Revolve({ { Radius, 0.0, 1.0 }, { Radius, Height, 1.0 } }, { 0, 0, 1, 1 }, 1, quarters);
}

/// A sphere: v = 0 at the south pole, 1 at the equator, 2 at the north pole.
sm::NURBSSurface MakeSphere()
{
  const double w = std::sqrt(0.5);
  return Revolve({ { 0.0, -Radius, 1.0 }, { Radius, -Radius, w }, { Radius, 0.0, 1.0 }, { Radius, Radius, w },
                   { 0.0, Radius, 1.0 } },
    { 0, 0, 0, 1, 1, 2, 2, 2 }, 2, 4);
}

sm::NURBSSurface MakePlane()
{
  sm::NURBSSurface surface;
  for (int d = 0; d < 2; ++d)
  {
    surface.Knots[d] = { 0.0, 0.0, 1.0, 1.0 };
    surface.NumberOfControlPoints[d] = 2;
  }
  for (int i = 0; i < 4; ++i)
  {
    surface.ControlPoints.push_back({ i % 2 * 1.0, i / 2 * 1.0, 0.0, 1.0 });
  }
  return surface;
}

/// Adds a loop of straight pieces in (u,v). The edges are the images of `edges`, in chords of 1/64 of each
/// piece, wider by `gap` of their distance from z.
void AddLoop(
  sm::Face& face, const std::vector<Point>& corners, const std::vector<Point>& edges, double gap = 0.0)
{
  sm::Loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    sm::Coedge coedge;
    coedge.Curve.Breaks.push_back(0.0);
    const Point ends[2] = { corners[i], corners[(i + 1) % corners.size()] };
    coedge.Curve.AppendPiece(1.0, ends, 1);
    auto edge = std::make_shared<sm::Edge>();
    edge->Curve.Breaks.push_back(0.0);
    const Point& from = edges[i % edges.size()];
    const Point& to = edges[(i + 1) % edges.size()];
    sm::Vector3 chord[2];
    for (int k = 0; k <= 64; ++k)
    {
      const double x = k / 64.0;
      chord[0] = chord[1];
      face.Surface.Evaluate(
        (1.0 - x) * from[0] + x * to[0], (1.0 - x) * from[1] + x * to[1], chord[1].data());
      chord[1][0] *= 1.0 + gap;
      chord[1][1] *= 1.0 + gap;
      if (k > 0)
      {
        edge->Curve.AppendPiece(x, chord, 1);
      }
    }
    edge->StartVertex = edge->Curve.GetStartPoint();
    edge->EndVertex = edge->Curve.GetEndPoint();
    coedge.Use = edge;
    loop.Coedges.push_back(coedge);
  }
  face.Loops.push_back(loop);
}

sm::Face MakeFace(const sm::NURBSSurface& surface, const std::vector<Point>& corners)
{
  sm::Face face;
  face.Surface = surface;
  AddLoop(face, corners, corners);
  return face;
}

void AddCircle(double radius, double z, double sign, sm::FaceStatement& statement)
{
  sm::SpaceCurve circle;
  circle.Kind = sm::SpaceCurve::Type::Ellipse;
  circle.Origin = { 0.0, 0.0, z };
  circle.Axes[0] = { 1.0, 0.0, 0.0 };
  circle.Axes[1] = { 0.0, 1.0, 0.0 };
  circle.Radii[0] = circle.Radii[1] = radius;
  const sm::Vector3 vertex{ radius, 0.0, z };
  sm::LineIntegrals edge;
  sm::IntegrateEdge(circle, vertex, vertex, true, edge);
  statement.Boundary.Add(edge, sm::Subtract(vertex, statement.Center), sign);
  statement.IsKnown = true;
}

/// The lateral face of a cylinder, with the normal outwards: the lower circle forwards, the upper one
/// backwards.
sm::FaceStatement StateCylinder()
{
  sm::FaceStatement statement;
  statement.Center = { 0.3, -0.2, 1.0 };
  AddCircle(Radius, 0.0, 1.0, statement);
  AddCircle(Radius, Height, -1.0, statement);
  return statement;
}

sm::FaceStatement StatePolygon(const std::vector<sm::Vector3>& points)
{
  sm::FaceStatement statement;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    statement.Boundary.AddSegment(points[i], points[(i + 1) % points.size()]);
  }
  statement.IsKnown = true;
  return statement;
}

sm::FaceFinding Check(const sm::Face& face, const sm::FaceStatement& statement,
  const sm::StatementPlace& place = sm::StatementPlace())
{
  return sm::CheckFace({ &face }, statement, place);
}

void CheckVerdict(const std::string& what, sm::FaceVerdict expected, const sm::FaceFinding& finding)
{
  smtest::CheckEqual(what, static_cast<long long>(expected), static_cast<long long>(finding.Verdict));
}

void TestCylinder()
{
  const sm::FaceStatement statement = StateCylinder();
  const sm::NURBSSurface surface = MakeCylinder(8);
  const sm::Face whole = MakeFace(surface, { { 0, 0 }, { 4, 0 }, { 4, 1 }, { 0, 1 } });
  sm::FaceFinding finding = Check(whole, statement);
  CheckVerdict("lateral face", sm::FaceVerdict::Agrees, finding);
  smtest::Check("its moments", 0.0, finding.MomentDifference, 1e-5, "five points for each quarter");

  sm::FaceStatement reversed = statement;
  reversed.IsForward = false;
  CheckVerdict("with the other sense", sm::FaceVerdict::Reversed, Check(whole, reversed));
  CheckVerdict("with its loop reversed", sm::FaceVerdict::Reversed,
    Check(MakeFace(surface, { { 0, 1 }, { 4, 1 }, { 4, 0 }, { 0, 0 } }), statement));
  sm::FaceStatement unknown = statement;
  unknown.IsKnown = false;
  CheckVerdict("without a statement", sm::FaceVerdict::Unknown, Check(whole, unknown));

  // Nothing, and twice: only the moments differ, by the diagonal (1, 1, -2) / 3 of pi r^2 h.
  const std::vector<Point> edges{ { 0, 0 }, { 4, 0 }, { 4, 1 }, { 0, 1 } };
  for (const double turns : { 0.0, 2.0 })
  {
    sm::Face face;
    face.Surface = surface;
    AddLoop(face, { { 0, 0 }, { 4 * turns, 0 }, { 4 * turns, 1 }, { 0, 1 } }, edges);
    finding = Check(face, statement);
    CheckVerdict(turns > 0.0 ? "twice the face" : "no area", sm::FaceVerdict::Differs, finding);
    smtest::Check("its vector area", 0.0, finding.AreaDifference, 1e-5, "five points for each quarter");
    smtest::Check("its moments", Pi * Radius * Radius * Height * std::sqrt(6.0) / 3.0,
      finding.MomentDifference, 1e-5, "five points for each quarter");
  }
  sm::Face half;
  half.Surface = surface;
  AddLoop(half, { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 0, 1 } }, edges);
  finding = Check(half, statement);
  CheckVerdict("half of the face", sm::FaceVerdict::Differs, finding);
  smtest::Check(
    "its vector area", 2.0 * Radius * Height, finding.AreaDifference, 1e-5, "five points for each quarter");

  // In inches, rotated, moved, and mirrored.
  for (const double mirror : { 1.0, -1.0 })
  {
    const double s = 1.0 / 25.4;
    sm::StatementPlace place;
    place.Linear = { sm::Vector3{ 0.0, -s, 0.0 }, sm::Vector3{ mirror * s, 0.0, 0.0 },
      sm::Vector3{ 0.0, 0.0, s } };
    place.Shift = { 7.0, -1.0, 0.25 };
    sm::Face placed = whole;
    sm::Face part = MakeFace(surface, { { 0, 0 }, { 3, 0 }, { 3, 1 }, { 0, 1 } });
    for (sm::Face* face : { &placed, &part })
    {
      for (auto& p : face->Surface.ControlPoints)
      {
        const sm::Vector3 old{ p[0], p[1], p[2] };
        for (int i = 0; i < 3; ++i)
        {
          p[i] = sm::Dot(place.Linear[i], old) + place.Shift[i] * p[3];
        }
      }
      for (sm::Coedge& coedge : face->Loops[0].Coedges)
      {
        auto edge = std::make_shared<sm::Edge>(*coedge.Use);
        for (auto& p : edge->Curve.Coefficients)
        {
          const sm::Vector3 old = p;
          for (int i = 0; i < 3; ++i)
          {
            p[i] = sm::Dot(place.Linear[i], old) + place.Shift[i];
          }
        }
        edge->StartVertex = edge->Curve.GetStartPoint();
        edge->EndVertex = edge->Curve.GetEndPoint();
        coedge.Use = edge;
      }
    }
    CheckVerdict("placed", sm::FaceVerdict::Agrees, Check(placed, statement, place));
    CheckVerdict("placed, three quarters", sm::FaceVerdict::Differs, Check(part, statement, place));
  }

  // Edges off the surface are a gap, as real files have.
  constexpr double gap = 1e-3;
  sm::FaceStatement wide;
  AddCircle(Radius * (1.0 + gap), 0.0, 1.0, wide);
  AddCircle(Radius * (1.0 + gap), Height, -1.0, wide);
  CheckVerdict("edges that are not near", sm::FaceVerdict::Differs, Check(whole, wide));
  sm::Face near;
  near.Surface = surface;
  AddLoop(near, edges, edges, gap);
  CheckVerdict("edges off the surface", sm::FaceVerdict::Agrees, Check(near, wide));

  // Two halves of a face that a repair has cut.
  const sm::Face first = MakeFace(surface, { { 0, 0 }, { 1.5, 0 }, { 1.5, 1 }, { 0, 1 } });
  const sm::Face second = MakeFace(surface, { { 1.5, 0 }, { 4, 0 }, { 4, 1 }, { 1.5, 1 } });
  CheckVerdict("in two parts", sm::FaceVerdict::Agrees, sm::CheckFace({ &first, &second }, statement, {}));
  CheckVerdict("of which one is lost", sm::FaceVerdict::Differs, sm::CheckFace({ &second }, statement, {}));
}

void TestSphere()
{
  const sm::NURBSSurface surface = MakeSphere();
  // The parallel at v = 1.5: a quarter of Bezier's arc has equal angles at equal distances from its ends.
  const double ring = Radius * std::sqrt(0.5);
  sm::FaceStatement cap;
  AddCircle(ring, ring, 1.0, cap);
  CheckVerdict("cap", sm::FaceVerdict::Agrees,
    Check(MakeFace(surface, { { 0, 1.5 }, { 4, 1.5 }, { 4, 2 }, { 0, 2 } }), cap));
  const sm::FaceFinding rest = Check(MakeFace(surface, { { 0, 0 }, { 4, 0 }, { 4, 1.5 }, { 0, 1.5 } }), cap);
  CheckVerdict("the rest instead", sm::FaceVerdict::Reversed, rest);
  smtest::Check(
    "its vector area", 2.0 * Pi * ring * ring, rest.AreaDifference, 1e-5, "five points for each quarter");

  sm::FaceStatement zone;
  AddCircle(ring, -ring, 1.0, zone);
  AddCircle(ring, ring, -1.0, zone);
  CheckVerdict("zone", sm::FaceVerdict::Agrees,
    Check(MakeFace(surface, { { 0, 0.5 }, { 4, 0.5 }, { 4, 1.5 }, { 0, 1.5 } }), zone));
  sm::Face caps = MakeFace(surface, { { 0, 1.5 }, { 4, 1.5 }, { 4, 2 }, { 0, 2 } });
  AddLoop(
    caps, { { 0, 0 }, { 4, 0 }, { 4, 0.5 }, { 0, 0.5 } }, { { 0, 0 }, { 4, 0 }, { 4, 0.5 }, { 0, 0.5 } });
  const sm::FaceFinding both = Check(caps, zone);
  CheckVerdict("two caps instead", sm::FaceVerdict::Reversed, both);
  smtest::Check("their vector area", 0.0, both.AreaDifference, 1e-5, "it is 0 for both");

  sm::FaceStatement nothing;
  nothing.IsKnown = true;
  sm::Face whole;
  whole.Surface = surface;
  CheckVerdict("whole sphere", sm::FaceVerdict::Agrees, Check(whole, nothing));
  CheckVerdict("a cap of a sphere without edges", sm::FaceVerdict::Differs,
    Check(MakeFace(surface, { { 0, 1.5 }, { 4, 1.5 }, { 4, 2 }, { 0, 2 } }), nothing));
}

/// A torus about z: v = 0 .. 4 goes round its circle from the outermost point on.
sm::NURBSSurface MakeTorus(double major, double minor)
{
  std::vector<std::array<double, 3>> profile;
  for (int i = 0; i <= 8; ++i)
  {
    const double length = i % 2 == 0 ? minor : minor * std::sqrt(2.0);
    profile.push_back({ major + length * std::cos(0.25 * Pi * i), length * std::sin(0.25 * Pi * i),
      i % 2 == 0 ? 1.0 : std::sqrt(0.5) });
  }
  return Revolve(profile, { 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4 }, 2, 4);
}

void TestPieces()
{
  const sm::NURBSSurface sphere = MakeSphere();
  sm::Face caps = MakeFace(sphere, { { 0, 1.5 }, { 4, 1.5 }, { 4, 2 }, { 0, 2 } });
  smtest::CheckEqual("pieces of a cap", 1LL, static_cast<long long>(sm::CountOuterLoops(caps)));
  const std::vector<Point> south{ { 0, 0 }, { 4, 0 }, { 4, 0.5 }, { 0, 0.5 } };
  AddLoop(caps, south, south);
  smtest::CheckEqual("pieces of two caps", 2LL, static_cast<long long>(sm::CountOuterLoops(caps)));
  sm::Face holed = MakeFace(sphere, { { 0, 0.5 }, { 4, 0.5 }, { 4, 1.5 }, { 0, 1.5 } });
  const std::vector<Point> hole{ { 1, 1 }, { 1, 1.2 }, { 2, 1.2 }, { 2, 1 } };
  AddLoop(holed, hole, hole);
  smtest::CheckEqual("pieces of a zone with a hole", 1LL, static_cast<long long>(sm::CountOuterLoops(holed)));
  // A diagonal slit as wide as rounding has no direction.
  const std::vector<Point> slit{ { 0, 0 }, { 1, 1 }, { 0.5, 0.5 + 1e-9 } };
  sm::Face narrow = MakeFace(sphere, { { 0, 0.5 }, { 4, 0.5 }, { 4, 1.5 }, { 0, 1.5 } });
  AddLoop(narrow, slit, slit);
  smtest::CheckEqual(
    "pieces of a zone with a slit", 1LL, static_cast<long long>(sm::CountOuterLoops(narrow)));

  // With the radii 1 and 2 the circle meets the axis at 2 pi / 3: v = 4 / 3.
  const sm::NURBSSurface surface = MakeTorus(1.0, 2.0);
  sm::SpindleTorus torus;
  torus.Axis = { 0.0, 0.0, 1.0 };
  torus.Major = 1.0;
  torus.Minor = 2.0;
  const auto isOnBoth = [&](double from, double to)
  {
    return sm::IsOnBothParts(
      MakeFace(surface, { { 0, from }, { 1, from }, { 1, to }, { 0, to } }), torus, sm::StatementPlace());
  };
  smtest::CheckTrue("the outer part of a torus", !isOnBoth(0.0, 1.0));
  smtest::CheckTrue("the inner part of a torus", !isOnBoth(1.6, 2.4));
  smtest::CheckTrue("both parts of a torus", isOnBoth(0.0, 4.0));
  smtest::CheckTrue("across the axis", isOnBoth(1.0, 2.0));
}

void TestPolygons()
{
  const sm::NURBSSurface surface = MakePlane();
  const sm::FaceStatement square = StatePolygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } });
  const std::vector<Point> corners{ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  const sm::Face face = MakeFace(surface, corners);
  CheckVerdict("square", sm::FaceVerdict::Agrees, Check(face, square));
  const sm::FaceFinding lost = Check(MakeFace(surface, { { 0, 0 }, { 1, 0 }, { 1, 1 } }), square);
  CheckVerdict("square without a side", sm::FaceVerdict::Differs, lost);
  smtest::Check("its vector area", 0.5, lost.AreaDifference, 1e-12);
  sm::Face twice = face;
  AddLoop(
    twice, { { 0.25, 0.25 }, { 0.5, 0.25 }, { 0.5, 0.5 } }, { { 0.25, 0.25 }, { 0.5, 0.25 }, { 0.5, 0.5 } });
  CheckVerdict("square with an additional loop", sm::FaceVerdict::Differs, Check(twice, square));

  // A loop that lies off its edges on the surface is not a gap.
  sm::Face narrow;
  narrow.Surface = surface;
  AddLoop(narrow, { { 0, 0 }, { 0.9, 0 }, { 0.9, 1 }, { 0, 1 } }, corners);
  CheckVerdict("a loop off its edges", sm::FaceVerdict::Differs, Check(narrow, square));
  sm::Face broken = face;
  broken.Surface.ControlPoints[0][0] = std::nan("");
  CheckVerdict("numbers that are none", sm::FaceVerdict::Differs, Check(broken, square));
}
}

int TestFaceCheck(int, char*[])
{
  TestCylinder();
  TestSphere();
  TestPieces();
  TestPolygons();
  return smtest::Finish();
}
