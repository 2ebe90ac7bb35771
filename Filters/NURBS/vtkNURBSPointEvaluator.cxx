#include "vtkNURBSPointEvaluator.h"

#include "smParallelFor.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkNURBSDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTrimmedNURBSModel.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <utility>

vtkObjectFactoryNewMacro(vtkNURBSPointEvaluator);

namespace
{
// A thread costs as much as some thousand points.
constexpr std::size_t PointsPerTask = 2048;
constexpr std::size_t FacesPerTask = 4;

/// The rows of a mesh's placement about the model's origin.
struct Frame
{
  double Rows[3][4];

  Frame(vtkNURBSDataSet* mesh, vtkTrimmedNURBSModel* model)
  {
    const double* m = mesh->GetPlacementData();
    for (int r = 0; r < 3; ++r)
    {
      std::copy_n(m + 4 * r, 4, this->Rows[r]);
      this->Rows[r][3] += vtkMath::Dot(this->Rows[r], model->GetOrigin());
    }
  }

  void Apply(const double from[3], double weight, double to[3]) const
  {
    for (int r = 0; r < 3; ++r)
    {
      to[r] = vtkMath::Dot(this->Rows[r], from) + weight * this->Rows[r][3];
    }
  }
};

/// Where the points of a face begin among those that are evaluated.
struct Range
{
  std::size_t Face;
  std::size_t First;
};

void EvaluateOnCPU(const sm::PointLayout& layout, const std::vector<Range>& ranges,
  const std::vector<sm::CutFacePointer>& patches, std::vector<sm::PointAndNormal>& results)
{
  sm::ParallelFor(results.size(), PointsPerTask,
    [&](std::size_t begin, std::size_t end)
    {
      auto range = std::upper_bound(ranges.begin(), ranges.end(), begin,
                     [](std::size_t at, const Range& r) { return at < r.First; }) -
        1;
      for (std::size_t i = begin; i < end; ++i)
      {
        while (range + 1 != ranges.end() && (range + 1)->First <= i)
        {
          ++range;
        }
        const sm::LocalPoint& point = layout.GetPoints()[layout.GetFirst(range->Face) + i - range->First];
        const sm::FacePanels& face = patches[range - ranges.begin()]->Panels;
        const sm::Patch& patch = face.Patches[point.Patch];
        results[i] = sm::EvaluateDisplayPoint(patch, face.Points.data() + patch.FirstPoint, point.S, point.R);
      }
    });
}

/// A copy of an array, of which a run changes a few tuples.
vtkSmartPointer<vtkDataArray> Copy(vtkDataArray* array)
{
  vtkSmartPointer<vtkDataArray> copy;
  copy.TakeReference(array->NewInstance());
  copy->DeepCopy(array);
  return copy;
}

/// Puts the results, which are in the model's frame, into copies of the mesh's points and normals, and the
/// edited model into the mesh. A point where the surface has no normal keeps the old one.
void MovePoints(vtkNURBSDataSet* mesh, vtkTrimmedNURBSModel* edited, const sm::PointLayout& layout,
  const std::vector<Range>& ranges, const std::vector<sm::PointAndNormal>& results)
{
  const std::vector<sm::FacePointer>& is = edited->GetFaces();
  const Frame frame(mesh, edited);
  vtkDataArray* oldNormals = mesh->GetPointData()->GetNormals();
  const vtkSmartPointer<vtkDataArray> coordinates = Copy(mesh->GetPoints()->GetData());
  const vtkSmartPointer<vtkDataArray> normals = oldNormals ? Copy(oldNormals) : nullptr;
  std::vector<vtkIdType> ids(results.size());
  sm::ParallelFor(ranges.size(), FacesPerTask,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t k = begin; k < end; ++k)
      {
        const Range& range = ranges[k];
        const double side = is[range.Face]->Reversed ? -1.0 : 1.0;
        for (std::size_t i = 0; i < layout.GetCount(range.Face); ++i)
        {
          const sm::PointAndNormal& result = results[range.First + i];
          const std::int64_t id = layout.GetIds()[layout.GetFirst(range.Face) + i];
          ids[range.First + i] = id;
          double moved[3];
          frame.Apply(result.data(), 1.0, moved);
          coordinates->SetTuple(id, moved);
          const double normal[3] = { side * result[3], side * result[4], side * result[5] };
          if (normals && (normal[0] != 0.0 || normal[1] != 0.0 || normal[2] != 0.0))
          {
            frame.Apply(normal, 0.0, moved);
            normals->SetTuple(id, moved);
          }
        }
      }
    });
  if (normals)
  {
    mesh->GetPointData()->SetNormals(normals);
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  mesh->SetModelAndPoints(edited, points, ids);
}
}

struct vtkNURBSPointEvaluator::Internals
{
  struct Known
  {
    vtkWeakPointer<vtkDataArray> FaceIndex;
    vtkWeakPointer<vtkDataArray> Parameters;
    vtkMTimeType FaceIndexTime = 0;
    vtkMTimeType ParametersTime = 0;
    std::shared_ptr<sm::PointLayout> Layout;
  };
  std::vector<Known> Meshes;

