#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# straight_line.sh TORSOR URDF_FOLDER [COMPILER [OPTIONS]]: what straight-line code costs as it grows. Derivatives of the
# forward dynamics of chain8, chain16 and chain32: operations, bytes of code, seconds of the compiler's processor,
# nanoseconds of a call (least, lower quartile and median of 201 turns), picoseconds of an operation in the least.
set -euo pipefail
torsor="$1" folder="$2" compiler="${3:-g++}" options="${4:--O2}" models="${MODELS:-chain8 chain16 chain32}"
here="$(cd "$(dirname "$0")" && pwd)"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
TIMEFORMAT='%U'
echo "model,operations,bytes,seconds,ns_least,ns_lower_quartile,ns_median,ps_per_operation"
for model in $models; do
  header="$work/$model.hpp"
  "$torsor" generate "$folder/$model.urdf" --kernels forward_dynamics_derivatives --output "$header" 2> /dev/null
  operations="$(awk '$2 == "forward_dynamics_derivatives" { print $(NF - 1); exit }' "$header")"
  # shellcheck disable=SC2086  # several options
  { time "$compiler" -std=c++17 $options -ffp-contract=fast "-DHEADER=\"$header\"" "-DMODEL=$model" \
    -c "$here/time_derivatives.cpp" -o "$work/$model.o"; } 2> "$work/seconds"
  "$compiler" "$work/$model.o" -o "$work/$model"
  times="$("$work/$model")"
  bytes="$(size "$work/$model.o" | awk 'END { print $1 }')"
  echo "$model,$operations,$bytes,$(tail -n 1 "$work/seconds"),$times,$((1000 * ${times%%,*} / operations))"
done
