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

for options in "-O2" "-O3" "-O2 -mavx2 -mfma" "-O3 -mavx2 -mfma"; do
  for scalar in double float; do
    for count in 2 3 5 7 8 16; do
      printf '#include "%s"\nusing S = %s;\nvoid sines(const S (&a)[%d], S (&s)[%d], S (&c)[%d]) { torsor::sincos_of_several(a, s, c); }\n' \
        "$header" "$scalar" "$count" "$count" "$count" > "$source"
      # shellcheck disable=SC2086
      "$compiler" -std=c++17 $options -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -c "$source" -o "$object"
      products="$(objdump --disassemble --demangle --no-show-raw-insn "$object" | awk '
        /^[0-9a-f]+ </ { inside = /sines|sincos_of_several/ }
        inside && /[ \tv](mul|fn?madd[0-9]+|fn?msub[0-9]+)p[sd][ \t]/ { ++packed }
        inside && /[ \tv](mul|fn?madd[0-9]+|fn?msub[0-9]+)s[sd][ \t]/ { ++single }
        END { print packed + 0, single + 0 }')"
      read -r packed single <<< "$products"
      echo "$compiler $options, $count angles in $scalar: $packed packed products, $single single ones"
      [ "$packed" -ge 15 ] && [ "$single" -le 2 ] || exit 1
    done
  done
done
