/**
 * @file smWriterFiles.h
 * @brief Folders and contents of the files that the writers' tests write
 */
#ifndef smWriterFiles_h
#define smWriterFiles_h

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace smtest
{
inline std::string MakeFolder(const std::string& parent, const std::string& name)
{
  const std::filesystem::path folder = std::filesystem::path(parent) / name;
  std::filesystem::create_directories(folder);
  return folder.string();
}

inline std::string ReadAll(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}
}

#endif
