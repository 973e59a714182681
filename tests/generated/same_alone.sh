#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Fails unless each function of a header is the same text when its kernel is generated alone, and the whole header
# whatever the order in which kernels are named.
# same_alone.sh PROGRAM KERNELS SCRATCH_FOLDER
set -euo pipefail
program="$1" kernels="$2" folder="$3"
mkdir -p "$folder"

# The function of a kernel in a header.
function_of() {
  awk -v start="^  TORSOR_DEVICE static [A-Za-z:]+ $1[(]const Precomputed&" '
    $0 ~ start { inside = 1 } inside { print } inside && /^  }$/ { exit }' "$2"
}

"$program" generate --kernels "$kernels" --output "$folder/together.hpp"
backwards=$(tr ',' '\n' <<<"$kernels" | tac | paste -sd,)
"$program" generate --kernels "$backwards" --output "$folder/backwards.hpp"
# The head says by which command, and to which file.
diff <(grep -v -e '--output' "$folder/together.hpp") <(grep -v -e '--output' "$folder/backwards.hpp")

compared=0
for kernel in $(sed -n 's/^\/\/ Kernels: //p' "$folder/together.hpp" | tr -d ','); do
  "$program" generate --kernels "$kernel" --output "$folder/alone.hpp"
  function_of "$kernel" "$folder/together.hpp" > "$folder/among_all"
  function_of "$kernel" "$folder/alone.hpp" > "$folder/alone"
  [ -s "$folder/alone" ] || { echo "$kernel alone is no function"; exit 1; }
  if ! diff "$folder/among_all" "$folder/alone"; then
    echo "$kernel is another function when it is generated alone"
    exit 1
  fi
  compared=$((compared + 1))
done
[ "$compared" -gt 0 ]
