/**
 * @file smRobotFile.h
 * @brief Writes the products of a file as a robot, with a mesh for each link
 */
#ifndef smRobotFile_h
#define smRobotFile_h

#include "smRobot.h"

#include <string>

class vtkDataObject;

namespace sm
{
struct JobOptions;
struct ProductResults;

/// Returns the robot of the options (smRobot.h), with messages about what readers leave out or refuse.
/// `bodies` is the output of the reader.
Robot MakeFileRobot(vtkDataObject* bodies, const ProductResults& results, const JobOptions& options);

/**
 * Writes the robot to options.RobotName, and next to it NAME-LINK.obj for each link, and with the collision
 * "hull" NAME-LINK-hull.obj; bytes of NAME that are not UTF-8, or are control characters, are replaced.
 * Writes nothing if a mesh would replace another file of the run, or could be that of another robot. `bodies`
 * has the display mesh, in units of `metres`. Sets the names of the meshes. Returns an error message, also if
 * a link is left out; empty if all is there.
 */
std::string WriteRobot(vtkDataObject* bodies, double metres, const JobOptions& options, Robot& robot);
}

#endif
