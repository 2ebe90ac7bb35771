#!/bin/sh
# Checks layout and words of the sources and the subjects of commits, and runs the tests with sanitizers:
#   sh Testing/check.sh [format | words | subjects [RANGE] | sanitizers [ctest arguments]]
# Without an argument: all of them, one after the other. `format` needs clang-format 14, or the one that
# CLANG_FORMAT names. `subjects` checks the commits of a RANGE of git (default: the last 20). `sanitizers`
# builds the preset `asan` in build-asan/, with SOLIDMOMENTS_JOBS compilations at a time. The exit status is
# not 0 where something is found.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
jobs=${SOLIDMOMENTS_JOBS:-$(nproc 2>/dev/null || echo 2)}
cd "$root"

check_format() {
  formatter=${CLANG_FORMAT:-clang-format}
  if ! "$formatter" --version | grep -q "version 14\."; then
    echo "The layout is that of clang-format 14; CLANG_FORMAT names another program: $formatter" >&2
    return 1
  fi
  find Examples Filters ParaViewPlugin Readers Rendering Testing -name '*.h' -o -name '*.cxx' |
    xargs "$formatter" --dry-run --Werror
}

check_words() {
  python3 -B Testing/Programs/CheckLanguage.py
}

# Subjects begin with a capital letter, have no full stop at the end, and at most 72 characters.
check_subjects() {
  git log --no-merges --format='%h %s' ${1:-"-20"} | awk '
    { subject = substr($0, index($0, " ") + 1) }
    length(subject) > 72 { print $0 ": " length(subject) " characters, at most 72"; found = 1 }
    subject !~ /^[A-Z]/ || subject ~ /\.$/ { print $0 ": a capital letter first, no full stop at the end"; found = 1 }
    END { exit found }'
}

check_sanitizers() {
  cmake --preset asan
  cmake --build --preset asan --parallel "$jobs"
  ctest --preset asan --parallel "$jobs" "$@"
}

case ${1:-all} in
  format | words | subjects | sanitizers)
    check=$1
    shift
    "check_$check" "$@"
    ;;
  all)
    check_format
    check_words
    check_subjects
    check_sanitizers
    ;;
  *)
    sed -n 2,7p "$0" >&2
    exit 1
    ;;
esac
