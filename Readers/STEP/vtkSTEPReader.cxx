#include "vtkSTEPReader.h"

#include "smOCCTDocument.h"
#include "smOCCTFile.h"
#include "smOCCTMesh.h"
#include "smOCCTModel.h"
#include "smSTEPLeaf.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataAssembly.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNURBSDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTimerLog.h"
#include "vtkTrimmedNURBSModel.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <vector>

vtkStandardNewMacro(vtkSTEPReader);

namespace
{
/// Share of the progress that OpenCASCADE's reading takes.
constexpr double ReadingShare = 0.5;

/// Short name of a unit the reader can write.
int AddChild(vtkDataAssembly* assembly, int parent, const std::string& name, const std::string& fallback)
{
  std::string valid = name.empty() ? fallback : vtkDataAssembly::MakeValidNodeName(name.c_str());
  if (vtkDataAssembly::IsNodeNameReserved(valid.c_str()))
  {
    valid += "_";
  }
  const int node = assembly->AddNode(valid.c_str(), parent);
  assembly->SetAttribute(node, "label", name.empty() ? fallback.c_str() : name.c_str());
  return node;
}

void AddProduct(vtkDataAssembly* assembly, int parent, const sm::ProductNode& product)
{
  const int node = AddChild(assembly, parent, product.Name, "Part");
  if (!product.Layer.empty())
  {
    assembly->SetAttribute(node, "layer", product.Layer.c_str());
  }
  for (const int instance : product.Instances)
  {
    assembly->AddDataSetIndex(node, static_cast<unsigned int>(instance));
  }
  for (const sm::ProductNode& child : product.Children)
  {
    AddProduct(assembly, node, child);
  }
}

std::string GetStem(const std::string& path)
{
  const std::size_t slash = path.find_last_of("/\\");
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  const std::size_t dot = name.find_last_of('.');
  return dot == std::string::npos || dot == 0 ? name : name.substr(0, dot);
}
}

struct vtkSTEPReader::Results
{
  std::vector<std::string> Messages;
  std::string FileUnit;
  std::string LengthUnit = "mm";
  int Bodies = 0;
  int Instances = 0;
  int FreeFaces = 0;
  double ReadSeconds = 0.0;
  double MeshSeconds = 0.0;
  double ConversionSeconds = 0.0;
};

vtkSTEPReader::vtkSTEPReader()
  : Last(new Results)
{
  this->SetNumberOfInputPorts(0);
}

vtkSTEPReader::~vtkSTEPReader()
{
  this->SetFileName(nullptr);
}

int vtkSTEPReader::CanReadFile(const char* fileName)
{
  return fileName && sm::LooksLikeSTEP(fileName) ? 1 : 0;
}

const char* vtkSTEPReader::GetStatusAsString() const
{
  static const char* const words[] = { "ok", "empty", "unreadable", "aborted" };
  return words[this->Status];
}

std::string vtkSTEPReader::GetFileUnit() const
{
  return this->Last->FileUnit;
}

std::string vtkSTEPReader::GetLengthUnit() const
{
  return this->Last->LengthUnit;
}

int vtkSTEPReader::GetNumberOfMessages() const
{
  return static_cast<int>(this->Last->Messages.size());
}

std::string vtkSTEPReader::GetMessage(int index) const
{
  return index >= 0 && index < this->GetNumberOfMessages() ? this->Last->Messages[index] : std::string();
}

int vtkSTEPReader::GetNumberOfBodies() const
{
  return this->Last->Bodies;
}

int vtkSTEPReader::GetNumberOfInstances() const
{
  return this->Last->Instances;
}

int vtkSTEPReader::GetNumberOfFreeFaces() const
{
  return this->Last->FreeFaces;
}

double vtkSTEPReader::GetReadSeconds() const
{
  return this->Last->ReadSeconds;
}

double vtkSTEPReader::GetMeshSeconds() const
{
  return this->Last->MeshSeconds;
}

double vtkSTEPReader::GetConversionSeconds() const
{
  return this->Last->ConversionSeconds;
}

int vtkSTEPReader::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPartitionedDataSetCollection");
  return 1;
}

int vtkSTEPReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  // Pieces beyond the first are empty: every rank of a parallel run may ask.
  outputVector->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

void vtkSTEPReader::SetLinearDeflection(double deflection)
{
  const double value = deflection > 0.0 ? std::min(std::max(deflection, 1e-7), 1e30) : 0.001;
  if (value != this->LinearDeflection)
  {
    this->LinearDeflection = value;
    this->Modified();
  }
}

void vtkSTEPReader::SetAngularDeflection(double angle)
{
  const double value = std::isnan(angle) ? 0.35 : std::min(std::max(angle, 0.01), 3.0);
  if (value != this->AngularDeflection)
  {
    this->AngularDeflection = value;
    this->Modified();
  }
}

bool vtkSTEPReader::Report(double fraction)
{
  this->UpdateProgress(fraction);
  return !this->GetAbortExecute();
}

int vtkSTEPReader::Fail(int status, const std::string& problem)
{
  const std::string sentence =
    std::string("Cannot read ") + (this->FileName ? this->FileName : "a STEP file") + ": " + problem + ".";
  this->Status = status;
  this->Last->Messages.push_back(sentence);
  vtkErrorMacro(<< sentence);
  // Other ranks, with their empty pieces, do not fail: what is downstream must run on all or on none.
  vtkInformation* info = this->GetOutputInformation(0);
  return info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()) > 1 ? 1 : 0;
}

int vtkSTEPReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  auto* output = vtkPartitionedDataSetCollection::SafeDownCast(info->Get(vtkDataObject::DATA_OBJECT()));
  *this->Last = Results();
  this->Status = EMPTY;
  if (info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    this->Status = OK;
    return 1;
  }
  if (!this->FileName || !*this->FileName)
  {
    return this->Fail(UNREADABLE, "no file name was given; call SetFileName first");
  }
  const bool fileUnit = this->OutputUnit == "file";
  double millimetres = fileUnit ? 1.0 : sm::GetUnitInMillimetres(this->OutputUnit);
  if (!fileUnit && sm::GetShortUnit(millimetres).empty())
  {
    return this->Fail(UNREADABLE,
      "OutputUnit \"" + this->OutputUnit + "\" is not known; use mm, cm, m, um, inch, ft or file");
  }

  if (sm::KernelSession::IsHeldHere())
  {
    return this->Fail(UNREADABLE,
      "another file is being read on this thread, and OpenCASCADE reads one at a time; do not update a "
      "reader "
      "inside an observer of another one's progress");
  }
  const sm::KernelSession kernel;
  const double start = vtkTimerLog::GetUniversalTime();
  sm::Document document =
    sm::ReadDocument(this->FileName, [this](double x) { return this->Report(ReadingShare * x); });
  this->Last->ReadSeconds = vtkTimerLog::GetUniversalTime() - start;
  this->Last->Messages = document.Messages;
  this->Last->FileUnit = document.FileUnit;
  if (document.Status == sm::ReadStatus::Aborted)
  {
    this->Status = ABORTED;
    return 1;
  }
  if (document.Status != sm::ReadStatus::Ok)
  {
    return this->Fail(document.Status == sm::ReadStatus::Empty ? EMPTY : UNREADABLE, document.Problem);
  }
  if (fileUnit)
  {
    millimetres = document.FileUnitInMillimetres;
    if (sm::GetShortUnit(millimetres).empty())
    {
      this->Last->Messages.push_back(
        "The file's length unit (" + document.FileUnit + ") has no name here; lengths are in mm.");
      millimetres = 1.0;
    }
  }
  this->Last->LengthUnit = sm::GetShortUnit(millimetres);
  this->Last->FreeFaces = document.FreeFaces;

  sm::LeafOptions options;
  options.Unit = 1.0 / millimetres;
  options.UnitName = this->Last->LengthUnit;
  options.FileUnitName = document.FileUnit.empty() ? "" : sm::GetShortUnit(document.FileUnitInMillimetres);
  options.LinearDeflection = this->LinearDeflection;
  options.RelativeDeflection = this->RelativeDeflection;
  options.AngularDeflection = this->AngularDeflection;

  std::vector<std::unique_ptr<sm::LeafMaker>> makers;
  for (std::size_t i = 0; i < document.Bodies.size(); ++i)
  {
    const auto report = [this, i, &document](double x)
    { return this->Report(ReadingShare + (1.0 - ReadingShare) * (i + x) / document.Bodies.size()); };
    bool aborted = !report(0.0);
    if (!aborted)
    {
      makers.emplace_back(new sm::LeafMaker(document.Bodies[i], document.Table, options, report));
      aborted = makers.back()->IsAborted();
    }
    if (aborted)
    {
      this->Status = ABORTED;
      return 1;
    }
    this->Last->MeshSeconds += makers.back()->GetMeshSeconds();
    this->Last->ConversionSeconds += makers.back()->GetConversionSeconds();
    for (const std::string& message : makers.back()->GetMessages())
    {
      this->Last->Messages.push_back(message);
    }
  }

  const double assembling = vtkTimerLog::GetUniversalTime();
  output->SetNumberOfPartitionedDataSets(static_cast<unsigned int>(document.Instances.size()));
  for (unsigned int i = 0; i < document.Instances.size(); ++i)
  {
    const sm::BodyInstance& instance = document.Instances[i];
    output->SetPartition(i, 0, makers[instance.Body]->MakeLeaf(instance));
    output->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), instance.Name.c_str());
  }
  vtkNew<vtkDataAssembly> assembly;
  const std::string stem = GetStem(this->FileName);
  assembly->SetRootNodeName("STEP");
  assembly->SetAttribute(vtkDataAssembly::GetRootNode(), "label", stem.c_str());
  for (const sm::ProductNode& product : document.Root.Children)
  {
    AddProduct(assembly, vtkDataAssembly::GetRootNode(), product);
  }
  output->SetDataAssembly(assembly);
  this->Last->Bodies = static_cast<int>(document.Bodies.size());
  this->Last->Instances = static_cast<int>(document.Instances.size());
  this->Last->ConversionSeconds += vtkTimerLog::GetUniversalTime() - assembling;
  this->Status = OK;
  this->UpdateProgress(1.0);
  return 1;
}

void vtkSTEPReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n"
     << indent << "LinearDeflection: " << this->LinearDeflection
     << (this->RelativeDeflection ? " relative\n" : "\n") << indent
     << "AngularDeflection: " << this->AngularDeflection << "\n"
     << indent << "OutputUnit: " << this->OutputUnit << "\n"
     << indent << "Status: " << this->GetStatusAsString() << "\n";
}
