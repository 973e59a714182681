#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# vectorised.sh COMPILER HEADER FOLDER: several sines and cosines are vector instructions at -O2 and -O3. Counts the
# products in the object code: packed ones must be there, single ones must not, but for the square of an angle that has a
# register for itself.
# Ends with 77 (skipped) when the compiler is not installed or this is no x86-64.
set -euo pipefail
compiler="$1" header="$2" folder="$3"
command -v "$compiler" > /dev/null || { echo "$compiler is not installed"; exit 77; }
[ "$(uname -m)" = x86_64 ] || { echo "looks for instructions of x86-64"; exit 77; }
mkdir -p "$folder"
source="$folder/$compiler.cpp" object="$folder/$compiler.o"

counts=(2 3 5 7 8 16)
{
  printf '#include "%s"\n' "$header"
  for scalar in double float; do
    for count in "${counts[@]}"; do
      printf 'void sines(const %s (&a)[%d], %s (&s)[%d], %s (&c)[%d]) { torsor::sincos_of_several(a, s, c); }\n' \
        "$scalar" "$count" "$scalar" "$count" "$scalar" "$count"
    done
  done
} > "$source"

for options in "-O2" "-O3" "-O2 -mavx2 -mfma" "-O3 -mavx2 -mfma"; do
  # shellcheck disable=SC2086
  "$compiler" -std=c++17 $options -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -c "$source" -o "$object"
  objdump --disassemble --demangle --no-show-raw-insn "$object" > "$object.txt"
  for scalar in double float; do
    for count in "${counts[@]}"; do
      products="$(awk -v whole="sines[(]$scalar const [(]&[)] [[]$count[]]" -v part="sincos_of_several<$scalar, $count[u>]" '
        /^[0-9a-f]+ </ { inside = $0 ~ whole || $0 ~ part }
        inside && /[ \tv](mul|fn?madd[0-9]+|fn?msub[0-9]+)p[sd][ \t]/ { ++packed }
        inside && /[ \tv](mul|fn?madd[0-9]+|fn?msub[0-9]+)s[sd][ \t]/ { ++single }
        END { print packed + 0, single + 0 }' "$object.txt")"
      read -r packed single <<< "$products"
      echo "$compiler $options, $count angles in $scalar: $packed packed products, $single single ones"
      [ "$packed" -ge 15 ] && [ "$single" -le 2 ] || exit 1
    done
  done
done
