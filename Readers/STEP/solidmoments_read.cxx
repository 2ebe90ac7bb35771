/**
 * @file solidmoments_read.cxx
 * @brief solidmoments-read: reads a STEP file for a vtkSTEPReader in another process, which gives it its settings
 *
 * It sends progress and output by the messages of smReadProgram.h to its standard output, and ends with the process that started it.
 */
#include "smReadProgram.h"
#include "vtkSTEPReader.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"

#include <cstdlib>
#include <exception>
#include <iostream>

namespace
{
constexpr int NumberOfArguments = 6;

void OnProgress(vtkObject* caller, unsigned long, void* data, void*)
{
  if (!sm::SendProgress(*static_cast<int*>(data), static_cast<vtkAlgorithm*>(caller)->GetProgress()))
  {
    std::_Exit(1); // nobody listens
  }
}

bool ReadAndSend(char** arguments)
{
  int messages = sm::OpenMessages();
  if (!sm::SendProgress(messages, 0.0))
  {
    return false;
  }
  vtkObject::GlobalWarningDisplayOff();
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(arguments[0]);
  reader->SetOutputUnit(arguments[1]);
  reader->SetRepair(std::atoi(arguments[2]));
  reader->SetLinearDeflection(std::strtod(arguments[3], nullptr));
  reader->SetRelativeDeflection(std::atoi(arguments[4]) != 0);
  reader->SetAngularDeflection(std::strtod(arguments[5], nullptr));
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(OnProgress);
  observer->SetClientData(&messages);
  reader->AddObserver(vtkCommand::ProgressEvent, observer);
  reader->Update();
  return sm::SendResult(messages, reader->PackOutput());
}
}

int main(int argc, char** argv)
{
  if (argc != NumberOfArguments + 1)
  {
    std::cerr
      << "solidmoments-read: this program is started by vtkSTEPReader; the command line is solidmoments.\n";
    return 1;
  }
  try
  {
    // Without the destructors of static objects in third-party libraries, which could only fail.
    std::_Exit(ReadAndSend(argv + 1) ? 0 : 1);
  }
  catch (const std::exception&)
  {
    return 1; // out of memory
  }
}
