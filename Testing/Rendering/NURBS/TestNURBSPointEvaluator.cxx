// TestNURBSPointEvaluator FOLDER opengl|none: display points of edited faces by OpenGL and by the CPU,
// against the exact surface; placed, mirrored, at poles; what costs what; and what is refused. none: where
// there is no OpenGL, the CPU evaluates.
#include "smLatticeBody.h"
#include "smModelEdit.h"
#include "smTestManifest.h"
#include "smTestPipeline.h"

#include <vtkComputeContext.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNURBSDeform.h>
#include <vtkNURBSPointEvaluatorGPU.h>
#include <vtkPartitionedDataSetCollection.h>

#include <algorithm>

namespace
{
using namespace smtest;

constexpr double Epsilon = 2.220446049250313e-16;

/// A copy whose points and normals are doubles, at a placement; every point starts at a wrong place, with a
/// wrong normal.
vtkSmartPointer<vtkNURBSDataSet> MakeMesh(vtkNURBSDataSet* leaf, vtkMatrix4x4* placement)
{
  auto mesh = vtkSmartPointer<vtkNURBSDataSet>::New();
  mesh->ShallowCopy(leaf);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < leaf->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(7e7, 7e7, 7e7);
    normals->InsertNextTuple3(5.0, 5.0, 5.0);
  }
  mesh->SetPoints(points);
  mesh->GetPointData()->SetNormals(normals);
  mesh->SetPlacement(placement);
  mesh->SetModel(leaf->GetModel());
  return mesh;
}

/// The same faces with new ids: an edit that moves nothing.
vtkSmartPointer<vtkTrimmedNURBSModel> Renew(vtkTrimmedNURBSModel* model)
{
  std::vector<sm::FacePointer> faces;
  for (const sm::FacePointer& face : model->GetFaces())
  {
    auto copy = std::make_shared<sm::Face>(*face);
    copy->Id = sm::NewId();
    faces.push_back(copy);
  }
  auto renewed = vtkSmartPointer<vtkTrimmedNURBSModel>::New();
  renewed->ShallowCopy(model);
  renewed->SetFaces(faces);
  return renewed;
}

double GetSize(vtkTrimmedNURBSModel* model)
{
  const double* b = model->GetLocalBounds();
  return std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
}

struct Differences
{
  double Position = 0.0;
  double Normal = 0.0;
  double Length = 0.0;
};

/// Against NURBSSurface::Evaluate(), which is another way of computing; normals where they are well
/// conditioned.
Differences CompareWithSurface(vtkNURBSDataSet* mesh, int& degenerate)
{
  Differences worst;
  vtkDataArray* faces = mesh->GetPointData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName());
  vtkDataArray* parameters = mesh->GetPointData()->GetArray(vtkNURBSDataSet::ParametersArrayName());
  const double* m = mesh->GetPlacementData();
  const double* origin = mesh->GetModel()->GetOrigin();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const sm::Face& face = *mesh->GetModel()->GetFaces()[static_cast<std::size_t>(faces->GetComponent(i, 0))];
    double p[3];
    double du[3];
    double dv[3];
    double normal[3];
    face.Surface.Evaluate(parameters->GetComponent(i, 0), parameters->GetComponent(i, 1), p, du, dv);
    vtkMath::Cross(du, dv, normal);
    const bool isRegular = vtkMath::Norm(normal) > 1e-3 * vtkMath::Norm(du) * vtkMath::Norm(dv) &&
      vtkMath::Norm(du) > 1e-3 * vtkMath::Norm(dv) && vtkMath::Norm(dv) > 1e-3 * vtkMath::Norm(du);
    degenerate += isRegular ? 0 : 1;
    vtkMath::Normalize(normal);
    const double* found = mesh->GetPointData()->GetNormals()->GetTuple(i);
    worst.Length = std::fmax(worst.Length, std::fabs(vtkMath::Norm(found) - 1.0));
    for (int r = 0; r < 3; ++r)
    {
      double x = m[4 * r + 3];
      double n = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        x += m[4 * r + c] * (p[c] + origin[c]);
        n += m[4 * r + c] * normal[c] * (face.Reversed ? -1.0 : 1.0);
      }
      worst.Position = std::fmax(worst.Position, std::fabs(x - mesh->GetPoint(i)[r]));
      worst.Normal = std::fmax(worst.Normal, isRegular ? std::fabs(n - found[r]) : 0.0);
    }
  }
  return worst;
}

