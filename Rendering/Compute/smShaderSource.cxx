#include "smShaderSource.h"

#include "Detail/smShaderCheck.h"
#include "smErrorFree.h"
#include "smInvocation.h"
#include "smPortable.h"
#include "smShaderFault.h"
#include "smTrimText.h"

#include <iomanip>
#include <set>
#include <sstream>

namespace
{
const char* const TagStart = "//SM::";
const char* const DefineTag = "//SM::Define";
const char* const IncludeTag = "//SM::Include ";

/// Largest nesting of replacements; deeper nesting means that a replacement contains its own tag.
constexpr int MaximumDepth = 32;

bool StartsWith(const std::string& text, const std::string& start)
{
  return text.compare(0, start.size(), start) == 0;
}
}

namespace sm
{
struct ShaderSource::Assembly
{
  std::string Text;
  std::set<std::string> Included;
  std::set<std::string> Replaced;
  bool Defined = false;
};

ShaderSource::ShaderSource(const std::string& name, const char* text)
  : Name(name)
  , Text(text ? text : "")
  , Chunks({ { "smInvocation", smInvocation }, { "smErrorFree", smErrorFree }, { "smPortable", smPortable } })
{
}

void ShaderSource::AddChunk(const std::string& name, const char* text)
{
  this->Chunks[name] = text ? text : "";
}

void ShaderSource::Define(const std::string& name, const std::string& value)
{
  this->Definitions.emplace_back(name, value);
}

void ShaderSource::Define(const std::string& name, int value)
{
  this->Define(name, std::to_string(value));
}

void ShaderSource::Define(const std::string& name, unsigned int value)
{
  this->Define(name, std::to_string(value) + "u");
}

void ShaderSource::Replace(const std::string& tag, const std::string& text)
{
  this->Replacements[tag] = text;
}

bool ShaderSource::Assemble()
{
  this->Source.clear();
  this->Error.clear();
  Assembly assembly;
  assembly.Text = "#version 430 core\n";
  if (GetFaultyShaders().count(this->Name) > 0)
  {
    assembly.Text += "#define SM_FLOAT_ARRAYS\n";
  }
  if (!this->Append(assembly, this->Name, this->Text, 0))
  {
    return false;
  }
  if (!this->Definitions.empty() && !assembly.Defined)
  {
    this->Error = this->Name + ": has no line " + DefineTag + " for its definitions";
    return false;
  }
  for (const auto& replacement : this->Replacements)
  {
    if (assembly.Replaced.count(replacement.first) == 0)
    {
      this->Error = this->Name + ": has no line " + replacement.first + " to replace";
      return false;
    }
  }
  const std::string complaint = this->IsChecked ? FindUnsafeConstruct(assembly.Text) : "";
  if (!complaint.empty())
  {
    this->Error = this->Name + ": " + complaint;
    return false;
  }
  this->Source = std::move(assembly.Text);
  return true;
}

bool ShaderSource::Append(Assembly& assembly, const std::string& where, const std::string& text, int depth)
{
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number)
  {
    const std::string trimmed = Trim(line);
    const std::string place = where + ":" + std::to_string(number);
    if (StartsWith(trimmed, TagStart))
    {
      if (!this->AppendTag(assembly, place, trimmed, depth))
      {
        return false;
      }
      continue;
    }
    if (line.find(TagStart) != std::string::npos)
    {
      this->Error = place + ": a tag must be alone on its line: " + trimmed;
      return false;
    }
    if (StartsWith(trimmed, "#version"))
    {
      this->Error = place + ": #version is the assembler's, remove it";
      return false;
    }
    assembly.Text += line + "\n";
  }
  return true;
}

bool ShaderSource::AppendTag(Assembly& assembly, const std::string& where, const std::string& tag, int depth)
{
  if (depth >= MaximumDepth)
  {
    this->Error = where + ": the tag contains itself: " + tag;
    return false;
  }
  if (tag == DefineTag)
  {
    assembly.Defined = true;
    for (const auto& definition : this->Definitions)
    {
      assembly.Text += "#define " + definition.first + " " + definition.second + "\n";
    }
    return true;
  }
  if (StartsWith(tag, IncludeTag))
  {
    const std::string name = Trim(tag.substr(std::string(IncludeTag).size()));
    const auto chunk = this->Chunks.find(name);
    if (chunk == this->Chunks.end())
    {
      this->Error = where + ": unknown chunk " + name;
      return false;
    }
    if (!assembly.Included.insert(name).second)
    {
      return true;
    }
    assembly.Text += "// chunk " + name + "\n";
    return this->Append(assembly, name, chunk->second, depth + 1);
  }
  const auto replacement = this->Replacements.find(tag);
  if (replacement == this->Replacements.end())
  {
    this->Error = where + ": the tag was not replaced: " + tag;
    return false;
  }
  assembly.Replaced.insert(tag);
  return this->Append(assembly, tag, replacement->second, depth + 1);
}

std::set<std::string>& GetFaultyShaders()
{
  static std::set<std::string> shaders;
  return shaders;
}

double& GetSampleFactor()
{
  static double factor = 1.0;
  return factor;
}

std::string ShaderSource::NumberLines(const std::string& source)
{
  std::istringstream lines(source);
  std::ostringstream numbered;
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number)
  {
    numbered << std::setw(5) << number << " | " << line << "\n";
  }
  return numbered.str();
}
}
