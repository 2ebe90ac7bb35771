// Images of native curves and surfaces under maps, and shapes that are refused.
#include "Geometry/smGeometryTransform.h"
#include "smNativeShapes.h"

namespace
{
using sm::Vector3;
using namespace smtest;

template <int Dimension>
sm::AffineTransform<Dimension> MakeTransform(bool isMirrored, double scale)
{
  sm::AffineTransform<Dimension> map;
  if constexpr (Dimension == 3)
  {
    const sm::GeometricFrame frame = MakeFrame();
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        map.Linear[i][j] = (isMirrored && j == 2 ? -scale : scale) * frame.Axes[j][i];
      }
    }
    map.Translation = { -4.0, 1.0, 2.0 };
  }
  else
  {
    map.Linear[0] = { 0.8 * scale, isMirrored ? 0.6 * scale : -0.6 * scale };
    map.Linear[1] = { 0.6 * scale, isMirrored ? -0.8 * scale : 0.8 * scale };
    map.Translation = { 1.0, -1.0 };
  }
  return map;
}

template <int Dimension>
void CheckImages(const sm::CurvePointer<Dimension>& curve, const sm::AffineTransform<Dimension>& map)
{
  sm::ParameterScale parameter;
  std::string problem;
  const auto image = sm::TransformCurve<Dimension>(curve, map, parameter, problem);
  smtest::CheckEqual("the image of a curve is one", "", problem);
  for (const double t : { 0.2, 0.9 })
  {
    const auto expected = map.MapPoint(curve->Evaluate(t));
    smtest::Check(
      "its point", 0.0, image ? GetGap<Dimension>(image->Evaluate(parameter(t)), expected) : 1.0, 1e-12);
  }
}

template <int Dimension>
void TestImagesOfCurves()
{
  using Shape = typename sm::ConicCurve<Dimension>::Type;
  sm::LineCurve<Dimension> line;
  line.Direction[1] = 1.0;
  const auto spline = MakeCurve<Dimension>(MakeSpline<Dimension>(true));
  sm::OffsetCurve<Dimension> offset{ spline, 0.3, {} };
  offset.Reference[0] = 1.0;
  sm::CompositeCurve<Dimension> composite;
  composite.Segments.push_back({ MakeCurve<Dimension>(line), 2.0, 1.0, 0.5 });
  composite.Segments.push_back({ spline, 0.0, 4.0, 2.0 });
  const sm::CurvePointer<Dimension> curves[] = { MakeCurve<Dimension>(line),
    MakeCurve<Dimension>(MakeConic<Dimension>(Shape::Ellipse, 2.0, 3.0)),
    MakeCurve<Dimension>(MakeConic<Dimension>(Shape::Parabola, 2.0, 2.0)),
    MakeCurve<Dimension>(MakeConic<Dimension>(Shape::Hyperbola, 2.0, 3.0)), spline,
    MakeCurve<Dimension>(composite), MakeCurve<Dimension>(offset) };
  for (const bool isMirrored : { false, true })
  {
    const auto map = MakeTransform<Dimension>(isMirrored, 2.5);
    smtest::Check("scale of the map", 2.5, map.GetScale(), Limit);
    smtest::CheckTrue("reflection of the map", map.IsMirrored() == isMirrored);
    for (const auto& curve : curves)
    {
      CheckImages<Dimension>(curve, map);
    }
  }
  // An affine map that is not a similarity keeps parameters; an offset has no image.
  sm::AffineTransform<Dimension> stretch;
  for (int d = 0; d < Dimension; ++d)
  {
    stretch.Linear[d][d] = d + 0.5;
  }
  smtest::Check("a stretch is not a similarity", 0.0, stretch.GetScale(), 0.0);
  for (int i = 0; i < 6; ++i)
  {
    CheckImages<Dimension>(curves[i], stretch);
  }
  sm::ParameterScale parameter;
  std::string problem;
  smtest::CheckTrue("a stretched offset is none",
    !sm::TransformCurve<Dimension>(curves[6], stretch, parameter, problem) && !problem.empty());
}