Differences Compare(vtkNURBSDataSet* a, vtkNURBSDataSet* b)
{
  Differences worst;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      worst.Position = std::fmax(worst.Position, std::fabs(a->GetPoint(i)[c] - b->GetPoint(i)[c]));
      worst.Normal = std::fmax(worst.Normal,
        std::fabs(a->GetPointData()->GetNormals()->GetComponent(i, c) -
          b->GetPointData()->GetNormals()->GetComponent(i, c)));
    }
  }
  return worst;
}

void CheckSolid(const std::string& folder, const std::string& name, bool hasPoles)
{
  std::printf("--- %s\n", name.c_str());
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName((folder + "/" + name + "-plain.step").c_str());
  reader->Update();
  auto* product = vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(0));
  auto* leaf = vtkNURBSDataSet::SafeDownCast(product->GetPartition(0, 0));
  const double size = GetSize(leaf->GetModel());
  // Rotated about z by the angle of (0.6, 0.8), moved; and the same after a reflection in x.
  const double rotated[16] = { 0.6, -0.8, 0, 3, 0.8, 0.6, 0, -4, 0, 0, 1, 5, 0, 0, 0, 1 };
  const double mirrored[16] = { -0.6, -0.8, 0, 3, -0.8, 0.6, 0, -4, 0, 0, 1, 5, 0, 0, 0, 1 };
  vtkNew<vtkNURBSPointEvaluator> gpu;
  CheckEqual("the factory's", "vtkNURBSPointEvaluatorGPU", gpu->GetClassName());
  gpu->SetBackend(vtkNURBSPointEvaluator::OPENGL);
  vtkNew<vtkNURBSPointEvaluator> cpu;
  cpu->SetBackend(vtkNURBSPointEvaluator::CPU);
  for (const double* rows : { rotated, mirrored })
  {
    vtkNew<vtkMatrix4x4> placement;
    placement->DeepCopy(rows);
    const auto byGPU = MakeMesh(leaf, placement);
    const auto byCPU = MakeMesh(leaf, placement);
    const auto edited = Renew(leaf->GetModel());
    CheckTrue("by OpenGL", gpu->UpdatePoints(byGPU, edited), gpu->GetMessage());
    CheckTrue("by the CPU", cpu->UpdatePoints(byCPU, edited), cpu->GetMessage());
    CheckEqual("backend", "opengl", gpu->GetBackendName());
    CheckEqual("backend", "cpu", cpu->GetBackendName());
    CheckEqual("all points", leaf->GetNumberOfPoints(), gpu->GetNumberOfEvaluations());
    CheckTrue("the model", byGPU->GetModel() == edited.Get() && byCPU->GetModel() == edited.Get());
    // Rounding of positions; of normals by the parameters' scale, which the patches' corners do not exceed.
    const double reach = size + 10.0;
    const Differences between = Compare(byGPU, byCPU);
    Check("positions agree", 0.0, between.Position, 16.0 * Epsilon * reach, "16 eps of the size");
    Check("normals agree", 0.0, between.Normal, 1e-9, "eps / 1e-6, the smallest normal");
    int degenerate = 0;
    const Differences against = CompareWithSurface(byGPU, degenerate);
    Check("positions are the surface's", 0.0, against.Position, 64.0 * Epsilon * reach, "blossoming");
    Check("normals are the surface's", 0.0, against.Normal, 1e-11, "conditioned by 1e-3");
    Check("of length 1", 0.0, against.Length, 8.0 * Epsilon, "rounding, placed");
    CheckTrue("poles", (degenerate > 0) == hasPoles, std::to_string(degenerate));
  }
  // The reader's normals are those of the exact surface, at poles, too; a patch's turn by a 4096th at the
  // pole.
  vtkNew<vtkNURBSDataSet> again;
  again->ShallowCopy(leaf);
  CheckTrue("at home", gpu->UpdatePoints(again, Renew(leaf->GetModel())), gpu->GetMessage());
  Check("the reader's normals", 0.0, Compare(again, leaf).Normal, 1e-3, "an angle of pi/2 / 4096, poles");
  Check("the reader's points", 0.0, Compare(again, leaf).Position, 1e-6 * size, "its single precision");
}

