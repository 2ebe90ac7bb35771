#!/bin/sh
# cycles.sh BUILD [CYCLES]: counts OpenGL objects, memory, threads and open files over CYCLES (1000) runs of a
# pipeline, in C++ and in ParaView, on a virtual display. CTest runs the same with fewer cycles where one
# takes long; this takes half an hour. The counts are printed; the exit status is 1 where something grows or
# an OpenGL error is pending.
set -u
if [ "$#" -lt 1 ]; then
  echo "usage: cycles.sh BUILD [CYCLES]" >&2
  exit 1
fi
build=$(cd "$1" && pwd) || exit 1
cycles=${2:-1000}
here=$(cd "$(dirname "$0")" && pwd)
solids=$build/Testing/solids
plugin=$(echo "$build"/lib/paraview-*/plugins/SolidMoments/SolidMoments.so)
status=0

count() { # COMMAND...
  echo
  echo "== $*"
  xvfb-run -a -s "-noreset -screen 0 1280x1024x24" "$@" > "$build/cycles.log" 2>&1
  ended=$?
  grep -E "^after|^FAIL|bytes a cycle|limit" "$build/cycles.log"
  if [ "$ended" -ne 0 ]; then
    echo "it ended with $ended; see $build/cycles.log" >&2
    exit 1
  fi
}

for context in own shared; do
  for mode in edit open window; do
    (count "$build/bin/FiltersMassPropertiesTests" TestApplyCycles "$mode" "$context" "$solids" "$cycles") || status=1
  done
done
PYTHONPATH=$(echo "$build"/lib/python3*/site-packages)
export PYTHONPATH
(count pvpython "$here/ParaViewPlugin/TestPluginApplyCycles.py" "$plugin" "$here/../Examples/Models/sample_part.step" "$cycles") || status=1
(count pvpython "$here/ParaViewPlugin/TestPluginCycles.py" "$plugin" "$solids/slanted_hole-moved.step" "$cycles" brief) || status=1
exit "$status"
