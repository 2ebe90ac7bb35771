#!/bin/sh
# gmsh 4.8.4 with OpenCASCADE 7.6.3 (Debian 12): a body that a STEP file places by a mapped item with a scale of 2.5, or with a
# reflection of y, is read at its own size, and rotated by half a turn about x instead of reflected, without a message.
# Guess: a reader of STEP applies the operator (CARTESIAN_TRANSFORMATION_OPERATOR_3D; ISO 10303-42, base_axis: an omitted third axis
# is z), or refuses it.
# Seen: the box of 1 x 2 x 3 ends at (1, 2, 3) for (2.5, 5, 7.5); reflected it reaches from z = -3 to 0 for 0 to 3.
# Needs: apt-get of Debian 12. Installs nothing; fails if the behaviour or the version changes.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
occt="foundation modeling-data modeling-algorithms data-exchange ocaf visualization"
apt-get download -qq gmsh=4.8.4+ds2-3 libgmsh4.8=4.8.4+ds2-3 libalglib3.19 libfltk-gl1.3 libfltk-images1.3 libfltk1.3 libgl2ps1.4 \
  libmetis5 libvoro++1 libglu1-mesa $(for part in $occt; do echo "libocct-$part-7.6=7.6.3+dfsg1-7"; done) 
for package in *.deb; do
  dpkg -x "$package" root
done
# write FILE OPERATOR: a box that the mapped item #90 places by an operator of the parameters given.
write() {
  python3 - "$1" "$2" <<'END'
import sys

lines = ["#1=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));", "#2=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));",
         "#3=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());", "#4=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),#1,'','');",
         "#5=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#4))GLOBAL_UNIT_ASSIGNED_CONTEXT((#1,#2,#3))"
         "REPRESENTATION_CONTEXT('',''));"]
number = 100


def add(text):
    global number
    number += 1
    lines.append(f"#{number}={text};")
    return f"#{number}"


def triple(kind, values):
    return add(f"{kind}('',({','.join(f'{float(v)}' for v in values)}))")


size = (1, 2, 3)
corners = {(i, j, k): tuple(size[c] * (i, j, k)[c] for c in range(3)) for i in (0, 1) for j in (0, 1) for k in (0, 1)}
vertices = {key: add(f"VERTEX_POINT('',{triple('CARTESIAN_POINT', point)})") for key, point in corners.items()}
edges = {}


def use(a, b):
    if (b, a) in edges:
        return add(f"ORIENTED_EDGE('',*,*,{edges[b, a]},.F.)")
    if (a, b) not in edges:
        along = tuple(q - p for p, q in zip(corners[a], corners[b]))
        line = add(f"LINE('',{triple('CARTESIAN_POINT', corners[a])},{add('VECTOR(' + repr('') + ',' + triple('DIRECTION', along) + ',1.)')})")
        edges[a, b] = add(f"EDGE_CURVE('',{vertices[a]},{vertices[b]},{line},.T.)")
    return add(f"ORIENTED_EDGE('',*,*,{edges[a, b]},.T.)")


faces = []
for axis in range(3):
    for side in (0, 1):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        loop = []
        for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)) if side else ((0, 0), (0, 1), (1, 1), (1, 0)):
            corner = [0, 0, 0]
            corner[axis], corner[u], corner[v] = side, du, dv
            loop.append(tuple(corner))
        bound = add(f"FACE_OUTER_BOUND('',{add('EDGE_LOOP(' + repr('') + ',(' + ','.join(use(loop[i], loop[(i + 1) % 4]) for i in range(4)) + '))')},.T.)")
        normal, along = [0, 0, 0], [0, 0, 0]
        normal[axis], along[u] = 1 if side else -1, 1
        place = add(f"AXIS2_PLACEMENT_3D('',{triple('CARTESIAN_POINT', corners[loop[0]])},{triple('DIRECTION', normal)},{triple('DIRECTION', along)})")
        faces.append(add(f"ADVANCED_FACE('',({bound}),{add('PLANE(' + repr('') + ',' + place + ')')},.T.)"))
solid = add(f"MANIFOLD_SOLID_BREP('',{add('CLOSED_SHELL(' + repr('') + ',(' + ','.join(faces) + '))')})")
origin = add(f"AXIS2_PLACEMENT_3D('',{triple('CARTESIAN_POINT', (0, 0, 0))},$,$)")
shape = add(f"ADVANCED_BREP_SHAPE_REPRESENTATION('',({solid},{origin}),#5)")
down = triple("DIRECTION", (0, -1, 0))
at = triple("CARTESIAN_POINT", (0, 0, 0))
operator = add("CARTESIAN_TRANSFORMATION_OPERATOR_3D('','','',$," + sys.argv[2].replace("DOWN", down).replace("AT", at) + ")")
mapped = add(f"MAPPED_ITEM('',{add(f'REPRESENTATION_MAP({origin},{shape})')},{operator})")
whole = add(f"SHAPE_REPRESENTATION('',({mapped},{origin}),#5)")
context = add("APPLICATION_CONTEXT('automotive design')")
product = add(f"PRODUCT('box','box','',({add(f'PRODUCT_CONTEXT({chr(39)}{chr(39)},{context},{chr(39)}mechanical{chr(39)})')}))")
formation = add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
definition = add(f"PRODUCT_DEFINITION('','',{formation},{add(f'PRODUCT_DEFINITION_CONTEXT({chr(39)}part definition{chr(39)},{context},{chr(39)}design{chr(39)})')})")
add(f"SHAPE_DEFINITION_REPRESENTATION({add(f'PRODUCT_DEFINITION_SHAPE({chr(39)}{chr(39)},{chr(39)}{chr(39)},{definition})')},{whole})")
with open(sys.argv[1], "w") as file:
    file.write("ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
               "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n" + "\n".join(lines) + "\nENDSEC;\nEND-ISO-10303-21;\n")
END
}
write plain.step '$,AT,1.,$'
write scaled.step '$,AT,2.5,$'
write reflected.step 'DOWN,AT,1.,$'
for name in plain scaled reflected; do
  cat >"$name.geo" <<END
SetFactory("OpenCASCADE");
v() = ShapeFromFile("$name.step");
b() = BoundingBox Volume{v(0)};
Printf("$name: box %g %g %g to %g %g %g", b(0), b(1), b(2), b(3), b(4), b(5));
END
  LD_LIBRARY_PATH=root/usr/lib/x86_64-linux-gnu root/usr/bin/gmsh -nopopup -0 "$name.geo" >"$name.log" 2>&1
  grep "Warning\|Error" "$name.log" && exit 1
  sed -i "s/-\{0,1\}1e-07/0/g" "$name.log"
  grep -o "$name: box.*" "$name.log"
done
LD_LIBRARY_PATH=root/usr/lib/x86_64-linux-gnu root/usr/bin/gmsh --version 2>&1
grep -q "plain: box 0 0 0 to 1 2 3" plain.log
grep -q "scaled: box 0 0 0 to 1 2 3" scaled.log
grep -q "reflected: box 0 -2 -3 to 1 0 0" reflected.log
