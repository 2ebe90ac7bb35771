#include "smOutputFiles.h"

#include "smSafeFile.h"

#include "vtkBREPReader.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sys/stat.h>
#include <unistd.h>

namespace
{
namespace fs = std::filesystem;

/// Returns the keys of a file: device and inode if it exists, and its path without links. Two names of one
/// file share a key.
std::set<std::string> Identities(const std::string& name)
{
  std::set<std::string> identities;
  struct stat info = {};
  if (stat(name.c_str(), &info) == 0)
  {
    if (S_ISCHR(info.st_mode))
    {
      return identities; // any number of outputs may be written to /dev/null
    }
    identities.insert(std::to_string(info.st_dev) + ":" + std::to_string(info.st_ino));
  }
  std::error_code error;
  fs::path path = fs::absolute(name, error);
  // A link to a file that does not exist yet is a name of that file.
  for (int i = 0; i < 8 && fs::is_symlink(fs::symlink_status(path, error)); ++i)
  {
    path = path.parent_path() / fs::read_symlink(path, error);
  }
  identities.insert(fs::weakly_canonical(path, error).string());
  return identities;
}

/// Appends -2, -3, ... to the second, third, ... of equal names; names that differ in the case of letters
/// only are one file on some file systems, and count as equal.
std::vector<std::string> MakeDistinct(std::vector<std::string> names)
{
  std::set<std::string> taken;
  std::map<std::string, int> seen;
  for (std::string& name : names)
  {
    const std::string plain = name;
    int& count = seen[sm::LowerCase(plain)];
    do
    {
      ++count;
      name = plain + (count > 1 ? "-" + std::to_string(count) : "");
    } while (!taken.insert(sm::LowerCase(name)).second);
  }
  return names;
}

std::vector<std::string> ListInputs(const sm::Arguments& arguments)
{
  std::vector<std::string> inputs = arguments.Files;
  for (const std::string& table : { arguments.Materials, arguments.Joints })
  {
    if (!table.empty())
    {
      inputs.push_back(table);
    }
  }
  for (const std::shared_ptr<sm::Analysis>& analysis : arguments.Job.Analyses)
  {
    if (!analysis->GetInputFile().empty())
    {
      inputs.push_back(analysis->GetInputFile());
    }
  }
  return inputs;
}

/// Returns options and names of outputs; a name may be empty, or - for the standard output.
std::vector<std::pair<std::string, std::string>> ListOutputs(const sm::Arguments& arguments)
{
  std::vector<std::pair<std::string, std::string>> outputs = { { "--json", arguments.Json },
    { "--csv", arguments.Csv }, { "--bom-csv", arguments.PartsCsv } };
  for (const auto& [option, given] : { std::make_pair("--mesh", arguments.Mesh),
         std::make_pair("--png", arguments.Picture), std::make_pair("--robot", arguments.RobotName) })
  {
    // Two products that are compared share one picture.
    const bool isOne = arguments.Compare && given == arguments.Picture;
    for (const std::string& name :
      isOne ? std::vector<std::string>{ given } : sm::OutputNames(arguments.Files, given))
    {
      outputs.emplace_back(option, name);
    }
  }
  outputs.emplace_back("--write-validation", arguments.Job.ValidationTarget);
  for (const std::shared_ptr<sm::Analysis>& analysis : arguments.Job.Analyses)
  {
    outputs.emplace_back(analysis->GetOption(), analysis->GetOutputFile());
  }
  return outputs;
}
}

namespace sm
{
std::vector<std::string> OutputNames(const std::vector<std::string>& files, const std::string& name)
{
  std::vector<std::string> names(files.size(), name);
  if (name.empty() || names.size() == 1)
  {
    return names;
  }
  const size_t dot = name.find_last_of('.');
  std::vector<std::string> plain;
  for (const std::string& file : files)
  {
    plain.push_back(name.substr(0, dot) + "-" + GetStem(file));
  }
  plain = MakeDistinct(plain);
  std::transform(plain.begin(), plain.end(), names.begin(),
    [&](const std::string& stem) { return stem + name.substr(dot); });
  return names;
}

std::vector<std::string> TexturePrefixes(const Arguments& arguments)
{
  std::vector<std::string> prefixes(arguments.Files.size());
  const std::string& folder = arguments.Job.Scheme.GetTextureFolder();
  if (!folder.empty())
  {
    std::transform(arguments.Files.begin(), arguments.Files.end(), prefixes.begin(),
      [&](const std::string& file) { return folder + "/" + GetStem(file); });
    prefixes = MakeDistinct(prefixes);
  }
  return prefixes;
}

bool IsModelFile(const std::string& name)
{
  struct stat info = {};
  if (stat(name.c_str(), &info) != 0 || !S_ISREG(info.st_mode))
  {
    return false;
  }
  const std::string extension = LowerCase(fs::path(name).extension().string());
  if (extension == ".step" || extension == ".stp" || extension == ".p21" || extension == ".brep" ||
    extension == ".brp")
  {
    return true;
  }
  std::ifstream file(name, std::ios::binary);
  std::string head(64, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  const size_t begin = head.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return begin != std::string::npos &&
    (head.compare(begin, 12, "ISO-10303-21") == 0 || vtkBREPReader::CanReadContent(head) != 0);
}

std::string MakeTextureFolder(const Arguments& arguments)
{
  const std::string& folder = arguments.Job.Scheme.GetTextureFolder();
  if (folder.empty())
  {
    return {};
  }
  std::error_code error;
  fs::create_directories(folder, error);
  return fs::is_directory(folder, error) && access(folder.c_str(), W_OK) == 0
    ? std::string()
    : "--trim-textures: the folder " + folder + " cannot be made or written";
}

bool IsSameFile(const std::string& a, const std::string& b)
{
  const std::set<std::string> known = Identities(a);
  const std::set<std::string> other = Identities(b);
  return std::any_of(
    other.begin(), other.end(), [&known](const std::string& identity) { return known.count(identity) > 0; });
}

std::vector<std::string> ListFiles(const Arguments& arguments)
{
  std::vector<std::string> names = ListInputs(arguments);
  for (const auto& [option, name] : ListOutputs(arguments))
  {
    names.push_back(name);
  }
  const auto isNone = [](const std::string& name) { return name.empty() || name == "-"; };
  names.erase(std::remove_if(names.begin(), names.end(), isNone), names.end());
  return names;
}

std::string CheckOutputs(const Arguments& arguments)
{
  std::map<std::string, std::string> taken;
  for (const std::string& file : ListInputs(arguments))
  {
    for (const std::string& identity : Identities(file))
    {
      taken.emplace(identity, "the input " + file);
    }
  }
  for (const auto& [option, name] : ListOutputs(arguments))
  {
    if (name.empty() || name == "-")
    {
      continue;
    }
    const std::set<std::string> identities = Identities(name);
    for (const std::string& identity : identities)
    {
      const auto found = taken.find(identity);
      if (found != taken.end())
      {
        return option + " would overwrite " + name + ", which is " + found->second;
      }
    }
    // Only the output of --write-validation may replace a STEP file.
    if (IsModelFile(name) && option != "--write-validation")
    {
      return option + " would overwrite " + name + ", which is a CAD file; name another file";
    }
    const std::string problem = FindSaveProblem(name);
    if (!problem.empty())
    {
      return name + " cannot be written: " + problem;
    }
    for (const std::string& identity : identities)
    {
      taken.emplace(identity, "the output of " + option);
    }
  }
  return {};
}
}
