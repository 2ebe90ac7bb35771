#include "smStepFile.h"

#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <UnitsMethods.hxx>
#include <XSControl_WorkSession.hxx>

#include <fstream>
#include <stdexcept>

namespace smtest
{
void QuietOcct()
{
  Message::DefaultMessenger()->ChangePrinters().Clear();
  STEPControl_Controller::Init();
}

void WriteStep(const TopoDS_Shape& shape, const std::string& path, const StepOptions& options)
{
  // Some versions of OpenCASCADE look at them when the writer is made, others when it translates.
  Interface_Static::SetIVal("write.surfacecurve.mode", options.WithPcurves ? 1 : 0);
  Interface_Static::SetCVal("write.step.unit", options.Unit);
  STEPControl_Writer writer;
  // Since 7.8 the unit is only a name: lengths would stay in mm.
  writer.Model()->SetWriteLengthUnit(
    UnitsMethods::GetLengthFactorValue(Interface_Static::IVal("write.step.unit")));
  if (writer.Transfer(shape, STEPControl_AsIs) != IFSelect_RetDone)
  {
    throw std::runtime_error("OCCT cannot translate the shape of " + path);
  }
  StepData_StepWriter text(writer.Model());
  if (options.AllDigits)
  {
    text.FloatWriter().SetFormat("%.16E");
  }
  text.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
  std::ofstream file(path);
  if (!text.Print(file) || !file.flush())
  {
    throw std::runtime_error("OCCT cannot write " + path);
  }
}
}
