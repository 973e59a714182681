#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# long_tests_exist.sh ROOT PATTERN...: every pattern of tests that are left out under the sanitizers still names one. A test
# that was given another name would run there again, for minutes.
set -euo pipefail
root="$1"
shift
names="$(grep -rhoE --include='*.cpp' '^(TYPED_)?TEST(_P|_F)?\([A-Za-z0-9_]+, *[A-Za-z0-9_]+' "$root/tests" |
  sed -E 's/^[A-Z_]+\(([A-Za-z0-9_]+), */\1./')"
missing=0
for pattern in "$@"; do
  case "$pattern" in Seeds/*) continue ;; esac  # whole families, by the number of the seed
  name="$(sed -E 's,^[A-Za-z0-9_]+/,,; s,/.*$,,' <<< "$pattern")"  # without instantiation and parameter
  found=no
  while IFS= read -r test; do
    # shellcheck disable=SC2053  # the pattern is one
    if [[ "$test" == $name ]]; then found=yes; break; fi
  done <<< "$names"
  if [ $found = no ]; then
    echo "TORSOR_LONG_UNDER_SANITIZERS names $pattern, but there is no such test"
    missing=1
  fi
done
[ "$#" -ge 50 ] || { echo "only $# patterns were given"; exit 1; }
exit $missing
