#include "smOCCTFile.h"

#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Controller.hxx>
#include <XCAFDoc_DocumentTool.hxx>

#include <ctime>
#include <utility>

namespace sm
{
namespace
{
std::mutex& GetKernelMutex()
{
  static std::mutex mutex;
  return mutex;
}

thread_local int SessionDepth = 0;
}

void KernelSettings::Set(const char* name, const char* value)
{
  if (Interface_Static::IsPresent(name))
  {
    this->Before.emplace(name, Interface_Static::CVal(name));
    Interface_Static::SetCVal(name, value);
  }
}

KernelSettings::~KernelSettings()
{
  for (const auto& [name, value] : this->Before)
  {
    Interface_Static::SetCVal(name.c_str(), value.c_str());
  }
}

KernelSession::KernelSession()
{
  if (SessionDepth > 0)
  {
    ++SessionDepth;
    return;
  }
  this->Lock = std::unique_lock<std::mutex>(GetKernelMutex());
  // Registers the parameters of the STEP translator, so that the unit can be set.
  STEPControl_Controller::Init();
  this->Printers = Message::DefaultMessenger()->Printers();
  Message::DefaultMessenger()->ChangePrinters().Clear();
  this->Settings.Set("xstep.cascade.unit", "MM");
  // Switches off the computation of the continuity between neighbouring faces, which is not used.
  this->Settings.Set("read.encoderegularity.angle", "0.");
  // Switches off the reading of triangulated shapes, which accompany the exact ones.
  this->Settings.Set("read.step.tessellated", "Off");
  SessionDepth = 1;
}

KernelSession::~KernelSession()
{
  if (--SessionDepth > 0)
  {
    return;
  }
  Message::DefaultMessenger()->ChangePrinters() = this->Printers;
}

bool KernelSession::IsHeldHere()
{
  return SessionDepth > 0;
}

void SetMillimetres(const Handle(TDocStd_Document) & document)
{
  XCAFDoc_DocumentTool::SetLengthUnit(document, 1.0, UnitsMethods_LengthUnit_Millimeter);
}

double GetThreadSeconds()
{
  timespec time;
  return clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) == 0
    ? static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec)
    : static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

KernelProgress::KernelProgress(ProgressCallback progress, double seconds)
  : Report(std::move(progress))
  , Limited(seconds > 0.0)
  , Deadline(GetThreadSeconds() + seconds)
{
}

Standard_Boolean KernelProgress::UserBreak()
{
  if (this->Limited && !this->TimedOut && GetThreadSeconds() > this->Deadline)
  {
    this->TimedOut = true;
  }
  return this->Stopped || this->TimedOut;
}

void KernelProgress::Show(const Message_ProgressScope&, const Standard_Boolean force)
{
  const double position = this->GetPosition();
  if (force || position > this->Last + 0.01)
  {
    this->Last = position;
    try
    {
      if (this->Report && !this->Stopped && !this->Report(position))
      {
        this->Stopped = true;
      }
    }
    catch (...)
    {
      this->Thrown = std::current_exception();
      this->Stopped = true;
    }
  }
}

void KernelProgress::Rethrow() const
{
  if (this->Thrown)
  {
    std::rethrow_exception(this->Thrown);
  }
}
}
