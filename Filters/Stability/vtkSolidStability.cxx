#include "vtkSolidStability.h"

#include "Detail/vtkSolidStabilityInternals.h"
#include "smAbortFlag.h"
#include "smColumns.h"
#include "smFailureReason.h"
#include "smFileState.h"
#include "smFormat.h"
#include "smMassPropertyNames.h"
#include "smMassTable.h"
#include "smMeshDemand.h"
#include "smRunReport.h"
#include "smStabilityNames.h"

#include "vtkCallbackCommand.h"
#include "vtkDataSetAttributes.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <exception>

vtkStandardNewMacro(vtkSolidStability);

namespace
{
namespace names = sm::names;

/// Fraction of the progress for the mass properties.
constexpr double MassShare = 0.8;

/// During its lifetime, forwards the progress of the internal filter to its owner, and the owner's abort flag
/// to the internal filter.
class ProgressRelay
{
public:
  ProgressRelay(vtkAlgorithm* inside, vtkAlgorithm* owner, double share)
    : Inside(inside)
    , Owner(owner)
    , Share(share)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback(
      [](vtkObject*, unsigned long, void* relay, void*) { static_cast<ProgressRelay*>(relay)->PassOn(); });
    this->Tag = inside->AddObserver(vtkCommand::ProgressEvent, command);
  }
  ~ProgressRelay() { this->Inside->RemoveObserver(this->Tag); }
  ProgressRelay(const ProgressRelay&) = delete;
  void operator=(const ProgressRelay&) = delete;

private:
  void PassOn()
  {
    this->Owner->UpdateProgress(this->Share * this->Inside->GetProgress());
    if (this->Owner->GetAbortExecute())
    {
      this->Inside->SetAbortExecute(1);
    }
  }

  vtkAlgorithm* Inside;
  vtkAlgorithm* Owner;
  double Share;
  unsigned long Tag = 0;
};

/// Returns the order of verdicts: a larger number is worse.
int GetBadness(sm::Verdict verdict)
{
  switch (verdict)
  {
    case sm::Verdict::Stable:
      return 0;
    case sm::Verdict::TooClose:
      return 1;
    case sm::Verdict::Unstable:
      return 2;
    case sm::Verdict::NoContact:
      return 3;
    case sm::Verdict::BelowGround:
      return 4;
    case sm::Verdict::Unknown:
      break;
  }
  return 5;
}
}

vtkSolidStability::vtkSolidStability()
  : Implementation(new Internals)
{
  sm::ClearAbortAtStart(this);
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(4);
}

vtkSolidStability::~vtkSolidStability() = default;

void vtkSolidStability::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const double v[3])
  { os << indent << name << ": " << v[0] << " " << v[1] << " " << v[2] << "\n"; };
  print("GravityDirection", this->GravityDirection);
  print("GroundNormal", this->GroundNormal);
  print("GroundOrigin", this->GroundOrigin);
  os << indent << "Ground: " << this->Ground << "\n"
     << indent << "ContactTolerance: " << this->ContactTolerance << "\n"
     << indent << "Bodies: " << this->Bodies << "\n"
     << indent << "GravityStrength: " << this->GravityStrength << "\n"
     << indent << "Stability: " << this->GetStability() << "\n"
     << indent << "MassProperties:\n";
  this->Implementation->Mass->PrintSelf(os, indent.GetNextIndent());
}

void vtkSolidStability::SetVector(
  const char* name, double (&vector)[3], double x, double y, double z, bool mayVanish)
{
  const bool vanishes = x == 0.0 && y == 0.0 && z == 0.0;
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z) || (vanishes && !mayVanish))
  {
    vtkErrorMacro("The " << name << " " << sm::FormatTriple(x, y, z)
                         << " is not used: give three finite numbers"
                         << (mayVanish ? "." : ", not all 0, for example 0, 0, -1."));
    return;
  }
  const double values[3] = { x, y, z };
  if (!std::equal(values, values + 3, vector))
  {
    std::copy_n(values, 3, vector);
    this->Modified();
  }
}

