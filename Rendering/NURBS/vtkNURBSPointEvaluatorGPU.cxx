#include "vtkNURBSPointEvaluatorGPU.h"

#include "smComputeBuffer.h"
#include "smComputeProgram.h"
#include "smContextScope.h"
#include "smDisplayPointsCS.h"
#include "smResidentFaces.h"
#include "smShaderSource.h"

#include "vtkAutoInit.h"
#include "vtkComputeContext.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <list>

// The library registers itself: no program needs vtk_module_autoinit for it.
VTK_MODULE_INIT(smRenderingNURBS)

vtkStandardNewMacro(vtkNURBSPointEvaluatorGPU);

namespace
{
// Invocations per work group, as in the shader.
constexpr unsigned int LocalSize = 32;
// Approximate number of evaluations of a bicubic patch in one dispatch: some 50 ms on two CPU cores.
constexpr std::size_t PointsPerDispatch = 1000000;
// Largest number of points whose results are on the GPU at a time.
constexpr std::size_t PointsPerRead = 1 << 20;
// Budget for patches on the GPU. It is small because the patches of edited faces are mostly used once.
constexpr std::size_t PatchBudget = std::size_t{ 64 } << 20;

// As smLocalPoint in glsl/smDisplayPointsCS.glsl, std430.
static_assert(sizeof(sm::LocalPoint) == 24, "layout of smLocalPoint");
static_assert(sizeof(sm::PointAndNormal) == 6 * sizeof(double), "layout of smResults");

/// Points of neighbouring faces on one page.
struct Portion
{
  std::size_t First;
  std::size_t Count;
  int Page;
};
}

/// All data that belong to one context.
struct vtkNURBSPointEvaluatorGPU::Internals
{
  /// A layout whose points are on the GPU, with the version of the points of every face.
  struct Mesh
  {
    std::weak_ptr<sm::PointLayout> Layout;
    sm::ComputeBuffer Points;
    std::vector<std::uint64_t> Versions;
  };

  vtkSmartPointer<vtkComputeContext> Context;
  sm::ResidentFaces Resident;
  sm::ComputeProgram Program;
  sm::ComputeBuffer FirstPatches;
  sm::ComputeBuffer Results;
  std::list<Mesh> Meshes;
  std::string Error;

  explicit Internals(vtkComputeContext* context)
    : Context(context)
    , Resident(context, sm::ResidentFaces::Sharing::None)
    , FirstPatches(context)
    , Results(context)
  {
    this->Resident.SetBudget(PatchBudget);
  }

  bool Fail(const std::string& what)
  {
    this->Error = "display points: " + what;
    return false;
  }

  bool Build();
  bool UploadPoints(const Work& work, Mesh*& mesh);
  std::vector<Portion> MakePortions(
    const Work& work, const std::vector<sm::ResidentFace>& places, std::size_t room) const;
  bool Dispatch(Mesh& mesh, const Portion& portion, std::size_t firstResult);
  bool Run(const Work& work, std::vector<sm::PointAndNormal>& results);
};

bool vtkNURBSPointEvaluatorGPU::Internals::Build()
{
  if (this->Program.IsBuilt())
  {
    return true;
  }
  sm::ShaderSource source("smDisplayPointsCS", smDisplayPointsCS);
  for (const char* chunk : { "smBernstein", "smDisplayPoint", "smPatch", "smPatchRecord", "smResident" })
  {
    source.AddChunk(chunk, sm::GetNURBSShaderChunk(chunk));
  }
  source.Define("SM_ROW_SIZE", sm::MaximumDegree + 1);
  source.Define("SM_BASIS_SIZE", sm::MaximumDegree);
  if (!source.Assemble())
  {
    return this->Fail(source.GetError());
  }
  return this->Program.Build(this->Context, source.GetName(), source.GetSource()) ||
    this->Fail(this->Program.GetError());
}

