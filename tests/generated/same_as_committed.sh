#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# same_as_committed.sh COMMITTED FRESH REMEDY COMMAND...: the command, given --output FRESH, writes what is committed.
set -euo pipefail
committed="$1" fresh="$2" remedy="$3"
rm -f "$fresh"
"${@:4}" --output "$fresh"
[ -f "$committed" ] || { echo "$committed is missing; run $remedy and commit it"; exit 1; }
if ! cmp "$committed" "$fresh"; then
  diff -u "$committed" "$fresh" | head -n 40 || true
  echo "$committed is not what the scene gives now; run $remedy, look at the difference and commit it"
  exit 1
fi
