#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced: how the kernels of a header are compiled. A large header takes seconds at each level: g++ optimises it, whose
# warnings need that, and clang++ compiles it in both scalars as it stands. With TORSOR_LONG_TESTS each does all.

is_large() { [ -z "${TORSOR_LONG_TESTS:-}" ] && [ "$(stat -c %s "$1")" -ge 24000 ]; }

# levels_of COMPILER HEADER
levels_of() {
  if [ -n "${TORSOR_LONG_TESTS:-}" ]; then echo -O2 -O0 -O3 -O1
  elif is_large "$2" && [ "$1" = g++ ] && command -v clang++ > /dev/null; then echo -O2
  elif is_large "$2" && [ "$1" = clang++ ]; then echo -O0
  else echo -O2 -O0
  fi
}
