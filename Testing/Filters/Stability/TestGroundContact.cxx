// Minimum heights of random trimmed rational faces, against dense samples; hulls and margins against
// formulas.
#include "Detail/smGroundContact.h"
#include "Detail/smSupportPolygon.h"
#include "Detail/smTrimClassifier.h"
#include "smTesting.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

namespace
{
/// A face of 2 x 2 spans of degree 2 and 3 with random points and weights; trimmed by a blob of four arcs, or
/// not at all.
sm::FacePointer MakeFace(std::mt19937& random, bool trimmed)
{
  std::uniform_real_distribution<double> spread(-0.3, 0.3);
  std::uniform_real_distribution<double> weight(0.5, 2.0);
  auto face = std::make_shared<sm::Face>();
  face->Id = sm::NewId();
  sm::NURBSSurface& surface = face->Surface;
  surface.Degree[0] = 2;
  surface.Degree[1] = 3;
  surface.Rational = true;
  // The knot in v is a crease.
  surface.Knots[0] = { 0, 0, 0, 0.4, 1, 1, 1 };
  surface.Knots[1] = { 0, 0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1, 1 };
  surface.NumberOfControlPoints[0] = 4;
  surface.NumberOfControlPoints[1] = 7;
  for (int j = 0; j < 7; ++j)
  {
    for (int i = 0; i < 4; ++i)
    {
      const double w = weight(random);
      surface.ControlPoints.push_back({ w * (i / 3.0 + 0.3 * spread(random)),
        w * (j / 6.0 + 0.3 * spread(random)), w * spread(random), w });
    }
  }
  if (!trimmed)
  {
    return face;
  }
  sm::Loop loop;
  const double radius[4] = { 0.3 + 0.5 * spread(random), 0.3 + 0.5 * spread(random),
    0.3 + 0.5 * spread(random), 0.3 + 0.5 * spread(random) };
  for (int k = 0; k < 4; ++k)
  {
    const auto at = [&](int index, double scale)
    {
      const double angle = 0.5 * vtkMath::Pi() * index + 0.3;
      return std::array<double, 2>{ 0.5 + scale * std::cos(angle), 0.5 + scale * std::sin(angle) };
    };
    const std::array<double, 2> from = at(k, radius[k]);
    const std::array<double, 2> to = at(k + 1, radius[(k + 1) % 4]);
    const std::array<double, 2> arc[3] = { from,
      { 0.5 + 1.2 * (0.5 * (from[0] + to[0]) - 0.5) + 0.1 * spread(random),
        0.5 + 1.2 * (0.5 * (from[1] + to[1]) - 0.5) },
      to };
    auto edge = std::make_shared<sm::Edge>();
    edge->Id = sm::NewId();
    edge->FileId = k + 1;
    const std::array<double, 3> line[2] = { { 0, 0, 0 }, { 0, 0, 0 } };
    edge->Curve.Breaks = { 0.0 };
    edge->Curve.AppendPiece(1.0, line, 1);
    sm::Coedge coedge;
    coedge.Use = edge;
    coedge.Curve.Breaks = { 0.0 };
    coedge.Curve.AppendPiece(1.0, arc, 2);
    if (k > 0)
    {
      // The same doubles as the end of the arc before.
      coedge.Curve.Coefficients.front() = loop.Coedges.back().Curve.GetEndPoint();
    }
    loop.Coedges.push_back(coedge);
  }
  loop.Coedges.back().Curve.Coefficients.back() = loop.Coedges.front().Curve.GetStartPoint();
  face->Loops.push_back(loop);
  return face;
}

/// Decides by the crossings of a ray with chords of the arcs.
bool IsInside(const sm::Face& face, double u, double v)
{
  if (face.Loops.empty())
  {
    return true;
  }
  int winding = 0;
  const int cuts = 200;
  for (const sm::Coedge& coedge : face.Loops[0].Coedges)
  {
    std::array<double, 2> a = coedge.Curve.GetStartPoint();
    for (int i = 1; i <= cuts; ++i)
    {
      const std::array<double, 2> b =
        i == cuts ? coedge.Curve.GetEndPoint() : coedge.Curve.Evaluate(static_cast<double>(i) / cuts);
      if ((a[1] <= v) != (b[1] <= v) && a[0] + (b[0] - a[0]) * (v - a[1]) / (b[1] - a[1]) > u)
      {
        winding += b[1] > a[1] ? 1 : -1;
      }
      a = b;
    }
  }
  return winding != 0;
}

double GetHeightAt(const sm::Face& face, const sm::GroundFrame& frame, double u, double v)
{
  double p[3];
  face.Surface.Evaluate(u, v, p);
  return frame.Rows[2][0] * p[0] + frame.Rows[2][1] * p[1] + frame.Rows[2][2] * p[2];
}

void TestLowest()
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> slope(-0.4, 0.4);
  int interior = 0;
  for (int trial = 0; trial < 60; ++trial)
  {
    const sm::FacePointer face = MakeFace(random, trial % 4 != 0);
    sm::GroundFrame frame;
    // Not orthogonal, which heights do not mind.
    frame.Rows[2] = { slope(random) * (trial % 3), slope(random) * (trial % 3), 1.0 };
    sm::FacePanelsCache cache;
    std::vector<sm::CutFacePointer> cut;
    cache.Acquire({ face }, cut, {});
    sm::ContactSearch search;
    search.AddFace(cut[0], frame);
    const sm::HeightRange lowest = search.FindLowest();
    double inner = HUGE_VAL;
    const int n = 120;
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        const double u = static_cast<double>(i) / n;
        const double v = static_cast<double>(j) / n;
        if (IsInside(*face, u, v))
        {
          inner = std::min(inner, GetHeightAt(*face, frame, u, v));
        }
      }
    }
    double border = HUGE_VAL;
    for (const sm::Loop& loop : face->Loops)
    {
      for (const sm::Coedge& coedge : loop.Coedges)
      {
        for (int i = 0; i <= 1000; ++i)
        {
          const std::array<double, 2> c = coedge.Curve.Evaluate(i / 1000.0);
          border = std::min(border, GetHeightAt(*face, frame, c[0], c[1]));
        }
      }
    }
    interior += inner < border ? 1 : 0;
    const double sampled = std::min(inner, border);
    // Polygons of the samples' trim stray by 1e-6, over slopes of about 1.
    smtest::CheckRange("minimum height, trial " + std::to_string(trial), sampled - 2e-3, lowest.High,
      sampled + 1e-5, "between samples");
    smtest::CheckRange("enclosed", 0.0, lowest.High - lowest.Low, 1e-11, "two roundings");
    const sm::GroundContacts contacts = search.FindContacts(lowest.High + 1e-9);
    smtest::CheckTrue("touches somewhere", !contacts.Pieces.empty() && !contacts.Coarse);
  }
  smtest::CheckRange("some inside, some on the border", 10, interior, 50);
}

