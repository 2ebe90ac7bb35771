#!/bin/sh
# Makes the paper's parts, draws all figures and draws up the table:
#   sh Examples/Paper/regenerate.sh [--build DIR] [--folder [TITLE=]DIR]... [--docs] OUTDIR
# OUTDIR gets parts/ (STEP), figures/ (PNG, SVG, CSV) and table.md, table.csv. --folder adds a table of the
# STEP files in a folder, with a reference.jsonl next to them if there is one. --build: where the programs are
# built, or are already (default build/ of this tree); what they need is what Examples/quickstart.sh installs.
# Needs no display and no GPU. SOLIDMOMENTS_JOBS sets the number of parallel compilations. --docs writes
# pictures, numbers and tables into this folder's page as well, and with --folder "Real files=DIR" into
# real_files.md; the sentences about them are to be read again then.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$root/build
output=
docs=
count=0
usage() {
  sed -n '2,9s/^# \{0,1\}//p' "$0" >&2
  exit 1
}
# The folders stay in "$@": names may hold spaces.
total=$#
while [ "$count" -lt "$total" ]; do
  argument=$1
  shift
  count=$((count + 1))
  case $argument in
    --build | --folder)
      if [ "$count" -ge "$total" ]; then
        usage
      fi
      if [ "$argument" = --build ]; then
        build=$1
      else
        set -- "$@" "$1"
      fi
      shift
      count=$((count + 1))
      ;;
    --docs) docs=yes ;;
    -*) usage ;;
    *)
      if [ -n "$output" ]; then
        usage
      fi
      output=$argument
      ;;
  esac
done
if [ -z "$output" ]; then
  usage
fi

if [ -f "$build/CMakeCache.txt" ]; then
  cmake -DSOLIDMOMENTS_BUILD_PAPER=ON "$build"
else
  cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DSOLIDMOMENTS_BUILD_TESTING=OFF -DSOLIDMOMENTS_BUILD_PAPER=ON
fi
jobs=${SOLIDMOMENTS_JOBS:-$(nproc 2>/dev/null || echo 2)}
cmake --build "$build" --parallel "$jobs" --target solidmoments make_paper_parts occt_mass_properties paper_figures
mkdir -p "$output"
"$build/bin/make_paper_parts" "$output/parts"
"$build/bin/paper_figures" "$output/figures" --part "$output/parts/free_form.step" \
  --model "$output/parts/propeller.step" --model "$output/parts/crank.step" --model "$output/parts/engine_block.step" \
  --model "$output/parts/gear_train.step" --model "$output/parts/free_form.step" --model "$output/parts/trefoil_tube.step"
python3 "$root/Examples/Paper/draw_figures.py" "$output/figures"
python3 "$root/Examples/Paper/table.py" --program "$build/bin/solidmoments" \
  --occt "$build/bin/occt_mass_properties" --markdown "$output/table.md" --csv "$output/table.csv" \
  "The parts=$output/parts" "$@"
echo "The figures are in $output/figures, the table in $output/table.md and table.csv"
if [ -n "$docs" ]; then
  python3 "$root/Examples/Paper/write_docs.py" "$output"
  echo "They are in $root/Examples/Paper/README.md and images/ as well"
fi
