#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# octave.sh MKOCTFILE OCTAVE TORSOR SOURCE FOLDER: a library of a robot, called from GNU Octave.
set -euo pipefail
mkoctfile="$1" octave="$2" torsor="$3" source="$4" folder="$5"
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
TORSOR_CACHE="$folder/cache" "$torsor" build "$source/tests/python/cart_pole.urdf" --initial hinge=0.3 --run-time pole_mass --flags=-O1 --output cart.so
"$mkoctfile" --mex -std=c99 -Wall -Wextra -Wconversion -Wshadow -Werror "-I$source/include" "$source/runtime/octave/torsor_call.c" -o torsor_call.mex
said="$("$octave" --no-init-file "$source/tests/abi/octave.m" 2>&1)" || { echo "$said"; exit 1; }
[[ "$said" == *"all of it holds"* ]] || { echo "$said"; exit 1; }
