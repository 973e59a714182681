#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# compile_packs.sh COMPILER ROOT FOLDER NAMES...: every function of these generated headers takes packs as its scalar, in
# C++17, whichever of the two headers comes first. Ends with 77 (skipped) when the compiler is not installed.
set -euo pipefail
compiler="$1" root="$2" folder="$3"
shift 3
command -v "$compiler" > /dev/null || { echo "$compiler is not installed"; exit 77; }
mkdir -p "$folder"
for name in "$@"; do
  source="$folder/$name.cpp"
  printf '#include "torsor/runtime/batch/simd.hpp"\n#include "generated/%s.hpp"\n' "$name" > "$source"
  for scalar in "NativeSimd<double>" "Simd<float, 3>"; do
    printf 'template struct %s::Mechanism<torsor::runtime::%s>;\n' "$name" "$scalar" >> "$source"
  done
  "$compiler" -std=c++17 -fsyntax-only -I "$root" -I "$root/include" -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror "$source"
  echo "$name: every function takes packs"
done
