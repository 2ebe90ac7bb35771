#!/bin/sh
# FreeCAD 0.20.2 (Debian 12): a link at half size to an assembly whose part has a place of its own is exported to STEP at full size, and
# without that place, without a message. A link at its own size is exported as FreeCAD shows it.
# Guess: the file has the volume and the centre that FreeCAD states for the link, or the export refuses it.
# Seen: FreeCAD states 125 mm^3 with the centre at x = 122.5, the file has 1000 mm^3 at x = 105.
# Needs: apt-get of Debian 12, python3. Installs nothing; fails if the behaviour or the version changes.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=0.20.2+dfsg1-4+deb12u1
# The packages that this machine lacks; nothing is installed.
apt-get install -s --no-install-recommends "freecad-python3=$version" "libfreecad-python3-0.20=$version" 2>/dev/null | sed -n 's/^Inst \([^ ]*\) .*/\1/p' >missing
test ! -s missing || xargs apt-get download -qq <missing 2>/dev/null
for package in *.deb; do
  test ! -f "$package" || dpkg -x "$package" root
done
cat >link.py <<'END'
import FreeCAD
import Import
import Part

results = []
for scale in (1.0, 0.5):
    document = FreeCAD.newDocument()
    box = document.addObject("Part::Box", "Box")
    inner, outer, whole = (document.addObject("App::Part", name) for name in ("Inner", "Outer", "Whole"))
    inner.addObject(box)
    inner.Placement.Base.x = 40.0
    outer.addObject(inner)
    link = document.addObject("App::Link", "Link")
    link.LinkedObject = outer
    link.Placement.Base.x = 100.0
    link.Scale = scale
    whole.addObject(link)
    document.recompute()
    Import.export([whole], "link.step")
    read = Part.Shape()
    read.read("link.step")
    for where, shape in (("FreeCAD", Part.getShape(link)), ("its file", read)):
        results.append((round(shape.Volume, 6), round(shape.CenterOfGravity.x, 6)))
        print("FreeCAD", ".".join(FreeCAD.Version()[:3]), "link at scale", scale, "in", where, "volume and x of the centre", results[-1])
raise SystemExit(results != [(1000.0, 145.0), (1000.0, 145.0), (125.0, 122.5), (1000.0, 105.0)])
END
libraries=$folder/root/usr/lib
export LD_LIBRARY_PATH="$libraries/x86_64-linux-gnu:$libraries/freecad-python3/lib:/usr/lib/freecad-python3/lib" QT_QPA_PLATFORM=offscreen HOME="$folder"
export PYTHONPATH="$libraries/freecad-python3/lib:/usr/lib/freecad-python3/lib:$libraries/python3/dist-packages"
/usr/bin/python3 link.py >log 2>&1 || { cat log; exit 1; }
grep '^FreeCAD .* link' log
