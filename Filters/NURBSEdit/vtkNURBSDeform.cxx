#include "vtkNURBSDeform.h"

#include "Detail/smDisplayPoints.h"
#include "Detail/smLeaves.h"
#include "Detail/smTimeSteps.h"
#include "smAbortFlag.h"
#include "smFailureReason.h"
#include "smFormat.h"
#include "smMeshDemand.h"
#include "smModelEdit.h"

#include "vtkBoundingBox.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNURBSDataSet.h"
#include "vtkNURBSPointEvaluator.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>

vtkStandardNewMacro(vtkNURBSDeform);

namespace
{
/// Gap that an edit opens, relative to the diagonal of its solid's box, above which the mass properties are
/// suspect (the default of vtkSurfaceIntegralBase::SetGapLimit()).
constexpr double TornShare = 1e-3;
}

struct vtkNURBSDeform::Run
{
  vtkNURBSDeform* Self;
  /// Factor of the displacements at the time of this run.
  double Share;
  /// Results of LATTICE by model, so that a model that several leaves share is deformed once.
  std::map<vtkTrimmedNURBSModel*, sm::ModelEdit> Known;
  int Solids = 0;
  int Deformed = 0;
  /// Largest number of faces of a chosen solid.
  int MaxFaces = 0;
  /// Uses of edges with a gap above TornShare.
  int TornEdges = 0;
  std::string Error;

  sm::PointMap MakeDisplacement(vtkNURBSDataSet* leaf) const;
  sm::PointMap MakeLattice(vtkTrimmedNURBSModel* model) const;
  sm::ModelEdit Edit(vtkTrimmedNURBSModel* model, const sm::PointMap& map) const;
  bool Change(vtkNURBSDataSet* source, vtkNURBSDataSet* copy);
  void Count(const sm::ModelEdit& edit);
  /// Returns true if a displacement is not 0.
  bool HasDisplacement() const
  {
    const double* displacement = this->Self->Displacement;
    return this->Self->Mode == DISPLACE && this->Share != 0.0 &&
      std::any_of(displacement, displacement + 3, [](double d) { return d != 0.0; });
  }
};

sm::PointMap vtkNURBSDeform::Run::MakeDisplacement(vtkNURBSDataSet* leaf) const
{
  // From the world to the stored coordinates: p' = R^T (p - t) - origin; the placement is rigid.
  const double* placement = leaf->GetPlacementData();
  const double* origin = leaf->GetModel()->GetOrigin();
  std::array<double, 3> center{};
  std::array<double, 3> displacement{};
  for (int c = 0; c < 3; ++c)
  {
    for (int r = 0; r < 3; ++r)
    {
      center[c] += placement[4 * r + c] * (this->Self->Center[r] - placement[4 * r + 3]);
      displacement[c] += placement[4 * r + c] * this->Share * this->Self->Displacement[r];
    }
    center[c] -= origin[c];
  }
  const double radius = this->Self->Radius;
  return [center, displacement, radius](const std::array<double, 3>& p)
  {
    const double distance = std::hypot(p[0] - center[0], p[1] - center[1], p[2] - center[2]);
    if (radius > 0.0 && distance >= radius)
    {
      return p;
    }
    // A NaN in a parameter gives NaN for every point.
    const double q = radius == 0.0 ? 1.0 : 1.0 - (distance / radius) * (distance / radius);
    const double factor = q * q * q;
    return std::array<double, 3>{ p[0] + factor * displacement[0], p[1] + factor * displacement[1],
      p[2] + factor * displacement[2] };
  };
}