void TestImagesOfSurfaces()
{
  using Shape = sm::ElementarySurface::Type;
  std::vector<sm::SurfacePointer> surfaces;
  for (const Shape kind : { Shape::Plane, Shape::Cylinder, Shape::Cone, Shape::Sphere, Shape::Torus })
  {
    surfaces.push_back(MakeSurface(MakeElementary(kind, 2.0, 0.5)));
  }
  const auto spline = MakeCurve<3>(MakeSpline<3>(true));
  const auto parabola = MakeCurve<3>(MakeConic<3>(sm::ConicCurve<3>::Type::Parabola, 2.0, 2.0));
  const Vector3 axis = sm::Normalized<double>({ 0.2, 0.1, 0.9 });
  surfaces.push_back(MakeSurface(sm::ExtrudedSurface{ parabola, { 0.0, 1.0 }, axis }));
  surfaces.push_back(MakeSurface(sm::RevolvedSurface{ spline, {}, { 1.0, 2.0, 0.0 }, axis }));
  surfaces.push_back(MakeSurface(sm::OffsetSurface{ surfaces.back(), 0.2 }));
  for (const bool isMirrored : { false, true })
  {
    const auto map = MakeTransform<3>(isMirrored, 2.5);
    for (const auto& surface : surfaces)
    {
      sm::ParameterScale parameters[2];
      std::string problem;
      const auto image = sm::TransformSurface(surface, map, parameters, problem);
      smtest::CheckEqual("the image of a surface is one", "", problem);
      const Vector3 expected = map.MapPoint(surface->Evaluate(0.3, 0.4));
      smtest::Check("its point", 0.0,
        image ? GetGap<3>(image->Evaluate(parameters[0](0.3), parameters[1](0.4)), expected) : 1.0, 1e-12);
    }
  }
}

void CheckRefused(const char* what, sm::GeometricSurface::Variant value)
{
  std::string problem;
  smtest::CheckTrue(
    what, !sm::GeometricSurface::Make(std::move(value), problem) && !problem.empty(), problem);
}

void CheckRefusedCurve(const char* what, sm::GeometricCurve<3>::Variant value)
{
  std::string problem;
  smtest::CheckTrue(
    what, !sm::GeometricCurve<3>::Make(std::move(value), problem) && !problem.empty(), problem);
}

void TestRefusals()
{
  using Shape = sm::ElementarySurface::Type;
  CheckRefusedCurve("a line without direction", sm::LineCurve<3>());
  CheckRefusedCurve("a circle of radius 0", MakeConic<3>(sm::ConicCurve<3>::Type::Ellipse, 0.0, 0.0));
  CheckRefused("a sphere of radius 0", MakeElementary(Shape::Sphere, 0.0, 0.0));
  sm::ElementarySurface cone = MakeElementary(Shape::Cone, 1.0, 0.0);
  cone.Angle = 0.0;
  CheckRefused("a cone without opening", cone);
  sm::ElementarySurface skew = MakeElementary(Shape::Plane, 0.0, 0.0);
  skew.Frame.Axes[1] = skew.Frame.Axes[0];
  CheckRefused("a plane with two equal axes", skew);
  sm::SplineCurve<3> spline = MakeSpline<3>(true);
  spline.Weights[2] = 0.0;
  CheckRefusedCurve("a weight of 0", spline);
  spline = MakeSpline<3>(false);
  spline.Poles.pop_back();
  CheckRefusedCurve("a control point too few", spline);
  spline = MakeSpline<3>(false);
  spline.Basis.Knots[2] = spline.Basis.Knots[1];
  CheckRefusedCurve("knots that do not increase", spline);
  spline = MakeSpline<3>(false);
  spline.Basis.Multiplicities = { 3, 1, 4, 3 };
  CheckRefusedCurve("a torn spline", spline);
  CheckRefused("an offset of nothing", sm::OffsetSurface());
}
}

int TestGeometryImages(int, char*[])
{
  TestImagesOfCurves<2>();
  TestImagesOfCurves<3>();
  TestImagesOfSurfaces();
  TestRefusals();
  return Finish();
}
