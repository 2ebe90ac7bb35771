#!/bin/sh
# OpenCASCADE 7.6.3 (Debian 12): the default STEP reader makes a pin with a rounded end 9.5 % too heavy if it is small, and the right
# one of the same pin ten times as large. The rounded end is a SURFACE_OF_REVOLUTION of a spline of degree 6 that follows its edge, a
# circle, to 3e-6 of its radius. Transformers in KiCad's library have such pins.
# Guess: volumes of similar parts differ by the third power of the scale.
# Seen: 3295.42 mm^3 for radius 5 and rounding 2.4, which is right, and 3.60825 mm^3 for radius 0.5 and 0.24, for 3.29542; no warning.
# Needs: apt-get of Debian 12, g++, python3, the C++ library. Installs nothing; fails if the behaviour or the version changes.
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
cat >pin.py <<'END'
"""pin.py SCALE: a cylinder of radius 5 and height 40 with a lower end rounded by 2.4, as STEP; its volume on the last line."""
import math
import sys

SCALE = float(sys.argv[1])
RADIUS, ROUND, HEIGHT = 5.0 * SCALE, 2.4 * SCALE, 40.0 * SCALE
INNER = RADIUS - ROUND
records = []


def add(text):
    records.append(f"#{len(records) + 1}={text};")
    return f"#{len(records)}"


def point(x, z):
    return add(f"CARTESIAN_POINT('',({x:.15g},0.,{z:.15g}))".replace("e", "E"))


def direction(*xyz):
    return add("DIRECTION('',(%s))" % ",".join(f"{x}." for x in xyz))


def frame(z, normal=(0, 0, 1), x=0.0):
    return add(f"AXIS2_PLACEMENT_3D('',{point(x, z)},{direction(*normal)},{direction(1, 0, 0)})")


def edge(start, end, curve):
    return add(f"EDGE_CURVE('',{start},{end},{curve},.T.)")


def face(surface, sense, bound, *uses):
    edges = ",".join(add(f"ORIENTED_EDGE('',*,*,{used},.{way}.)") for used, way in uses)
    ring = add(f"FACE_BOUND('',{add(f'''EDGE_LOOP('',({edges}))''')},.{bound}.)")
    return add(f"ADVANCED_FACE('',({ring}),{surface},.{sense}.)")


def circle(radius, *place):
    return add(f"CIRCLE('',{frame(*place)},{radius:.15g})")


# A quarter of a circle from (1,0) to (0,-1) by a spline of degree 6 that has its ends, tangents, curvatures and middle.
a = math.pi / 12
x = [1, 1, 1 - math.pi ** 2 / 120, 0, 2 * a, a, 0]
x[3] = (64 * math.sqrt(0.5) - 7 - 15 * x[2] - 15 * x[4] - 6 * x[5]) / 20
net = [(INNER + ROUND * x[i], -ROUND * x[6 - i]) for i in range(7)]

top, middle, low = (add(f"VERTEX_POINT('',{point(*p)})") for p in ((RADIUS, HEIGHT), (RADIUS, 0), (INNER, -ROUND)))
line = add(f"LINE('',{point(RADIUS, HEIGHT)},{add(f'''VECTOR('',{direction(0, 0, -1)},1.)''')})")
seam = edge(top, middle, line)
rims = [edge(v, v, circle(r, z)) for v, r, z in ((top, RADIUS, HEIGHT), (middle, RADIUS, 0.0), (low, INNER, -ROUND))]
meridian = edge(middle, low, circle(ROUND, 0.0, (0, 1, 0), INNER))
poles = ",".join(point(*p) for p in net)
profile = add(f"B_SPLINE_CURVE_WITH_KNOTS('',6,({poles}),.UNSPECIFIED.,.F.,.F.,(7,7),(0.,1.570796326795),.UNSPECIFIED.)")
axis = add(f"AXIS1_PLACEMENT('',{point(0, 0)},{direction(0, 0, -1)})")
faces = [
    face(add(f"CYLINDRICAL_SURFACE('',{frame(HEIGHT)},{RADIUS:.15g})"), "T", "T", (seam, "T"), (rims[1], "T"), (seam, "F"), (rims[0], "F")),
    face(add(f"SURFACE_OF_REVOLUTION('',{profile},{axis})"), "T", "F", (meridian, "F"), (rims[1], "T"), (meridian, "T"), (rims[2], "F")),
    face(add(f"PLANE('',{frame(HEIGHT)})"), "T", "T", (rims[0], "T")),
    face(add(f"PLANE('',{frame(-ROUND)})"), "F", "F", (rims[2], "T"))]
