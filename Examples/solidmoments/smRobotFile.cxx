#include "smRobotFile.h"

#include "smFileJob.h"
#include "smLengthUnits.h"
#include "smMeshFile.h"
#include "smOptions.h"
#include "smProductBodies.h"
#include "smProductResults.h"
#include "smProducts.h"
#include "smRobot.h"
#include "smSafeFile.h"
#include "smText.h"

#include "vtkNURBSDataSet.h"

#include <algorithm>
#include <filesystem>

namespace sm
{
std::string WriteRobot(vtkDataObject* input, const ProductResults& results, const JobOptions& options,
  std::vector<std::string>& notes)
{
  const std::filesystem::path target(options.RobotName);
  const std::string stem = target.stem().string();
  Robot robot = MakeRobot(
    GetStem(options.FileName), MakeProductTree(input), results, options.Fused, options.Joints, options.About);
  CheckRobot(robot, options.RobotFormat);
  for (const std::string& message : robot.Messages)
  {
    notes.push_back("robot: " + message);
  }
  if (!robot.Problem.empty())
  {
    return "no robot " + options.RobotName + ": " + robot.Problem;
  }
  const std::vector<ProductBody> all = ListBodies(input);
  const double metres = GetMetres(results.LengthUnit.value_or(""));
  for (RobotLink& link : robot.Links)
  {
    std::vector<vtkPolyData*> bodies;
    for (const ProductBody& body : all)
    {
      if (std::find(link.Bodies.begin(), link.Bodies.end(), body.Id) != link.Bodies.end())
      {
        bodies.push_back(body.Leaf);
      }
    }
    link.VisualMesh = stem + "-" + link.Name + ".obj";
    link.CollisionMesh = options.Collision == "hull" ? stem + "-" + link.Name + "-hull.obj" : "";
    for (const std::string& name : { link.VisualMesh, link.CollisionMesh })
    {
      const std::string problem = name.empty()
        ? std::string()
        : WriteLinkMesh(
            bodies, metres, link.Pose, name == link.CollisionMesh, (target.parent_path() / name).string());
      if (!problem.empty())
      {
        return "no robot " + options.RobotName + ": the mesh of the link " + link.Name + ": " + problem;
      }
    }
  }
  const std::string problem = SaveFile(options.RobotName, FormatRobot(robot, options.RobotFormat));
  if (!problem.empty())
  {
    return "no robot " + options.RobotName + ": " + problem;
  }
  return robot.Missing > 0 ? "the robot is without " + std::to_string(robot.Missing) + " of its links" : "";
}
}
