// A model built from arrays by AddEdge(), AddFace() and AddCoedge(): what is stored, and every mistake, which
// changes nothing.
#include "smTestArrays.h"
#include "smTesting.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTrimmedNURBSModel.h"

#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <string>

namespace
{
using smtest::CheckEqual;
using smtest::CheckTrue;
using smtest::MakeArray;

/// A unit square of one bilinear face, and the edge along its side v = 0.
struct Square
{
  vtkNew<vtkTrimmedNURBSModel> Model;
  vtkSmartPointer<vtkDoubleArray> Knots = MakeArray(1, { 0, 0, 1, 1 });
  vtkSmartPointer<vtkDoubleArray> Points = MakeArray(3, { 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0 });
  vtkSmartPointer<vtkDoubleArray> Breaks = MakeArray(1, { 0, 1 });
  vtkSmartPointer<vtkDoubleArray> Line = MakeArray(3, { 0, 0, 0, 1, 0, 0 });
  vtkSmartPointer<vtkDoubleArray> Trim = MakeArray(2, { 0, 0, 1, 0 });
};

void CheckStored()
{
  Square square;
  vtkTrimmedNURBSModel* model = square.Model;
  CheckEqual("first face", 0, model->AddFace(1, square.Knots, 1, square.Knots, square.Points));
  const double h = 0.7071067811865476;
  const auto weighted =
    MakeArray(4, { 1, 0, 0, 1, h, h, 0, h, 0, 1, 0, 1, 1, 0, 2, 1, h, h, 2 * h, h, 0, 1, 2, 1 });
  const auto quadratic = MakeArray(1, { 0, 0, 0, 1, 1, 1 });
  CheckEqual("second face", 1, model->AddFace(2, quadratic, 1, square.Knots, weighted, true));
  const sm::FacePointer plain = model->GetFaces()[0];
  const sm::FacePointer arc = model->GetFaces()[1];
  CheckTrue("weights of 1 are not rational, others are", !plain->Surface.Rational && arc->Surface.Rational);
  CheckTrue("orientation", !plain->Reversed && arc->Reversed);
  CheckTrue("ids", plain->Id != 0 && arc->Id != 0 && plain->Id != arc->Id);
  CheckEqual("control points in u", 3, arc->Surface.NumberOfControlPoints[0]);
  CheckEqual("control points in v", 2, arc->Surface.NumberOfControlPoints[1]);
  double point[3];
  arc->Surface.Evaluate(0.5, 0.5, point);
  smtest::Check("middle of the arc, x", h, point[0], 1e-15);
  smtest::Check("middle of the arc, z", 1.0, point[2], 1e-15);

  CheckEqual("first edge", 0, model->AddEdge(square.Breaks, square.Line));
  const auto bent = MakeArray(3, { 0, 0, 0, 1, 1, 0, 2, 0, 0, 3, -1, 0, 4, 0, 0 });
  CheckEqual("an edge of two parabolas", 1, model->AddEdge(MakeArray(1, { 0, 2, 3 }), bent, 1e-9));
  CheckEqual("a pole", 2, model->AddEdge(MakeArray(1, { 0, 4 }), MakeArray(3, { 0, 0, 1 })));
  CheckTrue("a coedge", model->AddCoedge(0, 0, 0, false, square.Breaks, square.Trim));
  CheckTrue(
    "another of the same loop", model->AddCoedge(0, 0, 1, true, MakeArray(1, { 0, 3 }), square.Trim, 1e-7));
  CheckTrue("one of the next loop", model->AddCoedge(0, 1, 2, false, MakeArray(1, { 0, 4 }), square.Trim));
  const sm::FacePointer trimmed = model->GetFaces()[0];
  CheckTrue("the face was replaced, not changed",
    trimmed != plain && trimmed->Id != plain->Id && plain->Loops.empty());
  CheckEqual("loops", 2, static_cast<long long>(trimmed->Loops.size()));
  CheckEqual("coedges of the first", 2, static_cast<long long>(trimmed->Loops[0].Coedges.size()));
  CheckEqual("edges", 3, model->GetNumberOfEdges());
  const sm::Coedge& second = trimmed->Loops[0].Coedges[1];
  CheckTrue("reversed", second.Reversed && !trimmed->Loops[0].Coedges[0].Reversed);
  smtest::Check("residual of a trim curve", 1e-7, second.Curve.GetMaxResidual(), 0.0);
  smtest::Check("residual of an edge", 1e-9, second.Use->Curve.GetMaxResidual(), 0.0);
  CheckEqual("pieces", 2, second.Use->Curve.GetNumberOfPieces());
  smtest::Check("the first piece ends at 2, in x = 2", 2.0, second.Use->Curve.Evaluate(2.0)[0], 0.0);
  smtest::Check("the last vertex", 4.0, second.Use->EndVertex[0], 0.0);
  CheckTrue("a pole is degenerate", trimmed->Loops[1].Coedges[0].Use->Degenerate && !second.Use->Degenerate);

  vtkNew<vtkTrimmedNURBSModel> copy;
  copy->ShallowCopy(model);
  CheckTrue("a copy knows the edges", copy->AddCoedge(1, 0, 0, false, square.Breaks, square.Trim));
  CheckTrue("and shares no change", model->GetFaces()[1]->Loops.empty());
}

/// `attempt` must say why it fails, in words that contain `words`, and change neither the faces nor the time
/// of the model. A face that others share is not changed; one that they do not share is not copied, which
/// would take quadratic time.
void CheckSharing()
{
  Square square;
  square.Model->AddFace(1, square.Knots, 1, square.Knots, square.Points);
  square.Model->AddEdge(square.Breaks, square.Line);
  const auto add = [&square]()
  { return square.Model->AddCoedge(0, 0, 0, false, square.Breaks, square.Trim); };
  const auto count = [](const sm::Face& face)
  { return static_cast<long long>(face.Loops[0].Coedges.size()); };
  CheckTrue("the first coedge", add());
  const sm::Face* const alone = square.Model->GetFaces()[0].get();
  const std::uint64_t id = alone->Id;
  CheckTrue("the second coedge", add());
  CheckTrue("the same face", square.Model->GetFaces()[0].get() == alone);
  CheckTrue("with a new id", alone->Id != id);
  CheckEqual("and two coedges", 2, count(*alone));
  const sm::FacePointer shared = square.Model->GetFaces()[0];
  CheckTrue("the third coedge", add());
  CheckEqual("a shared face keeps two", 2, count(*shared));
  CheckTrue("and its id", square.Model->GetFaces()[0]->Id != shared->Id);
  CheckEqual("the model's has three", 3, count(*square.Model->GetFaces()[0]));
  vtkNew<vtkTrimmedNURBSModel> copy;
  copy->ShallowCopy(square.Model);
  CheckTrue("the fourth coedge", add());
  CheckEqual("a copied model keeps three", 3, count(*copy->GetFaces()[0]));
}

void CheckRefused(
  const std::string& what, const std::string& words, Square& square, const std::function<bool()>& attempt)
{
  std::string said;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&said);
  listener->SetCallback([](vtkObject*, unsigned long, void* client, void* text)
    { *static_cast<std::string*>(client) += static_cast<const char*>(text); });
  const unsigned long tag = square.Model->AddObserver(vtkCommand::ErrorEvent, listener);
  const std::vector<sm::FacePointer> faces = square.Model->GetFaces();
  const vtkMTimeType time = square.Model->GetMTime();
  const bool refused = !attempt();
  square.Model->RemoveObserver(tag);
  CheckTrue(what + ": refused", refused);
  CheckTrue(what + ": " + words, said.find(words) != std::string::npos, said);
  CheckTrue(
    what + ": nothing changed", square.Model->GetFaces() == faces && square.Model->GetMTime() == time);
}

