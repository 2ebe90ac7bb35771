// Other closings of a box with gaps, each a model of its own that is integrated: no quantity changes by more
// than its spread, and aligned moves change the volume by at least half of it. Open solids have no spread,
// totals have the sum.
#include "smBoxBodies.h"
#include "smComputeMassProperties.h"
#include "smGappedSolids.h"
#include "smTesting.h"

#include <vtkMatrix4x4.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>

#include <map>
#include <random>

namespace
{
using namespace smtest;

constexpr double Gap = 2e-4;
constexpr double Tolerance = 5e-3;

vtkSmartPointer<vtkNURBSDataSet> MakeBox(int faces = 6)
{
  BoxBody body;
  body.Add({ { 1.0, 2.0, 3.0 }, { 5.0, 5.0, 5.0 }, true, faces });
  return body.Make();
}

vtkSmartPointer<vtkNURBSDataSet> MakeLeaf(vtkNURBSDataSet* source, vtkTrimmedNURBSModel* model)
{
  auto leaf = vtkSmartPointer<vtkNURBSDataSet>::New();
  leaf->ShallowCopy(source);
  leaf->SetModel(model);
  return leaf;
}

sm::BodyMassProperties Compute(vtkDataObject* data, double density = 0.0)
{
  sm::MassPropertiesOptions options;
  options.RelativeTolerance = 1e-13;
  options.Density = density;
  options.DensityTolerance = 0.01;
  options.GapLimit = 1.0;
  return sm::ComputeMassProperties(data, options).Total;
}

/// How an edge is closed: how far the boundary of each face moves out of it, relative to the tolerance, and
/// the weights of both boundaries in the common curve.
struct Move
{
  double Out[2] = { 0.0, 0.0 };
  double Weights[2] = { 0.0, 0.0 };
};

/// Returns the model with its edges closed in another way. Its curves have one piece of degree 4, and its
/// faces are planes, so that the moved curves are polynomials, too.
vtkSmartPointer<vtkTrimmedNURBSModel> Close(
  vtkTrimmedNURBSModel* source, const std::map<const sm::Edge*, Move>& moves)
{
  std::map<const sm::Edge*, std::shared_ptr<sm::Edge>> edges;
  std::map<const sm::Edge*, int> uses;
  std::vector<sm::FacePointer> faces;
  for (const sm::FacePointer& face : source->GetFaces())
  {
    auto copy = std::make_shared<sm::Face>(*face);
    copy->Id = sm::NewId();
    for (sm::Coedge& coedge : copy->Loops[0].Coedges)
    {
      const sm::Edge* original = coedge.Use.get();
      const int use = uses[original]++;
      std::shared_ptr<sm::Edge>& edge = edges[original];
      if (!edge)
      {
        edge = std::make_shared<sm::Edge>(*original);
        edge->Id = sm::NewId();
      }
      const auto found = moves.find(original);
      const Move move = found != moves.end() ? found->second : Move();
      for (std::size_t i = 1; i + 1 < edge->Curve.Coefficients.size(); ++i)
      {
        const std::array<double, 2>& at = coedge.Curve.Coefficients[i];
        sm::Vector3 point;
        face->Surface.Evaluate(at[0], at[1], point.data());
        for (int d = 0; d < 3; ++d)
        {
          edge->Curve.Coefficients[i][d] +=
            move.Weights[use] * (point[d] - original->Curve.Coefficients[i][d]);
        }
      }
      // The face is left of its loop.
      const std::array<double, 2>& start = coedge.Curve.GetStartPoint();
      const std::array<double, 2>& end = coedge.Curve.GetEndPoint();
      const double turn = coedge.Reversed ? -1.0 : 1.0;
      std::array<double, 2> out = { turn * (end[1] - start[1]), -turn * (end[0] - start[0]) };
      sm::Vector3 point;
      sm::Vector3 du;
      sm::Vector3 dv;
      face->Surface.Evaluate(0.5, 0.5, point.data(), du.data(), dv.data());
      const double length = std::hypot(out[0] * sm::Norm(du), out[1] * sm::Norm(dv));
      for (std::size_t i = 1; i + 1 < coedge.Curve.Coefficients.size(); ++i)
      {
        coedge.Curve.Coefficients[i][0] += move.Out[use] * Tolerance * out[0] / length;
        coedge.Curve.Coefficients[i][1] += move.Out[use] * Tolerance * out[1] / length;
      }
      coedge.Use = edge;
    }
    faces.push_back(copy);
  }
  auto model = vtkSmartPointer<vtkTrimmedNURBSModel>::New();
  model->ShallowCopy(source);
  model->SetFaces(faces);
  return model;
}

template <std::size_t N>
void CheckChange(const char* what, const sm::Bounded<std::array<double, N>>& before,
  const sm::Bounded<std::array<double, N>>& after, double& reached)
{
  for (std::size_t i = 0; i < N; ++i)
  {
    const double change = std::abs(after.Value[i] - before.Value[i]) - before.Bound - after.Bound;
    if (!(change <= before.Spread))
    {
      Check(what, before.Value[i], after.Value[i], before.Spread);
    }
    reached = std::max(reached, change / before.Spread);
  }
}

void CheckMoves()
{
  std::printf("--- moves of all edges of a box\n");
  std::mt19937 random(7);
  const auto box = MakeBox();
  const auto model = OpenGaps(box->GetModel(), Gap, Tolerance, random);
  const sm::BodyMassProperties before = Compute(MakeLeaf(box, model));
  std::vector<const sm::Edge*> edges;
  for (const sm::FacePointer& face : model->GetFaces())
  {
    for (const sm::Coedge& coedge : face->Loops[0].Coedges)
    {
      if (std::find(edges.begin(), edges.end(), coedge.Use.get()) == edges.end())
      {
        edges.push_back(coedge.Use.get());
      }
    }
  }
  CheckEqual("edges", 12, static_cast<long long>(edges.size()));
  // Boundaries start up to two gaps from the edge, and keep as far from the end of their range.
  constexpr double farthest = 1.0 - 4.0 * Gap / Tolerance;
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  double reached[5] = { 0.0, 0.0, 0.0, 0.0, 0.0 };
  for (int run = 0; run < 300; ++run)
  {
    std::map<const sm::Edge*, Move> moves;
    for (const sm::Edge* edge : edges)
    {
      Move move;
      move.Weights[0] = std::abs(draw(random));
      move.Weights[1] = (1.0 - move.Weights[0]) * std::abs(draw(random));
      for (double& out : move.Out)
      {
        // Half of them as far as possible.
        out = farthest * std::min(std::max(2.0 * draw(random), -1.0), 1.0);
      }
      moves[edge] = move;
    }
    const sm::BodyMassProperties after = Compute(MakeLeaf(box, Close(model, moves)));
    const sm::Bounded<std::array<double, 1>> volumes[2] = { { { before.Volume.Value }, before.Volume.Bound,
                                                              before.Volume.Spread },
      { { after.Volume.Value }, after.Volume.Bound, after.Volume.Spread } };
    const sm::Bounded<std::array<double, 1>> areas[2] = { { { before.Area.Value }, before.Area.Bound,
                                                            before.Area.Spread },
      { { after.Area.Value }, after.Area.Bound, after.Area.Spread } };
    CheckChange("volume", volumes[0], volumes[1], reached[0]);
    CheckChange("area", areas[0], areas[1], reached[1]);
    CheckChange("centre", before.Center, after.Center, reached[2]);
    CheckChange("inertia", before.Inertia, after.Inertia, reached[3]);
    CheckChange("principal moments", before.PrincipalMoments, after.PrincipalMoments, reached[4]);
  }
  for (const double part : reached)
  {
    CheckRange("largest part of a spread that a change reached", 0.02, part, 1.0);
  }

  // Each edge by itself, in both directions; then all that add volume, or all that remove it.
  std::map<const sm::Edge*, Move> best[2];
  for (const sm::Edge* edge : edges)
  {
    double largest[2] = { 0.0, 0.0 };
    for (int choice = 0; choice < 12; ++choice)
    {
      Move move;
      move.Out[0] = (choice & 1 ? farthest : -farthest);
      move.Out[1] = (choice & 2 ? farthest : -farthest);
      move.Weights[0] = choice / 4 == 1 ? 1.0 : 0.0;
      move.Weights[1] = choice / 4 == 2 ? 1.0 : 0.0;
      const double change =
        Compute(MakeLeaf(box, Close(model, { { edge, move } }))).Volume.Value - before.Volume.Value;
      for (int sign = 0; sign < 2; ++sign)
      {
        const double signedChange = sign == 0 ? change : -change;
        if (signedChange > largest[sign])
        {
          largest[sign] = signedChange;
          best[sign][edge] = move;
        }
      }
    }
  }
  double worst = 0.0;
  for (const auto& moves : best)
  {
    const double volume = Compute(MakeLeaf(box, Close(model, moves))).Volume.Value;
    worst = std::max(worst, std::abs(volume - before.Volume.Value));
  }
  // Polynomials do not stay at the ends of their range: TestClosingSpread has sharper moves.
  CheckRange("aligned moves of whole curves", 0.4 * before.Volume.Spread, worst, before.Volume.Spread);
}

void CheckTotals()
{
  std::printf("--- instances, densities, open solids\n");
  std::mt19937 random(8);
  const auto box = MakeBox();
  const auto model = OpenGaps(box->GetModel(), Gap, Tolerance, random);
  const sm::BodyMassProperties one = Compute(MakeLeaf(box, model), 2700.0);
  CheckTrue("a spread", one.Volume.Spread > 0.0 && one.Volume.Spread < 1e-3);
  Check("of the mass", 2.7e-6 * one.Volume.Spread, one.Mass.Spread, 1e-15 * one.Mass.Spread);

  vtkNew<vtkPartitionedDataSetCollection> product;
  product->SetPartition(0, 0, MakeLeaf(box, model));
  auto second = MakeLeaf(box, model);
  vtkNew<vtkMatrix4x4> placement;
  const double rows[16] = { 0, -1, 0, 10, 1, 0, 0, -20, 0, 0, 1, 30, 0, 0, 0, 1 };
  placement->DeepCopy(rows);
  second->SetPlacement(placement);
  product->SetPartition(1, 0, second);
  const sm::BodyMassProperties two = Compute(product, 2700.0);
  Check("volume of two", 2.0 * one.Volume.Spread, two.Volume.Spread, 1e-15);
  Check("mass of two", 2.0 * one.Mass.Spread, two.Mass.Spread, 1e-20);
  Check("area of two", 2.0 * one.Area.Spread, two.Area.Spread, 1e-15);
  // Both centres are some 18 from the common one: the volumes alone move it by at most twice that times the
  // change over the volume.
  CheckRange("centre of two", 0.3 * one.Center.Spread, two.Center.Spread,
    20.0 * two.Volume.Spread / two.Volume.Value + one.Center.Spread);
  CheckRange("inertia of two", 2.0 * one.Inertia.Spread, two.Inertia.Spread, 1e4 * two.Volume.Spread);

  const sm::BodyMassProperties open = Compute(MakeBox(5), 2700.0);
  CheckTrue("an open solid has a volume", std::isfinite(open.Volume.Value));
  for (const double spread : { open.Volume.Spread, open.Area.Spread, open.Center.Spread, open.Inertia.Spread,
         open.PrincipalMoments.Spread, open.Mass.Spread, open.MassInertia.Spread })
  {
    CheckTrue("and no spread", std::isnan(spread));
  }
  product->SetPartition(2, 0, MakeBox(5));
  const sm::BodyMassProperties three = Compute(product, 2700.0);
  CheckTrue("nor has a total with it",
    std::isfinite(three.Volume.Value) && std::isnan(three.Volume.Spread) && std::isnan(three.Mass.Spread) &&
      std::isnan(three.Area.Spread));
  const sm::BodyMassProperties exact = Compute(MakeBox(), 2700.0);
  Check("a box without gaps and tolerances", 0.0, exact.Volume.Spread, 0.0);
  Check("its area", 0.0, exact.Area.Spread, 0.0);
}
}

int TestMassSpread(int, char*[])
{
  CheckMoves();
  CheckTotals();
  return Finish();
}
