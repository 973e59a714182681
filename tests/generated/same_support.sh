#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# same_support.sh GENERATED PROGRAM FOLDER: what headers have in common is committed as it is written now, every header
# includes it, and none has the text itself.
set -euo pipefail
generated="$1" program="$2" folder="$3"
rm -rf "$folder"
mkdir -p "$folder/below"
"$program" generate --kernels energy --support "$folder/support.hpp" --output "$folder/below/header.hpp"
grep -qx '#include "../support.hpp"' "$folder/below/header.hpp" || { echo "the header does not include its support"; exit 1; }
cmp "$generated/torsor_support.hpp" "$folder/support.hpp" ||
  { echo "generated/torsor_support.hpp is not what is written now; run scripts/regenerate and commit it"; exit 1; }
for header in "$generated"/*.hpp; do
  [ "$header" != "$generated/torsor_support.hpp" ] || continue
  grep -qx '#include "torsor_support.hpp"' "$header" || { echo "$header does not include torsor_support.hpp"; exit 1; }
  ! grep -q 'struct SineCosine' "$header" || { echo "$header has text of torsor_support.hpp"; exit 1; }
done
# With the support and without, in one file: the same kernels.
"$program" generate --kernels energy --output "$folder/alone.hpp"
printf '#include "alone.hpp"\n#include "support.hpp"\nstatic_assert(torsor::support_fingerprint != 0, "");\n' > "$folder/both.cpp"
"${CXX:-c++}" -std=c++17 -fsyntax-only -Wall -Wextra -Wpedantic -Werror "$folder/both.cpp"
echo "$(ls "$generated"/*.hpp | wc -l) files, one support"
