#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# sines.sh PROGRAM FOLDER: sines and cosines of a Cortex-M4F under QEMU, by the support text that PROGRAM, a scene, writes.
# Ends with 77 (skipped) where a compiler or QEMU is not installed.
set -euo pipefail
program="$1" folder="$2"
repository="$(cd "$(dirname "$0")/../.." && pwd)"
for tool in arm-none-eabi-gcc arm-none-eabi-g++ qemu-system-arm; do
  command -v $tool > /dev/null || { echo "$tool is not installed"; exit 77; }
done
echo '#include <array>' | arm-none-eabi-g++ -std=c++17 -xc++ -fsyntax-only - 2> /dev/null ||
  { echo "arm-none-eabi-g++ has no <array>"; exit 77; }
mkdir -p "$folder/generated"
"$program" generate --kernels bias --support "$folder/generated/torsor_support.hpp" --output "$folder/generated/some.hpp"
"$program" generate --kernels bias --language c99 --output "$folder/some.h"
cat > "$folder/sine.c" <<'END'
#define TORSOR_SINGLE
#include "some.h"
void sine_in_c(float angle, float* sine, float* cosine);
void sine_in_c(float angle, float* sine, float* cosine) { torsor_sincos(angle, sine, cosine); }
END
core=(-mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mthumb -mfloat-abi=hard -O2 -Wall -Wextra -Wconversion -Werror)
arm-none-eabi-gcc "${core[@]}" -Wdouble-promotion -c "$folder/sine.c" -o "$folder/sine.o"
# Products fused with sums, as compilers do it by themselves.
arm-none-eabi-g++ "${core[@]}" -std=c++17 -fno-exceptions -fno-rtti -fno-threadsafe-statics -I"$folder" -I"$repository" -I"$repository/include" \
  -c "$repository/tests/microcontrollers/sines.cpp" -o "$folder/sines.o"
arm-none-eabi-gcc "${core[@]}" -c "$repository/examples/cortex_m/start.c" -o "$folder/start.o"
arm-none-eabi-g++ "${core[@]}" -nostartfiles --specs=nano.specs -T "$repository/examples/cortex_m/board.ld" \
  "$folder/sines.o" "$folder/sine.o" "$folder/start.o" -o "$folder/sines.elf"
timeout 300 qemu-system-arm -M mps2-an386 -icount shift=0 -nographic -semihosting -kernel "$folder/sines.elf" 2>&1 < /dev/null
