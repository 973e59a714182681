#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# random_contact_calls.sh CC CXX EIGEN RUNTIME FOLDER SEQUENCES PROGRAM: the units of both versions with contacts that PROGRAM
# writes, compiled with the sanitizers and called in random orders. The contact layer is that of the library RUNTIME, which has
# tests of its own.
set -euo pipefail
cc="$1" cxx="$2" eigen="$3" runtime="$4" folder="$5" sequences="$6" program="$7"
here="$(cd "$(dirname "$0")" && pwd)"
source "$here/moving_object.sh"
rm -rf "$folder"
# Matrices have the room that those of the library have. With an optimiser, as in contact_allocations.sh, they take twice as
# long to compile: what is called takes a moment.
sanitizers=(-DTORSOR_MOST_CONTACTS=32 -g -O0 -fsanitize=address,undefined -fno-sanitize-recover=all -ffp-contract=off)
warnings=(-pedantic -Wall -Wextra -Wconversion -Wshadow -Werror)
for version in 2 3; do
  to="$folder/$version"
  mkdir -p "$to"
  { read -r unit; read -r moving; read -r token; } < <("$program" "$version" "$to")
  "$cc" -std=c99 "${warnings[@]}" "${sanitizers[@]}" "-I$to" -DUNIT="\"$unit\"" \
    -DCALLS="\"calls$version.h\"" -DTOKEN="\"$token\"" -c "$here/random_calls.c" -o "$to/calls.o"
  moving_object "$to/$moving" "$cxx" -std=c++20 "${warnings[@]}" "${sanitizers[@]}" -DEIGEN_MALLOC_ALREADY_ALIGNED=1 \
    -isystem "$eigen"
  "$cxx" "${sanitizers[@]}" "$to/calls.o" "$moving_object" "$runtime" -o "$to/calls" -lm
  "$to/calls" "$sequences"
done