shell = add(f"CLOSED_SHELL('',({','.join(faces)}))")
solid = add(f"MANIFOLD_SOLID_BREP('',{shell})")
units = [add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))"), add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))"),
         add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())")]
accuracy = add(f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-7),{units[0]},'distance_accuracy_value','')")
context = add(f"(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({accuracy}))"
              f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({','.join(units)}))REPRESENTATION_CONTEXT('',''))")
shape = add(f"ADVANCED_BREP_SHAPE_REPRESENTATION('',({frame(0.0)},{solid}),{context})")
design = add("APPLICATION_CONTEXT('automotive design')")
product = add(f"PRODUCT('pin','pin','',({add(f'''PRODUCT_CONTEXT('',{design},'mechanical')''')}))")
version = add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
stage = add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{design},'design')")
definition = add(f"PRODUCT_DEFINITION('design','',{version},{stage})")
add(f"SHAPE_DEFINITION_REPRESENTATION({add(f'''PRODUCT_DEFINITION_SHAPE('','',{definition})''')},{shape})")
with open(f"pin{sys.argv[1]}.step", "w", encoding="ascii") as file:
    file.write("ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('pin','2026-11-27T00:00:00',(''),(''),'','','');\n"
               "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n" + "\n".join(records) +
               "\nENDSEC;\nEND-ISO-10303-21;\n")
# Discs between neighbouring points of the spline as truncated cones.
count = 20000
weights = [1, 6, 15, 20, 15, 6, 1]
curve = [[sum(w * p[d] * (k / count) ** i * (1 - k / count) ** (6 - i) for i, (w, p) in enumerate(zip(weights, net))) for d in (0, 1)]
         for k in range(count + 1)]
below = sum((p[0] ** 2 + p[0] * q[0] + q[0] ** 2) / 3 * (p[1] - q[1]) for p, q in zip(curve, curve[1:]))
print(repr(math.pi * (RADIUS ** 2 * HEIGHT + below)))
END
cat >volume.cxx <<'END'
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Version.hxx>

#include <cmath>
#include <cstdio>
#include <cstdlib>

int main(int, char* argv[])
{
  // Pairs of a file and its volume.
  double off[2];
  for (int i = 0; i < 2; ++i)
  {
    STEPControl_Reader reader;
    if (reader.ReadFile(argv[2 * i + 1]) != IFSelect_RetDone || reader.TransferRoots() != 1)
    {
      return 2;
    }
    GProp_GProps properties;
    BRepGProp::VolumeProperties(reader.OneShape(), properties, 1e-9);
    const double exact = std::atof(argv[2 * i + 2]);
    off[i] = properties.Mass() / exact - 1.0;
    std::printf("OpenCASCADE %s, %s: volume %.6f, exact %.6f, off by %.1e\n", OCC_VERSION_COMPLETE, argv[2 * i + 1], properties.Mass(),
      exact, off[i]);
  }
  return std::fabs(off[0]) < 1e-6 && off[1] > 0.05 ? 0 : 1;
}
END
libraries=root/usr/lib/x86_64-linux-gnu
g++ -std=c++17 -O1 -w -I root/usr/include/opencascade volume.cxx -o volume -L "$libraries" -lTKSTEP -lTKXSBase -lTKTopAlgo -lTKBRep -lTKG3d -lTKMath \
  -lTKernel -Wl,-rpath-link,"$libraries:/usr/lib/x86_64-linux-gnu"
large=$(python3 pin.py 1)
small=$(python3 pin.py 0.1)
LD_LIBRARY_PATH=$libraries ./volume pin1.step "$large" pin0.1.step "$small" | grep OpenCASCADE
LD_LIBRARY_PATH=$libraries ./volume pin1.step "$large" pin0.1.step "$small" >/dev/null
