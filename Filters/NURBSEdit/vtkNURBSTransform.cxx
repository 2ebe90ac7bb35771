#include "vtkNURBSTransform.h"

#include "Detail/smLeaves.h"
#include "Detail/smTimeSteps.h"
#include "smAbortFlag.h"
#include "smFailureReason.h"
#include "smFormat.h"
#include "smMeshDemand.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLinearTransform.h"
#include "vtkMatrix4x4.h"
#include "vtkNURBSDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTransform.h"
#include "vtkTrimmedNURBSModel.h"

#include <algorithm>
#include <cmath>
#include <exception>

vtkStandardNewMacro(vtkNURBSTransform);

namespace
{
/// Returns the largest deviation of a matrix from a rotation or reflection with a translation; infinity if an
/// entry is not finite.
double GetDeviation(const double m[16])
{
  double deviation = std::max({ std::abs(m[12]), std::abs(m[13]), std::abs(m[14]), std::abs(m[15] - 1.0) });
  for (int i = 0; i < 3; ++i)
  {
    for (int j = i; j < 3; ++j)
    {
      const double product = m[i] * m[j] + m[4 + i] * m[4 + j] + m[8 + i] * m[8 + j];
      deviation = std::max(deviation, std::abs(product - (i == j ? 1.0 : 0.0)));
    }
  }
  const bool finite = std::all_of(m, m + 16, [](double x) { return std::isfinite(x); });
  return finite ? deviation : VTK_DOUBLE_MAX;
}

void MovePoints(vtkPointSet* data, const double m[16])
{
  vtkPoints* from = data->GetPoints();
  if (!from)
  {
    return;
  }
  vtkNew<vtkPoints> to;
  to->SetDataType(from->GetDataType());
  to->SetNumberOfPoints(from->GetNumberOfPoints());
  for (vtkIdType i = 0; i < from->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    from->GetPoint(i, p);
    for (int r = 0; r < 3; ++r)
    {
      q[r] = m[4 * r] * p[0] + m[4 * r + 1] * p[1] + m[4 * r + 2] * p[2] + m[4 * r + 3];
    }
    to->SetPoint(i, q);
  }
  data->SetPoints(to);
}

void MapNormals(vtkDataSetAttributes* attributes, const double m[16])
{
  vtkDataArray* from = attributes->GetNormals();
  if (!from)
  {
    return;
  }
  const auto to = vtkSmartPointer<vtkDataArray>::Take(from->NewInstance());
  to->DeepCopy(from);
  for (vtkIdType i = 0; i < from->GetNumberOfTuples(); ++i)
  {
    double p[3];
    double q[3];
    from->GetTuple(i, p);
    for (int r = 0; r < 3; ++r)
    {
      q[r] = m[4 * r] * p[0] + m[4 * r + 1] * p[1] + m[4 * r + 2] * p[2];
    }
    to->SetTuple(i, q);
  }
  attributes->SetNormals(to);
}

void ReverseCells(vtkPolyData* data)
{
  vtkNew<vtkCellArray> reversed;
  reversed->DeepCopy(data->GetPolys());
  for (vtkIdType i = 0; i < reversed->GetNumberOfCells(); ++i)
  {
    reversed->ReverseCellAtId(i);
  }
  data->SetPolys(reversed);
}
}

vtkNURBSTransform::vtkNURBSTransform()
{
  sm::ClearAbortAtStart(this);
}

vtkNURBSTransform::~vtkNURBSTransform() = default;

void vtkNURBSTransform::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Translation: " << this->Translation[0] << " " << this->Translation[1] << " "
     << this->Translation[2] << "\n"
     << indent << "Rotation: " << this->Rotation[0] << " " << this->Rotation[1] << " " << this->Rotation[2]
     << "\n"
     << indent << "Mirror: " << this->Mirror << "\n"
     << indent << "TimeSteps: " << this->TimeSteps << "\n"
     << indent << "Transform: " << this->Transform.Get() << "\n";
}

void vtkNURBSTransform::SetTransform(vtkLinearTransform* transform)
{
  if (this->Transform != transform)
  {
    this->Transform = transform;
    this->Modified();
  }
}

vtkLinearTransform* vtkNURBSTransform::GetTransform()
{
  return this->Transform;
}

vtkMTimeType vtkNURBSTransform::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Transform ? std::max(time, this->Transform->GetMTime()) : time;
}

void vtkNURBSTransform::GetMatrix(vtkMatrix4x4* matrix)
{
  this->MakeMatrix(1.0, matrix);
}

