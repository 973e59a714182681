#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# far_angles_apart.sh PROGRAM NAME FOLDER COMPILER...: one kernel of C99 alone in a file, with many angles. The reduction of
# angles that are far is long and hardly ever called: it stays a function of its own even where one place calls it. Taken
# into the kernel it costs that registers, a tenth of arm7's time.
set -euo pipefail
program="$1" name="$2" folder="$3"
shift 3
mkdir -p "$folder"
"$program" generate --kernels inverse_dynamics --language c99 --output "$folder/$name.h"
cat > "$folder/kernel.c" << TEXT
#include "$name.h"
void kernel(const ${name}_precomputed* precomputed, const ${name}_state* state, const torsor_real* a, torsor_real* forces) {
  ${name}_inverse_dynamics(precomputed, state, a, 0, forces);
}
TEXT
for compiler in "$@"; do
  for single in "" -DTORSOR_SINGLE; do
    # shellcheck disable=SC2086
    "$compiler" -std=c99 -O3 -Wall -Wextra -Werror $single -c "$folder/kernel.c" -o "$folder/kernel.o"
    nm --defined-only "$folder/kernel.o" | grep -E 'torsor_(sincos_)?far' > /dev/null \
      || { echo "$compiler $single takes the reduction of far angles into the kernel"; exit 1; }
  done
done
