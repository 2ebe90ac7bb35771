// SweepFile FILE.step RESULT.json FOLDER [backends] [buoyancy] [writers]: reads a file once and judges every
// stage with it. RESULT.json gets
//   runs      for each tolerance the entry of the command line's JSON document, its exit status, and seconds
//   kernel    the converted faces against OpenCASCADE's (smKernelComparison.h), null for an unreadable file
//   mesh      the display mesh
//   checks    number and failures of the stages that are named, whose checks are printed
// FOLDER takes files that are saved. Exit status 0 when RESULT.json was written; SweepModels.py is the judge.
#include "smBackendComparison.h"
#include "smFileJob.h"
#include "smJson.h"
#include "smKernelComparison.h"
#include "smReportJson.h"
#include "smResults.h"
#include "smRoundTrip.h"
#if __has_include("smBuoyancySums.h")
#include "smBuoyancySums.h"
#endif

#include <vtkCellArray.h>
#include <vtkMath.h>
#include <vtkNURBSDataSet.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkTimerLog.h>

#include <filesystem>
#include <fstream>
#include <set>

namespace
{
using namespace smtest;
using sm::Json;

constexpr double Tolerances[] = { 1e-9, 1e-12 };
constexpr std::size_t MaxMessages = 20;

/// Compares while the document's shapes are there.
class ComparedReader : public vtkSTEPReader
{
public:
  static ComparedReader* New();
  vtkTypeMacro(ComparedReader, vtkSTEPReader);
  Json Kernel;

protected:
  void InspectDocument(const sm::Document& document) override
  {
    const KernelComparison result = CompareWithKernel(document);
    Json types = Json::object();
    for (const auto& [name, tally] : result.Tallies)
    {
      types[name] = { { "faces", tally.Faces }, { "surface", tally.Surface }, { "trim", tally.Trim } };
    }
    const std::size_t shown = std::min(result.Messages.size(), MaxMessages);
    this->Kernel = { { "solids", result.Solids }, { "shells", result.Shells }, { "faces", result.Faces },
      { "open_edges", result.OpenEdges }, { "missing_faces", result.MissingFaces },
      { "defects", result.Defects }, { "trim_pieces", result.TrimPieces },
      { "edge_pieces", result.EdgePieces }, { "surface", result.Surface }, { "trim", result.Trim },
      { "edge", result.Edge }, { "trim_residual", result.TrimResidual }, { "max_gap", result.MaxGap },
      { "above_limits", result.AboveLimits }, { "types", types },
      { "messages", std::vector<std::string>(result.Messages.begin(), result.Messages.begin() + shown) } };
  }
};
vtkStandardNewMacro(ComparedReader);

/// Volume, and normals that are not unit vectors, of all display meshes.
Json InspectMesh(vtkPartitionedDataSetCollection* parts)
{
  double volume = 0.0;
  long long badNormals = 0;
  for (unsigned int i = 0; i < parts->GetNumberOfPartitionedDataSets(); ++i)
  {
    auto* leaf = vtkNURBSDataSet::SafeDownCast(parts->GetPartitionAsDataObject(i, 0));
    vtkDataArray* normals = leaf ? leaf->GetPointData()->GetNormals() : nullptr;
    for (vtkIdType p = 0; normals && p < normals->GetNumberOfTuples(); ++p)
    {
      const double* n = normals->GetTuple(p);
      badNormals += std::abs(std::hypot(n[0], n[1], n[2]) - 1.0) <= 1e-6 ? 0 : 1;
    }
    if (!leaf || leaf->GetNumberOfPoints() == 0)
    {
      continue;
    }
    double origin[3];
    leaf->GetCenter(origin);
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    for (vtkIdType cell = 0; cell < leaf->GetPolys()->GetNumberOfCells(); ++cell)
    {
      leaf->GetPolys()->GetCellAtId(cell, size, ids);
      double corner[3][3];
      for (int k = 0; k < 3; ++k)
      {
        leaf->GetPoint(ids[k], corner[k]);
        vtkMath::Subtract(corner[k], origin, corner[k]);
      }
      volume += vtkMath::Determinant3x3(corner[0], corner[1], corner[2]) / 6.0;
    }
  }
  return { { "volume", volume }, { "bad_normals", badNormals } };
}

Json RunJob(const std::string& file, double tolerance, vtkSTEPReader* reader)
{
  const double start = vtkTimerLog::GetUniversalTime();
  sm::JobOptions options;
  options.FileName = file;
  // The default itself is under test.
  options.Tolerance = tolerance == Tolerances[0] ? options.Tolerance : tolerance;
  sm::FileResult result(options);
  sm::RunFileJob(
    options, [&](const sm::JobMessage& message) { result = message.File ? *message.File : result; }, reader);
  return { { "tolerance", tolerance }, { "exit_status", sm::GetExitStatus(result) },
    { "seconds", vtkTimerLog::GetUniversalTime() - start }, { "document", sm::MakeJson(result) } };
}

void RunStages(const std::set<std::string>& stages, vtkSTEPReader* reader, const std::string& folder)
{
  const std::string name = std::filesystem::path(reader->GetFileName()).stem().string();
  if (stages.count("backends"))
  {
    CompareBackends(reader, 0.0);
  }
#if __has_include("smBuoyancySums.h")
  if (stages.count("buoyancy"))
  {
    CheckBelowAndAbove(reader, name, { { 0, 0, 1 }, { 0.3L, -0.5L, 0.8L } }, true);
  }
#endif
  if (stages.count("writers"))
  {
    const auto saved =
      SaveAndRead(folder + "/" + name + ".step", reader->GetOutput(), nullptr, DisplayMesh::Fine);
    CompareProperties(name, reader->GetOutput(), saved, 1e-12);
  }
}
}

int main(int argc, char* argv[])
{
  if (argc < 4)
  {
    std::fprintf(stderr, "usage: SweepFile FILE.step RESULT.json FOLDER [backends] [buoyancy] [writers]\n");
    return 1;
  }
  vtkNew<ComparedReader> reader;
  Json result;
  for (const double tolerance : Tolerances)
  {
    result["runs"].push_back(RunJob(argv[1], tolerance, reader));
  }
  result["kernel"] = reader->Kernel;
  // The jobs have switched the display mesh off.
  reader->SetDisplayMesh(vtkCADReader::MESH_ALWAYS);
  reader->Update();
  result["mesh"] = InspectMesh(reader->GetOutput());
  RunStages({ argv + 4, argv + argc }, reader, argv[3]);
  result["checks"] = { { "number", GetCounts().Checks }, { "failures", GetCounts().Failures } };
  std::ofstream file(argv[2]);
  file << sm::Dump(result);
  file.close();
  return file ? 0 : 1;
}
