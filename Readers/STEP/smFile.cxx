#include "smFile.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <limits>
#include <system_error>

namespace sm
{
namespace
{
const char Magic[] = "ISO-10303-21;";

/// Bytes at the start of a file in which its header is searched.
constexpr std::size_t SniffBytes = 1 << 16;

/// Returns true if a text consists of blanks and comments, which may precede the header.
bool IsBlank(std::string_view text)
{
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    if (text.compare(i, 2, "/*") == 0)
    {
      const std::size_t end = text.find("*/", i + 2);
      if (end == std::string_view::npos)
      {
        return false;
      }
      i = end + 1;
    }
    else if (!std::isspace(static_cast<unsigned char>(text[i])))
    {
      return false;
    }
  }
  return true;
}
}

bool LoadFile(
  const std::string& name, const std::function<bool()>& progress, std::string& bytes, std::string& problem)
{
  std::ifstream file(name, std::ios::binary);
  file.seekg(0, std::ios::end);
  const std::streamoff size = file ? static_cast<std::streamoff>(file.tellg()) : -1;
  // On some systems a folder can be opened, and its size is then a huge number.
  if (size < 0 || size == std::numeric_limits<std::streamoff>::max())
  {
    std::error_code error;
    problem = std::filesystem::is_directory(name, error)
      ? "it is a folder; name a file in it"
      : "it cannot be opened; check that it exists and may be read";
    return true;
  }
  constexpr std::streamoff PieceSize = std::streamoff{ 1 } << 26;
  bytes.resize(static_cast<std::size_t>(size));
  file.seekg(0);
  std::streamoff done = 0;
  while (done < size && file)
  {
    if (!progress())
    {
      return false;
    }
    file.read(bytes.data() + done, std::min(PieceSize, size - done));
    done += std::max<std::streamsize>(file.gcount(), 0);
  }
  // A file may become shorter while it is read.
  bytes.resize(static_cast<std::size_t>(done));
  problem = bytes.empty() ? "it is empty; export it again" : "";
  return true;
}

FileCheck CheckText(std::string_view text)
{
  FileCheck check;
  const std::string_view head = text.substr(0, SniffBytes);
  const std::size_t start = head.find(Magic);
  if (start == std::string_view::npos)
  {
    check.Problem = head.compare(0, 2, "PK") == 0 ? "it is a zip archive (.stpz?); unpack it first"
      : head.compare(0, 2, "\x1f\x8b") == 0       ? "it is compressed with gzip; unpack it first"
                                            : "it is not a STEP file: \"ISO-10303-21;\" is missing at its "
                                              "start; export it as STEP (AP203, AP214 or AP242)";
    return check;
  }
  check.Readable = true;
  check.JunkBytes = IsBlank(head.substr(0, start)) ? 0 : start;
  const std::string_view tail = text.substr(text.size() - std::min<std::size_t>(text.size(), 4096));
  check.Truncated = tail.find("END-ISO-10303-21") == std::string_view::npos;
  return check;
}

std::string LoadHead(const std::string& name)
{
  std::ifstream file(name, std::ios::binary);
  std::string bytes(SniffBytes, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

bool LooksLikeSTEP(const std::string& name)
{
  return LoadHead(name).find(Magic) != std::string::npos;
}
}
