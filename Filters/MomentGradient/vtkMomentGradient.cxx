#include "vtkMomentGradient.h"

#include "smAbortFlag.h"
#include "smFailureReason.h"
#include "smFormat.h"
#include "smMomentGradient.h"

#include "vtkCellArray.h"
#include "vtkComputeContext.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <exception>

vtkStandardNewMacro(vtkMomentGradient);

namespace
{
void AddText(vtkPolyData* output, const char* name, const std::vector<std::string>& lines)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& line : lines)
  {
    array->InsertNextValue(line);
  }
  output->GetFieldData()->AddArray(array);
}

template <class Array>
vtkSmartPointer<Array> AddPointArray(
  vtkPolyData* output, const std::string& name, int components, vtkIdType points)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(points);
  output->GetPointData()->AddArray(array);
  return array;
}

/// Adds the points of a net, lines through them, and their arrays, from point `first` on.
void AddNets(const sm::MomentGradientResult& result, vtkPolyData* output)
{
  vtkIdType count = 0;
  for (const sm::FaceMomentGradient& face : result.Faces)
  {
    count += static_cast<vtkIdType>(face.Points.size());
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkCellArray> lines;
  const auto weights = AddPointArray<vtkDoubleArray>(output, "Weight", 1, count);
  const auto solids = AddPointArray<vtkIntArray>(output, "Solid", 1, count);
  const auto faces = AddPointArray<vtkIntArray>(output, "Face", 1, count);
  const auto ids = AddPointArray<vtkTypeInt64Array>(output, "FaceId", 1, count);
  const auto inU = AddPointArray<vtkIntArray>(output, "IndexU", 1, count);
  const auto inV = AddPointArray<vtkIntArray>(output, "IndexV", 1, count);
  const auto variables = AddPointArray<vtkIdTypeArray>(output, "PointVariable", 1, count);
  const auto weightVariables = AddPointArray<vtkIdTypeArray>(output, "WeightVariable", 1, count);
  vtkIdType at = 0;
  for (const sm::FaceMomentGradient& face : result.Faces)
  {
    const vtkIdType first = at;
    for (int i = 0; i < face.Count[0]; ++i)
    {
      for (int j = 0; j < face.Count[1]; ++j, ++at)
      {
        const std::size_t k = at - first;
        points->SetPoint(at, face.Points[k].data());
        weights->SetValue(at, face.Points[k][3]);
        solids->SetValue(at, face.Solid);
        faces->SetValue(at, face.Face);
        ids->SetValue(at, face.FileId);
        inU->SetValue(at, i);
        inV->SetValue(at, j);
        variables->SetValue(at, face.PointVariables[k]);
        weightVariables->SetValue(at, face.WeightVariables[k]);
      }
    }
    for (int i = 0; i < face.Count[0]; ++i)
    {
      lines->InsertNextCell(face.Count[1]);
      for (int j = 0; j < face.Count[1]; ++j)
      {
        lines->InsertCellPoint(first + static_cast<vtkIdType>(i) * face.Count[1] + j);
      }
    }
    for (int j = 0; j < face.Count[1]; ++j)
    {
      lines->InsertNextCell(face.Count[0]);
      for (int i = 0; i < face.Count[0]; ++i)
      {
        lines->InsertCellPoint(first + static_cast<vtkIdType>(i) * face.Count[1] + j);
      }
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
}

/// Adds the four arrays of a quantity.
void AddQuantity(const sm::MomentGradientResult& result, int quantity, vtkPolyData* output)
{
  const std::string name = sm::GetGradientQuantities()[quantity].Name;
  const vtkIdType count = output->GetNumberOfPoints();
  vtkSmartPointer<vtkDoubleArray> arrays[2][2];
  for (int which = 0; which < 2; ++which)
  {
    const std::string suffix = which == 0 ? "" : "Bound";
    arrays[which][0] = AddPointArray<vtkDoubleArray>(output, name + "ByPoint" + suffix, 3, count);
    arrays[which][1] = AddPointArray<vtkDoubleArray>(output, name + "ByWeight" + suffix, 1, count);
  }
  vtkIdType at = 0;
  for (const sm::FaceMomentGradient& face : result.Faces)
  {
    for (int i = 0; i < face.Count[0]; ++i)
    {
      for (int j = 0; j < face.Count[1]; ++j, ++at)
      {
        for (int which = 0; which < 2; ++which)
        {
          const std::vector<double>& from = which == 0 ? face.Values : face.Bounds;
          for (int c = 0; c < 3; ++c)
          {
            arrays[which][0]->SetComponent(at, c, from[face.GetIndex(i, j, c, quantity)]);
          }
          arrays[which][1]->SetValue(at, from[face.GetIndex(i, j, 3, quantity)]);
        }
      }
    }
  }
}

vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, const std::vector<double>& values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(4 * sm::NumberOfGradientQuantities);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / array->GetNumberOfComponents());
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}
}

vtkMomentGradient::vtkMomentGradient()
{
  sm::ClearAbortAtStart(this);
}

vtkMomentGradient::~vtkMomentGradient() = default;

void vtkMomentGradient::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tied: " << this->Tied << "\n"
     << indent << "RelativeTolerance: " << this->RelativeTolerance << "\n"
     << indent << "Backend: " << this->Backend << "\n"
     << indent << "UsedBackend: " << this->UsedBackend << "\n"
     << indent << "Solids: " << this->SolidIndices.size() << " chosen\n"
     << indent << "Faces: " << this->FaceIndices.size() << " chosen\n"
     << indent << "Status: " << this->Status << "\n";
}

