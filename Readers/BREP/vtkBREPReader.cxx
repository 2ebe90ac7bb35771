#include "vtkBREPReader.h"

#include "smBREPFormat.h"
#include "smFile.h"
#include "smKernel.h"
#include "smLengthUnits.h"
#include "smShapeAdder.h"

#include "vtkObjectFactory.h"
#include "vtkSTEPReader.h"
#include "vtksys/SystemTools.hxx"

#include <utility>

namespace
{
/// Adds a node with the instances of its parts.
sm::ProductNode AddNode(const sm::ShapeNode& shape, sm::ShapeAdder& adder)
{
  sm::ProductNode node;
  adder.Add(shape.Shapes, sm::PartBody(), shape.Place, sm::Vector3{ -1.0, -1.0, -1.0 }, node);
  for (const sm::ShapeNode& child : shape.Children)
  {
    node.Children.push_back(AddNode(child, adder));
  }
  return node;
}

sm::ReadStatus FindStatus(const sm::BREPContent& content, const sm::Document& document)
{
  return content.IsStopped     ? sm::ReadStatus::Aborted
    : content.HasFailed        ? sm::ReadStatus::Failed
    : !content.Problem.empty() ? sm::ReadStatus::Unreadable
    : document.Bodies.empty()  ? sm::ReadStatus::Empty
                               : sm::ReadStatus::Ok;
}
}

vtkStandardNewMacro(vtkBREPReader);

vtkBREPReader::vtkBREPReader() = default;

vtkBREPReader::~vtkBREPReader() = default;

int vtkBREPReader::CanReadFile(const char* fileName)
{
  const std::string head = fileName ? sm::LoadHead(fileName) : std::string();
  if (!fileName || sm::LooksLikeBREP(head) || vtkSTEPReader::CanReadContent(head) != 0)
  {
    return sm::LooksLikeBREP(head) ? 1 : 0;
  }
  const std::string extension =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(fileName));
  return (extension == ".brep" || extension == ".brp") && vtksys::SystemTools::FileExists(fileName, true) ? 1
                                                                                                          : 0;
}

int vtkBREPReader::CanReadContent(const std::string& content)
{
  return sm::LooksLikeBREP(content) ? 1 : 0;
}

sm::Document vtkBREPReader::ReadDocument(std::string content, const sm::ProgressCallback& progress)
{
  sm::Document document;
  sm::BREPContent brep = sm::ReadBREPShapes(content, progress);
  sm::ShapeAdder adder(document);
  adder.Announce(brep.Shapes);
  document.Root = AddNode(brep.Root, adder);
  document.Defects = std::move(brep.Defects);
  document.Status = FindStatus(brep, document);
  document.Problem =
    document.Status == sm::ReadStatus::Empty ? "it has no solid, shell or face" : brep.Problem;
  document.FileUnit = this->InputUnit;
  document.FileUnitInMillimetres = document.UnitInMillimetres = sm::GetUnitInMillimetres(this->InputUnit);
  return document;
}

std::string vtkBREPReader::FindMistakeOfHead(const std::string& head) const
{
  return sm::LooksLikeBREP(head) ? std::string() : sm::NotBREP;
}

std::string vtkBREPReader::FindMistakeOfFormat() const
{
  return sm::GetShortUnit(sm::GetUnitInMillimetres(this->InputUnit)).empty()
    ? "InputUnit \"" + this->InputUnit + "\" is not known; use mm, cm, m, um, inch or ft"
    : std::string();
}

void vtkBREPReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InputUnit: " << this->InputUnit << "\n";
}
