// TestSolidSection FOLDER MODE BACKEND: sections against closed forms, each value within its bound, and the
// bound within a tolerance of 1e-1 to 1e-12.
#include "smSectionTesting.h"

#include <cstdio>
#include <functional>

namespace
{
using namespace smtest;

constexpr double Tolerances[] = { 1e-1, 1e-3, 1e-6, 1e-9, 1e-12 };
constexpr int Entries[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 1, 2 }, { 0, 2 } };

/// A body to cut, and the exact values that its bounds are compared with.
struct Case
{
  std::string What;
  /// Size: the diameter of the body. Area: of its whole surface.
  Real Size;
  Real Area;
  Real Volume;
  /// How far the rounded numbers of the plane or of the file are from the exact ones, a length.
  Real Given = 0;
};

void CheckSection(
  const Case& body, const Cut& cut, const std::string& name, double tolerance, vtkSolidSection* filter)
{
  const Region& exact = cut.Section;
  const auto number = [](Real x) { return static_cast<double>(x); };
  const double size = number(body.Size);
  const double off = number(3 * body.Given * (cut.Slope + body.Size));
  const double bound = filter->GetSectionAreaBound();
  Check(name, number(exact.Area), filter->GetSectionArea(), bound + off + 2.3e-16 * number(exact.Area),
    "the bound");
  if (bound > 0)
  {
    std::printf("     %s: error / bound %.2g, bound / area %.2g\n", name.c_str(),
      std::abs(filter->GetSectionArea() - number(exact.Area)) / bound, bound / number(exact.Area));
  }
  // Twice: the scale of the area is rounded to a power of two. 3e-12: heights are rounded to some 1e-14, and
  // slopes and lengths at the plane are known within some factors.
  const double widest = 2.0 * tolerance * number(body.Area) +
    100.0 * number(body.Given * (cut.Slope + 4 * body.Size)) + 3e-12 * size * (size + number(cut.Slope));
  CheckRange(name + ", bound", 0.0, bound, widest);
  if (!(exact.Area > 3.0 * widest))
  {
    return;
  }
  const double part = (bound + off) / number(exact.Area);
  double centroid[3];
  filter->GetSectionCentroid(centroid);
  const double centroidBound = filter->GetSectionCentroidBound();
  const double reach = number(std::sqrt(Dot(exact.Centroid, exact.Centroid)));
  for (int c = 0; c < 3; ++c)
  {
    Check(name + ", centroid " + "xyz"[c], number(exact.Centroid[c]), centroid[c],
      centroidBound + 4.0 * size * off / number(exact.Area) + 10.0 * number(body.Given) + 1.2e-16 * reach,
      "the bound");
  }
  CheckRange(name + ", bound of the centroid", 0.0, centroidBound,
    20.0 * size * (part + tolerance * number(body.Area / exact.Area)) + 1e-14 * reach);
  double second[6];
  filter->GetSectionSecondMoments(second);
  const double secondBound = filter->GetSectionSecondMomentsBound();
  for (int i = 0; i < 6; ++i)
  {
    Check(name + ", second moment " + std::to_string(i), number(exact.Second[Entries[i][0]][Entries[i][1]]),
      second[i], secondBound + 4.0 * size * size * off, "the bound");
  }
  CheckRange(name + ", bound of the second moments", 0.0, secondBound,
    40.0 * size * size * (bound + off + tolerance * number(body.Area)) +
      1e-13 * size * size * number(exact.Area));
}