bool vtkNURBSPointEvaluatorGPU::Internals::UploadPoints(const Work& work, Mesh*& mesh)
{
  this->Meshes.remove_if([](const Mesh& known) { return known.Layout.expired(); });
  auto found = std::find_if(this->Meshes.begin(), this->Meshes.end(),
    [&work](const Mesh& known) { return known.Layout.lock() == work.Layout; });
  if (found == this->Meshes.end())
  {
    this->Meshes.push_back({ work.Layout, sm::ComputeBuffer(this->Context), {} });
    found = std::prev(this->Meshes.end());
  }
  mesh = &*found;
  const sm::PointLayout& layout = *work.Layout;
  const std::size_t bytes = layout.GetPoints().size() * sizeof(sm::LocalPoint);
  if (mesh->Points.GetSize() != bytes)
  {
    mesh->Versions.assign(layout.GetNumberOfFaces(), 0);
    if (!mesh->Points.Allocate(bytes))
    {
      return this->Fail(mesh->Points.GetError());
    }
  }
  for (const std::size_t face : work.Faces)
  {
    if (mesh->Versions[face] == layout.GetVersion(face))
    {
      continue;
    }
    const std::size_t first = layout.GetFirst(face);
    if (!mesh->Points.Upload(layout.GetPoints().data() + first,
          layout.GetCount(face) * sizeof(sm::LocalPoint), first * sizeof(sm::LocalPoint)))
    {
      return this->Fail(mesh->Points.GetError());
    }
    mesh->Versions[face] = layout.GetVersion(face);
  }
  return true;
}

std::vector<Portion> vtkNURBSPointEvaluatorGPU::Internals::MakePortions(
  const Work& work, const std::vector<sm::ResidentFace>& places, std::size_t room) const
{
  const sm::PointLayout& layout = *work.Layout;
  std::vector<Portion> portions;
  for (std::size_t i = 0; i < work.Faces.size(); ++i)
  {
    const int* degree = work.Patches[i]->Degree;
    const std::size_t cost = std::max(1, (degree[0] + 1) * (degree[1] + 1) / 16);
    const std::size_t limit = std::min(std::max<std::size_t>(PointsPerDispatch / cost, LocalSize), room);
    std::size_t first = layout.GetFirst(work.Faces[i]);
    for (std::size_t left = layout.GetCount(work.Faces[i]); left > 0;)
    {
      const bool goesOn = !portions.empty() && portions.back().Page == places[i].Page &&
        portions.back().First + portions.back().Count == first && portions.back().Count < limit;
      if (!goesOn)
      {
        portions.push_back({ first, 0, places[i].Page });
      }
      const std::size_t count = std::min(left, limit - portions.back().Count);
      portions.back().Count += count;
      first += count;
      left -= count;
    }
  }
  return portions;
}

bool vtkNURBSPointEvaluatorGPU::Internals::Dispatch(
  Mesh& mesh, const Portion& portion, std::size_t firstResult)
{
  // A bound range starts at an aligned offset: at a multiple of so many points.
  const auto alignment = static_cast<std::size_t>(this->Context->GetStorageOffsetAlignment());
  const std::size_t begin = portion.First / alignment * alignment;
  const std::size_t end = portion.First + portion.Count;
  const auto toUnsigned = [](std::size_t value) { return static_cast<unsigned int>(value); };
  if (!this->Resident.Bind(portion.Page) ||
    !mesh.Points.Bind(3, begin * sizeof(sm::LocalPoint), (end - begin) * sizeof(sm::LocalPoint)) ||
    !this->FirstPatches.Bind(4) || !this->Results.Bind(5))
  {
    return this->Fail("buffers cannot be bound: " + mesh.Points.GetError() + this->FirstPatches.GetError() +
      this->Results.GetError());
  }
  return (this->Program.SetUniform("smFirstPoint", toUnsigned(portion.First - begin)) &&
           this->Program.SetUniform("smFirstResult", toUnsigned(firstResult)) &&
           this->Program.SetUniform("smPointCount", toUnsigned(portion.Count)) &&
           this->Program.Dispatch(toUnsigned(portion.Count), LocalSize)) ||
    this->Fail(this->Program.GetError());
}

