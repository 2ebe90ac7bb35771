#include "smOCCTFile.h"

#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Controller.hxx>
#include <XCAFDoc_DocumentTool.hxx>

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

KernelProgress::KernelProgress(ProgressCallback progress)
  : Report(std::move(progress))
{
}

Standard_Boolean KernelProgress::UserBreak()
{
  return this->Stopped;
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