void CheckCost(int backend)
{
  std::printf("--- what an edit costs\n");
  LatticeBody body;
  const auto leaf = body.Make();
  vtkNew<vtkNURBSPointEvaluator> evaluator;
  evaluator->SetBackend(backend);
  const sm::ModelEdit edit = sm::MoveControlPoints(
    leaf->GetModel(), 5, { { 2, 1 } }, { 0.1, 0.2, 0.7 }, sm::EditRule::MoveSharedBoundary);
  vtkNew<vtkNURBSDataSet> mesh;
  mesh->ShallowCopy(leaf);
  vtkPoints* before = mesh->GetPoints();
  CheckTrue("one face", evaluator->UpdatePoints(mesh, edit.Model), evaluator->GetMessage());
  const vtkIdType each = leaf->GetNumberOfPoints() / 6;
  CheckEqual("its points are evaluated", each, evaluator->GetNumberOfEvaluations());
  CheckTrue("what was shared is left alone", leaf->GetPoints() == before && mesh->GetPoints() != before);
  bool same = true;
  bool moved = false;
  for (vtkIdType i = 0; i < leaf->GetNumberOfPoints(); ++i)
  {
    const bool equal =
      std::equal(leaf->GetPoint(i), leaf->GetPoint(i) + 3, mesh->GetPoints()->GetData()->GetTuple(i));
    (i < 5 * each ? same : moved) = i < 5 * each ? same && equal : moved || !equal;
  }
  CheckTrue("the others keep their bits", same);
  CheckTrue("it moved", moved);
  CheckTrue("undone", evaluator->UpdatePoints(mesh, leaf->GetModel()));
  CheckTrue("has its points again", Compare(mesh, leaf).Position <= 1e-14);
  CheckTrue("nothing to do", evaluator->UpdatePoints(mesh, leaf->GetModel()));
  CheckEqual("costs nothing", 0, evaluator->GetNumberOfEvaluations());
  CheckEqual("by nobody", "none", evaluator->GetBackendName());

  // Other knots, the same mesh: points lie on other patches.
  LatticeBody fine;
  fine.Knots = { 0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1 };
  auto lid = std::make_shared<sm::Face>(*leaf->GetModel()->GetFaces()[5]);
  lid->Id = sm::NewId();
  lid->Surface = fine.Make()->GetModel()->GetFaces()[5]->Surface;
  lid->Surface.ControlPoints[24][2] += 1.0;
  const sm::ModelEdit replaced = sm::ReplaceFace(leaf->GetModel(), 5, lid);
  CheckTrue("a face with other knots", evaluator->UpdatePoints(mesh, replaced.Model));
  int degenerate = 0;
  Check("is evaluated", 0.0, CompareWithSurface(mesh, degenerate).Position, 1e-14, "rounding of 5");

  std::printf("--- a collapsed face keeps its normals\n");
  auto point = std::make_shared<sm::Face>(*lid);
  point->Id = sm::NewId();
  std::fill(point->Surface.ControlPoints.begin(), point->Surface.ControlPoints.end(),
    std::array<double, 4>{ 1.0, 1.0, 5.0, 1.0 });
  mesh->ShallowCopy(leaf);
  CheckTrue("collapsed", evaluator->UpdatePoints(mesh, sm::ReplaceFace(leaf->GetModel(), 5, point).Model));
  CheckTrue(
    "its points are one", mesh->GetPoint(5 * each)[2] == 5.0 && mesh->GetPoint(6 * each - 1)[0] == 1.0);
  Check("its normals are those before", 0.0, Compare(mesh, leaf).Normal, 0.0);
}

