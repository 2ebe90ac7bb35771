#!/bin/sh
# Debian packages of the last commit: builds them in a bare Debian, installs them on another one with apt,
# uses what they bring, and removes them without a trace.
#   sudo sh Testing/packages.sh SUITE [build | check]      for example: sudo sh Testing/packages.sh trixie
# SUITE, root and disk as in Testing/debian.sh, which makes the systems: that of SOLIDMOMENTS_DEBIAN for
# building, and one with `-packages` after its name. The packages are left in build-packages-SUITE/ (or the
# folder that SOLIDMOMENTS_PACKAGES names); `build` only makes them, `check` only tries those that are there.
set -eu
project=$(cd "$(dirname "$0")/.." && pwd)

build_here() {
  log=$project/build-package.log
  : >"$log"
  . "$project/Examples/install-packages.sh"
  solidmoments_install "$log"
  solidmoments_step "$log" "Installing what cpack needs" apt-get install -y --no-install-recommends dpkg-dev file
  cd "$project"
  solidmoments_step "$log" "Configuring" cmake --preset package
  solidmoments_step "$log" "Building" cmake --build build-package --parallel "${SOLIDMOMENTS_JOBS:-$(nproc)}"
  rm -f build-package/*.deb
  solidmoments_step "$log" "Packing" cmake -E chdir build-package cpack
}

expect() { # TITLE COMMAND...
  title=$1
  shift
  if "$@" >/tmp/packages.out 2>&1; then
    echo "ok: $title"
  else
    cat /tmp/packages.out >&2
    echo "failed: $title" >&2
    exit 1
  fi
}

has_volume() { # VOLUME COMMAND...: the sample part's volume, to ten digits, is in what the command prints
  volume=$1
  shift
  "$@" >/tmp/packages.volume 2>&1 || { cat /tmp/packages.volume; return 1; }
  cat /tmp/packages.volume
  grep -qF "$volume" /tmp/packages.volume
}

leaves_nothing() {
  ! dpkg-query -W '*solidmoments*' 2>/dev/null | grep . &&
    ! find / -xdev \( -path /home -o -path /tmp -o -path /proc -o -path /root \) -prune -o \
      \( -iname '*solidmoments*' -o -name 'libsm[A-Z]*' -o -path /usr/bin/paraview.conf -o -path /usr/share/paraview/plugins \) -print | grep .
}

has_no_static_libraries() {
  ! dpkg-query -L libsolidmoments libsolidmoments-dev paraview-solidmoments python3-solidmoments | grep '\.a$'
}

check_here() {
  cd "$project"
  part=$project/Examples/Models/sample_part.step
  volume=43985.98364
  expect "apt installs a compiler" sh -c 'apt-get update && apt-get install -y --no-install-recommends g++ cmake make'

  expect "apt installs the packages" sh -c 'apt-get install -y --no-install-recommends ./packages/*.deb'
  expect "no static libraries" has_no_static_libraries
  expect "solidmoments and the sample part" has_volume "$volume" solidmoments "$part"
  expect "edit_part" edit_part --help
  expect "solidmoments-kernel" test -x /usr/bin/solidmoments-kernel
  for file in man/man1/solidmoments.1.gz man/man1/edit_part.1.gz bash-completion/completions/solidmoments \
    solidmoments/free_form_part.step doc/solidmoments/copyright doc/paraview-solidmoments/copyright \
    doc/solidmoments/Documentation/UserGuide.md; do
    expect "/usr/share/$file" test -s "/usr/share/$file"
  done
  expect "python3" has_volume "$volume" python3 Examples/Python/volume.py "$part"
  cat >/tmp/packages.py <<END
from paraview.simple import *
mass = MassProperties(Input=OpenDataFile("$part"))
print(servermanager.Fetch(mass, idx=0).GetFieldData().GetArray("Volume").GetValue(0))
END
  expect "pvpython finds the plugin by itself" has_volume "$volume" pvpython /tmp/packages.py
  expect "a program of one's own is built" sh -c 'rm -rf /tmp/consumer && cmake -S Examples/Consumer -B /tmp/consumer &&
    cmake --build /tmp/consumer'
  expect "it runs" has_volume "$volume" /tmp/consumer/consumer "$part"

  expect "apt removes the packages" apt-get purge -y --autoremove \
    libsolidmoments libsolidmoments-dev python3-solidmoments solidmoments paraview-solidmoments
  expect "nothing is left" leaves_nothing
}

case ${1:-} in
  build-here) build_here ;;
  check-here) check_here ;;
  '' | -*)
    sed -n 2,7p "$0" >&2
    exit 1
    ;;
  *)
    suite=$1
    system=${SOLIDMOMENTS_DEBIAN:-$project/build-debian-$suite}
    packages=${SOLIDMOMENTS_PACKAGES:-$project/build-packages-$suite}
    if [ "${2:-build}" = build ]; then
      SOLIDMOMENTS_DEBIAN=$system sh "$project/Testing/debian.sh" "$suite" sh Testing/packages.sh build-here
      mkdir -p "$packages"
      rm -f "$packages"/*.deb
      cp "$system"/home/user/project/build-package/*.deb "$packages"
      ls -l "$packages"
    fi
    if [ "${2:-check}" = check ]; then
      bare=$system-packages
      SOLIDMOMENTS_DEBIAN=$bare sh "$project/Testing/debian.sh" "$suite" true
      rm -rf "$bare/home/user/project/packages"
      cp -r "$packages" "$bare/home/user/project/packages"
      SOLIDMOMENTS_DEBIAN=$bare sh "$project/Testing/debian.sh" "$suite" sh Testing/packages.sh check-here
    fi
    ;;
esac