void CheckCuts(const Case& body, SectionScene& scene, const std::vector<Cut>& cuts)
{
  for (const double tolerance : Tolerances)
  {
    scene.Filter->SetRelativeTolerance(tolerance);
    vtkTypeInt64 evaluations = 0;
    double seconds = 0.0;
    for (const Cut& cut : cuts)
    {
      for (const int sense : { 1, -1 })
      {
        char label[40];
        std::snprintf(label, sizeof(label), "%s, %g", sense > 0 ? "" : ", from above", tolerance);
        const std::string name = body.What + ": " + cut.Name + label;
        scene.Set(cut.Point, Scaled(cut.Normal, sense));
        scene.Filter->Update();
        evaluations += scene.Filter->GetEvaluations();
        seconds += scene.Filter->GetPrepareSeconds() + scene.Filter->GetIntegrateSeconds();
        CheckSection(body, cut, name, tolerance, scene.Filter);
        const auto off = static_cast<double>(3 * body.Given * body.Area);
        Check(name + ", both sides", static_cast<double>(body.Volume),
          scene.Filter->GetVolumeBelow() + scene.Filter->GetVolumeAbove(),
          scene.Filter->GetVolumeBelowBound() + scene.Filter->GetVolumeAboveBound() + off, "the bounds");
        const double wide = static_cast<double>(body.Given * (cut.Slope + 4 * body.Size)) * 100.0;
        if (tolerance > 1e-10 && wide < tolerance * static_cast<double>(body.Area) &&
          40.0 * off < tolerance * static_cast<double>(body.Volume))
        {
          CheckEqual(name + ", status", "ok", scene.Filter->GetStatus());
          std::printf("%s", scene.Filter->GetStatus() == "ok" ? "" : GetMessages(scene.Filter).c_str());
        }
      }
    }
    std::printf("     %s, %g: %lld evaluations for %d planes, %.2g s\n", body.What.c_str(), tolerance,
      static_cast<long long>(evaluations), 2 * static_cast<int>(cuts.size()), seconds);
  }
}

std::string Name(const char* what, Real x)
{
  char name[60];
  std::snprintf(name, sizeof(name), "%s %g", what, static_cast<double>(x));
  return name;
}

/// A unit vector at right angles to n.
Vector Across(const Vector& n)
{
  return Unit(std::abs(n[0]) < Real(0.7) ? CrossProduct({ 1, 0, 0 }, n) : CrossProduct({ 0, 1, 0 }, n));
}

void CheckBoxes(const Manifest& manifest)
{
  const Vector sides = { 30, 20, 10 };
  std::vector<std::pair<Vector, Vector>> edges;
  for (int corner = 0; corner < 8; ++corner)
  {
    Vector a;
    for (int c = 0; c < 3; ++c)
    {
      a[c] = corner >> c & 1 ? sides[c] : 0;
    }
    for (int c = 0; c < 3; ++c)
    {
      if (a[c] == 0)
      {
        Vector b = a;
        b[c] = sides[c];
        edges.emplace_back(a, b);
      }
    }
  }
  std::vector<Cut> cuts;
  const auto add = [&](const std::string& name, const Vector& point, const Vector& normal) {
    cuts.push_back({ name, point, normal, ConvexSection(edges, point, Unit(normal)), 60 });
  };
  const Vector n = { 0.25L, 0.5L, 1 };
  for (const Real d : { -1.0L, 0.25L, 4.0L, 10.5L, 13.75L, 20.0L, 27.0L, 28.0L })
  {
    add(Name("tilted", d), { 0, 0, d }, n);
  }
  for (const double h : { 1e-6, 5.0, 7.25, 10.0 - 1e-6 })
  {
    add(Name("level", h), { 7, 7, h }, { 0, 0, 1 });
  }
  add("diagonal", { 15, 0, 5 }, { -1, 0, 3 });
  add("askew", { 11, 9, 4 }, { 3, -7, 2 });
  SectionScene scene(manifest.GetSolid("box", "plain")[0].Path);
  CheckCuts({ "box", 38, 2200, 6000 }, scene, cuts);
}

void CheckCylinders(const Manifest& manifest)
{
  const Real r = 8;
  std::vector<Cut> cuts;
  for (const Real slope : { 0.0L, 0.1L, 0.75L, 1.5L })
  {
    const Real secant = std::sqrt(1 + slope * slope);
    cuts.push_back({ Name("slope", slope), { 0, 0, 12.5L }, { slope, 0, 1 },
      Ellipse({ 0, 0, 12.5L }, r * secant, Scaled({ 1, 0, -slope }, 1 / secant), r, { 0, 1, 0 }), 100 });
  }
  for (const Real x : { 0.0L, 5.0L, -7.99L, 8.0L - 0x1p-20L })
  {
    const Real half = std::sqrt(r * r - x * x);
    cuts.push_back({ Name("upright", x), { x, 0, 0 }, { 1, 0, 0 },
      Symmetric({ x, 0, 12.5L }, 50 * half, 50 * half * half * half / 3, { 0, 1, 0 },
        half * 2 * 25 * 25 * 25 / 12, { 0, 0, 1 }),
      50 * std::abs(x) / half });
  }
  SectionScene scene(manifest.GetSolid("cylinder", "plain")[0].Path);
  CheckCuts({ "cylinder", 30, 2 * Pi * r * (r + 25), Pi * r * r * 25 }, scene, cuts);
}