sm::PointMap vtkNURBSDeform::Run::MakeLattice(vtkTrimmedNURBSModel* model) const
{
  std::array<double, 6> box;
  std::copy_n(model->GetLocalBounds(), 6, box.begin());
  std::array<int, 3> size;
  std::copy_n(this->Self->LatticeSize, 3, size.begin());
  auto displacements = this->Self->LatticeDisplacements;
  for (auto& [point, displacement] : displacements)
  {
    for (double& coordinate : displacement)
    {
      coordinate *= this->Share;
    }
  }
  return [box, size, displacements](const std::array<double, 3>& p)
  {
    std::vector<double> basis[3];
    for (int c = 0; c < 3; ++c)
    {
      const double width = box[2 * c + 1] - box[2 * c];
      const double x = width > 0.0 ? (p[c] - box[2 * c]) / width : 0.0;
      basis[c].assign(size[c], 0.0);
      basis[c][0] = 1.0;
      for (int degree = 1; degree < size[c]; ++degree)
      {
        for (int k = degree; k > 0; --k)
        {
          basis[c][k] = (1.0 - x) * basis[c][k] + x * basis[c][k - 1];
        }
        basis[c][0] *= 1.0 - x;
      }
    }
    std::array<double, 3> moved = p;
    for (const auto& [at, displacement] : displacements)
    {
      if (at[0] < size[0] && at[1] < size[1] && at[2] < size[2])
      {
        const double factor = basis[0][at[0]] * basis[1][at[1]] * basis[2][at[2]];
        for (int c = 0; c < 3; ++c)
        {
          moved[c] += factor * displacement[c];
        }
      }
    }
    return moved;
  };
}

sm::ModelEdit vtkNURBSDeform::Run::Edit(vtkTrimmedNURBSModel* model, const sm::PointMap& map) const
{
  std::vector<int> faces;
  if (this->Self->Mode == DISPLACE && !this->Self->Faces.empty())
  {
    for (const int face : this->Self->Faces)
    {
      if (face < model->GetNumberOfFaces())
      {
        faces.push_back(face);
      }
    }
    if (faces.empty())
    {
      sm::ModelEdit nothing;
      nothing.Model = model;
      return nothing;
    }
  }
  return sm::MapControlPoints(
    model, faces, map, this->Self->KeepClosed ? sm::EditRule::MoveSharedBoundary : sm::EditRule::OneFace);
}

void vtkNURBSDeform::Run::Count(const sm::ModelEdit& edit)
{
  const double limit =
    edit.Model ? TornShare * vtkBoundingBox(edit.Model->GetLocalBounds()).GetDiagonalLength() : 0.0;
  this->Self->NumberOfChangedFaces += static_cast<int>(edit.Replaced.size());
  this->Self->NumberOfOpenedEdges += static_cast<int>(edit.Opened.size());
  for (const sm::OpenedEdge& opened : edit.Opened)
  {
    this->Self->MaxGap = std::max(this->Self->MaxGap, opened.Gap);
    this->TornEdges += opened.Gap > limit ? 1 : 0;
  }
}

bool vtkNURBSDeform::Run::Change(vtkNURBSDataSet* source, vtkNURBSDataSet* copy)
{
  vtkTrimmedNURBSModel* model = source->GetModel();
  const int solid = this->Solids++;
  if (this->Self->Solid >= 0 && this->Self->Solid != solid)
  {
    return true;
  }
  ++this->Deformed;
  this->MaxFaces = std::max(this->MaxFaces, static_cast<int>(model->GetNumberOfFaces()));
  const bool isLattice = this->Self->Mode == LATTICE;
  const sm::PointMap map = isLattice ? this->MakeLattice(model) : this->MakeDisplacement(source);
  sm::ModelEdit edit;
  const auto known = this->Known.find(model);
  if (isLattice && known != this->Known.end())
  {
    edit = known->second;
  }
  else
  {
    edit = this->Edit(model, map);
    this->Count(edit);
    this->Known[model] = edit;
  }
  if (edit.Status != sm::EditStatus::Ok)
  {
    this->Error = edit.Message + "; displacements, centre and radius must be finite";
    return false;
  }
  // A leaf without a moved point keeps its model, and instances keep sharing theirs.
  return edit.Replaced.empty() ||
    sm::SetEditedModel(copy, edit.Model, map, this->Self->GetPointEvaluator(), this->Error);
}

vtkNURBSDeform::vtkNURBSDeform()
  : PointEvaluator(vtkSmartPointer<vtkNURBSPointEvaluator>::New())
{
  sm::ClearAbortAtStart(this);
}