void TestPolygons()
{
  // A square with a duplicate corner, points on its sides and inside.
  std::vector<sm::Point2> points = { { 0, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 }, { 2, 1e-15 }, { 1, 0 }, { 1, 1 },
    { 2, 0.5 } };
  const sm::SupportPolygon square = sm::SupportPolygon::FromPoints(points, 1e-13);
  smtest::CheckEqual("corners", 4, static_cast<long long>(square.Corners.size()));
  smtest::Check("inside", 0.5, square.GetMargin({ 1.5, 1.0 }), 1e-15);
  smtest::Check("outside a side", -1.0, square.GetMargin({ 3.0, 1.0 }), 1e-15);
  smtest::Check("outside a corner", -5.0, square.GetMargin({ 5.0, 6.0 }), 1e-14);
  smtest::Check("on a side", 0.0, square.GetMargin({ 2.0, 1.2 }), 1e-15);
  smtest::Check(
    "support", 2.0 * std::sqrt(2.0), square.GetSupport({ std::sqrt(0.5), std::sqrt(0.5) }), 1e-15);
  const sm::SupportPolygon line =
    sm::SupportPolygon::FromPoints({ { 0, 0 }, { 1, 1e-14 }, { 2, -1e-14 }, { 3, 0 } }, 1e-13);
  smtest::CheckEqual("a sliver is a segment", 2, static_cast<long long>(line.Corners.size()));
  smtest::Check("distance from it", -1.0, line.GetMargin({ 1.0, -1.0 }), 1e-13);
  smtest::CheckEqual("a point", 1,
    static_cast<long long>(sm::SupportPolygon::FromPoints({ { 1, 1 }, { 1, 1 } }, 1e-13).Corners.size()));
  smtest::CheckTrue("nothing", sm::SupportPolygon::FromPoints({}, 1e-13).GetMargin({ 0, 0 }) < -1e300);
  // Corners that are dense compared with the merging tolerance are left out one by one, yet the hull stays
  // within four times that.
  std::vector<sm::Point2> circle;
  const int count = 100000;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / count;
    circle.push_back({ std::cos(angle), std::sin(angle) });
  }
  const double merge = 1e-6;
  const sm::SupportPolygon dense = sm::SupportPolygon::FromPoints(circle, merge);
  smtest::CheckRange("margin in a dense circle", 1.0 - 4.0 * merge - 1e-9, dense.GetMargin({ 0, 0 }), 1.0);
}

void TestRegion()
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int decided[3] = { 0, 0, 0 };
  for (int trial = 0; trial < 20; ++trial)
  {
    const sm::FacePointer face = MakeFace(random, true);
    const sm::TrimClassifier region(*face);
    for (int k = 0; k < 200; ++k)
    {
      const double u = unit(random);
      const double v = unit(random);
      const double width = 0.02 * unit(random);
      const sm::TrimSide side = region.Classify({ u, v }, { u + width, v + width });
      ++decided[static_cast<int>(side)];
      int inside = 0;
      for (int i = 0; i < 9; ++i)
      {
        inside += IsInside(*face, u + width * (i % 3) / 2.0, v + width * (i / 3) / 2.0) ? 1 : 0;
      }
      if ((side == sm::TrimSide::Inside && inside != 9) || (side == sm::TrimSide::Outside && inside != 0))
      {
        smtest::CheckTrue("box", false, std::to_string(u) + " " + std::to_string(v));
      }
    }
  }
  smtest::CheckTrue("boxes of all kinds", decided[0] > 500 && decided[1] > 500 && decided[2] > 50,
    std::to_string(decided[0]) + " " + std::to_string(decided[1]) + " " + std::to_string(decided[2]));
}
}

int TestGroundContact(int, char*[])
{
  TestPolygons();
  TestRegion();
  TestLowest();
  return smtest::Finish();
}