void CheckBalls(const Manifest& manifest)
{
  for (const Expected& part : manifest.GetSolid("sphere"))
  {
    if (!part.HasPcurves || part.Variant == "reversed")
    {
      continue;
    }
    const Vector center = { part.Center[0], part.Center[1], part.Center[2] };
    const Real radius = std::cbrt(3 * static_cast<Real>(part.Volume) / (4 * Pi));
    std::vector<Cut> cuts;
    const std::pair<const char*, Vector> directions[] = { { "z", { 0, 0, 1 } }, { "x", { 1e-3L, 0, 0 } },
      { "askew", { 1, -2, 3 } }, { "nearly z", { 1e-5L, 2e-5L, 1 } } };
    for (const auto& [label, up] : directions)
    {
      for (const Real depth : { -1.5L, -0.9999L, -0.6L, 0.0L, 0.25L })
      {
        const Vector n = Unit(up);
        const Vector x = Across(n);
        const Real d = depth * radius;
        const Vector middle = Sum(center, Scaled(n, d));
        const Real small = std::abs(depth) < 1 ? std::sqrt(radius * radius - d * d) : 0;
        cuts.push_back({ Name(label, depth), middle, up, Ellipse(middle, small, x, small, CrossProduct(n, x)),
          2 * Pi * radius });
      }
    }
    SectionScene scene(part.Path);
    const Real given = 3e-16L * part.GetDistance() + 4e-16L * radius +
      static_cast<Real>(part.VolumeAccuracy) / (radius * radius);
    CheckCuts({ "sphere " + part.Variant, 2 * radius, 4 * Pi * radius * radius,
                4 * Pi / 3 * radius * radius * radius, given },
      scene, cuts);
  }
}