void CheckFaceErrors()
{
  Square s;
  const auto attempt = [&s](int degree, vtkDataArray* u, vtkDataArray* v, vtkDataArray* points)
  { return [&s, degree, u, v, points]() { return s.Model->AddFace(degree, u, 1, v, points) >= 0; }; };
  const auto falling = MakeArray(1, { 0, 0, 1, 0 });
  const auto pairs = MakeArray(2, { 0, 0, 1, 1 });
  const auto negative = MakeArray(4, { 0, 0, 0, 1, 1, 0, 0, -1, 0, 1, 0, 1, 1, 1, 0, 1 });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto unknown = MakeArray(3, { 0, 0, 0, 1, 0, nan, 0, 1, 0, 1, 1, 0 });
  CheckRefused("no knots", "knots in u is missing", s, attempt(1, nullptr, s.Knots, s.Points));
  CheckRefused("no control points", "control points is missing", s, attempt(1, s.Knots, s.Knots, nullptr));
  CheckRefused("degree 0", "degree 0 in u", s, attempt(0, s.Knots, s.Knots, s.Points));
  CheckRefused("a degree too high", "degree 26 in u", s, attempt(26, s.Knots, s.Knots, s.Points));
  CheckRefused("a degree that does not fit", "do not fit", s, attempt(2, s.Knots, s.Knots, s.Points));
  CheckRefused("falling knots", "knots in v", s, attempt(1, s.Knots, falling, s.Points));
  CheckRefused("knots of two components", "need 1 component", s, attempt(1, s.Knots, pairs, s.Points));
  CheckRefused("points of two components", "need 4 components", s, attempt(1, s.Knots, s.Knots, pairs));
  CheckRefused("too few points", "instead of 2 x 2", s, attempt(1, s.Knots, s.Knots, s.Line));
  CheckRefused("a negative weight", "weight", s, attempt(1, s.Knots, s.Knots, negative));
  CheckRefused("not a number", "not finite", s, attempt(1, s.Knots, s.Knots, unknown));
  // Two squares side by side, the second one lifted or not.
  const auto twice = MakeArray(1, { 0, 0, 0.5, 0.5, 1, 1 });
  const auto thrice = MakeArray(1, { 0, 0, 0.5, 0.5, 0.5, 1, 1 });
  const auto across = [](double lift)
  {
    return MakeArray(
      3, { 0, 0, 0, 1, 0, 0, 1, 0, lift, 2, 0, lift, 0, 1, 0, 1, 1, 0, 1, 1, lift, 2, 1, lift });
  };
  const auto along = [](double lift)
  {
    return MakeArray(3,
      { 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 7, 7, 7, 7, 7, 7, 0, 1, lift, 1, 1, lift, 0, 2, lift, 1, 2,
        lift });
  };
  CheckRefused("a jump in u", "jumps at u = 0.5", s, attempt(1, twice, s.Knots, across(1e-9)));
  CheckRefused("a jump in v", "jumps at v = 0.5", s, attempt(1, s.Knots, thrice, along(1e-9)));
  CheckTrue("no jump in u", attempt(1, twice, s.Knots, across(0.0))());
  CheckTrue("no jump in v", attempt(1, s.Knots, thrice, along(0.0))());
  // The second square by three times its homogeneous coordinates: the same points.
  const auto factors = MakeArray(
    4, { 0, 0, 0, 1, 1, 0, 0, 1, 3, 0, 0, 3, 6, 0, 0, 3, 0, 1, 0, 1, 1, 1, 0, 1, 3, 3, 0, 3, 6, 3, 0, 3 });
  CheckTrue("no jump by a common factor", attempt(1, twice, s.Knots, factors)());
}

