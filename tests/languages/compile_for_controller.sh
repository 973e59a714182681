#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# compile_for_controller.sh COMPILER PROGRAM NAME FOLDER: for a Cortex-M4 without warnings, all kernels in float and in
# double, as a header and as a header with a source file. Ends with 77 (skipped) where the compiler, or its <math.h>, is
# not installed.
set -euo pipefail
compiler="$1" program="$2" name="$3" folder="$4"
command -v "$compiler" > /dev/null || { echo "$compiler is not installed"; exit 77; }
echo '#include <math.h>' | "$compiler" -xc -fsyntax-only - 2> /dev/null || { echo "$compiler has no <math.h>"; exit 77; }
mkdir -p "$folder"
"$program" generate --kernels all --language c99 --output "$folder/alone_$name.h"
"$program" generate --kernels all --language c99 --source "$folder/$name.c" --output "$folder/$name.h"
printf '#include "alone_%s.h"\n' "$name" > "$folder/alone.c"
flags=(-std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Werror -mcpu=cortex-m4 -mthumb -mfloat-abi=hard
  -mfpu=fpv4-sp-d16 -O2 -c -o /dev/null)
for source in "$folder/alone.c" "$folder/$name.c"; do
  "$compiler" "${flags[@]}" -DTORSOR_SINGLE "$source"
  "$compiler" "${flags[@]}" "$source"
done
echo "$name: compiled by $compiler"
