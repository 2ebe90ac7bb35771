// Deformations: which control points move and how far, display points, instances, gaps where mapping control
// points opens.
#include "smFilterTesting.h"
#include "smMessageTrap.h"
#include "smRoundFaces.h"
#include "smWholeSphere.h"

#include <vtkNURBSDeform.h>
#include <vtkNURBSPointEvaluator.h>
#include <vtkObjectFactory.h>

#include <new>

namespace
{
using namespace smtest;

double GetFalloff(double distance, double radius)
{
  const double q = 1.0 - distance * distance / (radius * radius);
  return distance < radius ? q * q * q : 0.0;
}

void CheckDisplacement()
{
  std::printf("--- displaced with a radius\n");
  LatticeBody body;
  body.Origin = { 0.5, -0.25, 2.0 };
  const auto product = MakeProduct(body);
  vtkTrimmedNURBSModel* model = GetLeaf(product, 0)->GetModel();
  const std::vector<sm::FacePointer> before = model->GetFaces();
  vtkNew<vtkNURBSDeform> filter;
  filter->SetInputData(product);
  // Near the lid z = 5 of the first instance, away from the floor and from the second instance.
  const double center[3] = { 1.5, 1.25, 7.0 };
  const double radius = 2.5;
  filter->SetCenter(center[0], center[1], center[2]);
  filter->SetDisplacement(0.1, 0.2, 0.7);
  filter->SetRadius(radius);
  filter->Update();
  vtkDataObject* output = filter->GetOutputDataObject(0);
  CheckStructure(output);
  vtkNURBSDataSet* leaf = GetLeaf(output, 0);
  CheckTrue("the input stays", model->GetFaces() == before && GetLeaf(product, 0)->GetModel() == model);
  CheckTrue("an instance that nothing moved keeps the model", GetLeaf(output, 1)->GetModel() == model);
  CheckTrue("the other has its own", leaf->GetModel() && leaf->GetModel() != model);
  double worst = 0.0;
  int moved = 0;
  for (std::size_t f = 0; f < before.size(); ++f)
  {
    for (std::size_t i = 0; i < before[f]->Surface.ControlPoints.size(); ++i)
    {
      const std::array<double, 4>& from = before[f]->Surface.ControlPoints[i];
      const std::array<double, 4>& to = leaf->GetModel()->GetFaces()[f]->Surface.ControlPoints[i];
      const double factor = GetFalloff(
        std::hypot(from[0] + 0.5 - center[0], from[1] - 0.25 - center[1], from[2] + 2.0 - center[2]), radius);
      moved += factor > 0.0 ? 1 : 0;
      worst = std::fmax(worst, std::fabs(to[0] - from[0] - 0.1 * factor));
      worst = std::fmax(worst, std::fabs(to[2] - from[2] - 0.7 * factor));
      CheckTrue("what lies outside keeps its bits", factor > 0.0 || to == from);
    }
  }
  CheckRange("control points that move", 10, moved, 100);
  Check("by the falloff", 0.0, worst, 1e-14, "rounding of about 5");
  CheckTrue("the floor is shared", leaf->GetModel()->GetFaces()[4] == before[4]);
  CheckEqual("faces that changed", 5, filter->GetNumberOfChangedFaces());
  CheckEqual("nothing opened", 0, filter->GetNumberOfOpenedEdges());
  Check("points are on the faces", 0.0, GetDistanceFromFaces(leaf), 1e-13, "rounding of about 10");
  CheckRange("normals are the cells'", 0.9, GetMinimumCosine(leaf), 1.0);

  std::printf("--- set back\n");
  filter->SetDisplacement(0.0, 0.0, 0.0);
  filter->Update();
  CheckTrue(
    "no displacement, the model itself", GetLeaf(filter->GetOutputDataObject(0), 0)->GetModel() == model);

  std::printf("--- faces\n");
  filter->SetDisplacement(0.0, 0.0, 1.0);
  filter->SetRadius(0.0);
  filter->SetSolid(0);
  filter->AddFace(5);
  filter->Update();
  CheckEqual("the lid and its neighbours", 5, filter->GetNumberOfChangedFaces());
  CheckEqual("are closed", 0, filter->GetNumberOfOpenedEdges());
  CheckTrue(
    "the other solid was not chosen", GetLeaf(filter->GetOutputDataObject(0), 1)->GetModel() == model);
  filter->KeepClosedOff();
  filter->Update();
  CheckEqual("the lid alone", 1, filter->GetNumberOfChangedFaces());
  CheckEqual("opens its edges", 4, filter->GetNumberOfOpenedEdges());
  Check("by the displacement", 1.0, filter->GetMaxGap(), 1e-13, "rounding of about 10");
  filter->AddFace(6);
  CheckFails(filter, "no face 6");
  filter->RemoveAllFaces();
  filter->SetSolid(2);
  CheckFails(filter, "no exact geometry");
  filter->SetSolid(-1);
  filter->SetDisplacement(0.0, std::nan(""), 0.0);
  CheckFails(filter, "not finite");
  filter->SetDisplacement(0.0, 0.0, 1.0);
  filter->SetRadius(std::nan(""));
  CheckFails(filter, "not finite");
}

void CheckLattice()
{
  std::printf("--- a lattice\n");
  LatticeBody body;
  body.Origin = { 0.5, -0.25, 2.0 };
  const auto product = MakeProduct(body);
  vtkTrimmedNURBSModel* model = GetLeaf(product, 0)->GetModel();
  vtkNew<vtkNURBSDeform> filter;
  filter->SetInputData(product);
  filter->SetMode(vtkNURBSDeform::LATTICE);
  filter->SetLatticeSize(3, 1, 99);
  CheckTrue("the size is clamped",
    filter->GetLatticeSize()[0] == 3 && filter->GetLatticeSize()[1] == 2 &&
      filter->GetLatticeSize()[2] == 10);
  filter->SetLatticeSize(3, 2, 2);
  // A lattice that is displaced linearly is an affine map: x' = x + 0.1 y/b.
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 2; ++k)
    {
      filter->SetLatticeDisplacement(i, 1, k, 0.1, 0.0, 0.0);
    }
  }
  filter->Update();
  vtkDataObject* output = filter->GetOutputDataObject(0);
  CheckStructure(output);
  vtkTrimmedNURBSModel* sheared = GetLeaf(output, 0)->GetModel();
  CheckTrue("instances share the new model", sheared != model && GetLeaf(output, 1)->GetModel() == sheared);
  double worst = 0.0;
  for (std::size_t f = 0; f < 6; ++f)
  {
    for (std::size_t i = 0; i < model->GetFaces()[f]->Surface.ControlPoints.size(); ++i)
    {
      const std::array<double, 4>& from = model->GetFaces()[f]->Surface.ControlPoints[i];
      const std::array<double, 4>& to = sheared->GetFaces()[f]->Surface.ControlPoints[i];
      worst = std::fmax(worst, std::fabs(to[0] - from[0] - 0.1 * from[1] / 3.0));
    }
  }
  Check("the affine map", 0.0, worst, 1e-15, "rounding of 2");
  CheckEqual("is closed", 0, filter->GetNumberOfOpenedEdges());
  for (unsigned int i = 0; i < 2; ++i)
  {
    Check("points are on the faces", 0.0, GetDistanceFromFaces(GetLeaf(output, i)), 1e-13, "rounding of 40");
  }
  // The parabola of the middle point, B = 2 x (1 - x): 0.5 at x = 1/2.
  filter->ClearLatticeDisplacements();
  filter->AddLatticeDisplacement(1.0, 0.0, 0.0, 0.0, 0.0, 0.4);
  filter->AddLatticeDisplacement(1.0, 1.0, 0.0, 0.0, 0.0, 0.4);
  filter->Update();
  vtkTrimmedNURBSModel* bent = GetLeaf(filter->GetOutputDataObject(0), 0)->GetModel();
  worst = 0.0;
  for (std::size_t i = 0; i < model->GetFaces()[4]->Surface.ControlPoints.size(); ++i)
  {
    const std::array<double, 4>& from = model->GetFaces()[4]->Surface.ControlPoints[i];
    const double x = from[0] / 2.0;
    worst = std::fmax(worst,
      std::fabs(bent->GetFaces()[4]->Surface.ControlPoints[i][2] - from[2] - 0.4 * 2.0 * x * (1.0 - x)));
  }
  Check("the floor is bent", 0.0, worst, 1e-15, "rounding");
  CheckEqual("rows meet still", 0, filter->GetNumberOfOpenedEdges());
}

