/**
 * @file smVariantSolids.h
 * @brief Solids whose moments are known in closed form for every c, as shapes of variants
 */
#ifndef smVariantSolids_h
#define smVariantSolids_h

#include "smBoxBodies.h"
#include "smRationalBlock.h"
#include "smRoundFaces.h"
#include "smVariantShape.h"

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace smtest
{
/// Volume, first and second moments (XX YY ZZ XY YZ XZ) about the origin.
using TenMoments = std::array<Real, 10>;
using Numbers = std::vector<Real>;

struct VariantSolid
{
  std::string Name;
  std::shared_ptr<const sm::VariantShape> Shape;
  std::vector<double> Ranges;
  std::function<TenMoments(const Numbers&)> Truth;
};

inline TenMoments FromExact(const ExactMoments& exact, Real sign = 1)
{
  const Matrix second = exact.GetSecondMoments();
  const Real v = sign * exact.Volume;
  return { v, v * exact.Center[0], v * exact.Center[1], v * exact.Center[2], sign * second[0][0],
    sign * second[1][1], sign * second[2][2], sign * second[0][1], sign * second[1][2], sign * second[0][2] };
}

/// The moments about another point.
inline TenMoments About(const TenMoments& m, const std::array<double, 3>& point)
{
  TenMoments moved = m;
  for (int i = 0; i < 3; ++i)
  {
    moved[1 + i] -= m[0] * point[i];
  }
  const int axes[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 1, 2 }, { 0, 2 } };
  for (int k = 0; k < 6; ++k)
  {
    const Real a = point[axes[k][0]];
    const Real b = point[axes[k][1]];
    moved[4 + k] += -a * m[1 + axes[k][1]] - b * m[1 + axes[k][0]] + a * b * m[0];
  }
  return moved;
}

inline std::shared_ptr<const sm::VariantShape> MakeShape(
  vtkTrimmedNURBSModel* base, const std::vector<sm::MovedModel>& moved)
{
  std::string error;
  auto shape = sm::VariantShape::Make(base, moved, error);
  if (!shape)
  {
    std::printf("FAIL %s\n", error.c_str());
  }
  return shape;
}

inline vtkSmartPointer<vtkTrimmedNURBSModel> MakeModel(
  const std::vector<sm::FacePointer>& faces, const std::array<double, 6>& bounds)
{
  auto model = vtkSmartPointer<vtkTrimmedNURBSModel>::New();
  model->SetFaces(faces);
  double box[6];
  std::copy(bounds.begin(), bounds.end(), box);
  model->SetLocalBounds(box);
  return model;
}

/// A box whose sides are 1 + c, with the corner (0.5, -1, 2).
inline VariantSolid MakeBoxOfSides()
{
  const auto make = [](double x, double y, double z)
  {
    BoxBody body;
    body.Add({ { 0.5, -1.0, 2.0 }, { 1.5 + x, y, 3.0 + z } });
    return vtkSmartPointer<vtkTrimmedNURBSModel>(body.Make()->GetModel());
  };
  VariantSolid solid;
  solid.Name = "box by its sides";
  solid.Shape =
    MakeShape(make(0, 0, 0), { { make(0.5, 0, 0), 0.5 }, { make(0, 0.5, 0), 0.5 }, { make(0, 0, 2), 2.0 } });
  solid.Ranges = { 0.5, 0.9, 0.5 };
  solid.Truth = [](const Numbers& c)
  {
    Placement move;
    move.Translation = { 0.5L, -1.0L, 2.0L };
    return FromExact(Moved(Box(1 + c[0], 1 + c[1], 1 + c[2]), move));
  };
  return solid;
}

