#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# same_from_both_compilers.sh FOLDER FOLDER PROGRAM...: the programs of both folders write the same header for each kernel
# alone, the same counts, and the same equations in both forms. Exits with 77 when the first folder lacks a program.
set -euo pipefail
first="$1" second="$2"
shift 2
compared=0 different=0
differ() { echo "$1 differs"; different=$((different + 1)); }
for program in "$@"; do
  [ -x "$first/$program" ] || { echo "$first/$program is not there: build the preset release first"; exit 77; }
  # The kernels that the scene has: the last part of the list, without those that are absent, or large and made when named.
  kernels="$("$first/$program" list | sed -n '/^kernels /,$p' | sed 's/^kernels//' | grep -v '(absent\|(when named' | tr -d ' ')"
  for kernel in $kernels; do
    "$first/$program" generate --kernels "$kernel" --output - > /tmp/first.$$ 2> /dev/null
    "$second/$program" generate --kernels "$kernel" --output - > /tmp/second.$$ 2> /dev/null
    cmp /tmp/first.$$ /tmp/second.$$ || differ "$program: the kernel $kernel"
    compared=$((compared + 1))
  done
  for output in equations "equations --format latex" "counts --json"; do
    # shellcheck disable=SC2086  # words of a command
    "$first/$program" $output > /tmp/first.$$
    # shellcheck disable=SC2086
    "$second/$program" $output > /tmp/second.$$
    [ -s /tmp/first.$$ ] && cmp /tmp/first.$$ /tmp/second.$$ || differ "$program: $output"
  done
done
rm -f /tmp/first.$$ /tmp/second.$$
[ "$different" = 0 ] && [ "$compared" -gt 0 ] || exit 1
echo "$compared headers, the same bytes"
