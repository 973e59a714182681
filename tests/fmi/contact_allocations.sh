#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# contact_allocations.sh CC CXX EIGEN RUNTIME FOLDER PROGRAM: what the units of both versions with contacts that PROGRAM writes
# allocate in their steps.
set -euo pipefail
cc="$1" cxx="$2" eigen="$3" runtime="$4" folder="$5" program="$6"
here="$(cd "$(dirname "$0")" && pwd)"
source "$here/moving_object.sh"
rm -rf "$folder"
# Matrices have the room that those of the library have.
flags=(-O1 -ffp-contract=off -DTORSOR_MOST_CONTACTS=32)
warnings=(-pedantic -Wall -Wextra -Wconversion -Wshadow -Werror)  # some are an optimiser's
for version in 2 3; do
  to="$folder/$version"
  mkdir -p "$to"
  { read -r unit; read -r moving; read -r token; } < <("$program" "$version" "$to")
  "$cc" -std=c99 "${flags[@]}" "-I$to" -DUNIT="\"$unit\"" -DTOKEN="\"$token\"" -c "$here/contact_allocations.c" -o "$to/steps.o"
  moving_object "$to/$moving" "$cxx" -std=c++20 "${warnings[@]}" "${flags[@]}" -isystem "$eigen"
  "$cxx" "$to/steps.o" "$moving_object" "$runtime" -o "$to/steps" -lm
  "$to/steps"
done