/// A prism: the base is a quadrangle whose corners move in its plane, c has x and y of each. Its sides stay
/// planes.
inline VariantSolid MakePrism()
{
  constexpr double height = 3.0;
  // Corner c of a box has High where bit d of c is set, so corners c and c + 4 move together.
  const auto move = [=](int corner, int axis)
  {
    BoxBody body;
    body.Add({ { 0.0, 0.0, 0.0 }, { 2.0, 1.0, height } });
    vtkSmartPointer<vtkTrimmedNURBSModel> model = body.Make()->GetModel();
    if (corner < 0)
    {
      return model;
    }
    const auto shift = [=](std::array<double, 3>& point)
    {
      if (point[0] == (corner & 1 ? 2.0 : 0.0) && point[1] == (corner & 2 ? 1.0 : 0.0))
      {
        point[axis] += 1.0;
      }
    };
    std::map<const sm::Edge*, std::shared_ptr<const sm::Edge>> edges;
    std::vector<sm::FacePointer> faces;
    for (const sm::FacePointer& face : model->GetFaces())
    {
      auto moved = std::make_shared<sm::Face>(*face);
      for (std::array<double, 4>& point : moved->Surface.ControlPoints)
      {
        std::array<double, 3> at{ point[0], point[1], point[2] };
        shift(at);
        std::copy(at.begin(), at.end(), point.begin());
      }
      for (sm::Coedge& coedge : moved->Loops[0].Coedges)
      {
        std::shared_ptr<const sm::Edge>& known = edges[coedge.Use.get()];
        if (!known)
        {
          auto edge = std::make_shared<sm::Edge>(*coedge.Use);
          for (auto& point : edge->Curve.Coefficients)
          {
            shift(point);
          }
          shift(edge->StartVertex);
          shift(edge->EndVertex);
          known = edge;
        }
        coedge.Use = known;
      }
      faces.push_back(moved);
    }
    auto result = vtkSmartPointer<vtkTrimmedNURBSModel>::New();
    result->ShallowCopy(model);
    result->SetFaces(faces);
    return result;
  };
  VariantSolid solid;
  solid.Name = "prism by its corners";
  // The box and the moved copies come from different edges: all directions start from one base.
  const vtkSmartPointer<vtkTrimmedNURBSModel> base = move(-1, 0);
  std::vector<sm::MovedModel> moved;
  for (int corner = 0; corner < 4; ++corner)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      moved.push_back({ move(corner, axis), 1.0 });
    }
  }
  solid.Shape = MakeShape(base, moved);
  solid.Ranges.assign(8, 0.3);
  solid.Truth = [=](const Numbers& c)
  {
    // Green's theorem for the polygon of the corners 0 1 3 2.
    const int order[4] = { 0, 1, 3, 2 };
    Real p[4][2];
    for (int i = 0; i < 4; ++i)
    {
      const int k = order[i];
      p[i][0] = (k & 1 ? 2 : 0) + c[2 * k];
      p[i][1] = (k & 2 ? 1 : 0) + c[2 * k + 1];
    }
    Real area = 0, mx = 0, my = 0, xx = 0, yy = 0, xy = 0;
    for (int i = 0; i < 4; ++i)
    {
      const Real* a = p[i];
      const Real* b = p[(i + 1) % 4];
      const Real w = a[0] * b[1] - b[0] * a[1];
      area += w / 2;
      mx += w * (a[0] + b[0]) / 6;
      my += w * (a[1] + b[1]) / 6;
      xx += w * (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]) / 12;
      yy += w * (a[1] * a[1] + a[1] * b[1] + b[1] * b[1]) / 12;
      xy += w * (a[0] * b[1] + 2 * a[0] * a[1] + 2 * b[0] * b[1] + b[0] * a[1]) / 24;
    }
    const Real h = height;
    return TenMoments{ area * h, mx * h, my * h, area * h * h / 2, xx * h, yy * h, area * h * h * h / 3,
      xy * h, my * h * h / 2, mx * h * h / 2 };
  };
  return solid;
}

