// TestEditSession opengl|cpu: every case of `Benchmark edit` once, and what it costs, counted; times are the
// benchmark's.
#include "smEditSession.h"
#include "smFreeFormBody.h"
#include "smTesting.h"

#include <vtkTrimmedNURBSModel.h>

#include <string>

namespace
{
using namespace smtest;

struct FullRuns
{
  long long Edited = 0;
  double Volume = 0.0;
  /// Evaluations of the changed faces before the edit.
  long long Before = 0;
};

/// Integrates the session's present faces by a new filter, then the original's by the same filter, which has
/// results of all faces but those that changed.
FullRuns RunFully(EditSession& session, vtkNURBSDataSet* original, int backend, double tolerance)
{
  FullRuns runs;
  vtkNew<vtkMassPropertiesGPU> fresh;
  fresh->SetBackend(backend);
  fresh->SetRelativeTolerance(tolerance);
  fresh->SetInputData(session.GetLeaf());
  fresh->Update();
  runs.Volume = fresh->GetVolume();
  runs.Edited = fresh->GetEvaluations();
  fresh->SetInputData(original);
  fresh->Update();
  runs.Before = fresh->GetEvaluations();
  return runs;
}

void CheckBody(int backend, double tolerance)
{
  std::printf("--- tolerance %g\n", tolerance);
  const FreeFormBody body;
  const auto leaf = body.Make();
  const auto faces = static_cast<long long>(leaf->GetModel()->GetNumberOfFaces());
  CheckEqual("faces", FreeFormBody::NumberOfFaces, faces);
  const long long each = leaf->GetNumberOfPoints() / faces;
  EditSession session(leaf, backend, tolerance);
  const UpdateCost full = session.Update(EditKind::FullRun, 0);
  CheckEqual("closed, and in its bounds", "ok", session.GetMass()->GetStatus());
  const double original = session.GetMass()->GetVolume();
  CheckRange("evaluations of a full run", 1e4, static_cast<double>(full.Evaluations), 1e6);
  // From here on the faces that stay are known: those of the full run had other ids.
  session.Update(EditKind::Point, 1);

  const struct
  {
    EditKind Kind;
    long long Faces;
  } cases[] = { { EditKind::Point, 1 }, { EditKind::Row, 2 }, { EditKind::Lattice, faces } };
  int number = 1;
  for (const auto& [kind, changed] : cases)
  {
    const std::string name = GetName(kind);
    const UpdateCost cost = session.Update(kind, ++number);
    CheckEqual(name + ": no error", "", session.GetError());
    CheckEqual(name + ": status", "ok", session.GetMass()->GetStatus());
    CheckEqual(name + ": faces", changed, cost.ChangedFaces);
    CheckEqual(name + ": display points", changed * each, cost.ChangedPoints);
    const FullRuns runs = RunFully(session, leaf, backend, tolerance);
    CheckTrue(name + ": the bits of a full run", runs.Volume == session.GetMass()->GetVolume());
    CheckTrue(name + ": another volume", runs.Volume != original);
    CheckEqual(name + ": evaluations, those of its faces in a full run",
      runs.Edited - (full.Evaluations - runs.Before), cost.Evaluations);
    CheckRange(name + ": of all", 1.0, static_cast<double>(cost.Evaluations),
      changed == faces ? static_cast<double>(runs.Edited) : 0.1 * static_cast<double>(runs.Edited));
    CheckTrue(name + ": dispatches", (cost.Dispatches > 0) == (backend == vtkMassPropertiesGPU::OPENGL),
      std::to_string(cost.Dispatches));
  }
  const UpdateCost again = session.Update(EditKind::Point, 1);
  CheckEqual("the same edit again has a new face", 1, again.ChangedFaces);
  CheckTrue("which is evaluated", again.Evaluations > 0);
}
}

int main(int argc, char* argv[])
{
  const std::string name = argc == 2 ? argv[1] : "";
  if (name != "opengl" && name != "cpu")
  {
    std::fprintf(stderr, "usage: TestEditSession opengl|cpu\n");
    return 2;
  }
  const int backend = name == "cpu" ? vtkMassPropertiesGPU::CPU : vtkMassPropertiesGPU::OPENGL;
  CheckBody(backend, 1e-9);
  CheckBody(backend, 1e-6);
  return Finish();
}
