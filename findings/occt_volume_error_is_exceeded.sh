#!/bin/sh
# OpenCASCADE 7.6.3 (Debian 12): BRepGProp::VolumeProperties(shape, properties, epsilon) returns an estimate of the relative error of the
# volume that is below the true one for a ball that is cut by an oblique plane.
# Guess: what it returns is no less than the error, or at least than epsilon's order of magnitude.
# Seen: for epsilon 1e-6 it returns 1.3e-11, as for 1e-9, and the volume is off by 1.6e-10 (closed form of the cap).
# Needs: apt-get of Debian 12, g++, the C++ library. Installs nothing; fails if the behaviour or the version changes.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=7.6.3+dfsg1-7
for part in foundation modeling-data modeling-algorithms; do
  apt-get download -qq "libocct-$part-dev=$version" "libocct-$part-7.6=$version" 2>/dev/null
done
apt-get download -qq "libocct-visualization-dev=$version" libtbb12=2021.8.0-2+deb12u1 libtbbmalloc2=2021.8.0-2+deb12u1 2>/dev/null
for package in *.deb; do
  dpkg -x "$package" root
done
cat >cap.cxx <<'END'
#include <BRepAlgoAPI_Common.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Version.hxx>
#include <gp_Ax2.hxx>

#include <cmath>
#include <cstdio>

int main()
{
  // The part of a ball beyond a plane whose normal is not the axis of its parameters, by a box with a side on that plane.
  const double radius = 10.0;
  const double distance = 3.0;
  const gp_Dir normal(1, 2, 3);
  gp_Ax2 axes(gp_Pnt(distance * normal.X(), distance * normal.Y(), distance * normal.Z()), normal);
  axes.Translate(gp_Vec(axes.XDirection()) * -20 + gp_Vec(axes.YDirection()) * -20);
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(radius).Shape();
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(axes, 40, 40, 40).Shape();
  const TopoDS_Shape cap = BRepAlgoAPI_Common(ball, box).Shape();
  const double height = radius - distance;
  const double exact = 3.14159265358979323846 * height * height * (3.0 * radius - height) / 3.0;
  bool isExceeded = false;
  for (const double epsilon : { 1e-3, 1e-6, 1e-9 })
  {
    GProp_GProps properties;
    const double stated = BRepGProp::VolumeProperties(cap, properties, epsilon);
    const double error = std::fabs(properties.Mass() / exact - 1.0);
    std::printf("OpenCASCADE %s, epsilon %.0e: stated %.1e, true %.1e\n", OCC_VERSION_COMPLETE, epsilon, stated, error);
    isExceeded = isExceeded || (epsilon == 1e-6 && error > 5.0 * stated);
  }
  return isExceeded ? 0 : 1;
}
END
libraries=root/usr/lib/x86_64-linux-gnu
g++ -std=c++17 -O1 -w -I root/usr/include/opencascade cap.cxx -o cap -L "$libraries" -lTKBO -lTKPrim -lTKTopAlgo -lTKGeomBase -lTKBRep -lTKG3d \
  -lTKG2d -lTKMath -lTKernel -Wl,-rpath-link,"$libraries"
LD_LIBRARY_PATH=$libraries ./cap
