#!/bin/sh
# Installs what is missing, builds in build-dev/ with warnings as errors, and runs all tests:
#   sh Testing/run.sh [ctest arguments, for example -R Sphere]
# Needs no display and no GPU. SOLIDMOMENTS_JOBS sets the number of parallel compilations; one test more runs
# at a time. What ctest says comes last; the exit status is its own.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
jobs=${SOLIDMOMENTS_JOBS:-$(nproc 2>/dev/null || echo 2)}
build=$root/build-dev
log=$build/run.log

mkdir -p "$build"
: >"$log"
. "$root/Examples/install-packages.sh"

solidmoments_install "$log"
cd "$root"
solidmoments_step "$log" "Configuring" cmake --preset dev
solidmoments_step "$log" "Building with $jobs jobs (a few minutes)" cmake --build "$build" --parallel "$jobs"
echo
cd "$build"
# Some tests wait for programs that they start.
exec ctest --output-on-failure --parallel "$((jobs + 1))" "$@"
