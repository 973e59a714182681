#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# same_bytes_20_times.sh SCENE_PROGRAM KERNELS FOLDER: 20 processes, each with its own addresses, write the same header,
# counts and equations.
set -euo pipefail
program="$1" kernels="$2" folder="$3"
rm -rf "$folder"
mkdir -p "$folder"

run() {  # run NUMBER: one process per output, all into one folder
  local to="$folder/$1"
  mkdir "$to"
  "$program" generate --kernels "$kernels" --output "$to/header.hpp"
  "$program" counts --kernels "$kernels" --json > "$to/counts.json"
  "$program" equations > "$to/equations.txt"
  "$program" equations --format latex > "$to/equations.tex"
}

run 1
for output in header.hpp counts.json equations.txt equations.tex; do
  [ -s "$folder/1/$output" ] || { echo "the first run left $output empty"; exit 1; }
done
for number in $(seq 2 20); do
  run "$number"
  diff -r "$folder/1" "$folder/$number" | head -n 40 || true
  diff -rq "$folder/1" "$folder/$number" > /dev/null || { echo "run $number differs from the first"; exit 1; }
  rm -r "${folder:?}/$number"
done
echo "20 runs, the same bytes"
