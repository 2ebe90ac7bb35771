#!/bin/sh
# gmsh 4.8.4 with OpenCASCADE 7.6.3 (Debian 12): instance names of a STEP file (ISO 10303-21: # and digits, of any number) count modulo
# 2^32. A second box whose names are those of the first one plus 2^32 is read as a copy of the first one: volumes 6 and 6 for 6 and 24.
# The reader prints that references are unresolved, and goes on. A box whose names all begin at 2^32 is right, and of one whose names
# begin at 2^31 nothing is read.
# Guess: names above 2^31 are refused, or all digits count.
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
run() {
  LD_LIBRARY_PATH=root/usr/lib/x86_64-linux-gnu root/usr/bin/gmsh -nopopup -0 "$@" 2>&1
}
# box FILE X Y Z
box() {
  printf 'SetFactory("OpenCASCADE");\nBox(1) = {0, 0, 0, %s, %s, %s};\n' "$2" "$3" "$4" >box.geo
  run box.geo -o "$1" >/dev/null
}
# join FILE OFFSET: the first box, and the second one with an offset of its names; with one argument less the first one alone, moved.
join() {
  python3 - "$@" <<'END'
import re
import sys


def read(path, offset):
    head, data = open(path).read().split("DATA;", 1)
    data, tail = data.split("ENDSEC;", 1)
    return head + "DATA;", re.sub(r"#(\d+)", lambda name: f"#{int(name.group(1)) + offset}", data), "ENDSEC;" + tail


path, offset, both = sys.argv[1], int(sys.argv[2]), sys.argv[3] == "both"
head, first, tail = read("first.step", 0 if both else offset)
open(path, "w").write(head + first + (read("second.step", offset)[1] if both else "") + tail)
END
}
# volumes FILE
volumes() {
  printf 'SetFactory("OpenCASCADE");\nv() = ShapeFromFile("%s");\nFor i In {0:#v()-1}\n  m = Mass Volume{v(i)};\n  Printf("volume %%g", m);\nEndFor\n' \
    "$1" >read.geo
  run read.geo | grep -o "volume .*\|Unresolved Reference" | tr '\n' ' '
}
box first.step 1 2 3
box second.step 2 3 4
join near.step 1000 both
join far.step 4294967296 both
join all32.step 4294967296 alone
join all31.step 2147483648 alone
for name in near far all32 all31; do
  echo "$name: $(volumes $name.step)"
done | tee seen
echo "gmsh $(run --version)"
cat >expected <<'END'
near: volume 6 volume 24 
far: Unresolved Reference volume 6 volume 6 
all32: volume 6 
all31: 
END
cmp seen expected