void CheckCurveErrors()
{
  Square s;
  s.Model->AddFace(1, s.Knots, 1, s.Knots, s.Points);
  s.Model->AddEdge(s.Breaks, s.Line);
  const auto edge = [&s](vtkDataArray* breaks, vtkDataArray* coefficients, double residual)
  {
    return [&s, breaks, coefficients, residual]()
    { return s.Model->AddEdge(breaks, coefficients, residual) >= 0; };
  };
  const auto coedge = [&s](int face, int loop, int number, vtkDataArray* breaks)
  {
    return [&s, face, loop, number, breaks]()
    { return s.Model->AddCoedge(face, loop, number, false, breaks, s.Trim); };
  };
  const auto one = MakeArray(1, { 0 });
  const auto same = MakeArray(1, { 0, 1, 1 });
  const auto two = MakeArray(1, { 0, 1, 2 });
  auto high = vtkSmartPointer<vtkDoubleArray>::New();
  high->SetNumberOfComponents(3);
  high->SetNumberOfTuples(27);
  high->Fill(0.0);
  CheckRefused("no breaks", "breaks is missing", s, edge(nullptr, s.Line, 0.0));
  CheckRefused("no coefficients", "coefficients is missing", s, edge(s.Breaks, nullptr, 0.0));
  CheckRefused("one break", "two breaks or more", s, edge(one, s.Line, 0.0));
  CheckRefused("breaks that do not increase", "break 2 does not", s, edge(same, s.Line, 0.0));
  CheckRefused("coefficients that do not fit", "do not fit 2 pieces", s, edge(two, s.Line, 0.0));
  CheckRefused("two dimensions", "need 3 components", s, edge(s.Breaks, s.Trim, 0.0));
  CheckRefused("degree 26", "degree 26", s, edge(s.Breaks, high, 0.0));
  CheckRefused("a negative residual", "residual", s, edge(s.Breaks, s.Line, -1e-9));
  CheckRefused("no such face", "face 1 does not exist", s, coedge(1, 0, 0, s.Breaks));
  CheckRefused("a loop too far", "loop 1 of face 0", s, coedge(0, 1, 0, s.Breaks));
  CheckRefused("no such edge", "edge 1 does not exist", s, coedge(0, 0, 1, s.Breaks));
  CheckRefused("another range", "[0, 4]", s, coedge(0, 0, 0, MakeArray(1, { 0, 4 })));
  vtkNew<vtkIntArray> whole;
  whole->InsertNextValue(0);
  whole->InsertNextValue(1);
  CheckTrue("any type of numbers", s.Model->AddCoedge(0, 0, 0, false, whole, s.Trim));
}

void CheckDensity()
{
  Square s;
  s.Model->SetDensity(2700.0);
  for (const double density : { -1.0, 1e250, std::numeric_limits<double>::infinity(), std::nan("") })
  {
    CheckRefused("a density that is none", "is not a density; give kg/m^3 from 1e-200 to 1e200", s,
      [&]()
      {
        s.Model->SetDensity(density);
        return s.Model->GetDensity() != 2700.0;
      });
  }
  s.Model->SetDensity(0.0);
  smtest::Check("no density", 0.0, s.Model->GetDensity(), 0.0);
}
}

int TestTrimmedNURBSModelArrays(int, char*[])
{
  CheckStored();
  CheckSharing();
  CheckFaceErrors();
  CheckCurveErrors();
  CheckDensity();
  return smtest::Finish();
}