/// An ellipsoid with the axes 1 + c, about (3, -2, 1); with one c for all axes a ball.
inline VariantSolid MakeEllipsoid(bool isBall)
{
  const std::array<double, 3> center{ 3.0, -2.0, 1.0 };
  const auto make = [=](const std::array<double, 3>& scale)
  {
    const std::shared_ptr<sm::Face> face = MakeBall({ 0.0, 0.0, 0.0 }, 1.0);
    for (std::array<double, 4>& point : face->Surface.ControlPoints)
    {
      for (int c = 0; c < 3; ++c)
      {
        point[c] = scale[c] * point[c] + center[c] * point[3];
      }
    }
    return MakeModel({ face }, { 2.0, 4.0, -3.0, -1.0, 0.0, 2.0 });
  };
  VariantSolid solid;
  solid.Name = isBall ? "ball by its radius" : "ellipsoid by its axes";
  if (isBall)
  {
    solid.Shape = MakeShape(make({ 1, 1, 1 }), { { make({ 2, 2, 2 }), 1.0 } });
  }
  else
  {
    solid.Shape = MakeShape(make({ 1, 1, 1 }),
      { { make({ 2, 1, 1 }), 1.0 }, { make({ 1, 2, 1 }), 1.0 }, { make({ 1, 1, 3 }), 2.0 } });
  }
  solid.Ranges.assign(isBall ? 1 : 3, 0.7);
  solid.Truth = [=](const Numbers& c)
  {
    // V = 4/3 pi abc, and V a^2 / 5 for the second moments about the centre.
    const Real axes[3] = { 1 + c[0], 1 + c[isBall ? 0 : 1], 1 + c[isBall ? 0 : 2] };
    TenMoments m{};
    m[0] = 4 * Pi / 3 * axes[0] * axes[1] * axes[2];
    for (int i = 0; i < 3; ++i)
    {
      m[4 + i] = m[0] * axes[i] * axes[i] / 5;
    }
    return About(m, { -center[0], -center[1], -center[2] });
  };
  return solid;
}

/// A torus with the radii 3 + c_1 and 1 + c_2, 2 pi^2 R r^2.
inline VariantSolid MakeTorusOfRadii()
{
  const auto make = [](double ring, double tube) {
    return MakeModel({ MakeTorus({ 0.0, 0.0, 0.0 }, ring, tube) }, { -4, 4, -4, 4, -1, 1 });
  };
  VariantSolid solid;
  solid.Name = "torus by its radii";
  solid.Shape = MakeShape(make(3.0, 1.0), { { make(4.0, 1.0), 1.0 }, { make(3.0, 1.5), 0.5 } });
  solid.Ranges = { 1.0, 0.5 };
  solid.Truth = [](const Numbers& c) { return FromExact(Torus(3 + c[0], 1 + c[1])); };
  return solid;
}

/// The model of a block: six Bézier faces, and edges with the control polygons of its border as polynomial
/// curves, which leave gaps along rational borders.
inline vtkSmartPointer<vtkTrimmedNURBSModel> MakeBlockModel(const RationalBlock& block)
{
  std::map<std::array<int, 4>, std::shared_ptr<const sm::Edge>> edges;
  const auto getPole = [&](const std::array<int, 3>& at)
  {
    const std::size_t index = block.GetIndex(at[0], at[1], at[2]);
    const std::array<double, 3>& p = block.Poles[index];
    const double w = block.Weights.empty() ? 1.0 : block.Weights[index];
    return std::array<double, 4>{ w * p[0], w * p[1], w * p[2], w };
  };
  const bool isLeft = GetHandedness(block) < 0;
  std::vector<sm::FacePointer> faces;
  std::array<double, 6> bounds{ 1e9, -1e9, 1e9, -1e9, 1e9, -1e9 };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int side = 0; side < 2; ++side)
    {
      const int along[2] = { (axis + 1) % 3, (axis + 2) % 3 };
      auto face = std::make_shared<sm::Face>();
      face->Id = sm::NewId();
      face->Reversed = (side == 0) != isLeft;
      sm::NURBSSurface& surface = face->Surface;
      surface.Rational = !block.Weights.empty();
      std::array<int, 3> at{};
      at[axis] = side * block.Degree[axis];
      for (int d = 0; d < 2; ++d)
      {
        const int n = block.Degree[along[d]];
        surface.Degree[d] = n;
        surface.NumberOfControlPoints[d] = n + 1;
        surface.Knots[d].assign(n + 1, 0.0);
        surface.Knots[d].insert(surface.Knots[d].end(), n + 1, 1.0);
      }
      for (int j = 0; j <= block.Degree[along[1]]; ++j)
      {
        for (int i = 0; i <= block.Degree[along[0]]; ++i)
        {
          at[along[0]] = i;
          at[along[1]] = j;
          const std::array<double, 4> point = getPole(at);
          surface.ControlPoints.push_back(point);
          for (int c = 0; c < 3; ++c)
          {
            bounds[2 * c] = std::min(bounds[2 * c], point[c] / point[3]);
            bounds[2 * c + 1] = std::max(bounds[2 * c + 1], point[c] / point[3]);
          }
        }
      }
      sm::Loop loop;
      const std::array<double, 2> corner[4] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
      for (int k = 0; k < 4; ++k)
      {
        const int run = k % 2;
        // The edge runs in the direction of along[run], with the other two indices fixed.
        std::array<int, 3> start{};
        start[axis] = side * block.Degree[axis];
        start[along[1 - run]] = static_cast<int>(corner[k][1 - run]) * block.Degree[along[1 - run]];
        std::array<int, 4> key{ start[0], start[1], start[2], along[run] };
        key[along[run]] = 0;
        std::shared_ptr<const sm::Edge>& known = edges[key];
        if (!known)
        {
          auto edge = std::make_shared<sm::Edge>();
          edge->Id = sm::NewId();
          std::vector<std::array<double, 3>> points;
          for (int i = 0; i <= block.Degree[along[run]]; ++i)
          {
            std::array<int, 3> index = start;
            index[along[run]] = i;
            const std::array<double, 4> p = getPole(index);
            points.push_back({ p[0] / p[3], p[1] / p[3], p[2] / p[3] });
          }
          edge->Curve.Breaks = { 0.0 };
          edge->Curve.AppendPiece(1.0, points.data(), block.Degree[along[run]]);
          edge->StartVertex = points.front();
          edge->EndVertex = points.back();
          known = edge;
        }
        sm::Coedge coedge;
        coedge.Use = known;
        coedge.Reversed = k >= 2;
        const std::array<double, 2> ends[2] = { corner[coedge.Reversed ? (k + 1) % 4 : k],
          corner[coedge.Reversed ? k : (k + 1) % 4] };
        coedge.Curve.Breaks = { 0.0 };
        coedge.Curve.AppendPiece(1.0, ends, 1);
        loop.Coedges.push_back(coedge);
      }
      face->Loops.push_back(loop);
      faces.push_back(face);
    }
  }
  return MakeModel(faces, bounds);
}

