/**
 * @file smRobotFile.h
 * @brief Writes the parts of a file as a robot, with a mesh for each link
 */
#ifndef smRobotFile_h
#define smRobotFile_h

#include <string>
#include <vector>

class vtkDataObject;

namespace sm
{
struct JobOptions;
struct ProductResults;

/**
 * Writes the robot (smRobot.h) options.RobotName, and next to it NAME-LINK.obj for each link, and with the
 * collision "hull" NAME-LINK-hull.obj. `bodies` is the output of the reader, with its display mesh. Adds
 * notes: what is left out, and what readers refuse. Returns an error message, also if a link is left out;
 * empty if all is there.
 */
std::string WriteRobot(vtkDataObject* bodies, const ProductResults& results, const JobOptions& options,
  std::vector<std::string>& notes);
}

#endif
