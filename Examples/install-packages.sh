# Installs the packages with which SolidMoments is built and tested on Debian 12, 13 and testing. To be
# sourced, POSIX sh:
#   solidmoments_packages                      prints the names
#   solidmoments_library_packages              prints those that a program that links SolidMoments needs, too
#   solidmoments_install LOG                   installs those that are missing; says what it does
#   solidmoments_step LOG TITLE COMMAND...     runs a command quietly; on failure shows the end of the log and
#                                              exits

solidmoments_library_packages() {
  # ParaView's VTK and what its CMake files ask for
  echo paraview paraview-dev python3-paraview python3-dev libglew-dev libegl-dev libopengl-dev libgl-dev
  echo libx11-dev libdouble-conversion-dev libopenmpi-dev liblz4-dev liblzma-dev libexpat1-dev libpng-dev
  echo libjpeg-dev libtiff-dev libfreetype-dev zlib1g-dev libutfcpp-dev
  # OpenCASCADE; its CMake files ask for TBB and fontconfig
  echo libocct-data-exchange-dev libocct-modeling-algorithms-dev libtbb-dev libfontconfig-dev
}

solidmoments_packages() {
  # Compiler and build
  echo g++ cmake ninja-build
  solidmoments_library_packages
  # Titles of the table of materials in ParaView's panel; Debian 12's ParaView has Qt 5, newer ones Qt 6, and
  # that of Debian testing uses Debian's VTK
  case $(. /etc/os-release 2>/dev/null && echo "${VERSION_CODENAME:-}") in
    bookworm) echo qtbase5-dev ;;
    trixie) echo qt6-base-dev ;;
    *) echo qt6-base-dev libvtk9-qt-dev ;;
  esac
  # OpenGL on machines without a GPU, and a display for those without one
  echo libgl1-mesa-dri libegl1 xvfb xauth
  # Header libraries
  echo libglm-dev libcli11-dev nlohmann-json3-dev
  # For Testing: a locale with a decimal comma; the paper's figures
  echo locales python3-matplotlib
}

solidmoments_has_tools() {
  command -v cmake >/dev/null 2>&1 && command -v ninja >/dev/null 2>&1 && command -v g++ >/dev/null 2>&1
}

solidmoments_step() {
  _log=$1 _title=$2
  shift 2
  printf '%s ... ' "$_title"
  _status=0
  "$@" >>"$_log" 2>&1 || _status=$?
  if [ "$_status" -eq 0 ]; then
    echo "done"
    return 0
  fi
  echo failed
  tail -n 40 "$_log" >&2
  echo "The whole log is in $_log" >&2
  exit 1
}

solidmoments_install() {
  if ! command -v apt-get >/dev/null 2>&1 || ! command -v dpkg-query >/dev/null 2>&1; then
    echo "This machine has no apt-get. Needed are the equivalents of these Debian packages:" >&2
    solidmoments_packages | fold -s -w 100 >&2
    if solidmoments_has_tools; then
      echo "cmake, ninja and g++ are here; going on with what is installed." >&2
      return 0
    fi
    exit 1
  fi

  _missing=
  for _package in $(solidmoments_packages); do
    case $(dpkg-query -W -f='${db:Status-Abbrev}' "$_package" 2>/dev/null) in
      # The second letter means installed; the first one is "h" for held packages.
      ?i*) ;;
      *) _missing="$_missing $_package" ;;
    esac
  done
  [ -n "$_missing" ] || return 0

  _sudo=
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null 2>&1; then
      echo "Packages are missing, and installing them needs root or sudo. As root, run:" >&2
      echo "  apt-get update && apt-get install --no-install-recommends$_missing" >&2
      if solidmoments_has_tools; then
        echo "cmake, ninja and g++ are here; going on with what is installed." >&2
        return 0
      fi
      exit 1
    fi
    _sudo=sudo
    # Ask for the password here, where it can be seen, and not in the middle of a quiet step.
    sudo -v || exit 1
  fi
  solidmoments_step "$1" "Looking up packages" $_sudo env DEBIAN_FRONTEND=noninteractive apt-get update
  # shellcheck disable=SC2086
  solidmoments_step "$1" "Installing $(echo $_missing | wc -w) packages (a few minutes)" \
    $_sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $_missing
}
