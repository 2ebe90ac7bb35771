#include "smFormat.h"
#include "smRobot.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
using Pose = std::array<double, 12>;

std::string Number(double value)
{
  return FormatDigits(value, 17);
}

template <std::size_t N>
std::string List(const std::array<double, N>& values)
{
  std::string text;
  for (const double value : values)
  {
    text += (text.empty() ? "" : " ") + Number(value);
  }
  return text;
}

/// Returns the pose of `child` in the frame of `parent`.
Pose GetRelative(const Pose& parent, const Pose& child)
{
  Pose result{};
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      for (int k = 0; k < 3; ++k)
      {
        const double to = child[4 * k + j] - (j == 3 ? parent[4 * k + 3] : 0.0);
        result[4 * i + j] += parent[4 * k + i] * to;
      }
    }
  }
  return result;
}

Pose GetPoseInParent(const Robot& robot, const RobotLink& link)
{
  return link.Parent < 0 ? link.Pose : GetRelative(robot.Links[link.Parent].Pose, link.Pose);
}

std::array<double, 3> GetPosition(const Pose& pose)
{
  return { pose[3], pose[7], pose[11] };
}

/// Returns w, x, y, z with w >= 0; from the largest component, which no cancellation harms.
std::array<double, 4> GetQuaternion(const Pose& r)
{
  const double trace[4] = { r[0] + r[5] + r[10], r[0] - r[5] - r[10], r[5] - r[0] - r[10],
    r[10] - r[0] - r[5] };
  const auto largest = static_cast<int>(std::max_element(trace, trace + 4) - trace);
  const double s = 2.0 * std::sqrt(1.0 + trace[largest]);
  const double x = r[9] - r[6];
  const double y = r[2] - r[8];
  const double z = r[4] - r[1];
  std::array<double, 4> q;
  switch (largest)
  {
    case 0:
      q = { 0.25 * s, x / s, y / s, z / s };
      break;
    case 1:
      q = { x / s, 0.25 * s, (r[1] + r[4]) / s, (r[2] + r[8]) / s };
      break;
    case 2:
      q = { y / s, (r[1] + r[4]) / s, 0.25 * s, (r[6] + r[9]) / s };
      break;
    default:
      q = { z / s, (r[2] + r[8]) / s, (r[6] + r[9]) / s, 0.25 * s };
      break;
  }
  const double sign = q[0] < 0.0 ? -1.0 : 1.0;
  for (double& c : q)
  {
    c *= sign;
  }
  return q;
}

/// Returns angles about the fixed axes x, y and z, one after the other.
std::array<double, 3> GetRollPitchYaw(const Pose& r)
{
  const double level = std::hypot(r[0], r[4]);
  const double pitch = std::atan2(-r[8], level);
  // Where x points along z, only the sum or difference of the other angles counts.
  return level > 1e-9 ? std::array<double, 3>{ std::atan2(r[9], r[10]), pitch, std::atan2(r[4], r[0]) }
                      : std::array<double, 3>{ std::atan2(-r[6], r[5]), pitch, 0.0 };
}

/// Returns text for an attribute or an element.
std::string Escape(const std::string& text)
{
  std::string result;
  for (const char c : text)
  {
    result += c == '&' ? "&amp;"
      : c == '<'       ? "&lt;"
      : c == '>'       ? "&gt;"
      : c == '"'       ? "&quot;"
                       : std::string(1, c);
  }
  return result;
}

constexpr const char* Remark =
  "kg, m, kg m^2. The inertia is about the centre of mass, with the axes of the link;\n"
  "     products of inertia are entries of the tensor, which are negative products. By SolidMoments.";

