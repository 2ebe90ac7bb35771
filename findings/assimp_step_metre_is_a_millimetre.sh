#!/bin/sh
# assimp 5.2.5 (Debian 12), `assimp export cube.obj cube.stp`: the length unit of the STEP file is called METRE and is one millimetre, and
# the closed shell of a cube has four edges for each face, none of which two faces share.
# Guess: a unit called METRE is a metre (SI_UNIT($,.METRE.)), and a closed shell of a cube has 12 edges.
# Seen: CONVERSION_BASED_UNIT('METRE') of 1.0 SI_UNIT(.MILLI.,.METRE.), and 24 EDGE_CURVEs in one CLOSED_SHELL. Readers that go by the name
# and readers that go by the factor differ by 1000, and to no reader that goes by the edges is the shell closed.
# Needs: apt-get of Debian 12. Installs nothing; fails if the behaviour or the version changes.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq assimp-utils=5.2.5~ds0-1+b1 libassimp5=5.2.5~ds0-1+b1 libdraco7=1.5.5+dfsg-2 libminizip1=1.1-8+deb12u1 2>/dev/null
for package in *.deb; do
  dpkg -x "$package" root
done
cat >cube.obj <<'END'
v 0 0 0
v 2 0 0
v 2 3 0
v 0 3 0
v 0 0 4
v 2 0 4
v 2 3 4
v 0 3 4
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
END
LD_LIBRARY_PATH=root/usr/lib/x86_64-linux-gnu root/usr/bin/assimp export cube.obj cube.stp >log
LD_LIBRARY_PATH=root/usr/lib/x86_64-linux-gnu root/usr/bin/assimp version | grep Version
unit=$(grep -o "^#[0-9]*=.*CONVERSION_BASED_UNIT('METRE',#[0-9]*)LENGTH_UNIT" cube.stp | grep -o "METRE',#[0-9]*" | grep -o '[0-9]*$')
measure=$(grep "^#$unit=" cube.stp)
base=$(grep "^#$(echo "$measure" | grep -o '#[0-9]*)' | tail -n 1 | grep -o '[0-9]*')=" cube.stp)
edges=$(grep -c "EDGE_CURVE(" cube.stp)
shells=$(grep -c "=CLOSED_SHELL(" cube.stp)
echo "METRE is $measure of $base; $edges edge curves in $shells closed shell"
case "$measure" in *"LENGTH_MEASURE(1.0)"*) ;; *) exit 1 ;; esac
case "$base" in *"SI_UNIT(.MILLI.,.METRE.)"*) ;; *) exit 1 ;; esac
test "$edges" -eq 24 && test "$shells" -eq 1