bool vtkNURBSPointEvaluatorGPU::Internals::Run(const Work& work, std::vector<sm::PointAndNormal>& results)
{
  if (this->Context->Start() != vtkComputeContext::READY)
  {
    this->Error = this->Context->GetReason();
    return false;
  }
  const sm::ContextScope scope(this->Context);
  if (!scope)
  {
    return this->Fail("the context cannot be entered: " + this->Context->GetReason());
  }
  std::vector<sm::ResidentFace> places;
  if (!this->Resident.Acquire(work.Patches, places, nullptr))
  {
    return this->Fail(this->Resident.GetError());
  }
  std::vector<std::uint32_t> firstPatches(work.Layout->GetNumberOfFaces(), 0);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (!places[i].Error.empty())
    {
      return this->Fail(places[i].Error);
    }
    firstPatches[work.Faces[i]] = places[i].FirstPatch;
  }
  Mesh* mesh = nullptr;
  if (!this->Build() || !this->UploadPoints(work, mesh))
  {
    return false;
  }
  // Results are read when there is no room for the next portion's.
  const std::size_t room = std::min(PointsPerRead,
    static_cast<std::size_t>(this->Context->GetMaximumStorageBlockSize()) / sizeof(sm::PointAndNormal));
  const std::vector<Portion> portions = this->MakePortions(work, places, room);
  if (!this->FirstPatches.Upload(firstPatches) ||
    !this->Results.Allocate(std::min(room, results.size()) * sizeof(sm::PointAndNormal)))
  {
    return this->Fail(this->FirstPatches.GetError() + this->Results.GetError());
  }
  std::size_t done = 0;
  std::size_t waiting = 0;
  for (std::size_t i = 0; i < portions.size(); ++i)
  {
    if (!this->Dispatch(*mesh, portions[i], waiting))
    {
      return false;
    }
    waiting += portions[i].Count;
    if (i + 1 == portions.size() || waiting + portions[i + 1].Count > room)
    {
      if (!this->Results.Read(results.data() + done, waiting * sizeof(sm::PointAndNormal)))
      {
        return this->Fail(this->Results.GetError());
      }
      done += waiting;
      waiting = 0;
    }
  }
  return true;
}

vtkNURBSPointEvaluatorGPU::vtkNURBSPointEvaluatorGPU()
  : Implementation(new Internals(vtkNew<vtkComputeContext>()))
{
}

vtkNURBSPointEvaluatorGPU::~vtkNURBSPointEvaluatorGPU() = default;

void vtkNURBSPointEvaluatorGPU::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ComputeContext: " << this->Implementation->Context.Get() << "\n";
}

void vtkNURBSPointEvaluatorGPU::SetRenderWindow(vtkRenderWindow* window)
{
  if (this->GetRenderWindow() != window)
  {
    this->Implementation->Context->SetWindow(window);
    this->Modified();
  }
}

vtkRenderWindow* vtkNURBSPointEvaluatorGPU::GetRenderWindow()
{
  return this->Implementation->Context->GetWindow();
}

void vtkNURBSPointEvaluatorGPU::SetComputeContext(vtkComputeContext* context)
{
  if (this->Implementation->Context != context)
  {
    vtkSmartPointer<vtkComputeContext> next = context;
    if (!next)
    {
      next = vtkSmartPointer<vtkComputeContext>::New();
    }
    this->Implementation = std::make_unique<Internals>(next);
    this->Modified();
  }
}

vtkComputeContext* vtkNURBSPointEvaluatorGPU::GetComputeContext()
{
  return this->Implementation->Context;
}

bool vtkNURBSPointEvaluatorGPU::EvaluateByOpenGL(
  const Work& work, std::vector<sm::PointAndNormal>& results, std::string& reason)
{
  const bool done = this->Implementation->Run(work, results);
  reason = done ? "" : this->Implementation->Error;
  return done;
}
