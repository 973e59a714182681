#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# same_from_both_compilers.sh FOLDER FOLDER PROGRAM...: the programs of both folders write the same header for each kernel
# alone, and the same equations. Exits with 77 when the first folder lacks a program.
set -euo pipefail
first="$1" second="$2"
shift 2
kernels="kinematics mass_matrix bias inverse_dynamics forward_dynamics energy first_integrals constraints reactions linearisation"
kernels="$kernels inverse_dynamics_derivatives forward_dynamics_derivatives regressor"
compared=0 different=0
differ() { echo "$1 differs"; different=$((different + 1)); }
for program in "$@"; do
  [ -x "$first/$program" ] || { echo "$first/$program is not there: build the preset release first"; exit 77; }
  for kernel in $kernels; do
    "$first/$program" generate --kernels "$kernel" --output - > /tmp/first.$$ 2> /dev/null
    "$second/$program" generate --kernels "$kernel" --output - > /tmp/second.$$ 2> /dev/null
    cmp /tmp/first.$$ /tmp/second.$$ || differ "$program: the kernel $kernel"
    compared=$((compared + 1))
  done
  "$first/$program" equations > /tmp/first.$$
  "$second/$program" equations > /tmp/second.$$
  cmp /tmp/first.$$ /tmp/second.$$ || differ "$program: the page of equations"
done
rm -f /tmp/first.$$ /tmp/second.$$
[ "$different" = 0 ] || exit 1
echo "$compared headers, the same bytes"
