#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# compile_for_controller.sh COMPILER PROGRAM NAME FOLDER: without warnings, all kernels in float for a Cortex-M4F and in
# double for a Cortex-M7, as a header and as a header with a source file. What is in float calls for no double. Ends with
# 77 (skipped) where the compiler, or its <math.h>, is not installed.
set -euo pipefail
compiler="$1" program="$2" name="$3" folder="$4"
command -v "$compiler" > /dev/null || { echo "$compiler is not installed"; exit 77; }
echo '#include <math.h>' | "$compiler" -xc -fsyntax-only - 2> /dev/null || { echo "$compiler has no <math.h>"; exit 77; }
mkdir -p "$folder"
"$program" generate --kernels all --language c99 --output "$folder/alone_$name.h"
"$program" generate --kernels all --language c99 --source "$folder/$name.c" --output "$folder/$name.h"
printf '#include "alone_%s.h"\n' "$name" > "$folder/alone.c"
flags=(-std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Werror -mthumb -mfloat-abi=hard -O2 -c)
for source in "$folder/alone.c" "$folder/$name.c"; do
  for small in "" -DTORSOR_SMALL; do
    "$compiler" "${flags[@]}" $small -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -DTORSOR_SINGLE -o "$folder/single.o" "$source"
    if nm --undefined-only "$folder/single.o" | grep -E '__aeabi_(d[a-z0-9]*|[a-z0-9]*2d)$'; then
      echo "$source: in float it calls for doubles"
      exit 1
    fi
  done
  "$compiler" "${flags[@]}" -mcpu=cortex-m7 -mfpu=fpv5-d16 -o /dev/null "$source"
done
echo "$name: compiled by $compiler"
