#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# same_memory.sh CXX EIGEN SOURCE RUNTIME FOLDER: programs whose Eigen takes memory otherwise than the library's do not link.
set -euo pipefail
cxx="$1" eigen="$2" source="$3" runtime="$4" folder="$5"
mkdir -p "$folder"
cd "$folder"
printf '#include "torsor/runtime/library.hpp"\nint main() {}\n' > program.cpp
failed=0
# links YES FLAGS...
links() {
  local expected="$1" seen=yes
  shift
  "$cxx" -std=c++20 "$@" -I"$source" -I"$source/include" -isystem "$eigen" program.cpp "$runtime" -o program 2> said || seen=no
  [ $seen = yes ] || grep -q library_is_built_with_eigen_aligned_to said || { cat said >&2; failed=1; }
  [ $seen = "$expected" ] || { echo "with $*: links: $seen, must be $expected" >&2; failed=1; }
}
links yes -O1
links no -DEIGEN_MAX_ALIGN_BYTES=64
links no -DEIGEN_MALLOC_ALREADY_ALIGNED=0
links yes -fsanitize=address -DEIGEN_MALLOC_ALREADY_ALIGNED=1
exit $failed