/// Two faces at an edge with rows of different degree: nothing to carry, so that the edge is mapped for
/// itself.
void CheckGap()
{
  std::printf("--- rows that do not coincide\n");
  const auto run = [](double height, int warnings)
  {
    LatticeBody coarse;
    const auto leaf = coarse.Make();
    LatticeBody fine;
    fine.Knots = { 0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1 };
    auto lid = std::make_shared<sm::Face>(*leaf->GetModel()->GetFaces()[5]);
    lid->Id = sm::NewId();
    lid->Surface = fine.Make()->GetModel()->GetFaces()[5]->Surface;
    leaf->GetModel()->SetFace(5, lid);
    vtkNew<vtkNURBSDeform> filter;
    filter->SetInputData(leaf);
    filter->SetMode(vtkNURBSDeform::LATTICE);
    filter->SetLatticeSize(3, 2, 2);
    filter->SetLatticeDisplacement(1, 0, 1, 0.0, 0.0, height);
    filter->SetLatticeDisplacement(1, 1, 1, 0.0, 0.0, height);
    MessageTrap trap(filter);
    filter->Update();
    CheckEqual("warnings of torn faces", warnings, trap.NumberOfWarnings);
    CheckEqual("uses at the lid's edges across, of both faces", 4, filter->GetNumberOfOpenedEdges());
    return filter->GetMaxGap();
  };
  // The edge's line has control points at its ends, which stay: the gap is the whole of the lid's own bend,
  // about half the height; and the faces' bends differ by the squared distance of their control points.
  const double gap = run(0.4, 1);
  CheckRange("gap", 0.15, gap, 0.2);
  Check("it is linear in the displacement", 0.5 * gap, run(0.2, 1), 1e-3);
  run(1e-3, 0);
}