/// The cone of radius 12 at z = 0 with its tip at z = 20.
void CheckCones(const Manifest& manifest)
{
  const Real bottom = 12;
  const Real height = 20;
  std::vector<Cut> cuts;
  for (const Real z : { 1.0L, 10.0L, 19.999L })
  {
    const Real r = bottom * (1 - z / height);
    cuts.push_back({ Name("circle", z), { 1, 2, z }, { 0, 0, 1 },
      Ellipse({ 0, 0, z }, r, { 1, 0, 0 }, r, { 0, 1, 0 }), 100 });
  }
  // Through the axis: a triangle. Its second moments are base height^3 / 36 and height base^3 / 48.
  cuts.push_back({ "triangle", { 0, 0, 3 }, { 0, 1, 0 },
    Symmetric({ 0, 0, height / 3 }, bottom * height, height * std::pow(2 * bottom, Real(3)) / 48, { 1, 0, 0 },
      2 * bottom * height * height * height / 36, { 0, 0, 1 }),
    100 });
  // Parallel to a generator: a parabola of base 2 b and length l, with the area 4 b l / 3, the centroid at 2
  // l / 5 from the base, and the second moments 4 l b^3 / 15 across and 16 b l^3 / 175 along the axis.
  const Real k = 4;
  const Real b = std::sqrt(bottom * bottom - k * k);
  const Real generator = std::hypot(bottom, height);
  const Vector base = { k, 0, 0 };
  const Vector up = { bottom / generator, 0, height / generator };
  const Real l = generator * (bottom - k) / (2 * bottom);
  cuts.push_back({ "parabola", base, { height, 0, -bottom },
    Symmetric(Sum(base, Scaled(up, 2 * l / 5)), 4 * b * l / 3, 4 * l * b * b * b / 15, { 0, 1, 0 },
      16 * b * l * l * l / 175, up),
    200 });
  // Upright next to the axis: a hyperbola.
  for (const Real a : { 2.0L, 11.0L })
  {
    const auto half = [&](Real z)
    { return std::sqrt(std::max<Real>(std::pow(bottom * (1 - z / height), Real(2)) - a * a, 0)); };
    const Real top = height * (1 - a / bottom);
    // With z = top (1 - s^2) the root at the top is smooth, and Gauss' rule of two points on 4000 parts is
    // exact to 1e-14.
    Real area = 0;
    Real first = 0;
    Real second = 0;
    Real across = 0;
    constexpr int Parts = 4000;
    const Real node = 1 / std::sqrt(Real(3));
    for (int i = 0; i < Parts; ++i)
    {
      for (const Real side : { -node, node })
      {
        const Real s = (i + (1 + side) / 2) / Parts;
        const Real z = top * (1 - s * s);
        const Real weight = top * 2 * s / (2 * Parts);
        const Real y = half(z);
        area += weight * 2 * y;
        first += weight * 2 * y * z;
        second += weight * 2 * y * z * z;
        across += weight * 2 * y * y * y / 3;
      }
    }
    const Real closed =
      height / bottom * (bottom * std::sqrt(bottom * bottom - a * a) - a * a * std::acosh(bottom / a));
    Check("the area of a hyperbola, summed", static_cast<double>(closed), static_cast<double>(area),
      1e-13 * static_cast<double>(closed));
    const Real z = first / area;
    cuts.push_back({ Name("hyperbola", a), { a, 0, 0 }, { 1, 0, 0 },
      Symmetric({ a, 0, z }, closed, across, { 0, 1, 0 }, second - area * z * z, { 0, 0, 1 }), 400 });
  }
  cuts.push_back({ "beside", { 0, 0, 20.5L }, { 0.3L, 0.1L, 1 }, {}, 1 });
  SectionScene scene(manifest.GetSpecial("cone_tip").Path);
  CheckCuts(
    { "cone", 30, Pi * bottom * (bottom + generator), Pi * bottom * bottom * height / 3 }, scene, cuts);
}

/// Integral of f over [from, to], with roots or poles at the ends allowed: tanh-sinh rule.
Real Integrate(Real from, Real to, const std::function<Real(Real, Real, Real)>& f)
{
  // f gets the point and its distances from both ends, which the point itself rounds.
  const Real h = 1 / Real(64);
  Real sum = 0;
  for (int i = -64 * 4; i <= 64 * 4; ++i)
  {
    const Real t = i * h;
    const Real q = std::exp(-Pi * std::sinh(std::abs(t)));
    const Real near = (to - from) * q / (1 + q);
    const Real weight = h * (to - from) * Pi * std::cosh(t) * q / ((1 + q) * (1 + q));
    const Real x = t < 0 ? from + near : to - near;
    sum += weight * f(x, t < 0 ? near : to - from - near, t < 0 ? to - from - near : near);
  }
  return sum;
}

/// The section of the torus about z with x = a, |a| >= R - r: one piece, or two that touch.
Region Spiric(Real R, Real r, Real a)
{
  const Real to = R + r;
  // Half widths of z at the distance rho from the axis; y = sqrt(rho^2 - a^2).
  const auto integrate = [&](int y2, int z2)
  {
    return Integrate(a, to,
      [&](Real rho, Real left, Real right)
      {
        const Real half = std::sqrt(std::max<Real>((rho - R + r) * right, 0));
        const Real y = std::sqrt(left * (rho + a));
        if (y == 0)
        {
          return Real(0);
        }
        const Real inner = z2 ? 2 * half * half * half / 3 : 2 * half;
        return 2 * inner * (y2 ? y : 1 / y) * rho;
      });
  };
  return Symmetric({ a, 0, 0 }, integrate(0, 0), integrate(1, 0), { 0, 1, 0 }, integrate(0, 1), { 0, 0, 1 });
}