vtkNURBSDeform::~vtkNURBSDeform() = default;

void vtkNURBSDeform::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->Mode << "\n"
     << indent << "Displacement: " << this->Displacement[0] << " " << this->Displacement[1] << " "
     << this->Displacement[2] << "\n"
     << indent << "Center: " << this->Center[0] << " " << this->Center[1] << " " << this->Center[2] << "\n"
     << indent << "Radius: " << this->Radius << "\n"
     << indent << "Faces: " << this->Faces.size() << "\n"
     << indent << "Solid: " << this->Solid << "\n"
     << indent << "KeepClosed: " << this->KeepClosed << "\n"
     << indent << "TimeSteps: " << this->TimeSteps << "\n"
     << indent << "LatticeSize: " << this->LatticeSize[0] << " " << this->LatticeSize[1] << " "
     << this->LatticeSize[2] << "\n"
     << indent << "LatticeDisplacements: " << this->LatticeDisplacements.size() << "\n"
     << indent << "PointEvaluator: " << this->PointEvaluator.Get() << "\n"
     << indent << "NumberOfOpenedEdges: " << this->NumberOfOpenedEdges << "\n"
     << indent << "MaxGap: " << this->MaxGap << "\n"
     << indent << "NumberOfChangedFaces: " << this->NumberOfChangedFaces << "\n";
}

void vtkNURBSDeform::AddFace(int index)
{
  if (index < 0)
  {
    vtkErrorMacro("The face " << index << " is not used: faces are counted from 0.");
    return;
  }
  this->Faces.push_back(index);
  this->Modified();
}

void vtkNURBSDeform::RemoveAllFaces()
{
  if (!this->Faces.empty())
  {
    this->Faces.clear();
    this->Modified();
  }
}

int vtkNURBSDeform::GetNumberOfFaces() const
{
  return static_cast<int>(this->Faces.size());
}

void vtkNURBSDeform::SetLatticeSize(int x, int y, int z)
{
  const int size[3] = { std::clamp(x, 2, 10), std::clamp(y, 2, 10), std::clamp(z, 2, 10) };
  if (!std::equal(size, size + 3, this->LatticeSize))
  {
    std::copy_n(size, 3, this->LatticeSize);
    this->Modified();
  }
}

void vtkNURBSDeform::SetLatticeDisplacement(int i, int j, int k, double x, double y, double z)
{
  if (std::min({ i, j, k }) < 0 || !std::isfinite(x + y + z))
  {
    vtkErrorMacro("The displacement " << sm::FormatTriple(x, y, z) << " of the lattice point " << i << ", "
                                      << j << ", " << k
                                      << " is not used: give indices from 0, and finite numbers.");
    return;
  }
  this->LatticeDisplacements[{ i, j, k }] = { x, y, z };
  this->Modified();
}

void vtkNURBSDeform::ClearLatticeDisplacements()
{
  if (!this->LatticeDisplacements.empty())
  {
    this->LatticeDisplacements.clear();
    this->Modified();
  }
}

void vtkNURBSDeform::AddLatticeDisplacement(double i, double j, double k, double x, double y, double z)
{
  this->SetLatticeDisplacement(vtkMath::Round(i), vtkMath::Round(j), vtkMath::Round(k), x, y, z);
}

void vtkNURBSDeform::SetPointEvaluator(vtkNURBSPointEvaluator* evaluator)
{
  if (this->PointEvaluator != evaluator)
  {
    this->PointEvaluator = evaluator;
    if (!evaluator)
    {
      this->PointEvaluator = vtkSmartPointer<vtkNURBSPointEvaluator>::New();
    }
    this->Modified();
  }
}

vtkNURBSPointEvaluator* vtkNURBSDeform::GetPointEvaluator()
{
  return this->PointEvaluator;
}

vtkMTimeType vtkNURBSDeform::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->PointEvaluator->GetMTime());
}

