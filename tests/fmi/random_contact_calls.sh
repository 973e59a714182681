#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# random_contact_calls.sh CC CXX EIGEN RUNTIME VERSION FOLDER SEQUENCES PROGRAM: the unit with contacts that PROGRAM writes, compiled with
# the sanitizers and called in random orders. The contact layer is that of the library RUNTIME, which has tests of its own.
set -euo pipefail
cc="$1" cxx="$2" eigen="$3" runtime="$4" version="$5" folder="$6" sequences="$7" program="$8"
here="$(cd "$(dirname "$0")" && pwd)"
rm -rf "$folder"
mkdir -p "$folder"
{ read -r unit; read -r moving; read -r token; } < <("$program" "$version" "$folder")
# Matrices have the room that those of the library have.
sanitizers=(-DTORSOR_MOST_CONTACTS=32 -g -O1 -fsanitize=address,undefined -fno-sanitize-recover=all -ffp-contract=off "-I$folder")
warnings=(-pedantic -Wall -Wextra -Wconversion -Wshadow -Werror)
"$cc" -std=c99 "${warnings[@]}" "${sanitizers[@]}" -DUNIT="\"$unit\"" -DCALLS="\"calls$version.h\"" -DTOKEN="\"$token\"" \
  -c "$here/random_calls.c" -o "$folder/calls.o"
"$cxx" -std=c++20 "${warnings[@]}" "${sanitizers[@]}" -DEIGEN_MALLOC_ALREADY_ALIGNED=1 -isystem "$eigen" -c "$folder/$moving" -o "$folder/moving.o"
"$cxx" "${sanitizers[@]}" "$folder/calls.o" "$folder/moving.o" "$runtime" -o "$folder/calls" -lm
"$folder/calls" "$sequences"
