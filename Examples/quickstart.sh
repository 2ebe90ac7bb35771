#!/bin/sh
# From a fresh Debian 12, 13 or testing to the mass properties of a part:
#   sh Examples/quickstart.sh [FILE.step]
# Installs what is missing, builds in build/, prints volume, area, centre of mass and inertia of the file (by
# default of a sample part) and draws it in build/quickstart.png. Needs no display and no GPU.
# SOLIDMOMENTS_JOBS sets the number of parallel compilations. The exit status is that of solidmoments, 1 when
# something before it fails.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
file=${1:-$root/Examples/Models/sample_part.step}
jobs=${SOLIDMOMENTS_JOBS:-$(nproc 2>/dev/null || echo 2)}
build=$root/build
log=$build/quickstart.log

if [ ! -r "$file" ]; then
  echo "quickstart: $file cannot be read" >&2
  exit 1
fi
mkdir -p "$build"
: >"$log"
. "$root/Examples/install-packages.sh"

solidmoments_install "$log"
solidmoments_step "$log" "Configuring" cmake -S "$root" -B "$build" -G Ninja \
  -DCMAKE_BUILD_TYPE=Release -DSOLIDMOMENTS_BUILD_TESTING=OFF -DSOLIDMOMENTS_BUILD_EXAMPLES=ON
solidmoments_step "$log" "Building with $jobs jobs (a few minutes)" cmake --build "$build" --parallel "$jobs"

echo
rm -f "$build/quickstart.png"
status=0
"$build/bin/solidmoments" "$file" --png "$build/quickstart.png" || status=$?
echo
if [ -f "$build/quickstart.png" ]; then
  echo "The picture is in $build/quickstart.png"
fi
echo "The program is $build/bin/solidmoments; try it with --help."
exit "$status"
