#include "smEventPlayer.h"

#include <vtkCommand.h>
#include <vtkInteractorEventRecorder.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <algorithm>
#include <fstream>
#include <locale.h>
#include <sstream>

namespace sm
{
namespace
{
const char* const SizeLabel = "# WindowSize ";
const int MaxSize = 8192;

/// Numbers have a decimal point in this thread from construction to destruction: vtkInteractorEventRecorder
/// reads the version of the format, "1.2", in the current locale.
class DecimalPoint
{
public:
  DecimalPoint()
    : Classic(newlocale(LC_NUMERIC_MASK, "C", static_cast<locale_t>(nullptr)))
    , Before(uselocale(this->Classic))
  {
  }
  ~DecimalPoint()
  {
    uselocale(this->Before);
    freelocale(this->Classic);
  }
  DecimalPoint(const DecimalPoint&) = delete;
  DecimalPoint& operator=(const DecimalPoint&) = delete;

private:
  locale_t Classic;
  locale_t Before;
};

std::string DescribeSize(const int* size)
{
  return std::to_string(size[0]) + " x " + std::to_string(size[1]);
}

/// Returns an error message if a line is not an event in a window of this size; empty otherwise.
std::string CheckLine(const std::string& line, const int* size)
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
  if (vtkCommand::GetEventIdFromString(event.c_str()) == vtkCommand::NoEvent)
  {
    return "there is no event " + event;
  }
  const bool isInside = numbers[0] >= 0 && numbers[0] < size[0] && numbers[1] >= 0 && numbers[1] < size[1];
  // A drag may leave the window, but it starts inside.
  return isInside || event.find("ButtonPress") == std::string::npos ? std::string()
                                                                    : "pixel " + std::to_string(numbers[0]) +
      " " + std::to_string(numbers[1]) + " is outside the window of " + DescribeSize(size) +
      " pixels; give the size of the recorded window by --size";
}
}

std::optional<std::array<int, 2>> ReadWindowSize(const std::string& fileName)
{
  std::ifstream file(fileName);
  std::string line;
  while (std::getline(file, line))
  {
    std::istringstream numbers(
      line.rfind(SizeLabel, 0) == 0 ? line.substr(std::string(SizeLabel).size()) : "");
    std::array<int, 2> size;
    if (numbers >> size[0] >> size[1] && std::min(size[0], size[1]) > 0 &&
      std::max(size[0], size[1]) <= MaxSize)
    {
      return size;
    }
  }
  return std::nullopt;
}

std::string PlayEvents(vtkRenderWindowInteractor* interactor, const std::string& fileName)
{
  std::ifstream file(fileName);
  if (!file)
  {
    return fileName + " cannot be read";
  }
  const int* window = interactor->GetRenderWindow()->GetSize();
  const std::optional<std::array<int, 2>> size = ReadWindowSize(fileName);
  if (size && (size->at(0) != window[0] || size->at(1) != window[1]))
  {
    return fileName + " was recorded in a window of " + DescribeSize(size->data()) +
      " pixels and cannot be played in one of " + DescribeSize(window) +
      "; leave out --size, or give --size " + std::to_string(size->at(0)) + " " + std::to_string(size->at(1));
  }
  std::string line;
  int events = 0;
  for (int number = 1; std::getline(file, line); ++number)
  {
    if (line.empty() || line[0] == '#')
    {
      continue;
    }
    const std::string wrong = CheckLine(line, window);
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
  const DecimalPoint decimalPoint;
  vtkNew<vtkInteractorEventRecorder> player;
  player->KeyPressActivationOff();
  player->SetInteractor(interactor);
  player->SetFileName(fileName.c_str());
  player->Play();
  player->SetInteractor(nullptr);
  return {};
}

EventRecording::EventRecording(vtkRenderWindowInteractor* interactor, const std::string& fileName)
  : FileName(fileName)
{
  std::copy_n(interactor->GetRenderWindow()->GetSize(), 2, this->Size.begin());
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
  this->Recorder->Clear(); // closes the file
  this->Recorder->SetInteractor(nullptr);
  std::ofstream(this->FileName, std::ios::app) << SizeLabel << this->Size[0] << " " << this->Size[1] << "\n";
}
}
