#!/bin/sh
# OpenCASCADE 7.6.3 (Debian 12): in a STEP file in centimetres (write.step.unit CM) the focal distance of a parabola in the parameters of a
# plane (a PCURVE) stays in millimetres, while that of the same parabola in space is in centimetres: the parameter curve of an edge, which
# the file prefers (PCURVE_S1), lies far from the edge. In millimetres both are equal. Semi-axes of hyperbolas are the same.
# Guess: parameter curves on planes are in the unit of the file, as its points there are.
# Seen: for a parabola with the focal distance 3 mm, 3 and 3 in mm, 0.3 (in space) and 3 (on the plane) in cm.
# Needs: apt-get of Debian 12, g++, the C++ library. Installs nothing; fails if the behaviour or the version changes.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=7.6.3+dfsg1-7
for part in foundation modeling-data modeling-algorithms data-exchange ocaf visualization; do
  apt-get download -qq "libocct-$part-dev=$version" "libocct-$part-7.6=$version" 2>/dev/null
done
apt-get download -qq libtbb12=2021.8.0-2+deb12u1 libtbbmalloc2=2021.8.0-2+deb12u1 2>/dev/null
for package in *.deb; do
  dpkg -x "$package" root
done
cat >parabola.cxx <<'END'
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <Geom_Parabola.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <gp.hxx>
#include <gp_Vec.hxx>

int main()
{
  const Handle(Geom_Parabola) parabola = new Geom_Parabola(gp::XOY(), 3.0);
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(parabola, -6.0, 6.0).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(parabola->Value(6.0), parabola->Value(-6.0)).Edge());
  const TopoDS_Shape prism = BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire(), true).Face(), gp_Vec(0.0, 0.0, 2.0)).Shape();
  for (const char* unit : { "MM", "CM" })
  {
    STEPControl_Writer writer;
    Interface_Static::SetCVal("write.step.unit", unit);
    writer.Model(true);
    writer.Transfer(prism, STEPControl_AsIs);
    writer.Write((std::string(unit) + ".step").c_str());
  }
  return 0;
}
END
libraries=root/usr/lib/x86_64-linux-gnu
g++ -std=c++17 -O1 -w -I root/usr/include/opencascade parabola.cxx -o parabola -L "$libraries" -lTKSTEP -lTKXSBase -lTKPrim -lTKTopAlgo -lTKBRep -lTKGeomBase \
  -lTKG3d -lTKMath -lTKernel -Wl,-rpath-link,"$libraries:/usr/lib/x86_64-linux-gnu"
LD_LIBRARY_PATH=$libraries ./parabola >/dev/null
# A parabola on a plane has a frame with two coordinates.
python3 - <<'END' | tee seen
import re

for unit in ("MM", "CM"):
    text = re.sub(r"\s", "", open(unit + ".step").read())
    entities = dict(re.findall(r"(#\d+)=(.*?);", text))
    found = {(entities[frame].split("(")[0][-2:], round(float(focal), 9)) for frame, focal in re.findall(r"PARABOLA\('',(#\d+),([\d.E+-]+)\)", text)}
    print(unit, *(f"{place} {focal:g}" for place, focal in sorted(found)))
END
printf 'MM 2D 3 3D 3\nCM 2D 3 3D 0.3\n' >expected
cmp seen expected
