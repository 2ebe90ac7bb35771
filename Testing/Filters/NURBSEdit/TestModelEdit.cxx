// Edits of control points, weights and faces: what moves along, what opens, what comes back, and what is
// refused.
#include "smDecimalCommas.h"
#include "smLatticeBody.h"
#include "smModelEdit.h"
#include "smTesting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace
{
using namespace smtest;
using Homogeneous = std::array<double, 4>;

const LatticeBody::Point Displacement{ 0.3, -0.2, 0.7 };

bool HaveSameBits(const sm::Edge& a, const sm::Edge& b)
{
  return a.Curve.Coefficients == b.Curve.Coefficients && a.Curve.Breaks == b.Curve.Breaks &&
    a.Curve.Offsets == b.Curve.Offsets && a.Curve.Residual == b.Curve.Residual &&
    a.StartVertex == b.StartVertex && a.EndVertex == b.EndVertex;
}

/// Returns true if the models have the same bits in everything but ids.
bool HaveSameBits(vtkTrimmedNURBSModel* a, vtkTrimmedNURBSModel* b)
{
  bool same = a->GetNumberOfFaces() == b->GetNumberOfFaces();
  for (vtkIdType f = 0; same && f < a->GetNumberOfFaces(); ++f)
  {
    const sm::Face& x = *a->GetFaces()[f];
    const sm::Face& y = *b->GetFaces()[f];
    same = x.Surface.ControlPoints == y.Surface.ControlPoints && x.Surface.Rational == y.Surface.Rational &&
      x.Loops.size() == y.Loops.size();
    for (std::size_t l = 0; same && l < x.Loops.size(); ++l)
    {
      for (std::size_t c = 0; same && c < x.Loops[l].Coedges.size(); ++c)
      {
        same = HaveSameBits(*x.Loops[l].Coedges[c].Use, *y.Loops[l].Coedges[c].Use);
      }
    }
  }
  return same;
}

bool IsPaired(vtkTrimmedNURBSModel* model)
{
  std::map<const sm::Edge*, int> uses;
  for (const sm::FacePointer& face : model->GetFaces())
  {
    for (const sm::Coedge& coedge : face->Loops[0].Coedges)
    {
      uses[coedge.Use.get()] += coedge.Reversed == face->Reversed ? 1 : -1;
    }
  }
  return std::all_of(uses.begin(), uses.end(), [](const auto& use) { return use.second == 0; });
}

/// The face's control point of point (i,j,k) of the lattice.
sm::ControlPointIndex At(const LatticeBody& body, int axis, int side, int i, int j, int k)
{
  const int at[3] = { i, j, k };
  const auto index =
    LatticeBody::ToFace(side, body.GetNumberOfPoints() - 1, at[(axis + 1) % 3], at[(axis + 2) % 3]);
  return { index[0], index[1] };
}

/// Moves a point of the face z = top, and back.
void CheckMove(const std::string& what, int i, int j, std::size_t faces)
{
  std::printf("--- %s\n", what.c_str());
  LatticeBody body;
  const auto leaf = body.Make();
  vtkTrimmedNURBSModel* model = leaf->GetModel();
  const std::vector<sm::FacePointer> before = model->GetFaces();
  const int last = body.GetNumberOfPoints() - 1;
  const sm::ControlPointIndex index = At(body, 2, 1, i, j, last);
  Homogeneous point;
  CheckTrue("it exists", sm::GetControlPoint(model, 5, index, point));

  const sm::ModelEdit edit =
    sm::MoveControlPoints(model, 5, { index }, Displacement, sm::EditRule::MoveSharedBoundary);
  CheckEqual("status", "ok", sm::GetName(edit.Status));
  CheckTrue("the model stays", model->GetFaces() == before);
  CheckEqual(
    "faces that are new", static_cast<long long>(faces), static_cast<long long>(edit.Replaced.size()));
  std::set<std::uint64_t> ids;
  int shared = 0;
  for (int f = 0; f < 6; ++f)
  {
    ids.insert(before[f]->Id);
    ids.insert(edit.Model->GetFaces()[f]->Id);
    shared += edit.Model->GetFaces()[f] == before[f] ? 1 : 0;
  }
  CheckEqual("the others are shared", static_cast<long long>(6 - faces), shared);
  CheckEqual("new ids", static_cast<long long>(6 + faces), static_cast<long long>(ids.size()));
  Homogeneous moved;
  sm::GetControlPoint(edit.Model, 5, index, moved);
  for (int c = 0; c < 3; ++c)
  {
    Check("it moved", point[c] + Displacement[c], moved[c], 0.0);
  }
  CheckEqual("nothing opened", 0, static_cast<long long>(edit.Opened.size()));
  CheckTrue("edges are shared by two faces", IsPaired(edit.Model));

  const sm::ModelEdit second =
    sm::MoveControlPoints(edit.Model, 5, { index }, { 0.1, 0.1, 0.1 }, sm::EditRule::MoveSharedBoundary);
  const sm::ModelEdit back =
    sm::SetControlPoints(second.Model, 5, { { index, point } }, sm::EditRule::MoveSharedBoundary);
  CheckTrue("setting it back gives the same bits", HaveSameBits(model, back.Model));
  CheckTrue("the edit did not", !HaveSameBits(model, edit.Model));
  const sm::ModelEdit undone = sm::ReplaceFaces(edit.Model, edit.Replaced);
  CheckTrue("so does an undo, with the same faces", undone.Model->GetFaces() == before);

  // An edit of this face alone names the edges that it opens, with the width of the gap.
  const sm::ModelEdit alone = sm::MoveControlPoints(model, 5, { index }, Displacement, sm::EditRule::OneFace);
  CheckEqual("one face", 1, static_cast<long long>(alone.Replaced.size()));
  CheckEqual("opened edges", static_cast<long long>(faces) - 1, static_cast<long long>(alone.Opened.size()));
  for (const sm::OpenedEdge& opened : alone.Opened)
  {
    CheckEqual("face", 5, opened.Face);
    Check("gap before", 0.0, opened.GapBefore, 1e-14, "rounding");
    // A corner's basis function is 1 there; its foot may lie on the edge's line. Else a cubic's maximum.
    const double length = std::hypot(Displacement[0], Displacement[1], Displacement[2]);
    CheckRange("gap", 0.3 * length, opened.Gap, length * (1.0 + 1e-9));
  }
  const sm::ModelEdit closed =
    sm::SetControlPoints(alone.Model, 5, { { index, point } }, sm::EditRule::OneFace);
  CheckTrue("set back it is closed", HaveSameBits(model, closed.Model) && closed.Opened.empty());
}

void CheckWeights()
{
  std::printf("--- weights\n");
  LatticeBody body;
  const auto leaf = body.Make();
  const int last = body.GetNumberOfPoints() - 1;
  // On the edge of z = top and x = 0, bent first, so that a weight moves points.
  const sm::ControlPointIndex index = At(body, 2, 1, 0, 2, last);
  const sm::ModelEdit bent =
    sm::MoveControlPoints(leaf->GetModel(), 5, { index }, Displacement, sm::EditRule::MoveSharedBoundary);
  const sm::ModelEdit edit = sm::SetWeights(bent.Model, 5, { index }, 3.5, sm::EditRule::MoveSharedBoundary);
  CheckEqual("status", "ok", sm::GetName(edit.Status));
  CheckEqual("faces", 2, static_cast<long long>(edit.Replaced.size()));
  CheckTrue("rational now", edit.Model->GetFaces()[5]->Surface.Rational);
  CheckEqual("nothing opened", 0, static_cast<long long>(edit.Opened.size()));
  Homogeneous point;
  sm::GetControlPoint(bent.Model, 5, index, point);
  const sm::ModelEdit back =
    sm::SetControlPoints(edit.Model, 5, { { index, point } }, sm::EditRule::MoveSharedBoundary);
  CheckTrue("set back: the same bits", HaveSameBits(bent.Model, back.Model));
  const sm::ModelEdit alone = sm::SetWeights(bent.Model, 5, { index }, 3.5, sm::EditRule::OneFace);
  CheckEqual("on one face it opens", 1, static_cast<long long>(alone.Opened.size()));
}

void CheckReplacement()
{
  std::printf("--- a whole face\n");
  LatticeBody body;
  const auto leaf = body.Make();
  vtkTrimmedNURBSModel* model = leaf->GetModel();
  auto face = std::make_shared<sm::Face>(*model->GetFaces()[5]);
  face->Id = sm::NewId();
  for (Homogeneous& point : face->Surface.ControlPoints)
  {
    point[2] += 1.0;
  }
  const sm::ModelEdit lifted = sm::ReplaceFace(model, 5, face, sm::EditRule::MoveSharedBoundary);
  CheckEqual("status", "ok", sm::GetName(lifted.Status));
  CheckEqual("the lid and its neighbours", 5, static_cast<long long>(lifted.Replaced.size()));
  CheckEqual("nothing opened", 0, static_cast<long long>(lifted.Opened.size()));
  const sm::ModelEdit alone = sm::ReplaceFace(model, 5, face);
  CheckTrue("alone it is the face that was given", alone.Model->GetFaces()[5] == face);
  CheckEqual("and opens four edges", 4, static_cast<long long>(alone.Opened.size()));
  for (const sm::OpenedEdge& opened : alone.Opened)
  {
    Check("by one", 1.0, opened.Gap, 1e-14, "rounding");
  }
  auto loose = std::make_shared<sm::Face>(*model->GetFaces()[5]);
  loose->Id = sm::NewId();
  for (sm::Coedge& coedge : loose->Loops[0].Coedges)
  {
    coedge.Use = std::make_shared<sm::Edge>(*coedge.Use);
  }
  const sm::ModelEdit unpaired = sm::ReplaceFace(model, 5, loose);
  CheckEqual(
    "edges of its own leave the neighbours' open", 4, static_cast<long long>(unpaired.Opened.size()));
  CheckTrue("as wide as it gets",
    !unpaired.Opened.empty() && std::isinf(unpaired.Opened[0].Gap) && unpaired.Opened[0].Face == -1);
}

void CheckMap()
{
  std::printf("--- a map of all control points\n");
  LatticeBody body;
  const auto leaf = body.Make();
  vtkTrimmedNURBSModel* model = leaf->GetModel();
  const auto bend = [](const LatticeBody::Point& p) -> LatticeBody::Point {
    return { p[0] + 0.1 * p[2] * p[2], p[1], p[2] + 0.05 * p[0] * p[1] };
  };
  const sm::ModelEdit edit = sm::MapControlPoints(model, {}, bend, sm::EditRule::OneFace);
  CheckEqual("all faces", 6, static_cast<long long>(edit.Replaced.size()));
  CheckEqual("rows that coincide stay closed", 0, static_cast<long long>(edit.Opened.size()));
  CheckTrue("edges are shared", IsPaired(edit.Model));
  const auto still = [](const LatticeBody::Point& p) { return p; };
  const sm::ModelEdit none = sm::MapControlPoints(model, {}, still, sm::EditRule::OneFace);
  CheckTrue("a map that does nothing keeps the faces",
    none.Replaced.empty() && none.Model->GetFaces() == model->GetFaces());
  // The same by faces: a lid moved alone opens, its neighbours follow where the rule says so.
  const sm::ModelEdit lid = sm::MapControlPoints(model, { 5 }, bend, sm::EditRule::OneFace);
  CheckEqual("the lid alone opens", 4, static_cast<long long>(lid.Opened.size()));
  const sm::ModelEdit carried = sm::MapControlPoints(model, { 5 }, bend, sm::EditRule::MoveSharedBoundary);
  CheckEqual("with its neighbours it does not", 0, static_cast<long long>(carried.Opened.size()));
  CheckEqual("five faces", 5, static_cast<long long>(carried.Replaced.size()));
}

/// A corner that meets another one leaves it alone when it is set back.
void CheckSnap()
{
  std::printf("--- a corner on another corner, and back\n");
  LatticeBody body;
  const auto leaf = body.Make();
  vtkTrimmedNURBSModel* model = leaf->GetModel();
  const int last = body.GetNumberOfPoints() - 1;
  const sm::ControlPointIndex corner = At(body, 2, 1, 0, 0, last);
  Homogeneous from;
  Homogeneous to;
  sm::GetControlPoint(model, 5, corner, from);
  sm::GetControlPoint(model, 5, At(body, 2, 1, 0, last, last), to);
  const sm::EditRule rule = sm::EditRule::MoveSharedBoundary;
  const sm::ModelEdit edit = sm::SetControlPoints(model, 5, { { corner, to } }, rule);
  CheckEqual("faces", 3, static_cast<long long>(edit.Replaced.size()));
  const sm::ModelEdit back = sm::SetControlPoints(edit.Model, 5, { { corner, from } }, rule);
  CheckEqual("the same faces", 3, static_cast<long long>(back.Replaced.size()));
  CheckTrue("the same bits", HaveSameBits(model, back.Model));
}

/// The body with its vertices off its corners, as files have them, and a lid whose rows are not its
/// neighbours'.
vtkSmartPointer<vtkNURBSDataSet> MakeLoose(double off)
{
  LatticeBody body;
  const auto leaf = body.Make();
  LatticeBody fine;
  fine.Knots = { 0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1 };
  std::map<const sm::Edge*, std::shared_ptr<const sm::Edge>> loose;
  for (int f = 0; f < 6; ++f)
  {
    auto face = std::make_shared<sm::Face>(*leaf->GetModel()->GetFaces()[f]);
    face->Id = sm::NewId();
    face->Surface = f == 5 ? fine.Make()->GetModel()->GetFaces()[5]->Surface : face->Surface;
    for (sm::Coedge& coedge : face->Loops[0].Coedges)
    {
      std::shared_ptr<const sm::Edge>& known = loose[coedge.Use.get()];
      if (!known)
      {
        auto edge = std::make_shared<sm::Edge>(*coedge.Use);
        edge->Id = sm::NewId();
        edge->StartVertex[0] += off;
        edge->EndVertex[0] += off;
        known = edge;
      }
      coedge.Use = known;
    }
    leaf->GetModel()->SetFace(f, face);
  }
  return leaf;
}

/// The error of a face's surfaces and edges grows with a map that lengthens.
void CheckErrorsGrow()
{
  std::printf("--- residuals and roundings\n");
  LatticeBody body;
  const auto leaf = body.Make();
  vtkTrimmedNURBSModel* model = leaf->GetModel();
  const std::array<double, 3> rounding{ 1e-12, 2e-12, 4e-12 };
  for (int f = 0; f < 6; ++f)
  {
    auto face = std::make_shared<sm::Face>(*model->GetFaces()[f]);
    face->Surface.Rounding = rounding;
    face->Surface.Residual = 1e-7;
    model->SetFace(f, face);
  }
  const auto check = [](const std::string& what, const sm::ModelEdit& edit, int face,
                       const std::array<double, 3>& wanted, double residual)
  {
    const sm::NURBSSurface& surface = edit.Model->GetFaces()[face]->Surface;
    for (int c = 0; c < 3; ++c)
    {
      // Derivatives are differences over 1e-4 of the size.
      Check(what + ", rounding", wanted[c], surface.Rounding[c], 1e-3 * wanted[c]);
    }
    Check(what + ", residual", residual, surface.Residual, 1e-3 * residual);
  };
  const sm::EditRule alone = sm::EditRule::OneFace;
  const auto stretch = [](const LatticeBody::Point& p) {
    return LatticeBody::Point{ 1000.0 * p[0], p[1], 0.5 * p[2] };
  };
  check("stretched", sm::MapControlPoints(model, {}, stretch, alone), 0, { 1e-9, 2e-12, 4e-12 }, 1e-4);
  const auto shear = [](const LatticeBody::Point& p) {
    return LatticeBody::Point{ p[0], p[1] + 3.0 * p[2], p[2] };
  };
  // The largest singular value of a shear by 3 is (3 + sqrt(13)) / 2.
  check("sheared", sm::MapControlPoints(model, {}, shear, alone), 3, { 1e-12, 14e-12, 4e-12 },
    0.5 * (3.0 + std::sqrt(13.0)) * 1e-7);
  const auto move = [](const LatticeBody::Point& p) {
    return LatticeBody::Point{ p[0] + 0.1, p[1] - 7.7, p[2] + 31.0 };
  };
  const sm::ModelEdit moved = sm::MapControlPoints(model, {}, move, alone);
  CheckTrue("moved: not by a bit",
    moved.Model->GetFaces()[2]->Surface.Rounding == rounding &&
      moved.Model->GetFaces()[2]->Surface.Residual == 1e-7);
  const sm::ModelEdit lid = sm::MapControlPoints(model, { 5 }, stretch, sm::EditRule::MoveSharedBoundary);
  check("a neighbour that follows", lid, 0, { 1e-9 + 2e-12, 6e-12, 12e-12 }, 1e-7);
  CheckTrue("the opposite face", lid.Model->GetFaces()[4] == model->GetFaces()[4]);
  // An edge without rows is mapped with its residual.
  const auto loose = MakeLoose(0.0);
  const std::shared_ptr<const sm::Edge> exact = loose->GetModel()->GetFaces()[5]->Loops[0].Coedges[0].Use;
  auto edge = std::make_shared<sm::Edge>(*exact);
  edge->Curve.Residual = { 1e-9, 0.0, 1e-9 };
  for (int f = 0; f < 6; ++f)
  {
    auto face = std::make_shared<sm::Face>(*loose->GetModel()->GetFaces()[f]);
    for (sm::Coedge& coedge : face->Loops[0].Coedges)
    {
      coedge.Use = coedge.Use == exact ? edge : coedge.Use;
    }
    loose->GetModel()->SetFace(f, face);
  }
  const sm::ModelEdit mapped = sm::MapControlPoints(loose->GetModel(), {}, stretch, alone);
  const std::array<double, 3>& residual =
    mapped.Model->GetFaces()[5]->Loops[0].Coedges[0].Use->Curve.Residual;
  Check("residual of an edge, x", 1e-6, residual[0], 1e-9);
  Check("y", 0.0, residual[1], 0.0);
}

/// Vertices that moved without the row whose edge ends there stay where they are when the row moves
/// elsewhere.
void CheckVertices()
{
  std::printf("--- vertices that others moved\n");
  const auto leaf = MakeLoose(1e-3);
  const auto twice = [](const LatticeBody::Point& p) {
    return LatticeBody::Point{ 2.0 * p[0], 2.0 * p[1], 2.0 * p[2] };
  };
  const sm::ModelEdit large = sm::MapControlPoints(leaf->GetModel(), {}, twice, sm::EditRule::OneFace);
  CheckEqual("all faces", 6, static_cast<long long>(large.Replaced.size()));
  const sm::EditRule rule = sm::EditRule::MoveSharedBoundary;
  // On the edge of x = 0 and y = 0, between its ends.
  Homogeneous point;
  sm::GetControlPoint(large.Model, 0, { 0, 2 }, point);
  const sm::ModelEdit edit = sm::MoveControlPoints(large.Model, 0, { { 0, 2 } }, Displacement, rule);
  CheckEqual("the faces of the edge, not those of its ends", 2, static_cast<long long>(edit.Replaced.size()));
  const sm::ModelEdit back = sm::SetControlPoints(edit.Model, 0, { { { 0, 2 }, point } }, rule);
  CheckTrue("set back: the same vertices",
    back.Model->GetFaces()[0]->Loops[0].Coedges[3].Use->EndVertex ==
      large.Model->GetFaces()[0]->Loops[0].Coedges[3].Use->EndVertex);
}

/// A row that left its edge behind, by less than what rows may differ by, does not pull it along later.
void CheckLeftBehind()
{
  std::printf("--- an edge that was left behind\n");
  LatticeBody body;
  const auto leaf = body.Make();
  const int last = body.GetNumberOfPoints() - 1;
  const sm::EditRule rule = sm::EditRule::MoveSharedBoundary;
  const sm::ModelEdit bent =
    sm::MoveControlPoints(leaf->GetModel(), 0, { { 2, last } }, { 0.25, 0.0, 0.0 }, rule);
  const sm::ModelEdit apart = sm::MoveControlPoints(
    bent.Model, 0, { { 1, last } }, { std::ldexp(1.0, -40), 0.0, 0.0 }, sm::EditRule::OneFace);
  CheckEqual("one face", 1, static_cast<long long>(apart.Replaced.size()));
  Homogeneous point;
  sm::GetControlPoint(apart.Model, 0, { 3, last }, point);
  const sm::ModelEdit edit = sm::MoveControlPoints(apart.Model, 0, { { 3, last } }, { 0.5, 0.0, 0.0 }, rule);
  CheckEqual("two faces", 2, static_cast<long long>(edit.Replaced.size()));
  const sm::ModelEdit back = sm::SetControlPoints(edit.Model, 0, { { { 3, last }, point } }, rule);
  CheckTrue("set back: the same bits", HaveSameBits(apart.Model, back.Model));
}

void CheckErrors()
{
  std::printf("--- errors\n");
  LatticeBody body;
  const auto leaf = body.Make();
  vtkTrimmedNURBSModel* model = leaf->GetModel();
  const std::vector<sm::FacePointer> before = model->GetFaces();
  const sm::EditRule rule = sm::EditRule::MoveSharedBoundary;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto check = [](const std::string& status, const sm::ModelEdit& edit)
  {
    CheckEqual("status", status, sm::GetName(edit.Status));
    CheckTrue(
      "a sentence and no model", !edit.Message.empty() && !edit.Model && edit.Replaced.empty(), edit.Message);
  };
  check("no-model", sm::MoveControlPoints(nullptr, 0, { { 0, 0 } }, Displacement, rule));
  check("no-model", sm::ReplaceFaces(nullptr, {}));
  check("no-model", sm::MapControlPoints(nullptr, {}, {}, rule));
  check("no-such-face", sm::MoveControlPoints(model, 6, { { 0, 0 } }, Displacement, rule));
  check("no-such-face", sm::MoveControlPoints(model, -1, { { 0, 0 } }, Displacement, rule));
  check("no-such-face",
    sm::MapControlPoints(
      model, { 7 }, [](const auto& p) { return p; }, rule));
  check("no-such-control-point", sm::MoveControlPoints(model, 0, { { 0, 5 } }, Displacement, rule));
  check("no-such-control-point", sm::SetWeights(model, 0, { { -1, 0 } }, 2.0, rule));
  check("not-finite", sm::MoveControlPoints(model, 0, { { 0, 0 } }, { 0.0, nan, 0.0 }, rule));
  check("not-finite", sm::MoveControlPoints(model, 0, { { 0, 0 } }, { infinity, 0.0, 0.0 }, rule));
  check("not-finite", sm::SetWeights(model, 0, { { 1, 1 } }, nan, rule));
  check("weight-not-positive", sm::SetWeights(model, 0, { { 1, 1 } }, 0.0, rule));
  {
    const DecimalCommas commas;
    const sm::ModelEdit edit = sm::SetWeights(model, 0, { { 1, 1 } }, -0.5, rule);
    check("weight-not-positive", edit);
    CheckEqual("the weight", "the weight -0.5 of a control point is not above 0", edit.Message);
  }
  check(
    "weight-not-positive", sm::SetControlPoints(model, 0, { { { 1, 1 }, { 0.0, 0.0, 0.0, 0.0 } } }, rule));
  check("not-finite",
    sm::MapControlPoints(
      model, {},
      [nan](const auto&) {
        return LatticeBody::Point{ nan, 0.0, 0.0 };
      },
      rule));
  const auto pole = [nan](const LatticeBody::Point& p) {
    return LatticeBody::Point{ p[0] > 0.0 && p[0] < 0.01 ? nan : p[0], p[1], p[2] + 1.0 };
  };
  check("not-finite", sm::MapControlPoints(MakeLoose(1e-3)->GetModel(), {}, pole, rule));
  check("invalid-face", sm::ReplaceFace(model, 0, nullptr));
  auto face = std::make_shared<sm::Face>(*before[0]);
  check("invalid-face", sm::ReplaceFace(model, 0, face));
  face->Id = 0;
  check("invalid-face", sm::ReplaceFace(model, 0, face));
  face->Id = sm::NewId();
  face->Surface.ControlPoints[3][3] = 0.0;
  check("invalid-face", sm::ReplaceFace(model, 0, face));
  face->Surface = before[0]->Surface;
  face->Loops[0].Coedges[1].Use = nullptr;
  check("invalid-face", sm::ReplaceFace(model, 0, face));
  face->Loops = before[0]->Loops;
  check("invalid-face", sm::ReplaceFaces(model, { { 0, face }, { 1, std::make_shared<sm::Face>(*face) } }));
  std::vector<std::array<double, 3>> many(sm::MaximumDegree + 2);
  auto edge = std::make_shared<sm::Edge>(*face->Loops[0].Coedges[0].Use);
  edge->Curve = {};
  edge->Curve.Breaks = { 0.0 };
  edge->Curve.AppendPiece(1.0, many.data(), sm::MaximumDegree + 1);
  face->Loops[0].Coedges[0].Use = edge;
  check("invalid-face", sm::ReplaceFace(model, 0, face));
  face->Loops = before[0]->Loops;
  std::vector<std::array<double, 2>> steps(sm::MaximumDegree + 2);
  face->Loops[0].Coedges[0].Curve = {};
  face->Loops[0].Coedges[0].Curve.Breaks = { 0.0 };
  face->Loops[0].Coedges[0].Curve.AppendPiece(1.0, steps.data(), sm::MaximumDegree + 1);
  check("invalid-face", sm::ReplaceFace(model, 0, face));
  CheckTrue("the model is as it was", model->GetFaces() == before);
  Homogeneous point;
  CheckTrue("no point of no face", !sm::GetControlPoint(model, 6, { 0, 0 }, point));
}
}

int TestModelEdit(int, char*[])
{
  CheckMove("inside a face", 2, 1, 1);
  CheckMove("on an edge", 0, 2, 2);
  CheckMove("on another, across", 2, 4, 2);
  CheckMove("at a corner", 0, 0, 3);
  CheckMove("at the opposite corner", 4, 4, 3);
  CheckWeights();
  CheckReplacement();
  CheckMap();
  CheckSnap();
  CheckVertices();
  CheckErrorsGrow();
  CheckLeftBehind();
  CheckErrors();
  return Finish();
}
