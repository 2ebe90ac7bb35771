// TestMassPropertiesContext MODE FOLDER: the numbers come from the shaders, in whatever context there is.
//   x, egl   that context is taken; a perturbed shader changes the result by its factor; two runs give the
//   same bits none     no usable context (the caller limits OpenGL): the CPU computes and a message says why;
//   with OpenGL asked for,
//            NaN, backend "none" and the reason
#include "smResidentFaces.h"
#include "smTestManifest.h"
#include "smTestPipeline.h"
#include "smWrongSamples.h"

#include <vtkComputeContext.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkTable.h>

#include <cstdio>
#include <cstring>
#include <memory>

namespace
{
using namespace smtest;
namespace names = sm::names;

/// All numbers of the field data in a fixed order.
std::vector<double> GetNumbers(vtkMassPropertiesGPU* mass)
{
  std::vector<double> numbers;
  vtkFieldData* fields = mass->GetOutput()->GetFieldData();
  for (const char* name : { names::Volume, names::SurfaceArea, names::CenterOfMass, names::FirstMoments,
         names::SecondMoments, names::VolumeInertia, names::PrincipalMoments, names::ClosureCorrection,
         names::GapSquared, names::ClosureResidual, names::Evaluations })
  {
    for (const std::string& full : { std::string(name), std::string(name) + names::BoundSuffix })
    {
      vtkDataArray* array = fields->GetArray(full.c_str());
      for (int i = 0; array && i < array->GetNumberOfComponents(); ++i)
      {
        numbers.push_back(array->GetComponent(0, i));
      }
    }
  }
  return numbers;
}

/// Bit for bit; NaN equals NaN.
bool AreSameBits(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() && !a.empty() &&
    std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

void CheckContext(const Expected& part, const std::string& mode)
{
  Pipeline pipeline(part.Path);
  pipeline.Mass->Update();
  CheckEqual("backend", "opengl", pipeline.Mass->GetBackendName());
  CheckEqual("source of the context", mode, pipeline.Mass->GetComputeContext()->GetSourceName());
  Check("volume", part.Volume, pipeline.Mass->GetVolume(), 1e-9 * part.Volume);
  CheckTrue("evaluations were counted on the GPU", pipeline.Mass->GetEvaluations() > 0);
  CheckTrue("dispatches were counted", pipeline.Mass->GetDispatches() > 0);
  const std::vector<double> first = GetNumbers(pipeline.Mass);

  pipeline.Mass->CacheFaceResultsOff();
  pipeline.Mass->Update();
  CheckTrue("it evaluates again", pipeline.Mass->GetEvaluations() > 0);
  CheckTrue("second run of the filter: same bits", AreSameBits(first, GetNumbers(pipeline.Mass)));
  Pipeline again(part.Path);
  again.Mass->Update();
  CheckTrue("another reader and filter: same bits", AreSameBits(first, GetNumbers(again.Mass)));
}

/// Checks a shader that multiplies every sample by 1.001: integrals grow by that factor, the centre stays.
void CheckPerturbation(const Expected& part)
{
  const double factor = 1.0 + 1e-3;
  Pipeline pipeline(part.Path);
  auto wrong = std::make_unique<WrongSamples>(pipeline.Mass, factor);
  pipeline.Mass->Update();
  Check(
    "volume of the perturbed shader", factor * part.Volume, pipeline.Mass->GetVolume(), 1e-9 * part.Volume);
  Check(
    "area of the perturbed shader", factor * part.Area, pipeline.Mass->GetSurfaceArea(), 1e-8 * part.Area);
  double center[3];
  pipeline.Mass->GetCenterOfMass(center);
  for (int i = 0; i < 3; ++i)
  {
    Check("centre of the perturbed shader", part.Center[i], center[i], 1e-9 * part.Size);
  }
  wrong.reset();
  pipeline.Mass->Update();
  Check("volume without it", part.Volume, pipeline.Mass->GetVolume(), 1e-9 * part.Volume);
}

/// Two filters of one window on one part: its faces are on the GPU once, and all memory is free when both are
/// gone.
void CheckSharedFaces(const Expected& part)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(part.Path.c_str());
  vtkNew<vtkComputeContext> context;
  context->Start();
  const vtkTypeInt64 before = context->GetAllocatedBytes();
  vtkNew<vtkMassPropertiesGPU> first;
  std::vector<double> numbers;
  {
    vtkNew<vtkMassPropertiesGPU> second;
    vtkTypeInt64 bytes[3] = { before };
    int run = 0;
    for (vtkMassPropertiesGPU* mass : { first.Get(), second.Get() })
    {
      mass->SetRenderWindow(context->GetRenderWindow());
      mass->SetInputConnection(reader->GetOutputPort());
      mass->Update();
      CheckEqual("backend in the window", "opengl", mass->GetBackendName());
      bytes[++run] = context->GetAllocatedBytes();
    }
    CheckTrue("same bits", AreSameBits(GetNumbers(first), GetNumbers(second)));
    std::printf("the first filter takes %lld bytes, the second %lld more\n",
      static_cast<long long>(bytes[1] - bytes[0]), static_cast<long long>(bytes[2] - bytes[1]));
    // The second one has lists and results of its own, of the same size, but no faces.
    sm::ResidentFaces resident(context);
    std::vector<sm::ResidentFace> places;
    CheckTrue("the shared faces", resident.Acquire({}, places, nullptr) && resident.GetBytes() > 0);
    CheckEqual("the second filter adds no faces",
      static_cast<long long>(bytes[1] - bytes[0]) - static_cast<long long>(resident.GetBytes()),
      static_cast<long long>(bytes[2] - bytes[1]));
  }
  CheckTrue("the first one still has the faces", context->GetAllocatedBytes() > before);
  first->SetRenderWindow(nullptr);
  CheckEqual("all is released", static_cast<long long>(before), context->GetAllocatedBytes());
}

/// Without OpenGL, where AUTOMATIC is set, the CPU computes.
/// A small part is the CPU's by the estimate; where OpenGL of a certain source was wanted a message reports
/// why it is not used.
void CheckFallback(const Expected& part, int source)
{
  Pipeline pipeline(part.Path);
  MessageTrap messages(pipeline.Mass);
  pipeline.Mass->SetBackend(vtkMassPropertiesGPU::AUTOMATIC);
  pipeline.Mass->GetComputeContext()->SetSource(source);
  pipeline.Mass->Update();
  vtkFieldData* fields = pipeline.Mass->GetOutput()->GetFieldData();
  CheckEqual("backend", names::BackendCPU, pipeline.Mass->GetBackendName());
  CheckEqual("backend in the field data", names::BackendCPU, GetFieldText(fields, names::Backend));
  CheckTrue("renderer", GetFieldText(fields, names::Renderer).find("CPU, ") == 0,
    GetFieldText(fields, names::Renderer));
  CheckEqual("status", names::StatusOk, pipeline.Mass->GetStatus());
  CheckEqual("errors and warnings", 0, messages.NumberOfErrors + messages.NumberOfWarnings);
  if (source == vtkComputeContext::AUTOMATIC)
  {
    CheckEqual("messages", 0, pipeline.Mass->GetNumberOfMessages());
    CheckEqual("the reason", 0, GetFieldText(fields, names::BackendReason).find("estimated "));
    CheckEqual(
      "nothing was sought", vtkComputeContext::NOT_STARTED, pipeline.Mass->GetComputeContext()->GetStatus());
  }
  else
  {
    CheckEqual("messages", 1, pipeline.Mass->GetNumberOfMessages());
    CheckTrue("the message reports why",
      pipeline.Mass->GetMessage(0).find("computed on the CPU") == 0 &&
        pipeline.Mass->GetMessage(0).find(pipeline.Mass->GetComputeContext()->GetReason()) !=
          std::string::npos,
      pipeline.Mass->GetMessage(0));
  }
  CheckTrue("evaluations were counted", pipeline.Mass->GetEvaluations() > 0);
  CheckEqual("dispatches", 0, pipeline.Mass->GetDispatches());
  Check("volume", part.Volume, pipeline.Mass->GetVolume(), 1e-9 * part.Volume);
  Check("area", part.Area, pipeline.Mass->GetSurfaceArea(), 1e-8 * part.Area);
}

void CheckNone(const Expected& part)
{
  Pipeline pipeline(part.Path);
  pipeline.Mass->SetBackend(vtkMassPropertiesGPU::OPENGL);
  MessageTrap messages(pipeline.Mass);
  MessageTrap executive(pipeline.Mass->GetExecutive());
  pipeline.Mass->Update();
  vtkFieldData* fields = pipeline.Mass->GetOutput()->GetFieldData();
  CheckEqual("backend", "none", pipeline.Mass->GetBackendName());
  CheckEqual("backend in the field data", "none", GetFieldText(fields, names::Backend));
  CheckTrue("status is not ok", pipeline.Mass->GetStatus() != names::StatusOk, pipeline.Mass->GetStatus());
  CheckEqual("errors", 0, messages.NumberOfErrors);
  CheckTrue("a message reports why",
    pipeline.Mass->GetNumberOfMessages() > 0 && pipeline.Mass->GetMessage(0).size() > 20,
    pipeline.Mass->GetMessage(0));
  for (const char* name : { names::Volume, names::SurfaceArea, names::CenterOfMass, names::VolumeInertia })
  {
    vtkDataArray* array = fields->GetArray(name);
    CheckTrue(std::string(name) + " is there and NaN", array && std::isnan(array->GetComponent(0, 0)));
    CheckTrue(std::string(name) + " bound is NaN", std::isnan(GetFieldBound(fields, name)));
  }
  auto* table = vtkTable::SafeDownCast(pipeline.Mass->GetOutputDataObject(1));
  CheckEqual("row of the solid", 1, table->GetNumberOfRows());
  if (table->GetNumberOfRows() == 1)
  {
    CheckTrue("volume of the row is NaN", std::isnan(table->GetValueByName(0, names::Volume).ToDouble()));
  }
}
}

int TestMassPropertiesContext(int argc, char* argv[])
{
  RequireUsage(argc == 3, "TestMassPropertiesContext x|egl|none FOLDER");
  const std::string mode = argv[1];
  const Manifest manifest(argv[2]);
  const Expected part = manifest.GetSolid("slanted_hole", "moved")[0];
  if (mode == "none")
  {
    CheckFallback(part, vtkComputeContext::AUTOMATIC);
    CheckFallback(part, vtkComputeContext::EGL);
    CheckNone(part);
    return Finish();
  }
  CheckContext(part, mode);
  CheckPerturbation(part);
  CheckSharedFaces(part);
  return Finish();
}
