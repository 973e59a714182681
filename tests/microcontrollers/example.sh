#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# example.sh FOLDER: examples/cortex_m is built by its own project and runs under QEMU; its arm follows the motion. Nothing
# in the image computes in double. Ends with 77 (skipped) where a compiler or QEMU is not installed.
set -euo pipefail
folder="$1"
repository="$(cd "$(dirname "$0")/../.." && pwd)"
for tool in arm-none-eabi-gcc arm-none-eabi-g++ qemu-system-arm; do
  command -v $tool > /dev/null || { echo "$tool is not installed"; exit 77; }
done
echo '#include <array>' | arm-none-eabi-g++ -std=c++17 -xc++ -fsyntax-only - 2> /dev/null ||
  { echo "arm-none-eabi-g++ has no <array>"; exit 77; }
rm -rf "$folder"
cmake -G Ninja -S "$repository/examples/cortex_m" -B "$folder" --toolchain arm-none-eabi.cmake
cmake --build "$folder"
arm-none-eabi-size "$folder/controller"
if arm-none-eabi-nm "$folder/controller" | grep -E '__aeabi_(d[a-z0-9]*|[a-z0-9]*2d)$|__(add|sub|mul|div)df3'; then
  echo "the image calls for doubles"
  exit 1
fi
timeout 300 qemu-system-arm -M mps2-an386 -nographic -semihosting -kernel "$folder/controller" 2>&1 < /dev/null