void vtkSolidStability::SetGravityDirection(double x, double y, double z)
{
  this->SetVector("gravity direction", this->GravityDirection, x, y, z, false);
}

void vtkSolidStability::SetGravityDirection(const double direction[3])
{
  this->SetGravityDirection(direction[0], direction[1], direction[2]);
}

void vtkSolidStability::SetGroundNormal(double x, double y, double z)
{
  this->SetVector("ground normal", this->GroundNormal, x, y, z, true);
}

void vtkSolidStability::SetGroundNormal(const double normal[3])
{
  this->SetGroundNormal(normal[0], normal[1], normal[2]);
}

void vtkSolidStability::SetGroundOrigin(double x, double y, double z)
{
  this->SetVector("ground origin", this->GroundOrigin, x, y, z, true);
}

void vtkSolidStability::SetGroundOrigin(const double origin[3])
{
  this->SetGroundOrigin(origin[0], origin[1], origin[2]);
}

void vtkSolidStability::SetContactTolerance(double tolerance)
{
  if (std::isnan(tolerance))
  {
    vtkErrorMacro("The contact tolerance is not a number: give 0 to 0.1, for example 1e-6.");
    return;
  }
  const double clamped = std::clamp(tolerance, 0.0, 0.1);
  if (this->ContactTolerance != clamped)
  {
    this->ContactTolerance = clamped;
    this->Modified();
  }
}

void vtkSolidStability::SetDensity(double density)
{
  this->Implementation->Mass->SetDensity(density);
}

double vtkSolidStability::GetDensity()
{
  return this->Implementation->Mass->GetDensity();
}

void vtkSolidStability::SetRelativeTolerance(double tolerance)
{
  this->Implementation->Mass->SetRelativeTolerance(tolerance);
}

double vtkSolidStability::GetRelativeTolerance()
{
  return this->Implementation->Mass->GetRelativeTolerance();
}

void vtkSolidStability::SetBackend(int backend)
{
  this->Implementation->Mass->SetBackend(backend);
}

int vtkSolidStability::GetBackend()
{
  return this->Implementation->Mass->GetBackend();
}

void vtkSolidStability::SetRenderWindow(vtkRenderWindow* window)
{
  this->Implementation->Mass->SetRenderWindow(window);
}

vtkRenderWindow* vtkSolidStability::GetRenderWindow()
{
  return this->Implementation->Mass->GetRenderWindow();
}

vtkMassPropertiesGPU* vtkSolidStability::GetMassProperties()
{
  return this->Implementation->Mass;
}

std::string vtkSolidStability::GetStability() const
{
  return sm::GetName(this->Implementation->Worst.Result.Decision);
}

std::string vtkSolidStability::GetSupport() const
{
  return sm::GetName(this->Implementation->Worst.Result.Support);
}

double vtkSolidStability::GetStabilityMargin() const
{
  return this->Implementation->Worst.Result.StabilityMargin;
}

double vtkSolidStability::GetStabilityMarginBound() const
{
  return this->Implementation->Worst.Result.StabilityMarginBound;
}

double vtkSolidStability::GetTipAngle() const
{
  return this->Implementation->Worst.Result.TipAngle * sm::DegreesPerRadian;
}

double vtkSolidStability::GetTipAngleBound() const
{
  return this->Implementation->Worst.Result.TipAngleBound * sm::DegreesPerRadian;
}

double vtkSolidStability::GetCenterOfMassRise() const
{
  return this->Implementation->Worst.Result.CenterOfMassRise;
}

double vtkSolidStability::GetCenterOfMassRiseBound() const
{
  return this->Implementation->Worst.Result.CenterOfMassRiseBound;
}

double vtkSolidStability::GetRollingMargin() const
{
  return this->Implementation->Worst.Result.RollingMargin;
}

