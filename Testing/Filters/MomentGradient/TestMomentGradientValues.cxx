// Gradients by control points and weights against closed forms: a ball by its radius and as an ellipsoid, a
// torus by both radii, a box by its sides, a conic cylinder by its weight. Each within its bound, and the
// bound within the tolerance. With `opengl` by compute shaders.
#include "smBoxBodies.h"
#include "smGradientSums.h"
#include "smMomentGradient.h"
#include "smRoundFaces.h"
#include "smSubnormals.h"

#include <vtkMatrix4x4.h>
#include <vtkNURBSDataSet.h>

#include <map>

namespace
{
using namespace smtest;
using Names = std::map<std::string, double>;

constexpr double Pi = 3.14159265358979323846;

/// Checks the derivatives of quantities in a direction; `size` scales the largest bound that is accepted, by
/// the quantity's power of the length unit.
template <class Direction>
void CheckDirection(const std::string& what, const sm::MomentGradientResult& result, const Names& expected,
  double size, const Direction& direction)
{
  for (const auto& [name, value] : expected)
  {
    const int q = FindQuantity(name);
    const GradientSum sum = SumOverPoints(result, q, direction);
    const double scale = std::pow(size, sm::GetGradientQuantities()[q].LengthPower - 1);
    Check(what + " " + name, value, static_cast<double>(sum.Value), sum.Bound + 4e-16 * std::abs(value),
      "the bound");
    CheckRange(
      what + " " + name + " bound", 0.0, sum.Bound, 1e-7 * scale, "tolerance 1e-9, a hundred points");
  }
}

sm::MomentGradientResult Compute(
  vtkNURBSDataSet* leaf, bool tied, const std::vector<int>& faces = {}, const char* status = "ok")
{
  sm::MomentGradientOptions options;
  options.Tied = tied;
  options.Faces = faces;
  const sm::MomentGradientResult result = ComputeGradient(leaf, options);
  CheckEqual("status", status, result.Status);
  if (result.Status != status)
  {
    std::printf("     %s\n", result.Reason.c_str());
  }
  return result;
}

void CheckBall()
{
  const sm::Vector3 center{ 1.5, -2.0, 3.0 };
  const double r = 2.0;
  const auto ball = MakeRoundBody({ MakeBall(center, r) });
  const double area = 4.0 * Pi * r * r;
  const double volume = area * r / 3.0;
  for (const bool tied : { false, true })
  {
    std::printf("--- ball, %s\n", tied ? "tied" : "separate");
    const sm::MomentGradientResult result = Compute(ball, tied);
    CheckDirection("radius", result,
      { { "Volume", area }, { "FirstMoment_X", area * 1.5 }, { "FirstMoment_Y", area * -2.0 },
        { "FirstMoment_Z", area * 3.0 }, { "SecondMoment_XX", area * 2.25 + area * r * r / 3.0 },
        { "SecondMoment_YZ", area * -6.0 }, { "CenterOfMass_X", 0.0 }, { "CenterOfMass_Y", 0.0 },
        { "CenterOfMass_Z", 0.0 }, { "Inertia_XX", 8.0 / 3.0 * Pi * r * r * r * r },
        { "Inertia_ZZ", 8.0 / 3.0 * Pi * r * r * r * r }, { "Inertia_XY", 0.0 } },
      4.0,
      [&](const auto&, const std::array<double, 4>& p) -> std::array<double, 3> {
        return { (p[0] - center[0]) / r, (p[1] - center[1]) / r, (p[2] - center[2]) / r };
      });
    // The semi-axis a along x of the ellipsoid: V = 4/3 pi a b c, C_xx = V a^2 / 5.
    CheckDirection("semi-axis", result,
      { { "Volume", volume / r }, { "CenterOfMass_X", 0.0 }, { "Inertia_XX", 2.0 * volume * r / 5.0 },
        { "Inertia_YY", 4.0 * volume * r / 5.0 }, { "Inertia_ZZ", 4.0 * volume * r / 5.0 },
        { "Inertia_XZ", 0.0 } },
      4.0,
      [&](const auto&, const std::array<double, 4>& p) -> std::array<double, 3> {
        return { (p[0] - center[0]) / r, 0.0, 0.0 };
      });
    const GradientSum grown = SumOverPoints(result, FindQuantity("SurfaceArea"),
      [&](const auto&, const std::array<double, 4>& p) -> std::array<double, 3> {
        return { (p[0] - center[0]) / r, (p[1] - center[1]) / r, (p[2] - center[2]) / r };
      });
    // The rows of the poles are points except for the rounding of cos(90 degrees): what is left next to them,
    // 2^-24 of a panel, has the bound of the largest values.
    const double deviation = std::abs(static_cast<double>(grown.Value) - 8.0 * Pi * r);
    CheckRange("radius SurfaceArea", 0.0, deviation, std::min(1e-9 * area, grown.Bound), "the tolerance");
    CheckRange("radius SurfaceArea bound", 0.0, grown.Bound, 1.5e-4 * area);
    const sm::FaceMomentGradient& face = result.Faces[0];
    bool isUnknown = true;
    for (int k = 1; k <= 3; ++k)
    {
      const std::size_t at = face.GetIndex(1, 1, 0, FindQuantity("PrincipalMoment_" + std::to_string(k)));
      isUnknown = isUnknown && std::isnan(face.Values[at]) && std::isnan(face.Bounds[at]);
    }
    CheckTrue("principal moments coincide: NaN", isUnknown);
    CheckTrue("with a reason",
      !result.Messages.empty() && result.Messages.back().find("coincide") != std::string::npos,
      result.Messages.empty() ? "" : result.Messages.back());
    std::set<std::int64_t> points(face.PointVariables.begin(), face.PointVariables.end());
    std::set<std::int64_t> weights(face.WeightVariables.begin(), face.WeightVariables.end());
    // 9 columns of 5 points, of which the first and the last are one; two poles.
    CheckEqual("variables", tied ? 8 * 3 + 2 : 45, static_cast<long long>(points.size()));
    CheckEqual("weights", tied ? 40 : 45, static_cast<long long>(weights.size()));
  }
}

void CheckTorus()
{
  const sm::Vector3 center{ -1.0, 4.0, 2.0 };
  const double ring = 3.0;
  const double tube = 1.25;
  const auto torus = MakeRoundBody({ MakeTorus(center, ring, tube) });
  for (const bool tied : { false, true })
  {
    std::printf("--- torus, %s\n", tied ? "tied" : "separate");
    const sm::MomentGradientResult result = Compute(torus, tied);
    const auto radial = [&](const std::array<double, 4>& p) {
      return std::array<double, 2>{ p[0] - center[0], p[1] - center[1] };
    };
    // The net around the axis: a point at the distance d from it stands for the circle of radius d cos(45
    // degrees) where its weight has that factor. Its own angle has the unit point (cos, sin) / w of the arc.
    const CircularArc arc(0.0, 2.0 * Pi);
    const auto byRing = [&](const sm::FaceMomentGradient& face, const std::array<double, 4>& p)
    {
      (void)face;
      const std::array<double, 2> at = radial(p);
      // The arc point whose direction this is has the length 1 or 1 / w.
      const double length = std::hypot(at[0], at[1]);
      const double angle = std::atan2(at[1], at[0]) / (0.25 * Pi);
      const bool isInner = std::lround(angle) % 2 != 0;
      const double factor = (isInner ? std::sqrt(2.0) : 1.0) / length;
      return std::array<double, 3>{ at[0] * factor, at[1] * factor, 0.0 };
    };
    const auto byTube = [&](const sm::FaceMomentGradient& face, const std::array<double, 4>& p)
    {
      const std::array<double, 3> out = byRing(face, p);
      const std::array<double, 2> at = radial(p);
      const double unit = std::hypot(out[0], out[1]);
      const double along = (std::hypot(at[0], at[1]) / unit - ring) / tube;
      return std::array<double, 3>{ out[0] * along, out[1] * along, (p[2] - center[2]) / tube };
    };
    const double r2 = tube * tube;
    CheckDirection("ring", result,
      { { "Volume", 2.0 * Pi * Pi * r2 }, { "FirstMoment_X", -2.0 * Pi * Pi * r2 },
        { "FirstMoment_Z", 4.0 * Pi * Pi * r2 }, { "CenterOfMass_Z", 0.0 },
        { "PrincipalMoment_3", 6.0 * Pi * Pi * ring * ring * r2 + 1.5 * Pi * Pi * r2 * r2 },
        { "Inertia_XX", 3.0 * Pi * Pi * ring * ring * r2 + 1.25 * Pi * Pi * r2 * r2 } },
      8.0, byRing);
    CheckDirection("tube", result,
      { { "Volume", 4.0 * Pi * Pi * ring * tube }, { "FirstMoment_Y", 16.0 * Pi * Pi * ring * tube },
        { "PrincipalMoment_3", 4.0 * Pi * Pi * ring * ring * ring * tube + 6.0 * Pi * Pi * ring * tube * r2 },
        { "Inertia_YY", 2.0 * Pi * Pi * ring * ring * ring * tube + 5.0 * Pi * Pi * ring * tube * r2 } },
      8.0, byTube);
    CheckDirection("ring", result, { { "SurfaceArea", 4.0 * Pi * Pi * tube } }, 8.0, byRing);
    CheckDirection("tube", result, { { "SurfaceArea", 4.0 * Pi * Pi * ring } }, 8.0, byTube);
    const sm::FaceMomentGradient& face = result.Faces[0];
    const std::size_t at = face.GetIndex(1, 1, 0, FindQuantity("PrincipalMoment_1"));
    CheckTrue("the other two coincide", std::isnan(face.Values[at]));
  }
}

void CheckBox(bool placed)
{
  const std::array<double, 3> low{ 1.0, 2.0, 3.0 };
  const std::array<double, 3> high{ 4.0, 6.0, 9.0 };
  BoxBody body;
  body.Add({ low, high });
  const auto leaf = body.Make();
  vtkNew<vtkMatrix4x4> placement;
  if (placed)
  {
    // A rotation about z with exact entries, and a mirror.
    const double rows[16] = { 0.6, -0.8, 0, 10, 0.8, 0.6, 0, -20, 0, 0, -1, 30, 0, 0, 0, 1 };
    placement->DeepCopy(rows);
    leaf->SetPlacement(placement);
  }
  const double sides[3] = { 3.0, 4.0, 6.0 };
  const double volume = 72.0;
  for (const bool tied : { false, true })
  {
    const sm::MomentGradientResult result = Compute(leaf, tied);
    for (int d = 0; d < 3; ++d)
    {
      std::printf("--- box, side %d, %s, %s\n", d, placed ? "placed" : "at home", tied ? "tied" : "separate");
      // In world coordinates the side's points move along the placed axis.
      std::array<double, 3> axis{};
      for (int a = 0; a < 3; ++a)
      {
        axis[a] = placement->GetElement(a, d);
      }
      const auto direction = [&](const auto&, const std::array<double, 4>& p)
      {
        double local = 0.0;
        for (int a = 0; a < 3; ++a)
        {
          local += placement->GetElement(a, d) * (p[a] - placement->GetElement(a, 3));
        }
        const double step = std::abs(local - high[d]) < 1e-9 ? 1.0 : 0.0;
        return std::array<double, 3>{ step * axis[0], step * axis[1], step * axis[2] };
      };
      const double slope = volume / sides[d];
      Names expected{ { "Volume", slope } };
      // The centre moves by half, and the first moment by the side's centroid times its area.
      std::array<double, 3> centroid{};
      for (int a = 0; a < 3; ++a)
      {
        centroid[a] = placement->GetElement(a, 3);
        for (int c = 0; c < 3; ++c)
        {
          centroid[a] += placement->GetElement(a, c) * (c == d ? high[c] : 0.5 * (low[c] + high[c]));
        }
        const std::string name = std::string("_") + "XYZ"[a];
        expected["CenterOfMass" + name] = 0.5 * axis[a];
        expected["FirstMoment" + name] = slope * centroid[a];
      }
      // Principal moments ascend with the sum of the other two squares: about z, y and x.
      for (int k = 0; k < 3; ++k)
      {
        const int about = 2 - k;
        double moment = 0.0;
        double change = 0.0;
        for (int c = 0; c < 3; ++c)
        {
          moment += c == about ? 0.0 : sides[c] * sides[c] / 12.0;
          change += c == d && c != about ? sides[c] / 6.0 : 0.0;
        }
        expected["PrincipalMoment_" + std::to_string(k + 1)] = slope * moment + volume * change;
      }
      expected["SurfaceArea"] = 2.0 * (sides[0] + sides[1] + sides[2] - sides[d]);
      CheckDirection("side", result, expected, placed ? 60.0 : 12.0, direction);
    }
    if (tied)
    {
      std::set<std::int64_t> variables;
      for (const sm::FaceMomentGradient& face : result.Faces)
      {
        variables.insert(face.PointVariables.begin(), face.PointVariables.end());
      }
      CheckEqual("corners", 8, static_cast<long long>(variables.size()));
      // One face alone has the same numbers, those of the variables, which its neighbours follow.
      const sm::MomentGradientResult one = Compute(leaf, true, { 2 });
      CheckEqual("one face", 1, static_cast<long long>(one.Faces.size()));
      bool isEqual = one.Faces[0].Face == 2;
      for (std::size_t k = 0; k < one.Faces[0].Values.size(); ++k)
      {
        isEqual = isEqual && one.Faces[0].Values[k] == result.Faces[2].Values[k];
      }
      CheckTrue("has the numbers of the whole", isEqual);
    }
  }
}

/**
 * The face of a cylinder of height h over the conic with the control points (1,0), (0,0), (0,1) and weights
 * 1, w, 1: the area between its chord's corner and the curve is a(w) = (1 - w acos(w) / k) / (2 k^2), k^2 = 1
 * - w^2: the integral of z / (1 + 2 w z + z^2)^2 over z > 0.
 */
void CheckWeight()
{
  const double h = 2.5;
  for (const double w : { 0.3, std::sqrt(0.5), 0.9 })
  {
    std::printf("--- conic cylinder, weight %g\n", w);
    auto face = std::make_shared<sm::Face>();
    face->Id = sm::NewId();
    face->Surface.Rational = true;
    face->Surface.Degree[0] = 2;
    face->Surface.Knots[0] = { 0, 0, 0, 1, 1, 1 };
    face->Surface.Knots[1] = { 0, 0, 1, 1 };
    face->Surface.NumberOfControlPoints[0] = 3;
    face->Surface.NumberOfControlPoints[1] = 2;
    for (const double z : { 0.0, h })
    {
      face->Surface.ControlPoints.push_back({ 1.0, 0.0, z, 1.0 });
      face->Surface.ControlPoints.push_back({ 0.0, 0.0, w * z, w });
      face->Surface.ControlPoints.push_back({ 0.0, 1.0, z, 1.0 });
    }
    const auto body = MakeRoundBody({ face });
    const sm::MomentGradientResult result =
      Compute(body, false, {}, ComputeGradient(body, {}).Status.c_str());
    const double k2 = 1.0 - w * w;
    const double k = std::sqrt(k2);
    const double angle = std::acos(w);
    // a = (1 - w angle / k) / (2 k2), with angle' = -1/k, k' = -w/k.
    const double a = (1.0 - w * angle / k) / (2.0 * k2);
    const double slope = -(angle / k - w / k2 + w * w * angle / (k * k2)) / (2.0 * k2) + 2.0 * w * a / k2;
    // Su x Sv points away from the corner, so that the part between the axes and the curve is inside. Other
    // faces of the solid do not depend on the weight.
    for (int q = 0; q < 2; ++q)
    {
      GradientSum sum;
      const sm::FaceMomentGradient& first = result.Faces[0];
      for (int j = 0; j < 2; ++j)
      {
        const int quantity = FindQuantity(q == 0 ? "Volume" : "FirstMoment_Z");
        sum.Add(1.0, first.Values[first.GetIndex(1, j, 3, quantity)],
          first.Bounds[first.GetIndex(1, j, 3, quantity)]);
      }
      const double expected = slope * h * (q == 0 ? 1.0 : 0.5 * h);
      Check(q == 0 ? "Volume" : "FirstMoment_Z", expected, static_cast<double>(sum.Value), sum.Bound,
        "the bound");
      CheckRange("bound", 0.0, sum.Bound, 1e-7, "tolerance 1e-9");
      CheckTrue("not zero", std::abs(expected) > 1e-3);
    }
  }
}

/// A disk of the radius r as one biquadratic patch, on which tangents are parallel at the four corners: the
/// area grows by 2 pi r.
void CheckDisk()
{
  std::printf("--- disk\n");
  const double r = 3.0;
  const double half = std::sqrt(0.5);
  auto face = std::make_shared<sm::Face>();
  face->Id = sm::NewId();
  face->Surface.Rational = true;
  for (int d = 0; d < 2; ++d)
  {
    face->Surface.Degree[d] = 2;
    face->Surface.Knots[d] = { 0, 0, 0, 1, 1, 1 };
    face->Surface.NumberOfControlPoints[d] = 3;
  }
  for (int j = -1; j <= 1; ++j)
  {
    for (int i = -1; i <= 1; ++i)
    {
      // Corners on the circle; between them the intersections of its tangents, with weights sqrt(1/2).
      const bool isCorner = i != 0 && j != 0;
      const double weight = isCorner || (i == 0 && j == 0) ? 1.0 : half;
      const double size = isCorner ? half * r : r;
      face->Surface.ControlPoints.push_back({ size * i, size * j, 0.0, weight });
    }
  }
  const auto body = MakeRoundBody({ face });
  const sm::MomentGradientResult result = Compute(body, false, {}, ComputeGradient(body, {}).Status.c_str());
  const GradientSum grown = SumOverPoints(result, FindQuantity("SurfaceArea"),
    [&](const auto&, const std::array<double, 4>& p) -> std::array<double, 3> {
      return { p[0] / r, p[1] / r, 0.0 };
    });
  const double deviation = std::abs(static_cast<double>(grown.Value) - 2.0 * Pi * r);
  CheckRange("SurfaceArea", 0.0, deviation, std::min(1e-9 * Pi * r * r, grown.Bound), "the tolerance");
  CheckRange("bound", 0.0, grown.Bound, 1.5e-4 * Pi * r * r);

  // Weights that nearly vanish at one side: bounds are not known, which is said.
  for (int k = 2; k < 9; k += 3)
  {
    std::array<double, 4>& point = face->Surface.ControlPoints[k];
    for (double& coordinate : point)
    {
      coordinate *= 1e-18;
    }
  }
  const sm::MomentGradientResult light =
    Compute(MakeRoundBody({ face }), false, {}, ComputeGradient(body, {}).Status.c_str());
  const std::size_t at = light.Faces[0].GetIndex(1, 1, 0, FindQuantity("SurfaceArea"));
  CheckTrue("no bound", std::isnan(light.Faces[0].Bounds[at]));
  CheckTrue("counted in a message",
    std::any_of(light.Messages.begin(), light.Messages.end(),
      [](const std::string& message)
      { return message.find("bounds of derivatives of SurfaceArea are not known") != std::string::npos; }));
}

/// The top of a unit box as a rational patch of degree 3 with the weights w, w, w, 1 in x, whose trim curve
/// at x = 1 may be off by `residual`. Sr is constant there, so that the area by x of a point in the last
/// column changes by half of what R_3 does.
void CheckResidual(double w, double residual)
{
  std::printf("--- a trim curve that may be off, weights %g and 1\n", w);
  BoxBody boxes;
  boxes.Add({ { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } });
  const auto leaf = boxes.Make();
  std::vector<sm::FacePointer> faces = leaf->GetModel()->GetFaces();
  auto face = std::make_shared<sm::Face>(*faces[5]);
  face->Id = sm::NewId();
  face->Surface.Rational = true;
  face->Surface.Degree[0] = 3;
  face->Surface.Knots[0] = { 0, 0, 0, 0, 1, 1, 1, 1 };
  face->Surface.NumberOfControlPoints[0] = 4;
  face->Surface.ControlPoints.clear();
  for (int k = 0; k < 8; ++k)
  {
    const double weight = k % 4 < 3 ? w : 1.0;
    face->Surface.ControlPoints.push_back({ weight * (k % 4) / 3.0, weight * (k / 4), weight, weight });
  }
  face->Loops[0].Coedges[1].Curve.Residual = { residual, 0.0 };
  faces[5] = face;
  leaf->GetModel()->SetFaces(faces);
  sm::MomentGradientOptions options;
  options.Tied = false;
  options.Faces = { 5 };
  const sm::MomentGradientResult result = ComputeGradient(leaf, options);
  const std::size_t at = result.Faces[0].GetIndex(3, 1, 0, FindQuantity("SurfaceArea"));
  const double bound = result.Faces[0].Bounds[at];
  const auto isSaid = [&result](const char* text)
  {
    return std::any_of(result.Messages.begin(), result.Messages.end(),
      [text](const std::string& message) { return message.find(text) != std::string::npos; });
  };
  Check("SurfaceArea by x", 0.5, result.Faces[0].Values[at], 1e-9);
  const double basis = std::pow(1.0 + residual, 3);
  const double weight = w - (w - 1.0) * basis;
  if (weight > 0.0)
  {
    const double change = 0.5 * (basis / weight - 1.0);
    CheckRange("bound", change, bound, (w == 1.0 ? 10.0 : 1e5) * change, "what the residual changes");
    CheckTrue("said to exceed the values",
      isSaid("bounds of derivatives of SurfaceArea exceed the derivatives") == (change > 0.5));
  }
  else
  {
    CheckTrue("no bound", std::isnan(bound));
    CheckTrue("counted in a message", isSaid("bounds of derivatives of SurfaceArea are not known"));
  }
}

/// The bound of the derivative of the volume by the corner of one face of a unit box, whose three edges end
/// at (0, h, 0) instead of there, and have a vertex that is `away` from this end along x.
double GetCornerBound(double h, double away)
{
  BoxBody boxes;
  boxes.Add({ { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } });
  const auto leaf = boxes.Make();
  std::map<const sm::Edge*, std::shared_ptr<const sm::Edge>> edges;
  std::vector<sm::FacePointer> faces;
  const std::array<double, 3> corner{};
  for (const sm::FacePointer& face : leaf->GetModel()->GetFaces())
  {
    auto copy = std::make_shared<sm::Face>(*face);
    copy->Id = sm::NewId();
    for (sm::Coedge& coedge : copy->Loops[0].Coedges)
    {
      std::shared_ptr<const sm::Edge>& known = edges[coedge.Use.get()];
      if (!known)
      {
        auto edge = std::make_shared<sm::Edge>(*coedge.Use);
        for (std::array<double, 3>& point : edge->Curve.Coefficients)
        {
          point = point == corner ? std::array<double, 3>{ 0.0, h, 0.0 } : point;
        }
        for (std::array<double, 3>* vertex : { &edge->StartVertex, &edge->EndVertex })
        {
          *vertex = *vertex == corner ? std::array<double, 3>{ away, h, 0.0 } : *vertex;
        }
        known = edge;
      }
      coedge.Use = known;
    }
    faces.push_back(copy);
  }
  leaf->GetModel()->SetFaces(faces);
  sm::MomentGradientOptions options;
  options.Tied = false;
  options.Faces = { 0 };
  const sm::MomentGradientResult result = ComputeGradient(leaf, options);
  const sm::FaceMomentGradient& face = result.Faces[0];
  const std::size_t at = face.GetIndex(0, 0, 0, FindQuantity("Volume"));
  Check("Volume by a corner", -0.25, face.Values[at], face.Bounds[at], "the bound");
  return face.Bounds[at];
}

/// Each of the three faces at the corner has two caps, triangles from the vertex to the edge's end and to the
/// face's corner: half the product of these sides is the bound of the area. All of them move with the corner
/// of one face.
void CheckCorners()
{
  std::printf("--- a vertex off the corner\n");
  constexpr double h = 1e-3;
  const double caps = 6.0 * 0.5 * h * std::sqrt(2.0) * h;
  CheckRange("caps in the bound", 0.999 * caps, GetCornerBound(h, h) - GetCornerBound(h, 0.0), 1.001 * caps,
    "six caps, and their speed");
}

void CheckErrors()
{
  std::printf("--- errors\n");
  CheckEqual("null", "empty", sm::ComputeMomentGradient(nullptr).Status);
  const auto ball = MakeRoundBody({ MakeBall({ 0, 0, 0 }, 1.0) });
  sm::MomentGradientOptions options;
  options.Solids = { 1 };
  sm::MomentGradientResult result = sm::ComputeMomentGradient(ball, options);
  CheckEqual("no such solid", "not-computed", result.Status);
  CheckTrue("said so", result.Reason.find("solid 1") != std::string::npos, result.Reason);
  options.Solids = {};
  options.Faces = { -1 };
  result = sm::ComputeMomentGradient(ball, options);
  CheckEqual("no such face", "not-computed", result.Status);
  CheckTrue("said so", result.Reason.find("face -1") != std::string::npos, result.Reason);
  options.Faces = {};
  options.RelativeTolerance = 0.0;
  result = sm::ComputeMomentGradient(ball, options);
  CheckEqual("tolerance", "not-computed", result.Status);
  CheckTrue("said so", result.Reason.find("RelativeTolerance") != std::string::npos, result.Reason);
  options.RelativeTolerance = 1e-9;
  options.Progress = [](double fraction) { return fraction < 0.5; };
  result = sm::ComputeMomentGradient(ball, options);
  CheckEqual("stopped", "not-computed", result.Status);
  CheckTrue("without faces", result.Faces.empty() && !result.Reason.empty(), result.Reason);
}
}

int TestMomentGradientValues(int argc, char* argv[])
{
  RequireUsage(argc == 1 || std::string(argv[1]) == "opengl", "TestMomentGradientValues [opengl]");
  GradientTestBackend = argc == 1 ? sm::BackendChoice::CPU : sm::BackendChoice::OpenGL;
  if (argc > 1 && FlushesSubnormals())
  {
    return Skipped;
  }
  CheckBall();
  CheckTorus();
  CheckBox(false);
  CheckBox(true);
  CheckWeight();
  CheckDisk();
  CheckResidual(1.0, 1e-3);
  CheckResidual(180.0, 1.66e-3);
  CheckResidual(250.0, 1.66e-3);
  CheckCorners();
  CheckErrors();
  return Finish();
}
