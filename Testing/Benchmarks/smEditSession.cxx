#include "smEditSession.h"

#include "smModelEdit.h"

#include <vtkTimerLog.h>
#include <vtkTrimmedNURBSModel.h>

#include <cmath>

namespace smtest
{
namespace
{
double Now()
{
  return vtkTimerLog::GetUniversalTime();
}
}

const char* GetName(EditKind kind)
{
  switch (kind)
  {
    case EditKind::Point:
      return "point";
    case EditKind::Row:
      return "row";
    case EditKind::Lattice:
      return "lattice";
    case EditKind::FullRun:
      return "full";
  }
  return "";
}

EditSession::EditSession(vtkNURBSDataSet* leaf, int backend, double tolerance)
  : Original(leaf)
  , Leaf(vtkSmartPointer<vtkNURBSDataSet>::New())
  , Points(vtkSmartPointer<vtkNURBSPointEvaluator>::New())
{
  this->Leaf->ShallowCopy(leaf);
  this->Mass->SetInputData(this->Leaf);
  this->Mass->SetBackend(backend);
  this->Mass->SetRelativeTolerance(tolerance);
  this->Mass->CheckEditedSolidsOff();
  this->Points->SetBackend(backend);
  this->Lattice->SetInputData(leaf);
  this->Lattice->SetMode(vtkNURBSDeform::LATTICE);
  this->Lattice->SetLatticeSize(3, 2, 2);
  this->Lattice->SetPointEvaluator(this->Points);
  const std::vector<sm::FacePointer>& faces = leaf->GetModel()->GetFaces();
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (faces[f]->Surface.ControlPoints.size() > faces[this->Face]->Surface.ControlPoints.size())
    {
      this->Face = static_cast<int>(f);
    }
  }
  const double* box = leaf->GetModel()->GetLocalBounds();
  this->Size = std::hypot(box[1] - box[0], box[3] - box[2], box[5] - box[4]);
}

void EditSession::Check(bool good, const std::string& what)
{
  if (!good && this->Error.empty())
  {
    this->Error = what;
  }
}

void EditSession::Edit(EditKind kind, double amount, UpdateCost& cost)
{
  const double start = Now();
  vtkTrimmedNURBSModel* model = this->Original->GetModel();
  const int* count = model->GetFaces()[this->Face]->Surface.NumberOfControlPoints;
  std::vector<sm::ControlPointIndex> indices;
  if (kind == EditKind::Row)
  {
    for (int i = 1; i + 1 < count[0]; ++i)
    {
      indices.push_back({ i, 0 });
    }
  }
  else
  {
    indices.push_back({ count[0] / 2, count[1] / 2 });
  }
  const sm::ModelEdit edit = sm::MoveControlPoints(
    model, this->Face, indices, { 0.3 * amount, 0.5 * amount, amount }, sm::EditRule::MoveSharedBoundary);
  const double edited = Now();
  cost.Edit = edited - start;
  cost.ChangedFaces = static_cast<long long>(edit.Replaced.size());
  this->Check(edit.Status == sm::EditStatus::Ok, edit.Message);
  if (edit.Model)
  {
    this->Leaf->ShallowCopy(this->Original);
    this->Check(this->Points->UpdatePoints(this->Leaf, edit.Model), this->Points->GetMessage());
    cost.ChangedPoints = this->Points->GetNumberOfEvaluations();
  }
  cost.Display = Now() - edited;
}

void EditSession::Deform(double amount, UpdateCost& cost)
{
  const double start = Now();
  this->Lattice->SetLatticeDisplacement(1, 1, 1, 0.3 * amount, 0.5 * amount, amount);
  this->Lattice->Update();
  this->Leaf->ShallowCopy(this->Lattice->GetOutputDataObject(0));
  cost.Edit = Now() - start;
  cost.ChangedFaces = this->Lattice->GetNumberOfChangedFaces();
  cost.ChangedPoints = this->Points->GetNumberOfEvaluations();
}

void EditSession::Renew()
{
  std::vector<sm::FacePointer> faces;
  for (const sm::FacePointer& face : this->Original->GetModel()->GetFaces())
  {
    auto copy = std::make_shared<sm::Face>(*face);
    copy->Id = sm::NewId();
    faces.push_back(copy);
  }
  vtkNew<vtkTrimmedNURBSModel> model;
  model->ShallowCopy(this->Original->GetModel());
  model->SetFaces(faces);
  this->Leaf->ShallowCopy(this->Original);
  this->Leaf->SetModel(model);
}

UpdateCost EditSession::Update(EditKind kind, int number)
{
  UpdateCost cost;
  // A fraction of the body's size: at most 2 %, never 0.
  const double amount = this->Size * 0.01 * (1.0 + 1e-6 * (number % 1000000));
  switch (kind)
  {
    case EditKind::Point:
    case EditKind::Row:
      this->Edit(kind, amount, cost);
      break;
    case EditKind::Lattice:
      this->Deform(amount, cost);
      break;
    case EditKind::FullRun:
      this->Renew();
      break;
  }
  const double start = Now();
  this->Mass->Update();
  cost.Mass = Now() - start;
  cost.Prepare = this->Mass->GetPrepareSeconds();
  cost.Integrate = this->Mass->GetIntegrateSeconds();
  cost.Evaluations = this->Mass->GetEvaluations();
  cost.Dispatches = this->Mass->GetDispatches();
  this->Check(this->Mass->GetStatus() == "ok" || this->Mass->GetStatus() == "tolerance-not-met",
    "mass properties: " + this->Mass->GetStatus() +
      (this->Mass->GetNumberOfMessages() > 0 ? ", " + this->Mass->GetMessage(0) : ""));
  return cost;
}
}
