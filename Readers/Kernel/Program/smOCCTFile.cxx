#include "smOCCTFile.h"

#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Controller.hxx>
#include <XCAFDoc_DocumentTool.hxx>

#include <utility>

namespace sm
{
void SetKernelParameter(const char* name, const char* value)
{
  if (Interface_Static::IsPresent(name))
  {
    Interface_Static::SetCVal(name, value);
  }
}

void SetUpKernel()
{
  // Registers the parameters of the STEP translator, so that the unit can be set.
  STEPControl_Controller::Init();
  Message::DefaultMessenger()->ChangePrinters().Clear();
  SetKernelParameter("xstep.cascade.unit", "MM");
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
