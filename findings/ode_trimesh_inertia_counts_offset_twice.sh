#!/bin/sh
# ODE 0.16.2 (Debian 12): dMassSetTrimesh() of a closed mesh whose centre of mass is not at its origin gives mass and centre right, but
# an inertia in which the term of the parallel axes is counted twice; it stays once too large when dMassTranslate() moves the mass to
# its centre.
# Guess: the inertia about the origin, 26 kg m^2 for Ixx of a box of 1 x 2 x 3 m and 6 kg with a corner at the origin, and 6.5 at its centre.
# Seen: 45.5 = 6.5 + 2 x 19.5 about the origin, and 26 = 6.5 + 19.5 at the centre; with the mesh about its centre 6.5, which is right.
# For robots: move the mesh to its centre of mass before dMassSetTrimesh(), or give ODE the inertia with dMassSetParameters().
# Needs: apt-get of Debian 12, a C compiler. Installs nothing; fails if the behaviour or the version changes.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq libode8=2:0.16.2-1 libode-dev=2:0.16.2-1 libccd2=2.1-2+b1
for package in *.deb; do
  dpkg -x "$package" root
done
cat >box.c <<'END'
#include <ode/ode.h>
#include <stdio.h>

/* Prints mass, centre and Ixx of the box from a corner, as they are and moved to the centre. Triangles are counterclockwise from outside. */
static void measure(const char* name, double x, double y, double z)
{
  static const dTriIndex triangles[36] = { 0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0,
    4, 3, 4, 7 };
  double points[24];
  int i;
  for (i = 0; i < 8; ++i)
  {
    points[3 * i] = x + ((i & 3) == 1 || (i & 3) == 2 ? 1 : 0);
    points[3 * i + 1] = y + ((i & 3) >= 2 ? 2 : 0);
    points[3 * i + 2] = z + (i >= 4 ? 3 : 0);
  }
  dTriMeshDataID data = dGeomTriMeshDataCreate();
  dGeomTriMeshDataBuildDouble(data, points, 3 * sizeof(double), 8, triangles, 36, 3 * sizeof(dTriIndex));
  dMass mass;
  dMassSetTrimesh(&mass, 1.0, dCreateTriMesh(0, data, 0, 0, 0));
  printf("%s mass %g centre %g %g %g Ixx %g", name, mass.mass, mass.c[0], mass.c[1], mass.c[2], mass.I[0]);
  dMassTranslate(&mass, -mass.c[0], -mass.c[1], -mass.c[2]);
  printf(" at the centre %g\n", mass.I[0]);
}

int main(void)
{
  dInitODE2(0);
  measure("corner", 0, 0, 0);
  measure("middle", -0.5, -1, -1.5);
  return 0;
}
END
libraries=$(dirname "$(find root -name libode.so.8)")
gcc -DdIDEDOUBLE -I root/usr/include box.c -L "$libraries" -l:libode.so.8 -l:libccd.so.2 -lm -Wl,-rpath-link,"$libraries" -o box
dpkg-deb -f libode8_*.deb Package Version
LD_LIBRARY_PATH="$libraries" ./box | tee seen
cat >expected <<'END'
corner mass 6 centre 0.5 1 1.5 Ixx 45.5 at the centre 26
middle mass 6 centre 0 0 0 Ixx 6.5 at the centre 6.5
END
cmp seen expected
