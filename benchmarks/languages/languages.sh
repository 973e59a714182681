#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# languages.sh TORSOR ROBOT.urdf [OPTIONS]: nanoseconds of the inverse dynamics of a robot in C++, in C and in JavaScript, and
# how many times those of C++ they are. All are measured in turns, and the least counts: a busy machine slows all of them.
# g++ and gcc compile with OPTIONS, -O2 when absent, and fuse products with sums alike where the processor can.
set -euo pipefail
torsor="$1" robot="$2" options="${3:--O2}"
here="$(cd "$(dirname "$0")" && pwd)"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
for language in c++:hpp c99:h javascript:mjs; do
  "$torsor" generate "$robot" --name robot --kernels inverse_dynamics --language "${language%:*}" \
    --output "$work/robot.${language#*:}" 2> /dev/null
done
# shellcheck disable=SC2086  # several options
gcc -std=gnu99 $options -ffp-contract=fast -I "$work" -c "$here/robot.c" -o "$work/c.o"
# shellcheck disable=SC2086
g++ -std=c++17 $options -ffp-contract=fast -I "$work" "$here/times.cpp" "$work/c.o" -o "$work/times"
cp "$here/times.mjs" "$work"
for _ in 1 2 3 4 5; do
  "$work/times"
  node "$work/times.mjs"
done | awk '
  !($1 in least) { order[++count] = $1 }
  !($1 in least) || $2 < least[$1] { least[$1] = $2 }
  END { for (k = 1; k <= count; ++k) printf "%-10s %8.1f ns %8.3f\n", order[k], least[order[k]], least[order[k]] / least["C++"] }'