/// A block whose poles move, K directions that take all poles along, by pseudo-random vectors.
inline VariantSolid MakeBlock(const std::array<int, 3>& degree, bool isRational, int directions)
{
  const auto noise = [](int seed)
  {
    // A fixed sequence, between -1 and 1.
    const double x = std::sin(12.9898 * seed + 4.1414) * 43758.5453;
    return 2.0 * (x - std::floor(x)) - 1.0;
  };
  RationalBlock base = smtest::MakeBlock(degree,
    [](double u, double v, double w) {
      return std::array<double, 3>{ 2.0 * u + 0.2 * v * w, 1.5 * v + 0.1 * u * u, w + 0.15 * u * v };
    });
  std::vector<RationalBlock> moved(directions, base);
  for (int k = 0; k < directions; ++k)
  {
    for (std::size_t i = 0; i < base.Poles.size(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        moved[k].Poles[i][c] += 0.25 * noise(1000 * (k + 1) + 3 * static_cast<int>(i) + c);
      }
    }
  }
  // Other parameters of the same solid: weights that vary in all directions, and edges out of step with the
  // faces.
  const auto make = [isRational](const RationalBlock& block) {
    return MakeBlockModel(isRational ? Reparametrized(block, { 1.5, 0.7, 1.4 }) : block);
  };
  VariantSolid solid;
  solid.Name = std::string(isRational ? "rational" : "polynomial") + " block of degrees " +
    std::to_string(degree[0]) + " " + std::to_string(degree[1]) + " " + std::to_string(degree[2]);
  std::vector<sm::MovedModel> models;
  for (const RationalBlock& block : moved)
  {
    models.push_back({ make(block), 1.0 });
  }
  solid.Shape = MakeShape(make(base), models);
  solid.Ranges.assign(directions, 0.6 / directions);
  solid.Truth = [=](const Numbers& c)
  {
    RationalBlock block = base;
    for (std::size_t i = 0; i < base.Poles.size(); ++i)
    {
      for (int d = 0; d < 3; ++d)
      {
        Real p = base.Poles[i][d];
        for (int k = 0; k < directions; ++k)
        {
          p += c[k] * (static_cast<Real>(moved[k].Poles[i][d]) - base.Poles[i][d]);
        }
        block.Poles[i][d] = static_cast<double>(p);
      }
    }
    return FromExact(IntegrateBlock(block));
  };
  return solid;
}
}

#endif
