#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# check_sources_finds_violations.sh CHECK: the check must pass a clean tree and name each violation put into it.
set -euo pipefail
check="$1"
tree="$(mktemp -d)"
trap 'rm -rf "$tree"' EXIT
cd "$tree"

# REUSE-IgnoreStart
gpl='// SPDX-License-Identifier: GPL-3.0-or-later'
mit='// SPDX-License-Identifier: MIT'
mit_0='// SPDX-License-Identifier: MIT-0'
put() {  # put FILE LINE...
  mkdir -p "$(dirname "$1")"
  printf '%s\n' "${@:2}" > "$1"
}
for i in 1 2 3 4 5 6; do put "generator/expression/file_$i.hpp" "$gpl"; done
put generator/mechanics/body.hpp "$gpl" '#include "torsor/generator/expression/file_1.hpp"'
put generator/dynamics/theorems/lagrange.hpp "$gpl" '#include "torsor/generator/mechanics/body.hpp"'
put runtime/system.hpp "$mit"
put runtime/events/guard.hpp "$mit" '#include "torsor/runtime/system.hpp"'
put runtime/numerics/solve.hpp "$mit" '#include <Eigen/Dense>'
put generated/arm.hpp "$mit_0" '#include <array>' '#include <cmath>'
put scripts/run '#!/bin/sh' '# SPDX-License-Identifier: GPL-3.0-or-later'
bash "$check" "$tree" || { echo "a clean tree was refused"; exit 1; }

expect() {  # expect TEXT FILE LINE...: with that file the check must fail and print the text
  local text="$1" file="$2" before="" output
  [ -f "$file" ] && before="$(cat "$file")"
  put "${@:2}"
  if output="$(bash "$check" "$tree")"; then echo "not refused: $file"; exit 1; fi
  grep -qF -- "$text" <<< "$output" || { echo "$file: expected '$text', got: $output"; exit 1; }
  if [ -n "$before" ]; then printf '%s\n' "$before" > "$file"; else rm "$file"; fi
}
expect 'includes the higher layer dynamics' generator/mechanics/x.cpp "$gpl" '#include "torsor/generator/dynamics/theorems/lagrange.hpp"'
expect 'includes the higher layer cli' generator/verification/x.hpp "$gpl" '#  include "torsor/generator/cli/main.hpp"'
expect 'generator includes runtime' generator/cli/x.cpp "$gpl" '#include "torsor/runtime/numerics/solve.hpp"'
expect 'is no layer' generator/misc/x.cpp "$gpl" '#include "torsor/generator/mechanics/body.hpp"'
expect 'which stands higher' runtime/numerics/x.hpp "$mit" '#include "torsor/runtime/events/guard.hpp"'
expect 'which stands higher' runtime/x.hpp "$mit" '#include "torsor/runtime/events/guard.hpp"'
expect 'which stands higher' generator/dynamics/motion/x.cpp "$gpl" '#include "torsor/generator/dynamics/theorems/lagrange.hpp"'
expect 'is no folder of generator/dynamics' generator/dynamics/x.cpp "$gpl" '#include "torsor/generator/dynamics/theorems/lagrange.hpp"'
expect 'runtime includes generator' runtime/x.hpp "$mit" '#include "torsor/generator/expression/file_1.hpp"'
expect 'a main includes generator' examples/arm/main.cpp "$mit" '#include "torsor/generator/mechanics/body.hpp"'
expect 'only <array>, <cmath>' generated/x.hpp "$mit_0" '#include <vector>'
expect 'write torsor/runtime/system.hpp' runtime/x.hpp "$mit" '#include "runtime/system.hpp"'
expect 'must read MIT' runtime/x.hpp "$gpl"
expect 'must read MIT-0' generated/x.hpp "$mit"
expect 'must read MIT-0' templates/x.hpp.in "$mit"
expect 'must read GPL-3.0-or-later' generator/cli/x.cpp "$mit"
expect 'must read GPL-3.0-or-later' tests/x.cpp '// nothing'
expect 'must read GPL-3.0-or-later' scripts/run '#!/bin/sh'
mapfile -t long < <(yes 'int x;' | head -n 500)
expect '501 lines' generator/cli/long.cpp "$gpl" "${long[@]}"
echo "each violation was found"
# REUSE-IgnoreEnd
