#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# same_bits.sh NODE PROGRAM NAME STATES FOLDER RUN_TIME C++-COMPILER C-COMPILER...: writes all kernels, and those that MORE_KERNELS
# names, in each language, then compare.mjs.
set -euo pipefail
node="$1" program="$2" name="$3" states="$4" folder="$5" run_time="$6"
shift 6
kernels=all,gravity,centroidal_momentum,frames,operational_inertia,delassus,impact${MORE_KERNELS:+,$MORE_KERNELS}
mkdir -p "$folder/apart"
for language in c++:hpp c99:h javascript:mjs; do
  "$program" generate --kernels $kernels ${run_time:+--run-time "$run_time"} --language "${language%:*}" --output "$folder/$name.${language#*:}"
done
"$program" generate --kernels $kernels ${run_time:+--run-time "$run_time"} --language c99 --support "$folder/apart/torsor_support.h" \
  --source "$folder/apart/$name.c" --output "$folder/apart/$name.h"
exec "$node" "$(dirname "$0")/compare.mjs" "$name" "$states" "$folder" "$@"