/// A region without control points of the solid moves nothing, and a displacement of it is warned of.
void CheckNothingMoved()
{
  std::printf("--- a region without control points\n");
  LatticeBody body;
  vtkNew<vtkNURBSDeform> filter;
  filter->SetInputData(body.Make());
  filter->SetCenter(1e3, 0.0, 0.0);
  filter->SetRadius(1.0);
  MessageTrap trap(filter);
  filter->Update();
  CheckEqual("nothing is asked: warnings", 0, trap.NumberOfWarnings);
  filter->SetDisplacement(0.0, 0.0, 1.0);
  filter->Update();
  CheckEqual("nothing moved: warnings", 1, trap.NumberOfWarnings);
  CheckEqual("faces", 0, filter->GetNumberOfChangedFaces());
  filter->SetRadius(1e4);
  filter->Update();
  CheckEqual("something moved: no more of them", 1, trap.NumberOfWarnings);
}

/// Without FaceIndex and Parameters, points are mapped.
void CheckPlainPoints()
{
  std::printf("--- points that know no face\n");
  LatticeBody body;
  const auto leaf = body.Make();
  leaf->GetPointData()->RemoveArray(vtkNURBSDataSet::ParametersArrayName());
  vtkNew<vtkNURBSDeform> filter;
  filter->SetInputData(leaf);
  filter->SetDisplacement(1.0, 2.0, 3.0);
  filter->SetCenter(0.0, 0.0, 0.0);
  filter->SetRadius(6.0);
  filter->Update();
  auto* output = vtkNURBSDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  double worst = 0.0;
  for (vtkIdType i = 0; i < leaf->GetNumberOfPoints(); ++i)
  {
    double from[3];
    leaf->GetPoint(i, from);
    const double factor = GetFalloff(std::hypot(from[0], from[1], from[2]), 6.0);
    worst = std::fmax(worst, std::fabs(output->GetPoint(i)[1] - from[1] - 2.0 * factor));
  }
  Check("they are mapped", 0.0, worst, 1e-14, "rounding of 5");
  CheckTrue("and the model is there", output->GetModel() != nullptr);
}

