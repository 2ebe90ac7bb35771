/**
 * @file smFileReader.h
 * @brief Makes the reader for a file's format, with the settings of the options
 */
#ifndef smFileReader_h
#define smFileReader_h

#include "vtkSmartPointer.h"

#include <string>

class vtkCADReader;

namespace sm
{
struct JobOptions;

/// Returns the reader for the format that the file's first bytes show; one of STEP files if they show none.
vtkSmartPointer<vtkCADReader> MakeReader(const std::string& path);

/// Sets the reader's file and the settings of the options.
void SetUpReader(vtkCADReader* reader, const std::string& path, const JobOptions& options);
}

#endif
