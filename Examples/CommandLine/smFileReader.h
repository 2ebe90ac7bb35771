/**
 * @file smFileReader.h
 * @brief The reader of a file's format, with what the options say about reading
 */
#ifndef smFileReader_h
#define smFileReader_h

#include "vtkSmartPointer.h"

#include <string>

class vtkCADReader;

namespace sm
{
struct JobOptions;

/// The reader that fits the file's first bytes; one of STEP files where none does.
vtkSmartPointer<vtkCADReader> MakeReader(const std::string& path);

/// Sets the reader's file and what the options say about reading.
void SetUpReader(vtkCADReader* reader, const std::string& path, const JobOptions& options);
}

#endif
