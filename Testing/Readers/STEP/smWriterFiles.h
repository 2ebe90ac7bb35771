/**
 * @file smWriterFiles.h
 * @brief Folders and contents of the files that the writers' tests write
 */
#ifndef smWriterFiles_h
#define smWriterFiles_h

#include "smReaderTesting.h"
#include "smRoundTrip.h"

#include <filesystem>
#include <string>

namespace smtest
{
inline std::string MakeFolder(const std::string& parent, const std::string& name)
{
  const std::filesystem::path folder = std::filesystem::path(parent) / name;
  std::filesystem::create_directories(folder);
  return folder.string();
}

/// Folder of the files that the writers write.
inline std::string Output;

/// Writes the data to a STEP file of this name in the folder, and reads it.
inline vtkSmartPointer<vtkPartitionedDataSetCollection> Save(
  const std::string& name, vtkDataObject* data, std::string* messages = nullptr)
{
  return SaveAndRead(Output + "/" + name + ".step", data, messages);
}
}

#endif
