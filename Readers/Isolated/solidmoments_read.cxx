/**
 * @file solidmoments_read.cxx
 * @brief solidmoments-read: reads a file for a vtkCADReader in another process, which gives it its settings
 *
 * Its arguments are the format, "file" or "content" (of the standard input), and the words of
 * vtkCADReader::PackSettings(). It sends progress and output by the messages that smReadProgram.h names to
 * its standard output, and ends with the process that started it.
 */
#include "smHelperProcess.h"
#include "smReadProgram.h"
#include "smRepairNotice.h"
#include "vtkBREPReader.h"
#include "vtkSTEPReader.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkSmartPointer.h"

#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <string>

namespace
{
constexpr int NumberOfArguments = 2 + vtkCADReader::NumberOfSettings;

bool SendProgress(int messages, double fraction)
{
  return sm::SendMessage(messages, sm::ReadProgress, &fraction, sizeof(fraction));
}

void OnProgress(vtkObject* caller, unsigned long, void* data, void*)
{
  if (!SendProgress(*static_cast<int*>(data), static_cast<vtkAlgorithm*>(caller)->GetProgress()))
  {
    std::_Exit(1); // the other process has ended
  }
}

bool ReadAndSend(char** arguments)
{
  int messages = sm::OpenMessages();
  if (!SendProgress(messages, 0.0))
  {
    return false;
  }
  vtkObject::GlobalWarningDisplayOff();
  vtkSmartPointer<vtkCADReader> reader = vtkSmartPointer<vtkSTEPReader>::New();
  if (arguments[0] == std::string("BREP"))
  {
    reader = vtkSmartPointer<vtkBREPReader>::New();
  }
  // The process that started this one makes the mesh, when it is needed.
  reader->SetDisplayMeshToNever();
  reader->UnpackSettings({ arguments + 2, arguments + NumberOfArguments });
  if (arguments[1] == std::string("content"))
  {
    reader->SetContent({ std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>() });
  }
  auto observer = vtkSmartPointer<vtkCallbackCommand>::New();
  observer->SetCallback(OnProgress);
  observer->SetClientData(&messages);
  reader->AddObserver(vtkCommand::ProgressEvent, observer);
  sm::SetRepairObserver([messages](bool isBeginning)
    { sm::SendMessage(messages, isBeginning ? sm::RepairBegins : sm::RepairEnds, nullptr, 0); });
  reader->Update();
  const sm::Bytes output = reader->PackOutput();
  return sm::SendMessage(messages, sm::ReadResult, output.data(), output.size());
}
}

int main(int argc, char** argv)
{
  if (argc != NumberOfArguments + 1)
  {
    std::cerr
      << "solidmoments-read: this program is started by vtkCADReader; the command line is solidmoments.\n";
    return 1;
  }
  try
  {
    // _Exit() skips the destructors of static objects in third-party libraries, which might fail.
    std::_Exit(ReadAndSend(argv + 1) ? 0 : 1);
  }
  catch (const std::exception&)
  {
    return 1; // out of memory
  }
}
