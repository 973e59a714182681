#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# contact_allocations.sh CC CXX EIGEN RUNTIME VERSION FOLDER PROGRAM: what the unit with contacts that PROGRAM writes allocates in its steps.
set -euo pipefail
cc="$1" cxx="$2" eigen="$3" runtime="$4" version="$5" folder="$6" program="$7"
here="$(cd "$(dirname "$0")" && pwd)"
rm -rf "$folder"
mkdir -p "$folder"
{ read -r unit; read -r moving; read -r token; } < <("$program" "$version" "$folder")
# Matrices have the room that those of the library have.
flags=(-O1 -ffp-contract=off -DTORSOR_MOST_CONTACTS=32 "-I$folder")
"$cc" -std=c99 "${flags[@]}" -DUNIT="\"$unit\"" -DTOKEN="\"$token\"" -c "$here/contact_allocations.c" -o "$folder/steps.o"
"$cxx" -std=c++20 "${flags[@]}" -isystem "$eigen" -c "$folder/$moving" -o "$folder/moving.o"
"$cxx" "$folder/steps.o" "$folder/moving.o" "$runtime" -o "$folder/steps" -lm
"$folder/steps"
