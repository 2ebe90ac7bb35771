/**
 * @file smEventPlayer.h
 * @brief Mouse and keys recorded to a file and played back, in the text format of vtkInteractorEventRecorder
 *
 * A line per event: its name, x and y in pixels from the lower left corner, modifiers (1 Shift, 2 Ctrl, 4 Alt), the key's code,
 * a repeat count and the key's symbol ("0" for none). Pixels mean the same only in a window of the same size.
 */
#ifndef smEventPlayer_h
#define smEventPlayer_h

#include <vtkNew.h>

#include <string>

class vtkInteractorEventRecorder;
class vtkRenderWindowInteractor;

namespace sm
{
/// Plays a file to the end; the interactor must be initialized. Returns what is wrong with the file, and plays nothing then; an
/// empty string when it was played.
std::string PlayEvents(vtkRenderWindowInteractor* interactor, const std::string& fileName);

/// Writes events to a file while it lives.
class EventRecording
{
public:
  EventRecording(vtkRenderWindowInteractor* interactor, const std::string& fileName);
  ~EventRecording();
  EventRecording(const EventRecording&) = delete;
  EventRecording& operator=(const EventRecording&) = delete;

private:
  vtkNew<vtkInteractorEventRecorder> Recorder;
};
}

#endif
