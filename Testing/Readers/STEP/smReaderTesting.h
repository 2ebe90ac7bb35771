/**
 * @file smReaderTesting.h
 * @brief An assembly in a STEP file, files derived from it, and the errors of a reader, for the tests of
 * vtkSTEPReader
 */
#ifndef smReaderTesting_h
#define smReaderTesting_h

#include "smTesting.h"

#include "vtkNURBSDataSet.h"
#include "vtkSTEPReader.h"

#include <string>

namespace smtest
{
/// Folder of the files that a test writes.
inline std::string Folder;

/// Counts error events and keeps the last text.
struct ErrorLog
{
  int Count = 0;
  std::string Text;

  void Watch(vtkObject* object);
};

std::string ReadAll(const std::string& path);

/// Writes a file of this name into the folder and returns its path.
std::string Make(const std::string& name, const std::string& content);

/// Writes an assembly: two instances of a bored plate with a red face, a blue sphere of steel, and a loose
/// face.
void WriteAssembly(const std::string& path, bool solids = true);

vtkNURBSDataSet* GetLeaf(vtkSTEPReader* reader, unsigned int index);
}

#endif