std::string FormatUrdf(const Robot& robot)
{
  // MuJoCo would add links that do not move to the world, and libsdformat such links to their parents.
  std::string text = "<?xml version=\"1.0\"?>\n<!-- " + std::string(Remark) + " -->\n<robot name=\"" +
    robot.Name +
    "\">\n  <mujoco><compiler fusestatic=\"false\" discardvisual=\"false\"/></mujoco>\n  <link "
    "name=\"world\"/>\n";
  for (const RobotLink& link : robot.Links)
  {
    const std::array<double, 9>& i = link.Inertia;
    text += "  <link name=\"" + link.Name + "\">\n    <inertial>\n      <origin xyz=\"" + List(link.Center) +
      "\" rpy=\"0 0 0\"/>\n      <mass value=\"" + Number(link.Mass) + "\"/>\n      <inertia ixx=\"" +
      Number(i[0]) + "\" ixy=\"" + Number(i[1]) + "\" ixz=\"" + Number(i[2]) + "\" iyy=\"" + Number(i[4]) +
      "\" iyz=\"" + Number(i[5]) + "\" izz=\"" + Number(i[8]) + "\"/>\n    </inertial>\n";
    for (const auto& [tag, mesh] :
      { std::make_pair("visual", link.VisualMesh), std::make_pair("collision", link.CollisionMesh) })
    {
      if (!mesh.empty())
      {
        text += std::string("    <") + tag + "><geometry><mesh filename=\"" + Escape(mesh) +
          "\"/></geometry></" + tag + ">\n";
      }
    }
    text += "  </link>\n";
  }
  for (const RobotLink& link : robot.Links)
  {
    const Pose pose = GetPoseInParent(robot, link);
    const bool isFixed = link.JointType == "fixed";
    const std::string name = link.Name + "_joint";
    text += "  <joint name=\"" + name + "\" type=\"" +
      (link.JointType == "revolute" ? std::string("continuous") : link.JointType) +
      "\">\n    <parent link=\"" + (link.Parent < 0 ? std::string("world") : robot.Links[link.Parent].Name) +
      "\"/>\n    <child link=\"" + link.Name + "\"/>\n    <origin xyz=\"" + List(GetPosition(pose)) +
      "\" rpy=\"" + List(GetRollPitchYaw(pose)) + "\"/>\n";
    text += isFixed ? "" : "    <axis xyz=\"" + List(link.Axis) + "\"/>\n";
    text += link.JointType == "prismatic"
      ? "    <limit lower=\"-1e9\" upper=\"1e9\" effort=\"1e9\" velocity=\"1e9\"/>\n"
      : "";
    text += "  </joint>\n";
    text += isFixed && link.Parent >= 0
      ? "  <gazebo reference=\"" + name + "\"><preserveFixedJoint>true</preserveFixedJoint></gazebo>\n"
      : "";
  }
  return text + "</robot>\n";
}

std::string FormatSdf(const Robot& robot)
{
  std::string text = "<?xml version=\"1.0\"?>\n<!-- " + std::string(Remark) +
    " -->\n<sdf version=\"1.9\">\n<model name=\"" + robot.Name + "\">\n";
  for (const RobotLink& link : robot.Links)
  {
    const std::array<double, 9>& i = link.Inertia;
    const std::array<double, 4> q = GetQuaternion(link.Pose);
    text += "  <link name=\"" + link.Name + "\">\n    <pose rotation_format=\"quat_xyzw\">" +
      List(GetPosition(link.Pose)) + " " + List(std::array<double, 4>{ q[1], q[2], q[3], q[0] }) +
      "</pose>\n    <inertial>\n      <pose>" + List(link.Center) + " 0 0 0</pose>\n      <mass>" +
      Number(link.Mass) + "</mass>\n      <inertia><ixx>" + Number(i[0]) + "</ixx><ixy>" + Number(i[1]) +
      "</ixy><ixz>" + Number(i[2]) + "</ixz><iyy>" + Number(i[4]) + "</iyy><iyz>" + Number(i[5]) +
      "</iyz><izz>" + Number(i[8]) + "</izz></inertia>\n    </inertial>\n";
    for (const auto& [tag, mesh] :
      { std::make_pair("visual", link.VisualMesh), std::make_pair("collision", link.CollisionMesh) })
    {
      if (!mesh.empty())
      {
        text += std::string("    <") + tag + " name=\"" + tag + "\"><geometry><mesh><uri>" + Escape(mesh) +
          "</uri></mesh></geometry></" + tag + ">\n";
      }
    }
    text += "  </link>\n";
  }
  for (const RobotLink& link : robot.Links)
  {
    if (link.Parent < 0 && link.JointType == "fixed")
    {
      continue;
    }
    text += "  <joint name=\"" + link.Name + "_joint\" type=\"" + link.JointType + "\">\n    <parent>" +
      (link.Parent < 0 ? std::string("world") : robot.Links[link.Parent].Name) + "</parent>\n    <child>" +
      link.Name + "</child>\n";
    text += link.JointType == "fixed" ? "" : "    <axis><xyz>" + List(link.Axis) + "</xyz></axis>\n";
    text += "  </joint>\n";
  }
  return text + "</model>\n</sdf>\n";
}