class EvaluatorWithoutMemory : public vtkNURBSPointEvaluator
{
public:
  static EvaluatorWithoutMemory* New() { VTK_STANDARD_NEW_BODY(EvaluatorWithoutMemory); }
  vtkTypeMacro(EvaluatorWithoutMemory, vtkNURBSPointEvaluator);

protected:
  bool EvaluateByOpenGL(const Work&, std::vector<sm::PointAndNormal>&, std::string&) override
  {
    throw std::bad_alloc();
  }
};

/// An exception is an error of the filter with an empty output; it does not leave Update().
void CheckOutOfMemory()
{
  LatticeBody body;
  vtkNew<vtkNURBSDeform> filter;
  filter->SetInputData(MakeProduct(body));
  filter->SetDisplacement(0.0, 0.0, 0.5);
  filter->SetPointEvaluator(vtkNew<EvaluatorWithoutMemory>());
  CheckFails(filter, "there is not enough memory");
  filter->SetPointEvaluator(nullptr);
  filter->Update();
  CheckStructure(filter->GetOutputDataObject(0));
  CheckAbort(filter);
}
}

/// A whole sphere has few triangles, because it is compared by formulas; what an edit makes of it has many.
void CheckSphere()
{
  std::printf("--- a ball\n");
  const sm::FacePointer ball = MakeBall({ 1.0, 2.0, 3.0 }, 2.0);
  const auto leaf = MakeRoundBody({ ball });
  const vtkSmartPointer<vtkTrimmedNURBSModel> model = leaf->GetModel();
  // The scale mesh has the arrays of a display mesh.
  AddGrids(leaf, { ball }, 16);
  vtkNew<vtkDoubleArray> parameters;
  parameters->SetName(vtkNURBSDataSet::ParametersArrayName());
  parameters->SetNumberOfComponents(2);
  vtkNew<vtkIntArray> faces;
  faces->SetName(vtkNURBSDataSet::FaceIndexArrayName());
  for (vtkIdType i = 0; i < leaf->GetNumberOfPoints(); ++i)
  {
    const double whole = 2.0 * vtkMath::Pi();
    parameters->InsertNextTuple2(
      whole * static_cast<double>(i % 17) / 16.0, 0.5 * whole * (static_cast<double>(i / 17) / 16.0 - 0.5));
    faces->InsertNextValue(0);
  }
  leaf->GetPointData()->AddArray(parameters);
  leaf->GetPointData()->AddArray(faces);
  vtkNew<vtkPolyData> mesh;
  mesh->vtkPolyData::ShallowCopy(leaf);
  model->SetScaleMesh(mesh);
  leaf->SetModel(model);
  vtkNew<vtkNURBSDeform> filter;
  filter->SetInputData(leaf);
  filter->SetCenter(1.0, 2.0, 5.0);
  filter->SetDisplacement(0.0, 0.0, 0.5);
  // The whole ball, and then a part of it.
  for (const double radius : { 0.0, 2.5 })
  {
    filter->SetRadius(radius);
    filter->Update();
    auto* edited = vtkNURBSDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    vtkPolyData* scales = edited->GetModel()->GetScaleMesh();
    const bool isSphere = static_cast<bool>(sm::FindWholeSphere(*edited->GetModel()->GetFaces()[0]));
    CheckTrue("a sphere as before, or none", isSphere == (radius == 0.0));
    CheckRange("triangles", isSphere ? 1.0 : 5000.0, static_cast<double>(scales->GetNumberOfPolys()),
      isSphere ? 600.0 : 20000.0);
    vtkNew<vtkNURBSDataSet> placed;
    placed->ShallowCopy(scales);
    placed->SetModel(edited->GetModel());
    Check("points are on the face", 0.0, GetDistanceFromFaces(placed), 1e-13, "rounding of about 5");
  }
}

int TestNURBSDeform(int, char*[])
{
  CheckSphere();
  CheckDisplacement();
  CheckLattice();
  CheckGap();
  CheckNothingMoved();
  CheckPlainPoints();
  CheckOutOfMemory();
  return Finish();
}
