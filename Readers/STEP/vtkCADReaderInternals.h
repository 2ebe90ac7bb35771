/**
 * @file vtkCADReaderInternals.h
 * @brief The results of a vtkCADReader beside its output
 */
#ifndef vtkCADReaderInternals_h
#define vtkCADReaderInternals_h

#include "vtkCADReader.h"

struct vtkCADReader::Results
{
  std::vector<std::string> Messages;
  /// As sm::FileState.
  std::string Problem;
  std::vector<std::string> Defects;
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

#endif
