#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# before.sh TORSOR BEFORE ROBOT.urdf [OPTIONS]: what a change of the generator did to a robot's kernels. BEFORE is a revision of git,
# which is built in build/before, or the program `torsor` of before. For each kernel: operations before and now, nanoseconds of a
# call before and now, and now over before; at the end the seconds from a chain of 64 joints to its header. Both are measured in turns,
# and the least counts: a busy machine slows both. $CXX compiles with OPTIONS, -O2 when absent.
set -euo pipefail
[ $# -ge 3 ] || { sed -n '3,6s/^# //p' "$0" >&2; exit 2; }
now="$1" before="$2" robot="$3" options="${4:--O2}"
here="$(cd "$(dirname "$0")" && pwd)"
root="$here/../.."
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
kernels=mass_matrix,inverse_dynamics,forward_dynamics,inverse_dynamics_derivatives,forward_dynamics_derivatives

if [ ! -f "$before" ]; then
  revision="$(git -C "$root" rev-parse --verify --quiet "$before^{commit}")" || {
    echo "before.sh: '$before' is neither a program nor a revision" >&2
    exit 2
  }
  source="$root/build/before/$revision"
  before="$source/build/bin/torsor"
  if [ ! -f "$before" ]; then
    mkdir -p "$source"
    git -C "$root" archive "$revision" | tar -x -C "$source"
    if ! cmake -S "$source" -B "$source/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DTORSOR_UNITY_BUILD=ON \
      -DTORSOR_BUILD_TESTS=OFF -DTORSOR_BUILD_EXAMPLES=OFF -DTORSOR_BUILD_BENCHMARKS=OFF > "$work/log" ||
      ! cmake --build "$source/build" --target torsor >> "$work/log"; then
      tail -n 40 "$work/log" >&2
      exit 1
    fi
  fi
fi

for when in before now; do
  program="$now"
  [ $when = now ] || program="$before"
  "$program" generate "$robot" --name "robot_$when" --kernels "$kernels" --output "$work/$when.hpp" --quiet
  "$program" counts "$robot" --kernels "$kernels" --json --quiet > "$work/$when.json"
  # Support text of two revisions may differ: each has a namespace of its own.
  # shellcheck disable=SC2086  # several options
  "${CXX:-g++}" -std=c++17 $options "-Dtorsor=support_of_$when" "-DROBOT=robot_$when" "-DWHEN=$when" -include "$work/$when.hpp" \
    -c "$here/calls.cpp" -o "$work/$when.o"
done
"${CXX:-g++}" -std=c++17 -O2 "$here/times.cpp" "$work/before.o" "$work/now.o" -o "$work/times"
"$work/times" > "$work/times.txt"
python3 "$here/table.py" "$work" "$before" "$now"
