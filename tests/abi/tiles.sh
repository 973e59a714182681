#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# tiles.sh CXX SOURCE FOLDER: tiles.cpp with the registers that every processor has, and with the widest that this one has; with TORSOR_LONG_TESTS for each set between them too.
set -euo pipefail
cxx="$1" source="$2" folder="$3"
rm -rf "$folder"
mkdir -p "$folder"
has() { grep -qw "$1" /proc/cpuinfo 2> /dev/null; }
sets=("")
if has avx2; then sets+=("-mavx2"); fi
if has avx512f; then sets+=("-mavx512f"); fi
[ -n "${TORSOR_LONG_TESTS:-}" ] || [ ${#sets[@]} -lt 3 ] || sets=("" "${sets[-1]}")
for registers in "${sets[@]}"; do
  # shellcheck disable=SC2086  # an option, or none
  "$cxx" -std=c++20 -O2 -fsanitize=address -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror $registers -I"$source" -I"$source/include" \
    "$source/tests/abi/tiles.cpp" -o "$folder/tiles"
  "$folder/tiles"
done