void CheckMistakes()
{
  std::printf("--- mistakes\n");
  LatticeBody body;
  const auto leaf = body.Make();
  vtkNew<vtkNURBSPointEvaluator> evaluator;
  CheckTrue("no mesh", !evaluator->UpdatePoints(nullptr, leaf->GetModel()));
  CheckTrue("no model", !evaluator->UpdatePoints(leaf, nullptr) && !evaluator->GetMessage().empty());
  vtkNew<vtkTrimmedNURBSModel> shorter;
  shorter->SetFaces({ leaf->GetModel()->GetFaces()[0] });
  CheckTrue("another number of faces", !evaluator->UpdatePoints(leaf, shorter));
  leaf->GetPointData()->RemoveArray(vtkNURBSDataSet::ParametersArrayName());
  CheckTrue("no parameters", !evaluator->UpdatePoints(leaf, Renew(leaf->GetModel())));
  CheckTrue("it says so", evaluator->GetMessage().find("Parameters") != std::string::npos);
}

/// Two filters and a mass filter in one context; the evaluator's answers outlive a context that ended.
void CheckContext()
{
  std::printf("--- contexts\n");
  vtkNew<vtkComputeContext> context;
  vtkNew<vtkNURBSPointEvaluatorGPU> evaluator;
  evaluator->SetComputeContext(context);
  evaluator->SetBackend(vtkNURBSPointEvaluator::OPENGL);
  LatticeBody body;
  const auto leaf = body.Make();
  vtkNew<vtkNURBSDeform> deform;
  deform->SetInputData(leaf);
  deform->SetDisplacement(0.0, 0.0, 1.0);
  deform->SetPointEvaluator(evaluator);
  deform->Update();
  CheckEqual("by OpenGL", "opengl", evaluator->GetBackendName());
  const auto dispatches = context->GetNumberOfDispatches();
  CheckTrue("in the context that was given", dispatches > 0);
  deform->SetDisplacement(0.0, 0.0, 2.0);
  deform->Update();
  CheckEqual("all faces together in one dispatch", static_cast<long long>(dispatches) + 1,
    static_cast<long long>(context->GetNumberOfDispatches()));
  context->Stop();
  deform->SetDisplacement(0.0, 0.0, 3.0);
  deform->Update();
  auto* moved = vtkNURBSDataSet::SafeDownCast(deform->GetOutputDataObject(0));
  double worst = 0.0;
  for (vtkIdType i = 0; i < leaf->GetNumberOfPoints(); ++i)
  {
    worst = std::fmax(worst, std::fabs(moved->GetPoint(i)[2] - leaf->GetPoint(i)[2] - 3.0));
  }
  Check("after the context ended", 0.0, worst, 1e-14, "rounding of 8");
  evaluator->SetBackend(vtkNURBSPointEvaluator::CPU);
  deform->Update();
  CheckEqual("another backend runs the filter", "cpu", evaluator->GetBackendName());
}

void CheckFallback()
{
  std::printf("--- no OpenGL\n");
  LatticeBody body;
  const auto leaf = body.Make();
  vtkNew<vtkNURBSPointEvaluator> evaluator;
  CheckTrue("automatic", evaluator->UpdatePoints(leaf, Renew(leaf->GetModel())), evaluator->GetMessage());
  CheckEqual("is the CPU", "cpu", evaluator->GetBackendName());
  CheckTrue("and says why", !evaluator->GetMessage().empty(), evaluator->GetMessage());
  evaluator->SetBackend(vtkNURBSPointEvaluator::OPENGL);
  vtkPoints* points = leaf->GetPoints();
  CheckTrue("OpenGL alone fails", !evaluator->UpdatePoints(leaf, Renew(leaf->GetModel())));
  CheckTrue("and changes nothing", leaf->GetPoints() == points && evaluator->GetBackendName() == "none");
}
}

int TestNURBSPointEvaluator(int argc, char* argv[])
{
  const std::string mode = argc == 3 ? argv[2] : "";
  if (mode != "opengl" && mode != "none")
  {
    std::fprintf(stderr, "usage: TestNURBSPointEvaluator FOLDER opengl|none\n");
    return 2;
  }
  if (mode == "none")
  {
    CheckFallback();
    return Finish();
  }
  CheckSolid(argv[1], "sphere", true);
  CheckSolid(argv[1], "cone", false);
  CheckSolid(argv[1], "slanted_hole", false);
  CheckSolid(argv[1], "spline_ring", false);
  CheckCost(vtkNURBSPointEvaluator::OPENGL);
  CheckCost(vtkNURBSPointEvaluator::CPU);
  CheckMistakes();
  CheckContext();
  return Finish();
}
