#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# same_bits.sh PROGRAM NAME STATES FOLDER RUN_TIME C++-COMPILER C-COMPILER...: writes all kernels in each language, then
# compare.mjs.
set -euo pipefail
program="$1" name="$2" states="$3" folder="$4" run_time="$5"
shift 5
mkdir -p "$folder"
for language in c++:hpp c99:h javascript:mjs; do
  "$program" generate --kernels all ${run_time:+--run-time "$run_time"} --language "${language%:*}" --output "$folder/$name.${language#*:}"
done
exec node "$(dirname "$0")/compare.mjs" "$name" "$states" "$folder" "$@"
