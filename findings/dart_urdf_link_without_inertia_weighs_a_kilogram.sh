#!/bin/sh
# DART 6.12.1 (Debian 12): its reader of URDF gives every link that states no inertia 1 kg and unit moments, without a message: an empty
# base link or a frame of a tool, which URDF means as massless, makes a robot of 2 kg weigh 3 and 4 kg. An empty root named "world"
# is not counted.
# Guess: 2 kg, as urdfdom, KDL and MuJoCo have it, or a warning.
# Seen: 2 with the root "world", 3 with the root "base_link", 4 with an empty link "tool" as well.
# For robots: name the empty root "world", as solidmoments does, and give other empty links a small inertia.
# Needs: apt-get of Debian 12, a C++ compiler. Installs nothing; fails if the behaviour or the version changes.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=6.12.1+dfsg4-12+b2
# The packages that this machine lacks; nothing is installed.
apt-get install -s --no-install-recommends "libdart-utils-urdf-dev=$version" "libdart-external-ikfast-dev=$version" 2>/dev/null |
  sed -n 's/^Inst \([^ ]*\) .*/\1/p' >missing
test ! -s missing || xargs apt-get download -qq <missing 2>/dev/null
for package in *.deb; do
  test ! -f "$package" || dpkg -x "$package" root
done
cat >weigh.cpp <<'END'
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/utils/urdf/urdf.hpp>
#include <cstdio>

int main(int, char** files)
{
  while (*++files)
  {
    const auto robot = dart::utils::DartLoader().parseSkeleton(std::string("file://") + *files);
    std::printf("DART %s %s: %g kg, links:", DART_VERSION, std::strrchr(*files, '/') + 1, robot->getMass());
    for (std::size_t i = 0; i < robot->getNumBodyNodes(); ++i)
    {
      std::printf(" %s %g", robot->getBodyNode(i)->getName().c_str(), robot->getBodyNode(i)->getMass());
    }
    std::printf("\n");
  }
}
END
# robot ROOT [LINK]: an arm of 2 kg at an empty root, with an empty link on it.
robot() {
  echo "<robot name='robot'><link name='$1'/><link name='arm'><inertial><origin xyz='0 0 0.5'/><mass value='2'/>"
  echo "<inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link>"
  echo "<joint name='shoulder' type='continuous'><parent link='$1'/><child link='arm'/><axis xyz='0 0 1'/></joint>"
  test -z "${2:-}" || echo "<link name='$2'/><joint name='wrist' type='fixed'><parent link='arm'/><child link='$2'/></joint>"
  echo "</robot>"
}
robot world >world.urdf
robot base_link >base_link.urdf
robot base_link tool >tool.urdf
libraries=$folder/root/usr/lib/x86_64-linux-gnu
g++ -std=c++17 -O0 -include cstring weigh.cpp -o weigh -I root/usr/include -I root/usr/include/eigen3 -I /usr/include/eigen3 \
  -I root/usr/include/bullet -L "$libraries" -ldart-utils-urdf -ldart -Wl,--allow-shlib-undefined -Wl,-rpath-link,"$libraries"
LD_LIBRARY_PATH="$libraries" ./weigh "$folder/world.urdf" "$folder/base_link.urdf" "$folder/tool.urdf" | tee seen
cat >expected <<'END'
DART 6.12.1 world.urdf: 2 kg, links: arm 2
DART 6.12.1 base_link.urdf: 3 kg, links: base_link 1 arm 2
DART 6.12.1 tool.urdf: 4 kg, links: base_link 1 arm 2 tool 1
END
cmp seen expected
