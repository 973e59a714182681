#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# reuse_object.sh BUILD COMMAND...: a compiler's launcher in a project that holds torsor as its folder torsor/. It takes
# the objects of the generator, and of the motions with contacts in it, from torsor's own build, which compiled the same
# files; all else, and of both a sample, the floor geometry and the last files of the contacts, is compiled as the
# project says.
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
  *geometry* | *torsor_contacts.dir/Unity/unity_3_* | *torsor_contacts.dir/library.cpp.o) ;;
  torsor/generator/CMakeFiles/*.cxx.o | torsor/generator/CMakeFiles/*.cpp.o | \
    torsor/runtime/CMakeFiles/torsor_contacts.dir/*.cxx.o | torsor/runtime/CMakeFiles/torsor_contacts.dir/*.cpp.o)
    if [ -f "$compiled" ] && [ -n "$dependencies" ]; then
      cp "$compiled" "$object"
      printf '%s:\n' "$object" > "$dependencies"
      exit 0
    fi
    ;;
esac
exec "$@"
