/**
 * @file smRobot.h
 * @brief A product as a robot: links with their masses, and joints, as URDF, SDF and MJCF; not installed
 *
 * Units are kg, m and kg m^2. The frame of the robot is that of the file.
 */
#ifndef smRobot_h
#define smRobot_h

#include "smFields.h"
#include "smFiltersProductsModule.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace sm
{
struct ProductResults;
struct ProductTreeNode;

enum class RobotFormat
{
  Urdf,
  Sdf,
  Mjcf
};

/// Returns the format of a name, urdf, sdf or mjcf; nothing for another one.
SMFILTERSPRODUCTS_EXPORT std::optional<RobotFormat> ParseRobotFormat(const std::string& name);

/// A line of the table of joints.
struct RobotJoint
{
  /// Names of links, or of products that are one link: a link comes before a product of the same name. Parent
  /// "world": the child is the root.
  std::string Parent, Child;
  /// fixed, revolute or prismatic.
  std::string Type = "fixed";
  /// Direction in the frame of the file, of any length above 0.
  std::array<double, 3> Axis{ 0.0, 0.0, 1.0 };
  /// A point of the axis in the frame and the length unit of the results, which becomes the origin of the
  /// child; nothing: the origin of its product.
  std::optional<std::array<double, 3>> Origin;
};

/// Reads lines "parent,child,type,axis x,y,z,origin x,y,z", where the axis, or the origin, may be missing;
/// empty lines, those that begin with #, and the header "parent,child,type..." are skipped. Returns an error
/// message; empty if all is well.
SMFILTERSPRODUCTS_EXPORT std::string ParseRobotJoints(
  const std::string& text, std::vector<RobotJoint>& joints);

struct RobotLink
{
  /// Letters, digits, _, - and . only. No two of all names, alone and with -hull, _hull and _joint behind
  /// them, are equal or differ in case alone.
  std::string Name;
  std::string Product;
  /// Ids of its bodies.
  std::vector<std::string> Bodies;
  /// The frame of the link in that of the robot: first three rows, metres.
  std::array<double, 12> Pose{ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0 };
  double Mass = Unknown;
  /// In the frame of the link; the tensor is about the centre, with negative products of inertia.
  std::array<double, 3> Center{ Unknown, Unknown, Unknown };
  std::array<double, 9> Inertia{};
  /// Index of the parent; -1: the world.
  int Parent = -1;
  std::string JointType = "fixed";
  /// A unit vector in the frame of the link.
  std::array<double, 3> Axis{ 0.0, 0.0, 1.0 };
  /// Names of mesh files, UTF-8, without control characters; metres and the frame of the link; empty: none.
  std::string VisualMesh, CollisionMesh;
};

struct Robot
{
  std::string Name;
  std::vector<RobotLink> Links;
  /// What is left out, and what readers refuse.
  std::vector<std::string> Messages;
  /// Why there is no robot; empty if there is one.
  std::string Problem;
  /// Number of links that are left out.
  std::size_t Missing = 0;
};

/**
 * Makes a link for every occurrence of a product that has solids; of a product whose name matches one of the
 * patterns `fused` (MatchesPattern), and of all products below it, one link. A link has the frame of its
 * product, or `frame` (nine numbers in the unit of the results: origin, z axis, x axis; empty: that of the
 * file) if a pattern matches its product or the product is mirrored; with a joint that has an origin, it is
 * translated there. The name of a link without a product name is made of `name`. The first link is the root,
 * the others are fixed to it where `joints` says nothing else.
 *
 * A link whose mass or inertia is not known is left out. `results` are those of the products in `tree`;
 * the robot has no other solids. Values are as exact as the results: rounding of the
 * sums adds some 1e-16 of them.
 */
SMFILTERSPRODUCTS_EXPORT Robot MakeRobot(const std::string& name, const ProductTreeNode& tree,
  const ProductResults& results, const std::vector<std::string>& fused, const std::vector<RobotJoint>& joints,
  const std::vector<double>& frame = {});

/// Adds what the readers of a format leave out or refuse: libsdformat links below 1e-6 kg, MuJoCo moments
/// below 1e-14 kg m^2, and both moments of which the largest exceeds the sum of the others.
SMFILTERSPRODUCTS_EXPORT void CheckRobot(Robot& robot, RobotFormat format);

/// Returns the text of the file, UTF-8.
SMFILTERSPRODUCTS_EXPORT std::string FormatRobot(const Robot& robot, RobotFormat format);
}

#endif