std::vector<Cut> MakeTorusCuts()
{
  const Real R = 20;
  const Real r = 6;
  std::vector<Cut> cuts;
  // 2^-20 below the circle that the plane of z = 6 touches.
  for (const Real z : { -5.9999L, -3.0L, 0.0L, 2.5L, 6.0L - 0x1p-20L, 7.0L })
  {
    const Real w = std::abs(z) < r ? std::sqrt(r * r - z * z) : 0;
    const Region outer = Ellipse({ 0, 0, z }, R + w, { 1, 0, 0 }, R + w, { 0, 1, 0 });
    const Region inner = Ellipse({ 0, 0, z }, R - w, { 1, 0, 0 }, R - w, { 0, 1, 0 });
    cuts.push_back({ Name("level", z), { 0, 0, z }, { 0, 0, 1 }, w > 0 ? Combine(outer, inner, -1) : Region(),
      w > 0 ? 8 * Pi * R * std::abs(z) / w : 0 });
  }
  const Region side = Ellipse({ 0, R, 0 }, r, { 0, 1, 0 }, r, { 0, 0, 1 });
  Region other = side;
  other.Centroid[1] = -R;
  cuts.push_back({ "through the axis", {}, { 1, 0, 0 }, Combine(side, other, 1), 100 });
  for (const Real a : { 14.5L, 20.0L, 25.0L })
  {
    cuts.push_back({ Name("next to the axis", a), { a, 0, 0 }, { 1, 0, 0 }, Spiric(R, r, a), 200 });
  }
  // Touching the inside, where the section crosses itself.
  cuts.push_back({ "touching the saddle", { 14, 0, 0 }, { 1, 0, 0 }, Spiric(R, r, 14), 2e4L });
  // Villarceau's circles: of radius R, with centres at +-r, and the lens of both is hollow.
  const Real sine = r / R;
  const Real cosine = std::sqrt(1 - sine * sine);
  const Vector u = { 0, 1, 0 };
  const Vector v = { cosine, 0, sine };
  const Real angle = std::acos(r / R);
  const Real lens = 2 * R * R * angle - 2 * r * std::sqrt(R * R - r * r);
  // Halves of the lens are segments of height R - r at the distance r from the centre of their circle.
  const Real chord = std::sqrt(R * R - r * r);
  const Real segment = lens / 2;
  const Real alongChord =
    R * R * R * R / 4 * (angle - std::sin(2 * angle) / 2 * (1 + 2 * std::sin(angle) * std::sin(angle) / 3));
  const Real acrossCenter =
    R * R * R * R / 4 * (angle - std::sin(2 * angle) / 2 * (1 - 2 * std::sin(angle) * std::sin(angle)));
  // About the chord: the segment's centroid is at 2 chord^3 / (3 segment) from the circle's centre.
  const Real far = 2 * chord * chord * chord / (3 * segment);
  const Real aboutChord = acrossCenter - segment * far * far + segment * (far - r) * (far - r);
  const Region lensRegion = Symmetric({}, lens, 2 * aboutChord, u, 2 * alongChord, v);
  Region both = Ellipse({ 0, r, 0 }, R, u, R, v);
  both = Combine(both, Ellipse({ 0, -r, 0 }, R, u, R, v), 1);
  both = Combine(Combine(both, lensRegion, -1), lensRegion, -1);
  cuts.push_back({ "Villarceau", {}, { -sine, 0, cosine }, both, 2e4L });
  return cuts;
}

const Case Torus = { "torus", 60, 4 * Pi* Pi * 20 * 6, 2 * Pi* Pi * 20 * 36 };

void CheckTori(const Manifest& manifest)
{
  SectionScene scene(manifest.GetSolid("torus", "plain")[0].Path);
  CheckCuts(Torus, scene, MakeTorusCuts());
}

