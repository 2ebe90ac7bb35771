/**
 * @file vtkCADReaderInternals.h
 * @brief Results of a vtkCADReader other than its output, and the data of a file that it keeps between runs
 */
#ifndef vtkCADReaderInternals_h
#define vtkCADReaderInternals_h

#include "smDrawingTolerances.h"
#include "smInstanceNames.h"
#include "smLeafMesh.h"
#include "vtkCADReader.h"

#include "vtkDataAssembly.h"

#include <algorithm>

struct vtkCADReader::Results
{
  std::vector<std::string> Messages;
  /// See sm::FileState.
  std::string Problem;
  std::vector<std::string> Defects;
  /// Tolerances of the drawing, in mm.
  std::vector<sm::DrawingTolerance> Tolerances;
  std::string FileUnit;
  std::string LengthUnit = "mm";
  int Bodies = 0;
  int Instances = 0;
  int FreeFaces = 0;
  double ReadSeconds = 0.0;
  /// Parts of ReadSeconds.
  double ParseSeconds = 0.0;
  double TrimSeconds = 0.0;
  double MeshSeconds = 0.0;
  double ConversionSeconds = 0.0;
};

/// The data from which outputs with and without display mesh are made.
struct vtkCADReader::Reading
{
  /// Progress at which all bodies are converted.
  static constexpr double MeshStart = 0.9;

  /// An entry for each partitioned dataset.
  std::vector<sm::LeafSource> Sources;
  /// Names in the file, which may repeat; the names of the blocks, and the paths, which do not
  /// (smInstanceNames.h).
  std::vector<std::string> Names;
  std::vector<std::string> BlockNames;
  std::vector<std::string> Paths;
  vtkSmartPointer<vtkDataAssembly> Assembly;
  /// Results without the messages about display meshes.
  Results Last;
  /// MTime of the newest model.
  vtkMTimeType ModelTime = 0;

  /// Sets BlockNames and Paths.
  void NameInstances()
  {
    this->BlockNames = sm::NumberNames(this->Names, {});
    this->Paths = sm::ListPaths(*this->Assembly, this->Names);
  }

  vtkMTimeType FindModelTime() const
  {
    vtkMTimeType time = 0;
    for (const sm::LeafSource& source : this->Sources)
    {
      time = std::max(time, source.Model->GetMTime());
    }
    return time;
  }
};

#endif
