#include "smFileReader.h"

#include "smFileJob.h"
#include "smMeshOrigin.h"

#include "vtkBREPReader.h"
#include "vtkSTEPReader.h"

namespace sm
{
vtkSmartPointer<vtkCADReader> MakeReader(const std::string& path)
{
  if (vtkBREPReader::CanReadFile(path.c_str()) != 0)
  {
    return vtkSmartPointer<vtkBREPReader>::New();
  }
  return vtkSmartPointer<vtkSTEPReader>::New();
}

void SetUpReader(vtkCADReader* reader, const std::string& path, const JobOptions& options)
{
  reader->SetFileName(path.c_str());
  reader->SetOutputUnit(options.Unit);
  if (auto* step = vtkSTEPReader::SafeDownCast(reader))
  {
    std::string folders;
    for (const std::string& folder : options.SearchFolders)
    {
      folders += (folders.empty() ? "" : ":") + folder;
    }
    step->SetSearchFolders(folders.c_str());
    step->SetHidden(options.Hidden == "skip" ? vtkSTEPReader::SKIP_HIDDEN
        : options.Hidden == "only"           ? vtkSTEPReader::ONLY_HIDDEN
                                             : vtkSTEPReader::COUNT_HIDDEN);
    step->SetRepair(options.Repair == "needed" ? vtkSTEPReader::ON_NEED
        : options.Repair == "never"            ? vtkSTEPReader::NEVER
                                               : vtkSTEPReader::ALWAYS);
  }
  if (auto* brep = vtkBREPReader::SafeDownCast(reader))
  {
    brep->SetInputUnit(options.InputUnit);
  }
  if (options.Deflection > 0.0)
  {
    reader->RelativeDeflectionOff();
    // What rounding to single precision may add is left free, see FindMeshOrigin().
    reader->SetLinearDeflection(
      options.Deflection * (HasSinglePoints(options.MeshName) ? 1.0 - SinglePrecisionShare : 1.0));
  }
}
}
