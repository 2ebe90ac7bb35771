/**
 * @file smLivePlane.h
 * @brief Lets a filter with a plane follow the plane while it is dragged in a view, without Apply
 *
 * ParaView takes the place of a plane that the user drags when Apply is pressed. For a filter with the hint
 * `<LivePlane/>`, which is the active source, and as its property LivePlane says, the filter runs and the
 * views are drawn during the drag instead: never (0), where a run takes less than a tenth of a second (1), or
 * always (2). Works on the client without Qt.
 */
#ifndef smLivePlane_h
#define smLivePlane_h

class vtkAlgorithm;
class vtkSMSourceProxy;

namespace sm
{
/// Installs what observes the planes in the views of the filter's session; once a session. `algorithm` is the
/// filter itself in the built-in session, whose runs are timed, else null: then only "always" follows.
void FollowPlane(vtkSMSourceProxy* filter, vtkAlgorithm* algorithm);
}

#endif
