#include "smInputFile.h"

#include "smText.h"

#include "vtk_zlib.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <system_error>
#include <vector>

namespace sm
{
namespace
{
namespace fs = std::filesystem;

constexpr std::uint64_t MaxBytes = std::uint64_t(4) << 30;
constexpr size_t BufferSize = 1 << 16;
const char* const TooLarge = "it has more than 4 GB";

std::string GetTemporaryFolder()
{
  const char* const given = std::getenv("TMPDIR");
  return given && *given ? given : "/tmp";
}

/// Returns why the content cannot be kept in the folder for temporary files, and what to do.
std::string DescribeNoSpace(const std::string& problem)
{
  return "its content cannot be kept in the folder for temporary files, " + GetTemporaryFolder() + " (" +
    problem + "); set TMPDIR to a folder with room for it";
}

std::string DescribeNoSpace()
{
  return DescribeNoSpace(errno == 0 ? "it is full" : std::generic_category().message(errno));
}

bool IsSTEPName(const std::string& name)
{
  const std::string extension = LowerCase(fs::path(name).extension().string());
  return extension == ".step" || extension == ".stp" || extension == ".p21";
}

bool IsCADName(const std::string& name)
{
  const std::string extension = LowerCase(fs::path(name).extension().string());
  return IsSTEPName(name) || extension == ".brep" || extension == ".brp";
}

std::uint32_t ReadNumber(const std::string& bytes, size_t at, size_t count)
{
  std::uint32_t value = 0;
  for (size_t i = 0; i < count && at + i < bytes.size(); ++i)
  {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  }
  return value;
}

/// Writes the inflated stream. `windowBits` is that of zlib: 31 for gzip, -15 for a raw stream. Returns an
/// error message; empty if the stream is complete. Several concatenated gzip streams are one file.
std::string InflateTo(std::istream& input, std::ostream& output, int windowBits)
{
  z_stream stream = {};
  if (inflateInit2(&stream, windowBits) != Z_OK)
  {
    return "zlib cannot be started";
  }
  std::vector<char> in(BufferSize);
  std::vector<char> out(BufferSize);
  std::uint64_t written = 0;
  std::string error;
  errno = 0;
  int status = Z_OK;
  bool isWhole = false;
  while (error.empty())
  {
    if (stream.avail_in == 0)
    {
      input.read(in.data(), static_cast<std::streamsize>(in.size()));
      stream.next_in = reinterpret_cast<Bytef*>(in.data());
      stream.avail_in = static_cast<uInt>(input.gcount());
    }
    if (stream.avail_in == 0)
    {
      error = isWhole ? std::string() : "it ends in the middle";
      break;
    }
    if (isWhole && inflateReset(&stream) != Z_OK)
    {
      break;
    }
    isWhole = false;
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    status = inflate(&stream, Z_NO_FLUSH);
    const size_t count = out.size() - stream.avail_out;
    written += count;
    output.write(out.data(), static_cast<std::streamsize>(count));
    error = status != Z_OK && status != Z_STREAM_END ? "its compressed data are damaged"
      : written > MaxBytes                           ? TooLarge
      : !output                                      ? DescribeNoSpace()
                                                     : "";
    isWhole = status == Z_STREAM_END;
    if (isWhole && windowBits < 0)
    {
      break;
    }
  }
  inflateEnd(&stream);
  return error;
}
}

InputFile::InputFile(const std::string& name)
  : Path(name)
{
  if (name == "-")
  {
    this->CopyStandardInput();
    return;
  }
  std::error_code error;
  if (!fs::is_regular_file(name, error))
  {
    return;
  }
  std::ifstream file(name, std::ios::binary);
  std::string head(4, '\0');
  file.read(head.data(), 4);
  if (head.compare(0, 2, "\x1f\x8b") == 0)
  {
    this->Inflate(name);
  }
  else if (head == "PK\x03\x04")
  {
    this->Extract(name);
  }
}

InputFile::~InputFile()
{
  if (!this->Folder.empty())
  {
    std::error_code error;
    fs::remove_all(this->Folder, error);
  }
}

bool InputFile::MakeFolder(const std::string& name)
{
  std::string folder = GetTemporaryFolder() + "/solidmoments-XXXXXX";
  if (!mkdtemp(folder.data()))
  {
    this->Error = DescribeNoSpace();
    return false;
  }
  this->Folder = folder;
  // The stem of "bracket.step.gz" is bracket.step.
  const std::string stem = GetStem(name);
  this->Path = folder + "/" + (IsCADName(stem) ? stem : stem + ".step");
  return true;
}

void InputFile::CopyStandardInput()
{
  if (!this->MakeFolder("standard-input"))
  {
    return;
  }
  std::ofstream copy(this->Path, std::ios::binary);
  std::vector<char> buffer(BufferSize);
  std::uint64_t written = 0;
  errno = 0;
  while (copy && written <= MaxBytes &&
    (std::cin.read(buffer.data(), static_cast<std::streamsize>(buffer.size())), std::cin.gcount() > 0))
  {
    copy.write(buffer.data(), std::cin.gcount());
    written += static_cast<std::uint64_t>(std::cin.gcount());
  }
  copy.close();
  this->Error = written > MaxBytes ? TooLarge
    : !copy                        ? DescribeNoSpace()
    : written == 0                 ? "it is empty; write a STEP or BREP file to the standard input"
                                   : "";
  if (!this->Error.empty())
  {
    return;
  }
  // The file in the archive may be compressed itself.
  InputFile inner(this->Path);
  if (!inner.GetError().empty() || inner.GetPath() == this->Path)
  {
    this->Error = inner.GetError();
    return;
  }
  std::error_code error;
  fs::copy_file(inner.GetPath(), this->Path, fs::copy_options::overwrite_existing, error);
  this->Error = error ? DescribeNoSpace(error.message()) : "";
}

void InputFile::Inflate(const std::string& name)
{
  if (!this->MakeFolder(name))
  {
    return;
  }
  std::ifstream file(name, std::ios::binary);
  std::ofstream copy(this->Path, std::ios::binary);
  this->Error = InflateTo(file, copy, 31);
  copy.close();
  this->Error = this->Error.empty() && !copy ? DescribeNoSpace() : this->Error;
}

void InputFile::Extract(const std::string& name)
{
  std::ifstream file(name, std::ios::binary);
  const std::string bytes = [&file]()
  {
    // The directory of a ZIP archive is at the end of the file: its last record begins within the last 64 kB.
    file.seekg(0, std::ios::end);
    const std::streamoff size = file.tellg();
    const std::streamoff count = std::min<std::streamoff>(size, 65557);
    std::string tail(static_cast<size_t>(count), '\0');
    file.seekg(size - count);
    file.read(tail.data(), count);
    return tail;
  }();
  const size_t end = bytes.rfind("PK\x05\x06");
  this->Error = "the ZIP archive is damaged";
  if (end == std::string::npos || end + 22 > bytes.size())
  {
    return;
  }
  const std::uint32_t size = ReadNumber(bytes, end + 12, 4);
  std::string directory(std::min<size_t>(size, 1 << 26), '\0');
  file.clear();
  file.seekg(ReadNumber(bytes, end + 16, 4));
  file.read(directory.data(), static_cast<std::streamsize>(directory.size()));
  std::vector<size_t> found; ///< STEP files before BREP files
  size_t stepFiles = 0;
  for (size_t at = 0; at + 46 <= directory.size() && directory.compare(at, 4, "PK\x01\x02") == 0;)
  {
    const size_t length = ReadNumber(directory, at + 28, 2);
    const std::string member = directory.substr(at + 46, length);
    if (IsSTEPName(member))
    {
      found.insert(found.begin() + static_cast<std::ptrdiff_t>(stepFiles++), at);
    }
    else if (IsCADName(member))
    {
      found.push_back(at);
    }
    at += 46 + length + ReadNumber(directory, at + 30, 2) + ReadNumber(directory, at + 32, 2);
  }
  if (found.empty() || (stepFiles != 1 && found.size() != 1))
  {
    this->Error =
      "the ZIP archive has " + std::to_string(found.size()) + " STEP or BREP files; it must have one";
    return;
  }
  const size_t at = found.front();
  const std::uint32_t method = ReadNumber(directory, at + 10, 2);
  const bool isEncrypted = (ReadNumber(directory, at + 8, 2) & 1) != 0;
  const std::uint32_t stored = ReadNumber(directory, at + 20, 4);
  std::string header(30, '\0');
  file.clear();
  file.seekg(ReadNumber(directory, at + 42, 4));
  file.read(header.data(), 30);
  if (!file || header.compare(0, 4, "PK\x03\x04") != 0 ||
    !this->MakeFolder(GetFileName(directory.substr(at + 46, ReadNumber(directory, at + 28, 2)))))
  {
    return;
  }
  file.seekg(ReadNumber(header, 26, 2) + ReadNumber(header, 28, 2), std::ios::cur);
  std::ofstream copy(this->Path, std::ios::binary);
  if (isEncrypted || (method != 0 && method != 8))
  {
    this->Error = isEncrypted ? "the ZIP archive is encrypted"
                              : "the ZIP archive is compressed in a way that is not known";
  }
  else if (method == 8)
  {
    this->Error = InflateTo(file, copy, -15);
  }
  else
  {
    std::vector<char> buffer(BufferSize);
    std::uint32_t left = stored;
    while (left > 0 && file.read(buffer.data(), std::min<std::streamsize>(left, BufferSize)).gcount() > 0)
    {
      copy.write(buffer.data(), file.gcount());
      left -= static_cast<std::uint32_t>(file.gcount());
    }
    this->Error = left == 0 ? "" : "it ends in the middle";
  }
  copy.close();
  this->Error = this->Error.empty() && !copy ? DescribeNoSpace() : this->Error;
}

std::optional<std::string> ReadTextFile(const std::string& name)
{
  std::error_code error;
  std::ifstream file(name, std::ios::binary);
  if (!file.is_open() || fs::is_directory(name, error))
  {
    return {};
  }
  std::string text{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  if (file.bad())
  {
    return {};
  }
  const std::string mark = "\xEF\xBB\xBF";
  return text.compare(0, mark.size(), mark) == 0 ? text.substr(mark.size()) : text;
}

std::vector<std::string> ExpandFolders(const std::vector<std::string>& names)
{
  std::vector<std::string> result;
  for (const std::string& name : names)
  {
    std::vector<std::string> inside;
    std::error_code error;
    for (fs::directory_iterator it(name, error), end; !error && it != end; it.increment(error))
    {
      const std::string file = it->path().string();
      const std::string extension = LowerCase(it->path().extension().string());
      if (it->is_regular_file(error) &&
        (IsCADName(file) || extension == ".stpz" || (extension == ".gz" && IsCADName(GetStem(file)))))
      {
        inside.push_back(file);
      }
    }
    std::sort(inside.begin(), inside.end());
    if (inside.empty())
    {
      inside.push_back(name);
    }
    result.insert(result.end(), inside.begin(), inside.end());
  }
  return result;
}
}
