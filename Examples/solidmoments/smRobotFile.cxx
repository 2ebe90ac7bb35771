#include "smRobotFile.h"

#include "smExtras.h"
#include "smFileJob.h"
#include "smOptions.h"
#include "smOutputFiles.h"
#include "smProductBodies.h"
#include "smProducts.h"
#include "smSafeFile.h"
#include "smText.h"

#include "vtkNURBSDataSet.h"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace sm
{
namespace
{
/// Returns what the names of the meshes of a robot begin with: XML has no other bytes than UTF-8, and no
/// control characters.
std::string GetMeshPrefix(const std::string& robotName)
{
  std::string stem = MakeUtf8(std::filesystem::path(robotName).stem().string());
  std::replace_if(
    stem.begin(), stem.end(), [](unsigned char c) { return c < 32 || c == 127; }, '_');
  return stem + "-";
}

/// Returns why a mesh cannot have this name; empty if it can.
std::string FindNameProblem(const std::string& name, const JobOptions& options)
{
  const std::string path = (std::filesystem::path(options.RobotName).parent_path() / name).string();
  for (const std::string& taken : options.TakenNames)
  {
    if (IsSameFile(path, taken))
    {
      return taken + " is another file of this run; name one of the two otherwise";
    }
  }
  if (IsModelFile(path))
  {
    return "it would overwrite " + path + ", which is a CAD file; name the robot otherwise";
  }
  for (const std::string& other : options.AllRobots)
  {
    const std::string prefix = LowerCase(GetMeshPrefix(other));
    if (other != options.RobotName && LowerCase(name).compare(0, prefix.size(), prefix) == 0)
    {
      return name + " could be a mesh of the robot " + other + ", too; write the two in runs of their own, " +
        "to names that do not begin alike";
    }
  }
  return {};
}
}

Robot MakeFileRobot(vtkDataObject* input, const ProductResults& results, const JobOptions& options)
{
  Robot robot = MakeRobot(
    GetStem(options.FileName), MakeProductTree(input), results, options.Fused, options.Joints, options.About);
  CheckRobot(robot, options.RobotFormat);
  return robot;
}

std::string WriteRobot(vtkDataObject* input, double metres, const JobOptions& options, Robot& robot)
{
  if (!robot.Problem.empty())
  {
    return "not written: " + robot.Problem;
  }
  const std::string prefix = GetMeshPrefix(options.RobotName);
  for (RobotLink& link : robot.Links)
  {
    link.VisualMesh = prefix + link.Name + ".obj";
    link.CollisionMesh = options.Collision == "hull" ? prefix + link.Name + "-hull.obj" : "";
    for (const std::string& name : { link.VisualMesh, link.CollisionMesh })
    {
      const std::string problem = name.empty() ? std::string() : FindNameProblem(name, options);
      if (!problem.empty())
      {
        return "not written: the mesh of the link " + link.Name + ": " + problem;
      }
    }
  }
  const std::vector<ProductBody> all = ListBodies(input);
  for (const RobotLink& link : robot.Links)
  {
    std::vector<vtkPolyData*> bodies;
    for (const ProductBody& body : all)
    {
      if (std::find(link.Bodies.begin(), link.Bodies.end(), body.Id) != link.Bodies.end())
      {
        bodies.push_back(body.Leaf);
      }
    }
    for (const std::string& name : { link.VisualMesh, link.CollisionMesh })
    {
      const std::string path = (std::filesystem::path(options.RobotName).parent_path() / name).string();
      const std::string problem = name.empty() ? std::string()
                                               : CallExtra(&ExtraFunctions::WriteLinkMesh, bodies, metres,
                                                   link.Pose, name == link.CollisionMesh, path);
      if (!problem.empty())
      {
        return "not written: the mesh of the link " + link.Name + ": " + problem;
      }
    }
  }
  const std::string problem = SaveFile(options.RobotName, FormatRobot(robot, options.RobotFormat));
  if (!problem.empty())
  {
    return "not written: " + problem;
  }
  return robot.Missing > 0 ? "it is without " + std::to_string(robot.Missing) + " of its links" : "";
}
}
