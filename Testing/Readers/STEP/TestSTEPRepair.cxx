// TestSTEPRepair SOLIDS VARIANT: what vtkSTEPReader takes from the file as it is has the properties that
// formulas give, also where the file has no trim curves; what has to be repaired is repaired, and said.
#include "smReaderTesting.h"
#include "smRoundTrip.h"
#include "smTestManifest.h"

#include <vtkNew.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <string>

namespace
{
using namespace smtest;

/// Reads as the file has it; `repaired` gets the message about repairs.
vtkSmartPointer<vtkPartitionedDataSetCollection> ReadAsItIs(const std::string& path, std::string& repaired)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetRepair(vtkSTEPReader::ON_NEED);
  reader->Update();
  repaired.clear();
  for (int i = 0; i < reader->GetNumberOfMessages(); ++i)
  {
    const std::string message = reader->GetMessage(i);
    repaired += message.find("repaired by OpenCASCADE") != std::string::npos ? message : "";
  }
  return reader->GetStatus() == vtkSTEPReader::OK ? reader->GetOutput() : nullptr;
}

void CheckSolid(const Expected& expected)
{
  const std::string name = expected.Solid + "-" + expected.Variant;
  std::string repaired;
  const auto data = ReadAsItIs(expected.Path, repaired);
  CheckTrue(name + ": read", data != nullptr);
  if (!data)
  {
    return;
  }
  CheckEqual(name + ": repaired", std::string(), repaired);
  const Properties p = Weigh(data, 1e-9);
  // Digits far from the origin cost more than the tolerance in some solids.
  CheckTrue(name + ": status",
    p.Status == "ok" || (expected.Variant == "far" && p.Status == "tolerance-not-met"), p.Status);
  CheckEqual(name + ": open edges", 0, p.OpenEdges);
  Check(name + ": volume", expected.Volume, p.Volume, p.Bounds[0] + expected.VolumeAccuracy + p.GapSquared,
    "bound, digits of the file, gaps");
  if (expected.Area == expected.Area)
  {
    Check(name + ": area", expected.Area, p.Area, p.Bounds[1] + expected.AreaAccuracy + 1e-7 * expected.Size,
      "bound, digits of the file, feet that are moved onto straight lines");
  }
  for (int c = 0; c < 3; ++c)
  {
    Check(name + ": centre", expected.Center[c], p.Center[c], p.Bounds[2] + expected.CenterAccuracy,
      "bound, digits of the file");
  }
  if (expected.Variant == "plain")
  {
    vtkNew<vtkSTEPReader> always;
    always->SetFileName(expected.Path.c_str());
    always->SetRepair(vtkSTEPReader::ALWAYS);
    always->Update();
    CheckEqual(name + ": faces as when all is repaired", CountFaces(always->GetOutput()), CountFaces(data));
  }
  CheckRange(name + ": bound / volume", 0.0, p.Bounds[0] / expected.Volume, 1e-9);
  if (repaired.empty() && expected.Variant == "nopcurves")
  {
    // OpenCASCADE's projections are 1e-7 to 1e-4 mm off.
    CheckRange(name + ": largest gap", 0.0, p.MaxGap / expected.Size, 1e-8);
  }
}
}

int TestSTEPRepair(int argc, char* argv[])
{
  if (argc < 3)
  {
    return 1;
  }
  const std::string variant = argv[2];
  for (const Expected& expected : Manifest(argv[1]).GetVariant(variant))
  {
    CheckSolid(expected);
  }
  return Finish();
}
