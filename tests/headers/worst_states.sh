#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# worst_states.sh HEADER FOLDER PROGRAM: every kernel of the header at random and at the worst states, under each
# rounding, made by each compiler there is at the levels of levels.sh, and with fused multiply-add. PROGRAM is the object of
# stress/states.cpp; objects of the kernels are those that compile_alone.sh left in FOLDER, or are made here.
# TORSOR_LONG_TESTS: 240 000 states instead of 10 000 (ten million over all examples), -O1 and -O3 too, large headers
# with fused multiply-add too.
set -euo pipefail
header="$1" folder="$2" program="$3"
here="$(cd "$(dirname "$0")" && pwd)"
command -v g++ > /dev/null || { echo "g++ is not installed"; exit 77; }
mkdir -p "$folder"
mechanism="$(sed -nE 's/^(inline )?namespace ([A-Za-z_0-9:]+) *\{.*/\2/p' "$header" | grep -vx torsor | tail -n 1)"
long="${TORSOR_LONG_TESTS:-}"
# Kernels whose results may cancel, all but for the rounding of their terms.
mapfile -t excepted < <(awk -F ' *[|] *' -v scene="$mechanism" '$1 == scene { print $2 }' "$here/stress/exceptions.txt")

source="$folder/by_number.cpp"
printf '#include "%s"\n#include "%s/stress/kernels_by_number.hpp"\n%s template struct %s::Mechanism<double>;\n%s\n' \
  "$header" "$here" "extern" "$mechanism" "TORSOR_KERNELS_BY_NUMBER($mechanism::Mechanism<double>)" > "$source"
g++ -std=c++17 -O0 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -fno-exceptions -fno-rtti \
  -c "$source" -o "$folder/by_number.o"

# shellcheck source=tests/headers/levels.sh
source "$here/levels.sh"
states() { echo "$1:" "${@:2}"; "$folder/states-$1" "${@:2}"; }
first=""
for compiler in g++ clang++; do
  command -v "$compiler" > /dev/null || continue
  for level in $(levels_of "$compiler" "$header"); do
    made="$compiler$level"
    { [ "$folder/$made.o" -nt "$header" ] && [ ! "$(dirname "$header")/torsor_support.hpp" -nt "$folder/$made.o" ]; } ||
      bash "$here/compile_alone.sh" "$compiler" "$header" "$folder"
    g++ "$folder/by_number.o" "$folder/$made.o" "$program" -o "$folder/states-$made"
    if [ -z "$first" ]; then
      first="$made"
      states "$made" random "$([ -n "$long" ] && echo 240000 || echo 10000)"
      states "$made" extremes
      states "$made" rounding "${excepted[@]}"
      for kernel in "${excepted[@]}"; do
        mapfile -t others < <(printf '%s\n' "${excepted[@]}" | grep -vx "$kernel")
        if states "$made" rounding "${others[@]}" > /dev/null; then
          echo "$kernel needs no exception: remove it from tests/headers/stress/exceptions.txt"
          exit 1
        fi
      done
      states "$made" write "$folder/results"
    else
      # No fused multiply-add, and sums as they stand: the same bits from each.
      states "$made" same "$folder/results"
    fi
  done
done

if grep -qw fma /proc/cpuinfo 2> /dev/null && { [ -n "$long" ] || [ "$(wc -c < "$header")" -lt 24000 ]; }; then
  sed -i 's/^extern template/template/' "$source"
  g++ -std=c++17 -O3 -mavx2 -mfma -ffp-contract=fast -c "$source" -o "$folder/fused.o"
  g++ "$folder/fused.o" "$program" -o "$folder/states-fused"
  states fused near "$folder/results" "${excepted[@]}"
fi
