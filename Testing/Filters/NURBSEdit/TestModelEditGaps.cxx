// Gaps that edits open, however narrow, and faces that cannot be evaluated.
#include "smLatticeBody.h"
#include "smModelEdit.h"
#include "smTesting.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using namespace smtest;

const LatticeBody::Point Move{ 0.3, -0.2, 0.7 };

/// The widest gap lies between samples; there are enough of them.
void CheckGapSamples()
{
  std::printf("--- a narrow gap\n");
  LatticeBody body;
  body.Degree = sm::MaximumDegree;
  body.Cells = 1;
  body.Knots.assign(body.Degree + 1, 0.0);
  body.Knots.resize(2 * body.Degree + 2, 1.0);
  const auto leaf = body.Make();
  // B_4 of degree 25, largest at 4/25.
  const sm::ModelEdit edit = sm::MoveControlPoints(
    leaf->GetModel(), 0, { { 4, body.Degree } }, { 1.0, 0.0, 0.0 }, sm::EditRule::OneFace);
  const double largest = 12650.0 * std::pow(0.16, 4) * std::pow(0.84, 21);
  CheckEqual("opened", 1, static_cast<long long>(edit.Opened.size()));
  // 32 samples are at most 1/64 from it: 1 - B / B_max < (1/64)^2 / 2 * 25 / (0.16 0.84) = 0.023, here 0.004.
  CheckRange("gap", 0.99 * largest, edit.Opened.empty() ? 0.0 : edit.Opened[0].Gap, largest * (1.0 + 1e-9));
}

/// Faces that cannot be evaluated lie in a model untouched, and are not obstacle to edits of others.
void CheckBrokenFaces()
{
  std::printf("--- next to broken faces\n");
  LatticeBody body;
  const auto leaf = body.Make();
  vtkTrimmedNURBSModel* model = leaf->GetModel();
  auto broken = std::make_shared<sm::Face>(*model->GetFaces()[3]);
  broken->Id = sm::NewId();
  broken->Surface = sm::NURBSSurface();
  broken->Surface.NumberOfControlPoints[0] = broken->Surface.NumberOfControlPoints[1] = 2;
  model->SetFace(3, broken);
  auto bare = std::make_shared<sm::Face>(*model->GetFaces()[5]);
  bare->Id = sm::NewId();
  auto edge = std::make_shared<sm::Edge>(*bare->Loops[0].Coedges[0].Use);
  edge->Curve = {};
  bare->Loops[0].Coedges[0].Use = edge;
  bare->Loops[0].Coedges[1].Curve = {};
  model->SetFace(5, bare);
  const sm::EditRule rule = sm::EditRule::MoveSharedBoundary;
  const int last = body.GetNumberOfPoints() - 1;
  for (const int k : { 0, last })
  {
    const sm::ModelEdit edit = sm::MoveControlPoints(model, 5, { { k, k }, { 0, last } }, Move, rule);
    CheckEqual("status", "ok", sm::GetName(edit.Status));
    CheckTrue("it moved", edit.Model && edit.Model->GetFaces()[5] != bare);
  }
  std::array<double, 4> point;
  CheckTrue("no points of a broken face", !sm::GetControlPoint(model, 3, { 1, 1 }, point));
  const auto still = [](const LatticeBody::Point& p) { return p; };
  CheckEqual("moving them", "invalid-face",
    sm::GetName(sm::MoveControlPoints(model, 3, { { 1, 1 } }, Move, rule).Status));
  CheckEqual(
    "mapping them", "invalid-face", sm::GetName(sm::MapControlPoints(model, {}, still, rule).Status));
  // A NaN gap is reported, and not hidden by those measured after it.
  const auto sound = body.Make();
  vtkNew<vtkTrimmedNURBSModel> odd;
  odd->ShallowCopy(sound->GetModel());
  auto face = std::make_shared<sm::Face>(*odd->GetFaces()[5]);
  face->Id = sm::NewId();
  auto half = std::make_shared<sm::Edge>(*face->Loops[0].Coedges[0].Use);
  const LatticeBody::Point ends[2] = { half->Curve.GetStartPoint(), half->Curve.GetEndPoint() };
  const LatticeBody::Point middle{ 0.5 * (ends[0][0] + ends[1][0]), 0.5 * (ends[0][1] + ends[1][1]),
    ends[0][2] };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const LatticeBody::Point start[3] = { ends[0], { nan, nan, nan }, middle };
  const LatticeBody::Point rest[2] = { middle, ends[1] };
  half->Curve = {};
  half->Curve.Breaks = { 0.0 };
  half->Curve.AppendPiece(0.5, start, 2);
  half->Curve.AppendPiece(1.0, rest, 1);
  face->Loops[0].Coedges[0].Use = half;
  odd->SetFace(5, face);
  const std::vector<sm::OpenedEdge> opened = sm::FindOpenedEdges(sound->GetModel(), odd);
  CheckTrue("a NaN gap is reported",
    std::any_of(opened.begin(), opened.end(), [](const sm::OpenedEdge& e) { return std::isnan(e.Gap); }));
  CheckEqual("such an edge is refused", "invalid-face",
    sm::GetName(sm::ReplaceFace(sound->GetModel(), 5, face).Status));
}
}

int TestModelEditGaps(int, char*[])
{
  CheckGapSamples();
  CheckBrokenFaces();
  return Finish();
}
