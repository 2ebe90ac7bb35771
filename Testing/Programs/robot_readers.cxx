// robot_readers urdfdom|kdl|sdformat FILE: prints what a reader takes of a robot, as JSON. Exit status 1:
// nothing, 3: it reports errors.
#include <cstdio>
#include <fstream>
#include <iostream>
#include <kdl/tree.hpp>
#include <kdl_parser/kdl_parser.hpp>
#include <sdf/sdf.hh>
#include <sstream>
#include <string>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

namespace
{
bool First = true;
void PrintLink(const std::string& name, double mass, const double c[3], const double r[9], const double i[6])
{
  // The tensor about the centre of mass with the axes of the link: R I R^T. i: xx xy xz yy yz zz.
  const double m[3][3] = { { i[0], i[1], i[2] }, { i[1], i[3], i[4] }, { i[2], i[4], i[5] } };
  double t[3][3] = {};
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l)
          t[a][b] += r[3 * a + k] * m[k][l] * r[3 * b + l];
  std::printf("%s\n  {\"name\": \"%s\", \"mass\": %.17g, \"center\": [%.17g, %.17g, %.17g], \"inertia\": "
              "[%.17g, %.17g, %.17g, %.17g, %.17g, %.17g]}",
    First ? "" : ",", name.c_str(), mass, c[0], c[1], c[2], t[0][0], t[0][1], t[0][2], t[1][1], t[1][2],
    t[2][2]);
  First = false;
}

int ReadUrdfdom(const std::string& path)
{
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  const urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(text.str());
  if (!model)
    return 1;
  std::printf("{\"links\": [");
  for (const auto& [name, link] : model->links_)
  {
    if (!link->inertial)
      continue;
    const urdf::Inertial& in = *link->inertial;
    const urdf::Rotation& q = in.origin.rotation;
    double r[9];
    const urdf::Vector3 e[3] = { q * urdf::Vector3(1, 0, 0), q * urdf::Vector3(0, 1, 0),
      q * urdf::Vector3(0, 0, 1) };
    for (int k = 0; k < 3; ++k)
    {
      r[k] = e[k].x;
      r[3 + k] = e[k].y;
      r[6 + k] = e[k].z;
    }
    const double c[3] = { in.origin.position.x, in.origin.position.y, in.origin.position.z };
    const double i[6] = { in.ixx, in.ixy, in.ixz, in.iyy, in.iyz, in.izz };
    PrintLink(name, in.mass, c, r, i);
  }
  std::printf("]}\n");
  return 0;
}

int ReadKdl(const std::string& path)
{
  KDL::Tree tree;
  if (!kdl_parser::treeFromFile(path, tree))
    return 1;
  std::printf("{\"links\": [");
  for (const auto& [name, element] : tree.getSegments())
  {
    KDL::RigidBodyInertia in = element.segment.getInertia();
    if (in.getMass() == 0.0)
      continue;
    const KDL::Vector cog = in.getCOG();
    // About the link's frame; Steiner's term is removed.
    const KDL::RotationalInertia i = in.RefPoint(cog).getRotationalInertia();
    const double c[3] = { cog.x(), cog.y(), cog.z() };
    const double r[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
    const double six[6] = { i.data[0], i.data[1], i.data[2], i.data[4], i.data[5], i.data[8] };
    PrintLink(name, in.getMass(), c, r, six);
  }
  std::printf("]}\n");
  return 0;
}

int ReadSdformat(const std::string& path)
{
  sdf::Root root;
  const sdf::Errors errors = root.Load(path);
  for (const auto& error : errors)
    std::cerr << error << "\n";
  const sdf::Model* model = root.Model();
  if (!model && root.WorldCount() > 0 && root.WorldByIndex(0)->ModelCount() > 0)
    model = root.WorldByIndex(0)->ModelByIndex(0);
  if (!model)
    return 1;
  std::printf("{\"links\": [");
  for (uint64_t k = 0; k < model->LinkCount(); ++k)
  {
    const sdf::Link& link = *model->LinkByIndex(k);
    const auto& in = link.Inertial();
    const auto& i = in.MassMatrix();
    const auto pose = in.Pose();
    // The names of the classes differ among versions.
    const auto x = pose.Rot().XAxis();
    const auto y = pose.Rot().YAxis();
    const auto z = pose.Rot().ZAxis();
    double r[9];
    for (int a = 0; a < 3; ++a)
    {
      r[3 * a] = x[a];
      r[3 * a + 1] = y[a];
      r[3 * a + 2] = z[a];
    }
    const double c[3] = { pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z() };
    const double six[6] = { i.Ixx(), i.Ixy(), i.Ixz(), i.Iyy(), i.Iyz(), i.Izz() };
    PrintLink(link.Name(), i.Mass(), c, r, six);
  }
  std::printf("], \"errors\": %zu}\n", errors.size());
  return errors.empty() ? 0 : 3;
}
}

int main(int argc, char** argv)
{
  if (argc != 3)
    return 2;
  const std::string reader = argv[1];
  return reader == "urdfdom" ? ReadUrdfdom(argv[2])
    : reader == "kdl"        ? ReadKdl(argv[2])
    : reader == "sdformat"   ? ReadSdformat(argv[2])
                             : 2;
}
