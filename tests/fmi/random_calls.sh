#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# random_calls.sh CC VERSION FOLDER SEQUENCES PROGRAM WORDS...: a unit of FMI whose sources are compiled with the sanitizers
# and called in random orders. WORDS stand behind the command fmu: options, or the file of a robot with its own.
set -euo pipefail
cc="$1" version="$2" folder="$3" sequences="$4" program="$5"
shift 5
here="$(cd "$(dirname "$0")" && pwd)"
rm -rf "$folder"
mkdir -p "$folder"
"$program" fmu "$@" --fmi "$version" --sources-only --run-time all -o "$folder/unit.fmu"
cmake -E chdir "$folder" cmake -E tar xf unit.fmu
token="$(sed -n 's/.*\(guid\|instantiationToken\)="\([^"]*\)".*/\2/p' "$folder/modelDescription.xml" | head -n 1)"
unit="$(cd "$folder/sources" && echo *_fmi"$version".c)"
# The warnings that generated text is promised not to give, and all that the sanitizers find.
"$cc" -std=c99 -pedantic -Wall -Wextra -Wconversion -Wshadow -Werror -g -O1 -fsanitize=address,undefined -fno-sanitize-recover=all \
  -DCOUNT_ALLOCATIONS -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc -ffp-contract=off -I"$folder/sources" -DUNIT="\"$unit\"" -DCALLS="\"calls$version.h\"" -DTOKEN="\"$token\"" \
  "$here/random_calls.c" -o "$folder/calls" -lm
"$folder/calls" "$sequences"