int vtkNURBSDeform::ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputs,
  vtkInformationVector* outputs, int port, vtkMTimeType* time)
{
  sm::PassMeshDemand(this, inputs, outputs, port);
  return this->Superclass::ComputePipelineMTime(request, inputs, outputs, port, time);
}

int vtkNURBSDeform::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkNURBSDeform::FillOutputPortInformation(int port, vtkInformation* info)
{
  sm::DeclareMeshOutput(info);
  return this->Superclass::FillOutputPortInformation(port, info);
}

void vtkNURBSDeform::Update(int port)
{
  sm::RequestMeshOutput(this, port);
  this->Superclass::Update(port);
}

vtkTypeBool vtkNURBSDeform::Update(int port, vtkInformationVector* requests)
{
  sm::RequestMeshOutput(this, port);
  return this->Superclass::Update(port, requests);
}

int vtkNURBSDeform::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  sm::DeclareTimeSteps(this->TimeSteps, outputVector->GetInformationObject(0));
  return 1;
}

int vtkNURBSDeform::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->NumberOfOpenedEdges = this->NumberOfChangedFaces = 0;
  this->MaxGap = 0.0;
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  bool done = false;
  try
  {
    done = this->DeformInput(vtkDataObject::GetData(inputVector[0], 0),
      info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()),
      sm::TakeTimeShare(this->TimeSteps, info), output);
  }
  catch (...)
  {
    vtkErrorMacro(
      "The deformation failed: " << sm::GetReason(std::current_exception()) << ". The output is empty.");
  }
  if (!done)
  {
    output->Initialize();
  }
  // Where ranks run together, what is downstream must run on all or on none.
  return done || info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()) > 1 ? 1 : 0;
}

bool vtkNURBSDeform::DeformInput(vtkDataObject* input, int piece, double share, vtkDataObject* output)
{
  Run run{ this, share, {}, 0, 0, 0, 0, {} };
  const auto change = [&run](vtkPointSet* source, vtkPointSet* copy)
  {
    auto* from = vtkNURBSDataSet::SafeDownCast(source);
    auto* to = vtkNURBSDataSet::SafeDownCast(copy);
    return !from || !to || !from->GetModel() || run.Change(from, to);
  };
  const auto report = [this](double part)
  {
    this->UpdateProgress(part);
    return !this->GetAbortExecute();
  };
  bool done = sm::CopyLeaves(input, output, change, report);
  if (!done && run.Error.empty() && this->GetAbortExecute())
  {
    output->Initialize();
    vtkWarningMacro("The run was aborted: the output is empty.");
    return true;
  }
  const auto worst = std::max_element(this->Faces.begin(), this->Faces.end());
  if (!done)
  {
    vtkErrorMacro("The deformation is not possible: " << run.Error << ".");
  }
  else if (run.Deformed == 0 && piece > 0)
  {
    // A rank that has no solids.
  }
  else if (run.Deformed == 0)
  {
    done = false;
    vtkErrorMacro("There is no exact geometry to deform: the input has "
      << run.Solids << " solids with it, and the one to deform has the number " << this->Solid + 1
      << " (0: all).");
  }
  else if (this->Mode == DISPLACE && worst != this->Faces.end() && *worst >= run.MaxFaces)
  {
    done = false;
    vtkErrorMacro("There is no face " << *worst << ": the solid has " << run.MaxFaces << ", counted from 0.");
  }
  else if (this->NumberOfChangedFaces == 0 && run.HasDisplacement())
  {
    vtkWarningMacro("The deformation moves nothing: no control point of the chosen faces lies within the "
                    "radius of the centre. Remedy: "
                    "another centre, or a larger radius.");
  }
  else if (run.TornEdges > 0)
  {
    vtkWarningMacro("The deformation tears faces from their edges at "
      << run.TornEdges << " places, by up to " << sm::FormatDistance(this->MaxGap)
      << ": their control points lie too far from each other. Mass properties close such gaps "
      << "and are suspect. Remedy: " << (this->KeepClosed ? "" : "Keep Closed, ")
      << "a smaller displacement, a larger radius, or a part whose faces have more "
         "control points.");
  }
  return done;
}
