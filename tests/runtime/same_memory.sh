#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# same_memory.sh CXX EIGEN SOURCE RUNTIME FOLDER: programs whose matrices lie in memory otherwise than the library's do not link.
set -euo pipefail
cxx="$1" eigen="$2" source="$3" runtime="$4" folder="$5"
mkdir -p "$folder"
cd "$folder"
printf '#include "torsor/runtime/%s.hpp"\n' library contacts/contact_problem > program.cpp
echo 'int main() {}' >> program.cpp
failed=0
# links YES FLAGS...
links() {
  local expected="$1" seen=yes
  shift
  "$cxx" -std=c++20 "$@" -I"$source" -I"$source/include" -isystem "$eigen" program.cpp "$runtime" -o program 2> said || seen=no
  [ $seen = yes ] || grep -qE "library_(is_built_with_eigen_aligned_to|has_room_for_contacts)" said || { cat said >&2; failed=1; }
  [ $seen = "$expected" ] || { echo "with $*: links: $seen, must be $expected" >&2; failed=1; }
}
links yes -O1
links no -DEIGEN_MAX_ALIGN_BYTES=64
links no -DEIGEN_MALLOC_ALREADY_ALIGNED=0
links no -DTORSOR_MOST_CONTACTS=4
links yes -DTORSOR_MOST_CONTACTS=32
links yes -fsanitize=address -DEIGEN_MALLOC_ALREADY_ALIGNED=1
exit $failed
