#include "smMessageCollector.h"

#include "smText.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(smMessageCollector);

namespace
{
/// Returns the part `text` of VTK's "ERROR: In file.cxx, line 12\nvtkFoo (0x55d0): text\n\n".
std::string Sentence(const char* raw)
{
  std::string text = raw ? raw : "";
  if (text.rfind("ERROR: In ", 0) == 0 || text.rfind("Warning: In ", 0) == 0 ||
    text.rfind("Generic Warning: In ", 0) == 0)
  {
    const size_t line = text.find('\n');
    text = line == std::string::npos ? std::string() : text.substr(line + 1);
  }
  const size_t address = text.find(" (0x");
  const size_t colon = text.find("): ");
  if (text.rfind("vtk", 0) == 0 && address < colon && colon != std::string::npos)
  {
    text.erase(0, colon + 3);
  }
  text = sm::TrimEnd(text);
  // The executive repeats every error of an algorithm.
  return text.rfind("Algorithm vtk", 0) == 0 ? std::string() : text;
}
}

void smMessageCollector::DisplayText(const char* text)
{
  const std::string sentence = Sentence(text);
  if (!sentence.empty() &&
    std::find(this->Messages.begin(), this->Messages.end(), sentence) == this->Messages.end())
  {
    this->Messages.push_back(sentence);
  }
}

void smMessageCollector::DisplayErrorText(const char* text)
{
  this->DisplayText(text);
}

void smMessageCollector::DisplayWarningText(const char* text)
{
  this->DisplayText(text);
}

void smMessageCollector::DisplayGenericWarningText(const char* text)
{
  this->DisplayText(text);
}