std::string vtkSolidStability::GetStatus() const
{
  return this->Implementation->Status;
}

int vtkSolidStability::GetNumberOfMessages() const
{
  return static_cast<int>(this->Implementation->Messages.size());
}

std::string vtkSolidStability::GetMessage(int index) const
{
  return index >= 0 && index < this->GetNumberOfMessages() ? this->Implementation->Messages[index] : "";
}

vtkMTimeType vtkSolidStability::GetMTime()
{
  // The input of the internal filter is set by every run; its options may be changed by the user.
  return std::max(this->Superclass::GetMTime(), this->Implementation->Mass->GetMTime());
}

int vtkSolidStability::ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputs,
  vtkInformationVector* outputs, int port, vtkMTimeType* time)
{
  sm::PassMeshDemand(this, inputs, outputs, port);
  return this->Superclass::ComputePipelineMTime(request, inputs, outputs, port, time);
}

int vtkSolidStability::FillInputPortInformation(int, vtkInformation* info)
{
  // All data, which is refused in one sentence; VTK says one for each request.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

int vtkSolidStability::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

int vtkSolidStability::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  for (int i = 0; i < this->GetNumberOfOutputPorts(); ++i)
  {
    sm::RemoveFileState(vtkDataObject::GetData(outputVector, i));
  }
  Internals& self = *this->Implementation;
  self.Worst = sm::SupportedBody();
  self.Status.clear();
  self.Messages.clear();
  const int port = std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()));
  vtkInformation* info = outputVector->GetInformationObject(port);
  try
  {
    return this->Evaluate(vtkDataObject::GetData(inputVector[0], 0),
      info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()), outputVector);
  }
  catch (...)
  {
    self.Worst = sm::SupportedBody();
    self.Status = names::StatusNotComputed;
    self.Messages.push_back(std::string("nothing was computed: ") + sm::GetReason(std::current_exception()));
    for (int i = 0; i < this->GetNumberOfOutputPorts(); ++i)
    {
      vtkDataObject::GetData(outputVector, i)->Initialize();
    }
    vtkErrorMacro("The stability could not be evaluated: " << sm::GetReason(std::current_exception())
                                                           << ". The outputs are empty.");
  }
  // Where ranks run together, what is downstream must run on all or on none.
  return info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()) > 1 ? 1 : 0;
}

int vtkSolidStability::Evaluate(vtkDataObject* input, int piece, vtkInformationVector* outputVector)
{
  sm::RejectedInput rejected;
  std::vector<sm::BodyIntegrals> bodies = sm::CollectBodies(input, rejected);
  if (bodies.empty() && rejected.Plain + rejected.Withheld > 0)
  {
    this->Implementation->Status = names::StatusEmpty;
    vtkErrorMacro(
      "No exact geometry in the input. Take the output of STEP Reader or BREP Reader: filters that move or "
      "rebuild points drop the exact faces. NURBS Transform moves a part and keeps them.");
    return 0;
  }
  // One of several ranks has the bodies, and reports when there are none.
  if (bodies.empty() && piece > 0)
  {
    return 1;
  }
  sm::GroundDirections ground;
  if (!sm::GroundDirections::Make(this->GravityDirection, this->GroundNormal, ground))
  {
    vtkErrorMacro("The ground stands upright: its normal is at right angles to gravity. Give a ground normal "
                  "that is not, or 0, 0, 0 for a level ground.");
    return 0;
  }
  this->UpdateMassProperties(input);
  this->Implementation->KeepChosen(bodies);
  std::vector<sm::SupportedBody> supported = this->Implementation->Collect(bodies, this->Bodies == TOGETHER);
  this->EvaluateBodies(ground, supported);
  this->FillOutputs(ground, supported, outputVector);
  return 1;
}

