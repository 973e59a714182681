#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# reuse_object.sh BUILD COMMAND...: a compiler's launcher in a project that holds torsor as its folder torsor/. It takes
# the objects of the generator from torsor's own build, which compiled the same files; all else, and the floor geometry
# as a sample of the generator, is compiled as the project says.
set -euo pipefail
build="$1"
shift
object="" dependencies="" previous=""
for argument in "$@"; do
  case "$previous" in
    -o) object="$argument" ;;
    -MF) dependencies="$argument" ;;
  esac
  previous="$argument"
done
compiled="$build/${object#torsor/}"
case "$object" in
  *geometry*) ;;
  torsor/generator/CMakeFiles/*.cxx.o | torsor/generator/CMakeFiles/*.cpp.o)
    if [ -f "$compiled" ] && [ -n "$dependencies" ]; then
      cp "$compiled" "$object"
      printf '%s:\n' "$object" > "$dependencies"
      exit 0
    fi
    ;;
esac
exec "$@"