  std::shared_ptr<sm::PointLayout> GetLayout(
    vtkDataArray* faceIndex, vtkDataArray* parameters, std::size_t faces)
  {
    this->Meshes.erase(std::remove_if(this->Meshes.begin(), this->Meshes.end(),
                         [](const Known& known)
                         {
                           return !known.FaceIndex || !known.Parameters ||
                             known.FaceIndex->GetMTime() != known.FaceIndexTime ||
                             known.Parameters->GetMTime() != known.ParametersTime;
                         }),
      this->Meshes.end());
    for (const Known& known : this->Meshes)
    {
      if (known.FaceIndex == faceIndex && known.Parameters == parameters &&
        known.Layout->GetNumberOfFaces() == faces)
      {
        return known.Layout;
      }
    }
    this->Meshes.push_back({ faceIndex, parameters, faceIndex->GetMTime(), parameters->GetMTime(),
      std::make_shared<sm::PointLayout>(faceIndex, parameters, faces) });
    return this->Meshes.back().Layout;
  }

  /// The points of the faces that changed; `ranges` gets where the results of each begin.
  static Work MakeWork(const std::vector<sm::FacePointer>& was, const std::vector<sm::FacePointer>& is,
    std::shared_ptr<sm::PointLayout> known, std::vector<Range>& ranges)
  {
    Work work;
    work.Layout = std::move(known);
    sm::PointLayout& layout = *work.Layout;
    for (std::size_t f = 0; f < is.size(); ++f)
    {
      if (is[f] != was[f] && layout.GetCount(f) > 0)
      {
        work.Faces.push_back(f);
        ranges.push_back({ f, work.NumberOfPoints });
        work.NumberOfPoints += layout.GetCount(f);
      }
    }
    work.Patches.resize(work.Faces.size());
    sm::ParallelFor(work.Faces.size(), FacesPerTask,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          work.Patches[i] = layout.MakePatches(is[work.Faces[i]], work.Faces[i]);
        }
      });
    return work;
  }
};

vtkNURBSPointEvaluator::vtkNURBSPointEvaluator()
  : Implementation(new Internals)
{
}

vtkNURBSPointEvaluator::~vtkNURBSPointEvaluator() = default;

void vtkNURBSPointEvaluator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Backend: " << this->Backend << "\n"
     << indent << "NumberOfEvaluations: " << this->NumberOfEvaluations << "\n"
     << indent << "BackendName: " << this->BackendName << "\n"
     << indent << "Message: " << this->Message << "\n";
}

bool vtkNURBSPointEvaluator::Fail(const std::string& why)
{
  this->BackendName = "none";
  this->Message = why;
  return false;
}

bool vtkNURBSPointEvaluator::EvaluateByOpenGL(
  const Work&, std::vector<sm::PointAndNormal>&, std::string& reason)
{
  reason = "the module SolidMoments::RenderingNURBS, which evaluates by OpenGL, is not loaded";
  return false;
}

bool vtkNURBSPointEvaluator::UpdatePoints(vtkNURBSDataSet* mesh, vtkTrimmedNURBSModel* edited)
{
  this->NumberOfEvaluations = 0;
  this->BackendName = "none";
  this->Message.clear();
  vtkTrimmedNURBSModel* before = mesh ? mesh->GetModel() : nullptr;
  if (!before || !edited || !mesh->GetPoints())
  {
    return this->Fail("the mesh has no exact geometry or no points, or there is no edited model");
  }
  vtkDataArray* faceIndex = mesh->GetPointData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName());
  vtkDataArray* parameters = mesh->GetPointData()->GetArray(vtkNURBSDataSet::ParametersArrayName());
  const std::vector<sm::FacePointer>& was = before->GetFaces();
  const std::vector<sm::FacePointer>& is = edited->GetFaces();
  const vtkIdType count = mesh->GetNumberOfPoints();
  if (!faceIndex || !parameters || parameters->GetNumberOfComponents() != 2 ||
    faceIndex->GetNumberOfTuples() != count || parameters->GetNumberOfTuples() != count)
  {
    return this->Fail("the mesh has no FaceIndex and Parameters for its points");
  }
  if (was.size() != is.size())
  {
    return this->Fail("the edited model has " + std::to_string(is.size()) + " faces instead of " +
      std::to_string(was.size()));
  }

  std::vector<Range> ranges;
  const Work work =
    Internals::MakeWork(was, is, this->Implementation->GetLayout(faceIndex, parameters, is.size()), ranges);
  const sm::PointLayout& layout = *work.Layout;
  std::vector<sm::PointAndNormal> results(work.NumberOfPoints);
  if (!results.empty())
  {
    const bool byOpenGL = this->Backend != CPU && this->EvaluateByOpenGL(work, results, this->Message);
    if (!byOpenGL && this->Backend == OPENGL)
    {
      return this->Fail("nothing was evaluated: " + this->Message);
    }
    if (!byOpenGL)
    {
      EvaluateOnCPU(layout, ranges, work.Patches, results);
    }
    this->BackendName = byOpenGL ? "opengl" : "cpu";
  }
  this->NumberOfEvaluations = static_cast<vtkTypeInt64>(results.size());

  MovePoints(mesh, edited, layout, ranges, results);
  return true;
}
