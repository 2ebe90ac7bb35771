#include "smEventPlayer.h"

#include <vtkCommand.h>
#include <vtkInteractorEventRecorder.h>
#include <vtkRenderWindowInteractor.h>

#include <fstream>
#include <sstream>

namespace sm
{
namespace
{
/// What is wrong with a line; empty when nothing is.
std::string CheckLine(const std::string& line)
{
  std::istringstream words(line);
  std::string event;
  int numbers[5];
  words >> event;
  for (int& number : numbers)
  {
    words >> number;
  }
  if (!words)
  {
    return "\"" + line + "\" is not a name and five numbers";
  }
  return vtkCommand::GetEventIdFromString(event.c_str()) == vtkCommand::NoEvent ? "there is no event " + event
                                                                                : std::string();
}
}

std::string PlayEvents(vtkRenderWindowInteractor* interactor, const std::string& fileName)
{
  std::ifstream file(fileName);
  if (!file)
  {
    return fileName + " cannot be read";
  }
  std::string line;
  int events = 0;
  for (int number = 1; std::getline(file, line); ++number)
  {
    if (line.empty() || line[0] == '#')
    {
      continue;
    }
    const std::string wrong = CheckLine(line);
    if (!wrong.empty())
    {
      return fileName + ", line " + std::to_string(number) + ": " + wrong;
    }
    ++events;
  }
  if (events == 0)
  {
    return fileName + " holds no events";
  }
  vtkNew<vtkInteractorEventRecorder> player;
  player->KeyPressActivationOff();
  player->SetInteractor(interactor);
  player->SetFileName(fileName.c_str());
  player->Play();
  player->SetInteractor(nullptr);
  return {};
}

EventRecording::EventRecording(vtkRenderWindowInteractor* interactor, const std::string& fileName)
{
  this->Recorder->KeyPressActivationOff();
  this->Recorder->SetInteractor(interactor);
  this->Recorder->SetFileName(fileName.c_str());
  this->Recorder->On();
  this->Recorder->Record();
}

EventRecording::~EventRecording()
{
  this->Recorder->Stop();
  this->Recorder->Off();
  this->Recorder->SetInteractor(nullptr);
}
}
