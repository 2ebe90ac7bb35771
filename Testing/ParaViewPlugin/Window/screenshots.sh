#!/bin/sh
# screenshots.sh BUILD FOLDER: pictures of ParaView's window with the plugin, made on a virtual display and
# written to FOLDER: window_main.png (a part and its mass properties), window_table.png (an assembly, rows of
# its table selected), window_parts.png (its parts list), window_volume.png (its solids coloured by volume),
# window_flagged.png (an open solid), window_materials.png (the table of materials in the panel, and labels).
# With a scene (main, table, parts, volume, flagged, materials) and a STEP file: one picture of that file.
# Needs paraview, xvfb-run, xdotool and ImageMagick's import; BUILD has the plugin and make_paper_parts. Look
# at the pictures: nothing here judges them.
set -eu
if [ "$#" -ne 2 ] && [ "$#" -ne 4 ]; then
  echo "usage: screenshots.sh BUILD FOLDER [SCENE FILE.step]" >&2
  exit 1
fi
build=$(cd "$1" && pwd)
mkdir -p "$2"
folder=$(cd "$2" && pwd)
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$build/bin/make_paper_parts" "$work" gear_train > /dev/null

grab() { # SCENE FILE.step
  rm -f "$work/ready" "$work/events.xml"
  events=
  if [ -e "$here/screenshots_$1.xml" ]; then
    # Without blanks in its path, whatever that of the tree is.
    cp "$here/screenshots_$1.xml" "$work/events.xml"
    events=--test-script=$work/events.xml
  fi
  SM_SCENE=$1 SM_FILE=$2 SM_READY=$work/ready HOME=$work PYTHONPATH=$here/../../Support QT_QPA_PLATFORM=xcb xvfb-run -a \
    -s "-noreset -screen 0 1440x900x24" sh -c '
      paraview --dr --plugin-search-paths="$1" --plugins=SolidMoments --script="$2" $4 > "$3/log" 2>&1 &
      window=$!
      tries=0
      until [ -e "$3/ready" ] || [ "$tries" -ge 300 ]; do sleep 1; tries=$((tries + 1)); done
      # The window shows changes with a delay: wait until two pictures are the same.
      settle() {
        import -window root "$3/before.png"
        while sleep 3; do
          import -window root "$3/after.png"
          if cmp -s "$3/before.png" "$3/after.png"; then break; fi
          mv "$3/after.png" "$3/before.png"
        done
      }
      settle "$@"
      if [ "$5" = materials ]; then
        # The borders of the panel, which no event of ParaView moves: wider, and higher.
        xdotool mousemove 294 420 sleep 3 mousedown 1 sleep 3 mousemove 400 420 sleep 3 mousemove 520 420 sleep 3 \
          mousemove 521 420 sleep 5 mouseup 1
        settle "$@"
        xdotool mousemove 150 352 sleep 3 mousedown 1 sleep 3 mousemove 150 300 sleep 3 mousemove 150 240 sleep 5 mouseup 1
        settle "$@"
      fi
      kill "$window"
      wait "$window" 2> /dev/null || true
    ' sh "$(echo "$build"/lib/paraview-*/plugins/SolidMoments)" "$here/screenshots.py" "$work" "$events" "$1"
  if [ ! -e "$work/ready" ]; then
    cat "$work/log" >&2
    exit 1
  fi
  # 256 colours are enough for a window, and a third of the bytes. Nothing of the screen around the window.
  convert "$work/after.png" -trim +repage +dither -colors 256 -define png:compression-filter=0 "PNG8:$folder/window_$1.png"
  echo "$folder/window_$1.png"
}

if [ "$#" -eq 4 ]; then
  grab "$3" "$4"
  exit
fi
grab main "$here/../../../Examples/Models/sample_part.step"
grab table "$work/gear_train.step"
grab parts "$work/gear_train.step"
grab volume "$work/gear_train.step"
grab materials "$work/gear_train.step"
grab flagged "$build/Testing/solids/open_solid.step"
