#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# same_from_both_compilers.sh FIRST KERNELS FOLDER SECOND...: the program FIRST and the command SECOND write the same
# header of all kernels, the same counts, and the same equations in both forms. Exits with 77 when the first is not there.
set -euo pipefail
first="$1" kernels="$2" folder="$3"
shift 3
[ -x "$first" ] || { echo "$first is not there: build the preset release first"; exit 77; }
mkdir -p "$folder"
for output in "generate --kernels $kernels --output -" equations "equations --format latex" "counts --json"; do
  # shellcheck disable=SC2086  # words of a command
  "$first" $output > "$folder/first"
  # shellcheck disable=SC2086
  "$@" $output > "$folder/second"
  [ -s "$folder/first" ] || { echo "$first $output writes nothing"; exit 1; }
  cmp "$folder/first" "$folder/second" || { echo "$* $output is another text"; exit 1; }
done
echo "the same bytes"
