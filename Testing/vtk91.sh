#!/bin/sh
# Builds the tree, without the plugin, against Debian's plain VTK 9.1 and runs the tests with it:
#   sh Testing/vtk91.sh [ctest arguments, for example -R Sphere]
# libvtk9-dev and python3-paraview exclude each other on one system: VTK 9.1 is only unpacked, into
# build-vtk91-root/ or the folder that SOLIDMOMENTS_VTK91 names, which needs no root. What lies there already
# is used again. The build folder is build-vtk91/. SOLIDMOMENTS_JOBS sets the number of parallel compilations
# and tests. What ctest says comes last; the exit status is its own.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
jobs=${SOLIDMOMENTS_JOBS:-$(nproc 2>/dev/null || echo 2)}
build=$root/build-vtk91
log=$build/run.log
prefix=${SOLIDMOMENTS_VTK91:-$root/build-vtk91-root}
# VTK's CMake files ask for its Qt and Java libraries and its programs, too, and for the headers of jsoncpp.
vtk_packages="libvtk9-dev libvtk9.1 libvtk9.1-qt libvtk9-java vtk9 python3-vtk9 libjsoncpp-dev libjsoncpp25"

vtk_libraries() {
  for _cmake in "$prefix"/usr/lib/*/cmake/vtk-9.1; do
    echo "${_cmake%/cmake/*}"
  done
}

is_unpacked() {
  [ -e "$prefix/usr/share/doc/$1" ] || [ -L "$prefix/usr/share/doc/$1" ]
}

has_file() {
  set -- "$packages/${1}"_*.deb
  [ -e "$1" ]
}

# download PACKAGE...: into $packages, by the system's lists, or by lists of our own where those are missing
# or old.
download() {
  command -v apt-get >/dev/null 2>&1 || {
    echo "This machine has no apt-get. Build against a VTK 9.1 of your own: configure with" >&2
    echo "-DSOLIDMOMENTS_BUILD_PARAVIEW_PLUGIN=OFF -DVTK_DIR=..., or put Debian's files where SOLIDMOMENTS_VTK91 says." >&2
    return 1
  }
  rm -rf "$packages/incoming"
  mkdir -p "$packages/incoming" "$packages/lists/partial" "$packages/cache/archives/partial"
  cd "$packages/incoming"
  _lists="-o Dir::State::Lists=../lists -o Dir::Cache=../cache"
  # shellcheck disable=SC2086
  apt-get download "$@" || { apt-get $_lists update && apt-get $_lists download "$@"; } || {
    echo "These packages cannot be downloaded: no network, or not Debian 12. Elsewhere, on Debian 12, run" >&2
    echo "  apt-get download $*" >&2
    echo "and bring the files to $packages" >&2
    return 1
  }
  mv ./*.deb "$packages"
}

# unpack PACKAGE...: into $prefix those that are not there.
unpack() {
  _absent=
  for _package in "$@"; do
    is_unpacked "$_package" || has_file "$_package" || _absent="$_absent $_package"
  done
  if [ -n "$_absent" ]; then
    # shellcheck disable=SC2086
    (download $_absent) || return 1
  fi
  for _package in "$@"; do
    is_unpacked "$_package" || dpkg-deb -x "$packages/${_package}"_*.deb "$prefix" || {
      echo "Unpacking $_package failed. Delete its file in $packages and start again." >&2
      return 1
    }
  done
}

# The shared libraries that VTK's own, the Java ones apart, do not find.
missing_libraries() {
  find "$prefix/usr/lib" ! -name '*Java.so' \( -name 'libvtk*.so' -o -path '*/vtkmodules/*.so' \) -exec ldd {} + 2>/dev/null |
    sed -n 's/^[[:space:]]*\(.*\) => not found$/\1/p' | sort -u
}

# The packages that those with VTK's libraries depend on and that are neither installed nor unpacked.
missing_packages() {
  for _file in "$packages"/*.deb; do
    case $_file in
      *-dev_* | *-java_*) ;;
      *) dpkg-deb -f "$_file" Depends | tr ',' '\n' ;;
    esac
  done | sed 's/[|(:].*//; s/[[:space:]]//g' | sort -u | while read -r _package; do
    is_unpacked "$_package" && continue
    case $(dpkg-query -W -f='${db:Status-Abbrev}' "$_package" 2>/dev/null) in
      ?i*) ;;
      *) echo "$_package" ;;
    esac
  done
}

# VTK, and the libraries it needs that the system does not have.
unpack_vtk() {
  # shellcheck disable=SC2086
  unpack $vtk_packages || return 1
  LD_LIBRARY_PATH=$(vtk_libraries)${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
  export LD_LIBRARY_PATH
  while _libraries=$(missing_libraries) && [ -n "$_libraries" ]; do
    _packages=$(missing_packages)
    if [ -z "$_packages" ]; then
      echo "VTK 9.1 needs these libraries, and no package that it depends on holds them: install them." >&2
      echo "$_libraries" >&2
      return 1
    fi
    # shellcheck disable=SC2086
    unpack $_packages || return 1
  done
}

mkdir -p "$build" "$prefix"
prefix=$(cd "$prefix" && pwd)
packages=$prefix/packages
: >"$log"
. "$root/Examples/install-packages.sh"

solidmoments_install "$log"
solidmoments_step "$log" "Unpacking VTK 9.1 in $prefix" unpack_vtk
cd "$root"
# Presets know nothing of this build: it is the one for development, in a folder of its own and with another
# VTK.
solidmoments_step "$log" "Configuring" cmake --preset dev -B "$build" \
  -DSOLIDMOMENTS_BUILD_PARAVIEW_PLUGIN=OFF -DVTK_DIR="$(vtk_libraries)/cmake/vtk-9.1"
solidmoments_step "$log" "Building with $jobs jobs (a few minutes)" cmake --build "$build" --parallel "$jobs"
echo
cd "$build"
exec ctest --output-on-failure --parallel "$jobs" "$@"