/// Adds the body of a link with those of its children.
void AddBody(const Robot& robot, int index, const std::string& indent, std::string& text)
{
  const RobotLink& link = robot.Links[index];
  const Pose pose = GetPoseInParent(robot, link);
  const std::array<double, 9>& i = link.Inertia;
  text += indent + "<body name=\"" + link.Name + "\" pos=\"" + List(GetPosition(pose)) + "\" quat=\"" +
    List(GetQuaternion(pose)) + "\">\n" + indent + "  <inertial pos=\"" + List(link.Center) + "\" mass=\"" +
    Number(link.Mass) + "\" fullinertia=\"" +
    List(std::array<double, 6>{ i[0], i[4], i[8], i[1], i[2], i[5] }) + "\"/>\n";
  if (link.JointType != "fixed")
  {
    text += indent + "  <joint name=\"" + link.Name + "_joint\" type=\"" +
      (link.JointType == "revolute" ? "hinge" : "slide") + "\" axis=\"" + List(link.Axis) + "\"/>\n";
  }
  text += link.VisualMesh.empty() ? ""
                                  : indent + "  <geom type=\"mesh\" mesh=\"" + link.Name +
      "\" contype=\"0\" conaffinity=\"0\" group=\"2\"/>\n";
  text += link.CollisionMesh.empty()
    ? ""
    : indent + "  <geom type=\"mesh\" mesh=\"" + link.Name + "_hull\" group=\"3\"/>\n";
  for (int k = 0; k < static_cast<int>(robot.Links.size()); ++k)
  {
    if (robot.Links[k].Parent == index)
    {
      AddBody(robot, k, indent + "  ", text);
    }
  }
  text += indent + "</body>\n";
}

std::string FormatMjcf(const Robot& robot)
{
  std::string text = "<!-- " + std::string(Remark) + " -->\n<mujoco model=\"" + robot.Name +
    "\">\n  <compiler angle=\"radian\" inertiafromgeom=\"false\" autolimits=\"true\"/>\n  <asset>\n";
  for (const RobotLink& link : robot.Links)
  {
    text += link.VisualMesh.empty()
      ? ""
      : "    <mesh name=\"" + link.Name + "\" file=\"" + Escape(link.VisualMesh) + "\"/>\n";
    text += link.CollisionMesh.empty()
      ? ""
      : "    <mesh name=\"" + link.Name + "_hull\" file=\"" + Escape(link.CollisionMesh) + "\"/>\n";
  }
  text += "  </asset>\n  <worldbody>\n";
  for (int k = 0; k < static_cast<int>(robot.Links.size()); ++k)
  {
    if (robot.Links[k].Parent < 0)
    {
      AddBody(robot, k, "    ", text);
    }
  }
  return text + "  </worldbody>\n</mujoco>\n";
}
}

std::string FormatRobot(const Robot& robot, RobotFormat format)
{
  return format == RobotFormat::Urdf ? FormatUrdf(robot)
    : format == RobotFormat::Sdf     ? FormatSdf(robot)
                                     : FormatMjcf(robot);
}
}
