#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# same_bytes_every_time.sh COUNT SCENE_PROGRAM KERNELS FOLDER: that many processes, each with its own addresses, write the
# same header, counts and equations. TORSOR_LONG_TESTS: twenty at least.
set -euo pipefail
count="$1" program="$2" kernels="$3" folder="$4"
[ -z "${TORSOR_LONG_TESTS:-}" ] || [ "$count" -ge 20 ] || count=20
rm -rf "$folder"
mkdir -p "$folder"

run() {  # run NUMBER: one process per output, all into one folder
  local to="$folder/$1"
  mkdir "$to"
  "$program" generate --kernels "$kernels" --support "$to/support.hpp" --output "$to/header.hpp"
  # What they have in common with the first is written from the same listings: some kernels show the rest.
  "$program" generate --kernels inverse_dynamics,energy --language c99 --support "$to/support.h" --source "$to/source.c" \
    --output "$to/header.h"
  "$program" generate --kernels inverse_dynamics,energy --language javascript --output "$to/module.mjs"
  "$program" counts --kernels "$kernels" --json > "$to/counts.json"
  "$program" equations > "$to/equations.txt"
  "$program" equations --format latex > "$to/equations.tex"
}

run 1
for output in header.hpp support.hpp header.h support.h source.c module.mjs counts.json equations.txt equations.tex; do
  [ -s "$folder/1/$output" ] || { echo "the first run left $output empty"; exit 1; }
done
for number in $(seq 2 "$count"); do
  run "$number"
  diff -r "$folder/1" "$folder/$number" | head -n 40 || true
  diff -rq "$folder/1" "$folder/$number" > /dev/null || { echo "run $number differs from the first"; exit 1; }
  rm -r "${folder:?}/$number"
done
echo "$count runs, the same bytes"
