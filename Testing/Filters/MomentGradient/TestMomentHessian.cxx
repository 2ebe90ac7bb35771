// The Hessian of moments times directions against closed forms: a ball by radius and semi-axes, a torus by
// both radii, a box by its sides; the second variation itself by Gauss sums; failures. Each within its bound,
// and the bound within the tolerance.
#include "smBoxBodies.h"
#include "smGaussRule.h"
#include "smHessianSums.h"
#include "smRoundFaces.h"
#include "smTestPipeline.h"

#include <vtkMatrix4x4.h>
#include <vtkNURBSDataSet.h>

#include <map>

namespace
{
using namespace smtest;
using Expected = std::map<std::string, double>;
using Direction = std::vector<sm::NetDirection>;
using Vector = std::array<double, 3>;

constexpr double HalfTurn = 3.14159265358979323846;

sm::MomentGradientResult GetGradient(vtkDataObject* leaf, bool tied)
{
  sm::MomentGradientOptions options;
  options.Tied = tied;
  return sm::ComputeMomentGradient(leaf, options);
}

sm::MomentHessianResult Apply(vtkDataObject* leaf, const Direction& v, bool tied, double tolerance = 1e-9)
{
  sm::MomentHessianOptions options;
  options.Tied = tied;
  options.RelativeTolerance = tolerance;
  const sm::MomentHessianResult result = sm::ComputeMomentHessianProduct(leaf, v, options);
  CheckEqual("status", "ok", result.Status);
  return result;
}

/// Checks u . H v for some quantities, and that v . H u is the same.
void CheckPair(const std::string& what, vtkDataObject* leaf, const Direction& u, const Direction& v,
  const Expected& expected, double size)
{
  for (const bool tied : { true, false })
  {
    const sm::MomentGradientResult gradient = GetGradient(leaf, tied);
    const sm::MomentHessianResult alongV = Apply(leaf, v, tied);
    const sm::MomentHessianResult alongU = Apply(leaf, u, tied);
    for (const auto& [name, value] : expected)
    {
      const int q = FindQuantity(name);
      const double scale = std::pow(size, sm::GetGradientQuantities()[q].LengthPower - 2);
      const GradientSum sum = smtest::Multiply(gradient, u, alongV, q);
      const GradientSum other = smtest::Multiply(gradient, v, alongU, q);
      Check(what + " " + name, value, static_cast<double>(sum.Value), sum.Bound + 4e-16 * std::abs(value),
        tied ? "the bound, tied" : "the bound, separate");
      CheckRange(what + " " + name + " bound", 0.0, sum.Bound, 1e-6 * scale, "1e-9, a hundred points");
      Check(what + " " + name + " symmetric", static_cast<double>(sum.Value),
        static_cast<double>(other.Value), sum.Bound + other.Bound);
    }
    bool isHessian = true;
    for (const sm::FaceHessianProduct& face : alongV.Faces)
    {
      isHessian = isHessian && face.HasTiedBorder;
    }
    CheckTrue(what + ": all borders are tied", isHessian);
  }
}

void CheckBallTwice()
{
  std::printf("--- ball\n");
  const Vector c{ 1.5, -2.0, 3.0 };
  const double r = 2.0;
  const auto ball = MakeRoundBody({ MakeBall({ c[0], c[1], c[2] }, r) });
  const sm::MomentGradientResult gradient = GetGradient(ball, true);
  const auto scale = [&](double x, double y, double z)
  {
    return MakeDirection(gradient,
      [&, x, y, z](const auto&, const auto& p) {
        return Vector{ x * (p[0] - c[0]) / r, y * (p[1] - c[1]) / r, z * (p[2] - c[2]) / r };
      });
  };
  const Direction byRadius = scale(1.0, 1.0, 1.0);
  const double unit = 4.0 * HalfTurn / 3.0;
  // V = unit r^3, S_xx = V c_x^2 + V r^2 / 5.
  CheckPair("radius", ball, byRadius, byRadius,
    { { "Volume", 6.0 * unit * r }, { "FirstMoment_X", 6.0 * unit * r * c[0] },
      { "SecondMoment_XX", unit * (6.0 * r * c[0] * c[0] + 4.0 * r * r * r) },
      { "SecondMoment_YZ", 6.0 * unit * r * c[1] * c[2] } },
    4.0);
  // V = unit a b c, S_xx = V (c_x^2 + a^2 / 5).
  CheckPair("semi-axes", ball, scale(1.0, 0.0, 0.0), scale(0.0, 1.0, 0.0),
    { { "Volume", unit * r }, { "FirstMoment_Z", unit * r * c[2] },
      { "SecondMoment_XX", unit * r * (c[0] * c[0] + 3.0 * r * r / 5.0) } },
    4.0);
  CheckPair("one semi-axis", ball, scale(1.0, 0.0, 0.0), scale(1.0, 0.0, 0.0),
    { { "Volume", 0.0 }, { "FirstMoment_Y", 0.0 }, { "SecondMoment_XX", unit * r * r * 6.0 * r / 5.0 } },
    4.0);
}

void CheckTorusTwice()
{
  std::printf("--- torus\n");
  const Vector c{ -1.0, 4.0, 2.0 };
  const double ring = 3.0;
  const double tube = 1.25;
  const auto torus = MakeRoundBody({ MakeTorus({ c[0], c[1], c[2] }, ring, tube) });
  const sm::MomentGradientResult gradient = GetGradient(torus, true);
  // A control point at an odd multiple of 45 degrees is farther from the axis by 1 / cos(45 degrees).
  const auto radial = [&](const std::array<double, 4>& p)
  {
    const double x = p[0] - c[0];
    const double y = p[1] - c[1];
    const bool isCorner = std::lround(std::atan2(y, x) / (0.25 * HalfTurn)) % 2 != 0;
    const double factor = (isCorner ? std::sqrt(2.0) : 1.0) / std::hypot(x, y);
    return Vector{ x * factor, y * factor, 0.0 };
  };
  const Direction byRing = MakeDirection(gradient, [&](const auto&, const auto& p) { return radial(p); });
  const Direction byTube = MakeDirection(gradient,
    [&](const auto&, const auto& p)
    {
      const Vector out = radial(p);
      const double along = (std::hypot(p[0] - c[0], p[1] - c[1]) / std::hypot(out[0], out[1]) - ring) / tube;
      return Vector{ out[0] * along, out[1] * along, (p[2] - c[2]) / tube };
    });
  const double pi2 = HalfTurn * HalfTurn;
  // V = 2 pi^2 R r^2, S_zz = V (c_z^2 + r^2 / 4).
  CheckPair("ring, tube", torus, byRing, byTube,
    { { "Volume", 4.0 * pi2 * tube }, { "FirstMoment_X", 4.0 * pi2 * tube * c[0] },
      { "SecondMoment_ZZ", pi2 * (4.0 * tube * c[2] * c[2] + 2.0 * tube * tube * tube) } },
    8.0);
  CheckPair("tube, tube", torus, byTube, byTube,
    { { "Volume", 4.0 * pi2 * ring },
      { "SecondMoment_ZZ", pi2 * ring * (4.0 * c[2] * c[2] + 6.0 * tube * tube) } },
    8.0);
  CheckPair("ring, ring", torus, byRing, byRing, { { "Volume", 0.0 }, { "FirstMoment_Y", 0.0 } }, 8.0);
}

void CheckBoxTwice()
{
  std::printf("--- box, rotated and mirrored\n");
  const Vector low{ 1.0, 2.0, 3.0 };
  const Vector high{ 4.0, 6.0, 9.0 };
  BoxBody body;
  body.Add({ low, high });
  const auto leaf = body.Make();
  const double rows[16] = { 0.6, -0.8, 0, 10, 0.8, 0.6, 0, -20, 0, 0, -1, 30, 0, 0, 0, 1 };
  vtkNew<vtkMatrix4x4> placement;
  placement->DeepCopy(rows);
  leaf->SetPlacement(placement);
  const sm::MomentGradientResult gradient = GetGradient(leaf, true);
  const auto bySide = [&](int d)
  {
    return MakeDirection(gradient,
      [&, d](const auto&, const auto& p)
      {
        double local = 0.0;
        for (int a = 0; a < 3; ++a)
        {
          local += rows[4 * a + d] * (p[a] - rows[4 * a + 3]);
        }
        const double step = std::abs(local - high[d]) < 1e-9 ? 1.0 : 0.0;
        return Vector{ step * rows[d], step * rows[4 + d], step * rows[8 + d] };
      });
  };
  // In world coordinates z = 30 - local z, of which the middle is 24: M_z = V (30 - (low + high) / 2).
  CheckPair(
    "sides a, b", leaf, bySide(0), bySide(1), { { "Volume", 6.0 }, { "FirstMoment_Z", 144.0 } }, 60.0);
  CheckPair("sides b, c", leaf, bySide(1), bySide(2),
    { { "Volume", 3.0 }, { "FirstMoment_Z", 3.0 * 24.0 - 0.5 * 18.0 } }, 60.0);
  // S_zz = a b ((30 - low)^3 - (30 - high)^3) / 3.
  CheckPair("side c twice", leaf, bySide(2), bySide(2),
    { { "Volume", 0.0 }, { "FirstMoment_Z", -12.0 }, { "SecondMoment_ZZ", -2.0 * 12.0 * 21.0 } }, 60.0);
}

using VariationSums = std::array<std::array<Real, 10>, 3>;

/// Adds `weight` times R [ (grad g . e) n + g (e_u x Sv + Su x e_v) ] at a point: R is x of `basis`, e of
/// `moves`.
void AddVariation(const sm::NURBSSurface& surface, const double* origin, const sm::NURBSSurface& moves,
  const sm::NURBSSurface& basis, double u, double v, Real weight, VariationSums& sums)
{
  double x[3], xu[3], xv[3], e[3], eu[3], ev[3], r[3];
  surface.Evaluate(u, v, x, xu, xv);
  moves.Evaluate(u, v, e, eu, ev);
  basis.Evaluate(u, v, r);
  for (int c = 0; c < 3; ++c)
  {
    x[c] += origin[c];
  }
  const double g[10] = { 1.0, x[0], x[1], x[2], x[0] * x[0], x[1] * x[1], x[2] * x[2], x[0] * x[1],
    x[1] * x[2], x[0] * x[2] };
  const double along[10] = { 0.0, e[0], e[1], e[2], 2 * x[0] * e[0], 2 * x[1] * e[1], 2 * x[2] * e[2],
    x[0] * e[1] + x[1] * e[0], x[1] * e[2] + x[2] * e[1], x[0] * e[2] + x[2] * e[0] };
  for (int c = 0; c < 3; ++c)
  {
    const int d = (c + 1) % 3;
    const int f = (c + 2) % 3;
    const double n = xu[d] * xv[f] - xu[f] * xv[d];
    const double change = eu[d] * xv[f] - eu[f] * xv[d] + xu[d] * ev[f] - xu[f] * ev[d];
    for (int q = 0; q < 10; ++q)
    {
      sums[c][q] += weight * r[0] * (along[q] * n + g[q] * change);
    }
  }
}

/// The second variation by Gauss sums over a whole face, for one R.
VariationSums IntegrateVariation(const sm::Face& face, const double* origin, const sm::NURBSSurface& moves,
  const sm::NURBSSurface& basis, const GaussRule& rule, int points)
{
  const std::vector<double> us = face.Surface.GetSpanBreaks(0);
  const std::vector<double> vs = face.Surface.GetSpanBreaks(1);
  VariationSums sums{};
  for (std::size_t a = 0; a + 1 < us.size(); ++a)
  {
    for (std::size_t b = 0; b + 1 < vs.size(); ++b)
    {
      const Real du = us[a + 1] - us[a];
      const Real dv = vs[b + 1] - vs[b];
      for (int k = 0; k < points * points; ++k)
      {
        const Real weight =
          (face.Reversed ? -1 : 1) * rule.Weights[k % points] * rule.Weights[k / points] * du * dv;
        AddVariation(face.Surface, origin, moves, basis,
          static_cast<double>(us[a] + rule.Nodes[k % points] * du),
          static_cast<double>(vs[b] + rule.Nodes[k / points] * dv), weight, sums);
      }
    }
  }
  return sums;
}

/// A surface with the knots and weights of another one, and the control points that get(i, j) returns.
template <class Get>
sm::NURBSSurface MakeLike(const sm::NURBSSurface& surface, const Get& get)
{
  sm::NURBSSurface other = surface;
  const int* count = surface.NumberOfControlPoints;
  for (int i = 0; i < count[0]; ++i)
  {
    for (int j = 0; j < count[1]; ++j)
    {
      std::array<double, 4>& point = other.ControlPoints[i + static_cast<std::size_t>(count[0]) * j];
      const Vector to = get(i, j);
      point = { point[3] * to[0], point[3] * to[1], point[3] * to[2], point[3] };
    }
  }
  return other;
}

/// Compares each entry of a whole face with the second variation by Gauss sums.
void CheckVariation(vtkNURBSDataSet* leaf, int index, int points, double tolerance)
{
  const sm::Face& face = *leaf->GetModel()->GetFaces()[index];
  const int* count = face.Surface.NumberOfControlPoints;
  const Direction v = MakeDirection(GetGradient(leaf, false),
    [](const sm::FaceMomentGradient& net, const std::array<double, 4>& p)
    {
      return Vector{ 0.3 * p[1] - 0.1 * p[2] * p[0] + net.Face, 0.2 * std::cos(p[0]) + p[2],
        0.5 - 0.4 * p[1] * p[2] };
    });
  const sm::MomentHessianResult product = Apply(leaf, v, false);
  const sm::NURBSSurface moves = MakeLike(face.Surface,
    [&](int i, int j) { return v[index].Displacements[static_cast<std::size_t>(i) * count[1] + j]; });
  const GaussRule rule = MakeGaussRule(points);
  double worst = 0.0;
  double worstOfBound = 0.0;
  double size = 0.0;
  const sm::FaceHessianProduct& result = product.Faces[index];
  for (int k = 0; k < count[0] * count[1]; ++k)
  {
    const sm::NURBSSurface basis = MakeLike(face.Surface,
      [&](int i, int j) {
        return Vector{ i * count[1] + j == k ? 1.0 : 0.0, 0.0, 0.0 };
      });
    const VariationSums sums =
      IntegrateVariation(face, leaf->GetModel()->GetOrigin(), moves, basis, rule, points);
    for (int c = 0; c < 3; ++c)
    {
      for (int q = 0; q < 10; ++q)
      {
        const std::size_t at = result.GetIndex(k / count[1], k % count[1], c, q);
        size = std::max(size, std::abs(result.Values[at]));
        worst =
          std::max(worst, std::abs(static_cast<double>(sums[c][q]) - result.Values[at]) - result.Bounds[at]);
        worstOfBound = std::max(worstOfBound, result.Bounds[at]);
      }
    }
  }
  std::printf("     face %d: largest entry %.3g, largest bound %.1e, difference beyond the bound %.1e\n",
    index, size, worstOfBound, worst);
  CheckRange("the second variation", -1.0, worst, tolerance * size, "the bound, and the Gauss sums");
  CheckRange("bounds", 0.0, worstOfBound, 1e-6 * size);
}

/// A shell, of a box without one of its faces, has no volume, and so no derivatives of it.
void CheckOpen()
{
  BoxBody body;
  body.Add({ { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } });
  const auto leaf = body.Make();
  std::vector<sm::FacePointer> faces = leaf->GetModel()->GetFaces();
  faces.pop_back();
  leaf->GetModel()->SetFaces(faces);
  leaf->GetModel()->SetBody(vtkTrimmedNURBSModel::SHELL);
  sm::MomentHessianOptions options;
  options.Tied = false;
  const sm::MomentHessianResult result =
    sm::ComputeMomentHessianProduct(leaf, { { 0, 0, std::vector<Vector>(4, { 1.0, 0.0, 0.0 }) } }, options);
  CheckEqual("status of an open shell", "open", result.Status);
  bool isUnknown = result.Faces.size() == 5;
  for (const sm::FaceHessianProduct& face : result.Faces)
  {
    for (std::size_t k = 0; k < face.Values.size(); ++k)
    {
      isUnknown = isUnknown && std::isnan(face.Values[k]) && std::isnan(face.Bounds[k]);
    }
  }
  CheckTrue("all is NaN", isUnknown);
  CheckTrue("and said so",
    std::any_of(result.Messages.begin(), result.Messages.end(),
      [](const std::string& message) { return message.find("all values are NaN") != std::string::npos; }));
}

/// Displacements that differ by a rounding are those of one variable.
void CheckNearlyTied()
{
  BoxBody body;
  body.Add({ { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } });
  const auto leaf = body.Make();
  const auto apply = [&](double off)
  {
    int calls = 0;
    return Apply(leaf,
      MakeDirection(GetGradient(leaf, true),
        [&](const sm::FaceMomentGradient&, const std::array<double, 4>& p)
        {
          // Each corner has its first call at the first 2 faces, which are opposite.
          return Vector{ 1.0 + p[1] + (calls++ < 8 ? 0.0 : off), 0.5 * p[0], 0.0 };
        }),
      true);
  };
  const sm::MomentHessianResult right = apply(0.0);
  const sm::MomentHessianResult own = apply(1e-13);
  bool isSame = own.Faces.size() == 6 && right.Faces.size() == 6;
  for (std::size_t f = 0; isSame && f < 6; ++f)
  {
    isSame = own.Faces[f].Values == right.Faces[f].Values && own.Faces[f].Bounds == right.Faces[f].Bounds;
  }
  CheckTrue("tied points move by the first one's displacement", isSame);
}

void CheckFailures()
{
  std::printf("--- failures\n");
  BoxBody body;
  body.Add({ { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } });
  const auto leaf = body.Make();
  const std::vector<Vector> ones(4, { 1.0, 0.0, 0.0 });
  const auto refuse = [&](const std::string& text, vtkDataObject* model, const Direction& direction,
                        const sm::MomentHessianOptions& options = {})
  {
    const sm::MomentHessianResult result = sm::ComputeMomentHessianProduct(model, direction, options);
    CheckTrue(text,
      result.Status != "ok" && result.Faces.empty() && result.Reason.find(text) != std::string::npos,
      result.Status + ": " + result.Reason);
  };
  refuse("no face moves", leaf, {});
  refuse("does not exist", leaf, { { 0, 6, ones } });
  refuse("named twice", leaf, { { 0, 1, ones }, { 0, 1, ones } });
  refuse("there is no solid 3", leaf, { { 3, 0, ones } });
  refuse("has 4 control points", leaf, { { 0, 0, { ones[0] } } });
  refuse("not finite", leaf, { { 0, 0, { ones[0], ones[0], ones[0], { NAN, 0.0, 0.0 } } } });
  const std::vector<Vector> tiny(4, { 1e-308, 0.0, 0.0 });
  refuse("scale the direction", leaf, { { 0, 0, tiny } });
  refuse("scale the direction", leaf, { { 0, 0, std::vector<Vector>(4, { 1e201, 0.0, 0.0 }) } });
  refuse("tied points move apart", leaf, { { 0, 0, ones } });
  refuse("without exact geometry", nullptr, { { 0, 0, ones } });
  sm::MomentHessianOptions options;
  options.RelativeTolerance = 0.0;
  refuse("RelativeTolerance", leaf, { { 0, 0, ones } }, options);
  options.RelativeTolerance = 1e-9;
  options.Tied = false;
  options.Progress = [](double fraction) { return fraction < 0.5; };
  refuse("abort", leaf, { { 0, 0, ones } }, options);
  options.Progress = nullptr;
  const sm::MomentHessianResult still =
    sm::ComputeMomentHessianProduct(leaf, { { 0, 0, std::vector<Vector>(4) } }, options);
  CheckEqual("a direction of zeros", "ok", still.Status);
  CheckTrue("gives zeros",
    still.Faces.size() == 6 &&
      std::all_of(
        still.Faces[0].Values.begin(), still.Faces[0].Values.end(), [](double x) { return x == 0.0; }));
}
}

int TestMomentHessian(int argc, char* argv[])
{
  RequireUsage(argc == 2, "TestMomentHessian FREE_FORM.step");
  CheckBallTwice();
  CheckTorusTwice();
  CheckBoxTwice();
  std::printf("--- the second variation\n");
  CheckVariation(MakeRoundBody({ MakeTorus({ 0.2, 0.1, -0.3 }, 3.0, 1.25) }), 0, 16, 1e-12);
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(argv[1]);
  UseCoarseMesh(reader);
  reader->Update();
  auto* leaf = vtkNURBSDataSet::SafeDownCast(reader->GetOutput()->GetPartitionAsDataObject(0, 0));
  for (const int face : { 0, 17, 39 })
  {
    CheckVariation(leaf, face, 10, 1e-13);
  }
  CheckOpen();
  CheckNearlyTied();
  CheckFailures();
  return Finish();
}
