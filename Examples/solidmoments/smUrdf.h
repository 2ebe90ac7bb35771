/**
 * @file smUrdf.h
 * @brief Inertial blocks of robots, for URDF; SDF takes the same numbers
 */
#ifndef smUrdf_h
#define smUrdf_h

#include <string>
#include <vector>

namespace sm
{
struct FileResult;

/**
 * Returns the reason why a file has no inertial block: no mass, or an impossible inertia, which simulators
 * refuse (principal moments must be positive, and the largest at most the sum of the others). Empty if it has
 * one.
 */
std::string FindUrdfProblem(const FileResult& file);

/**
 * Returns a robot with a link for every file that has an inertial block: mass in kg, centre of mass in m, and
 * the inertia in kg m^2 about that centre with the axes of the link, which are those of the file or of the
 * frame of --about. Off-diagonals are entries of the tensor, negative products of inertia.
 */
std::string FormatUrdf(const std::vector<FileResult>& files);
}

#endif