void vtkSolidStability::UpdateMassProperties(vtkDataObject* input)
{
  Internals& self = *this->Implementation;
  // Only the data object is passed on: the internal filter must not run the pipeline of this one.
  if (self.Mass->GetInputDataObject(0, 0) != input)
  {
    self.Mass->SetInputDataObject(input);
  }
  // A leaf of a composite may have changed although the composite is the same. Results of unchanged faces are
  // reused.
  self.Mass->Modified();
  {
    const ProgressRelay relay(self.Mass, this, MassShare);
    self.Mass->Update();
  }
  self.Status = self.Mass->GetStatus();
  self.FileNotes = sm::GetFileState(input).Notes;
  for (int i = 0; i < self.Mass->GetNumberOfMessages(); ++i)
  {
    self.Messages.push_back(self.Mass->GetMessage(i));
  }
}

void vtkSolidStability::EvaluateBodies(
  const sm::GroundDirections& ground, std::vector<sm::SupportedBody>& supported)
{
  Internals& self = *this->Implementation;
  for (std::size_t i = 0; i < supported.size(); ++i)
  {
    if (this->GetAbortExecute())
    {
      self.Messages.push_back("the run was aborted before all bodies were put on the ground");
      vtkWarningMacro(<< self.Messages.back());
      // The verdict of the remaining bodies is not known.
      self.Worst = supported[i];
      break;
    }
    sm::SupportedBody& body = supported[i];
    sm::EvaluateStability(
      body, ground, this->Ground == PLANE ? this->GroundOrigin : nullptr, this->ContactTolerance, self.Cache);
    if (body.Coarse)
    {
      self.Messages.push_back((body.Name.empty() ? "" : body.Name + ": ") +
        "the search for contacts was cut short; the bound of the margin shows by how much");
    }
    if (i == 0 || GetBadness(body.Result.Decision) > GetBadness(self.Worst.Result.Decision))
    {
      self.Worst = body;
    }
    this->UpdateProgress(
      MassShare + (1.0 - MassShare) * static_cast<double>(i + 1) / static_cast<double>(supported.size()));
  }
  // The parts refer to data of this run and must not outlive it.
  self.Worst.Parts.clear();
}

void vtkSolidStability::FillOutputs(const sm::GroundDirections& ground,
  const std::vector<sm::SupportedBody>& supported, vtkInformationVector* outputVector)
{
  Internals& self = *this->Implementation;
  vtkPolyData* drawing = vtkPolyData::GetData(outputVector, 0);
  sm::DrawSupportedBodies(supported, ground, drawing);
  const auto worst = std::max_element(supported.begin(), supported.end(),
    [](const sm::SupportedBody& a, const sm::SupportedBody& b)
    { return GetBadness(a.Result.Decision) < GetBadness(b.Result.Decision); });
  sm::columns::KeptArrays arrays;
  if (worst != supported.end())
  {
    Internals::AddColumns(arrays, { *worst }, ground, this->GravityStrength, drawing->GetFieldData());
  }
  sm::columns::Writer fields(arrays, drawing->GetFieldData());
  fields.SetString(names::Status, self.Status);
  fields.SetString(names::Backend, self.Mass->GetBackendName());
  Internals::AddColumns(
    arrays, supported, ground, this->GravityStrength, vtkTable::GetData(outputVector, 1)->GetRowData());
  const std::string reason =
    self.Status == names::StatusOk || self.Messages.empty() ? std::string() : self.Messages.front();
  std::vector<std::string> notes = self.Messages;
  notes.insert(notes.end(), self.FileNotes.begin(), self.FileNotes.end());
  sm::columns::Writer(arrays, vtkTable::GetData(outputVector, 2)->GetRowData())
    .SetString(names::Text,
      sm::FormatStatus(self.Status, reason) + Internals::GetSummary(supported, this->GravityStrength) +
        sm::FormatNotes(reason, notes));
  Internals::AddSides(arrays, supported, ground, this->GravityStrength, vtkTable::GetData(outputVector, 3));
}
