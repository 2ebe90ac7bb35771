/**
 * @file smEventPlayer.h
 * @brief Records mouse and keys to a file and plays them back, in the text format of
 * vtkInteractorEventRecorder
 *
 * A line has one event: its name, x and y in pixels from the lower left corner, modifiers (1 Shift, 2 Ctrl, 4
 * Alt), the key's code, a repeat count and the key's symbol ("0" for none). The same pixels show the same
 * points only in a window of the same size, which a recording states in a comment: "# WindowSize 900 700".
 */
#ifndef smEventPlayer_h
#define smEventPlayer_h

#include <vtkNew.h>

#include <array>
#include <optional>
#include <string>

class vtkInteractorEventRecorder;
class vtkRenderWindowInteractor;

namespace sm
{
/// Returns the window size that a recording states; no value if it states none or cannot be read.
std::optional<std::array<int, 2>> ReadWindowSize(const std::string& fileName);

/// Plays a file to the end; the interactor must be initialized. Returns an error message and plays nothing
/// when the file is wrong or belongs to a window of another size; returns an empty string when it was played.
std::string PlayEvents(vtkRenderWindowInteractor* interactor, const std::string& fileName);

/// Writes events to a file from construction to destruction; then the window's size.
class EventRecording
{
public:
  EventRecording(vtkRenderWindowInteractor* interactor, const std::string& fileName);
  ~EventRecording();
  EventRecording(const EventRecording&) = delete;
  EventRecording& operator=(const EventRecording&) = delete;

private:
  vtkNew<vtkInteractorEventRecorder> Recorder;
  std::string FileName;
  std::array<int, 2> Size{};
};
}

#endif