void vtkNURBSTransform::MakeMatrix(double share, vtkMatrix4x4* matrix)
{
  if (this->Transform)
  {
    this->Transform->Update();
    matrix->DeepCopy(this->Transform->GetMatrix());
    return;
  }
  vtkNew<vtkTransform> transform;
  transform->Translate(
    share * this->Translation[0], share * this->Translation[1], share * this->Translation[2]);
  transform->RotateZ(share * this->Rotation[2]);
  transform->RotateX(share * this->Rotation[0]);
  transform->RotateY(share * this->Rotation[1]);
  transform->Scale(
    this->Mirror == X ? -1.0 : 1.0, this->Mirror == Y ? -1.0 : 1.0, this->Mirror == Z ? -1.0 : 1.0);
  matrix->DeepCopy(transform->GetMatrix());
}

int vtkNURBSTransform::ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputs,
  vtkInformationVector* outputs, int port, vtkMTimeType* time)
{
  sm::PassMeshDemand(this, inputs, outputs, port);
  return this->Superclass::ComputePipelineMTime(request, inputs, outputs, port, time);
}

int vtkNURBSTransform::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkNURBSTransform::FillOutputPortInformation(int port, vtkInformation* info)
{
  sm::DeclareMeshOutput(info);
  return this->Superclass::FillOutputPortInformation(port, info);
}

void vtkNURBSTransform::Update(int port)
{
  sm::RequestMeshOutput(this, port);
  this->Superclass::Update(port);
}

vtkTypeBool vtkNURBSTransform::Update(int port, vtkInformationVector* requests)
{
  sm::RequestMeshOutput(this, port);
  return this->Superclass::Update(port, requests);
}

int vtkNURBSTransform::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  sm::DeclareTimeSteps(this->TimeSteps, outputVector->GetInformationObject(0));
  return 1;
}

int vtkNURBSTransform::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  try
  {
    return this->MoveInput(vtkDataObject::GetData(inputVector[0], 0),
             sm::TakeTimeShare(this->TimeSteps, outputVector->GetInformationObject(0)), output)
      ? 1
      : 0;
  }
  catch (...)
  {
    output->Initialize();
    vtkErrorMacro(
      "The transformation failed: " << sm::GetReason(std::current_exception()) << ". The output is empty.");
  }
  // Where ranks run together, what is downstream must run on all or on none.
  vtkInformation* info = outputVector->GetInformationObject(0);
  return info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()) > 1 ? 1 : 0;
}

bool vtkNURBSTransform::MoveInput(vtkDataObject* input, double share, vtkDataObject* output)
{
  vtkNew<vtkMatrix4x4> matrix;
  this->MakeMatrix(share, matrix);
  const double* m = matrix->GetData();
  const double deviation = GetDeviation(m);
  if (!(deviation <= 1e-12))
  {
    vtkErrorMacro("The transform is not rigid: it scales, shears or projects (off by "
      << sm::FormatDigits(deviation, 3)
      << "), and a placement of exact geometry may only rotate, reflect and translate. Leave "
      << "the scale out, choose the reader's output unit instead, or deform the part with NURBS Deform.");
    return false;
  }
  const bool mirrored = matrix->Determinant() < 0.0;
  const auto move = [&](vtkPointSet* source, vtkPointSet* copy)
  {
    MovePoints(copy, m);
    MapNormals(copy->GetPointData(), m);
    MapNormals(copy->GetCellData(), m);
    auto* mesh = vtkPolyData::SafeDownCast(copy);
    if (mirrored && mesh && mesh->GetPolys())
    {
      ReverseCells(mesh);
    }
    auto* from = vtkNURBSDataSet::SafeDownCast(source);
    auto* to = vtkNURBSDataSet::SafeDownCast(copy);
    if (from && to && from->GetModel())
    {
      vtkNew<vtkMatrix4x4> placement;
      from->GetPlacement(placement);
      vtkMatrix4x4::Multiply4x4(matrix, placement, placement);
      to->SetPlacement(placement);
      to->SetModel(from->GetModel());
    }
    return true;
  };
  const auto report = [this](double part)
  {
    this->UpdateProgress(part);
    return !this->GetAbortExecute();
  };
  const bool done = sm::CopyLeaves(input, output, move, report);
  if (!done && this->GetAbortExecute())
  {
    output->Initialize();
    vtkWarningMacro("The run was aborted: the output is empty.");
    return true;
  }
  return done;
}