/// A block 40 x 24 x 16 with a slanted hole, and a ball with a void.
void CheckHoles(const Manifest& manifest)
{
  std::vector<Cut> cuts;
  for (const Real z : { 0.5L, 8.0L, 15.0L })
  {
    const Region block =
      Symmetric({ 20, 12, z }, 960, 960 * Real(1600) / 12, { 1, 0, 0 }, 960 * Real(576) / 12, { 0, 1, 0 });
    cuts.push_back({ Name("hole at", z), { 3, 4, z }, { 0, 0, 1 },
      Combine(block, Ellipse({ 12 + 0.75L * z, 11, z }, 6.25L, { 1, 0, 0 }, 5, { 0, 1, 0 }), -1), 100 });
  }
  {
    SectionScene scene(manifest.GetSolid("slanted_hole", "plain")[0].Path);
    const Expected part = manifest.GetSolid("slanted_hole", "plain")[0];
    CheckCuts({ "block with a hole", 50, part.Area, part.Volume, 1e-13L }, scene, cuts);
  }
  cuts.clear();
  for (const Real z : { -9.0L, -6.0L, -1.5L, 0.0L, 4.0L })
  {
    const auto circle = [](Real x, Real y, Real at, Real square) {
      return Ellipse({ x, y, at }, std::sqrt(square), { 1, 0, 0 }, std::sqrt(square), { 0, 1, 0 });
    };
    const Real hole = 36 - (z + 1.5L) * (z + 1.5L);
    const Region outer = circle(0, 0, z, 100 - z * z);
    cuts.push_back({ Name("void at", z), { 0, 0, z }, { 0, 0, 1 },
      hole > 0 ? Combine(outer, circle(1, 2, z, hole), -1) : outer, 120 });
  }
  SectionScene scene(manifest.GetSolid("hollow_sphere", "plain")[0].Path);
  CheckCuts({ "hollow ball", 20, 4 * Pi * 136, 4 * Pi / 3 * (1000 - 216), 1e-14L }, scene, cuts);
}

/// Checks bodies whose placement mirrors, then rotates about y, x and z, then moves.
void CheckPlacements(const Manifest& manifest)
{
  const Real angle = 30 * Pi / 180;
  const Real c = std::cos(angle);
  const Real s = std::sin(angle);
  for (const bool mirror : { false, true })
  {
    for (const Real distance : { 0.0L, 1e5L })
    {
      const Vector move = Scaled({ 1, -0.2L, 3e-3L }, distance);
      const auto turn = [&](const Vector& v) -> Vector
      {
        const Vector m = { mirror ? -v[0] : v[0], v[1], v[2] };
        const Vector y = { c * m[0] + s * m[2], m[1], -s * m[0] + c * m[2] };
        const Vector x = { y[0], c * y[1] - s * y[2], s * y[1] + c * y[2] };
        return { c * x[0] - s * x[1], s * x[0] + c * x[1], x[2] };
      };
      std::vector<Cut> cuts = MakeTorusCuts();
      for (Cut& cut : cuts)
      {
        cut.Point = Sum(turn(cut.Point), move);
        cut.Normal = turn(cut.Normal);
        cut.Section.Centroid = Sum(turn(cut.Section.Centroid), move);
        // Rows, then columns.
        Tensor second = cut.Section.Second;
        for (int pass = 0; pass < 2; ++pass)
        {
          Tensor columns;
          for (int i = 0; i < 3; ++i)
          {
            const Vector row = turn(second[i]);
            for (int j = 0; j < 3; ++j)
            {
              columns[j][i] = row[j];
            }
          }
          second = columns;
        }
        cut.Section.Second = second;
      }
      SectionScene scene(manifest.GetSolid("torus", "plain")[0].Path);
      scene.Move->SetRotation(30, 30, 30);
      scene.Move->SetTranslation(
        static_cast<double>(move[0]), static_cast<double>(move[1]), static_cast<double>(move[2]));
      scene.Move->SetMirror(mirror ? vtkNURBSTransform::X : vtkNURBSTransform::NONE);
      Case body = Torus;
      body.What = std::string(mirror ? "mirrored torus" : "moved torus") + (distance > 0 ? " far away" : "");
      // The plane's point and direction and the matrix are rounded.
      body.Given = 1e-14L + 1.2e-15L * distance;
      CheckCuts(body, scene, cuts);
    }
  }
}
}

int TestSolidSection(int argc, char* argv[])
{
  return RunMode(argc, argv, "TestSolidSection",
    { { "boxes", CheckBoxes }, { "cylinders", CheckCylinders }, { "balls", CheckBalls },
      { "cones", CheckCones }, { "tori", CheckTori }, { "holes", CheckHoles },
      { "placements", CheckPlacements } });
}
