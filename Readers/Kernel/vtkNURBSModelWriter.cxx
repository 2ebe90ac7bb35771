#include "vtkNURBSModelWriter.h"

#include "smAbortFlag.h"
#include "smCatchFailure.h"
#include "smExport.h"
#include "smFileState.h"
#include "smLengthUnits.h"
#include "smSafeFile.h"

#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

struct vtkNURBSModelWriter::Results
{
  std::vector<std::string> Messages;
  int Faces = 0;
  /// True if the input was computed.
  bool HadInput = false;
};

vtkNURBSModelWriter::vtkNURBSModelWriter()
  : Last(new Results)
{
  sm::ClearAbortAtStart(this);
}

vtkNURBSModelWriter::~vtkNURBSModelWriter()
{
  this->SetFileName(nullptr);
}

int vtkNURBSModelWriter::GetNumberOfMessages() const
{
  return static_cast<int>(this->Last->Messages.size());
}

std::string vtkNURBSModelWriter::GetMessage(int index) const
{
  return index >= 0 && index < this->GetNumberOfMessages() ? this->Last->Messages[index] : std::string();
}

int vtkNURBSModelWriter::GetNumberOfFaces() const
{
  return this->Last->Faces;
}

int vtkNURBSModelWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

void vtkNURBSModelWriter::Fail(unsigned long code, const std::string& problem)
{
  const std::string sentence = std::string("Cannot save ") +
    (this->FileName && *this->FileName ? this->FileName : "the solids") + ": " + problem + ".";
  this->Last->Messages.push_back(sentence);
  this->SetErrorCode(code);
  vtkErrorMacro(<< sentence);
}

int vtkNURBSModelWriter::Write()
{
  *this->Last = Results();
  if (this->GetNumberOfInputConnections(0) < 1)
  {
    this->Fail(vtkErrorCode::UserError, "there is no input; call SetInputConnection or SetInputData first");
    return 0;
  }
  // Checked before the update, so that all ranks of a parallel run fail, not only the one that writes.
  if (!this->FileName || !*this->FileName)
  {
    this->Fail(vtkErrorCode::NoFileNameError, "no file name was given; call SetFileName first");
    return 0;
  }
  // An executive that fails before it requests data does not reset the error code of the previous run.
  this->SetErrorCode(vtkErrorCode::NoError);
  const int written = this->Superclass::Write();
  if (written != 0 && !this->Last->HadInput)
  {
    this->Fail(vtkErrorCode::UserError, "its input could not be computed; see the errors before this one");
    return 0;
  }
  return written;
}

vtkTypeBool vtkNURBSModelWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
  {
    vtkInformation* info = inputVector[0]->GetInformationObject(0);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), this->Piece);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), this->NumberOfPieces);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    return 1;
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

void vtkNURBSModelWriter::WriteData()
{
  *this->Last = Results();
  this->Last->HadInput = true;
  if (this->Piece > 0)
  {
    return;
  }
  const std::string problem = sm::CatchEverything([this]() { this->WriteFile(); });
  if (!problem.empty())
  {
    this->Fail(vtkErrorCode::UnknownError, problem);
  }
}

void vtkNURBSModelWriter::WriteFile()
{
  if (!this->FileName || !*this->FileName)
  {
    this->Fail(vtkErrorCode::NoFileNameError, "no file name was given; call SetFileName first");
    return;
  }
  const sm::FileState state = sm::GetFileState(this->GetInput());
  if (!state.Problem.empty())
  {
    this->Fail(vtkErrorCode::UserError, "its input could not be computed: " + state.Problem);
    return;
  }
  const sm::ExportTree tree = sm::MakeExportTree(this->GetInput());
  sm::ExportOptions options;
  if (!this->MakeOptions(tree, options))
  {
    return;
  }
  sm::SafeFile file(this->FileName);
  if (!file.GetProblem().empty())
  {
    this->Fail(vtkErrorCode::CannotOpenFileError, file.GetProblem());
    return;
  }
  const auto report = [this](double x)
  {
    this->UpdateProgress(x);
    return !this->GetAbortExecute();
  };
  const sm::ExportResult result = sm::WriteExport(this->GetFormat(), tree, options, file.GetStream(), report);
  if (!result.Problem.empty() || result.Aborted)
  {
    this->Fail(vtkErrorCode::UnknownError, result.Aborted ? "the application asked to stop" : result.Problem);
    return;
  }
  if (!file.Keep())
  {
    this->Fail(file.IsDiskFull() ? vtkErrorCode::OutOfDiskSpaceError : vtkErrorCode::CannotOpenFileError,
      file.GetProblem());
    return;
  }
  this->Last->Faces = result.Faces;
  std::vector<std::string> warnings = tree.Warnings;
  warnings.insert(warnings.end(), result.Warnings.begin(), result.Warnings.end());
  this->Warn(warnings);
}

bool vtkNURBSModelWriter::MakeOptions(const sm::ExportTree& tree, sm::ExportOptions& options)
{
  this->Last->Messages = tree.Notes;
  if (tree.Parts.empty())
  {
    this->Last->Messages.insert(this->Last->Messages.end(), tree.Warnings.begin(), tree.Warnings.end());
    this->Fail(vtkErrorCode::UserError,
      "its input has no exact geometry" +
        (tree.Warnings.empty()
            ? std::string(
                "; save what STEP Reader or BREP Reader gave, or NURBS Transform and NURBS Deform made of it")
            : " (" + tree.Warnings.front() + ")"));
    return false;
  }
  const std::string unit = this->ChooseUnit(tree);
  const double from = sm::GetUnitInMillimetres(tree.LengthUnit);
  const double to = sm::GetUnitInMillimetres(unit);
  // OpenCASCADE ignores a unit with another spelling and would write mm.
  options.UnitName = sm::GetShortUnit(to);
  if (!(from > 0.0) || options.UnitName.empty())
  {
    this->Fail(vtkErrorCode::UserError,
      "the length unit \"" + (from > 0.0 ? unit : tree.LengthUnit) +
        "\" is not known; use mm, cm, m, um, inch or ft");
    return false;
  }
  options.Unit = from == to ? 1.0 : from / to;
  const std::string path = this->FileName;
  options.FileName = path.substr(path.find_last_of("/\\") + 1);
  options.System = "SolidMoments " SOLIDMOMENTS_VERSION;
  return true;
}

void vtkNURBSModelWriter::Warn(const std::vector<std::string>& warnings)
{
  if (warnings.empty())
  {
    return;
  }
  this->Last->Messages.insert(this->Last->Messages.end(), warnings.begin(), warnings.end());
  const std::string more =
    warnings.size() > 1 ? " (and " + std::to_string(warnings.size() - 1) + " more messages)" : std::string();
  vtkWarningMacro("Saved " << this->FileName << ". " << warnings.front() << more);
}

void vtkNURBSModelWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n"
     << indent << "Piece: " << this->Piece << " of " << this->NumberOfPieces << "\n"
     << indent << "Faces: " << this->Last->Faces << "\n";
}