void vtkMomentGradient::SetRelativeTolerance(double tolerance)
{
  if (!(tolerance > 0.0 && tolerance <= 1.0))
  {
    vtkErrorMacro("the relative tolerance is " << sm::FormatDigits(tolerance, 6)
                                               << " and stays as it was: give 1e-15 to 1, for example 1e-9");
    return;
  }
  const double clamped = std::max(tolerance, 1e-15);
  if (clamped != this->RelativeTolerance)
  {
    this->RelativeTolerance = clamped;
    this->Modified();
  }
}

void vtkMomentGradient::SetComputeContext(vtkComputeContext* context)
{
  if (context != this->Context)
  {
    this->Context = context;
    this->Modified();
  }
}

void vtkMomentGradient::AddSolid(int index)
{
  this->SolidIndices.push_back(index);
  this->Modified();
}

void vtkMomentGradient::ClearSolids()
{
  this->SolidIndices.clear();
  this->Modified();
}

void vtkMomentGradient::AddFace(int index)
{
  this->FaceIndices.push_back(index);
  this->Modified();
}

void vtkMomentGradient::ClearFaces()
{
  this->FaceIndices.clear();
  this->Modified();
}

const vtkMomentGradient::FaceArrays* vtkMomentGradient::Find(int index) const
{
  return index >= 0 && index < this->GetNumberOfFaces() ? &this->Faces[index] : nullptr;
}

vtkDoubleArray* vtkMomentGradient::GetValues(int index) const
{
  const FaceArrays* face = this->Find(index);
  return face ? face->Values.Get() : nullptr;
}

vtkDoubleArray* vtkMomentGradient::GetBounds(int index) const
{
  const FaceArrays* face = this->Find(index);
  return face ? face->Bounds.Get() : nullptr;
}

int vtkMomentGradient::GetCountU(int index) const
{
  const FaceArrays* face = this->Find(index);
  return face ? face->Count[0] : 0;
}

int vtkMomentGradient::GetCountV(int index) const
{
  const FaceArrays* face = this->Find(index);
  return face ? face->Count[1] : 0;
}

int vtkMomentGradient::GetSolid(int index) const
{
  const FaceArrays* face = this->Find(index);
  return face ? face->Solid : -1;
}

int vtkMomentGradient::GetFace(int index) const
{
  const FaceArrays* face = this->Find(index);
  return face ? face->Face : -1;
}

int vtkMomentGradient::GetNumberOfQuantities()
{
  return sm::NumberOfGradientQuantities;
}

std::string vtkMomentGradient::GetQuantityName(int quantity)
{
  return quantity >= 0 && quantity < sm::NumberOfGradientQuantities
    ? sm::GetGradientQuantities()[quantity].Name
    : "";
}

int vtkMomentGradient::GetQuantityLengthPower(int quantity)
{
  return quantity >= 0 && quantity < sm::NumberOfGradientQuantities
    ? sm::GetGradientQuantities()[quantity].LengthPower
    : 0;
}

int vtkMomentGradient::FillInputPortInformation(int, vtkInformation* info)
{
  // All data, which is refused in one sentence; VTK says one for each request.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

int vtkMomentGradient::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  this->Faces.clear();
  this->Status = this->Reason = "";
  this->Evaluations = 0;
  this->UsedBackend = CPU;
  this->BackendReason = "";
  this->MomentSeconds = this->GradientSeconds = 0.0;
  try
  {
    sm::MomentGradientOptions options;
    options.Solids = this->SolidIndices;
    options.Faces = this->FaceIndices;
    options.Tied = this->Tied;
    options.RelativeTolerance = this->RelativeTolerance;
    options.Backend = static_cast<sm::BackendChoice>(this->Backend);
    if (!this->Context && this->Backend != CPU)
    {
      // Not started before it is needed.
      this->Context = vtkSmartPointer<vtkComputeContext>::New();
    }
    options.Context = this->Context;
    options.Progress = [this](double fraction)
    {
      this->UpdateProgress(fraction);
      return !this->GetAbortExecute();
    };
    const sm::MomentGradientResult result =
      sm::ComputeMomentGradient(vtkDataObject::GetData(input[0]), options);
    this->Status = result.Status;
    this->Reason = result.Reason;
    this->Evaluations = result.Evaluations;
    this->UsedBackend = static_cast<int>(result.Backend);
    this->BackendReason = result.BackendReason;
    this->MomentSeconds = result.MomentSeconds;
    this->GradientSeconds = result.GradientSeconds;
    AddText(output, "Status", { result.Status });
    AddText(output, "Message", result.Messages);
    AddText(output, "LengthUnit", { result.LengthUnit });
    if (result.Faces.empty())
    {
      if (!this->GetAbortExecute())
      {
        vtkErrorMacro(<< result.Reason);
        return 0;
      }
      return 1;
    }
    AddNets(result, output);
    for (int q = 0; q < sm::NumberOfGradientQuantities; ++q)
    {
      AddQuantity(result, q, output);
    }
    output->GetPointData()->SetActiveVectors("VolumeByPoint");
    for (const sm::FaceMomentGradient& face : result.Faces)
    {
      this->Faces.push_back({ face.Solid, face.Face, { face.Count[0], face.Count[1] },
        MakeArray("Values", face.Values), MakeArray("Bounds", face.Bounds) });
    }
  }
  catch (...)
  {
    output->Initialize();
    this->Faces.clear();
    this->Status = "not-computed";
    this->Reason = sm::GetReason(std::current_exception());
    vtkErrorMacro("nothing was computed: " << this->Reason);
    return 0;
  }
  return 1;
}
