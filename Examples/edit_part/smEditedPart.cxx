#include "smEditedPart.h"

#include "smBodyScene.h"

#include <vtkMath.h>
#include <vtkNURBSDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkTimerLog.h>
#include <vtkTrimmedNURBSModel.h>

#include <utility>

namespace sm
{
namespace
{
/// The Greville abscissa of basis function `index`, the mean of its inner knots, near which the function is
/// largest.
double GetGreville(const NURBSSurface& surface, int direction, int index)
{
  double sum = 0.0;
  for (int k = 1; k <= surface.Degree[direction]; ++k)
  {
    sum += surface.Knots[direction][index + k];
  }
  return sum / surface.Degree[direction];
}
}

std::array<double, 3> ToWorldVector(vtkNURBSDataSet* body, const std::array<double, 3>& model)
{
  const double* m = body->GetPlacementData();
  std::array<double, 3> world;
  for (int r = 0; r < 3; ++r)
  {
    world[r] = m[4 * r] * model[0] + m[4 * r + 1] * model[1] + m[4 * r + 2] * model[2];
  }
  return world;
}

std::array<double, 3> ToModelVector(vtkNURBSDataSet* body, const std::array<double, 3>& world)
{
  // A placement is a rotation or a reflection, so its inverse is its transpose.
  const double* m = body->GetPlacementData();
  std::array<double, 3> model;
  for (int c = 0; c < 3; ++c)
  {
    model[c] = m[c] * world[0] + m[4 + c] * world[1] + m[8 + c] * world[2];
  }
  return model;
}

std::array<double, 3> ToWorld(vtkNURBSDataSet* body, const std::array<double, 4>& point)
{
  const double* origin = body->GetModel()->GetOrigin();
  const double* m = body->GetPlacementData();
  std::array<double, 3> world = ToWorldVector(body,
    { origin[0] + point[0] / point[3], origin[1] + point[1] / point[3], origin[2] + point[2] / point[3] });
  for (int r = 0; r < 3; ++r)
  {
    world[r] += m[4 * r + 3];
  }
  return world;
}

EditedPart::EditedPart(vtkPartitionedDataSetCollection* source)
  : Bodies(vtkSmartPointer<vtkPartitionedDataSetCollection>::New())
{
  for (unsigned int i = 0; i < source->GetNumberOfPartitionedDataSets(); ++i)
  {
    for (unsigned int j = 0; j < source->GetNumberOfPartitions(i); ++j)
    {
      auto* leaf = vtkNURBSDataSet::SafeDownCast(source->GetPartitionAsDataObject(i, j));
      if (leaf && leaf->GetModel() && leaf->GetPoints())
      {
        Body body{ vtkSmartPointer<vtkNURBSDataSet>::New(), {} };
        body.Leaf->ShallowCopy(leaf);
        AddColors(body.Leaf);
        this->Now.push_back(body);
      }
    }
  }
  this->Steps = { this->Now };
  this->Show(this->Now);
}

EditedPart::~EditedPart() = default;

vtkPartitionedDataSetCollection* EditedPart::GetBodies() const
{
  return this->Bodies;
}

int EditedPart::GetNumberOfBodies() const
{
  return static_cast<int>(this->Now.size());
}

vtkNURBSDataSet* EditedPart::GetBody(int body) const
{
  return this->Now.at(body).Leaf;
}

const FacePointer& EditedPart::GetFace(int body, int face) const
{
  return this->GetBody(body)->GetModel()->GetFaces().at(face);
}

const std::vector<OpenedEdge>& EditedPart::GetOpened(int body) const
{
  return this->Now.at(body).Opened;
}

bool EditedPart::GetPosition(const Grip& grip, std::array<double, 3>& world) const
{
  std::array<double, 4> point;
  if (grip.Body < 0 || grip.Body >= this->GetNumberOfBodies() ||
    !GetControlPoint(this->GetBody(grip.Body)->GetModel(), grip.Face, grip.Index, point))
  {
    return false;
  }
  world = ToWorld(this->GetBody(grip.Body), point);
  return true;
}

bool EditedPart::GetWeight(const Grip& grip, double& weight) const
{
  std::array<double, 4> point;
  if (grip.Body < 0 || grip.Body >= this->GetNumberOfBodies() ||
    !GetControlPoint(this->GetBody(grip.Body)->GetModel(), grip.Face, grip.Index, point))
  {
    return false;
  }
  weight = point[3];
  return true;
}

std::array<double, 3> EditedPart::GetNormal(const Grip& grip) const
{
  const FacePointer& face = this->GetFace(grip.Body, grip.Face);
  double position[3];
  double du[3];
  double dv[3];
  face->Surface.Evaluate(GetGreville(face->Surface, 0, grip.Index.U),
    GetGreville(face->Surface, 1, grip.Index.V), position, du, dv);
  std::array<double, 3> normal;
  vtkMath::Cross(du, dv, normal.data());
  if (vtkMath::Normalize(normal.data()) > 0.0 && face->Reversed)
  {
    vtkMath::MultiplyScalar(normal.data(), -1.0);
  }
  return ToWorldVector(this->GetBody(grip.Body), normal);
}

void EditedPart::Show(State state)
{
  this->Now = std::move(state);
  for (std::size_t i = 0; i < this->Now.size(); ++i)
  {
    this->Bodies->SetPartition(static_cast<unsigned int>(i), 0, this->Now[i].Leaf);
  }
  this->Bodies->Modified();
}

template <typename EditFunction>
bool EditedPart::Change(int index, const EditFunction& edit)
{
  if (index < 0 || index >= this->GetNumberOfBodies())
  {
    this->Message = "there is no body " + std::to_string(index);
    return false;
  }
  const double start = vtkTimerLog::GetUniversalTime();
  vtkNURBSDataSet* before = this->Steps[this->Step][index].Leaf;
  vtkTrimmedNURBSModel* original = this->Steps.front()[index].Leaf->GetModel();
  ModelEdit result = edit(before);
  this->Message = result.Message;
  if (result.Status != EditStatus::Ok)
  {
    return false;
  }
  Body body{ vtkSmartPointer<vtkNURBSDataSet>::New(), {} };
  body.Opened =
    before->GetModel() == original ? std::move(result.Opened) : FindOpenedEdges(original, result.Model);
  const double edited = vtkTimerLog::GetUniversalTime();
  body.Leaf->ShallowCopy(before);
  if (!this->Points->UpdatePoints(body.Leaf, result.Model))
  {
    this->Message = this->Points->GetMessage();
    return false;
  }
  this->EditSeconds = edited - start;
  this->DisplaySeconds = vtkTimerLog::GetUniversalTime() - edited;
  State state = this->Steps[this->Step];
  state[index] = std::move(body);
  this->Show(std::move(state));
  return true;
}

bool EditedPart::Move(const Grip& grip, const std::array<double, 3>& displacement, EditRule rule)
{
  return this->Change(grip.Body,
    [&](vtkNURBSDataSet* leaf)
    {
      return MoveControlPoints(
        leaf->GetModel(), grip.Face, { grip.Index }, ToModelVector(leaf, displacement), rule);
    });
}

bool EditedPart::Replace(int body, vtkTrimmedNURBSModel* moved)
{
  return this->Change(body,
    [&](vtkNURBSDataSet* leaf)
    {
      ModelEdit edit;
      edit.Model = moved;
      edit.Opened = FindOpenedEdges(leaf->GetModel(), moved);
      return edit;
    });
}

bool EditedPart::SetWeight(const Grip& grip, double weight, EditRule rule)
{
  return this->Change(grip.Body,
    [&](vtkNURBSDataSet* leaf)
    { return SetWeights(leaf->GetModel(), grip.Face, { grip.Index }, weight, rule); });
}

bool EditedPart::Commit()
{
  bool moved = false;
  for (std::size_t i = 0; i < this->Now.size(); ++i)
  {
    moved = moved || this->Now[i].Leaf != this->Steps[this->Step][i].Leaf;
  }
  if (moved)
  {
    this->Steps.resize(this->Step + 1);
    this->Steps.push_back(this->Now);
    ++this->Step;
  }
  return moved;
}

void EditedPart::Cancel()
{
  this->GoTo(this->Step);
}

bool EditedPart::GoTo(std::size_t step)
{
  this->Step = step;
  this->EditSeconds = this->DisplaySeconds = 0.0;
  this->Message.clear();
  this->Show(this->Steps[step]);
  return true;
}

bool EditedPart::Undo()
{
  return this->Step > 0 && this->GoTo(this->Step - 1);
}

bool EditedPart::Redo()
{
  return this->Step + 1 < this->Steps.size() && this->GoTo(this->Step + 1);
}

bool EditedPart::Reset()
{
  this->EditSeconds = this->DisplaySeconds = 0.0;
  this->Message.clear();
  this->Cancel();
  this->Show(this->Steps.front());
  return this->Commit();
}
}
