#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# table_of_counts.sh MODEL_COUNTS MODELS PAGE: the table of operation counts in PAGE is what the program prints.
set -euo pipefail
printed="$("$1" "$2" | awk '
  NF == 1 { model = $1 }
  $1 == "mass_matrix" { mass[model] = $NF }
  $1 == "inverse_dynamics" { inverse[model] = $NF }
  $1 == "forward_dynamics" { forward[model] = $NF; order[++n] = model }
  END { for (i = 1; i <= n; ++i) print order[i], inverse[order[i]], mass[order[i]], forward[order[i]] }')"
rows=0
while IFS='|' read -r _ model _ inverse mass forward _; do
  row="$(echo "$model $inverse $mass $forward" | tr -d ',' | tr -s ' ' | sed 's/^ //;s/ $//')"
  grep -qxF -- "$row" <<< "$printed" || { echo "$3 says '$row'; the program prints:"; echo "$printed"; exit 1; }
  rows=$((rows + 1))
done < <(grep -E '^\| [a-z]+[0-9]* \| [0-9]+ \| [0-9,]+ \| [0-9,]+ \| [0-9,]+ \|$' "$3")
[ "$rows" -ge 6 ] || { echo "only $rows rows of counts found in $3"; exit 1; }
echo "$rows rows, as the program prints them"
