// The exact model follows its points, and only its points.
#include "smTesting.h"

#include "vtkMatrix4x4.h"
#include "vtkNURBSDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTrimmedNURBSModel.h"

int TestNURBSDataSet(int, char*[])
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  vtkNew<vtkTrimmedNURBSModel> model;
  model->SetName("part");
  auto face = std::make_shared<sm::Face>();
  face->Id = sm::NewId();
  face->Surface.ControlPoints.resize(100000);
  model->SetFaces({ face });
  vtkNew<vtkMatrix4x4> placement;
  placement->SetElement(0, 3, 5.0);

  vtkNew<vtkNURBSDataSet> data;
  data->SetPoints(points);
  data->SetModel(model);
  data->SetPlacement(placement);
  smtest::CheckTrue("is a polydata for everyone else", data->GetDataObjectType() == VTK_POLY_DATA);
  smtest::CheckTrue("memory counts the model", data->GetActualMemorySize() > 3000);

  vtkNew<vtkNURBSDataSet> copy;
  copy->ShallowCopy(data);
  smtest::CheckTrue("shallow copy shares the model", copy->GetModel() == model);
  smtest::Check("shallow copy keeps the placement", 5.0, copy->GetPlacementData()[3], 0.0);
  vtkNew<vtkNURBSDataSet> deep;
  deep->DeepCopy(data);
  smtest::CheckTrue("deep copy has the model and points of its own",
    deep->GetModel() == model && deep->GetPoints() != data->GetPoints());

  vtkNew<vtkPolyData> plain;
  plain->ShallowCopy(data);
  deep->ShallowCopy(plain);
  smtest::CheckTrue(
    "a copy from a plain polydata has no model", !deep->GetModel() && !deep->IsModelWithheld());
  vtkNew<vtkNURBSDataSet> structure;
  structure->SetModel(model);
  structure->CopyStructure(data);
  smtest::CheckTrue("CopyStructure drops the model", !structure->GetModel());

  copy->GetPoints()->Modified();
  smtest::CheckTrue("points with a new time alone keep the model",
    copy->GetModel() && data->GetModel() && !copy->IsModelWithheld());
  copy->GetPoints()->SetPoint(1, 2.0, 0.0, 0.0);
  copy->GetPoints()->Modified();
  smtest::CheckTrue("moved points withhold the model", !copy->GetModel() && copy->IsModelWithheld());
  smtest::CheckTrue("of everyone who shares them", !data->GetModel() && data->IsModelWithheld());
  vtkNew<vtkNURBSDataSet> late;
  late->ShallowCopy(data);
  smtest::CheckTrue("and a copy made afterwards has none", !late->GetModel());

  vtkNew<vtkNURBSDataSet> replaced;
  replaced->SetPoints(points);
  replaced->SetModel(model);
  vtkNew<vtkPoints> other;
  replaced->SetPoints(other);
  smtest::CheckTrue(
    "replaced points withhold the model", !replaced->GetModel() && replaced->IsModelWithheld());
  replaced->Initialize();
  smtest::CheckTrue("Initialize forgets it", !replaced->IsModelWithheld());

  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    vtkNew<vtkPoints> before;
    before->SetDataType(type);
    vtkNew<vtkPoints> after;
    after->SetDataType(type);
    for (int i = 0; i < 5; ++i)
    {
      before->InsertNextPoint(i, 0.0, 0.0);
      after->InsertNextPoint(i, i == 1 || i == 3 ? 1.0 : 0.0, 0.0);
    }
    vtkNew<vtkNURBSDataSet> leaf;
    leaf->SetPoints(before);
    leaf->SetModel(model);
    vtkNew<vtkTrimmedNURBSModel> next;
    leaf->SetModelAndPoints(next, after, { 1, 3 });
    smtest::CheckTrue("edited: model and points", leaf->GetModel() == next && leaf->GetPoints() == after);
    after->Modified();
    smtest::CheckTrue("a new time alone keeps the edited model", leaf->GetModel() == next);
    after->SetPoint(2, 2.0, 0.0, 1e-6);
    after->Modified();
    smtest::CheckTrue("another point that moves withholds it", leaf->IsModelWithheld());
  }

  vtkNew<vtkTrimmedNURBSModel> edited;
  edited->ShallowCopy(model);
  auto newFace = std::make_shared<sm::Face>(*face);
  newFace->Id = sm::NewId();
  edited->SetFace(0, newFace);
  smtest::CheckTrue("an edit of a copy leaves the source as it was",
    model->GetFaces()[0] == face && edited->GetFaces()[0] == newFace);
  smtest::CheckTrue("ids are never used twice", newFace->Id != face->Id);
  return smtest::Finish();
}
